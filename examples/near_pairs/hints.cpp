// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Hints; see hints.h.

#include "hints.h"

#include "error.h"
#include "exact_number.h"
#include "text.h"

#include <algorithm>
#include <cmath>

namespace near_pairs {
namespace {

// Tells what an arc on the sphere measures, if it is long enough for the difference to matter. A
// distance is that of an arc if the user gave it, and that of a chord if it was found.
void print_chord(std::ostream& out, double distance, bool is_found)
{
  const double radius = earth_radius, pi = std::acos(-1.), noticeable = 0.999;
  const double arc
    = is_found ? 2 * radius * std::asin(std::min(1., distance / (2 * radius))) : distance;
  const double chord = 2 * radius * std::sin(arc / (2 * radius));
  if(arc <= pi * radius && chord < noticeable * arc)
    out << "near_pairs: hint: distances are straight lines through the sphere: "
        << std::llround(arc) << " m along its surface are " << std::llround(chord) << " m\n";
}

} // namespace

Tie_watch::Tie_watch(const Scene& scene, const Options& options)
  : scene_(scene), reach_(reach_of(options)), is_open_(options.open),
    is_on_(scene.rounding != 0 && std::isfinite(reach_))
{}

void Tie_watch::add_found(std::size_t i, std::size_t j, const Offset& offset)
{
  found_ += is_on_ && is_tie(i, j, offset);
}

void Tie_watch::add_lost(std::size_t i, std::size_t j, const Offset& offset)
{
  lost_ += is_on_ && !is_open_ && is_tie(i, j, offset);
}

bool Tie_watch::is_tie(std::size_t i, std::size_t j, const Offset& offset) const
{
  const double* const a = scene_.doubles.data() + i * scene_.dimension;
  const double* const b = scene_.doubles.data() + j * scene_.dimension;
  double largest = reach_;
  for(int axis = 0; axis < scene_.dimension; ++axis)
    largest = std::max({largest, std::abs(a[axis]), std::abs(b[axis])});
  return std::abs(scene_.distance(i, j, offset) - reach_) <= rounding_of(largest);
}

void print_degree_hints(std::ostream& out, const Options& options, bool has_degrees)
{
  if(options.geographic)
    print_chord(out, reach_of(options), options.closest);
  if(has_degrees && !options.decimal)
    out << "near_pairs: hint: degrees are taken as numbers in the plane; --geographic puts them on "
           "a sphere and measures meters\n";
}

void print_hints(std::ostream& out, const Scene& scene, const Options& options,
                 std::size_t found_ties, std::size_t lost_ties)
{
  print_degree_hints(out, options, scene.has_degrees);
  if(scene.cell && !scene.cell->space_group.empty())
    out << "near_pairs: hint: the copies of the atoms in the cell by the space group "
        << one_line(readable(scene.cell->space_group))
        << " are not in the file, and are not searched\n";
  if(found_ties + lost_ties != 0)
    out << "near_pairs: hint: pairs are at the distance but for rounding to doubles ("
        << found_ties << " of those found, " << lost_ties << " of those not found); --decimal "
           "takes decimals exactly\n";
}

} // namespace near_pairs
