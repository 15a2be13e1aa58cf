// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_PERIODIC_LATTICE_D_H
#define CGAL_PERIODIC_LATTICE_D_H

#include <CGAL/Dimension.h>
#include <CGAL/Kernel_traits.h>

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgThickIntersectionDRef

holds the periods of a domain that repeats: two vectors in the plane, or three in space, and which
of them repeat.

The vectors are the exact numbers that they are, in any directions: a skewed cell of a crystal, a
slab that repeats along two axes of space, a wire that repeats along one. They need not be short,
nor nearly orthogonal. Periodic searches take points anywhere, in the cell or not.

The periods of an `Iso_rectangle_2` or `Iso_cuboid_3` are the differences of its coordinates, which
are not rounded. A search with this lattice also takes points outside of the box, which a search
with the box itself refuses.

Several threads may read a lattice at once.

\tparam Vector is `Vector_2` or `Vector_3` of a kernel of \cgal.
*/
template <class Vector>
class Periodic_lattice_d
{
public:
  /// 2 or 3.
  static constexpr int dimension = Ambient_dimension<Vector>::type::value;

  /// The number type of the kernel.
  using FT = typename Kernel_traits<Vector>::Kernel::FT;

  /// For each vector, whether it repeats.
  using Axes = std::array<bool, static_cast<std::size_t>(dimension)>;

  /// takes the vectors. Those that do not repeat may be zero.
  explicit Periodic_lattice_d(
    const std::array<Vector, static_cast<std::size_t>(dimension)>& vectors,
    const Axes& repeats = all_axes())
    : repeats_(repeats)
  {
    for(int k = 0; k < dimension; ++k)
      for(int axis = 0; axis < dimension; ++axis)
        ends_[index(k)][index(axis)] = {FT(0), vectors[index(k)].cartesian(axis)};
  }

  /// takes the vectors of a lattice in the plane.
  Periodic_lattice_d(const Vector& v, const Vector& w)
    : Periodic_lattice_d(std::array<Vector, 2>{v, w})
  {}

  /// takes the vectors of a lattice in space.
  Periodic_lattice_d(const Vector& u, const Vector& v, const Vector& w)
    : Periodic_lattice_d(std::array<Vector, 3>{u, v, w})
  {}

  /// takes the sides of an `Iso_rectangle_2` or `Iso_cuboid_3`.
  template <class Iso_box, class = decltype(std::declval<const Iso_box&>().min_coord(0))>
  explicit Periodic_lattice_d(const Iso_box& box, const Axes& repeats = all_axes())
    : repeats_(repeats)
  {
    for(int k = 0; k < dimension; ++k) {
      ends_[index(k)].fill({FT(0), FT(0)});
      ends_[index(k)][index(k)] = {box.min_coord(k), box.max_coord(k)};
    }
  }

  /// returns whether vector `k` repeats.
  bool repeats(int k) const { return repeats_[index(k)]; }

  /// returns two numbers: component `axis` of vector `k` is the second minus the first.
  const std::pair<FT, FT>& ends(int k, int axis) const { return ends_[index(k)][index(axis)]; }

private:
  static constexpr std::size_t index(int i) { return static_cast<std::size_t>(i); }

  static constexpr Axes all_axes()
  {
    Axes axes{};
    for(std::size_t k = 0; k < axes.size(); ++k)
      axes[k] = true;
    return axes;
  }

  std::array<std::array<std::pair<FT, FT>, static_cast<std::size_t>(dimension)>,
             static_cast<std::size_t>(dimension)>
    ends_;
  Axes repeats_;
};

#ifndef DOXYGEN_RUNNING
template <class Iso_box, class = decltype(std::declval<const Iso_box&>().min_coord(0))>
explicit Periodic_lattice_d(const Iso_box&)
  -> Periodic_lattice_d<std::decay_t<decltype((std::declval<const Iso_box&>().max)()
                                              - (std::declval<const Iso_box&>().min)())>>;
template <class Iso_box, class = decltype(std::declval<const Iso_box&>().min_coord(0))>
Periodic_lattice_d(const Iso_box&,
                   const std::array<bool, Ambient_dimension<Iso_box>::type::value>&)
  -> Periodic_lattice_d<std::decay_t<decltype((std::declval<const Iso_box&>().max)()
                                              - (std::declval<const Iso_box&>().min)())>>;
template <class Vector, std::size_t Dimension>
explicit Periodic_lattice_d(const std::array<Vector, Dimension>&) -> Periodic_lattice_d<Vector>;
template <class Vector, std::size_t Dimension>
Periodic_lattice_d(const std::array<Vector, Dimension>&, const std::array<bool, Dimension>&)
  -> Periodic_lattice_d<Vector>;
template <class Vector>
Periodic_lattice_d(const Vector&, const Vector&, const Vector&) -> Periodic_lattice_d<Vector>;
#endif

} // namespace CGAL

#endif // CGAL_PERIODIC_LATTICE_D_H
