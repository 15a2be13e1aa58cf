// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Readers of the real data files: coordinates as the exact decimals that are printed, or, for
// places on the Earth, as points of space rounded to centimetres.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_DATA_FILES_H
#define THICK_INTERSECTION_TEST_SUPPORT_DATA_FILES_H

#include "csv.h"
#include "decimal.h"

#include <cctype>
#include <filesystem>

namespace test_support {

// The folders that may hold data files: the one shipped with the examples, and optionally another.
// Each is given by the compiler as a macro or, with precedence, by the environment variable of the
// same name.
inline std::vector<std::string> data_folders()
{
  std::map<std::string, std::string> given;
#ifdef THICK_SHIPPED_DATA
  given["THICK_SHIPPED_DATA"] = THICK_SHIPPED_DATA;
#endif
#ifdef THICK_EXTRA_DATA
  given["THICK_EXTRA_DATA"] = THICK_EXTRA_DATA;
#endif
  std::vector<std::string> folders;
  for(const char* name : {"THICK_SHIPPED_DATA", "THICK_EXTRA_DATA"}) {
    const char* value = std::getenv(name);
    const std::string folder = value != nullptr ? std::string(value) : given[name];
    if(!folder.empty())
      folders.push_back(folder);
  }
  return folders;
}

// The path of a file in the first folder that has it.
inline std::optional<std::string> find_data_file(const std::string& name,
                                                 const std::vector<std::string>& folders)
{
  for(const std::string& folder : folders) {
    const std::filesystem::path path = std::filesystem::path(folder) / name;
    if(std::filesystem::exists(path))
      return path.string();
  }
  return std::nullopt;
}

inline std::string file_name(const std::string& path)
{
  return std::filesystem::path(path).filename().string();
}

inline std::vector<std::string> words(const std::string& line)
{
  std::istringstream in(line);
  std::vector<std::string> result;
  for(std::string word; in >> word;)
    result.push_back(word);
  return result;
}

// ---- places on the Earth ------------------------------------------------------------------------

// Latitude, longitude in degrees and, where the file has altitudes that are used, feet.
inline Text_rows read_places(const std::string& path)
{
  const std::string name = file_name(path);
  if(name.rfind("earthquakes", 0) == 0)
    return Csv_table(path).columns({"Latitude", "Longitude"});
  if(name.rfind("ships", 0) == 0)
    return Csv_table(path).columns({"lat_deg", "lon_deg"});
  if(name.rfind("aircraft", 0) == 0)
    return Csv_table(path).columns({"lat_deg", "lon_deg", "alt_ft"});
  if(name != "airports.dat")
    throw std::invalid_argument("no places in " + path);
  Text_rows rows; // airports.dat has no header; its altitudes are not used
  for(const std::string& line : read_lines(path)) {
    const std::vector<std::string> fields = split_csv_line(line);
    rows.push_back({fields.at(6), fields.at(7)});
  }
  return rows;
}

// (latitude, longitude) as points of the plane.
inline Decimal_points plane_points(Text_rows places)
{
  for(auto& place : places)
    place.resize(2);
  return scaled_to_integers(places);
}

// Points on a sphere of radius 6371008.8 m, higher by the altitude if there is one, in whole
// centimetres: `decimals` is 2, in metres. The sines come from libm, so that a coordinate may
// differ by a centimetre on another platform.
inline Decimal_points sphere_points(const Text_rows& places)
{
  const double degree = 3.14159265358979323846 / 180;
  Decimal_points points;
  points.dimension = 3;
  points.decimals = 2;
  for(const auto& place : places) {
    const double altitude = place.size() > 2 ? std::stod(place[2]) * 0.3048 : 0;
    const double radius = 6371008.8 + altitude;
    const double latitude = std::stod(place[0]) * degree;
    const double longitude = std::stod(place[1]) * degree;
    const double directions[] = {std::cos(latitude) * std::cos(longitude),
                                 std::cos(latitude) * std::sin(longitude), std::sin(latitude)};
    points.coordinates.emplace_back();
    for(double x : directions)
      points.coordinates.back().emplace_back(std::nearbyint(100 * radius * x));
  }
  return points;
}

// ---- runways ------------------------------------------------------------------------------------

// Segment i joins ends i and i + n; segments of one airport may meet.
struct Runways
{
  Decimal_points ends;
  std::vector<std::string> airports;
};

inline Runways read_runways(const std::string& path)
{
  const Csv_table table(path);
  Text_rows ends = table.columns({"le_latitude_deg", "le_longitude_deg"});
  const Text_rows high_ends = table.columns({"he_latitude_deg", "he_longitude_deg"});
  ends.insert(ends.end(), high_ends.begin(), high_ends.end());
  Runways runways;
  runways.ends = scaled_to_integers(ends);
  for(const auto& row : table.columns({"airport_ref"}))
    runways.airports.push_back(row[0]);
  return runways;
}

// ---- TSPLIB -------------------------------------------------------------------------------------

inline Decimal_points read_tsp(const std::string& path)
{
  Text_rows rows;
  bool are_nodes = false;
  for(const std::string& line : read_lines(path)) {
    const std::vector<std::string> fields = words(line);
    if(line.rfind("NODE_COORD", 0) == 0)
      are_nodes = true;
    else if(are_nodes && fields.size() >= 3)
      rows.push_back({fields[1], fields[2]});
  }
  return scaled_to_integers(rows);
}

// ---- molecules ----------------------------------------------------------------------------------

// radii[i] / 10^centres.decimals is the van der Waals radius of atom i.
struct Atoms
{
  Decimal_points centres;
  std::vector<std::string> elements;
  std::vector<Decimal_integer> radii;
};

// Bondi's radii in Angstrom; carbon's for anything else.
inline std::string van_der_waals_radius(const std::string& element)
{
  static const std::map<std::string, std::string> radii = {
    {"H", "1.20"}, {"C", "1.70"}, {"N", "1.55"}, {"O", "1.52"},
    {"S", "1.80"}, {"P", "1.80"}, {"FE", "2.00"}};
  const auto found = radii.find(element);
  return found == radii.end() ? "1.70" : found->second;
}

// The upper case letters of a fixed-width field, which ends where the line ends.
inline std::string letters(const std::string& line, std::size_t first, std::size_t length)
{
  std::string result;
  for(std::size_t i = first; i < (std::min)(first + length, line.size()); ++i)
    if(std::isalpha(static_cast<unsigned char>(line[i])))
      result += static_cast<char>(std::toupper(static_cast<unsigned char>(line[i])));
  return result;
}

// Columns 77-78, or the first letter of the atom's name where those are empty.
inline std::string element_of(const std::string& line)
{
  const std::string element = letters(line, 76, 2);
  return element.empty() ? letters(line, 12, 4).substr(0, 1) : element;
}

inline Atoms read_pdb(const std::string& path)
{
  Atoms atoms;
  Text_rows rows;
  for(const std::string& line : read_lines(path))
    if(line.rfind("ATOM  ", 0) == 0 || line.rfind("HETATM", 0) == 0) {
      std::vector<std::string> row;
      for(std::size_t column : {30, 38, 46})
        row.push_back(words(line.substr(column, 8)).at(0));
      rows.push_back(row);
      atoms.elements.push_back(element_of(line));
    }
  atoms.centres = scaled_to_integers(rows);
  for(const std::string& element : atoms.elements)
    atoms.radii.push_back(scaled_decimal(van_der_waals_radius(element), atoms.centres.decimals));
  return atoms;
}

// ---- meshes -------------------------------------------------------------------------------------

struct Mesh
{
  Decimal_points vertices;
  std::vector<std::array<std::size_t, 3>> triangles;
};

// Faces with more than three corners become fans of triangles.
inline Mesh read_obj(const std::string& path)
{
  Mesh mesh;
  Text_rows rows;
  for(const std::string& line : read_lines(path)) {
    const std::vector<std::string> fields = words(line);
    if(fields.empty())
      continue;
    if(fields[0] == "v")
      rows.push_back({fields.at(1), fields.at(2), fields.at(3)});
    if(fields[0] == "f") {
      const auto corner = [&](std::size_t i) { return std::stoul(fields.at(i)) - 1; };
      for(std::size_t i = 2; i + 1 < fields.size(); ++i)
        mesh.triangles.push_back({corner(1), corner(i), corner(i + 1)});
    }
  }
  mesh.vertices = scaled_to_integers(rows);
  return mesh;
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_DATA_FILES_H
