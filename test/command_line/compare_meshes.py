#!/usr/bin/env python3
# Copyright (c) 2026 The Thick_intersection_d authors.
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Compares the vertices that near_pairs reads of meshes with those that CGAL reads.

  compare_meshes.py NEAR_PAIRS PRINT_VERTICES FILE...

PRINT_VERTICES is the program of print_vertices.cpp. doc/readers.md has the files and the figures.
CGAL rounds numbers to floats where a PLY file says so, and so both sides are rounded. Prints what
differs, and ends with the status 1 if the readers read something different; that only one of them
reads a file is no fault.
"""

import collections
import struct
import subprocess
import sys

import compare_tables


def as_floats(point):
    layout = f"{len(point)}f"
    return struct.unpack(layout, struct.pack(layout, *map(float, point)))


def by_near_pairs(program, file):
    """The vertices of a file; a string if it is refused."""
    points = compare_tables.points_of(program, file, [])
    return points if isinstance(points, str) else [as_floats(x) for _, *x in points]


def by_cgal(program, file):
    run = subprocess.run([program, file], capture_output=True, text=True, check=False)
    if run.returncode < 0:
        return "CGAL stops: " + " ".join(run.stderr.split())[:100]
    points = [as_floats(line.split()) for line in run.stdout.splitlines()]
    return points if points else "CGAL reads nothing"


def main():
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    counts = collections.Counter()
    for file in sys.argv[3:]:
        ours, theirs = by_near_pairs(sys.argv[1], file), by_cgal(sys.argv[2], file)
        verdict = ("refused by both" if isinstance(ours, str) and isinstance(theirs, str)
                   else "refused by near_pairs" if isinstance(ours, str)
                   else "refused by CGAL" if isinstance(theirs, str) and ours
                   else "the same" if ours == theirs or not ours else "different")
        counts[verdict] += 1
        if verdict != "the same":
            print(f"{file}: {verdict}",
                  *(f"  {read if isinstance(read, str) else f'{len(read)} vertices'}"
                    for read in (ours, theirs)), sep="\n")
    print(", ".join(f"{count} {name}" for name, count in sorted(counts.items())))
    sys.exit(1 if counts["different"] else 0)


if __name__ == "__main__":
    main()
