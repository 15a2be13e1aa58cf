#!/usr/bin/env bash
# Checks that the programs shown in README.md are those that are built and run: each C++ block is,
# line by line, an example program without its head of comments. And that the table of headers, in
# the manual, names each public header.
#
# SPDX-License-Identifier: LGPL-3.0-or-later
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."

shown=$(awk '/^```cpp$/ { inside = 1; next } /^```$/ { inside = 0 } inside' README.md)
built=$(sed '/^\/\//d' examples/near_points.cpp | sed '/./,$!d')

if [[ $shown != "$built" ]]; then
  echo "The program in README.md is not examples/near_points.cpp:" >&2
  diff <(echo "$built") <(echo "$shown") >&2 || true
  exit 1
fi

manual=doc/Thick_intersection_d/Thick_intersection_d.txt
named=$(awk -F '|' '/^\\section/ { inside = $0 ~ /thickHeaders/ } inside && /^\|/ { print $2 }' \
            "$manual")

fail=0
for header in include/CGAL/*.h; do
  if ! grep -qF "\`CGAL/${header##*/}\`" <<< "$named"; then
    echo "The section Headers of $manual does not name CGAL/${header##*/}." >&2
    fail=1
  fi
done
exit "$fail"
