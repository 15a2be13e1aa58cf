// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Methods without CGAL: the forms of distance_forms.h, the grid, nanoflann and Boost's R-tree.

#include "methods/Cell_list.h"
#include "columns.h"

#include "support/exact_points.h"

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#if __has_include(<nanoflann.hpp>)
#include <nanoflann.hpp>
#define THICK_LAB_HAS_NANOFLANN
#endif

#include <limits>

namespace lab {
namespace {

// ---- forms --------------------------------------------------------------------------------------

template <class Form, std::size_t Dimension>
Found find_by_form(const Point_scene& scene)
{
  const auto points = array_points<Dimension>(scene);
  const double r = length_of(scene.radius);
  return timed(false, [&](Pairs& pairs) {
    for_each_candidate(points, r, [&](std::size_t i, std::size_t j) {
      if(Form::is_near(points[i], points[j], r))
        pairs.push_back(std::minmax(i, j));
    });
  });
}

// ---- grids: candidates are decided exactly, so that only lost ones are wrong --------------------

struct By_division
{
  double r;
  double operator()(double x) const { return std::floor(x / r); }
};

struct By_inverse
{
  explicit By_inverse(double r) : inverse(1 / r) {}
  double inverse;
  double operator()(double x) const { return std::floor(x * inverse); }
};

template <class Cell_of, std::size_t Dimension>
Found find_by_grid(const Point_scene& scene)
{
  const auto points = array_points<Dimension>(scene);
  const test_support::Exact_points exact(scene.points, scene.radius);
  return timed(false, [&](Pairs& pairs) {
    const Cell_list<Dimension> cells(points,
                                     Cell_of{test_support::upper_bound(scene.radius)});
    cells.for_each_candidate([&](std::size_t i, std::size_t j) {
      if(exact.are_within_radius(i, j))
        pairs.push_back(std::minmax(i, j));
    });
  });
}

// ---- nanoflann ----------------------------------------------------------------------------------

template <std::size_t Dimension>
struct Nanoflann_points
{
  std::vector<Array_point<Dimension>> points;

  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const { return points[i][axis]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const
  {
    return false;
  }
};

#ifdef THICK_LAB_HAS_NANOFLANN

// Its radius is the square, and its ball is open; the next double makes it closed.
template <std::size_t Dimension, bool IsClosed>
Found find_by_nanoflann(const Point_scene& scene)
{
  using Adaptor = Nanoflann_points<Dimension>;
  using Tree
    = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Adaptor>, Adaptor,
                                          Dimension, std::size_t>;
  const Adaptor adaptor{array_points<Dimension>(scene)};
  const double r = length_of(scene.radius);
  const double square
    = IsClosed ? std::nextafter(r * r, std::numeric_limits<double>::infinity()) : r * r;
  return timed(true, [&](Pairs& pairs) {
    Tree tree(Dimension, adaptor);
    tree.buildIndex();
    std::vector<std::pair<std::size_t, double>> near;
    nanoflann::SearchParams parameters;
    parameters.sorted = false;
    for(std::size_t i = 0; i < adaptor.points.size(); ++i) {
      tree.radiusSearch(adaptor.points[i].data(), square, near, parameters);
      for(const auto& neighbour : near)
        if(neighbour.first != i)
          pairs.emplace_back(i, neighbour.first);
    }
  });
}

#endif // THICK_LAB_HAS_NANOFLANN

// ---- Boost.Geometry -----------------------------------------------------------------------------

namespace bg = boost::geometry;

struct Compare_comparable
{
  template <class Point>
  static bool is_near(const Point& p, const Point& q, double r)
  {
    return bg::comparable_distance(p, q) <= r * r;
  }
};

struct Compare_true
{
  template <class Point>
  static bool is_near(const Point& p, const Point& q, double r)
  {
    return bg::distance(p, q) <= r;
  }
};

template <class Form, std::size_t Dimension>
Found find_by_rtree(const Point_scene& scene)
{
  using Point = bg::model::point<double, Dimension, bg::cs::cartesian>;
  using Value = std::pair<Point, std::size_t>;
  const auto make_point = [](const Array_point<Dimension>& a) {
    if constexpr(Dimension == 2)
      return Point(a[0], a[1]);
    else
      return Point(a[0], a[1], a[2]);
  };
  const auto corner = [&](Array_point<Dimension> a, double shift) {
    for(double& x : a)
      x += shift;
    return make_point(a);
  };
  const auto points = array_points<Dimension>(scene);
  const double r = length_of(scene.radius);
  std::vector<Value> values;
  for(const auto& a : points)
    values.emplace_back(make_point(a), values.size());
  return timed(true, [&](Pairs& pairs) {
    const bg::index::rtree<Value, bg::index::quadratic<16>> tree(values);
    for(std::size_t i = 0; i < points.size(); ++i) {
      const bg::model::box<Point> window(corner(points[i], -r), corner(points[i], r));
      const auto is_near = [&](const Value& other) {
        return other.second != i && Form::is_near(values[i].first, other.first, r);
      };
      for(auto found = tree.qbegin(bg::index::intersects(window) && bg::index::satisfies(is_near));
          found != tree.qend(); ++found)
        pairs.emplace_back(i, found->second);
    }
  });
}

template <std::size_t Dimension>
std::vector<Method> methods()
{
  return {
    {"double", "form", find_by_form<Squared_in<double>, Dimension>},
    {"double, fma", "form", find_by_form<Squared_with_fma, Dimension>},
    {"double, sqrt", "form", find_by_form<With_square_root, Dimension>},
    {"double, hypot", "form", find_by_form<With_hypot, Dimension>},
    {"double, expanded", "form", find_by_form<Expanded, Dimension>},
    {"float", "form", find_by_form<Squared_in<float>, Dimension>},
    {"long double", "form", find_by_form<Squared_in<long double>, Dimension>},
    {"grid, x / r", "grid", find_by_grid<By_division, Dimension>},
    {"grid, x * (1 / r)", "grid", find_by_grid<By_inverse, Dimension>},
#ifdef THICK_LAB_HAS_NANOFLANN
    {"nanoflann, open", "library", find_by_nanoflann<Dimension, false>},
    {"nanoflann, closed", "library", find_by_nanoflann<Dimension, true>},
#endif
    {"Boost rtree, squared", "library", find_by_rtree<Compare_comparable, Dimension>},
    {"Boost rtree, distance", "library", find_by_rtree<Compare_true, Dimension>},
  };
}

} // namespace

std::vector<Method> plain_methods(int dimension)
{
  return dimension == 2 ? methods<2>() : methods<3>();
}

} // namespace lab
