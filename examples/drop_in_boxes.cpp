// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Boxes in the place of CGAL::box_self_intersection_d(): radio transmissions in time and frequency.
// Doubles do not hold nanoseconds since 1970; 64-bit integers do.

#include <CGAL/thick_box_intersection_d.h>
#include <iostream>
#include <vector>

struct Transmission
{
  char station;
  long long low[2], high[2]; // nanoseconds, hertz

  static constexpr int dimension() { return 2; }
  long long min_coord(int i) const { return low[i]; }
  long long max_coord(int i) const { return high[i]; }
};

int main()
{
  const long long t = 1700000000000000000;
  const std::vector<Transmission> sent = {{'A', {t, 2400000000}, {t + 301, 2400020000}},
                                          {'B', {t + 301, 2400000000}, {t + 700, 2400020000}},
                                          {'C', {t + 302, 2400010000}, {t + 600, 2400030000}},
                                          {'D', {t, 2400030000}, {t + 900, 2400050000}}};
  const auto print = [](const Transmission& a, const Transmission& b) {
    std::cout << a.station << ' ' << b.station << '\n';
  };

  std::cout << "touch or overlap\n"; // boxes are closed
  CGAL::thick_box_self_intersection_d(sent.begin(), sent.end(), print);

  std::cout << "overlap\n"; // the upper ends do not belong to the boxes; the cutoff has no effect
  CGAL::thick_box_self_intersection_d(sent.begin(), sent.end(), print, 10,
                                      CGAL::Thick_box_intersection_d::HALF_OPEN);
}
