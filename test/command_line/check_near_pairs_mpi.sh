#!/usr/bin/env bash
# Copyright (c) 2026 The Thick_intersection_d authors.
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Checks that several processes of the example near_pairs_mpi find the pairs of near_pairs.
#
#   check_near_pairs_mpi.sh NEAR_PAIRS_MPI NEAR_PAIRS MPIEXEC NUMBER_FLAG
#
# Prints a line per check and a count at the end; the status is 1 if a check failed.

set -u

program=$(realpath "$1")
near_pairs=$(realpath "$2")
mpiexec=$3
number_flag=$4
directory=$(mktemp -d)
trap 'rm -rf "$directory"' EXIT
cd "$directory" || exit 2

# Open MPI starts more processes than there are processors, as any user. The preset sanitize would
# take memory that Open MPI leaves behind for a leak of the program.
export LSAN_OPTIONS=detect_leaks=0
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_mpi_yield_when_idle=1
export OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_btl_vader_single_copy_mechanism=none

passed=0
failed=0

verdict() { # NAME TEST...
  local name=$1
  shift
  if "$@"; then
    passed=$((passed + 1))
    echo "ok      $name"
  else
    failed=$((failed + 1))
    echo "FAILED  $name"
    sed 's/^/        stdout: /' out | head -n 5
    sed 's/^/        stderr: /' err | head -n 5
  fi
}

run() { # PROCESSES ARGUMENT...
  local processes=$1
  shift
  rm -f found.*
  timeout 60 "$mpiexec" "$number_flag" "$processes" "$program" "$@" > out 2> err
  status=$?
}

sorted_pairs() { # FILE
  cut -d, -f1,2 "$1" | grep -v '^i' | sort
}

has_pairs_of() { # FILE
  cat found.*.csv > found
  [ "$status" -eq 0 ] && [ -s "$1" ] && [ "$(sorted_pairs found)" = "$(sorted_pairs "$1")" ]
}

fails_with() { # MESSAGE
  [ "$status" -ne 0 ] && [ "$status" -ne 124 ] && [ ! -s out ] && grep -qF -- "$1" err
}

# Lines of many lengths, so that shares of the file begin anywhere in a line.
awk 'BEGIN { srand(1); print "x,y,z"; print "# points"
             for(i = 0; i < 3000; ++i) printf "%.*g, %.17g,%g\n", i % 17 + 1, rand(), rand(), rand() }' \
  > points.csv
"$near_pairs" points.csv --distance 0.05 --pairs csv_pairs.csv > /dev/null || exit 2
head -c 72000 /dev/zero > points.bin
"$near_pairs" points.bin --distance 0 --pairs /dev/null > out || exit 2
equal_pairs=$(sed -n 's/^pairs  *//p' out)
printf 'x,y\n1,2\n3,4,5,6\n' > long.csv

for processes in 1 2 5; do
  run $processes points.csv --distance 0.05 --pairs found
  verdict "lines, $processes processes" has_pairs_of csv_pairs.csv
  run $processes points.csv --distance 0.05 --as-is --pairs found
  verdict "  where they are read" has_pairs_of csv_pairs.csv
  verdict "  with a profile of each" test "$(grep -c '"rank": ' out)" = $processes
  run $processes points.bin --distance 0
  verdict "binary points, $processes processes" grep -qF "\"pairs\": $equal_pairs," out
  run $processes long.csv --distance 1
  verdict "a line that is too long, $processes processes" fails_with "has not two or three numbers"
done
printf 'x;y\n1,5;2\n' > commas.csv
run 2 commas.csv --distance 1
verdict "decimals with commas" fails_with "has ',' and ';'"
run 2 missing.bin --distance 1
verdict "no file" fails_with "missing.bin: "
run 2 points.csv --distance 1 --pairs no/such/place
verdict "no place for pairs" fails_with "no/such/place."
run 2 points.csv
verdict "no distance" fails_with "give a file and --distance"

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
