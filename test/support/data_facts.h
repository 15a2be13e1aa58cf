// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What is known about the real data files: exact numbers of pairs, counted by an independent
// program in integer arithmetic on the printed decimals.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_DATA_FACTS_H
#define THICK_INTERSECTION_TEST_SUPPORT_DATA_FACTS_H

#include "data_files.h"

namespace test_support {

enum class View
{
  plane,      // (latitude, longitude) in degrees, or the coordinates of a plane instance
  sphere,     // points on the Earth in metres, two decimals
  end_points, // of runways, in degrees
  centres,    // of atoms, in Angstrom
  vertices    // of a mesh
};

struct Fact
{
  std::string file;
  View view;
  int dimension;
  std::size_t n;
  std::string radius;     // decimal text, in the unit of the view
  std::size_t closer;     // pairs strictly closer than the radius
  std::size_t at_radius;  // pairs at exactly the radius
};

struct Ball_fact
{
  std::string file;
  std::size_t overlapping; // pairs of van der Waals balls with common inner points
  std::size_t touching;    // pairs of balls with one common point
};

inline std::ostream& operator<<(std::ostream& out, const Fact& fact)
{
  return out << fact.file << ", " << fact.dimension << "D, r = " << fact.radius;
}

inline std::vector<Fact> facts()
{
  const std::string aircraft = "aircraft_ch_2018-08-01_am.csv", quakes = "earthquakes-23k.csv";
  const std::string ships = "ships_us_2022-01-03.csv", airports = "airports.dat";
  return {
    {aircraft, View::plane, 2, 12939, "0.011", 6904, 0},
    {aircraft, View::plane, 2, 12939, "0.053", 128801, 0},
    {aircraft, View::sphere, 3, 12939, "1300", 7381, 0},
    {aircraft, View::sphere, 3, 12939, "5000", 130318, 0},
    {quakes, View::plane, 2, 23412, "0.065", 11500, 8},
    {quakes, View::plane, 2, 23412, "0.41", 219595, 0},
    {quakes, View::sphere, 3, 23412, "6700", 11579, 0},
    {quakes, View::sphere, 3, 23412, "45000", 236049, 0},
    {"runways.csv", View::end_points, 2, 31072, "0.011", 14877, 0},
    {"runways.csv", View::end_points, 2, 31072, "0.61", 310518, 0},
    {ships, View::plane, 2, 10227, "0.00069", 4931, 0},
    {ships, View::plane, 2, 10227, "0.019", 101850, 0},
    {ships, View::sphere, 3, 10227, "69", 5092, 0},
    {ships, View::sphere, 3, 10227, "1900", 101535, 0},
    {airports, View::plane, 2, 7698, "0.44", 3863, 0},
    {airports, View::plane, 2, 7698, "2.4", 78615, 0},
    {airports, View::sphere, 3, 7698, "41000", 3767, 0},
    {airports, View::sphere, 3, 7698, "230000", 79592, 0},
    {"1crn.pdb", View::centres, 3, 327, "1.5", 193, 0},
    {"1crn.pdb", View::centres, 3, 327, "4.8", 3229, 0},
    {"1ihm.pdb", View::centres, 3, 11284, "1.5", 7100, 0},
    {"1ihm.pdb", View::centres, 3, 11284, "4.8", 114746, 0},
    {"4hhb.pdb", View::centres, 3, 4779, "1.4", 1916, 0},
    {"4hhb.pdb", View::centres, 3, 4779, "4.7", 47787, 0},
    {"5dfr_solv.pdb", View::centres, 3, 23558, "0.96", 14056, 0},
    {"5dfr_solv.pdb", View::centres, 3, 23558, "3.9", 246174, 0},
    {"pba38478.tsp", View::plane, 2, 38478, "3", 28291, 12042},
    {"pba38478.tsp", View::plane, 2, 38478, "12", 417132, 8947},
    {"usa13509.tsp", View::plane, 2, 13509, "580", 6771, 0},
    {"usa13509.tsp", View::plane, 2, 13509, "3400", 140246, 0},
    {"spot.obj", View::vertices, 3, 2930, "0.023", 1445, 0},
    {"spot.obj", View::vertices, 3, 2930, "0.082", 29332, 0}};
}

inline std::vector<Ball_fact> ball_facts()
{
  return {{"1crn.pdb", 1141, 0},
          {"1ihm.pdb", 39339, 0},
          {"4hhb.pdb", 16276, 0},
          {"5dfr_solv.pdb", 66022, 0}};
}

// spot.obj: pairs of its triangles whose closed bounding boxes meet.
constexpr std::size_t meeting_boxes_of_spot = 36747;

// aircraft_ch_2018-08-01_am.csv: pairs at one instant, closer than 5 nautical miles and 1000 feet.
struct Separation_fact
{
  std::string file = "aircraft_ch_2018-08-01_am.csv";
  std::size_t instants = 510;
  std::size_t pairs = 31;
};

// runways.csv: pairs of runways of one airport that cross at inner points of both, and those that
// only touch, overlap or have an end in common.
constexpr std::size_t crossing_runways = 2601, touching_runways = 71;

inline Decimal_points read_view(const std::string& path, View view)
{
  switch(view) {
  case View::sphere: return sphere_points(read_places(path));
  case View::end_points: return read_runways(path).ends;
  case View::centres: return read_pdb(path).centres;
  case View::vertices: return read_obj(path).vertices;
  case View::plane: break;
  }
  const bool is_tsp = std::filesystem::path(path).extension() == ".tsp";
  return is_tsp ? read_tsp(path) : plane_points(read_places(path));
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_DATA_FACTS_H
