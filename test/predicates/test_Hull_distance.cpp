// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Distances of hulls of doubles against the oracle: no answer is wrong, few are missing, and the
// vertices that are left for exact numbers are enough and few.

#include "support/distance_oracle.h"
#include "support/lattice_hulls.h"
#include "support/rounding_mode.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/predicates/Hull_distance.h>

BOOST_AUTO_TEST_SUITE(Hull_distance)

using namespace test_support;

// The squared distance of a and b. Numbers are small, or of any length.
Rational true_square(const Integers& a, const Integers& b, bool are_small)
{
  return are_small ? squared_distance_of_hulls(a, b) : squared_distance_of_long_hulls(a, b);
}

double true_square(const Integers& a)
{
  return static_cast<double>(true_square(Integers(1, Hull_vector<std::int64_t>{}), a, true));
}

// ---- simplices ----------------------------------------------------------------------------------

template <class Vector>
double square_of(const Vector& p)
{
  return internal::dot_product(p, p);
}

bool is_nearly(double x, double y) { return std::fabs(x - y) <= 1e-11 * (1 + std::fabs(y)); }

// The nearest point is right, and that of the vertices that are kept.
template <int Dimension>
void check_simplices(std::size_t count)
{
  Random random(count);
  std::size_t proper = 0, wrong = 0;
  for(const std::int64_t side : {2, 5, 12})
    for(int i = 0; i < 2000; ++i) {
      Integers vertices;
      internal::Hull_simplex<Dimension> simplex;
      for(std::size_t k = 0; k < count; ++k) {
        vertices.push_back(lattice_point(random, lattice_around_origin(Dimension, side)));
        simplex.add(as_doubles<Dimension>(vertices.back()));
      }
      if(is_flat(vertices))
        continue;
      ++proper;
      const double square = true_square(vertices);
      const auto first = simplex.nearest();
      const std::size_t kept = simplex.size();
      const auto again = simplex.nearest();
      wrong += !is_nearly(square_of(first), square) || !is_nearly(square_of(again), square)
               || kept == 0
               || (square != 0 && kept > Dimension);
    }
  BOOST_CHECK_EQUAL(wrong, 0u);
  BOOST_CHECK_GT(proper, 500u);
}

BOOST_AUTO_TEST_CASE(nearest_point_of_a_simplex)
{
  for(std::size_t count = 1; count <= 3; ++count) {
    check_simplices<2>(count);
    check_simplices<3>(count);
  }
  check_simplices<3>(4);
}

BOOST_AUTO_TEST_CASE(simplex_has_the_vertices_that_it_keeps)
{
  internal::Hull_simplex<2> simplex;
  for(const std::array<double, 2>& p : {std::array<double, 2>{1, 1}, {1, -1}, {5, 0}})
    simplex.add(p);
  BOOST_CHECK(simplex.has({5, 0}));
  BOOST_CHECK((simplex.nearest() == std::array<double, 2>{1, 0}));
  BOOST_CHECK_EQUAL(simplex.size(), 2u);
  BOOST_CHECK(simplex.has({1, 1}) && simplex.has({1, -1}) && !simplex.has({5, 0}));
}

// Of parallel segments, any point of the difference may be told.
template <int Dimension>
void check_segments()
{
  Random random(Dimension);
  std::size_t wrong = 0;
  for(int i = 0; i < 5000; ++i) {
    const Integers a = lattice_hull(random, lattice_around_origin(Dimension, 6), 2);
    const Integers b = lattice_hull(random, lattice_around_origin(Dimension, 6), 2);
    const auto from = [](const auto& p, const auto& q) {
      return as_doubles<Dimension>(difference(q, p));
    };
    const double found = square_of(
      internal::nearest_of_segments(from(a[0], a[1]), from(b[0], b[1]), from(a[0], b[0])));
    const double truth = static_cast<double>(true_square(a, b, true));
    const bool are_parallel = is_null(cross(difference(a[1], a[0]), difference(b[1], b[0])));
    wrong += are_parallel ? !(found > truth - 1e-9) : !is_nearly(found, truth);
  }
  BOOST_CHECK_EQUAL(wrong, 0u);
}

BOOST_AUTO_TEST_CASE(nearest_point_of_two_segments)
{
  check_segments<2>();
  check_segments<3>();
}

// ---- distances ----------------------------------------------------------------------------------

// The answers to questions with a bound at the distance and around it.
struct Answers
{
  std::size_t asked = 0, wrong = 0, unknown = 0;
  std::size_t kept = 0; // vertices for exact numbers

  void check(const CGAL::Uncertain<bool>& answer, bool truth)
  {
    ++asked;
    if(!CGAL::is_certain(answer))
      ++unknown;
    else
      wrong += CGAL::get_certain(answer) != truth;
  }
};

template <int Dimension>
internal::Hull<Dimension> hull(const Integers& vertices, int exponent)
{
  internal::Hull<Dimension> hull;
  hull.size = vertices.size();
  for(std::size_t k = 0; k < hull.size; ++k)
    hull.vertices[k] = as_doubles<Dimension>(vertices[k], std::ldexp(1., exponent));
  return hull;
}

// What doubles know about the distance of two hulls: by the first guesses, and by more steps if
// these do not tell.
template <int Dimension, std::size_t Size_a, std::size_t Size_b>
class Asked
{
  using Hull = internal::Hull<Dimension>;
  using Distance = internal::Hull_distance<Dimension>;

public:
  Asked(const Hull& a, const Hull& b) : a_(a), b_(b) {}

  CGAL::Uncertain<bool> guess(double low, double high)
  {
    return internal::are_hulls_near<Size_a, Size_b>(a_, b_, {low, high}, v_);
  }

  CGAL::Uncertain<bool> is_within(double low, double high)
  {
    const CGAL::Uncertain<bool> guessed = guess(low, high);
    return CGAL::is_certain(guessed) ? guessed : Distance(a_, b_, v_).is_within({low, high});
  }

  // Of a bound that neither knows.
  Distance distance(double bound)
  {
    guess(bound, bound);
    Distance distance(a_, b_, v_);
    distance.is_within({bound, bound});
    return distance;
  }

private:
  Hull a_, b_;
  typename Distance::Vector v_;
};

// Two hulls, and their squared distance.
template <int Dimension, std::size_t Size_a, std::size_t Size_b>
struct Question
{
  using Asked_hulls = Asked<Dimension, Size_a, Size_b>;

  Question(const Integers& a, const Integers& b, bool are_small)
    : a(a), b(b), are_small(are_small), square(true_square(a, b, are_small))
  {}

  Asked_hulls hulls() const
  {
    return Asked_hulls(hull<Dimension>(a, exponent), hull<Dimension>(b, exponent));
  }

  // Whether the hulls are within r steps.
  void ask(double r, Answers& answers) const
  {
    const bool truth = square <= Rational(r) * Rational(r);
    const double bound = std::ldexp(r, exponent);
    answers.check(hulls().is_within(bound, bound), truth);
  }

  void guess(double r, Answers& answers) const
  {
    const double bound = std::ldexp(r, exponent);
    answers.check(hulls().guess(bound, bound), square <= Rational(r) * Rational(r));
  }

  // Whether the vertices that are left have the same distance. Counts them.
  bool are_enough(Answers& answers) const
  {
    const double r = std::ldexp(std::sqrt(static_cast<double>(square)), exponent);
    if(CGAL::is_certain(hulls().is_within(r, r)))
      return true;
    const auto asked = hulls().distance(r);
    Integers left_a, left_b;
    for(std::size_t k = 0; k < Size_a; ++k)
      if(asked.may_be_nearest(0, k))
        left_a.push_back(a[k]);
    for(std::size_t k = 0; k < Size_b; ++k)
      if(asked.may_be_nearest(1, k))
        left_b.push_back(b[k]);
    answers.kept += left_a.size() + left_b.size();
    return !left_a.empty() && !left_b.empty() && true_square(left_a, left_b, are_small) == square;
  }

  Integers a, b;
  bool are_small; // as true_square() asks
  Rational square;
  int exponent = 0; // of a step
};

// What is known about many pairs of hulls that are apart, in any rounding mode.
struct Survey
{
  explicit Survey(std::uint64_t seed) : random(seed) {}

  // Asks with bounds that are these multiples of the distance, and for the vertices that are left.
  template <class Question>
  void ask(const Question& question, const std::vector<double>& factors)
  {
    if(question.square == 0)
      return;
    ++apart;
    const Rounding_mode rounding(rounding_modes[random.below(4)]);
    const double r = std::sqrt(static_cast<double>(question.square));
    for(const double factor : factors)
      question.ask(factor * r, answers);
    too_few += !question.are_enough(left);
  }

  void check(std::size_t least_count) const
  {
    BOOST_CHECK_EQUAL(answers.wrong + left.wrong, 0u);
    BOOST_CHECK_EQUAL(too_few, 0u);
    BOOST_CHECK_GE(apart, least_count);
  }

  Random random;
  Answers answers, left;
  std::size_t too_few = 0, apart = 0;
};

// Of vertices whose coordinates are integers of up to `size`.
template <int Dimension, std::size_t Size_a, std::size_t Size_b>
Question<Dimension, Size_a, Size_b> small_question(Random& random, std::int64_t size)
{
  const Lattice lattice = lattice_around_origin(Dimension, size);
  const Integers a = lattice_hull(random, lattice, Size_a);
  return {a, lattice_hull(random, lattice, Size_b), true};
}

// Small integers: doubles know all but ties.
template <int Dimension, std::size_t Size_a, std::size_t Size_b>
void check_small_hulls()
{
  Survey survey(10 * Size_a + Size_b);
  Answers ties, guesses;
  for(const std::int64_t size : {1, 2, 4, 9})
    for(int i = 0; i < 300; ++i) {
      auto question = small_question<Dimension, Size_a, Size_b>(survey.random, size);
      const int exponents[] = {0, 0, -60, 150, 20};
      question.exponent = exponents[survey.random.below(5)];
      survey.ask(question, {.5, 1 - 1e-9, 1 + 1e-9, 2.});
      const Rounding_mode rounding(rounding_modes[survey.random.below(4)]);
      const double r = std::sqrt(static_cast<double>(question.square));
      for(const double bound : {r, std::nextafter(r, 0), std::nextafter(r, 1e9), .01})
        question.ask(bound, ties);
      if(question.square != 0)
        for(const double factor : {.5, 1 - 1e-9, 1 + 1e-9, 2.})
          question.guess(factor * r, guesses);
    }
  BOOST_TEST_CONTEXT(Size_a << " and " << Size_b << " vertices in dimension " << Dimension)
  {
    survey.check(21);
    BOOST_CHECK_EQUAL(ties.wrong + guesses.wrong, 0u);
    BOOST_CHECK_EQUAL(survey.answers.unknown, 0u);
    if constexpr(Size_a <= 2 && Size_b <= 2)
      BOOST_CHECK_EQUAL(guesses.unknown, 0u);
    else if constexpr(Size_a <= 3 && Size_b <= 3)
      BOOST_CHECK_LT(5 * guesses.unknown, 2 * guesses.asked);
    // A vertex and a triangle, or two edges, make four.
    BOOST_CHECK_LT(survey.left.kept, 5 * survey.apart);
  }
}

BOOST_AUTO_TEST_CASE(small_hulls)
{
  check_small_hulls<2, 1, 2>();
  check_small_hulls<2, 2, 2>();
  check_small_hulls<2, 3, 3>();
  check_small_hulls<2, 4, 4>();
  check_small_hulls<3, 1, 1>();
  check_small_hulls<3, 1, 4>();
  check_small_hulls<3, 2, 2>();
  check_small_hulls<3, 3, 2>();
  check_small_hulls<3, 3, 3>();
  check_small_hulls<3, 4, 4>();
  check_small_hulls<3, 2, 8>();
  check_small_hulls<3, 4, 8>();
}

// Hulls that are far longer than their distance: a vertex of one is near the middle of the other.
template <int Dimension, std::size_t Size_a, std::size_t Size_b>
void check_long_hulls()
{
  Survey survey(100 * Size_a + Size_b);
  Random& random = survey.random;
  for(int i = 0; i < 400; ++i) {
    const Lattice lattice
      = lattice_around_origin(Dimension, std::int64_t(1) << (10 + random.below(38)));
    Integers a = lattice_hull(random, lattice, Size_a), b = lattice_hull(random, lattice, Size_b);
    const auto gap
      = lattice_point(random, lattice_around_origin(Dimension, 1 << random.below(20)));
    Integers& one = i % 2 == 0 ? b : a;
    const Integers& other = i % 2 == 0 ? a : b;
    for(std::size_t axis = 0; axis < Dimension; ++axis)
      one[0][axis] = (other.front()[axis] + other.back()[axis]) / 2 + gap[axis];
    survey.ask(Question<Dimension, Size_a, Size_b>(a, b, false),
               {1, 1 - 0x1p-50, 1 + 0x1p-50, 1 - 0x1p-30, 1 + 0x1p-30});
  }
  BOOST_TEST_CONTEXT(Size_a << " and " << Size_b << " vertices in dimension " << Dimension)
  {
    survey.check(41);
  }
}

BOOST_AUTO_TEST_CASE(long_hulls)
{
  check_long_hulls<2, 1, 2>();
  check_long_hulls<2, 2, 2>();
  check_long_hulls<2, 3, 3>();
  check_long_hulls<3, 2, 2>();
  check_long_hulls<3, 3, 1>();
  check_long_hulls<3, 3, 3>();
  check_long_hulls<3, 4, 4>();
}

// Hulls next to a line.
Integers thin_hull(Random& random, const Hull_vector<std::int64_t>& direction, std::size_t size)
{
  const std::size_t width = std::size_t(1) << random.below(24);
  Integers vertices = lattice_hull(random, lattice_around_origin(3, std::int64_t(width)), size);
  for(auto& p : vertices) {
    const auto factor = static_cast<std::int64_t>(random.below(std::uint64_t(1) << 21));
    for(std::size_t axis = 0; axis < 3; ++axis)
      p[axis] += factor * direction[axis];
  }
  return vertices;
}

template <std::size_t Size_a, std::size_t Size_b>
void check_thin_hulls()
{
  Survey survey(1000 * Size_a + Size_b);
  for(int i = 0; i < 1000; ++i) {
    const std::int64_t length = std::int64_t(1) << survey.random.below(21);
    const auto direction = lattice_point(survey.random, lattice_around_origin(3, length));
    const Integers a = thin_hull(survey.random, direction, Size_a);
    const Integers b = thin_hull(survey.random, direction, Size_b);
    survey.ask(Question<3, Size_a, Size_b>(a, b, false), {1});
  }
  survey.check(100);
}

BOOST_AUTO_TEST_CASE(thin_hulls)
{
  check_thin_hulls<2, 2>();
  check_thin_hulls<3, 1>();
  check_thin_hulls<3, 3>();
  check_thin_hulls<4, 4>();
}

// ---- what is not known --------------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(bounds_between_two_doubles)
{
  const Question<2, 1, 2> question({{0, 0, 0}}, {{3, 4, 0}, {3, -4, 0}}, true); // at distance 3
  const auto answer = [&](double low, double high) {
    return question.hulls().is_within(low, high);
  };
  BOOST_CHECK(CGAL::certainly(answer(3.1, 3.2)));
  BOOST_CHECK(CGAL::certainly_not(answer(2.8, 2.9)));
  BOOST_CHECK(!CGAL::is_certain(answer(2.9, 3.1)));
  BOOST_CHECK(!CGAL::is_certain(answer(0, 3.1)));
}

// Segments on parallel lines of tiny and of huge numbers, whose products underflow and overflow.
BOOST_AUTO_TEST_CASE(parallel_segments_of_any_size)
{
  Survey survey(7);
  for(int exponent = -400; exponent <= 1000; exponent += exponent < -200 || exponent > 150 ? 1 : 9)
    for(int i = 0; i < 12; ++i) {
      const Lattice lattice = lattice_around_origin(3, 1 << 20);
      const Integers a = lattice_hull(survey.random, lattice, 2);
      Integers b = lattice_hull(survey.random, lattice, 1);
      b.push_back(b[0]);
      for(std::size_t axis = 0; axis < 3; ++axis)
        b[1][axis] += a[1][axis] - a[0][axis];
      Question<3, 2, 2> question(a, b, false);
      question.exponent = exponent;
      survey.ask(question, {.01, .5, .9, 1 - 1e-9, 1 + 1e-9, 1.1, 2.});
    }
  survey.check(10000);
  BOOST_CHECK_LT(survey.answers.unknown, survey.answers.asked);
}

// The triangles are on two parallel lines, and their means are next to each other. The difference
// of these has squares that vanish, so that its length seems to be 0, but products that do not.
BOOST_AUTO_TEST_CASE(tiny_numbers_whose_squares_vanish)
{
  Random random(8);
  Answers answers;
  for(int i = 0; i < 1000; ++i) {
    constexpr std::int64_t apart = 1430, shifts[] = {1 << 20, 1 << 21, -3 * (1 << 20)};
    Integers a, b;
    for(const std::int64_t shift : shifts) {
      const auto x = static_cast<std::int64_t>(random.below(std::uint64_t(1) << 50));
      a.push_back({x, x, 0});
      b.push_back({x + shift + apart, x + shift - apart, 0});
    }
    Question<2, 3, 3> question(a, b, false);
    question.exponent = -548;
    question.ask(0x1p50, answers);
  }
  BOOST_CHECK_EQUAL(answers.wrong, 0u);
}

// Squares overflow or vanish, or what is made of squares does: then no vertex is left out.
template <std::size_t Size_a, std::size_t Size_b>
void check_large_and_small_hulls()
{
  Survey survey(Size_a + Size_b);
  for(int exponent = -1000; exponent <= 1000; exponent += 10)
    for(int i = 0; i < 20; ++i) {
      auto question = small_question<3, Size_a, Size_b>(survey.random, 9);
      question.exponent = exponent;
      survey.ask(question, {.1, .9, 1.1, 9.});
    }
  survey.check(500);
}

BOOST_AUTO_TEST_CASE(numbers_that_are_large_or_small)
{
  check_large_and_small_hulls<1, 2>();
  check_large_and_small_hulls<2, 2>();
  check_large_and_small_hulls<3, 1>();
  check_large_and_small_hulls<3, 3>();
  check_large_and_small_hulls<4, 3>();
}

BOOST_AUTO_TEST_CASE(numbers_that_are_too_large_or_too_small)
{
  for(const int exponent : {-1074, -600, 600, 1000}) {
    Question<2, 2, 2> question({{1, 1, 0}, {9, 1, 0}}, {{1, 2, 0}, {9, 5, 0}}, true);
    question.exponent = exponent;
    const double bound = std::ldexp(100, exponent);
    BOOST_CHECK(!CGAL::is_certain(question.hulls().is_within(bound, bound)));
    const auto distance = question.hulls().distance(bound);
    for(std::size_t k = 0; k < 2; ++k)
      BOOST_CHECK(distance.may_be_nearest(0, k) && distance.may_be_nearest(1, k));
  }
}

// Coordinates that are up to the error less than those of the object.
template <int Dimension>
void lower_vertices(internal::Hull<Dimension>& hull, double error, Random& random)
{
  hull.error = error;
  for(std::size_t k = 0; k < hull.size; ++k)
    for(double& x : hull.vertices[k])
      x -= error * static_cast<double>(random.below(3)) / 2;
}

template <std::size_t Size_a, std::size_t Size_b>
void check_vertices_that_are_off()
{
  Random random(Size_b);
  const double errors[] = {0, 0x1p-30, 0x1p-10, 0x1p-5};
  Answers around, far;
  for(int i = 0; i < 4000; ++i) {
    const auto question = small_question<3, Size_a, Size_b>(random, 6);
    if(question.square == 0)
      continue;
    auto a = hull<3>(question.a, 0);
    auto b = hull<3>(question.b, 0);
    lower_vertices(a, errors[random.below(4)], random);
    lower_vertices(b, errors[random.below(4)], random);
    const double r = std::sqrt(static_cast<double>(question.square));
    const auto ask = [&](double bound, Answers& answers) {
      answers.check(Asked<3, Size_a, Size_b>(a, b).is_within(bound, bound), bound > r);
    };
    for(const double move : {-0x1p-4, -0x1p-5, -0x1p-9, -0x1p-30, 0x1p-30, 0x1p-9, 0x1p-5, 0x1p-4})
      ask(r + move, around);
    ask(r + 1, far);
    if(r > 1)
      ask(r - 1, far);
  }
  BOOST_TEST_CONTEXT(Size_a << " and " << Size_b << " vertices")
  {
    BOOST_CHECK_EQUAL(around.wrong + far.wrong, 0u);
    BOOST_CHECK_EQUAL(far.unknown, 0u);
    BOOST_CHECK_GT(far.asked, 1000u);
  }
}

BOOST_AUTO_TEST_CASE(vertices_that_are_off)
{
  BOOST_CHECK(CGAL::certainly(
    Asked<2, 1, 1>({{{{1, 1}}}, 1, 0x1p-50}, {{{{1, 1}}}, 1, 0}).is_within(1, 1)));
  check_vertices_that_are_off<1, 2>();
  check_vertices_that_are_off<2, 2>();
  check_vertices_that_are_off<2, 3>();
  check_vertices_that_are_off<4, 4>();
}

BOOST_AUTO_TEST_SUITE_END()
