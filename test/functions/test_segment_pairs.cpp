// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Long segments, which are searched in stretches: each pair once, whichever set they are in and
// wherever they touch, with little work.

#include "support/check_pairs.h"
#include "support/kernel_types.h"
#include "support/parallel_pairs.h"
#include "support/rounding_mode.h"
#include "support/seeds.h"
#include "support/usual_kernels.h"

#include <CGAL/Cartesian_converter.h>
#include <CGAL/Thick_intersection_d/internal/objects/segment_pairs_search.h>
#include <CGAL/fixed_radius_near_neighbors.h>
#include <CGAL/thick_intersection_d.h>

using namespace test_support;
using CGAL::Arithmetic_tier;
using CGAL::Scene_profile;
using namespace CGAL::Thick_intersection_d::internal;

namespace plans {

struct Road : Epeck::Segment_2
{
  using Epeck::Segment_2::Segment_2;
};

bool do_intersect(const Road&, const Road&);

} // namespace plans

namespace {

// One type of callback, because compilers make a search for each.
using Callback = std::function<void(std::size_t, std::size_t)>;

// Makes long segments, and small triangles of which many have a vertex at the end of a stretch of a
// segment. Coordinates are integers times `unit`.
template <class Kernel, int Dimension>
class Maker
{
  using Steps = std::array<std::int64_t, Dimension>;
  using Types = Kernel_types<Kernel, Dimension>;

public:
  using Point = typename Types::Point;
  using Segment = typename Types::Segment;
  using Triangle = typename Types::Triangle;

  Maker(std::uint64_t seed, const typename Kernel::FT& unit) : random_(seed), unit_(unit) {}

  // A sixty-fourth of each is a vector of integers.
  std::vector<Segment> segments(std::size_t count)
  {
    std::vector<Segment> segments;
    for(std::size_t i = 0; i < count; ++i) {
      sources_.push_back(random_steps(1024));
      directions_.push_back(random_steps(33));
      for(std::int64_t& step : directions_.back())
        step -= 16;
      segments.emplace_back(point_on(i, 0), point_on(i, 64));
    }
    return segments;
  }

  std::vector<Triangle> triangles(std::size_t count)
  {
    std::vector<Triangle> triangles;
    while(triangles.size() < count) {
      const std::size_t segment = random_.below(sources_.size());
      const Steps p = steps_on(segment, static_cast<std::int64_t>(random_.below(65)));
      const Steps q = triangles.size() % 2 == 0 ? p : moved(p);
      const Triangle triangle(point(q), point(moved(q)), point(moved(q)));
      if(!triangle.is_degenerate()) // which CGAL's test does not take
        triangles.push_back(triangle);
    }
    return triangles;
  }

private:
  Steps random_steps(std::uint64_t size)
  {
    Steps steps;
    for(std::int64_t& step : steps)
      step = static_cast<std::int64_t>(random_.below(size));
    return steps;
  }

  Steps moved(Steps steps)
  {
    for(std::int64_t& step : steps)
      step += static_cast<std::int64_t>(random_.below(9)) - 4;
    return steps;
  }

  Steps steps_on(std::size_t segment, std::int64_t part) const
  {
    Steps steps = sources_[segment];
    for(std::size_t axis = 0; axis < steps.size(); ++axis)
      steps[axis] += part * directions_[segment][axis];
    return steps;
  }

  Point point_on(std::size_t segment, std::int64_t part) const
  {
    return point(steps_on(segment, part));
  }

  Point point(const Steps& steps) const
  {
    return Types::point([&](std::size_t axis) {
      return typename Kernel::FT(typename Kernel::FT(static_cast<double>(steps[axis])) * unit_);
    });
  }

  Random random_;
  typename Kernel::FT unit_;
  std::vector<Steps> sources_;
  std::vector<Steps> directions_;
};

template <class A, class B>
Pairs pairs_of_cgal(const std::vector<A>& a, const std::vector<B>& b)
{
  Pairs pairs;
  for(std::size_t i = 0; i < a.size(); ++i)
    for(std::size_t j = 0; j < b.size(); ++j)
      if(CGAL::do_intersect(a[i], b[j]))
        pairs.emplace_back(i, j);
  return pairs;
}

template <class ConcurrencyTag = CGAL::Sequential_tag, class A, class B>
Pairs found_pairs(const std::vector<A>& a, const std::vector<B>& b)
{
  return collected([&](const Callback& callback) {
    CGAL::thick_intersection_d<ConcurrencyTag>(a, b, callback);
  });
}

std::uint64_t decided_by_all(const Scene_profile& profile)
{
  std::uint64_t sum = 0;
  for(int tier = 0; tier <= static_cast<int>(Arithmetic_tier::FILTERED_EXACT); ++tier)
    sum += profile.decided(static_cast<Arithmetic_tier>(tier));
  return sum;
}

// Returns how many pairs of boxes are asked about.
template <class A, class B>
std::uint64_t asked_pairs(const std::vector<A>& a, const std::vector<B>& b)
{
  Scene_profile profile;
  const Callback ignore = [](std::size_t, std::size_t) {};
  CGAL::thick_intersection_d(a, b, ignore, profile);
  return decided_by_all(profile);
}

Pairs swapped(Pairs pairs)
{
  for(Pair& pair : pairs)
    std::swap(pair.first, pair.second);
  return pairs;
}

// Either set may be the first one. Without stretches, more than `least_saved` times as many pairs
// would be asked about.
template <class Kernel, int Dimension>
void check_scene(std::uint64_t seed, const typename Kernel::FT& unit, double least_saved)
{
  Maker<Kernel, Dimension> maker(seed, unit);
  const auto segments = maker.segments(60);
  const auto triangles = maker.triangles(2000);
  const Pairs expected = pairs_of_cgal(segments, triangles);
  BOOST_CHECK_GT(expected.size(), 1000u);
  check_pairs("segments first", expected, found_pairs(segments, triangles));
  check_pairs("triangles first", swapped(expected), found_pairs(triangles, segments));

  std::uint64_t meeting_boxes = 0;
  for(const auto& segment : segments)
    for(const auto& triangle : triangles)
      meeting_boxes += CGAL::do_overlap(segment.bbox(), triangle.bbox());
  const std::uint64_t asked = asked_pairs(segments, triangles);
  BOOST_CHECK_EQUAL(asked, asked_pairs(triangles, segments));
  BOOST_CHECK_LT(static_cast<double>(asked) * least_saved, static_cast<double>(meeting_boxes));
}

// Stretches hold their points, and from each to the next no end turns back.
void check_stretches(const Interval& source, const Interval& target, Place count)
{
  using Exact = CGAL::Exact_rational;
  const auto goes_on = [](double from, double to, double before, double now) {
    return from < to ? before <= now : now <= before;
  };
  Interval before = {};
  for(Place k = 0; k < count; ++k) {
    const Interval stretch = interval_of_stretch(source, target, k, count);
    for(const Place end : {k, k + 1})
      for(const auto& [p, q] :
          {std::pair(source.low, target.low), std::pair(source.high, target.high)}) {
        const Exact x = Exact(p) + (Exact(q) - Exact(p)) * Exact(end) / Exact(count);
        BOOST_CHECK(Exact(stretch.low) <= x && x <= Exact(stretch.high));
      }
    BOOST_CHECK(k == 0 || goes_on(source.low, target.low, before.low, stretch.low));
    BOOST_CHECK(k == 0 || goes_on(source.high, target.high, before.high, stretch.high));
    before = stretch;
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(long_segments_in_the_plane_meet_small_triangles)
{
  check_scene<Epick, 2>(1, 1, 2);
  check_scene<Epick, 2>(2, 0x1p300, 2);
}
BOOST_AUTO_TEST_CASE(long_segments_in_space_meet_small_triangles)
{
  check_scene<Epick, 3>(3, 1, 1.5);
  check_scene<Epick, 3>(4, 0x1p-1070, 0); // no length has a reciprocal, so none is cut
}
BOOST_AUTO_TEST_CASE(coordinates_may_be_no_doubles)
{
  check_scene<Epeck, 2>(5, Epeck::FT(1) / 3, 2);
  check_scene<Epeck, 3>(6, Epeck::FT(1) / 3, 1.5);
}

// Boxes of lazy numbers shrink when they are evaluated. In the middle of a search, that would move
// the box in which a pair of a stretch is reported.
BOOST_AUTO_TEST_CASE(boxes_of_lazy_objects_do_not_shrink_in_a_search)
{
  check_seeds(1, [](std::uint64_t seed) {
    Random random(seed);
    const auto number = [](double x) {
      const Epeck::FT large = Epeck::FT(1e14) / Epeck::FT(3);
      return Epeck::FT(x) + large - large; // in an interval that is a hundredth long
    };
    const auto point = [&](double x, double y, double size) {
      const double dx = size * random.uniform();
      return Epeck::Point_2(number(x + dx), number(y + size * random.uniform()));
    };
    std::vector<Epeck::Segment_2> segments;
    for(int i = 0; i < 300; ++i) {
      const Epeck::Point_2 source = point(0, 0, 100);
      segments.emplace_back(source, point(0, 0, 100));
    }
    std::vector<Epeck::Triangle_2> triangles;
    for(int i = 0; i < 5000; ++i) {
      const double x = 100 * random.uniform(), y = 100 * random.uniform();
      const Epeck::Point_2 p = point(x, y, .3), q = point(x, y, .3);
      triangles.emplace_back(p, q, point(x, y, .3));
    }
    Pairs truth;
    for(std::size_t i = 0; i < segments.size(); ++i)
      for(std::size_t j = 0; j < triangles.size(); ++j)
        if(CGAL::do_overlap(segments[i].bbox(), triangles[j].bbox())
           && CGAL::do_intersect(segments[i], triangles[j]))
          truth.emplace_back(i, j);
    BOOST_REQUIRE_MESSAGE(sorted(found_pairs(segments, triangles)) == truth, "seed " << seed);
  });
}

// With a radius, a road is the segment that its base is, although it has a test of its own.
BOOST_AUTO_TEST_CASE(boxes_of_derived_objects_with_radii_do_not_shrink_in_a_search)
{
  Random random(3);
  const auto point = [](double x, double y) {
    const auto number = [](double z) {
      const Epeck::FT large = Epeck::FT(1e14) / Epeck::FT(3);
      return Epeck::FT(z) + large - large; // in an interval that is a hundredth long
    };
    return Epeck::Point_2(number(x), number(y));
  };
  const auto near_to = [&](double x, double size) { return x + size * random.uniform(); };
  std::vector<std::pair<plans::Road, Epeck::FT>> roads;
  std::vector<std::pair<Epeck::Segment_2, Epeck::FT>> segments;
  for(int i = 0; i < 300; ++i) {
    const double x = near_to(0, 100), y = near_to(0, 100);
    const double z = near_to(0, 100), w = near_to(0, 100);
    roads.emplace_back(plans::Road(point(x, y), point(z, w)), 0);
    segments.emplace_back(Epeck::Segment_2(point(x, y), point(z, w)), 0);
  }
  std::vector<Epeck::Triangle_2> triangles, others;
  for(int i = 0; i < 5000; ++i) {
    std::array<double, 6> x;
    x[0] = near_to(0, 100), x[1] = near_to(0, 100);
    for(std::size_t k = 2; k < 6; ++k)
      x[k] = near_to(x[k - 2], .3);
    for(std::vector<Epeck::Triangle_2>* list : {&triangles, &others})
      list->emplace_back(point(x[0], x[1]), point(x[2], x[3]), point(x[4], x[5]));
  }
  check_pairs("roads", sorted(found_pairs(segments, others)),
              sorted(found_pairs(roads, triangles)));
}

// 1,000 segments and the boxes of 20,000 triangles meet 400,000 times.
BOOST_AUTO_TEST_CASE(few_pairs_are_asked_about)
{
  Random random(7);
  const auto point = [&](const Epick::Point_3& from, double size) {
    const double x = random.uniform(), y = random.uniform();
    return from + size * Epick::Vector_3(x, y, random.uniform());
  };
  std::vector<Epick::Segment_3> segments;
  for(int i = 0; i < 1000; ++i) {
    const Epick::Point_3 source = point(CGAL::ORIGIN, 1);
    segments.emplace_back(source, point(CGAL::ORIGIN, 1));
  }
  std::vector<Epick::Triangle_3> triangles;
  for(int i = 0; i < 20000; ++i) {
    const Epick::Point_3 corner = point(CGAL::ORIGIN, 1), second = point(corner, .01);
    triangles.emplace_back(corner, second, point(corner, .01));
  }
  const Pairs pairs = found_pairs(segments, triangles);
  BOOST_CHECK_GT(pairs.size(), 100u);
  BOOST_CHECK_LT(asked_pairs(segments, triangles), 20 * segments.size());
  BOOST_CHECK(compare(pairs, found_pairs<CGAL::Parallel_tag>(segments, triangles)).empty());
  BOOST_CHECK(pairs == found_pairs(segments, triangles)); // in the same order
}

// Twice as many segments as small squares, all of which go from one side of the plane to the other.
struct Long_segments
{
  static constexpr int dimension = 2;
  static constexpr std::size_t segment_count = 20000;

  std::size_t size() const { return segment_count + segment_count / 2; }
  double reach() const { return 0; }
  bool is_segment(std::size_t) const { return true; }
  std::array<Interval, 2> box(const Stretch&) const { return {Interval{0, 1}, Interval{0, 1}}; }
  auto intervals(std::size_t position) const
  {
    const double low = position % 2 == 0 ? 0 : .999;
    return [low](int) { return Interval{low, low + .001}; };
  }
};

BOOST_AUTO_TEST_CASE(stretches_take_linear_memory)
{
  const Long_segments scene;
  const auto stretches = count_stretches(
    scene, 0, scene.segment_count, scene.segment_count, scene.size(), Threads());
  BOOST_CHECK_LT(stretches.added, 8 * scene.size());
  BOOST_CHECK_GT(stretches.added, 3 * scene.size());
}

// Claims to be one object more than a search by boxes takes. Nobody reads any.
struct Too_many_segments
  : Traits_boxes<std::vector<Epick::Segment_2>, CGAL::Thick_object_traits_d<Epick::Segment_2>>
{
  using Traits_boxes::Traits_boxes;
  std::size_t size() const { return (std::size_t(1) << 31) - 1; }
};

BOOST_AUTO_TEST_CASE(too_many_objects_are_refused_at_once)
{
  const std::vector<Epick::Segment_2> none;
  const CGAL::Thick_object_traits_d<Epick::Segment_2> traits;
  const Too_many_segments objects(none, traits);
  const Two_sets sets{1};
  const Callback ignore = [](std::size_t, std::size_t) {};
  auto progress = make_progress(CGAL::parameters::default_values(), 1);
  BOOST_CHECK_THROW(report_segment_pairs(objects, none, sets, ignore, progress, Threads()),
                    std::length_error);
  BOOST_CHECK_THROW(report_meeting_boxes(objects, sets, ignore, progress, Threads()),
                    std::length_error);
}

// Ties are near, and so is each end of a stretch.
BOOST_AUTO_TEST_CASE(points_are_within_a_distance_of_long_segments)
{
  const CGAL::Cartesian_converter<Epick, Rational_kernel> exact;
  Maker<Epick, 3> maker(12, 1);
  const auto segments = maker.segments(40);
  std::vector<Epick::Point_3> points;
  for(const auto& triangle : maker.triangles(1500))
    points.push_back(triangle[1]);
  Pairs expected;
  std::uint64_t meeting_boxes = 0;
  for(std::size_t i = 0; i < segments.size(); ++i) {
    const Rational_kernel::Segment_3 segment = exact(segments[i]);
    const CGAL::Bbox_3 box = segments[i].bbox();
    const CGAL::Bbox_3 grown(box.xmin() - 3, box.ymin() - 3, box.zmin() - 3, box.xmax() + 3,
                             box.ymax() + 3, box.zmax() + 3);
    for(std::size_t j = 0; j < points.size(); ++j)
      if(CGAL::do_overlap(grown, points[j].bbox())) {
        ++meeting_boxes;
        if(CGAL::squared_distance(segment, exact(points[j])) <= 9)
          expected.emplace_back(i, j);
      }
  }
  Pairs found;
  Scene_profile profile;
  CGAL::fixed_radius_near_neighbors(segments, points, CGAL::within_distance(3),
                                    Pair_collector{found}, profile);
  check_pairs("points", expected, found);
  BOOST_CHECK_GT(found.size(), 400u);
  BOOST_CHECK_LT(3 * decided_by_all(profile), 2 * meeting_boxes);

  std::vector<std::pair<Epick::Segment_3, double>> capsules;
  for(const Epick::Segment_3& segment : segments)
    capsules.emplace_back(segment, 3);
  Pairs inside;
  Scene_profile profile_of_capsules;
  CGAL::thick_intersection_d(capsules, points, Pair_collector{inside}, profile_of_capsules);
  check_pairs("points in capsules", expected, inside);
  BOOST_CHECK_LT(3 * decided_by_all(profile_of_capsules), 2 * meeting_boxes);
}

BOOST_AUTO_TEST_CASE(objects_of_several_kinds_may_be_segments)
{
  Maker<Epick, 3> maker(8, 1);
  const auto segments = maker.segments(60);
  const auto triangles = maker.triangles(2000);
  const std::vector<Epick::Triangle_3> some(triangles.begin(), triangles.begin() + 100);
  using Object = std::variant<Epick::Triangle_3, Epick::Segment_3>;
  std::vector<Object> objects(some.begin(), some.end());
  objects.insert(objects.end(), segments.begin(), segments.end());
  Pairs expected = pairs_of_cgal(some, triangles);
  for(const Pair& pair : pairs_of_cgal(segments, triangles))
    expected.emplace_back(100 + pair.first, pair.second);
  check_pairs("objects", expected, found_pairs(objects, triangles));
}

BOOST_AUTO_TEST_CASE(progress_is_that_of_stretches)
{
  Maker<Epick, 2> maker(10, 1);
  const auto segments = maker.segments(200);
  const auto triangles = maker.triangles(10000);
  std::vector<double> values;
  std::size_t found = 0, found_before_end = 0;
  const std::function<bool(double)> tell = [&](double value) {
    values.push_back(value);
    found_before_end = value < 1 ? found_before_end : found;
    return true;
  };
  const Callback count = [&](std::size_t, std::size_t) { ++found; };
  CGAL::thick_intersection_d(segments, triangles, count, CGAL::parameters::callback(tell));
  BOOST_CHECK(std::is_sorted(values.begin(), values.end()));
  BOOST_CHECK_EQUAL(std::count(values.begin(), values.end(), 1.), 1);
  BOOST_CHECK_EQUAL(found_before_end, found);
}

BOOST_AUTO_TEST_CASE(stretches_hold_their_points)
{
  constexpr double largest = (std::numeric_limits<double>::max)();
  Random random(11);
  for(const Place count : {2u, 8u, 64u}) {
    for(int i = 0; i < 200; ++i) {
      const double source = std::ldexp(random.uniform() - .5, static_cast<int>(random.below(60)));
      const double target = std::ldexp(random.uniform() - .5, static_cast<int>(random.below(60)));
      check_stretches({source, source}, {target, target}, count);
      check_stretches({source, source + .125}, {target, target + 3}, count);
    }
    check_stretches({0, 0}, {0x1p-1070, 0x1p-1070}, count);
    check_stretches({1, 1}, {1, 1}, count);
    check_stretches({0, 0}, {largest, largest}, count);
    check_stretches({largest, largest}, {-largest, -largest}, count); // its length is infinite
  }
}

// In some rounding modes, a length that overflows is the largest double.
BOOST_AUTO_TEST_CASE(stretches_beyond_the_doubles_hold_their_points_in_every_rounding_mode)
{
  constexpr double largest = (std::numeric_limits<double>::max)();
  for(const int mode : rounding_modes) {
    const Rounding_mode rounding(mode);
    check_stretches({largest, largest}, {-largest, -largest}, 8);
    check_stretches({-largest, -0x1p1023}, {-0x1p970, largest}, 8);
  }
}
