// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "polygon_generators.h"

#include "support/point_generators.h"

#include <algorithm>
#include <cmath>

namespace thick_benchmark {

namespace {

using test_support::Random;

using Node = std::array<double, 2>;

// A lattice of quadrangles.
struct Lattice
{
  std::size_t side;
  std::vector<Node> nodes;

  explicit Lattice(std::size_t count)
    : side(static_cast<std::size_t>(std::sqrt(static_cast<double>(count))) + 1)
  {
    Random random(1);
    for(std::size_t y = 0; y <= side; ++y)
      for(std::size_t x = 0; x <= side; ++x)
        nodes.push_back({static_cast<double>(x) + .4 * random.uniform(),
                         static_cast<double>(y) + .4 * random.uniform()});
  }

  const Node& at(std::size_t x, std::size_t y) const { return nodes[y * (side + 1) + x]; }

  // Calls a function with the corners of each quadrangle.
  template <class Function>
  void for_each(const Function& function) const
  {
    for(std::size_t y = 0; y < side; ++y)
      for(std::size_t x = 0; x < side; ++x)
        function(Ring{at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)});
  }
};

constexpr std::size_t edges_of_border = 50;

// Appends the border from p to q without q. It is the same one from q to p.
void append_border(Ring& ring, const Node& p, const Node& q)
{
  const bool is_forward = p < q;
  const Node& first = is_forward ? p : q;
  const Node& last = is_forward ? q : p;
  Random random(static_cast<std::uint64_t>(1e6 * (first[0] + 1000 * last[1])));
  Ring border;
  for(std::size_t k = 0; k <= edges_of_border; ++k) {
    const double part = static_cast<double>(k) / edges_of_border;
    const bool is_end = k == 0 || k == edges_of_border;
    Node node;
    for(std::size_t axis = 0; axis < 2; ++axis)
      node[axis] = first[axis] + part * (last[axis] - first[axis])
                   + (is_end ? 0 : .004 * (random.uniform() - .5));
    border.push_back(node);
  }
  border.back() = last;
  if(!is_forward)
    std::reverse(border.begin(), border.end());
  ring.insert(ring.end(), border.begin(), border.end() - 1);
}

} // namespace

Rings parcels(std::size_t n)
{
  Rings rings;
  Lattice(n / 4).for_each([&](const Ring& corners) { rings.push_back(corners); });
  return rings;
}

Rings triangles_of_parcels(std::size_t n)
{
  Rings rings;
  Lattice(n / 6).for_each([&](const Ring& corners) {
    rings.push_back({corners[0], corners[1], corners[2]});
    rings.push_back({corners[0], corners[2], corners[3]});
  });
  return rings;
}

Rings parcels_of_long_borders(std::size_t n)
{
  Rings rings;
  Lattice(n / (4 * edges_of_border)).for_each([&](const Ring& corners) {
    Ring ring;
    for(std::size_t k = 0; k < 4; ++k)
      append_border(ring, corners[k], corners[(k + 1) % 4]);
    rings.push_back(ring);
  });
  return rings;
}

Rings stars(std::size_t n)
{
  Random random(2);
  Rings rings;
  const double side = std::sqrt(static_cast<double>(n) / 17.5);
  for(std::size_t vertices = 0; vertices < n; vertices += rings.back().size()) {
    const Node center = {side * random.uniform(), side * random.uniform()};
    const double size = rings.size() % 50 == 0 ? 4 : 1;
    Ring ring(3 + random.below(30));
    for(std::size_t k = 0; k < ring.size(); ++k) {
      const double angle = 2 * 3.141592653589793 * static_cast<double>(k)
                           / static_cast<double>(ring.size());
      const double radius = size * (.3 + .3 * random.uniform());
      ring[k] = {center[0] + radius * std::cos(angle), center[1] + radius * std::sin(angle)};
    }
    rings.push_back(ring);
  }
  return rings;
}

} // namespace thick_benchmark
