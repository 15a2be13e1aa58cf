// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Meshes of a file to solids; see feature.h.

#include "error.h"
#include "face_triangles.h"
#include "feature.h"
#include "mesh_reader.h"
#include "row_numbers.h"

#include <algorithm>
#include <memory>
#include <numeric>
#include <utility>

namespace near_pairs {
namespace {

// Numbers points by their coordinates: equal ones have one number.
std::vector<std::size_t> numbers_of(const std::vector<std::array<double, 3>>& points)
{
  std::vector<std::size_t> order(points.size()), numbers(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return points[i] < points[j]; });
  for(std::size_t i = 1; i < order.size(); ++i)
    numbers[order[i]] = numbers[order[i - 1]] + (points[order[i - 1]] < points[order[i]]);
  return numbers;
}

// Whether the search fills the mesh.
bool is_closed(const Mesh& mesh)
{
  const std::vector<std::size_t> numbers = numbers_of(mesh.points);
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for(const std::array<std::size_t, 3>& triangle : mesh.triangles)
    for(std::size_t k = 0; k < 3; ++k) {
      const auto [low, high]
        = std::minmax(numbers[triangle[k]], numbers[triangle[(k + 1) % 3]]);
      if(low != high)
        edges.emplace_back(low, high);
    }
  std::sort(edges.begin(), edges.end());
  for(std::size_t i = 0; i < edges.size(); i += 2)
    if(i + 1 == edges.size() || edges[i] != edges[i + 1])
      return false;
  return true;
}

class Solid_maker
{
public:
  Solid_maker(const Input& input, const Read_options& options)
    : input_(input), reader_(make_mesh_reader(format_of(input.name(), options), input, options))
  {
    if(!reader_)
      throw Error(input.name(), "--solids reads the formats obj, off, ply and stl");
    if(reader_->dimension != 3)
      throw Error(input.name(), "solids are in space, and the vertices have no coordinate z");
  }

  std::vector<Feature> make()
  {
    reader_->take_face = [&](const Face& face) { add_face(face); };
    for(Row row; reader_->next(row); )
      vertices_.push_back(point_of(row));
    if(faces_.empty())
      throw Error(input_.name(), "has no faces, which solids are made of");
    // The faces of a solid may be at several places of the file.
    std::stable_sort(faces_.begin(), faces_.end(), [](const Face& a, const Face& b) {
      return a.solid < b.solid;
    });
    vertices_in_solid_.assign(vertices_.size(), {0, 0});
    for(const Face& face : faces_) {
      if(solids_.empty() || face.solid != solid_)
        begin_solid(face.solid);
      add_triangles(face);
    }
    for(Feature& solid : solids_)
      solid.mesh.is_closed = is_closed(solid.mesh);
    if(solids_.size() == 1)
      solids_.front().id.clear();
    return std::move(solids_);
  }

private:
  std::array<double, 3> point_of(const Row& row) const
  {
    const Place place = {input_, *reader_, row};
    return {read_number(place, 0).value, read_number(place, 1).value,
            read_number(place, 2).value};
  }

  void add_face(const Face& face)
  {
    if(face.corners.size() < 3)
      throw wrong(face, "has fewer than three corners");
    if(face.corners.size() > most_corners)
      throw wrong(face, "has more than " + std::to_string(most_corners) + " corners");
    faces_.push_back(face);
  }

  void begin_solid(std::size_t solid)
  {
    solid_ = solid;
    solids_.emplace_back();
    solids_.back().id = reader_->solids[solid];
  }

  void add_triangles(const Face& face)
  {
    Corners corners;
    for(std::size_t vertex : face.corners) {
      if(vertex >= vertices_.size())
        throw wrong(face, "has a corner that is no vertex");
      corners.push_back(vertices_[vertex]);
    }
    const auto triangles = triangles_of(corners);
    if(triangles.empty())
      throw wrong(face, "is in a plane, and crosses itself");
    Mesh& mesh = solids_.back().mesh;
    mesh.bent_faces += !are_in_plane(corners);
    for(const std::array<std::size_t, 3>& triangle : triangles)
      mesh.triangles.push_back({position_of(face.corners[triangle[0]]),
                                position_of(face.corners[triangle[1]]),
                                position_of(face.corners[triangle[2]])});
  }

  // The position of a vertex among those of the solid in hand.
  std::size_t position_of(std::size_t vertex)
  {
    std::vector<std::array<double, 3>>& points = solids_.back().mesh.points;
    auto& [number_of_solid, position] = vertices_in_solid_[vertex];
    if(number_of_solid != solids_.size()) {
      number_of_solid = solids_.size();
      position = points.size();
      points.push_back(vertices_[vertex]);
    }
    return position;
  }

  Error wrong(const Face& face, const std::string& what) const
  {
    if(face.line != 0)
      return Error(input_.name(), face.line, "a face " + what);
    return Error(input_.name(), "a face " + what);
  }

  const Input& input_;
  const std::unique_ptr<Mesh_reader> reader_;
  std::vector<std::array<double, 3>> vertices_;
  std::vector<Face> faces_;
  std::vector<Feature> solids_;
  std::size_t solid_ = 0; // in hand, as the reader numbers them
  std::vector<std::pair<std::size_t, std::size_t>> vertices_in_solid_; // the last one, and where
};

} // namespace

std::vector<Feature> read_solids(const Input& input, const Read_options& options)
{
  return Solid_maker(input, options).make();
}

} // namespace near_pairs
