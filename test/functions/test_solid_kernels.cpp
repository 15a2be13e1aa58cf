// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Triangle meshes on several kernels, places and scales, against all pairs of their faces and all
// vertices: which ones intersect, and which ones are within a distance.

#include "support/check_solids.h"
#include "support/seeds.h"

using namespace test_support;

using Float_kernel = CGAL::Simple_cartesian<float>;

BOOST_AUTO_TEST_CASE(solids_of_doubles)
{
  const std::vector<Solid_scene> scenes = solid_scenes(60);
  check_solids<Solids, Epick>(scenes, {{}, {Scale::ONE, 1, 0x1p-52}});
  check_solids<Solids_and_polylines, Epick>(
    scenes, {{}, {Scale::ONE, 1, 0x1p-52}, {Scale::ONE, 0x1p+52, 1}, {Scale::HUGE_POWER},
             {Scale::DENORMAL}});
  check_solids<Solids_and_polylines, Double_kernel, Float_kernel>(solid_scenes(10), {{}});
}

BOOST_AUTO_TEST_CASE(random_solids)
{
  using Features = Solids_and_polylines<Epick>;
  check_seeds(20, [](std::uint64_t seed) {
    Solid_scene scene = seed % 3 == 0   ? random_solid_scene(seed, 12, 4, 4)
                        : seed % 3 == 1 ? random_solid_scene(seed, 20, 12, 8)
                                        : random_scene_of_parts(seed);
    if(seed % 5 == 0)
      scene.solids.push_back(random_solid_of_many_faces(seed));
    const Pairs expected = pairs_of_solids(scene.solids);
    for(const Placement& placement :
        {Placement{Scale::ONE, 1, 0x1p-52}, {Scale::ONE, 0x1p+52, 1},
         {seed % 2 == 0 ? Scale::HUGE_POWER : Scale::DENORMAL}})
      BOOST_TEST_CONTEXT("seed " << seed)
        check_solids_on_kernel<Features, Epick>(scene, expected, placement);
    BOOST_TEST_CONTEXT("seed " << seed)
      check_near_solids<Features, Epick>({scene}, {static_cast<std::int64_t>(seed / 3 % 3),
                                                   seed % 4 == 0});
  });
}

BOOST_AUTO_TEST_CASE(solids_of_exact_numbers)
{
  const std::vector<Solid_scene> scenes = small_solid_scenes(3);
  check_solids<Solids, Epeck>(scenes, {{Scale::THIRD}});
  check_solids<Solids_and_polylines, Epeck, Rational_kernel>(scenes, {{Scale::THIRD}});
  check_solids<Solids_and_polylines, Epeck>({scenes[0], scenes[2]}, {{Scale::CLOSE}});
}

BOOST_AUTO_TEST_CASE(near_solids)
{
  const std::vector<Solid_scene> scenes = solid_scenes(10);
  check_near_solids<Solids_and_polylines<Epick>, Epick>(scenes, {2, false});
  check_near_solids<Solids_and_polylines<Epick>, Epick>(scenes, {2, true});
  check_near_solids<Solids_and_polylines<Epick>, Epick>(scenes, {1, false});
  check_near_solids<Solids_and_polylines<Epick>, Epick>(scenes, {0, true});
  check_near_solids<Solids_and_polylines<Epeck>, Epeck>(small_solid_scenes(2), {1, false});
}
