// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Hints; see hints.h.

#include "hints.h"

#include "exact_number.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace near_pairs {
namespace {

double reach_of(const Options& options)
{
  const double distance = to_double(options.distance);
  return options.squared ? std::sqrt(distance) : distance;
}

// Tells what an arc on the sphere measures, if it is long enough for the difference to matter.
void print_chord(std::ostream& out, double arc)
{
  const double radius = earth_radius, pi = std::acos(-1.), noticeable = 0.999;
  const double chord = 2 * radius * std::sin(arc / (2 * radius));
  if(arc <= pi * radius && chord < noticeable * arc)
    out << "near_pairs: hint: distances are straight lines through the sphere: "
        << std::llround(arc) << " m along its surface are " << std::llround(chord) << " m\n";
}

} // namespace

Tie_watch::Tie_watch(const Scene& scene, const Options& options)
  : scene_(scene), reach_(reach_of(options)),
    is_on_(scene.has_short_decimals && !options.closest && std::isfinite(reach_))
{}

// Coordinates are rounded by half a unit in the last place, so a distance of up to three dimensions
// is wrong by less than two units of the largest one; the distance itself is rounded here, too.
void Tie_watch::add_pair(std::size_t i, std::size_t j, const Offset& offset)
{
  if(!is_on_)
    return;
  const double* const a = scene_.doubles.data() + i * scene_.dimension;
  const double* const b = scene_.doubles.data() + j * scene_.dimension;
  double largest = reach_;
  for(int axis = 0; axis < scene_.dimension; ++axis)
    largest = std::max({largest, std::abs(a[axis]), std::abs(b[axis])});
  const double error = 4 * std::numeric_limits<double>::epsilon() * largest;
  count_ += std::abs(scene_.distance(i, j, offset) - reach_) <= error;
}

void print_hints(std::ostream& out, const Scene& scene, const Options& options,
                 std::size_t rounded_ties)
{
  if(options.geographic)
    print_chord(out, reach_of(options));
  if(scene.unit == "deg" && !options.decimal)
    out << "near_pairs: hint: degrees are taken as numbers in the plane; --geographic puts them on "
           "a sphere and measures meters\n";
  if(scene.cell && !scene.cell->space_group.empty())
    out << "near_pairs: hint: the copies of the atoms in the cell by the space group "
        << scene.cell->space_group << " are not in the file, and are not searched\n";
  if(rounded_ties != 0)
    out << "near_pairs: hint: pairs are at the distance but for rounding to doubles ("
        << rounded_ties << " of those found), and others may be missing; --decimal takes decimals "
           "exactly\n";
}

} // namespace near_pairs
