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

#include <CGAL/Kernel_traits.h>

#include <CGAL/Thick_intersection_d/internal/arrays/Hash_table.h>
#include <CGAL/Thick_intersection_d/internal/arrays/hash.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/arrays/prefix_sums.h>
#include <CGAL/Thick_intersection_d/internal/arrays/radix_sort.h>
#include <CGAL/Thick_intersection_d/internal/input/vertices.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_kernel_objects_intersect.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Numbers points in space by their coordinates, in the order in which they come.
class Numbered_points
{
public:
  using Point = std::array<double, 3>;

  std::size_t size() const { return points_.size(); }

  // Returns the number of a point. Equal points have one number.
  Place number_of(const Point& p)
  {
    if(table_.slot_count() < 2 * (points_.size() + 1))
      grow();
    Place& slot = table_[slot_of(p)];
    if(slot == no_point) {
      slot = static_cast<Place>(points_.size());
      points_.push_back(p);
    }
    return slot;
  }

private:
  static constexpr Place no_point = max_place;

  std::size_t slot_of(const Point& p) const
  {
    std::uint64_t sum = 0;
    for(std::size_t axis = 0; axis < 3; ++axis)
      sum = hash_.add(sum, static_cast<int>(axis), radix_key(p[axis]));
    return table_.find(hash_.finish(sum), [&](Place other) { return points_[other] == p; });
  }

  void grow()
  {
    table_ = Hash_table<Place, no_point>(2 * (points_.size() + 16));
    for(std::size_t i = 0; i < points_.size(); ++i)
      table_[slot_of(points_[i])] = static_cast<Place>(i);
  }

  const Sequence_hash<3> hash_{3, seed_of_process()};
  Hash_table<Place, no_point> table_;
  std::vector<Point> points_;
};

class Mesh_shape
{
public:
  // `face_at(i)` is one of `count` triangles.
  template <class Face_at>
  Mesh_shape(std::size_t count, const Face_at& face_at) : faces_(count)
  {
    if(!number_doubles(face_at))
      number_exactly(face_at);
  }

  bool is_closed() const
  {
    std::vector<Place> ends(vertex_count_ + 1), others;
    for_each_edge([&](Place low, Place) { ++ends[low]; });
    others.resize(replace_by_prefix_sums(ends.data(), ends.data() + ends.size()));
    for_each_edge([&](Place low, Place high) { others[ends[low]++] = high; });
    // Invariant: the edges of the vertices up to this one occur an even number of times each.
    Place first = 0;
    for(std::size_t vertex = 0; vertex < vertex_count_; first = ends[vertex++])
      if(!are_pairs(others.begin() + first, others.begin() + ends[vertex]))
        return false;
    return true;
  }

  // Calls take(i) for one face of each set of faces that are connected by common vertices, if
  // is_unwanted() holds for none of them.
  template <class Is_unwanted, class Take>
  void for_each_component(const Is_unwanted& is_unwanted, const Take& take) const
  {
    std::vector<Place> links(vertex_count_); // lead to one vertex of each component
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
    std::vector<bool> is_taken(vertex_count_);
    for(std::size_t i = 0; i < faces_.size(); ++i)
      if(is_unwanted(i))
        is_taken[find(faces_[i][0])] = true;
    for(std::size_t i = 0; i < faces_.size(); ++i)
      if(const Place component = find(faces_[i][0]); !is_taken[component]) {
        is_taken[component] = true;
        take(i);
      }
  }

private:
  // Returns false if a coordinate is no double.
  template <class Face_at>
  bool number_doubles(const Face_at& face_at)
  {
    Numbered_points points;
    for(std::size_t i = 0; i < faces_.size(); ++i) {
      std::array<Numbered_points::Point, 3> vertices;
      if(!read_vertices(face_at(i), [&](std::size_t k, int axis, double x) {
           vertices[k][static_cast<std::size_t>(axis)] = x;
         }))
        return false;
      for(std::size_t k = 0; k < 3; ++k)
        faces_[i][k] = points.number_of(vertices[k]);
    }
    vertex_count_ = points.size();
    return true;
  }

  template <class Face_at>
  void number_exactly(const Face_at& face_at)
  {
    const auto vertex = [&](std::size_t i, int k) {
      return with_exact_predicates(face_at(i).vertex(k));
    };
    using Point = decltype(vertex(0, 0));
    std::map<Point, Place, typename Kernel_traits<Point>::Kernel::Less_xyz_3> numbers;
    for(std::size_t i = 0; i < faces_.size(); ++i)
      for(std::size_t k = 0; k < 3; ++k)
        faces_[i][k] = numbers.emplace(vertex(i, static_cast<int>(k)),
                                       static_cast<Place>(numbers.size())).first->second;
    vertex_count_ = numbers.size();
  }

  template <class Take>
  void for_each_edge(const Take& take) const
  {
    for(const std::array<Place, 3>& face : faces_)
      for(std::size_t k = 0; k < 3; ++k)
        if(const auto [low, high] = std::minmax(face[k], face[(k + 1) % 3]); low != high)
          take(low, high);
  }

  // Whether each number occurs an even number of times. Sorts the numbers.
  static bool are_pairs(std::vector<Place>::iterator first, std::vector<Place>::iterator last)
  {
    std::sort(first, last);
    for(; first != last; first += 2)
      if(first + 1 == last || first[0] != first[1])
        return false;
    return true;
  }

  std::vector<std::array<Place, 3>> faces_; // their vertices
  std::size_t vertex_count_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_MESH_SHAPE_H
