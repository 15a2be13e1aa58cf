// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The closest pair of ships, of earthquakes, and of the atoms of a protein, and whether any two of
// them are within a distance.
//
//   closest_pair [DIRECTORY OF THE DATA]

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/closest_pair.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

std::ifstream open(const std::string& file)
{
  std::ifstream in(file);
  if(!in)
    throw std::runtime_error("cannot read " + file);
  return in;
}

// A place on the Earth, in meters from its center.
Point on_sphere(double latitude, double longitude)
{
  const double radius = 6371008.8, degree = std::acos(-1.) / 180;
  return Point(radius * std::cos(latitude * degree) * std::cos(longitude * degree),
               radius * std::cos(latitude * degree) * std::sin(longitude * degree),
               radius * std::sin(latitude * degree));
}

// The places in a CSV file without quotes, from the columns of latitude and longitude.
std::vector<Point> read_places(const std::string& file, std::size_t latitude_column)
{
  std::ifstream in = open(file);
  std::vector<Point> places;
  std::string line, field;
  std::getline(in, line); // names
  while(std::getline(in, line)) {
    std::istringstream fields(line);
    for(std::size_t i = 0; i < latitude_column; ++i)
      std::getline(fields, field, ',');
    double latitude, longitude;
    char comma;
    fields >> latitude >> comma >> longitude;
    places.push_back(on_sphere(latitude, longitude));
  }
  return places;
}

// The atoms in a PDB file, in angstrom.
std::vector<Point> read_atoms(const std::string& file)
{
  std::ifstream in = open(file);
  std::vector<Point> atoms;
  for(std::string line; std::getline(in, line);)
    if(line.compare(0, 6, "ATOM  ") == 0 || line.compare(0, 6, "HETATM") == 0)
      atoms.emplace_back(std::stod(line.substr(30, 8)), std::stod(line.substr(38, 8)),
                         std::stod(line.substr(46, 8)));
  return atoms;
}

void print_closest(const std::string& name, const std::vector<Point>& points,
                   const std::string& unit)
{
  const auto [i, j] = CGAL::closest_pair(points);
  std::cout << name << ": " << i << " and " << j << " of " << points.size() << ", "
            << std::sqrt(CGAL::squared_distance(points[i], points[j])) << ' ' << unit << '\n';
}

int main(int argc, char** argv)
{
  const std::string data = argc > 1 ? argv[1] : "data";
  const std::vector<Point> ships = read_places(data + "/ships_us_2022-01-03.csv", 2);
  const std::vector<Point> earthquakes = read_places(data + "/earthquakes-23k.csv", 1);
  const std::vector<Point> atoms = read_atoms(data + "/4hhb.pdb");
  print_closest("ships", ships, "m");
  print_closest("earthquakes", earthquakes, "m");
  print_closest("atoms", atoms, "angstrom");

  // No bond is as short as this: such atoms are alternatives for one, or an error of the file.
  const auto bound = CGAL::within_distance(0.7).open();
  std::cout << "atoms closer than 0.7 angstrom: "
            << (CGAL::has_close_pair(atoms, bound) ? "yes" : "no") << '\n';
}
