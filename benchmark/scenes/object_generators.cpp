// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "object_generators.h"

#include "support/point_generators.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace thick_benchmark {

namespace {

using test_support::Random;

const double pi = 3.14159265358979323846;

using Vector = std::array<double, 3>;

Vector operator+(Vector a, const Vector& b)
{
  for(std::size_t axis = 0; axis < 3; ++axis)
    a[axis] += b[axis];
  return a;
}

Vector operator*(double factor, Vector a)
{
  for(double& x : a)
    x *= factor;
  return a;
}

Vector random_point(Random& random)
{
  return {random.uniform(), random.uniform(), random.uniform()};
}

// Of length 1, in the plane or in space.
Vector random_direction(int dimension, Random& random)
{
  Vector v = {};
  double square = 0;
  for(std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) {
    v[axis] = random.bell();
    square += v[axis] * v[axis];
  }
  return 1 / std::sqrt(square) * v;
}

// ---- from figures to scenes ---------------------------------------------------------------------

// The corners of an object: two of a box or segment, three of a triangle. A ball is that in a cube.
using Figure = std::array<Vector, 3>;
using Figures = std::vector<Figure>;

Figure box_around(const Vector& center, const Vector& sides)
{
  return {center + -0.5 * sides, center + 0.5 * sides};
}

Figure segment(const Vector& a, const Vector& b) { return {a, b}; }

template <class Make_figure>
Figures make_figures(std::size_t n, const Make_figure& make_figure)
{
  Random random(1);
  Figures figures;
  figures.reserve(n);
  for(std::size_t i = 0; i < n; ++i)
    figures.push_back(make_figure(random));
  return figures;
}

// Figures around the origin, moved to uniform points.
Figures scattered(Figures figures, double scale)
{
  Random random(2);
  for(Figure& figure : figures) {
    const Vector center = random_point(random);
    for(Vector& corner : figure)
      corner = center + scale * corner;
  }
  return figures;
}

Figures shuffled(Figures figures) { return test_support::shuffled(std::move(figures), 3); }

Object_scene make_scene(const std::string& name, Shape shape, int dimension,
                        const Figures& figures)
{
  Object_scene scene{std::to_string(dimension) + "D " + name, shape, dimension, {}};
  const std::size_t corners = shape == Shape::TRIANGLE ? 3 : 2;
  const auto append = [&](const Vector& v) {
    scene.numbers.insert(scene.numbers.end(), v.begin(), v.begin() + dimension);
  };
  scene.numbers.reserve(figures.size() * scene.numbers_per_object());
  for(const Figure& figure : figures)
    if(shape == Shape::BALL) {
      append(0.5 * (figure[0] + figure[1]));
      scene.numbers.push_back((figure[1][0] - figure[0][0]) / 2);
    }
    else
      for(std::size_t corner = 0; corner < corners; ++corner)
        append(figure[corner]);
  return scene;
}

// ---- sizes for a number of pairs ----------------------------------------------------------------

Vector sides_of(const Figure& figure, std::size_t corners)
{
  Vector sides;
  for(std::size_t axis = 0; axis < 3; ++axis) {
    const auto is_less = [=](const Vector& a, const Vector& b) { return a[axis] < b[axis]; };
    const auto ends
      = std::minmax_element(figure.begin(), figure.begin() + static_cast<int>(corners), is_less);
    sides[axis] = (*ends.second)[axis] - (*ends.first)[axis];
  }
  return sides;
}

// The factor for which the boxes of figures at uniform points have about k pairs: two boxes overlap
// with probability prod(s_i + t_i), s and t their sides. The mean is that of a sample of pairs.
double scale_for(const Figures& figures, std::size_t corners, int dimension, double k)
{
  Random random(4);
  const int samples = 1000000;
  double sum = 0;
  for(int sample = 0; sample < samples; ++sample) {
    const Vector sides = sides_of(figures[random.below(figures.size())], corners)
                         + sides_of(figures[random.below(figures.size())], corners);
    double product = 1;
    for(int axis = 0; axis < dimension; ++axis)
      product *= sides[static_cast<std::size_t>(axis)];
    sum += product;
  }
  const double n = static_cast<double>(figures.size());
  return std::pow(2 * k / (n * n * (sum / samples)), 1. / dimension);
}

// The figures that make_figure(random) makes around the origin, at uniform points.
template <class Make_figure>
Object_scene scatter(const std::string& name, Shape shape, int dimension, std::size_t n, double k,
                     const Make_figure& make_figure)
{
  const Figures figures = make_figures(n, make_figure);
  const std::size_t corners = shape == Shape::TRIANGLE ? 3 : 2;
  return make_scene(name, shape, dimension,
                    scattered(figures, scale_for(figures, corners, dimension, k)));
}

// The same of boxes and balls, whose sides are sides(random).
template <class Sides>
Object_scene scatter_boxes(const std::string& name, int dimension, std::size_t n, double k,
                           const Sides& sides, Shape shape = Shape::BOX)
{
  return scatter(name, shape, dimension, n, k,
                 [&](Random& random) { return box_around({}, sides(random)); });
}

Vector cube(double side) { return {side, side, side}; }

// At least 1 and at most 1000; exceeds s in between with probability s^-2.
double power_law(Random& random) { return (std::min)(1000., 1 / std::sqrt(1 - random.uniform())); }

// Two balls in two cubes that overlap meet with this probability.
const double ball_in_cube = pi / 6;

// The balls in the cubes of a scene in space.
Object_scene balls_in(const Object_scene& cubes)
{
  Object_scene balls{cubes.name, Shape::BALL, 3, {}};
  for(std::size_t i = 0; i < cubes.size(); ++i) {
    const double* low = cubes.object(i);
    for(std::size_t axis = 0; axis < 3; ++axis)
      balls.numbers.push_back((low[axis] + low[3 + axis]) / 2);
    balls.numbers.push_back((low[3] - low[0]) / 2);
  }
  return balls;
}

// ---- lattices -----------------------------------------------------------------------------------

// Appends the numbers of a cube or ball. The corners are rounded, as programs compute them.
void append_around(const Vector& center, double half, Object_scene& scene)
{
  const auto append = [&](double offset) {
    for(int axis = 0; axis < scene.dimension; ++axis)
      scene.numbers.push_back(center[static_cast<std::size_t>(axis)] + offset);
  };
  append(scene.shape == Shape::BALL ? 0 : -half);
  if(scene.shape == Shape::BALL)
    scene.numbers.push_back(half);
  else
    append(half);
}

// Points of a lattice with `steps` steps from 0 to 1. A quotient of integers is the double next to
// the decimal.
Object_scene lattice_objects(const std::string& name, Shape shape, int dimension, std::size_t n,
                             double steps)
{
  const double row = std::floor(std::pow(8 * static_cast<double>(n), 1. / dimension));
  Object_scene scene{std::to_string(dimension) + "D " + name, shape, dimension, {}};
  Random random(11);
  for(std::size_t i = 0; i < n; ++i) {
    const auto coordinate = [&] { return std::floor(row * random.uniform()) / steps; };
    const double x = coordinate(), y = coordinate();
    const double twice_half = 2 + static_cast<double>(random.below(3));
    append_around({x, y, coordinate()}, twice_half / (2 * steps), scene);
  }
  return scene;
}

// ---- meshes -------------------------------------------------------------------------------------

// A point of the mesh, parameters between 0 and 1: of the plane, or of a wavy torus.
Vector mesh_point(int dimension, double s, double t)
{
  if(dimension == 2)
    return {s, t, 0};
  const double u = 2 * pi * s, v = 2 * pi * t;
  const double thickness = 0.3 + 0.02 * std::sin(11 * u) * std::sin(7 * v);
  const double distance = 1 + thickness * std::cos(v);
  return {distance * std::cos(u), distance * std::sin(u), thickness * std::sin(v)};
}

// The triangles of (m + 1)^2 points in a lattice of the parameters, each moved a little.
Figures mesh(int dimension, std::size_t m)
{
  Random random(5);
  const auto jittered = [&](std::size_t i) {
    return (static_cast<double>(i) + 0.6 * random.uniform()) / static_cast<double>(m + 1);
  };
  std::vector<Vector> points;
  for(std::size_t i = 0; i <= m; ++i)
    for(std::size_t j = 0; j <= m; ++j) {
      const double s = jittered(i);
      points.push_back(mesh_point(dimension, s, jittered(j)));
    }
  Figures triangles;
  for(std::size_t i = 0; i < m; ++i)
    for(std::size_t j = 0; j < m; ++j) {
      const Vector* corner = points.data() + i * (m + 1) + j;
      triangles.push_back({corner[0], corner[1], corner[m + 1]});
      triangles.push_back({corner[1], corner[m + 1], corner[m + 2]});
    }
  return triangles;
}

Figure box_of(const Figure& triangle)
{
  Figure box = {triangle[0], triangle[0]};
  for(const Vector& corner : triangle)
    for(std::size_t axis = 0; axis < 3; ++axis) {
      box[0][axis] = (std::min)(box[0][axis], corner[axis]);
      box[1][axis] = (std::max)(box[1][axis], corner[axis]);
    }
  return box;
}

} // namespace

// ---- boxes --------------------------------------------------------------------------------------

Object_scene uniform_boxes(int dimension, std::size_t n, double k)
{
  return scatter_boxes("uniform boxes", dimension, n, k, random_point);
}

// Two intervals with sides up to s meet with probability s, but for those at the ends of the scene.
Object_scene uniform_boxes_d(int dimension, std::size_t n, double k)
{
  const double size = static_cast<double>(n);
  const double longest = std::pow(2 * k / (size * size), 1. / dimension);
  Object_scene scene{std::to_string(dimension) + "D uniform boxes", Shape::BOX, dimension, {}};
  const auto d = static_cast<std::size_t>(dimension);
  scene.numbers.resize(2 * d * n);
  Random random(10);
  for(double* low = scene.numbers.data(); low != scene.numbers.data() + 2 * d * n; low += 2 * d)
    for(std::size_t axis = 0; axis < d; ++axis) {
      const double center = random.uniform(), half = longest * random.uniform() / 2;
      low[axis] = center - half;
      low[d + axis] = center + half;
    }
  return scene;
}

Object_scene power_law_boxes(int dimension, std::size_t n, double k)
{
  return scatter_boxes("cubes by a power law", dimension, n, k,
                       [](Random& random) { return cube(power_law(random)); });
}

Object_scene log_uniform_boxes(int dimension, std::size_t n, double k)
{
  return scatter_boxes("cubes of six decades", dimension, n, k,
                       [](Random& random) { return cube(std::pow(10, 6 * random.uniform())); });
}

Object_scene thin_boxes(std::size_t n, double k)
{
  return scatter_boxes("thin boxes", 2, n, k, [](Random& random) -> Vector {
    const double side = random.uniform();
    const double root_of_ratio = std::pow(10, 2 * random.uniform() - 1);
    return {side * root_of_ratio, side / root_of_ratio, 0};
  });
}

Object_scene beams(std::size_t n, double k)
{
  return scatter_boxes("beams", 3, n, k, [](Random& random) {
    Vector sides = cube(1);
    sides[random.below(3)] = 100;
    return sides;
  });
}

Object_scene long_boxes(int dimension, std::size_t n, double k)
{
  const double ratio = dimension == 2 ? 1e5 : 1e3;
  return scatter_boxes("long boxes", dimension, n, k, [=](Random& random) {
    Vector sides = random_point(random);
    sides[0] *= ratio;
    return sides;
  });
}

// The m boxes of a bell of width w have about m/2 pairs if their mean side is sqrt(pi) w m^(-1/d).
Object_scene clustered_boxes(int dimension, std::size_t n)
{
  struct Cluster
  {
    Vector center;
    double width;
  };
  const std::size_t clusters = 100;
  Random random(6);
  std::vector<Cluster> all(clusters);
  for(Cluster& cluster : all)
    cluster = {random_point(random), std::pow(10, -1 - 3 * random.uniform())};
  const double side = std::sqrt(pi) * std::pow(static_cast<double>(n / clusters), -1. / dimension);
  return make_scene("clusters", Shape::BOX, dimension, make_figures(n, [&](Random& in_cluster) {
    const Cluster& cluster = all[in_cluster.below(clusters)];
    Vector center = cluster.center;
    for(double& x : center)
      x += cluster.width * in_cluster.bell();
    return box_around(center, 2 * side * cluster.width * random_point(in_cluster));
  }));
}

Object_scene boxes_with_giant(int dimension, std::size_t n, double k)
{
  Object_scene scene = uniform_boxes(dimension, n, k);
  const auto d = static_cast<std::size_t>(dimension);
  std::fill_n(scene.numbers.begin(), d, -1);
  std::fill_n(scene.numbers.begin() + dimension, d, 2);
  return scene;
}

Object_scene boxes_on_one_axis(int dimension, std::size_t n, double k)
{
  Object_scene scene = uniform_boxes(dimension - 1, n, k);
  Object_scene result{std::to_string(dimension) + "D on one axis", Shape::BOX, dimension, {}};
  Random random(7);
  for(std::size_t corner = 0; corner < 2 * n; ++corner) {
    const double* x = scene.numbers.data() + corner * static_cast<std::size_t>(dimension - 1);
    result.numbers.push_back((corner % 2 == 0 ? -1 : 1) * random.uniform());
    result.numbers.insert(result.numbers.end(), x, x + dimension - 1);
  }
  return result;
}

Object_scene trap(int dimension, std::size_t n)
{
  const auto d = static_cast<std::size_t>(dimension);
  const double thickness = (dimension == 2 ? 1 : 0.75) / static_cast<double>(n);
  return make_scene("trap", Shape::BOX, dimension, make_figures(n, [=](Random& random) {
    const std::size_t axis = random.below(d);
    Vector center = random_point(random);
    if(dimension == 2 && axis == 1)
      center[0] += 2;
    center[axis] = 0.4 + 0.2 * random.uniform(); // ends differ, for cuts at the ends
    Vector sides = cube(thickness);
    sides[axis] = dimension == 2 ? 1.2 : 2;
    return box_around(center, sides);
  }));
}

Object_scene nested_boxes(int dimension, std::size_t n)
{
  double side = 0;
  return make_scene("nested boxes", Shape::BOX, dimension, shuffled(make_figures(n, [&](Random&) {
    return box_around({}, cube(++side));
  })));
}

Object_scene identical_boxes(int dimension, std::size_t n)
{
  return make_scene("identical boxes", Shape::BOX, dimension,
                    Figures(n, box_around({}, cube(1))));
}

Object_scene mesh_boxes(int dimension, std::size_t n)
{
  const double side = std::sqrt(static_cast<double>(n) / 2);
  Figures figures = mesh(dimension, static_cast<std::size_t>(side));
  std::transform(figures.begin(), figures.end(), figures.begin(), box_of);
  return make_scene("boxes of a mesh", Shape::BOX, dimension, shuffled(std::move(figures)));
}

// ---- balls, segments, triangles -----------------------------------------------------------------

Object_scene uniform_balls(std::size_t n, double k)
{
  return scatter_boxes("balls", 3, n, k / ball_in_cube,
                       [](Random& random) { return cube(0.6 + 0.4 * random.uniform()); },
                       Shape::BALL);
}

Object_scene power_law_balls(std::size_t n, double k)
{
  return scatter_boxes("balls by a power law", 3, n, k / ball_in_cube,
                       [](Random& random) { return cube(power_law(random)); }, Shape::BALL);
}

Object_scene log_uniform_balls(std::size_t n, double k)
{
  return balls_in(log_uniform_boxes(3, n, k / ball_in_cube));
}

Object_scene balls_with_giant(std::size_t n, double k)
{
  Object_scene scene = uniform_balls(n, k);
  std::fill_n(scene.numbers.begin(), 3, 0.5);
  scene.numbers[3] = 2;
  return scene;
}

Object_scene nested_balls(std::size_t n) { return balls_in(nested_boxes(3, n)); }

Object_scene identical_balls(std::size_t n) { return balls_in(identical_boxes(3, n)); }

Object_scene uniform_segments(int dimension, std::size_t n, double k)
{
  return scatter("segments", Shape::SEGMENT, dimension, n, k, [=](Random& random) {
    const Vector half = random.uniform() * random_direction(dimension, random);
    return segment(-1. * half, half);
  });
}

Object_scene roads(std::size_t n)
{
  const auto pieces = static_cast<std::size_t>(std::sqrt(static_cast<double>(n)));
  Random random(8);
  Figures figures;
  while(figures.size() < n) {
    const Vector step = 1 / static_cast<double>(pieces) * random_direction(2, random);
    Vector place = random_point(random);
    for(std::size_t piece = 0; piece < pieces && figures.size() < n; ++piece) {
      const Vector next = place + step;
      figures.push_back(segment(place, next));
      place = next;
    }
  }
  return make_scene("roads", Shape::SEGMENT, 2, shuffled(std::move(figures)));
}

Object_scene paths(std::size_t n, double k)
{
  Figures figures = make_figures(n, [](Random& random) {
    return segment({}, random.uniform() * random_direction(3, random));
  });
  const double scale = scale_for(figures, 2, 3, k);
  Random random(9);
  Vector place;
  for(std::size_t i = 0; i < n; ++i) {
    if(i % 10 == 0)
      place = random_point(random);
    const Vector next = place + scale * figures[i][1];
    figures[i] = segment(place, next);
    place = next;
  }
  return make_scene("paths", Shape::SEGMENT, 3, shuffled(std::move(figures)));
}

Object_scene uniform_triangles(std::size_t n, double k)
{
  return scatter("triangles", Shape::TRIANGLE, 3, n, k, [](Random& random) -> Figure {
    const Vector a = random_point(random), b = random_point(random);
    return {a, b, random_point(random)};
  });
}

// ---- lattices -----------------------------------------------------------------------------------

Object_scene decimal_objects(Shape shape, int dimension, std::size_t n)
{
  return lattice_objects("decimals", shape, dimension, n, 10);
}

Object_scene integer_objects(Shape shape, int dimension, std::size_t n)
{
  return lattice_objects("integers", shape, dimension, n, 1);
}

// ---- two sets -----------------------------------------------------------------------------------

Object_scene in_two_sets(Object_scene scene)
{
  scene.size_a = scene.size() / 2;
  return scene;
}

} // namespace thick_benchmark
