// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What tasks cost that run in turn, as if there were many processors. The work is the time of all
// tasks. The span is the time that remains with any number of processors: that of the longest chain
// of tasks of which each has to wait for the one before. P processors that are never idle while
// there are tasks take at most work / P + span. [Graham: Bounds for certain multiprocessing
// anomalies, 1966]

#ifndef THICK_INTERSECTION_BENCHMARK_MANY_PROCESSORS_TASK_RECORD_H
#define THICK_INTERSECTION_BENCHMARK_MANY_PROCESSORS_TASK_RECORD_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <utility>
#include <vector>

namespace thick_benchmark {

// What is read between two tasks: the time, the bytes that are allocated, and the most that were
// allocated since the last reading.
struct Reading
{
  std::int64_t nanoseconds;
  std::int64_t bytes;
  std::int64_t most_bytes;
};

struct Cost
{
  double work = 0; // nanoseconds
  double span = 0;
  std::int64_t kept_bytes = 0; // what is allocated at the end, beyond the beginning
  std::int64_t most_bytes = 0; // at any time, beyond the beginning
};

// The segments of a run, between beginnings and ends of tasks, in the order in which they ran.
class Task_record
{
public:
  // What follows a segment: the first task of several, the next one, what follows the last one, or
  // nothing.
  enum class Mark { FORK, NEXT, JOIN, END };

  Task_record(std::size_t processors, std::function<Reading()> read)
    : processors_(processors), read_(std::move(read)), share_(processors), last_(read_())
  {}

  std::size_t processors() const { return processors_; }

  // Which processor would run the task that runs now.
  std::size_t processor() const { return processor_; }

  // Calls task(t) for t < count, which the processors of the calling task may do at the same time.
  // They share the tasks as evenly as they can.
  template <class Task>
  void run(std::size_t count, const Task& task)
  {
    if(count == 0)
      return;
    const std::size_t first = processor_;
    const std::size_t share = share_;
    end_segment(Mark::FORK);
    share_ = (std::max)(share / count, std::size_t(1));
    for(std::size_t t = 0; t < count; ++t) {
      processor_ = first + t * share / count;
      task(t);
      end_segment(t + 1 < count ? Mark::NEXT : Mark::JOIN);
    }
    processor_ = first;
    share_ = share;
  }

  void finish() { end_segment(Mark::END); }

  // Replaces the time of each segment by that of another run of the same tasks, if it is less. So
  // a segment is not charged with what interrupted one run.
  void take_least_times(const Task_record& other)
  {
    const auto same_mark = [](const Segment& a, const Segment& b) { return a.mark == b.mark; };
    if(!std::equal(segments_.begin(), segments_.end(), other.segments_.begin(),
                   other.segments_.end(), same_mark))
      throw std::runtime_error("two runs of the same search have other tasks");
    for(std::size_t s = 0; s < segments_.size(); ++s)
      segments_[s].nanoseconds
        = (std::min)(segments_[s].nanoseconds, other.segments_[s].nanoseconds);
  }

  Cost cost() const
  {
    auto segment = segments_.begin();
    return cost_of_chain(segment, processors_);
  }

private:
  struct Segment
  {
    Mark mark;
    std::int64_t nanoseconds;
    std::int64_t kept_bytes;
    std::int64_t most_bytes;
  };
  using Iterator = std::vector<Segment>::const_iterator;

  void end_segment(Mark mark)
  {
    const Reading now = read_();
    segments_.push_back({mark, now.nanoseconds - last_.nanoseconds, now.bytes - last_.bytes,
                         now.most_bytes - last_.bytes});
    last_ = read_(); // without the time of this function
  }

  // The cost of segments that follow each other, up to the end of their task, and of the tasks
  // between them. `segment` becomes the first one behind these. `processors` is how many run
  // these tasks.
  static Cost cost_of_chain(Iterator& segment, std::size_t processors)
  {
    Cost chain;
    for(;;) {
      const Segment& s = *segment++;
      append(chain, {double(s.nanoseconds), double(s.nanoseconds), s.kept_bytes, s.most_bytes});
      if(s.mark != Mark::FORK)
        return chain;
      append(chain, cost_of_tasks(segment, processors));
    }
  }

  static void append(Cost& chain, const Cost& next)
  {
    chain.work += next.work;
    chain.span += next.span;
    chain.most_bytes = (std::max)(chain.most_bytes, chain.kept_bytes + next.most_bytes);
    chain.kept_bytes += next.kept_bytes;
  }

  // The cost of tasks that run at the same time. Each processor may be where its task has allocated
  // most, while what other tasks keep is there already.
  static Cost cost_of_tasks(Iterator& segment, std::size_t processors)
  {
    Cost tasks;
    std::vector<std::int64_t> passing_bytes; // of each task
    const std::size_t own = (std::max)(processors / count_tasks(segment), std::size_t(1));
    do {
      const Cost task = cost_of_chain(segment, own);
      tasks.work += task.work;
      tasks.span = (std::max)(tasks.span, task.span);
      tasks.kept_bytes += task.kept_bytes;
      const std::int64_t kept = (std::max)(task.kept_bytes, std::int64_t(0));
      tasks.most_bytes += kept;
      passing_bytes.push_back(task.most_bytes - kept);
    } while(std::prev(segment)->mark == Mark::NEXT);
    std::sort(passing_bytes.begin(), passing_bytes.end(), std::greater<>());
    for(std::size_t t = 0; t < (std::min)(processors, passing_bytes.size()); ++t)
      tasks.most_bytes += passing_bytes[t];
    return tasks;
  }

  static std::size_t count_tasks(Iterator segment)
  {
    std::size_t count = 1;
    for(int depth = 0; depth > 0 || segment->mark != Mark::JOIN; ++segment) {
      depth += segment->mark == Mark::FORK;
      depth -= segment->mark == Mark::JOIN;
      count += depth == 0 && segment->mark == Mark::NEXT;
    }
    return count;
  }

  const std::size_t processors_;
  const std::function<Reading()> read_;
  std::size_t processor_ = 0;
  std::size_t share_; // how many processors the running task has, from this one on
  Reading last_;
  std::vector<Segment> segments_;
};

// The record of what runs now: that of the library's tasks.
inline Task_record*& current_record()
{
  static Task_record* record = nullptr;
  return record;
}

// Records a run of `function` by so many processors.
template <class Function>
Task_record record_tasks(std::size_t processors, const std::function<Reading()>& read,
                         const Function& function)
{
  Task_record record(processors, read);
  current_record() = &record;
  function();
  record.finish();
  current_record() = nullptr;
  return record;
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_MANY_PROCESSORS_TASK_RECORD_H
