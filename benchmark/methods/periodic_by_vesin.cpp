// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// vesin (https://github.com/Luthaf/vesin), a list of neighbors for simulations of atoms, by cells.

#include "periodic_methods.h"

#include <vesin.h>

#include <stdexcept>

namespace thick_benchmark {

namespace {

class Vesin_list
{
public:
  Vesin_list(const Periodic_scene& scene, bool is_full)
  {
    VesinOptions options = {};
    options.cutoff = scene.r;
    options.full = is_full;
    options.algorithm = VesinAutoAlgorithm;
    options.n_threads = 1;
    options.return_shifts = true;
    double box[3][3];
    for(std::size_t k = 0; k < 3; ++k)
      for(std::size_t axis = 0; axis < 3; ++axis)
        box[k][axis] = scene.vectors[k][axis];
    const bool periodic[3] = {true, true, true};
    const char* error = nullptr;
    const auto* points = reinterpret_cast<const double(*)[3]>(scene.points.data());
    if(vesin_neighbors(points, scene.points.size(), box, periodic, VesinDevice{VesinCPU}, options,
                       &list_, &error) != 0)
      throw std::runtime_error(error);
  }
  ~Vesin_list() { vesin_free(&list_); }
  Vesin_list(const Vesin_list&) = delete;
  Vesin_list& operator=(const Vesin_list&) = delete;

  std::size_t size() const { return list_.length; }

  // Of a full list, the pairs in one order.
  Image_pairs pairs(bool is_full) const
  {
    Image_pairs pairs;
    for(std::size_t k = 0; k < list_.length; ++k) {
      const auto& shift = list_.shifts[k];
      const Image_pair pair(list_.pairs[k][0], list_.pairs[k][1],
                            Offset{shift[0], shift[1], shift[2]});
      const Image_pair in_order = ordered(pair);
      if(!is_full || pair == in_order)
        pairs.push_back(in_order);
    }
    return pairs;
  }

private:
  VesinNeighborList list_;
};

Periodic_method method(const char* name, bool is_full)
{
  return {name, true, [=](const Periodic_scene& scene) {
            return Periodic_run{[=, &scene] { return Vesin_list(scene, is_full).size(); },
                                [=, &scene] { return Vesin_list(scene, is_full).pairs(is_full); }};
          }};
}

} // namespace

Periodic_method vesin_half_list() { return method("vesin, half list", false); }
Periodic_method vesin_full_list() { return method("vesin, full list", true); }

} // namespace thick_benchmark
