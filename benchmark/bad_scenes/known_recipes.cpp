// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "bad_scenes/Recipe.h"

namespace thick_benchmark {

std::vector<const char*> known_recipes()
{
  return {
    // wires along y, with and without outliers
    "near3 r=1/n place:0:0.3:1e-9@all:1 place:2:0.7:1e-9@all:1",
    "near3 r=1/n place:0:0.3:1e-9@all:1 place:2:0.7:1e-9@all:1 place:0:1e12:0@one:0",
    "near3 r=1/n place:0:0.3:1e-9@all:1 place:2:0.7:1e-9@all:1 place:2:1e12:0@one:0",
    // bars and plates with outliers
    "near3 r=1/n place:1:0:4.5r@all:1 place:2:0:4.5r@all:1 place:0:1e12:0@one:0",
    "near3 r=1/n^0.5 place:2:0:4.5r@all:1 place:0:1e12:0@one:0",
    "near3 r=1/n^0.5 place:1:0:4.5r@all:1",
    "near2 r=1/n place:1:0:4.5r@all:1 place:0:1e12:0@one:0",
    // a bar, and a tenth of the points at all scales along each axis
    "near3 r=1/n place:1:0:4.5r@all:1 place:2:0:4.5r@all:1 log:0:20:1e12@random:0.1"
    " log:1:20:1e12@random:0.1 log:2:20:1e12@random:0.1",
    // many scales along both axes
    "near2 r=0.0006/n^0.5 nested:2:0.64/n^0.5:160000/n^-0.5@last:0.9"
    " clusters:1:5.3e-05r:7.4e-07@unseen:0.002 clusters:1:5.3e-05r:2r@unseen:0.002",
    "near2_sets r=220r/n^-0.5 first=0.21 nested:0:2/n^0.5:2@all:0.5"
    " follow:1:0.0042:1700r@sampled:0.5 place:1:0.49:0.49r@others:0.002"
    " sort:1:0.0002:30r@others:0.01",
    // a cross of two wires
    "near3 r=1/n place:1:0.3:1e-9@every:0.5 place:2:0.1:1e-9@every:0.5 place:0:0.3:1e-9@others:0.5"
    " place:2:0.7:1e-9@others:0.5",
    // one set on a line, and bands
    "near2_sets r=1e-12 bands:1:62:0.1@all:1 place:0:0.5:0@first:0.5",
    "near3_sets r=1e-12 bands:1:62:0.1@all:1 place:0:0.5:0@first:0.5",
    // scenes of many scales
    "near2 r=1e-200 log:2:300:1e100@all:1",
    "closest2 nested:0:600/n:1@all:1 follow:1:0:1@all:1",
    "closest3 nested:0:600/n:1@all:1 follow:1:0:1@all:1 follow:2:0:1@all:1",
    "closest5 nested:5:600/n:1@all:1",
    "closest2 squeeze:2:1:1@all:1 place:2:0:1e-19@every:0.5",
    "closest3 squeeze:3:1:1@all:1 place:3:0:1e-19@every:0.5",
    "closest5 squeeze:5:1:1@all:1 place:5:0:1e-19@every:0.5",
    "closest2 log:2:300:1@all:1",
    "closest3 log:3:300:1@all:1",
    "close2 r=1e-30 nested:0:600/n:1@all:1 follow:1:0:1@all:1",
    "close3 r=1e-30 squeeze:3:1:1@all:1 place:3:0:1e-19@every:0.5",
    // all neighbors at the same distance, and no distance at all
    "closest2 steps:2:0.59:0.98/n@all:1 copy:1:0r:0@random:0.82 nested:2:0.5:8.5@sampled:0.9",
    "closest2 steps:2:0.14:0.0088@all:1",
    "closest3 steps:3:0.14:0.0088@all:1",
    "closest2 steps:2:0:5e-324/n^-1@all:1",
    "closest3 steps:3:0:5e-324/n^-1@all:1",
    "closest3 steps:3:0:1e-300@all:1",
    "close2 r=1/n steps:2:0:1@all:1",
    "close2 r=2e-05 steps:1:0:0.21@first:1 span:0:1:0/n@others:0.38 nested:1:600/n:1.1@last:0.1",
    "close3 seed=51 r=1/n steps:3:0.5:6.2e-07@last:0.99 steps:1:0.00039:1@unseen:0.18",
    "close2 r=0",
    "close3 r=0",
    // short boxes on a lattice
    "boxes2 r=1e-9 bands:2:64:0@all:1",
    "boxes3 r=1e-9 bands:3:60:0@all:1",
    "boxes4 r=1e-9 bands:4:20:0@all:1",
    // horizontals and verticals that begin on a diagonal, none of which meet
    "boxes2 follow:1:0.0001:1@all:1 extent:0:0.2:0@every:0.5 extent:1:0.2:0@others:0.5",
    "boxes2_sets follow:1:0.0001:1@all:1 extent:0:0.2:0@first:0.5 extent:1:0.2:0@last:0.5",
    // the same, and a hundredth of them far out
    "boxes2 follow:1:2:1@all:1 extent:1:0.2:0@others:0.5 extent:0:0.2:0@every:0.5"
    " squeeze:1:30:30r@sampled:0.01",
    "boxes2_sets squeeze:1:30:30r@every:0.01 extent:0:0.2:0@first:0.5 extent:1:0.2:0@last:0.5",
    "boxes2 r=1/n extent:0:0.0009/n^-0.5:0@every:0.5 follow:1:5.6e-05:2@all:0.99"
    " nested:1:0.87:2.1e-11@sampled:0.5 extent:1:0.2:0@others:0.5",
    // two kinds of boxes in turn, of which one begins in one place along two axes
    "boxes3 r=1.2e-06 place:2:4.5:0@all:1 span:0:0.5r:0.09r@others:0.33",
    // sizes
    "boxes2 law:2:0.3/n^0.5:0.7@all:1",
    "boxes3 law:3:0.3/n^0.5:0.7@all:1",
    "boxes2 extent:0:1/n^0.5:0@every:0.5 extent:1:0.01/n^0.5:0@every:0.5"
    " extent:1:1/n^0.5:0@others:0.5 extent:0:0.01/n^0.5:0@others:0.5",
    "boxes3_sets span:2:0:1@all:1 place:0:2:1@first:0.5",
    "boxes4 log:4:6:1@all:1 extent:4:0:0.1/n^0.5@all:1"};
}

} // namespace thick_benchmark
