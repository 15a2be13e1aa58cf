// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Tests of the tests: the oracles agree with each other, the scenes have the number of pairs they
// claim, and the data files are read as those who counted their pairs read them.

#include "box_oracle.h"
#include "brute_force.h"
#include "counting_allocator.h"
#include "data_facts.h"
#include "delaunay_oracle.h"
#include "grid_count.h"
#include "lattice_counts.h"
#include "mpfr_kernel_number.h"
#include "pairs.h"
#include "robustness_families.h"
#include "scenes.h"
#include "unit_test.h"

#include <CGAL/Simple_cartesian.h>

#include <new>
#include <sstream>

using namespace test_support;

namespace {

void check_pairs(const Point_scene& scene, const char* oracle, const Pairs& expected,
                 const Pairs& found)
{
  const Pairs_difference difference = compare(expected, found);
  BOOST_CHECK_MESSAGE(difference.empty(), scene << ", " << oracle << ": " << difference);
}

void check_oracles(const Point_scene& scene)
{
  const Truth& truth = truth_of(scene);
  check_pairs(scene, "boxes", truth.pairs, box_pairs(scene));
  check_pairs(scene, "Delaunay", truth.pairs, delaunay_pairs(scene));
}

void check_count(const std::string& what, std::size_t expected, std::size_t found)
{
  BOOST_CHECK_MESSAGE(expected == found, what << ": expected " << expected << ", found " << found);
}

using Box = std::array<std::array<Decimal_integer, 2>, 3>;
using Triangle = std::array<std::size_t, 3>;

Box box_of(const Triangle& triangle, const Integer_points& vertices)
{
  Box box;
  for(std::size_t axis = 0; axis < 3; ++axis) {
    const auto [low, high] = std::minmax({vertices[triangle[0]][axis], vertices[triangle[1]][axis],
                                          vertices[triangle[2]][axis]});
    box[axis] = {low, high};
  }
  return box;
}

bool boxes_meet(const Box& a, const Box& b)
{
  for(std::size_t axis = 0; axis < 3; ++axis)
    if(a[axis][0] > b[axis][1] || b[axis][0] > a[axis][1])
      return false;
  return true;
}

bool share_a_vertex(const Triangle& t, const Triangle& u)
{
  return std::find_first_of(t.begin(), t.end(), u.begin(), u.end()) != t.end();
}

using Integer_point = std::vector<Decimal_integer>;

int orientation(const Integer_point& p, const Integer_point& q, const Integer_point& r)
{
  const Decimal_integer area =
    (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  return area.sign();
}

// Whether r, on the line of the segment pq, lies on the segment.
bool is_between(const Integer_point& p, const Integer_point& q, const Integer_point& r)
{
  for(std::size_t axis = 0; axis < 2; ++axis)
    if(r[axis] < std::min(p[axis], q[axis]) || r[axis] > std::max(p[axis], q[axis]))
      return false;
  return true;
}

enum class Meeting { none, crossing, touching };

Meeting meeting(const Integer_point& a, const Integer_point& b, const Integer_point& c,
                const Integer_point& d)
{
  const int abc = orientation(a, b, c), abd = orientation(a, b, d);
  const int cda = orientation(c, d, a), cdb = orientation(c, d, b);
  if(abc * abd < 0 && cda * cdb < 0)
    return Meeting::crossing;
  const bool touch = (abc == 0 && is_between(a, b, c)) || (abd == 0 && is_between(a, b, d))
                     || (cda == 0 && is_between(c, d, a)) || (cdb == 0 && is_between(c, d, b));
  return touch ? Meeting::touching : Meeting::none;
}

// A folder was named, so some file of it must have been found: else the check checks nothing.
void check_that_files_were_found(std::size_t checked)
{
  BOOST_CHECK_MESSAGE(data_folders().empty() || checked > 0, "no data file in the named folders");
  BOOST_TEST_MESSAGE(checked << " facts checked");
}

} // namespace

BOOST_AUTO_TEST_CASE(difference_of_pairs_is_one_of_multisets)
{
  const Pairs once = {{0, 1}, {2, 3}};
  const Pairs_difference difference = compare(once, {{4, 5}, {0, 1}, {0, 1}});
  BOOST_CHECK((difference.missing == Pairs{{2, 3}}));
  BOOST_CHECK((difference.extra == Pairs{{0, 1}, {4, 5}}));
  BOOST_CHECK(!difference.empty());
  BOOST_CHECK(compare(once, {{2, 3}, {0, 1}}).empty());
  std::ostringstream out;
  out << compare(Pairs(12, Pair(7, 8)), {});
  BOOST_CHECK(out.str().find("12 missing (7, 8)") == 0);
  BOOST_CHECK(out.str().find("...; 0 extra") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(random_points_are_those_of_the_first_day)
{
  // The 10000th number of the default seed is fixed by the standard.
  Random random(5489);
  for(int i = 0; i < 9999; ++i)
    random.below(1);
  BOOST_CHECK_EQUAL(random.below(static_cast<std::size_t>(-1)), 9981545732273789042u);
  BOOST_CHECK_EQUAL(uniform_points(1, 1, 0, 1, 11)[0][0], Random(11).uniform());
}

BOOST_AUTO_TEST_CASE(scenes_have_distinct_names_and_their_dimension)
{
  for(int d : {1, 2, 3, 5}) {
    std::set<std::string> names;
    for(const Point_scene& scene : small_scenes(d)) {
      BOOST_CHECK_MESSAGE(names.insert(scene.name).second, scene << " occurs twice");
      BOOST_CHECK_MESSAGE(scene.points.size() <= 800, scene << " is large");
      for(const Coordinates& p : scene.points)
        BOOST_REQUIRE_MESSAGE(p.size() == static_cast<std::size_t>(d), scene);
    }
  }
}

BOOST_AUTO_TEST_CASE(random_scenes_have_pairs_but_not_all)
{
  for(int d : {1, 2, 3, 4, 5})
    for(const Point_scene& scene : small_scenes(d))
      if(scene.name == "uniform" || scene.name == "clustered") {
        const std::size_t n = scene.points.size(), k = truth_of(scene).pairs.size();
        BOOST_CHECK_MESSAGE(n / 4 < k && k < 40 * n, scene << ": k = " << k);
      }
}

BOOST_AUTO_TEST_CASE(brute_force_knows_the_boundary)
{
  const Points two = two_points_at_five(3);
  BOOST_CHECK_EQUAL(brute_force(two, Radius::of_length(5)).boundary, 1u);
  BOOST_CHECK_EQUAL(brute_force(two, Radius::of_square("25")).boundary, 1u);
  BOOST_CHECK(brute_force(two, Radius::of_length(5)).open_pairs.empty());
  BOOST_CHECK_EQUAL(brute_force(two, Radius::of_square("51/2")).boundary, 0u);
  BOOST_CHECK_EQUAL(brute_force(two, Radius::of_square("51/2")).open_pairs.size(), 1u);
  BOOST_CHECK(brute_force(two, Radius::of_length(std::nextafter(5., 0.))).pairs.empty());
}

BOOST_AUTO_TEST_CASE(oracles_agree_on_small_scenes)
{
  for(int d : {2, 3})
    for(const Point_scene& scene : small_scenes(d))
      check_oracles(scene);
}

BOOST_AUTO_TEST_CASE(oracles_agree_on_robustness_families)
{
  for(int d : {2, 3})
    for(const Point_scene& scene : robustness_families(d))
      check_oracles(scene);
}

BOOST_AUTO_TEST_CASE(two_sets_are_the_mixed_pairs_of_one_set)
{
  for(int d : {2, 3})
    for(const Point_scene& scene : small_scenes(d)) {
      const std::size_t half = scene.points.size() / 2;
      const auto middle = scene.points.begin() + static_cast<std::ptrdiff_t>(half);
      const Points a(scene.points.begin(), middle), b(middle, scene.points.end());
      Pairs mixed;
      for(const auto& [i, j] : truth_of(scene).pairs)
        if(i < half && j >= half)
          mixed.emplace_back(i, j - half);
      check_pairs(scene, "two sets", mixed, brute_force(a, b, scene.radius).pairs);
      check_pairs(scene, "boxes of two sets", mixed,
                  d == 2 ? box_pairs<2>(a, b, scene.radius) : box_pairs<3>(a, b, scene.radius));
    }
}

BOOST_AUTO_TEST_CASE(families_have_the_counts_of_the_table)
{
  std::size_t checked = 0;
  for(int d : {2, 3})
    for(const Point_scene& scene : robustness_families(d)) {
      if(!scene.expected)
        continue;
      const Truth& truth = truth_of(scene);
      check_count(scene.name + ", pairs", scene.expected->pairs, truth.pairs.size());
      check_count(scene.name + ", boundary", scene.expected->on_boundary, truth.boundary);
      ++checked;
    }
  BOOST_CHECK_EQUAL(checked, 42u);
}

BOOST_AUTO_TEST_CASE(ties_along_the_axes_are_ties)
{
  for(int d : {2, 3})
    for(const Point_scene& scene : robustness_families(d))
      if(scene.name == "random 40-bit, ties along the axes")
        BOOST_CHECK_MESSAGE(truth_of(scene).boundary >= 160, scene << truth_of(scene).boundary);
}

BOOST_AUTO_TEST_CASE(lattice_formula_counts_what_brute_force_counts)
{
  for(int d : {1, 2, 3, 4, 5})
    for(int threshold : {0, 1, 2, 5, 9, 1000}) {
      const std::size_t m = d <= 2 ? 9 : 4;
      const Truth truth =
        brute_force(lattice_points(d, m, 1), Radius::of_square(std::to_string(threshold)));
      const Lattice_count count = lattice_count(m, d, threshold);
      BOOST_CHECK_EQUAL(count.pairs, truth.pairs.size());
      BOOST_CHECK_EQUAL(count.at_threshold, truth.boundary);
    }
}

BOOST_AUTO_TEST_CASE(doubles_of_a_file_are_exact_or_refused)
{
  const auto doubles = as_exact_doubles(scaled_to_integers({{"1.25", "-3"}}));
  BOOST_REQUIRE(doubles.has_value());
  BOOST_CHECK((*doubles == Double_rows{{125, -300}}));
  BOOST_CHECK(!as_exact_doubles(scaled_to_integers({{"9007199254740993"}})));
}

BOOST_AUTO_TEST_CASE(lattice_formula_gives_the_large_figures)
{
  BOOST_CHECK_EQUAL(lattice_count(1000, 2, 25).pairs, 39826168u);
  BOOST_CHECK_EQUAL(lattice_count(100, 3, 9).pairs, 58922124u);
  BOOST_CHECK_EQUAL(lattice_count(28, 2, 25).at_threshold, 3688u);
}

BOOST_AUTO_TEST_CASE(decimals_are_scaled_exactly)
{
  BOOST_CHECK_EQUAL(scaled_decimal("-0.0832331", 8), -8323310);
  BOOST_CHECK_EQUAL(scaled_decimal("+12.5e-3", 5), 1250);
  BOOST_CHECK_EQUAL(scaled_decimal("2.5E3", 0), 2500);
  BOOST_CHECK_EQUAL(scaled_decimal("1.500", 1), 15);
  BOOST_CHECK_EQUAL(scaled_decimal("0", 3), 0);
  BOOST_CHECK_THROW(scaled_decimal("1.55", 1), std::invalid_argument);
  BOOST_CHECK_THROW(parse_decimal("abc"), std::invalid_argument);
  BOOST_CHECK_THROW(parse_decimal(""), std::invalid_argument);
  BOOST_CHECK((split_csv_line("1,\"a \"\"b\"\", c\",,2") ==
               std::vector<std::string>{"1", "a \"b\", c", "", "2"}));
}

BOOST_AUTO_TEST_CASE(data_files_have_the_pairs_of_the_facts)
{
  std::size_t checked = 0;
  for(const Fact& fact : facts()) {
    const auto path = find_data_file(fact.file, data_folders());
    if(!path)
      continue;
    ++checked;
    const Decimal_points points = read_view(*path, fact.view);
    BOOST_TEST_MESSAGE(fact << ", decimals " << points.decimals);
    BOOST_CHECK_EQUAL(points.dimension, fact.dimension);
    BOOST_CHECK_EQUAL(points.coordinates.size(), fact.n);
    const Pair_count count =
      grid_count(points.coordinates, scaled_decimal(fact.radius, points.decimals));
    check_count(fact.file + " closer than " + fact.radius, fact.closer, count.closer);
    check_count(fact.file + " at " + fact.radius, fact.at_radius, count.at_radius);
  }
  check_that_files_were_found(checked);
}

BOOST_AUTO_TEST_CASE(atoms_overlap_as_the_facts_say)
{
  for(const Ball_fact& fact : ball_facts()) {
    const auto path = find_data_file(fact.file, data_folders());
    if(!path)
      continue;
    const Atoms atoms = read_pdb(*path);
    const Decimal_integer reach = 2 * *std::max_element(atoms.radii.begin(), atoms.radii.end());
    const Pair_count count =
      grid_count(atoms.centres.coordinates, reach, [&](std::size_t i, std::size_t j) {
        return Decimal_integer(atoms.radii[i] + atoms.radii[j]);
      });
    check_count(fact.file + " overlapping", fact.overlapping, count.closer);
    check_count(fact.file + " touching", fact.touching, count.at_radius);
  }
}

BOOST_AUTO_TEST_CASE(triangles_have_the_boxes_of_the_facts)
{
  const Mesh_fact fact;
  const auto path = find_data_file(fact.file, data_folders());
  if(!path)
    return;
  const Mesh mesh = read_obj(*path);
  BOOST_CHECK_EQUAL(mesh.triangles.size(), fact.triangles);
  std::vector<Box> boxes;
  for(const Triangle& triangle : mesh.triangles)
    boxes.push_back(box_of(triangle, mesh.vertices.coordinates));
  std::size_t meeting_boxes = 0, sharing = 0;
  for(std::size_t i = 0; i < boxes.size(); ++i)
    for(std::size_t j = i + 1; j < boxes.size(); ++j)
      if(boxes_meet(boxes[i], boxes[j])) {
        ++meeting_boxes;
        sharing += share_a_vertex(mesh.triangles[i], mesh.triangles[j]) ? 1 : 0;
      }
  check_count("meeting boxes", fact.meeting_boxes, meeting_boxes);
  check_count("triangles sharing a vertex", fact.sharing_a_vertex, sharing);
}

BOOST_AUTO_TEST_CASE(runways_meet_as_the_facts_say)
{
  const Runway_fact fact;
  const auto path = find_data_file(fact.file, data_folders());
  if(!path)
    return;
  const Runways runways = read_runways(*path);
  const Integer_points& ends = runways.ends.coordinates;
  const std::size_t n = runways.airports.size();
  BOOST_CHECK_EQUAL(n, fact.segments);
  std::map<std::string, std::vector<std::size_t>> at_airport;
  for(std::size_t i = 0; i < n; ++i)
    at_airport[runways.airports[i]].push_back(i);
  std::size_t crossing = 0, touching = 0;
  for(const auto& [airport, here] : at_airport)
    for(std::size_t a = 0; a < here.size(); ++a)
      for(std::size_t b = a + 1; b < here.size(); ++b) {
        const std::size_t i = here[a], j = here[b];
        const Meeting kind = meeting(ends[i], ends[i + n], ends[j], ends[j + n]);
        crossing += kind == Meeting::crossing ? 1 : 0;
        touching += kind == Meeting::touching ? 1 : 0;
      }
  check_count("crossing runways", fact.crossing, crossing);
  check_count("touching runways", fact.touching, touching);
}

BOOST_AUTO_TEST_CASE(allocations_are_counted)
{
  const std::size_t before = current_bytes();
  reset_peak();
  BOOST_CHECK_EQUAL(peak_bytes(), before);
  void* bytes = ::operator new[](1000); // a new-expression may be optimised away
  BOOST_CHECK_EQUAL(current_bytes(), before + 1000);
  ::operator delete[](bytes);
  const auto alignment = static_cast<std::align_val_t>(256);
  void* wide = ::operator new(500, alignment);
  BOOST_CHECK_EQUAL(reinterpret_cast<std::uintptr_t>(wide) % 256, 0u);
  BOOST_CHECK_EQUAL(current_bytes(), before + 500);
  ::operator delete(wide, alignment);
  BOOST_CHECK_EQUAL(current_bytes(), before);
  ::operator delete(::operator new(700, std::nothrow));
  BOOST_CHECK_EQUAL(current_bytes(), before);
  BOOST_CHECK_EQUAL(peak_bytes(), before + 1000);
  BOOST_CHECK_THROW(::operator delete(::operator new(static_cast<std::size_t>(-1))),
                    std::bad_alloc);
}

BOOST_AUTO_TEST_CASE(mpfr_numbers_make_a_kernel)
{
  using Number = Mpfr_number<30>;
  using Kernel = CGAL::Simple_cartesian<Number>;
  const Kernel::Point_2 p(0, 0), q(3, 4);
  const Kernel::Point_3 u(0.5, 1, 2), v(0.5, 1, 3);
  BOOST_CHECK(Kernel().compare_x_2_object()(p, q) == CGAL::SMALLER);
  BOOST_CHECK(Kernel().compare_xyz_3_object()(u, v) == CGAL::SMALLER);
  BOOST_CHECK(CGAL::squared_distance(p, q) == 25);
  BOOST_CHECK(Kernel().compare_squared_distance_2_object()(p, q, Number(25)) == CGAL::EQUAL);
  BOOST_CHECK(CGAL::compare_squared_distance(u, v, Number(2)) == CGAL::SMALLER);
  BOOST_CHECK(CGAL::orientation(p, q, Kernel::Point_2(3, 5)) == CGAL::LEFT_TURN);
  BOOST_CHECK(CGAL::sqrt(Number(49)) == 7);
  BOOST_CHECK(CGAL::to_double(Number(0.1)) == 0.1);
  BOOST_CHECK(CGAL::is_finite(Number(1)) && !CGAL::is_finite(Number(1) / 0));
  BOOST_CHECK(!CGAL::Algebraic_structure_traits<Number>::Is_exact::value);
}

BOOST_AUTO_TEST_CASE(mpfr_intervals_enclose)
{
  using Number = Mpfr_number<30>;
  const double largest = std::numeric_limits<double>::max();
  BOOST_CHECK(CGAL::to_interval(Number(0.1)) == std::make_pair(0.1, 0.1));
  const Number third = Number(1) / 3;
  const auto [low, high] = CGAL::to_interval(third);
  BOOST_CHECK(low < third && third < high);
  BOOST_CHECK_EQUAL(std::nextafter(low, infinity), high);
  BOOST_CHECK(CGAL::to_interval(Number(-third)) == std::make_pair(-high, -low));
  BOOST_CHECK(CGAL::to_interval(Number(2) * largest) == std::make_pair(largest, infinity));
}
