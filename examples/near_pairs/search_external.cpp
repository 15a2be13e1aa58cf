// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The search of points that are read when they are needed; see external.h.

#include "external.h"

#include "bound.h"
#include "error.h"
#include "input.h"
#include "point_stream.h"
#include "progress.h"

#include <CGAL/Memory_budget.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/external_fixed_radius_near_neighbors.h>
#include <CGAL/tags.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <mutex>
#include <type_traits>
#include <utility>

namespace near_pairs {
namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;

// The points of a file as a range. Each pass reads the file anew.
class Streamed_points
{
public:
  class Iterator
  {
  public:
    using iterator_category = std::input_iterator_tag;
    using value_type = Point;
    using difference_type = std::ptrdiff_t;
    using pointer = const Point*;
    using reference = Point;

    Iterator() = default;
    Iterator(std::shared_ptr<Point_stream> stream, External_result& result)
      : stream_(std::move(stream)), result_(&result)
    {
      result.points = 0;
      read();
    }

    Point operator*() const { return Point(x_[0], x_[1], x_[2]); }

    Iterator& operator++()
    {
      read();
      return *this;
    }

    bool operator==(const Iterator& other) const { return stream_ == other.stream_; }
    bool operator!=(const Iterator& other) const { return stream_ != other.stream_; }

  private:
    void read()
    {
      if(stream_->next(x_)) {
        ++result_->points;
        return;
      }
      result_->unit = stream_->unit();
      result_->frame = stream_->frame();
      stream_.reset();
    }

    std::shared_ptr<Point_stream> stream_; // none at the end
    External_result* result_ = nullptr;
    std::array<double, 3> x_ = {};
  };

  // Counts the points of the last pass in `result`.
  Streamed_points(const Input& input, const Read_options& options, External_result& result)
    : input_(input), options_(options), result_(result)
  {}

  Iterator begin() const
  {
    return Iterator(std::make_shared<Point_stream>(input_, options_), result_);
  }
  Iterator end() const { return Iterator(); }

private:
  const Input& input_;
  const Read_options& options_;
  External_result& result_;
};

// Returns false iff the search was stopped.
template <class ConcurrencyTag>
bool report_pairs(const Streamed_points& points, const Options& options,
                  const CGAL::Memory_budget& budget, External_result& result,
                  const External_sink& sink)
{
  std::mutex mutex;
  const auto callback = [&](std::uint64_t i, std::uint64_t j) {
    std::unique_lock<std::mutex> lock(mutex, std::defer_lock);
    if(!std::is_same_v<ConcurrencyTag, CGAL::Sequential_tag>) // then several threads may call
      lock.lock();
    ++result.pairs;
    if(sink)
      sink(i, j);
  };
  const auto go_on = progress_functor(options.progress);
  return CGAL::external_fixed_radius_near_neighbors<ConcurrencyTag>(
    points, bound_of(options), budget, callback, CGAL::parameters::callback(go_on));
}

} // namespace

External_result search_external(const Options& options, std::size_t bytes,
                                const External_sink& sink)
{
  const Input input(options.files.front());
  const CGAL::Memory_budget budget
    = options.scratch.empty() ? CGAL::Memory_budget(bytes)
                              : CGAL::Memory_budget(bytes, options.scratch);
  External_result result;
  result.guessed = Point_stream(input, options.readings.front()).guessed();
  const Streamed_points points(input, options.readings.front(), result);
  const auto start = std::chrono::steady_clock::now();
#ifdef CGAL_LINKED_WITH_TBB
  const bool is_complete
    = options.parallel
        ? report_pairs<CGAL::Parallel_tag>(points, options, budget, result, sink)
        : report_pairs<CGAL::Sequential_tag>(points, options, budget, result, sink);
#else
  const bool is_complete
    = report_pairs<CGAL::Sequential_tag>(points, options, budget, result, sink);
#endif
  if(!is_complete)
    throw Error("stopped");
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

} // namespace near_pairs
