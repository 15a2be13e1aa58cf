#!/usr/bin/env bash
# Measures the distributed search on processes of this machine, and prints tables in Markdown.
#
#   measure.sh <program distributed_table> [--quick] [<table>]...
#
# Tables are threads, trees and memory; all of them if none is named. trees is left out if the
# program was built without ArborX.
#
# SPDX-License-Identifier: LGPL-3.0-or-later
set -euo pipefail

program=$1
shift
options=()
if [ "${1:-}" = --quick ]; then
  options=(--quick)
  shift
fi
tables=("${@:-threads trees memory}")

# Open MPI starts more processes than there are processors, and binds none of them to a processor:
# two threads of one process are to find two. Processes that wait leave their processor to others.
export OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_hwloc_base_binding_policy=none
export OMPI_MCA_mpi_yield_when_idle=1
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 # as in a container

rows() {  # table, number of processes...
  local table=$1
  shift
  for processes in "$@"; do
    mpiexec -n "$processes" "$program" "$table" "${options[@]}"
  done
}

rows facts 1
for table in ${tables[*]}; do
  echo
  case $table in
    threads)
      echo "| scene | n | k | ms of 1 process | of 2 threads | of 2 processes | of 2, as is |\
 machine | 2 threads | 2 processes | 2, as is | processes / threads |"
      echo "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|"
      rows threads 2 ;;
    trees)
      echo "| scene | n | k | processes | pairs more | ms of ours | of ArborX | ours / ArborX |"
      echo "|---|--:|--:|--:|--:|--:|--:|--:|"
      rows trees 1 2 4 ;;
    memory)
      echo "| processes | points on each | bytes / point, the points | the peak |"
      echo "|--:|--:|--:|--:|"
      rows memory 1 2 4 8 ;;
  esac
done
