// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Tables and maps; see tables.h.

#include "tables.h"

#include "error.h"
#include "row_reader.h"
#include "text.h"

#include <array>
#include <cmath>

namespace near_pairs {
namespace {

bool is_map(const std::string& file)
{
  return extension(file) == ".geojson";
}

void write_coordinates(std::ostream& out, const Scene& scene, std::size_t point)
{
  for(int axis = 0; axis < scene.columns(); ++axis)
    out << shortest_text(scene.column(point, axis)) << ',';
}

void write_names(std::ostream& out, const Scene& scene,
                 const std::array<std::string, 3>& names, const std::string& suffix)
{
  for(int axis = 0; axis < scene.columns(); ++axis)
    out << csv_field(names[axis] + suffix) << ',';
}

class Pair_table : public Pair_writer
{
public:
  Pair_table(std::ostream& stream, const Scene& scene, bool with_coordinates)
    : stream_(stream), scene_(scene), with_coordinates_(with_coordinates)
  {
    stream_.precision(10);
    stream_ << "i,j,";
    for(int k = 1; k <= numbers_of_offset(); ++k)
      stream_ << "offset_" << k << ',';
    stream_ << (scene.ids.empty() ? "" : "id_i,id_j,");
    if(with_coordinates_) {
      write_names(stream_, scene_, scene_.names.front(), "_i");
      write_names(stream_, scene_, scene_.names.back(), "_j");
    }
    stream_ << "distance\n";
  }

  void add(std::size_t i, std::size_t j, const Offset& offset) override
  {
    stream_ << scene_.position(i) << ',' << scene_.position(j) << ',';
    for(int k = 0; k < numbers_of_offset(); ++k)
      stream_ << offset[k] << ',';
    if(!scene_.ids.empty())
      stream_ << csv_field(scene_.ids[i]) << ',' << csv_field(scene_.ids[j]) << ',';
    if(with_coordinates_) {
      write_coordinates(stream_, scene_, i);
      write_coordinates(stream_, scene_, j);
    }
    stream_ << scene_.distance(i, j, offset) << '\n';
  }

private:
  int numbers_of_offset() const { return scene_.cell ? scene_.dimension : 0; }

  std::ostream& stream_;
  const Scene& scene_;
  bool with_coordinates_;
};

// A place of a map is [longitude, latitude].
using Degrees = std::array<double, 2>;

std::string place(const Degrees& degrees)
{
  return "[" + shortest_text(degrees[0]) + "," + shortest_text(degrees[1]) + "]";
}

// Whether the shorter way around the globe is that across the 180th meridian. Longitudes beyond it
// count on, and the way is the straight one then.
bool is_across_meridian(const Degrees& a, const Degrees& b)
{
  return std::abs(a[0] - b[0]) > 180 && std::abs(a[0]) <= 180 && std::abs(b[0]) <= 180;
}

// A line across the 180th meridian has two parts: one that was drawn on a map would run around it.
// A place on the meridian is on the side of the other one.
void write_line(std::ostream& out, Degrees a, Degrees b)
{
  for(Degrees* const end : {&b, &a})
    if(std::abs((*end)[0]) == 180 && is_across_meridian(a, b))
      (*end)[0] = -(*end)[0];
  if(!is_across_meridian(a, b)) {
    out << R"({"type":"LineString","coordinates":[)" << place(a) << ',' << place(b) << "]}";
    return;
  }
  const double meridian = a[0] > 0 ? 180 : -180;
  const double part = (meridian - a[0]) / (b[0] + 2 * meridian - a[0]);
  const double latitude = a[1] + part * (b[1] - a[1]);
  out << R"({"type":"MultiLineString","coordinates":[[)" << place(a) << ','
      << place({meridian, latitude}) << "],[" << place({-meridian, latitude}) << ',' << place(b)
      << "]]}";
}

// A collection of features, one on each line.
class Map
{
public:
  explicit Map(std::ostream& stream) : stream_(stream)
  {
    stream_.precision(10);
    stream_ << R"({"type":"FeatureCollection","features":[)";
  }

  std::ostream& begin_feature()
  {
    stream_ << (is_first_ ? "\n" : ",\n") << R"({"type":"Feature","geometry":)";
    is_first_ = false;
    return stream_;
  }

  void finish() { stream_ << "\n]}\n"; }

private:
  std::ostream& stream_;
  bool is_first_ = true;
};

class Pair_map : public Pair_writer
{
public:
  Pair_map(std::ostream& stream, const Scene& scene) : map_(stream), scene_(scene) {}

  void add(std::size_t i, std::size_t j, const Offset&) override
  {
    std::ostream& out = map_.begin_feature();
    write_line(out, scene_.degrees(i), scene_.degrees(j));
    out << R"(,"properties":{"i":)" << scene_.position(i) << R"(,"j":)" << scene_.position(j);
    if(!scene_.ids.empty())
      out << R"(,"id_i":)" << json_string(scene_.ids[i]) << R"(,"id_j":)"
          << json_string(scene_.ids[j]);
    out << R"(,"distance":)" << scene_.distance(i, j, {}) << "}}";
  }

  void finish() override { map_.finish(); }

private:
  Map map_;
  const Scene& scene_;
};

void write_point_map(std::ostream& stream, const Scene& scene, const Groups& groups)
{
  Map map(stream);
  for(std::size_t i = 0; i < scene.size(); ++i) {
    std::ostream& out = map.begin_feature();
    out << R"({"type":"Point","coordinates":)" << place(scene.degrees(i))
        << R"(},"properties":{"i":)" << scene.position(i);
    if(scene.first_size)
      out << R"(,"file":)" << scene.file(i);
    if(!scene.ids.empty())
      out << R"(,"id":)" << json_string(scene.ids[i]);
    out << R"(,"neighbors":)" << groups.neighbors(i) << R"(,"component":)" << groups.component(i)
        << "}}";
  }
  map.finish();
}

void write_point_table(std::ostream& out, const Scene& scene, const Groups& groups,
                       bool with_coordinates)
{
  out << (scene.first_size ? "i,file," : "i,") << (scene.ids.empty() ? "" : "id,");
  if(with_coordinates)
    write_names(out, scene, scene.names.front(), "");
  out << "neighbors,component\n";
  for(std::size_t i = 0; i < scene.size(); ++i) {
    out << scene.position(i) << ',';
    if(scene.first_size)
      out << scene.file(i) << ',';
    if(!scene.ids.empty())
      out << csv_field(scene.ids[i]) << ',';
    if(with_coordinates)
      write_coordinates(out, scene, i);
    out << groups.neighbors(i) << ',' << groups.component(i) << '\n';
  }
}

} // namespace

void check_map(const std::string& file, const Scene& scene)
{
  if(is_map(file) && !scene.is_geographic && scene.unit != "deg")
    throw Error(file, "a map has latitudes and longitudes, and this scene has not; write a .csv "
                "file, or read with --geographic");
}

std::unique_ptr<Pair_writer> make_pair_writer(const std::string& file, std::ostream& stream,
                                              const Scene& scene, bool with_coordinates)
{
  if(is_map(file))
    return std::make_unique<Pair_map>(stream, scene);
  return std::make_unique<Pair_table>(stream, scene, with_coordinates);
}

void write_points(const std::string& file, std::ostream& stream, const Scene& scene,
                  const Groups& groups, bool with_coordinates)
{
  if(is_map(file))
    write_point_map(stream, scene, groups);
  else
    write_point_table(stream, scene, groups, with_coordinates);
}

} // namespace near_pairs
