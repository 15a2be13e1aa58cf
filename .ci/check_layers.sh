#!/usr/bin/env bash
# Checks what the headers include and name. Each room includes the rooms and the public headers that
# the table in doc/design.md allows, and directly what it uses; there are no cycles. oneTBB, calls of
# an operating system and processor instructions stand in one room each. No part of CGAL under the
# GPL is included, and some things have no place in a header at all.
#
# Prints each offending line; exits with 1 if there is one.
#
# SPDX-License-Identifier: LGPL-3.0-or-later
set -euo pipefail
export LC_ALL=C.UTF-8

top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$top/include"

internal=CGAL/Thick_intersection_d/internal
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
  grep -rnE --include='*.h' --include='*.inc' "$@" -e "$expression" CGAL || true
}

mapfile -t headers < <(find CGAL -name '*.h' -o -name '*.inc' | sort)
(( ${#headers[@]} > 0 )) || { echo "No headers found." >&2; exit 1; }

# The table of rooms: may_include[room] has words such as internal/input/ and CGAL/Neighbor_lists.h.
declare -A may_include=()
rooms=()
while IFS='|' read -r _ room others vocabulary _; do
  room=$(tr -d ' \`' <<< "$room")
  words=" $internal/$room"
  for other in $others; do
    [[ " ${rooms[*]} " == *" $other/ "* ]] ||
      { echo "doc/design.md: $room may include $other/, which does not stand above it." >&2; exit 1; }
    words+=" $internal/$other/"
  done
  for header in $(tr -d '\`' <<< "$vocabulary"); do words+=" CGAL/$header"; done
  may_include[$room]="$words "
  rooms+=("$room")
done < <(sed -n '/^| room | may include rooms/,/^$/p' "$top/doc/design.md" | grep '^| `')
(( ${#rooms[@]} > 0 )) || { echo "doc/design.md has no table of rooms." >&2; exit 1; }

# The includes of our headers by our headers, as lines "header included". One process reads them all:
# a process for each header would take longer than all other checks.
includes=$(awk '/^ *# *include *[<"]CGAL\// {
    sub(/^ *# *include *[<"]/, "")
    sub(/[>"].*/, "")
    print FILENAME, $0
  }' "${headers[@]}" | while read -r header included; do
    if [[ -f $included ]]; then echo "$header $included"; fi
  done)

for header in "${headers[@]}"; do
  [[ $header == "$internal"/* ]] || continue
  folder=${header#"$internal"/}
  [[ -n ${may_include[${folder%/*}/]-} ]] ||
    forbid "${folder%/*}/ is not in the table of rooms" <<< "$header"
done
while read -r header included; do
  [[ $header == "$internal"/* ]] || continue
  folder=${header#"$internal"/}
  folder=${folder%/*}/
  target=$included
  [[ $included != "$internal"/* ]] || target=${included%/*}/
  [[ ${may_include[$folder]-} == *" $target "* ]] ||
    forbid "$folder may not include it" <<< "$header: $included"
done <<< "$includes"

# What a header uses, it includes.
# The lanes of instruction sets have the same names, so they are left out.
mapfile -t named < <(printf '%s\n' "${headers[@]}" | grep -vE '\.inc$|/lanes_[a-z0-9]+\.h$')
forbid 'is used here and not included' < <(
  awk -f "$top/.ci/check_includes.awk" "${named[@]}" "${named[@]}" | sort)

# No cycles: tsort names the headers of a cycle, given the pairs (header, included header).
forbid 'these headers include each other in a circle' < <(
  tsort <<< "$includes" 2>&1 > /dev/null | sed -nE 's|^tsort: (CGAL/)|\1|p')

forbid 'only machine/ names oneTBB and calls an operating system' < <(
  find_lines '(tbb::|include *[<"](oneapi/)?tbb|CGAL_LINKED_WITH_TBB|madvise|include *<sys/|fcntl|unistd)' |
    grep -v "^$internal/machine/")
forbid 'only distributed/ calls MPI, and one public header takes a communicator' < <(
  find_lines '(^|[^_[:alnum:]])MPI_[A-Z]' | grep -v "^$internal/distributed/" |
    grep -v '^CGAL/distributed_fixed_radius_near_neighbors.h:')
forbid 'only lanes/ has processor instructions' < <(
  find_lines '(_mm[0-9]*_|__m[0-9]+|immintrin|arm_neon|__builtin_(ia32|cpu)|target *\(")' |
    grep -v "^$internal/lanes/")
forbid 'the recursion knows no number, kernel or named parameter' < <(
  find_lines '(Named_function|parameters::|coordinate\(|cartesian|Exact_)' |
    grep "^$internal/recursion/")
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
forbid 'a function has at most 35 lines' < <(
  awk -v limit=35 -f "$top/.ci/check_functions.awk" "${headers[@]}")
forbid 'a header has at most 300 lines' < <(
  wc -l "${headers[@]}" | awk '$2 != "total" && $1 > 300 { print $2 ": " $1 " lines" }')

exit $fail
