// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Self-intersections of meshes, against those of CGAL: a mesh of the real world that was rounded,
// folded, cut and copied, and small meshes on a lattice where nearly everything is degenerate.

#include "support/check_pairs.h"
#include "support/data_files.h"
#include "support/usual_kernels.h"

#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/IO/OBJ.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/thick_mesh_self_intersections.h>

using namespace test_support;

namespace {

using Point = Epick::Point_3;
using Surface = CGAL::Surface_mesh<Point>;
using Vertex = Surface::Vertex_index;
using Face = Surface::Face_index;

template <class Mesh>
using Face_pairs = std::vector<std::pair<typename boost::graph_traits<Mesh>::face_descriptor,
                                         typename boost::graph_traits<Mesh>::face_descriptor>>;

// The pairs by the positions of faces among those of the mesh, the smaller position first.
template <class Mesh>
Pairs by_positions(const Mesh& mesh, const Face_pairs<Mesh>& found)
{
  std::map<typename boost::graph_traits<Mesh>::face_descriptor, std::size_t> positions;
  for(const auto face : faces(mesh))
    positions.emplace(face, positions.size());
  Pairs pairs;
  for(const auto& [f, g] : found)
    pairs.push_back(std::minmax(positions.at(f), positions.at(g)));
  return pairs;
}

template <class Mesh>
Pairs pairs_of_cgal(const Mesh& mesh)
{
  Face_pairs<Mesh> found;
  CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(found));
  return by_positions(mesh, found);
}

template <class ConcurrencyTag = CGAL::Sequential_tag, class Mesh>
Pairs pairs_of(const Mesh& mesh)
{
  Face_pairs<Mesh> found;
  CGAL::thick_mesh_self_intersections<ConcurrencyTag>(mesh, std::back_inserter(found));
  return by_positions(mesh, found);
}

template <class Mesh>
void check_pairs_of(const Mesh& mesh, const Pairs& expected, const std::string& name)
{
  check_pairs(name, expected, pairs_of(mesh));
  check_pairs(name + ", in parallel", expected, pairs_of<CGAL::Parallel_tag>(mesh));
}

// Returns the number of pairs.
template <class Mesh>
std::size_t check_mesh(const Mesh& mesh, const std::string& name)
{
  const Pairs expected = pairs_of_cgal(mesh);
  check_pairs_of(mesh, expected, name);
  return expected.size();
}

Surface read_spot()
{
  const auto path = find_data_file("spot.obj", data_folders());
  BOOST_REQUIRE(path);
  Surface mesh;
  BOOST_REQUIRE(CGAL::IO::read_OBJ(*path, mesh));
  return mesh;
}

Surface moved(Surface mesh, const std::function<Point(const Point&)>& move)
{
  for(Point& p : mesh.points())
    p = move(p);
  return mesh;
}

// The mesh and a copy of it.
Surface with_copy(Surface mesh, const Epick::Vector_3& shift)
{
  mesh.join(moved(mesh, [&](const Point& p) { return p + shift; }));
  return mesh;
}

double rounded(double x) { return std::round(x * 128) / 128; }

// A patch of triangles, and a closed surface, with vertices anywhere on a small lattice.
Surface random_mesh(unsigned int seed)
{
  Surface mesh;
  if(seed % 4 < 2)
    CGAL::make_icosahedron<Surface, Point>(mesh);
  else
    CGAL::make_grid(4, 3, mesh, true);
  Random random(seed);
  return moved(mesh, [&](const Point&) {
    const double x = double(random.below(3)), y = double(random.below(3));
    return Point(x, y, double(random.below(2 + seed % 2)));
  });
}

// Calls task(mesh, name) for random meshes, which returns how many pairs there are.
template <class Task>
void for_random_meshes(unsigned int count, std::size_t least_pairs, const Task& task)
{
  std::size_t pairs = 0;
  for(unsigned int seed = 0; seed < count; ++seed)
    pairs += task(random_mesh(seed), "seed " + std::to_string(seed));
  BOOST_CHECK_GT(pairs, least_pairs);
}

// The mesh with all coordinates divided by three.
template <class Kernel>
auto thirds(const Surface& mesh)
{
  using FT = typename Kernel::FT;
  CGAL::Surface_mesh<typename Kernel::Point_3> result;
  CGAL::copy_face_graph(mesh, result);
  for(auto& p : result.points())
    p = typename Kernel::Point_3(FT(p.x() / 3), FT(p.y() / 3), FT(p.z() / 3));
  return result;
}

// Two triangles without neighbors.
Surface two_triangles(const std::array<Point, 6>& points)
{
  Surface mesh;
  std::array<Vertex, 6> v;
  std::transform(points.begin(), points.end(), v.begin(),
                 [&](const Point& p) { return mesh.add_vertex(p); });
  mesh.add_face(v[0], v[1], v[2]);
  mesh.add_face(v[3], v[4], v[5]);
  return mesh;
}

// Lets all edges of a vertex end in another one.
void merge(Surface& mesh, Vertex from, Vertex into)
{
  for(const auto h : mesh.halfedges())
    if(mesh.target(h) == from)
      mesh.set_target(h, into);
}

} // namespace

BOOST_AUTO_TEST_CASE(real_mesh_has_the_pairs_of_cgal)
{
  const Surface spot = read_spot();
  BOOST_CHECK_EQUAL(check_mesh(spot, "as it is"), 0u);
  const auto round = [](const Point& p) {
    return Point(rounded(p.x()), rounded(p.y()), rounded(p.z()));
  };
  BOOST_CHECK_GT(check_mesh(moved(spot, round), "rounded"), 100u);
  BOOST_CHECK_GT(check_mesh(with_copy(spot, Epick::Vector_3(0.01, 0.02, 0.03)), "shifted"), 1000u);
  BOOST_CHECK_GE(check_mesh(with_copy(spot, CGAL::NULL_VECTOR), "twice"), spot.num_faces());
  const auto fold = [](const Point& p) { return Point(p.x(), std::fabs(p.y()), p.z()); };
  BOOST_CHECK_GT(check_mesh(moved(spot, fold), "folded"), 100u);
  const auto flatten = [](const Point& p) { return Point(p.x(), p.y(), std::round(4 * p.z())); };
  BOOST_CHECK_GT(check_mesh(moved(spot, flatten), "in layers"), 1000u);
}

BOOST_AUTO_TEST_CASE(mesh_with_holes_and_removed_faces_reports_its_own_descriptors)
{
  Surface mesh = with_copy(read_spot(), Epick::Vector_3(0.01, 0.02, 0.03));
  const std::vector<Face> faces(mesh.faces().begin(), mesh.faces().end());
  for(std::size_t i = 0; i < faces.size(); i += 7)
    CGAL::Euler::remove_face(mesh.halfedge(faces[i]), mesh);
  BOOST_CHECK(mesh.has_garbage());
  BOOST_CHECK_GT(check_mesh(mesh, "with holes"), 500u);
}

BOOST_AUTO_TEST_CASE(random_meshes_on_a_lattice_have_the_pairs_of_cgal)
{
  for_random_meshes(400, 20000, check_mesh<Surface>);
}

// CGAL 5.5 reports them, too. CGAL 6.1 does not.
BOOST_AUTO_TEST_CASE(two_faces_with_the_same_vertices_are_a_pair)
{
  Surface mesh;
  const Vertex a = mesh.add_vertex(Point(0, 0, 0)), b = mesh.add_vertex(Point(1, 0, 0)),
               c = mesh.add_vertex(Point(0, 1, 0));
  mesh.add_face(a, b, c);
  mesh.add_face(a, c, b);
  BOOST_CHECK(pairs_of(mesh) == Pairs({{0, 1}}));
}

BOOST_AUTO_TEST_CASE(two_edges_between_two_vertices_are_not_one_edge)
{
  Surface mesh = two_triangles({Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 0),
                                Point(1, 0, 0), Point(0, 0, 1)});
  merge(mesh, Vertex(3), Vertex(0));
  BOOST_CHECK_EQUAL(check_mesh(mesh, "one vertex at two points"), 1u);
  merge(mesh, Vertex(4), Vertex(1));
  BOOST_CHECK_EQUAL(check_mesh(mesh, "two edges"), 1u);
}

BOOST_AUTO_TEST_CASE(triangles_that_touch_are_a_pair_unless_the_mesh_joins_them)
{
  Surface mesh = two_triangles({Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 0),
                                Point(-1, 0, 0), Point(0, 0, 1)});
  BOOST_CHECK_EQUAL(check_mesh(mesh, "two vertices at one point"), 1u);
  merge(mesh, Vertex(3), Vertex(0));
  BOOST_CHECK_EQUAL(check_mesh(mesh, "one vertex"), 0u);
}

BOOST_AUTO_TEST_CASE(degenerate_faces_come_first_and_are_in_no_other_pair)
{
  const Surface mesh
    = two_triangles({Point(0, 0, 0), Point(2, 0, 0), Point(0, 2, 0), Point(0, 0, 0),
                     Point(1, 1, 0), Point(2, 2, 0)});
  Surface both = mesh;
  both.join(mesh);
  Face_pairs<Surface> found;
  CGAL::thick_mesh_self_intersections(both, std::back_inserter(found));
  const Face_pairs<Surface> expected
    = {{Face(1), Face(1)}, {Face(3), Face(3)}, {Face(0), Face(2)}};
  BOOST_CHECK(found == expected);
}

BOOST_AUTO_TEST_CASE(faces_of_a_range_are_compared_with_each_other_only)
{
  Surface mesh = with_copy(read_spot(), Epick::Vector_3(0.01, 0.02, 0.03));
  std::vector<Face> some;
  for(const Face face : mesh.faces())
    if(face.idx() % 3 != 0)
      some.push_back(face);
  Face_pairs<Surface> expected, found;
  CGAL::Polygon_mesh_processing::self_intersections(some, mesh, std::back_inserter(expected));
  CGAL::thick_mesh_self_intersections(some, mesh, std::back_inserter(found));
  BOOST_CHECK(std::all_of(found.begin(), found.end(),
                          [](const auto& pair) { return pair.first < pair.second; }));
  check_pairs("a range", by_positions(mesh, expected), by_positions(mesh, found));
}

BOOST_AUTO_TEST_CASE(search_stops_at_the_maximum_number)
{
  const Surface mesh = with_copy(read_spot(), Epick::Vector_3(0.01, 0.02, 0.03));
  for(const unsigned int number : {0u, 1u, 17u}) {
    Face_pairs<Surface> found;
    const auto np = CGAL::parameters::maximum_number(number);
    CGAL::thick_mesh_self_intersections(mesh, std::back_inserter(found), np);
    BOOST_CHECK_EQUAL(found.size(), number);
    found.clear();
    CGAL::thick_mesh_self_intersections<CGAL::Parallel_tag>(mesh, std::back_inserter(found), np);
    BOOST_CHECK_EQUAL(found.size(), number);
  }
  const Surface flat = moved(mesh, [](const Point& p) { return Point(p.x(), 0, 0); });
  for(const unsigned int number : {0u, 3u}) {
    Face_pairs<Surface> found;
    CGAL::thick_mesh_self_intersections(flat, std::back_inserter(found),
                                        CGAL::parameters::maximum_number(number));
    BOOST_CHECK_EQUAL(found.size(), number);
  }
}

BOOST_AUTO_TEST_CASE(output_iterator_is_returned_behind_the_last_pair)
{
  const Surface mesh
    = two_triangles({Point(0, 0, 0), Point(2, 0, 0), Point(0, 2, 0), Point(0, 0, 0),
                     Point(1, 1, 0), Point(2, 0, 2)});
  Face_pairs<Surface> found(4);
  BOOST_CHECK(CGAL::thick_mesh_self_intersections(mesh, found.begin()) == found.begin() + 1);
}

BOOST_AUTO_TEST_CASE(progress_functor_cancels_the_search)
{
  const Surface mesh = read_spot();
  Face_pairs<Surface> found;
  const Surface twice = with_copy(mesh, CGAL::NULL_VECTOR);
  CGAL::thick_mesh_self_intersections(twice, std::back_inserter(found),
                                      CGAL::parameters::callback([](double) { return false; }));
  BOOST_CHECK_LT(found.size(), mesh.num_faces());
}

BOOST_AUTO_TEST_CASE(point_map_replaces_the_points_of_the_mesh)
{
  Surface mesh = read_spot();
  const auto folded = mesh.add_property_map<Vertex, Point>("folded").first;
  for(const Vertex v : mesh.vertices())
    folded[v] = Point(mesh.point(v).x(), std::fabs(mesh.point(v).y()), mesh.point(v).z());
  Face_pairs<Surface> expected, found;
  const auto np = CGAL::parameters::vertex_point_map(folded);
  CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(expected), np);
  CGAL::thick_mesh_self_intersections(mesh, std::back_inserter(found), np);
  BOOST_CHECK_EQUAL(found.size(), expected.size());
  BOOST_CHECK_GT(found.size(), 100u);
}

BOOST_AUTO_TEST_CASE(polyhedron_has_the_same_pairs)
{
  const Surface mesh = with_copy(read_spot(), Epick::Vector_3(0.01, 0.02, 0.03));
  CGAL::Polyhedron_3<Epick> polyhedron;
  CGAL::copy_face_graph(mesh, polyhedron);
  BOOST_CHECK(sorted(pairs_of(polyhedron)) == sorted(pairs_of(mesh)));
}

// Thirds are no doubles, so the planes through them need exact numbers.
BOOST_AUTO_TEST_CASE(exact_kernels_have_the_pairs_of_cgal)
{
  for_random_meshes(40, 2000, [](const Surface& mesh, const std::string& name) {
    const auto lazy = thirds<Epeck>(mesh);
    check_pairs_of(thirds<Rational_kernel>(mesh), pairs_of_cgal(lazy), name + ", rationals");
    return check_mesh(lazy, name);
  });
}

// The first search makes their numbers exact, so the second one could find narrower boxes.
BOOST_AUTO_TEST_CASE(lazy_points_have_the_same_pairs_in_the_same_order_again)
{
  const Epeck::FT far = 0x1p46;
  Surface random;
  for(unsigned int seed = 0; seed < 8; ++seed)
    random.join(random_mesh(seed));
  auto mesh = thirds<Epeck>(random);
  for(auto& p : mesh.points())
    p = Epeck::Point_3((far + p.x()) - far, (far + p.y()) - far, (far + p.z()) - far);
  const Pairs first = pairs_of(mesh);
  BOOST_CHECK_GT(first.size(), 1000u);
  BOOST_CHECK(first == pairs_of(mesh));
}

// Tenths of integers are on a line or plane only nearly, so that predicates in doubles err.
BOOST_AUTO_TEST_CASE(kernel_with_inexact_predicates_has_the_pairs_of_an_exact_one)
{
  for_random_meshes(100, 2000, [](const Surface& random, const std::string& name) {
    const Surface mesh = moved(random, [](const Point& p) {
      return Point(p.x() / 10 + 100, p.y() / 10 + 200, p.z() / 10 + 300);
    });
    CGAL::Surface_mesh<Double_kernel::Point_3> inexact;
    CGAL::copy_face_graph(mesh, inexact);
    const Pairs expected = pairs_of_cgal(mesh);
    check_pairs_of(inexact, expected, name);
    return expected.size();
  });
}

BOOST_AUTO_TEST_CASE(empty_mesh_has_no_pair)
{
  BOOST_CHECK(pairs_of(Surface()).empty());
  BOOST_CHECK(pairs_of<CGAL::Parallel_tag>(Surface()).empty());
}

BOOST_AUTO_TEST_CASE(coordinate_that_is_not_finite_is_refused_before_anything_is_written)
{
  for(const double x : {std::numeric_limits<double>::quiet_NaN(),
                        std::numeric_limits<double>::infinity()}) {
    Surface mesh = two_triangles({Point(0, 0, 0), Point(1, 0, 0), Point(2, 0, 0), Point(0, 0, 0),
                                  Point(1, 1, 0), Point(0, x, 0)});
    Face_pairs<Surface> found;
    const std::string error
      = refusal([&] { CGAL::thick_mesh_self_intersections(mesh, std::back_inserter(found)); });
    BOOST_CHECK_EQUAL(error.rfind("A vertex of face 1 has a coordinate", 0), 0u);
    BOOST_CHECK(found.empty());
  }
}

BOOST_AUTO_TEST_CASE(face_that_is_no_triangle_is_refused)
{
  Surface mesh;
  CGAL::make_quad(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0), mesh);
  BOOST_CHECK_EQUAL(refusal([&] { pairs_of(mesh); }), "Face 0 is no triangle.");
}
