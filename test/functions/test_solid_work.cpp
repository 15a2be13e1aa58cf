// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The work of the search of meshes: the tests of faces are counted, and the comparisons of boxes,
// where boxes of many meshes or parts of them meet, but those of few faces; allocations where most
// meshes are inside others; and bytes.

#include "support/counting_allocator.h"
#include "support/unit_test.h"
#include "support/usual_kernels.h"

#include <CGAL/thick_feature_intersection_d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>

using namespace test_support;

namespace {

using Point = Epick::Point_3;
using Soup = std::pair<std::vector<Point>, std::vector<std::array<std::size_t, 3>>>;
using Soups = std::vector<Soup>;

double tests = 0, comparisons = 0;

// Counts the tests of faces.
struct Counted_test : internal::Pieces_intersect
{
  template <class Faces>
  static bool do_meet(const Faces& faces, std::size_t i, std::size_t j)
  {
    ++tests;
    return internal::Pieces_intersect::do_meet(faces, i, j);
  }
};

// Counts the comparisons of trees.
struct Counted_box : internal::Space_box
{};

bool do_boxes_meet(const Counted_box& a, const Counted_box& b)
{
  ++comparisons;
  return internal::do_boxes_meet(a, b);
}

// ---- meshes -------------------------------------------------------------------------------------

// A box whose sides are cut into squares of two faces, `count` along each edge.
void add_box(Soup& soup, const Point& low, const Point& high, std::size_t count)
{
  const auto add_side = [&](int axis, double at) {
    const std::size_t first = soup.first.size();
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for(std::size_t i = 0; i <= count; ++i)
      for(std::size_t j = 0; j <= count; ++j) {
        double x[3];
        const auto along = [&](int k, std::size_t step) {
          const double part = static_cast<double>(step) / static_cast<double>(count);
          return step == count ? high[k] : low[k] + (high[k] - low[k]) * part;
        };
        x[axis] = at;
        x[u] = along(u, i);
        x[v] = along(v, j);
        soup.first.emplace_back(x[0], x[1], x[2]);
        if(i != count && j != count) {
          const std::size_t p = first + i * (count + 1) + j, q = p + count + 1;
          soup.second.push_back({p, q, p + 1});
          soup.second.push_back({q, q + 1, p + 1});
        }
      }
  };
  for(int axis = 0; axis < 3; ++axis) {
    add_side(axis, low[axis]);
    add_side(axis, high[axis]);
  }
}

Soup box(const Point& low, const Point& high, std::size_t count)
{
  Soup soup;
  add_box(soup, low, high, count);
  return soup;
}

// The points point_at(u, v) of numbers from 0 to 1, in so many steps of each.
template <class Point_at>
Soup surface(std::size_t u_steps, std::size_t v_steps, const Point_at& point_at)
{
  Soup soup;
  for(std::size_t i = 0; i <= u_steps; ++i)
    for(std::size_t j = 0; j <= v_steps; ++j) {
      soup.first.push_back(point_at(static_cast<double>(i) / static_cast<double>(u_steps),
                                    static_cast<double>(j) / static_cast<double>(v_steps)));
      if(i != u_steps && j != v_steps) {
        const std::size_t p = i * (v_steps + 1) + j, q = p + v_steps + 1;
        soup.second.push_back({p, q, p + 1});
        soup.second.push_back({q, q + 1, p + 1});
      }
    }
  return soup;
}

constexpr double turn = 6.28318530717959;

// Two combs of plates, those of one between those of the other.
Soups combs(std::size_t teeth, std::size_t count)
{
  Soups combs(2);
  for(std::size_t i = 0; i < 2 * teeth; ++i) {
    const double z = 2. * static_cast<double>(i);
    add_box(combs[i % 2], Point(0, 0, z), Point(99, 99, z + 1), count);
  }
  return combs;
}

// Two spiral staircases, each of which winds between the turns of the other.
Soups staircases(std::size_t steps, double turns)
{
  Soups stairs;
  for(const double first : {0., turn / 2})
    stairs.push_back(surface(steps, 4, [&](double u, double v) {
      const double angle = first + turn * turns * u;
      return Point((1 + v) * std::cos(angle), (1 + v) * std::sin(angle), turns * u);
    }));
  return stairs;
}

// Hollow boxes, each inside the one before it.
Soups shells(std::size_t levels, std::size_t count)
{
  Soups shells(levels);
  for(std::size_t i = 0; i < 2 * levels; ++i) {
    const double low = static_cast<double>(i), high = 5. * static_cast<double>(levels) - low;
    add_box(shells[i / 2], Point(low, low, low), Point(high, high, high), count);
  }
  return shells;
}

// Boxes, each inside the one before it and with another one beside those of the others.
Soups nested_boxes(std::size_t levels, std::size_t count)
{
  Soups soups(levels);
  for(std::size_t i = 0; i < levels; ++i) {
    const double low = static_cast<double>(i), high = 5. * static_cast<double>(levels) - low;
    add_box(soups[i], Point(-low - .5, low, low), Point(-low, high, high), count);
    add_box(soups[i], Point(low, low, low), Point(high, high, high), count);
  }
  return soups;
}

// Surfaces of separate faces, each of them between others.
Soups layers(std::size_t count, std::size_t steps)
{
  Soups layers;
  for(std::size_t i = 0; i < count; ++i) {
    const Soup whole = surface(steps, steps, [&](double u, double v) {
      return Point(u, v, std::sin(9 * u) + 1e-3 * static_cast<double>(i));
    });
    Soup& faces = layers.emplace_back();
    for(const auto& triple : whole.second) {
      const std::size_t first = faces.first.size();
      for(const std::size_t vertex : triple)
        faces.first.push_back(whole.first[vertex]);
      faces.second.push_back({first, first + 1, first + 2});
    }
  }
  return layers;
}

// A hilly surface, and small boxes above it.
Soups huge_and_small(std::size_t count)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> anywhere(0, 1);
  const auto height = [](double x, double y) { return std::sin(20 * x) * std::sin(15 * y) / 9; };
  Soups soups = {surface(count, count, [&](double u, double v) {
    return Point(u, v, height(u, v));
  })};
  const double size = .3 / static_cast<double>(count);
  for(std::size_t i = 0; i < count * count / 9; ++i) {
    const double x = anywhere(random), y = anywhere(random), z = height(x, y) + 8 * size;
    soups.push_back(box(Point(x, y, z), Point(x + size, y + size, z + size), 1));
  }
  return soups;
}

// Two rings, each through the hole of the other.
Soups linked_rings(std::size_t count)
{
  const auto at = [](double a, double b) {
    return std::array<double, 3>{std::sin(b), (4 + std::cos(b)) * std::cos(a),
                                 (4 + std::cos(b)) * std::sin(a)};
  };
  return {surface(2 * count, count, [&](double u, double v) {
            const auto [x, y, z] = at(turn * u, turn * v);
            return Point(x, y, z);
          }),
          surface(2 * count, count, [&](double u, double v) {
            const auto [x, y, z] = at(turn * u, turn * v);
            return Point(z, 4 + y, x);
          })};
}

// Open surfaces in a box that is part of the same feature, and a box inside of that.
std::vector<Soups> surfaces_and_boxes(std::size_t count)
{
  Soups whole = {box(Point(0, 0, 0), Point(9, 9, 9), 1)};
  for(int i = 0; i < 20; ++i)
    whole.push_back(surface(count, count, [&](double u, double v) {
      return Point(1 + u, 1 + v, 1 + .1 * i);
    }));
  return {whole, {box(Point(5, 5, 5), Point(6, 6, 6), 1)}};
}

// Strings along axis 0, and along axis 1, at heights in any order. All of them cross the others; if
// two have each height, each of them touches one of the others.
Soups harps(std::size_t strings, bool have_two_each_height = false)
{
  std::mt19937 random(1);
  std::vector<std::size_t> heights(2 * strings);
  for(std::size_t i = 0; i < 2 * strings; ++i)
    heights[i] = have_two_each_height ? i / 2 : i;
  for(std::size_t k = 0; k < 2; ++k) // of each harp
    for(std::size_t i = strings - 1; i > 0; --i)
      std::swap(heights[2 * i + k], heights[2 * (random() % (i + 1)) + k]);
  Soups harps(2);
  for(std::size_t i = 0; i < 2 * strings; ++i) {
    const double at = static_cast<double>(i), end = 2. * static_cast<double>(strings);
    const double z = 1e-3 * static_cast<double>(heights[i]);
    const std::size_t first = i / 2 * 3;
    auto& [points, triples] = harps[i % 2];
    if(i % 2 == 0)
      points.insert(points.end(), {Point(0, at, z), Point(end, at, z), Point(end, at + 1, z)});
    else
      points.insert(points.end(), {Point(at, 0, z), Point(at, end, z), Point(at + 1, end, z)});
    triples.push_back({first, first + 1, first + 2});
  }
  return harps;
}

// ---- tests of faces -----------------------------------------------------------------------------

// Searches meshes, and compares the number of tests of faces with the most that there may be.
void check_tests(const std::string& name, const Soups& soups, std::size_t expected,
                 double most_tests)
{
  std::size_t pairs = 0;
  const auto report = [&](std::size_t, std::size_t) { ++pairs; };
  tests = 0;
  internal::search_features(Counted_test(), report, CGAL::parameters::default_values(),
                            internal::Threads(), soups);
  BOOST_TEST_MESSAGE(name << ": " << tests << " tests of faces");
  BOOST_CHECK_EQUAL(pairs, expected);
  BOOST_CHECK_MESSAGE(tests <= most_tests, name << ": " << tests);
}

BOOST_AUTO_TEST_CASE(faces_of_meshes_that_do_not_meet_are_not_tested)
{
  Soups nested, parts;
  for(int i = 0; i < 40; ++i) {
    nested.push_back(box(Point(i, i, i), Point(99 - i, 99 - i, 99 - i), 6));
    add_box(nested.back(), Point(i + .5, i + .5, i + .5),
            Point(98.5 - i, 98.5 - i, 98.5 - i), 6);
    for(int j = 0; j < 40; ++j)
      parts.push_back(box(Point(3 * i, 3 * j, 0), Point(3 * i + 2, 3 * j + 2, 2), 4));
  }
  check_tests("shells in shells", nested, 0, 0);
  check_tests("many parts", parts, 0, 0);
}

BOOST_AUTO_TEST_CASE(meshes_that_touch_take_few_tests)
{
  Soups grid;
  for(int i = 0; i < 30; ++i)
    for(int j = 0; j < 30; ++j)
      grid.push_back(box(Point(i, j, 0), Point(i + 1, j + 1, 1), 3));
  const std::size_t pairs = 2 * 30 * 29 + 2 * 29 * 29;
  check_tests("cells of a grid", grid, pairs, 2. * static_cast<double>(pairs));
}

// ---- comparisons of boxes -----------------------------------------------------------------------

using Trees = internal::Solid_trees<Epick::Triangle_3, Counted_box>;

// Adds the tree of a mesh, whose faces come in any order.
internal::Halved_range add_tree(Trees& trees, Soup soup)
{
  std::mt19937 random(1);
  std::shuffle(soup.second.begin(), soup.second.end(), random);
  const internal::Place first = trees.size();
  for(const auto& [p, q, r] : soup.second) {
    Counted_box box;
    for(const std::size_t vertex : {p, q, r})
      box.add_point(soup.first[vertex]);
    trees.add_piece({soup.first[p], soup.first[q], soup.first[r]}, box);
  }
  return trees.add_tree(first);
}

internal::Space_box box_of(const Soup& soup)
{
  internal::Space_box box;
  for(const Point& p : soup.first)
    box.add_point(p);
  return box;
}

// Finds the k pairs of faces whose boxes meet, of pairs of meshes whose boxes do. The smaller ones
// of these have n / 2 faces. Returns k.
double check_comparisons(const std::string& name, const Soups& soups, double limit)
{
  Trees trees;
  std::vector<internal::Space_box> boxes;
  std::vector<internal::Halved_range> ranges;
  for(const Soup& soup : soups) {
    boxes.push_back(box_of(soup));
    ranges.push_back(add_tree(trees, soup));
  }
  comparisons = 0;
  double n = 0, k = 0;
  const auto count = [&](internal::Place, internal::Place) {
    ++k;
    return false;
  };
  for(std::size_t i = 0; i < soups.size(); ++i)
    for(std::size_t j = 0; j < i; ++j)
      if(internal::do_boxes_meet(boxes[i], boxes[j])) {
        n += 2. * static_cast<double>((std::min)(soups[i].second.size(), soups[j].second.size()));
        trees.is_any_pair(ranges[i], ranges[j], count);
      }
  const double work = comparisons / (n + k);
  BOOST_TEST_MESSAGE(name << ": n = " << n << ", k = " << k << ", comparisons / (n + k) " << work);
  BOOST_CHECK_MESSAGE(work <= limit, name << ": " << work);
  return k;
}

// However the faces come. All strings of a harp cross all of the other one, so that the trees of
// these tell little.
BOOST_AUTO_TEST_CASE(boxes_are_compared_a_few_times_for_each_face)
{
  for(const std::size_t n : {20, 40}) {
    check_comparisons("combs of cut plates", combs(n, 8), 60);
    check_comparisons("combs", combs(10 * n, 1), 50);
    check_comparisons("staircases", staircases(50 * n, static_cast<double>(n)), 3.5);
    check_comparisons("steep staircases", staircases(50 * n, 2), .6);
    check_comparisons("shells in shells", shells(n, 6), 1.5);
    check_comparisons("shells of few faces", shells(4 * n, 1), 1);
    check_comparisons("a huge mesh and small ones", huge_and_small(2 * n), 3);
    check_comparisons("linked rings", linked_rings(n), .1);
    check_comparisons("harps", harps(50 * n), 300);
  }
}

// Faces with vertices beyond the doubles on both sides have boxes without ends.
Soups with_endless_faces(Soups soups)
{
  for(auto& [points, triples] : soups)
    for(std::size_t i = 0; i < 8; ++i) {
      triples.push_back({points.size(), points.size(), points.size() + 1});
      points.insert(points.end(), {Point(-infinity, -infinity, -infinity),
                                   Point(infinity, infinity, infinity)});
    }
  return soups;
}

// Each of them meets all faces of the other mesh. The other faces stay in order.
BOOST_AUTO_TEST_CASE(faces_beyond_doubles_are_sorted)
{
  for(const std::size_t n : {20, 40}) {
    check_comparisons("staircases and endless faces",
                      with_endless_faces(staircases(50 * n, static_cast<double>(n))), 1.8);
    check_comparisons("steep staircases and endless faces",
                      with_endless_faces(staircases(50 * n, 2)), 1.8);
    check_comparisons("linked rings and endless faces", with_endless_faces(linked_rings(n)), 1.8);
  }
}

BOOST_AUTO_TEST_CASE(all_strings_that_touch_are_found)
{
  const std::size_t n = 1000;
  BOOST_CHECK_EQUAL(check_comparisons("harps with pairs", harps(n, true), 300), n);
  const Soups apart = harps(n);
  check_tests("harps", apart, 0, 0);
  for(const std::size_t i : {0, 300, 999}) {
    Soups soups = apart;
    for(std::size_t k = 0; k < 3; ++k) {
      Point& p = soups[1].first[3 * i + k];
      p = Point(p.x(), p.y(), soups[0].first[0].z());
    }
    check_tests("harps with a pair", soups, 1, 1);
  }
}

// It is found by the box route.
BOOST_AUTO_TEST_CASE(the_last_pair_counts)
{
  const std::size_t n = 1000;
  const Soups soups = harps(n, true);
  Trees trees;
  const internal::Halved_range a = add_tree(trees, soups[0]), b = add_tree(trees, soups[1]);
  std::size_t asked = 0;
  BOOST_CHECK(trees.is_any_pair(a, b, [&](internal::Place, internal::Place) {
    return ++asked == n;
  }));
}

// ---- allocations and bytes ----------------------------------------------------------------------

// Trees for the insides of all meshes are made once, and their parts a few times, or never if no
// mesh is closed.
BOOST_AUTO_TEST_CASE(insides_and_parts_of_meshes_are_found_a_few_times)
{
  const auto check = [](const std::string& name, const Soups& soups, std::size_t expected,
                        double most) {
    std::size_t pairs = 0, used = 0;
    {
      constexpr std::size_t many = std::size_t(1) << 40;
      const Memory_that_runs_out never(many);
      CGAL::thick_feature_self_intersection_d(soups, [&](std::size_t, std::size_t) { ++pairs; });
      used = many - allocations_left;
    }
    const double each = static_cast<double>(used) / static_cast<double>(soups.size());
    BOOST_TEST_MESSAGE(name << ": allocations of each mesh " << each);
    BOOST_CHECK_EQUAL(pairs, expected);
    BOOST_CHECK_LT(each, most);
  };
  for(const std::size_t n : {50, 100}) {
    check("shells", shells(n, 2), 0, 300);
    check("nested boxes", nested_boxes(n, 2), n * (n - 1) / 2, 300);
    check("layers", layers(n, 8), 0, 10);
  }
}

double face_count(const Soup& soup) { return static_cast<double>(soup.second.size()); }

template <class Feature>
double face_count(const std::vector<Feature>& features)
{
  return std::accumulate(features.begin(), features.end(), 0., [](double sum, const auto& feature) {
    return sum + face_count(feature);
  });
}

BOOST_AUTO_TEST_CASE(memory_is_linear_in_faces_and_pairs)
{
  const auto check = [](const std::string& name, const auto& features, double limit) {
    double pairs = 0;
    const double faces = face_count(features);
    const std::size_t bytes = bytes_taken_by([&] {
      CGAL::thick_feature_self_intersection_d(features,
                                              [&](std::size_t, std::size_t) { ++pairs; });
    });
    const double each = static_cast<double>(bytes) / (faces + pairs);
    BOOST_TEST_MESSAGE(name << ": " << faces << " faces, " << pairs << " pairs, bytes / (n + k) "
                            << each);
    BOOST_CHECK_MESSAGE(each <= limit, name << ": " << each);
  };
  for(const std::size_t n : {20, 40}) {
    check("combs of cut plates", combs(n, 8), 450);
    check("shells in shells", shells(n, 6), 400);
    check("equal meshes", Soups(10 * n, box(Point(0, 0, 0), Point(1, 1, 1), 5)), 170);
    check("a huge mesh and small ones", huge_and_small(2 * n), 450);
    check("harps", harps(50 * n), 350);
    check("open surfaces in a box", surfaces_and_boxes(n), 40);
  }
}

} // namespace
