#!/usr/bin/env bash
# Checks that the public headers reach, through whatever they include, no file of CGAL under the
# GPL alone: a program that uses them stays free of it.
#
#   .ci/check_licences.sh <compiler> <option>...      options: language version, -I and -D
#
# SPDX-License-Identifier: LGPL-3.0-or-later
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."

mapfile -t reached < <(
  find include/CGAL -maxdepth 1 -name '*.h' | sort | sed 's|^include/\(.*\)|#include <\1>|' |
    sed 's|^.*/distributed_.*|#if __has_include(<mpi.h>)\n&\n#endif|' |
    "$@" -Iinclude -x c++ -M - | tr ' ' '\n' | grep '/CGAL/.*\.h$' | sort -u)
(( ${#reached[@]} > 100 )) || { echo "The compiler listed no headers of CGAL." >&2; exit 1; }

if grep -lE 'SPDX-License-Identifier: GPL' "${reached[@]}" >&2; then
  echo "These files are reached, and they are under the GPL." >&2
  exit 1
fi
echo "None of the ${#reached[@]} headers reached is under the GPL."
