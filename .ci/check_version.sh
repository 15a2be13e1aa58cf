#!/usr/bin/env bash
# Checks that the files that repeat the version have that of CGAL/Thick_intersection_d/version.h: the
# number beside the string, the manual, CHANGES.md, CITATION.cff, the port for vcpkg and the packages
# for Debian.
#
# Prints each file that differs; exits with 1 if there is one.
#
# SPDX-License-Identifier: LGPL-3.0-or-later
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."

header=include/CGAL/Thick_intersection_d/version.h
version=$(sed -nE 's/^#define CGAL_THICK_INTERSECTION_D_VERSION "([0-9.]+)"$/\1/p' "$header")
[[ $version =~ ^([0-9]+)\.([0-9]+)\.([0-9])$ ]] ||
  { echo "$header: '$version' is not major.minor.patch with a patch number below 10" >&2; exit 1; }
# As CGAL_VERSION_NUMBER, which has one digit for the patch number.
number=$((1000001000 + 10000000 * BASH_REMATCH[1] + 100000 * BASH_REMATCH[2] +
          10000 * BASH_REMATCH[3]))

fail=0
expect() {  # file, what it is to say, an expression that prints what it says
  local said
  said=$(sed -nE "$3" "$1" | head -n 1)
  if [[ $said != "$2" ]]; then
    echo "$1: '$said' instead of $2" >&2
    fail=1
  fi
}

expect "$header" "$number" 's/^#define CGAL_THICK_INTERSECTION_D_VERSION_NR ([0-9]+)$/\1/p'
expect doc/Doxyfile "$version" 's/^PROJECT_NUMBER *= *(.*)$/\1/p'
expect CHANGES.md "$version" 's/^## ([^ ]*).*$/\1/p'
expect CITATION.cff "$version" 's/^version: *(.*)$/\1/p'
expect debian/changelog "$version" 's/^thick-intersection-d [(](.*)[)] .*$/\1/p'
expect packaging/vcpkg/vcpkg.json "$version" 's/^ *"version-semver": "(.*)",$/\1/p'

exit $fail
