// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "touching_generators.h"

#include "support/point_generators.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <map>
#include <utility>
#include <vector>

namespace thick_benchmark {

namespace {

using test_support::Random;

using Point = std::array<double, 3>;

// ---- what all scenes are made of ----------------------------------------------------------------

Object_scene empty_scene(const std::string& name, Shape shape, int dimension)
{
  return {std::to_string(dimension) + "D " + name, shape, dimension, {}};
}

void append(Object_scene& scene, std::initializer_list<Point> corners)
{
  for(const Point& corner : corners)
    scene.numbers.insert(scene.numbers.end(), corner.begin(), corner.begin() + scene.dimension);
}

// The two triangles of a quadrangle, whose corners are in order around it.
void append_quadrangle(Object_scene& scene, const std::array<Point, 4>& corner)
{
  append(scene, {corner[0], corner[1], corner[2]});
  append(scene, {corner[0], corner[2], corner[3]});
}

// In random order.
Object_scene shuffled(Object_scene scene)
{
  Random random(3);
  const std::size_t size = scene.numbers_per_object();
  for(std::size_t i = scene.size(); i > 1; --i) {
    double* last = scene.numbers.data() + (i - 1) * size;
    const std::size_t other = random.below(i);
    if(other != i - 1)
      std::swap_ranges(last, last + size, scene.numbers.data() + other * size);
  }
  return scene;
}

// How many steps along each axis a lattice has with n objects, of which each node has some.
int steps_for(std::size_t n, double objects_per_node, int dimension)
{
  return static_cast<int>(
    std::round(std::pow(static_cast<double>(n) / objects_per_node, 1. / dimension)));
}

Point integers(int x, int y, int z) { return {double(x), double(y), double(z)}; }

// A quotient of integers is the double next to the decimal.
Point decimals(int x, int y, int z = 0) { return {x / 10., y / 10., z / 10.}; }

// A node of an oblique lattice of squares in the plane.
Point oblique_node(int i, int j) { return decimals(3 * i - j, i + 3 * j); }

// The nodes of a lattice with the given numbers of steps, each moved by up to `jitter` steps.
class Moved_nodes
{
public:
  Moved_nodes(int x_steps, int y_steps, int z_steps, double jitter)
    : y_size_(y_steps + 1), z_size_(z_steps + 1)
  {
    Random random(5);
    for(int i = 0; i <= x_steps; ++i)
      for(int j = 0; j <= y_steps; ++j)
        for(int k = 0; k <= z_steps; ++k) {
          nodes_.push_back(integers(i, j, k));
          for(double& x : nodes_.back())
            x += jitter * random.uniform();
        }
  }

  const Point& operator()(int i, int j, int k) const
  {
    return nodes_[static_cast<std::size_t>((i * y_size_ + j) * z_size_ + k)];
  }

private:
  const int y_size_, z_size_;
  std::vector<Point> nodes_;
};

// ---- bricks -------------------------------------------------------------------------------------

// Bricks of four steps by two, each row shifted by half a brick. place(i, j) is a point of the
// plane.
template <class Place>
Object_scene bricks(const std::string& name, std::size_t n, const Place& place)
{
  Object_scene scene = empty_scene(name, Shape::TRIANGLE, 3);
  const int rows = steps_for(n, 2, 2);
  for(int row = 0; row < rows; ++row)
    for(int brick = 0; brick < rows; ++brick) {
      const int i = 4 * brick + 2 * (row % 2), j = 2 * row;
      append_quadrangle(scene,
                        {place(i, j), place(i + 4, j), place(i + 4, j + 2), place(i, j + 2)});
    }
  return shuffled(std::move(scene));
}

// ---- tetrahedra ---------------------------------------------------------------------------------

// The six tetrahedra of the cube at (i, j, k): each takes one way from the first corner to the
// opposite one, along the axes in some order.
template <class Node>
void append_cube(Object_scene& scene, const Node& node, int i, int j, int k)
{
  std::array<std::size_t, 3> axes = {0, 1, 2};
  do {
    std::array<Point, 4> corners;
    std::array<int, 3> place = {i, j, k};
    for(std::size_t corner = 0; corner < 4; ++corner) {
      corners[corner] = node(place[0], place[1], place[2]);
      if(corner < 3)
        ++place[axes[corner]];
    }
    append(scene, {corners[0], corners[1], corners[2], corners[3]});
  } while(std::next_permutation(axes.begin(), axes.end()));
}

// A flat block of cubes: three times as long and as wide as high.
template <class Node>
void append_block(Object_scene& scene, const Node& node, int height)
{
  for(int i = 0; i < 3 * height; ++i)
    for(int j = 0; j < 3 * height; ++j)
      for(int k = 0; k < height; ++k)
        append_cube(scene, node, i, j, k);
}

const double tetrahedra_per_step = 6 * 3 * 3;

// ---- meshes -------------------------------------------------------------------------------------

// The two triangles of each square of a lattice.
template <class Place>
Mesh_scene lattice_mesh(const std::string& name, std::size_t n, const Place& place)
{
  Mesh_scene mesh{name, {}, {}};
  const int m = steps_for(n, 2, 2);
  for(int i = 0; i <= m; ++i)
    for(int j = 0; j <= m; ++j)
      mesh.points.push_back(place(i, j));
  for(int i = 0; i < m; ++i)
    for(int j = 0; j < m; ++j) {
      const auto corner = static_cast<std::uint32_t>(i * (m + 1) + j);
      const auto next_row = corner + static_cast<std::uint32_t>(m + 1);
      mesh.faces.push_back({corner, next_row, corner + 1});
      mesh.faces.push_back({corner + 1, next_row, next_row + 1});
    }
  return mesh;
}

Object_scene soup_of(const Mesh_scene& mesh)
{
  Object_scene scene = empty_scene(mesh.name, Shape::TRIANGLE, 3);
  for(const auto& face : mesh.faces)
    append(scene, {mesh.points[face[0]], mesh.points[face[1]], mesh.points[face[2]]});
  return shuffled(std::move(scene));
}

// The mesh of an octahedron whose faces are divided into small triangles.
class Octahedron
{
public:
  explicit Octahedron(int steps) : steps_(steps)
  {
    for(int x : {-1, 1})
      for(int y : {-1, 1})
        for(int z : {-1, 1})
          add_side({x, y, z});
  }

  // On the sphere of radius 1.
  Mesh_scene mesh;

private:
  using Node = std::array<int, 3>; // the sum of the absolute values is steps_

  void add_side(const Node& signs)
  {
    for(int i = 0; i < steps_; ++i)
      for(int j = 0; j < steps_ - i; ++j) {
        add_face(signs, {i, j}, {i + 1, j}, {i, j + 1});
        if(j + 1 < steps_ - i)
          add_face(signs, {i + 1, j}, {i + 1, j + 1}, {i, j + 1});
      }
  }

  using Place = std::array<int, 2>;

  void add_face(const Node& signs, const Place& a, const Place& b, const Place& c)
  {
    const auto vertex = [&](const Place& p) {
      return index_of({signs[0] * p[0], signs[1] * p[1], signs[2] * (steps_ - p[0] - p[1])});
    };
    const bool is_mirrored = signs[0] * signs[1] * signs[2] < 0;
    mesh.faces.push_back({vertex(a), vertex(is_mirrored ? c : b), vertex(is_mirrored ? b : c)});
  }

  std::uint32_t index_of(const Node& node)
  {
    const auto next = static_cast<std::uint32_t>(mesh.points.size());
    const auto inserted = indices_.insert({node, next});
    if(inserted.second)
      mesh.points.push_back(point_of(node));
    return inserted.first->second;
  }

  Point point_of(const Node& node)
  {
    Point p;
    double square = 0;
    for(std::size_t axis = 0; axis < 3; ++axis) {
      p[axis] = node[axis] + 0.85 * random_.uniform();
      square += p[axis] * p[axis];
    }
    for(double& x : p)
      x /= std::sqrt(square);
    return p;
  }

  const int steps_;
  Random random_{5};
  std::map<Node, std::uint32_t> indices_;
};

// ---- near objects on a lattice ------------------------------------------------------------------

using Lattice_place = std::array<std::size_t, 3>;

Lattice_place random_place(Random& random, const Lattice_place& low, std::size_t side,
                           int dimension)
{
  Lattice_place place = low;
  for(std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis)
    place[axis] += random.below(side);
  return place;
}

// Whether the places p and q, or p, q and r, are on one line, or equal.
bool are_degenerate(const std::vector<Lattice_place>& corners)
{
  const auto difference = [&](std::size_t k, std::size_t axis) {
    return static_cast<int>(corners[k][axis]) - static_cast<int>(corners[0][axis]);
  };
  if(corners.size() == 2)
    return corners[0] == corners[1];
  for(std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t next = (axis + 1) % 3;
    if(difference(1, axis) * difference(2, next) != difference(1, next) * difference(2, axis))
      return false;
  }
  return true;
}

} // namespace

// ---- segments -----------------------------------------------------------------------------------

Object_scene streets(std::size_t n)
{
  Object_scene scene = empty_scene("streets", Shape::SEGMENT, 2);
  const int m = steps_for(n, 1.5, 2);
  for(int i = 0; i < m; ++i)
    for(int j = 0; j < m; ++j) {
      append(scene, {oblique_node(i, j), oblique_node(i, j + 1)});
      if((i + j) % 2 == 0)
        append(scene, {oblique_node(i, j), oblique_node(i + 2, j)});
    }
  return shuffled(std::move(scene));
}

// Beams to half of the 26 nodes around a node are made there, and the others at their other ends.
// Most of them are along the axes.
Object_scene frame_of_beams(std::size_t n)
{
  const double share_of_axes = 0.4, share_of_diagonals = 0.04;
  Object_scene scene = empty_scene("beams", Shape::SEGMENT, 3);
  const int m = steps_for(n, 3 * share_of_axes + 10 * share_of_diagonals, 3);
  Random random(12);
  for(int place = 0; place < m * m * m; ++place)
    for(int half = 14; half < 27; ++half) {
      const int x = half / 9 - 1, y = half / 3 % 3 - 1, z = half % 3 - 1;
      const bool is_axis = x * x + y * y + z * z == 1;
      if(random.uniform() < (is_axis ? share_of_axes : share_of_diagonals)) {
        const int i = place / (m * m), j = place / m % m, k = place % m;
        append(scene, {integers(i, j, k), integers(i + x, j + y, k + z)});
      }
    }
  return shuffled(std::move(scene));
}

// ---- triangles in the plane ---------------------------------------------------------------------

Object_scene triangulation(std::size_t n)
{
  Object_scene scene = empty_scene("triangulation", Shape::TRIANGLE, 2);
  const int m = steps_for(n, 2, 2);
  const Moved_nodes node(m, m, 0, 0.4);
  for(int i = 0; i < m; ++i)
    for(int j = 0; j < m; ++j)
      append_quadrangle(scene, {node(i, j, 0), node(i + 1, j, 0), node(i + 1, j + 1, 0),
                                node(i, j + 1, 0)});
  return shuffled(std::move(scene));
}

Object_scene rows_of_triangles(std::size_t n)
{
  Object_scene scene = empty_scene("rows of triangles", Shape::TRIANGLE, 2);
  const int m = steps_for(n, 2, 2);
  for(int j = 0; j < m; ++j)
    for(int i = 0; i < 2 * m; i += 2) {
      const Point next = oblique_node(i + 2, j), above = oblique_node(i + 1, j + 1);
      append(scene, {oblique_node(i, j), next, above});
      append(scene, {next, oblique_node(i + 3, j + 1), above});
    }
  return shuffled(std::move(scene));
}

// ---- triangles in space -------------------------------------------------------------------------

Object_scene terrain(std::size_t n) { return soup_of(terrain_mesh(n)); }

Object_scene floor_of_triangles(std::size_t n) { return soup_of(floor_mesh(n)); }

Object_scene bricks_of_decimals(std::size_t n)
{
  return bricks("tilted bricks", n, [](int i, int j) { return decimals(i, j, i + 2 * j); });
}

// Floats have 24 bits, so the sum is exact.
Object_scene bricks_of_floats(std::size_t n)
{
  return bricks("tilted bricks in one plane", n, [](int i, int j) -> Point {
    const double x = static_cast<float>(i / 10.), y = static_cast<float>(j / 10.);
    return {x, y, x / 2 + y / 4};
  });
}

// Each square of a floor has two triangles, and a wall begins on every other square.
Object_scene walls_on_floors(std::size_t n)
{
  const int floors = 10, height = 3;
  Object_scene scene = empty_scene("walls on floors", Shape::TRIANGLE, 3);
  const int m = steps_for(n, floors * 3, 2);
  for(int z = 0; z < floors * height; z += height)
    for(int x = 0; x < 2 * m; x += 2)
      for(int y = 0; y < 2 * m; y += 2) {
        append_quadrangle(scene, {decimals(x, y, z), decimals(x + 2, y, z),
                                  decimals(x + 2, y + 2, z), decimals(x, y + 2, z)});
        if((x + y) % 4 == 0)
          append_quadrangle(scene, {decimals(x + 1, y, z), decimals(x + 3, y + 1, z),
                                    decimals(x + 3, y + 1, z + height),
                                    decimals(x + 1, y, z + height)});
      }
  return shuffled(std::move(scene));
}

// ---- tetrahedra ---------------------------------------------------------------------------------

Object_scene tetrahedra_of_mesh(std::size_t n)
{
  Object_scene scene = empty_scene("tetrahedra of a mesh", Shape::TETRAHEDRON, 3);
  const int height = steps_for(n, tetrahedra_per_step, 3);
  append_block(scene, Moved_nodes(3 * height, 3 * height, height, 0.25), height);
  return shuffled(std::move(scene));
}

Object_scene shifted_tetrahedra(std::size_t n)
{
  Object_scene scene = empty_scene("tetrahedra, shifted", Shape::TETRAHEDRON, 3);
  const int height = steps_for(n, 2 * tetrahedra_per_step, 3);
  for(const int shift : {0, 1})
    append_block(
      scene,
      [=](int i, int j, int k) { return decimals(2 * i + shift, 2 * j + shift, 2 * k); }, height);
  return shuffled(std::move(scene));
}

// ---- meshes -------------------------------------------------------------------------------------

Mesh_scene sphere_mesh(std::size_t n)
{
  Mesh_scene mesh = Octahedron(steps_for(n, 8, 2)).mesh;
  mesh.name = "sphere";
  return mesh;
}

Mesh_scene terrain_mesh(std::size_t n)
{
  Random random(6);
  return lattice_mesh("terrain", n, [&](int i, int j) -> Point {
    return {double(i), double(j), random.uniform()};
  });
}

Mesh_scene floor_mesh(std::size_t n)
{
  return lattice_mesh("floor", n, [](int i, int j) { return decimals(i, j, 3); });
}

Mesh_scene with_shuffled_faces(Mesh_scene mesh)
{
  mesh.faces = test_support::shuffled(std::move(mesh.faces), 3);
  return mesh;
}

// ---- near objects on a lattice ------------------------------------------------------------------

Near_scene lattice_scene(Shape shape, int dimension, std::size_t n, double step)
{
  Random random(17);
  const double places = 2 * static_cast<double>(n);
  const auto side = static_cast<std::size_t>(std::ceil(std::pow(places, 1. / dimension)));
  Near_scene scene = {step == 1 ? "lattice" : "lattice of decimals", {"", shape, dimension, {}},
                      step};
  while(scene.objects.size() < n) {
    std::vector<Lattice_place> corners = {random_place(random, {}, side, dimension)};
    while(corners.size() < corners_of(shape))
      corners.push_back(random_place(random, corners.front(), 3, dimension));
    if(are_degenerate(corners))
      continue;
    for(const Lattice_place& corner : corners)
      for(std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis)
        scene.objects.numbers.push_back(step * static_cast<double>(corner[axis]));
  }
  return scene;
}

} // namespace thick_benchmark
