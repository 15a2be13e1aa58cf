// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_COMMUNICATOR_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_COMMUNICATOR_H

// The processes that search together. Only the files of this room call MPI.

#include <mpi.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A duplicate of the user's communicator, so that no message of the user is mistaken for one of a
// search. Making one is collective, and so is destroying it: either all processes throw or none.
class Communicator
{
public:
  explicit Communicator(MPI_Comm original)
  {
    check(original);
    if(const int error = MPI_Comm_dup(original, &comm_)) // where the user has errors returned
      MPI_Abort(original, error);
    MPI_Comm_set_errhandler(comm_, MPI_ERRORS_ARE_FATAL);
    MPI_Comm_rank(comm_, &rank_);
    MPI_Comm_size(comm_, &size_);
  }
  Communicator(const Communicator&) = delete;
  Communicator& operator=(const Communicator&) = delete;
  ~Communicator() { MPI_Comm_free(&comm_); }

  MPI_Comm get() const { return comm_; }
  int rank() const { return rank_; }
  int size() const { return size_; }

  // Returns the least of the numbers of all processes.
  int least(int number) const
  {
    MPI_Allreduce(MPI_IN_PLACE, &number, 1, MPI_INT, MPI_MIN, comm_);
    return number;
  }

  // Adds up the numbers of all processes, place by place.
  void add_up(std::vector<std::uint64_t>& numbers) const
  {
    MPI_Allreduce(MPI_IN_PLACE, numbers.data(), static_cast<int>(numbers.size()), MPI_UINT64_T,
                  MPI_SUM, comm_);
  }

  // Sets `all` to the values of all processes, one process after another. It has room for them, so
  // that nothing is allocated while other processes wait.
  template <class Value>
  void gather(const Value* mine, std::size_t count, std::vector<Value>& all) const
  {
    const int bytes = static_cast<int>(count * sizeof(Value));
    MPI_Allgather(mine, bytes, MPI_BYTE, all.data(), bytes, MPI_BYTE, comm_);
  }

private:
  static void check(MPI_Comm original)
  {
    int is_initialized = 0, is_finalized = 0;
    MPI_Initialized(&is_initialized);
    MPI_Finalized(&is_finalized);
    if(!is_initialized || is_finalized)
      throw std::logic_error("MPI is not initialized, or no longer.");
    int is_inter = 0;
    MPI_Comm_test_inter(original, &is_inter);
    if(is_inter)
      throw std::invalid_argument("The communicator must be an intracommunicator.");
  }

  MPI_Comm comm_;
  int rank_ = 0;
  int size_ = 1;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_COMMUNICATOR_H
