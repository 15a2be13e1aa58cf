// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_MESH_SHAPE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_MESH_SHAPE_H

// Whether the faces of a mesh are closed, and which of them are connected, by the coordinates of
// their vertices alone: a file of triangles that repeats points is as good as a mesh.
//
// Faces are closed if each edge, as the pair of its ends, belongs to an even number of them. Edges
// of length zero do not count. The faces are a cycle modulo 2 then. So two rays from a point, which
// pass no edge, cross the faces equally often, modulo 2.

#include <CGAL/Exact_rational.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/Double_grid.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arrays/hash.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/features/check_features.h>
#include <CGAL/Thick_intersection_d/internal/features/feature_kinds.h>
#include <CGAL/Thick_intersection_d/internal/features/mesh_faces.h>
#include <CGAL/Thick_intersection_d/internal/input/base_kind.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/vertices.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Whether an edge is known to belong to an odd number of faces: if the hashes of the edges of all
// faces do not cancel out, modulo 2. An edge whose ends have one hash counts nowhere.
template <class Mesh>
bool has_odd_edge(const Mesh& mesh, std::size_t feature)
{
  const Sequence_hash<3> hash(3, seed_of_process());
  bool are_doubles = true;
  const auto hash_of = [&](const auto& point) {
    std::uint64_t sum = 0;
    for(int axis = 0; axis < 3; ++axis) {
      const auto x = coordinate_bounds(point, axis);
      are_doubles &= x.first == x.second;
      sum = hash.add(sum, axis, x.first == 0 ? 0 : bits_of(x.first)); // -0. is 0.
    }
    return sum;
  };
  std::uint64_t rest = 0;
  for_each_face(mesh, feature, [&](const auto& p, const auto& q, const auto& r) {
    const std::uint64_t a = hash_of(p), b = hash_of(q), c = hash_of(r);
    rest ^= (a != b ? a * b : 0) ^ (b != c ? b * c : 0) ^ (c != a ? c * a : 0);
  });
  return are_doubles && rest != 0;
}

class Mesh_shape
{
public:
  // `piece_at(i)` is one of `count` pieces. A segment is a face with two vertices.
  template <class Piece_at>
  Mesh_shape(std::size_t count, const Piece_at& piece_at) : faces_(count)
  {
    check_feature_count("vertices of the faces of a mesh", 3 * count);
    if(!number_vertices<double>(piece_at))
      number_vertices<Exact_rational>(piece_at);
  }

  bool is_closed() const
  {
    std::vector<std::pair<Place, Place>> edges;
    edges.reserve(3 * faces_.size());
    for(const std::array<Place, 3>& face : faces_)
      for(std::size_t k = 0; k < 3; ++k)
        if(const auto [low, high] = std::minmax(face[k], face[(k + 1) % 3]); low != high)
          edges.emplace_back(low, high);
    std::sort(edges.begin(), edges.end());
    // Edges that belong to odd numbers of faces form cycles. So none of them is alone at the end.
    for(auto edge = edges.begin(); edge != edges.end(); edge += 2)
      if(edge[0] != edge[1])
        return false;
    return true;
  }

  // Numbers the sets of faces that common vertices connect, and returns the number of each face.
  std::vector<Place> part_numbers() const
  {
    std::vector<Place> links(vertex_count_); // lead to one vertex of each set
    std::iota(links.begin(), links.end(), Place(0));
    const auto find = [&](Place v) {
      while(links[v] != v)
        v = links[v] = links[links[v]];
      return v;
    };
    for(const auto& [p, q, r] : faces_) {
      links[find(p)] = find(q);
      links[find(q)] = find(r);
    }
    std::vector<Place> number_of(vertex_count_, max_place), numbers;
    Place count = 0;
    for(const auto& face : faces_) {
      Place& number = number_of[find(face[0])];
      if(number == max_place)
        number = count++;
      numbers.push_back(number);
    }
    return numbers;
  }

private:
  // Equal vertices get one number. Returns false if a coordinate is no NT.
  template <class NT, class Piece_at>
  bool number_vertices(const Piece_at& piece_at)
  {
    std::vector<std::pair<std::array<NT, 3>, std::size_t>> corners;
    corners.reserve(3 * faces_.size());
    bool are_numbers = true;
    const auto add_corners = [&](const auto& object) {
      constexpr int last = Vertex_count<std::decay_t<decltype(object)>>::value - 1;
      for(int k = 0; k < 3; ++k) {
        const auto x = [&](int axis) {
          return coordinate_of<NT>(object, (std::min)(k, last), axis, are_numbers);
        };
        corners.push_back({{x(0), x(1), x(2)}, corners.size()});
      }
    };
    for(std::size_t i = 0; i < faces_.size(); ++i)
      with_points_of(piece_at(i), add_corners);
    std::sort(corners.begin(), corners.end());
    vertex_count_ = 0;
    for(auto corner = corners.begin(); corner != corners.end(); ++corner) {
      vertex_count_ += corner == corners.begin() || corner[-1].first != corner->first;
      faces_[corner->second / 3][corner->second % 3] = static_cast<Place>(vertex_count_ - 1);
    }
    return are_numbers;
  }

  template <class NT, class Object>
  static NT coordinate_of(const Object& object, int v, int axis,
                          [[maybe_unused]] bool& are_numbers)
  {
    if constexpr(std::is_same_v<NT, Exact_rational>)
      return to_exact_rational(coordinate(vertex_of(object, v), axis));
    else {
      const auto x = vertex_bounds(object, v, axis);
      are_numbers &= x.first == x.second;
      return x.first;
    }
  }

  std::vector<std::array<Place, 3>> faces_; // their vertices
  std::size_t vertex_count_ = 0;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_MESH_SHAPE_H
