// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Structs of one's own, and two sets of them: ships that are close to a port. A property map reads
// the place, so no array of points is made.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/fixed_radius_near_neighbors.h>

#include <boost/property_map/property_map.hpp>

#include <iostream>
#include <string>
#include <vector>

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;

struct Place
{
  std::string name;
  Point position; // kilometers
};

struct Position_of_place
{
  using key_type = Place;
  using value_type = Point;
  using reference = const Point&;
  using category = boost::readable_property_map_tag;

  friend reference get(Position_of_place, const Place& place) { return place.position; }
};

int main()
{
  const std::vector<Place> ships
    = {{"Aurora", {0, 0}}, {"Borealis", {30, 40}}, {"Cygnus", {9, 12}}};
  const std::vector<Place> ports = {{"North", {0, 50}}, {"South", {0, -15}}, {"East", {24, 32}}};
  const auto np = CGAL::parameters::point_map(Position_of_place());

  CGAL::fixed_radius_near_neighbors(
    ships, ports, CGAL::within_distance(25),
    CGAL::with_elements([](const Place& ship, const Place& port) {
      std::cout << ship.name << " is near " << port.name << '\n';
    }),
    np);

  // A callback that returns false stops the search. This one takes positions.
  const bool is_clear = CGAL::fixed_radius_near_neighbors(
    ships, CGAL::within_distance(15).open(), [](std::size_t, std::size_t) { return false; }, np);
  std::cout << (is_clear ? "no ships are closer than 15 km\n" : "ships are too close\n");
}
