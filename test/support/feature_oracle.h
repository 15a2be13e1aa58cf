// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Polylines and polygons on a lattice, and whether two of them intersect: by all pairs of their
// segments, and by all vertices of one in the other. In space, there are polylines only.
//
// This shares nothing with the search. Coordinates are less than 2^12.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_FEATURE_ORACLE_H
#define THICK_INTERSECTION_TEST_SUPPORT_FEATURE_ORACLE_H

#include "hull_oracle.h"
#include "pairs.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

namespace test_support {

using Lattice_point = Hull_vector<std::int64_t>; // in the plane, the last coordinate is zero
using Chain = std::vector<Lattice_point>;

enum class Feature_kind {
  POINT,
  POLYLINE,
  POLYGON,
  WITH_HOLES, // the first chain is the outer boundary, and the others are holes
  POLYGONS    // a polygon for each chain
};

struct Lattice_feature
{
  Feature_kind kind;
  std::vector<Chain> chains;

  bool is_filled() const
  {
    return kind != Feature_kind::POINT && kind != Feature_kind::POLYLINE;
  }
};

using Lattice_features = std::vector<Lattice_feature>;
using Lattice_segment = std::array<Lattice_point, 2>;

inline std::vector<Lattice_segment> segments_of(const Lattice_feature& feature)
{
  std::vector<Lattice_segment> segments;
  for(const Chain& chain : feature.chains) {
    for(std::size_t i = 1; i < chain.size(); ++i)
      segments.push_back({chain[i - 1], chain[i]});
    if(!chain.empty() && (feature.is_filled() || chain.size() == 1))
      segments.push_back({chain.back(), chain.front()});
  }
  return segments;
}

inline bool do_segments_meet(const Lattice_segment& a, const Lattice_segment& b)
{
  for(std::size_t axis = 0; axis < 3; ++axis)
    if((std::max)(a[0][axis], a[1][axis]) < (std::min)(b[0][axis], b[1][axis])
       || (std::max)(b[0][axis], b[1][axis]) < (std::min)(a[0][axis], a[1][axis]))
      return false;
  return do_hulls_intersect(Hull_vectors<std::int64_t>(a.begin(), a.end()),
                            Hull_vectors<std::int64_t>(b.begin(), b.end()));
}

// Whether `p`, which is on no edge of the ring, is inside. The ray goes up so steeply that it has
// no other point of the lattice.
inline bool is_inside_ring(const Lattice_point& p, const Chain& ring)
{
  const Lattice_point far = {p[0] + 1, p[1] + (std::int64_t(1) << 20), 0};
  const auto turn = [](const Lattice_point& a, const Lattice_point& b, const Lattice_point& c) {
    return cross(difference(b, a), difference(c, a))[2] > 0;
  };
  bool is_inside = false;
  for(std::size_t i = 0; i < ring.size(); ++i) {
    const Lattice_point& a = ring[i];
    const Lattice_point& b = ring[(i + 1) % ring.size()];
    if(a != p && b != p && turn(p, far, a) != turn(p, far, b) && turn(a, b, p) != turn(a, b, far))
      is_inside = !is_inside;
  }
  return is_inside;
}

// Whether a point that is on no edge is in the feature.
inline bool is_inside(const Lattice_point& p, const Lattice_feature& feature)
{
  const auto is_in = [&](const Chain& ring) { return is_inside_ring(p, ring); };
  const auto first = feature.chains.begin(), last = feature.chains.end();
  if(feature.kind == Feature_kind::WITH_HOLES)
    return is_in(*first) && std::none_of(first + 1, last, is_in);
  return feature.is_filled() && std::any_of(first, last, is_in);
}

inline bool has_vertex_inside(const Lattice_feature& a, const Lattice_feature& b)
{
  return std::any_of(a.chains.begin(), a.chains.end(), [&](const Chain& chain) {
    return std::any_of(chain.begin(), chain.end(),
                       [&](const Lattice_point& p) { return is_inside(p, b); });
  });
}

// The pairs of features that have segments of which do_pair() says so, or a vertex inside.
template <class Function>
Pairs pairs_of_features(const Lattice_features& features, const Function& do_pair)
{
  std::vector<std::vector<Lattice_segment>> segments;
  for(const Lattice_feature& feature : features)
    segments.push_back(segments_of(feature));
  Pairs pairs;
  for(std::size_t j = 0; j < features.size(); ++j)
    for(std::size_t i = 0; i < j; ++i) {
      const bool are_any
        = std::any_of(segments[i].begin(), segments[i].end(), [&](const auto& a) {
            return std::any_of(segments[j].begin(), segments[j].end(),
                               [&](const auto& b) { return do_pair(a, b); });
          });
      if(are_any || has_vertex_inside(features[i], features[j])
         || has_vertex_inside(features[j], features[i]))
        pairs.emplace_back(i, j);
    }
  return pairs;
}

inline Pairs intersecting_pairs(const Lattice_features& features)
{
  return pairs_of_features(features, do_segments_meet);
}

// Whether two segments that do not meet are within a bound on the squared distance.
inline bool are_near(const Lattice_segment& a, const Lattice_segment& b, std::int64_t r2,
                     bool is_open)
{
  using Kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  for(std::size_t axis = 0; axis < 3; ++axis) {
    const std::int64_t gap
      = (std::max)((std::min)(a[0][axis], a[1][axis]) - (std::max)(b[0][axis], b[1][axis]),
                   (std::min)(b[0][axis], b[1][axis]) - (std::max)(a[0][axis], a[1][axis]));
    if(gap > 0 && gap * gap > r2)
      return false;
  }
  const auto point = [](const Lattice_point& p) {
    const auto x = [&](std::size_t axis) { return static_cast<double>(p[axis]); };
    return Kernel::Point_3(x(0), x(1), x(2));
  };
  const auto object = [&](const Lattice_segment& s) {
    return std::pair(Kernel::Segment_3(point(s[0]), point(s[1])), s[0] == s[1]);
  };
  const auto [s, is_s_point] = object(a);
  const auto [t, is_t_point] = object(b);
  const CGAL::Exact_rational distance
    = is_s_point && is_t_point ? CGAL::squared_distance(s.source(), t.source())
      : is_s_point             ? CGAL::squared_distance(s.source(), t)
      : is_t_point             ? CGAL::squared_distance(s, t.source())
                               : CGAL::squared_distance(s, t);
  return is_open ? distance < r2 : distance <= r2;
}

inline Pairs near_feature_pairs(const Lattice_features& features, std::int64_t r2, bool is_open)
{
  return pairs_of_features(features, [=](const auto& a, const auto& b) {
    return do_segments_meet(a, b) || are_near(a, b, r2, is_open);
  });
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_FEATURE_ORACLE_H
