#!/usr/bin/env bash
# Copyright (c) 2026 The Thick_intersection_d authors.
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Checks that a process that the system kills in a search ends the whole job, in seconds and with an
# error.
#
#   check_killed_process.sh TEST_DISTRIBUTED_NEAR_NEIGHBORS MPIEXEC NUMBER_FLAG

set -u

seconds=20
output=$(timeout -k 5 "$seconds" "$2" "$3" 4 "$1" --run_test=a_killed_process_ends_the_job 2>&1)
status=$?
echo "$output"
echo "status $status after $SECONDS seconds"
# timeout has the status 124 if it stopped the job, and 137 if it had to kill it.
[[ $output == *"is killed now"* && $status -ne 0 && $status -ne 124 && $SECONDS -lt $seconds ]]
