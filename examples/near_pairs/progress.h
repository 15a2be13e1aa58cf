// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The option --progress.

#ifndef NEAR_PAIRS_PROGRESS_H
#define NEAR_PAIRS_PROGRESS_H

#include "stop.h"

#include <cstdio>
#include <functional>

namespace near_pairs {

// Shows the percentage that is done on the standard error. What is printed next, such as an error,
// takes its place.
inline void show_progress(double done)
{
  const int percent = static_cast<int>(100 * done);
  std::fprintf(stderr, "searching %3d %%  %s", percent, percent >= 100 ? "\n" : "\r");
}

// Shows the progress of a search if that is wanted, and stops the search if that is.
inline std::function<bool(double)> progress_functor(bool is_shown)
{
  return [is_shown](double done) {
    if(is_shown)
      show_progress(done);
    return !stop_requested;
  };
}

} // namespace near_pairs

#endif // NEAR_PAIRS_PROGRESS_H
