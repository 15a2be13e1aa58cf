// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Positions of aircraft arrive minute by minute. Reports those that will come closer than three
// kilometers within two minutes, if they keep their velocities.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/fixed_radius_near_tracks.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vector = Kernel::Vector_3;
using Track = std::vector<std::pair<double, Kernel::Point_3>>; // in seconds and meters
using Aircraft = std::pair<int, Track>;

Track way_ahead(double lat, double lon, double feet, double knots, double course, double climb)
{
  const double degree = std::acos(-1.) / 180, foot = 0.3048, knot = 1852. / 3600;
  const double s = std::sin(lat * degree), c = std::cos(lat * degree);
  const double u = std::sin(lon * degree), v = std::cos(lon * degree);
  const Vector up(c * v, c * u, s), north(-s * v, -s * u, c), east(-u, v, 0);
  const Vector ahead = std::sin(course * degree) * east + std::cos(course * degree) * north;
  const Vector velocity = knots * knot * ahead + climb * foot / 60 * up;
  const auto here = CGAL::ORIGIN + (6371008.8 + feet * foot) * up;
  return {{0, here}, {120, here + 120 * velocity}};
}

int main(int argc, char* argv[])
{
  std::ifstream file(argc > 1 ? argv[1] : "data/aircraft_ch_2018-08-01.csv");
  std::map<std::string, std::vector<Aircraft>> minutes;
  char time[21];
  int id;
  double lat, lon, feet, knots, course, climb;
  for(std::string row; std::getline(file, row);)
    if(std::sscanf(row.c_str(), "%20[^,],%d,%lf,%lf,%lf,%lf,%lf,%lf", time, &id, &lat, &lon,
                   &feet, &knots, &course, &climb) == 8)
      minutes[time].emplace_back(id, way_ahead(lat, lon, feet, knots, course, climb));
  std::set<std::pair<int, int>> warned;
  const auto warn = CGAL::with_elements([&](const Aircraft& a, const Aircraft& b) {
    const auto approach = CGAL::closest_approach(a.second, b.second);
    if(warned.emplace(a.first, b.first).second && warned.size() <= 5)
      std::cout << "aircraft " << a.first << " and " << b.first << ": "
                << std::sqrt(CGAL::to_double(approach->squared_distance)) << " m in "
                << CGAL::to_double(approach->time) << " s\n";
  });
  const auto np = CGAL::parameters::point_map(CGAL::Second_of_pair_property_map<Aircraft>());
  for(const auto& minute : minutes)
    CGAL::fixed_radius_near_tracks(minute.second, CGAL::within_distance(3000), warn, np);
  std::cout << warned.size() << " pairs of aircraft were warned\n";
}
