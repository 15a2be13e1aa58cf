// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_NEAR_BOXES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_NEAR_BOXES_H

// The boxes of all parts, and those that are near the boxes of one part.

#include <CGAL/Thick_intersection_d/internal/input/Interval.h>
#include <CGAL/Thick_intersection_d/internal/parts/Byte_reader.h>
#include <CGAL/Thick_intersection_d/internal/parts/Part_box.h>
#include <CGAL/Thick_intersection_d/internal/parts/receives.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Writes the boxes that have points, and how many there are.
inline void write_boxes(const std::vector<Part_box>& boxes, std::vector<char>& bytes)
{
  const std::uint64_t count = static_cast<std::uint64_t>(
    std::count_if(boxes.begin(), boxes.end(), [](const Part_box& box) { return !box.is_empty(); }));
  write_bytes(&count, 1, bytes);
  for(const Part_box& box : boxes)
    if(!box.is_empty())
      write_bytes(box.intervals().data(), box.intervals().size(), bytes);
}

// Returns the boxes of one part after another.
inline std::vector<std::vector<Part_box>> read_boxes_of_parts(const std::vector<char>& bytes,
                                                              int dimension)
{
  std::vector<std::vector<Part_box>> boxes;
  for(Byte_reader reader(bytes); !reader.is_at_end();) {
    std::uint64_t count;
    reader.read(&count, 1);
    boxes.emplace_back();
    for(std::uint64_t i = 0; i < count; ++i) {
      std::vector<Interval> intervals(static_cast<std::size_t>(dimension));
      reader.read(intervals.data(), intervals.size());
      boxes.back().emplace_back(std::move(intervals));
    }
  }
  return boxes;
}

// Finds the parts that receive a point of one part: it is near one of their boxes.
class Near_boxes
{
public:
  // `all[i]` are the boxes of part i, and `mine` those of `part`.
  Near_boxes(const std::vector<Part_box>& mine, int part,
             const std::vector<std::vector<Part_box>>& all, double reach)
    : reach_(reach), near_(mine.size())
  {
    for(std::size_t m = 0; m < mine.size(); ++m)
      for(std::size_t other = 0; other < all.size(); ++other)
        if(!mine[m].is_empty() && receives(static_cast<int>(other), part))
          for(const Part_box& box : all[other])
            if(box.is_near(mine[m], reach))
              near_[m].push_back({other, &box});
  }

  // Calls visit(part) for each part that receives a point. The point is in box `m` of its own part.
  template <class Point, class Visit>
  void for_receivers(std::size_t m, const Point& point, const Visit& visit) const
  {
    const std::vector<Other_box>& others = near_[m];
    for(std::size_t i = 0; i < others.size();) {
      const std::size_t part = others[i].part;
      bool is_near = false;
      for(; i < others.size() && others[i].part == part; ++i)
        is_near = is_near || others[i].box->is_near(point, reach_);
      if(is_near)
        visit(part);
    }
  }

private:
  struct Other_box
  {
    std::size_t part;
    const Part_box* box;
  };

  double reach_;
  std::vector<std::vector<Other_box>> near_; // of each box, in the order of parts
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_NEAR_BOXES_H
