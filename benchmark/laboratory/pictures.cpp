// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Where the forms of the predicate go wrong: neighbouring lattice points around the circle, a scene
// that moves away from the origin, and a scene that shrinks and grows.
//
//   pictures <folder for microscope.csv, offsets.csv and scales.csv>

#include "measuring/Csv_file.h"
#include "methods/all_pairs.h"
#include "methods/distance_forms.h"

#include "support/brute_force.h"
#include "support/kernels.h"
#include "support/point_generators.h"

#include <CGAL/Simple_cartesian.h>

namespace {

using namespace test_support;
using Kernel = CGAL::Simple_cartesian<double>;
using thick_benchmark::Csv_file;
using Form = thick_benchmark::Named_form<2>;
using Array = Form::Point;

const char* const truth = "GMP integers (test/support/exact_points.h, are_within_radius)";

bool is_near_by_package(const Array& p, const Array& q, double r)
{
  const CGAL::Thick_point_traits_d<Kernel::Point_2> traits(CGAL::within_distance(r));
  return traits.do_intersect_d_object()({p[0], p[1]}, {q[0], q[1]});
}

std::vector<Form> forms()
{
  std::vector<Form> forms = thick_benchmark::common_forms<2>();
  forms.push_back({"long double", thick_benchmark::Squared_in<long double>::is_near<2>});
  forms.push_back({"ours", is_near_by_package});
  return forms;
}

// ---- the microscope: p stays, q is each of 256 x 256 points next to each other ------------------

struct View
{
  std::string name;
  Array p;
  double r;
};

// A row of pixels, '.' right, 'x' extra, 'm' missing, as runs: "200.3x53." is 256 pixels.
std::string run_lengths(const std::string& row)
{
  std::string runs;
  for(std::size_t first = 0; first < row.size();) {
    const std::size_t last = std::min(row.find_first_not_of(row[first], first), row.size());
    runs += std::to_string(last - first) + row[first];
    first = last;
  }
  return runs;
}

void write_views(Csv_file& csv)
{
  constexpr int width = 256;
  const double step = std::ldexp(1., -56);
  for(const View& view : {View{"p = (-3, -4), r = 5", {-3, -4}, 5.},
                          View{"p = (-0.3, -0.4), r = 0.5", {-0.3, -0.4}, 0.5}}) {
    Points points = {{view.p[0], view.p[1]}};
    for(int y = 0; y < width; ++y)
      for(int x = 0; x < width; ++x)
        points.push_back({(x - width / 2) * step, (y - width / 2) * step});
    const Exact_points exact(points, Radius::of_length(view.r));
    for(const Form& form : forms()) {
      if(form.name == "float" || form.name == "long double" || form.name == "double, expanded")
        continue; // all wrong, all right, much like another one
      for(int y = 0; y < width; ++y) {
        std::string row(width, '.');
        for(int x = 0; x < width; ++x) {
          const std::size_t i = static_cast<std::size_t>(1 + y * width + x);
          const bool is_found = form.is_near(view.p, {points[i][0], points[i][1]}, view.r);
          if(is_found != exact.are_within_radius(0, i))
            row[static_cast<std::size_t>(x)] = is_found ? 'x' : 'm';
        }
        csv.row(view.name, form.name, y, run_lengths(row));
      }
    }
  }
}

// ---- scenes that move and scale -----------------------------------------------------------------

Pairs pairs_by(const Form& form, const Points& points, double r)
{
  Pairs pairs;
  const auto is_near = [&](std::size_t i, std::size_t j) {
    return form.is_near({points[i][0], points[i][1]}, {points[j][0], points[j][1]}, r);
  };
  const auto append = [&](std::size_t i, std::size_t j) { pairs.emplace_back(i, j); };
  thick_benchmark::all_pairs(points.size(), is_near, append);
  return pairs;
}

void write_wrong_pairs(int exponent, const Points& points, double r, Csv_file& csv)
{
  const Pairs expected = brute_force(points, Radius::of_length(r)).pairs;
  const auto write = [&](const std::string& name, const Pairs& found) {
    const Pairs_difference wrong = compare(expected, found);
    csv.row(exponent, name, expected.size(), wrong.missing.size(), wrong.extra.size());
  };
  for(const Form& form : forms())
    if(form.name != "ours")
      write(form.name, pairs_by(form, points, r));
  write("ours", near_pairs(make_points<Cartesian_points<Kernel, 2>>(points),
                           CGAL::within_distance(r)));
}

} // namespace

int main(int, char** arguments)
{
  const std::string folder = arguments[1];
  Csv_file microscope(folder, "microscope.csv", truth, "view,form,row,pixels");
  write_views(microscope);

  Csv_file offsets(folder, "offsets.csv", truth, "exponent,method,true_pairs,missing,extra");
  for(int exponent = 0; exponent <= 50; ++exponent)
    write_wrong_pairs(exponent, uniform_points(2, 400, std::ldexp(1., exponent), 1, 1), 0.1,
                      offsets);

  Csv_file scales(folder, "scales.csv", truth, "exponent,method,true_pairs,missing,extra");
  for(int exponent = -540; exponent <= 540; exponent += 15) {
    const double unit = std::ldexp(0.1, exponent);
    write_wrong_pairs(exponent, lattice_points(2, 16, unit), 5 * unit, scales);
  }
}
