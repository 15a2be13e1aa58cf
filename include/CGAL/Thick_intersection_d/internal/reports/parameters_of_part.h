// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_PARAMETERS_OF_PART_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_PARAMETERS_OF_PART_H

// The progress of a search that consists of searches.

#include <CGAL/Named_function_parameters.h>

#include <type_traits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Tells the functor of a search how far one part of the search is.
template <class Functor>
struct Part_of_progress
{
  Functor functor;
  double start;
  double end;
  bool* is_cancelled; // null, or becomes true if the functor cancels the part

  bool operator()(double done)
  {
    const bool goes_on = functor(done == 1 ? end : start + (end - start) * done); // not rounded
    if(is_cancelled != nullptr && !goes_on)
      *is_cancelled = true;
    return goes_on;
  }
};

// Returns the named parameters of a part of a search.
template <class NamedParameters>
auto parameters_of_part([[maybe_unused]] const NamedParameters& np, [[maybe_unused]] double start,
                        [[maybe_unused]] double end,
                        [[maybe_unused]] bool* is_cancelled = nullptr)
{
  if constexpr(parameters::is_default_parameter<NamedParameters, internal_np::callback_t>::value)
    return parameters::default_values();
  else {
    const auto& functor = parameters::get_parameter(np, internal_np::callback);
    using Part = Part_of_progress<std::decay_t<decltype(functor)>>;
    return parameters::callback(Part{functor, start, end, is_cancelled});
  }
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_PARAMETERS_OF_PART_H
