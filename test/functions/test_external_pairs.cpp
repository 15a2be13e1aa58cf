// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The search of points that do not fit in memory, compared with the search in memory.

#include "support/brute_force.h"
#include "support/kernels.h"
#include "support/unit_test.h"

#include <CGAL/external_fixed_radius_near_neighbors.h>

#include <CGAL/Thick_intersection_d/internal/external/external_pairs_search.h>

#ifdef __unix__
#include <sys/stat.h>
#include <unistd.h>
#endif

using namespace test_support;
using namespace CGAL::Thick_intersection_d::internal;

namespace fs = std::filesystem;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Bound = CGAL::Distance_bound<double>;

namespace {

// A budget that has room for 858 points, which the public function refuses, and one that all scenes
// fit in.
constexpr std::size_t small = 1 << 16, large = 1 << 26;

Points uniform(std::size_t size) { return uniform_points(3, size, 0, 1, 1); }

// The callback and the kind of range are the same for all tests, so the search is compiled once.
using Report = std::function<bool(std::uint64_t, std::uint64_t)>;
using Go_on = std::function<bool(double)>;

bool search(const Points& scene, const Bound& bound, std::size_t bytes, const Report& report,
            const Go_on& go_on = [](double) { return true; })
{
  const auto points = make_points<Cartesian_points<Kernel, 3>>(scene);
  using Search = External_search<3, std::vector<Point>, No_map, double, const Report, Go_on>;
  return Search(points, No_map(), bound, CGAL::Memory_budget(bytes), report, go_on,
                Threads())
    .run();
}

Pairs pairs_of(const Points& points, const Bound& bound, std::size_t bytes)
{
  Pairs pairs;
  BOOST_CHECK(search(points, bound, bytes, [&](std::uint64_t i, std::uint64_t j) {
    BOOST_CHECK_LT(i, j);
    pairs.emplace_back(i, j);
    return true;
  }));
  return sorted(pairs);
}

// The pairs are the same in parts as in memory, and there are some.
void check_parts(const std::string& name, const Points& points, double distance)
{
  for(const bool is_open : {false, true})
    BOOST_TEST_CONTEXT(name << ", r = " << distance << (is_open ? ", open" : ""))
    {
      const Bound bound(distance, false, is_open);
      const Pairs expected = pairs_of(points, bound, large);
      BOOST_CHECK(!expected.empty());
      BOOST_CHECK(pairs_of(points, bound, small) == expected);
    }
}

Points moved(Points points, const std::function<void(std::size_t, Coordinates&)>& move)
{
  for(std::size_t i = 0; i < points.size(); ++i)
    move(i, points[i]);
  return points;
}

// A folder of its own for a test, which leaves nothing in it.
struct Scratch_folder
{
  Scratch_folder()
  {
    const auto now = std::chrono::system_clock::now().time_since_epoch().count();
    path = fs::temp_directory_path() / ("thick_test_" + std::to_string(now));
    fs::create_directory(path);
    fs::permissions(path, fs::perms::all);
  }
  ~Scratch_folder()
  {
    BOOST_CHECK(fs::is_empty(path));
    fs::remove_all(path);
  }
  fs::path path;
};

} // namespace

BOOST_AUTO_TEST_CASE(scenes_have_the_same_pairs_in_parts)
{
  check_parts("uniform", uniform(20000), .03);
  check_parts("clusters", clustered_points(3, 9000, 12, .004, 2), .001);
  check_parts("a plane", moved(uniform(10000), [](std::size_t, Coordinates& c) { c[0] = 3; }), .01);
  check_parts("a line", embedded(uniform_points(1, 10000, 0, 1, 3), 3), .0001);
  check_parts("of all sizes", moved(uniform(6000), [](std::size_t i, Coordinates& c) {
    for(double& x : c)
      x = std::ldexp(x, -static_cast<int>(i % 900));
  }), 0x1p-880);
}

// Decimals have ties that integers do not decide, and no two of them need be equal.
BOOST_AUTO_TEST_CASE(near_ties_are_the_same_in_parts)
{
  check_parts("a lattice", lattice_points(3, 20, .1), .1);
  check_parts("far from zero", moved(lattice_points(3, 16, 1), [](std::size_t, Coordinates& c) {
    c = {c[0] + 0x1p50, c[1] + 0x1p51, c[2] / 8 + 0x1p49};
  }), 1);
  Random random(4);
  const Points decimals
    = moved(embedded(integer_points(2, 20000, 5000, random), 3), [](std::size_t, Coordinates& c) {
        for(double& x : c)
          x /= 1000;
      });
  for(const double distance : {.005, .05})
    check_parts("decimals", decimals, distance);
}

// The first points tell where to cut, and here they are all on one side.
BOOST_AUTO_TEST_CASE(points_in_order_have_the_same_pairs_in_parts)
{
  Points points = uniform(20000);
  for(const std::size_t axis : {0, 2}) {
    std::sort(points.begin(), points.end(), [&](const Coordinates& p, const Coordinates& q) {
      return p[axis] < q[axis];
    });
    check_parts("in order", points, .03);
  }
}

BOOST_AUTO_TEST_CASE(points_of_type_Point_2_have_the_same_pairs_in_parts)
{
  const auto points = make_points<Cartesian_points<Kernel, 2>>(uniform_points(2, 140000, 0, 1, 5));
  const auto pairs_within = [&](std::size_t bytes) {
    Pairs pairs;
    CGAL::external_fixed_radius_near_neighbors(
      points, CGAL::within_distance(.002), CGAL::Memory_budget(bytes),
      [&](std::uint64_t i, std::uint64_t j) { pairs.emplace_back(i, j); });
    return sorted(pairs);
  };
  const Pairs expected = pairs_within(large);
  BOOST_CHECK_GT(expected.size(), 100000);
  BOOST_CHECK(pairs_within(1 << 22) == expected);
  BOOST_CHECK_THROW(pairs_within((1 << 22) - 1), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_crowd_that_fits_has_its_pairs)
{
  Points points = concatenated(uniform(10000), uniform_points(3, 400, .5, 1e-6, 6));
  std::reverse(points.begin() + 5000, points.end());
  check_parts("a crowd", points, .01);
}

BOOST_AUTO_TEST_CASE(equal_points_are_pairs_across_parts)
{
  const Points points = repeated(uniform(2500), 4);
  BOOST_CHECK_EQUAL(pairs_of(points, CGAL::within_distance(0.), small).size(), 6 * 2500);
}

BOOST_AUTO_TEST_CASE(a_crowd_that_does_not_fit_is_refused)
{
  const Points equal = identical_points(3, 3000, 1);
  BOOST_CHECK_THROW(pairs_of(equal, CGAL::within_distance(0.), small), std::length_error);
  const Points points = uniform(5000);
  BOOST_CHECK_THROW(pairs_of(points, CGAL::within_distance(.7), small), std::length_error);
  BOOST_CHECK_THROW(pairs_of(points, Bound(infinity, false), small),
                    std::length_error);
}

BOOST_AUTO_TEST_CASE(no_point_and_one_point_have_no_pair)
{
  for(std::size_t size : {0, 1})
    for(std::size_t bytes : {small, large})
      BOOST_CHECK(pairs_of(uniform(size), CGAL::within_distance(1.), bytes).empty());
}

BOOST_AUTO_TEST_CASE(callback_stops_the_search_in_a_later_part)
{
  const Points points = uniform(20000);
  std::size_t count = 0;
  BOOST_CHECK(!search(points, CGAL::within_distance(.03), small,
                      [&](std::uint64_t, std::uint64_t) { return ++count < 5000; }));
  BOOST_CHECK_EQUAL(count, 5000);
}

// Many sizes, as few of them would show a last value that is rounded.
BOOST_AUTO_TEST_CASE(progress_grows_up_to_one_and_stops_the_search)
{
  const Points points = uniform(20000);
  const Report report = [](std::uint64_t, std::uint64_t) { return true; };
  for(std::size_t size = 1000; size <= points.size(); size += 200) {
    const Points some(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(size));
    std::vector<double> told;
    BOOST_CHECK(search(some, CGAL::within_distance(.03), small, report, [&](double done) {
      told.push_back(done);
      return true;
    }));
    BOOST_CHECK(std::is_sorted(told.begin(), told.end()));
    BOOST_CHECK_EQUAL(told.back(), 1);
  }
  for(double last : {0., .1, .5})
    BOOST_CHECK(!search(points, CGAL::within_distance(.03), small, report,
                        [&](double done) { return done < last; }));
}

BOOST_AUTO_TEST_CASE(bad_arguments_are_refused_before_any_pair)
{
  Points points = uniform(3000);
  BOOST_CHECK_THROW(pairs_of(points, CGAL::within_distance(-1.), small), std::invalid_argument);
  points.back()[1] = std::nan("");
  const auto names_position = [](const std::invalid_argument& error) {
    return std::string(error.what()).find("point 2999") != std::string::npos;
  };
  BOOST_CHECK_EXCEPTION(pairs_of(points, CGAL::within_distance(.01), small), std::invalid_argument,
                        names_position);
}

BOOST_AUTO_TEST_CASE(a_folder_that_is_missing_is_an_error)
{
  const fs::path missing = fs::temp_directory_path() / "thick_intersection_d_no_such_folder";
  BOOST_CHECK_THROW(Scratch_file file(missing), std::system_error);
}

#ifdef __unix__
BOOST_AUTO_TEST_CASE(a_folder_of_the_system_that_is_missing_is_an_error_with_its_variable)
{
  const char* const given = std::getenv("TMPDIR");
  const std::string before = given == nullptr ? "" : given;
  setenv("TMPDIR", "/no/such/place", 1);
  const auto names_variable = [](const std::system_error& error) {
    return std::string(error.what()).find("TMPDIR") != std::string::npos;
  };
  BOOST_CHECK_EXCEPTION(CGAL::Memory_budget{large}, std::system_error, names_variable);
  BOOST_CHECK_EQUAL(CGAL::Memory_budget(large, "here").directory(), "here");
  given == nullptr ? unsetenv("TMPDIR") : setenv("TMPDIR", before.c_str(), 1);
}

// As a user who may not read what was made. The superuser may, and plays another user.
BOOST_AUTO_TEST_CASE(a_scratch_file_that_cannot_be_opened_leaves_nothing_behind)
{
  const Scratch_folder folder;
  const bool is_superuser = geteuid() == 0;
  constexpr uid_t nobody = 65534;
  BOOST_REQUIRE(!is_superuser || seteuid(nobody) == 0);
  const mode_t mask = umask(0777);
  BOOST_CHECK_THROW(Scratch_file file(folder.path), std::system_error);
  umask(mask);
  BOOST_REQUIRE(!is_superuser || seteuid(0) == 0);
}
#endif

#ifdef __linux__
// The file has no name, so it is found among those that the process has opened.
BOOST_AUTO_TEST_CASE(a_scratch_file_is_for_its_owner_alone)
{
  const Scratch_folder folder;
  const mode_t mask = umask(0);
  const Scratch_file file(folder.path);
  umask(mask);
  int found = 0;
  for(const fs::directory_entry& opened : fs::directory_iterator("/proc/self/fd")) {
    std::error_code ignored; // of that by which the directory is read
    const std::string name = fs::read_symlink(opened.path(), ignored).string();
    if(name.find(folder.path.filename().string()) == std::string::npos)
      continue;
    ++found;
    BOOST_CHECK(fs::status(opened.path()).permissions()
                == (fs::perms::owner_read | fs::perms::owner_write));
  }
  BOOST_CHECK_EQUAL(found, 1);
}
#endif

BOOST_AUTO_TEST_CASE(a_scratch_file_leaves_nothing_behind)
{
  const Scratch_folder folder;
  Scratch_file file(folder.path), other(folder.path);
  const std::array<double, 3> written = {1, 2, 3};
  std::array<double, 3> read = {};
  const std::uint64_t far = std::uint64_t(5) << 30; // beyond 32 bits; the file has a hole
  file.write(far, written.data(), sizeof written);
  file.read(far, read.data(), sizeof read);
  BOOST_CHECK(read == written);
  BOOST_CHECK_THROW(other.read(0, read.data(), sizeof read), std::system_error);
}

BOOST_AUTO_TEST_CASE(a_list_on_disk_gives_its_chunks_to_the_next_list)
{
  Chunk_store<3> store(fs::temp_directory_path(), 5);
  Stored_points<3> list, next;
  for(std::uint64_t i = 0; i < 203; ++i)
    list.add(store, {{1. * i, 0, 0}, i});
  list.flush(store);
  BOOST_CHECK_EQUAL(list.size(), 203);
  BOOST_CHECK_EQUAL(list.box().intervals()[0].high, 202);
  for(std::uint64_t i = 0; i < 203; ++i)
    BOOST_CHECK_EQUAL(list.read(store, i).id, i);
  list.take(store, [&](const Stored_point<3>& point) {
    BOOST_CHECK_EQUAL(point.id, next.size());
    next.add(store, point);
  });
  BOOST_CHECK_EQUAL(list.size(), 0);
  BOOST_CHECK_LE(store.size(), 4); // rows of 16 chunks
  std::vector<Stored_point<3>> loaded;
  next.load(store, loaded);
  BOOST_REQUIRE_EQUAL(loaded.size(), 203);
  for(std::uint64_t i = 0; i < 203; ++i) {
    BOOST_CHECK_EQUAL(loaded[i].x[0], 1. * i);
    BOOST_CHECK_EQUAL(loaded[i].id, i);
  }
}

// Half of the ids have no room in a number. Some points are given.
BOOST_AUTO_TEST_CASE(points_of_a_part_are_found_by_their_numbers)
{
  Loaded_points<3> part;
  const std::uint64_t far = (std::uint64_t(1) << 31) - 500;
  for(std::uint64_t first : {0, 1, 2}) {
    if(first < 2)
      part.begins.push_back(part.points.size());
    for(std::uint64_t id = first; id < 1000; id += 2)
      part.points.push_back({{1. * id, 0, 0}, far + id});
    if(first < 2)
      part.owned = part.points.size();
  }
  const Searched_points<3> points(part);
  int short_ids = 0;
  for(std::size_t place = 0; place < part.points.size(); ++place) {
    const std::uint64_t id = part.points[place].id;
    const std::size_t number = points.number(place);
    BOOST_CHECK_EQUAL(points.id(number), id);
    BOOST_CHECK_EQUAL(points.place(number), place);
    BOOST_CHECK_EQUAL(points[points.place(number)].x[0], id - far);
    BOOST_CHECK_EQUAL(points.is_owned(number), place < 1000);
    short_ids += points.is_id(number);
  }
  BOOST_CHECK_EQUAL(short_ids, 499);
}

BOOST_AUTO_TEST_CASE(stripes_have_about_as_many_numbers_each)
{
  Random random(7);
  std::vector<double> values;
  for(int i = 0; i < 6400; ++i)
    values.push_back(std::ldexp(random.uniform(), i % 600));
  std::sort(values.begin(), values.end());
  const Stripes stripes(values, 32);
  std::array<int, 32> counts = {};
  std::size_t last = 0;
  for(const double x : values) {
    BOOST_REQUIRE_GE(stripes(x), last);
    last = stripes(x);
    ++counts[last];
  }
  BOOST_CHECK_EQUAL(*std::min_element(counts.begin(), counts.end()), 200);
  const double infinite = (std::numeric_limits<double>::max)();
  BOOST_CHECK_EQUAL(stripes(-infinite), 0);
  BOOST_CHECK_EQUAL(stripes(infinite), 31);
}

BOOST_AUTO_TEST_CASE(stripes_separate_a_number_from_many_equal_ones)
{
  for(const double other : {1., 3.}) {
    std::vector<double> values(100, 2);
    values.push_back(other);
    std::sort(values.begin(), values.end());
    const Stripes stripes(values, 4);
    BOOST_CHECK_NE(stripes(2), stripes(other));
  }
}

BOOST_AUTO_TEST_CASE(a_huge_budget_has_parts_that_a_search_takes)
{
  const int bits = (std::min)(40, std::numeric_limits<std::size_t>::digits - 1); // a terabyte
  const std::size_t huge = std::size_t(1) << bits;
  BOOST_CHECK_LT(Part_limits(huge, sizeof(Stored_point<3>)).points_per_search(), max_place / 2);
}

BOOST_AUTO_TEST_CASE(parts_fill_the_budget_with_the_points_near_them)
{
  const Points points = uniform(60000);
  for(const auto& [bytes, reach, most_parts] : {std::tuple(small, .03, 250), {1 << 20, .003, 6}}) {
    External_parts<3> parts(CGAL::Memory_budget(bytes), reach);
    const auto point_at = [&](std::uint64_t i) {
      return Stored_point<3>({points[i][0], points[i][1], points[i][2]}, i);
    };
    parts.make(points.size(), point_at, [&](const auto& visit) {
      for(std::size_t i = 0; i < points.size(); ++i)
        visit(point_at(i));
    });
    std::size_t owned = 0;
    int count = 0;
    Loaded_points<3> loaded;
    for(; parts.find_next(); ++count) {
      parts.take_next(loaded);
      owned += loaded.owned;
      BOOST_CHECK_LE(loaded.points.size(), parts.limits().points_per_search());
    }
    BOOST_CHECK_EQUAL(owned, points.size());
    BOOST_CHECK_LE(count, most_parts);
  }
}
