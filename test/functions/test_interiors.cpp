// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Which objects without their boundaries intersect each other and closed ones, for all kinds that
// have an interior, on the usual kernels. The oracle makes objects smaller by so little that a
// closed object is in the interior that it stands for, and meets what the interior meets.

#include "support/check_kinds.h"
#include "support/usual_kernels.h"

using namespace test_support;

namespace {

using boost::multiprecision::mpz_int;
using Hull = Hull_vectors<mpz_int>;

// ---- the truth ----------------------------------------------------------------------------------

struct Set_object
{
  Kind_object object;
  bool is_open;
};

bool has_interior(const Hull& hull, int dimension)
{
  for(const auto& b : hull)
    for(const auto& c : hull)
      for(const auto& d : hull) {
        const auto u = difference(b, hull[0]), v = difference(c, hull[0]);
        const auto normal = cross(u, v);
        if(dimension == 2 ? normal[2] != 0 : dot(normal, difference(d, hull[0])) != 0)
          return true;
      }
  return false;
}

// Objects become smaller by a `part`-th of them: less than any quotient of the determinants that
// decide whether they meet.
mpz_int part_of(const Hull& a, const Hull& b, std::int64_t radius)
{
  mpz_int largest = radius + 1;
  for(const Hull* hull : {&a, &b})
    for(const auto& vertex : *hull)
      for(std::size_t axis = 0; axis < 3; ++axis)
        largest = (std::max)(largest, mpz_int(abs(mpz_int(vertex[axis] - a[0][axis]))));
  return mpz_int(1) << 12 * (boost::multiprecision::msb(largest) + 4);
}

// The hull in a unit that is `count * part` times as small, towards its mean if it is open.
Hull scaled(const Hull& hull, const mpz_int& count, const mpz_int& part, bool is_smaller)
{
  const mpz_int own = hull.size();
  Hull result;
  for(const auto& vertex : hull) {
    result.emplace_back();
    for(std::size_t axis = 0; axis < 3; ++axis) {
      mpz_int sum = 0;
      for(const auto& other : hull)
        sum += other[axis];
      const mpz_int whole = own * vertex[axis];
      result.back()[axis]
        = count * mpz_int(is_smaller ? mpz_int(part * sum + (part - 1) * (whole - sum))
                                     : mpz_int(part * whole));
    }
  }
  return result;
}

// Whether two objects meet if both are closed.
bool do_touch(const Set_object& a, const Set_object& b)
{
  const mpz_int radii = mpz_int(a.object.radius) + b.object.radius;
  return squared_distance(a.object, b.object) <= Rational(mpz_int(radii * radii));
}

bool do_meet(const Set_object& a, const Set_object& b, int dimension)
{
  const Hull hull_a = hull_of<mpz_int>(a.object), hull_b = hull_of<mpz_int>(b.object);
  const auto is_empty = [&](const Set_object& x, const Hull& hull) {
    return x.is_open && x.object.radius == 0 && !has_interior(hull, dimension);
  };
  if(!do_touch(a, b) || is_empty(a, hull_a) || is_empty(b, hull_b))
    return false;
  const mpz_int part = part_of(hull_a, hull_b, a.object.radius + b.object.radius);
  const auto is_smaller = [](const Set_object& x) { return x.is_open && x.object.radius == 0; };
  const mpz_int size_a = hull_a.size(), size_b = hull_b.size();
  const Rational square = squared_distance_of_hulls(scaled(hull_a, size_b, part, is_smaller(a)),
                                                    scaled(hull_b, size_a, part, is_smaller(b)));
  const auto radius = [&](const Set_object& x) {
    return mpz_int(x.object.radius * (x.is_open ? mpz_int(part - 1) : part) * size_a * size_b);
  };
  const mpz_int radii = radius(a) + radius(b);
  return square <= Rational(mpz_int(radii * radii));
}

// ---- the searches -------------------------------------------------------------------------------

// Kinds that have an interior, or a radius.
template <class K, int Dimension>
struct Open_kinds : Kernel_kinds<K, Dimension>
{
private:
  using Plain = Kernel_kinds<K, Dimension>;
  template <class Kind>
  using Thick = std::pair<Kind, typename K::FT>;
  using Simplex = std::conditional_t<Dimension == 2, typename K::Triangle_2,
                                     typename K::Tetrahedron_3>;
  using Segment = typename Plain::Types::Segment;
  using Iso_box = typename Plain::Types::Iso_box;
  using Bbox = std::conditional_t<Dimension == 2, CGAL::Bbox_2, CGAL::Bbox_3>;

public:
  using Object = std::variant<Simplex, Iso_box, Bbox, typename Plain::Ball, Thick<Simplex>,
                              Thick<Segment>, Thick<Iso_box>>;

  static bool has(Kind kind)
  {
    return kind != Kind::POINT && (Dimension == 2 || kind != Kind::TRIANGLE);
  }

  Object make(const Kind_object& object) const
  {
    const auto open = [&](const auto& x) -> Object {
      using Type = std::decay_t<decltype(x)>;
      const auto radius = this->number(object.radius);
      if constexpr(std::is_constructible_v<Object, const Type&>) {
        if constexpr(std::is_constructible_v<Object, const Thick<Type>&>)
          if(object.radius != 0)
            return Thick<Type>(x, radius);
        return x;
      }
      else if constexpr(std::is_constructible_v<Object, const Thick<Type>&>)
        return Thick<Type>(x, radius);
      else
        throw std::logic_error("The object has no interior.");
    };
    return std::visit(open, Plain::make(object));
  }
};

struct Counts
{
  std::size_t overlapping = 0;
  std::size_t touching = 0;
};

template <class K, int Dimension>
class Interiors_case
{
  using Open = Open_kinds<K, Dimension>;
  using Closed = Kernel_kinds<K, Dimension>;

public:
  explicit Interiors_case(std::uint64_t seed) : seed_(seed)
  {
    Kind_drawer drawer(seed, Dimension, true);
    const Kind_scene scene = drawer.scene();
    const bool is_third = Closed::is_exact && drawer.is_chance(3);
    const Open open{{{scene.exponent, is_third}}};
    const Closed closed{{scene.exponent, is_third}};
    for(Kind_object object : scene.objects) {
      if(Open::has(object.kind)) {
        if(object.kind == Kind::BBOX)
          object.radius = 0;
        open_.push_back({object, true});
        open_objects_.push_back(open.make(object));
      }
      if(object.kind != Kind::BALL)
        object.radius = 0;
      closed_.push_back({object, false});
      closed_objects_.push_back(closed.make(object));
    }
  }

  // Adds how many objects overlap, and how many only touch.
  void check(Counts& counts) const
  {
    const Pairs among = pairs_where(open_.size(), [&](std::size_t i, std::size_t j) {
      return do_meet(open_[i], open_[j], Dimension);
    });
    std::vector<Set_object> same = open_;
    for(Set_object& object : same)
      object.is_open = false;
    const Pairs with_same = pairs_with(same, counts), with_closed = pairs_with(closed_, counts);
    const auto check_with_tag = [&](auto tag) {
      using Tag = decltype(tag);
      Pairs found;
      Locked_collector collect(found);
      CGAL::thick_self_intersection_d<Tag>(CGAL::interiors(open_objects_), collect);
      compare_pairs("interiors", among, found);
      check_with_closed<Tag>(open_objects_, with_same);
      check_with_closed<Tag>(closed_objects_, with_closed);
    };
    check_with_tag(CGAL::Sequential_tag());
    if constexpr(!std::is_same_v<CGAL::Parallel_if_available_tag, CGAL::Sequential_tag>)
      check_with_tag(CGAL::Parallel_if_available_tag());
  }

private:
  // The pairs of an open object and one of others that meet.
  Pairs pairs_with(const std::vector<Set_object>& others, Counts& counts) const
  {
    Pairs pairs;
    for(std::size_t i = 0; i < open_.size(); ++i)
      for(std::size_t j = 0; j < others.size(); ++j)
        if(do_meet(open_[i], others[j], Dimension))
          pairs.emplace_back(i, j);
        else if(do_touch(open_[i], others[j]))
          ++counts.touching;
    counts.overlapping += pairs.size();
    return pairs;
  }

  template <class ConcurrencyTag, class Objects>
  void check_with_closed(const Objects& objects, const Pairs& expected) const
  {
    Pairs found, swapped;
    Locked_collector collect(found), collect_swapped(swapped);
    CGAL::thick_intersection_d<ConcurrencyTag>(CGAL::interiors(open_objects_), objects, collect);
    CGAL::thick_intersection_d<ConcurrencyTag>(objects, CGAL::interiors(open_objects_),
                                               [&](std::size_t i, std::size_t j) {
                                                 collect_swapped(j, i);
                                               });
    compare_pairs("interiors and others", expected, found);
    compare_pairs("others and interiors", expected, swapped);
  }

  void compare_pairs(const char* what, const Pairs& expected, const Pairs& found) const
  {
    const Pairs_difference difference = compare(expected, found);
    BOOST_REQUIRE_MESSAGE(difference.empty(), what << ", seed " << seed_ << ": " << difference);
  }

  const std::uint64_t seed_;
  std::vector<Set_object> open_, closed_;
  std::vector<typename Open::Object> open_objects_;
  std::vector<typename Closed::Object> closed_objects_;
};

template <class K, int Dimension>
void check_interiors()
{
  constexpr std::uint64_t count = 300;
  Counts counts;
  const std::uint64_t checked = check_seeds(count, [&](std::uint64_t seed) {
    Interiors_case<K, Dimension>(seed).check(counts);
  });
  if(checked < count) // in the seconds that scripts/fuzz_searches gives
    return;
  BOOST_CHECK_GT(counts.overlapping, 2000u);
  BOOST_CHECK_GT(counts.touching, 2000u);
}

bool has_interior(const CGAL::Bbox_2& box)
{
  return box.xmin() < box.xmax() && box.ymin() < box.ymax();
}

void check_boxes(const std::vector<CGAL::Bbox_2>& boxes)
{
  const auto do_overlap = [&](std::size_t i, std::size_t j) {
    const CGAL::Bbox_2 &a = boxes[i], &b = boxes[j];
    return a.xmin() < b.xmax() && b.xmin() < a.xmax() && a.ymin() < b.ymax() && b.ymin() < a.ymax();
  };
  Pairs open, mixed, expected_mixed;
  CGAL::thick_self_intersection_d(CGAL::interiors(boxes), std::back_inserter(open));
  CGAL::thick_intersection_d(CGAL::interiors(boxes), boxes, std::back_inserter(mixed));
  for(std::size_t i = 0; i < boxes.size(); ++i)
    for(std::size_t j = 0; j < boxes.size(); ++j)
      if(has_interior(boxes[i]) && do_overlap(i, j))
        expected_mixed.emplace_back(i, j);
  const Pairs expected = pairs_where(boxes.size(), [&](std::size_t i, std::size_t j) {
    return has_interior(boxes[i]) && has_interior(boxes[j]) && do_overlap(i, j);
  });
  BOOST_CHECK_GT(expected_mixed.size(), expected.size());
  BOOST_CHECK(sorted(open) == expected);
  BOOST_CHECK(sorted(mixed) == expected_mixed);
}

} // namespace

// Boxes decide about boxes, but a profile counts them all.
BOOST_AUTO_TEST_CASE(a_profile_counts_each_pair_whose_boxes_meet)
{
  const std::vector<CGAL::Bbox_2> boxes = {{0, 0, 2, 2}, {1, 1, 3, 3}, {2, 0, 4, 2}, {9, 9, 9, 9}};
  Pairs pairs;
  CGAL::Scene_profile profile;
  CGAL::thick_self_intersection_d(CGAL::interiors(boxes), std::back_inserter(pairs), profile);
  BOOST_CHECK(sorted(pairs) == Pairs({{0, 1}, {1, 2}}));
  BOOST_CHECK_EQUAL(profile.decided(CGAL::Arithmetic_tier::DOUBLE), 3u);
}

// In ranges of nothing but boxes, boxes decide, unless one is flat. There are zeros of both signs.
BOOST_AUTO_TEST_CASE(boxes_decide_about_boxes)
{
  Random random(1);
  const auto end = [&] {
    const double x = static_cast<double>(random.below(6)) - 3;
    return x == 0 && random.below(2) == 0 ? -0. : x;
  };
  const auto side = [&] {
    const double x = end(), y = end();
    return std::minmax({x, y});
  };
  std::vector<CGAL::Bbox_2> boxes, solid;
  for(int i = 0; i < 400; ++i) {
    const auto x = side(), y = side();
    boxes.emplace_back(x.first, y.first, x.second, y.second);
    if(has_interior(boxes.back()))
      solid.push_back(boxes.back());
  }
  check_boxes(boxes);
  check_boxes(solid);
  check_boxes({solid.begin(), solid.begin() + 100});
}

BOOST_AUTO_TEST_CASE(a_flat_tetrahedron_in_another_one_has_no_interior)
{
  using Point = Epick::Point_3;
  using Tetrahedron = Epick::Tetrahedron_3;
  const Tetrahedron solid(Point(0, 0, 0), Point(9, 0, 0), Point(0, 9, 0), Point(0, 0, 9));
  const Tetrahedron flat(Point(1, 1, 1), Point(2, 1, 1), Point(1, 2, 1), Point(2, 2, 1));
  for(const std::vector<Tetrahedron>& objects : {std::vector{solid, flat}, {flat, solid}}) {
    Pairs open, mixed;
    CGAL::thick_self_intersection_d(CGAL::interiors(objects), std::back_inserter(open));
    CGAL::thick_intersection_d(CGAL::interiors(objects), objects, std::back_inserter(mixed));
    BOOST_CHECK(open.empty());
    BOOST_CHECK_EQUAL(mixed.size(), 2u); // of the solid one, with itself and the flat one
  }
}

BOOST_AUTO_TEST_CASE(epick_2) { check_interiors<Epick, 2>(); }
BOOST_AUTO_TEST_CASE(epick_3) { check_interiors<Epick, 3>(); }
BOOST_AUTO_TEST_CASE(epeck_3) { check_interiors<Epeck, 3>(); }
BOOST_AUTO_TEST_CASE(doubles_2) { check_interiors<Double_kernel, 2>(); }
BOOST_AUTO_TEST_CASE(rationals_2) { check_interiors<Rational_kernel, 2>(); }
