#!/usr/bin/env bash
# Checks what the headers include and name: includes point one way (public headers to internal
# ones, no cycles), TBB is named in one file, no part of CGAL under the GPL is included, and some
# things have no place in a header at all. Prints each offending line; exits with 1 if there is one.
#
# SPDX-License-Identifier: LGPL-3.0-or-later
set -euo pipefail
export LC_ALL=C.UTF-8

cd "$(dirname "${BASH_SOURCE[0]}")/../include"

internal=CGAL/Thick_intersection_d
parallel=$internal/internal/machine/parallel.h
# The public headers that name the things which the internal ones work on.
vocabulary='Arithmetic_tier|Distance_bound|Neighbor_lists|Scene_profile'
# Parts of CGAL under the GPL that are near at hand here. The test `licences` follows every include.
gpl='license/|box_intersection_d|Box_intersection_d/|Kd_tree|Fuzzy_|Search_traits|Orthogonal_|Orthtree'
gpl+='|Delaunay|Triangulation|Regular_triangulation|Point_set_2|point_set|Point_set_processing_3/|AABB_'

fail=0
forbid() {  # reason; the offending lines on standard input
  local line
  while IFS= read -r line; do
    echo "include/$line    <- $1" >&2
    fail=1
  done
}

# The lines of our headers that match, as file:line:text; none is not an error here.
find_lines() {  # extended regular expression, grep option...
  local expression=$1
  shift
  grep -rnE --include='*.h' "$@" -e "$expression" CGAL || true
}

mapfile -t headers < <(find CGAL -name '*.h' | sort)
(( ${#headers[@]} > 0 )) || { echo "No headers found." >&2; exit 1; }

# One way: internal headers include internal ones and the vocabulary.
public=$(find CGAL -maxdepth 1 -name '*.h' -printf '%f\n' | sed 's/\.h$//' |
         { grep -vxE "$vocabulary" || true; } | paste -sd '|')
if [[ -n $public ]]; then
  forbid 'an internal header includes a public one' < <(
    find_lines "^ *# *include *[<\"]CGAL/($public)\.h[>\"]" | grep "^$internal/")
fi

# No cycles: tsort names the headers of a cycle, given the pairs (header, included header).
forbid 'these headers include each other in a circle' < <(
  for header in "${headers[@]}"; do
    sed -nE 's|^ *# *include *[<"](CGAL/[^>"]*)[>"].*|\1|p' "$header" |
      while read -r included; do
        if [[ -f $included ]]; then echo "$header $included"; fi
      done
  done | tsort 2>&1 > /dev/null | sed -nE 's|^tsort: (CGAL/)|\1|p')

forbid "only $parallel names TBB" < <(
  find_lines '(tbb::|include *[<"](oneapi/)?tbb|CGAL_LINKED_WITH_TBB)' | grep -v "^$parallel:")
forbid 'this part of CGAL is under the GPL' < <(
  find_lines "^ *# *include *[<\"]CGAL/($gpl)")
forbid 'no using-directive in a header' < <(
  find_lines '^ *using +namespace')
forbid 'a header prints nothing' < <(
  find_lines 'std::(cout|cerr|clog)|include *<iostream>')
forbid 'CGAL_assertion or an exception instead' < <(
  find_lines '(^|[^_[:alnum:]])(assert|abort|exit) *\(')
forbid 'nothing unfinished' < <(
  find_lines 'TODO|FIXME|XXX|^ *# *if +0')
forbid 'write (std::min)(...): windows.h has macros of these names' < <(
  find_lines 'std::(min|max) *(<[^>]*>)? *\(|>::(min|max) *\(')

exit $fail
