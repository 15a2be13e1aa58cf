// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Which arithmetic decides the pairs of each family of segments, triangles and tetrahedra, and
// which one would be enough for all determinants of the scene.
//
//   object_stages <folder for object_stages.csv>

#include "predicate_columns.h"

#include "measuring/Csv_file.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/thick_intersection_d.h>

#include <sstream>

namespace {

using namespace lab;
using CGAL::Arithmetic_tier;
using Kernel = CGAL::Simple_cartesian<double>;

CGAL::Scene_profile profile_of(const Object_set& set)
{
  return with_maker(set.kind, [&](auto maker) {
    CGAL::Scene_profile profile;
    CGAL::thick_self_intersection_d(objects_of<Kernel>(maker, set),
                                    [](std::size_t, std::size_t) {}, profile);
    return profile;
  });
}

std::string name_of(Arithmetic_tier tier)
{
  std::ostringstream name;
  name << tier;
  return name.str();
}

} // namespace

int main(int, char** arguments)
{
  thick_benchmark::Csv_file csv(arguments[1], "object_stages.csv",
                                "none: the profiles of searches (CGAL/Scene_profile.h, decided)",
                                "dimension,kind,family,degree,difference_bits,bits,needed_tier,"
                                "double,int64,int128,int192,exact");
  for(const Kind& kind : kinds())
    for(const Object_set& set : object_families(kind)) {
      const CGAL::Scene_profile profile = profile_of(set);
      csv.row(kind.dimension, kind.name, set.family, profile.degree(), profile.difference_bits(),
              profile.bits(), name_of(profile.needed_tier()),
              profile.decided(Arithmetic_tier::DOUBLE), profile.decided(Arithmetic_tier::INT64),
              profile.decided(Arithmetic_tier::INT128), profile.decided(Arithmetic_tier::INT192),
              profile.decided(Arithmetic_tier::FILTERED_EXACT));
    }
}
