#!/usr/bin/env python3
# Copyright (c) 2026 The Thick_intersection_d authors.
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Checks the pairs of solids that near_pairs finds by those of polygons, on many random scenes.

  check_solids.py NEAR_PAIRS [FIRST_SEED LAST_SEED]

The solids are prisms over polygons, which stand in one plane. So two of them meet, or are within a
distance, iff their polygons are. Corners are in a lattice, so many polygons touch, and corners may
be reflex or straight. The axes of space are exchanged at random. Every other scene is sheared by
integers, which changes distances, and not what meets.

Prints the scenes that differ, and ends with the status 1 if there are any.
"""

import pathlib
import random
import subprocess
import sys
import tempfile

PRISMS = 30


def polygon(rng):
    """A polygon that is monotone along an axis: a lower chain of corners, and an upper one."""
    size = rng.choice((2, 4, 8))
    x, y, step = rng.randrange(40), rng.randrange(40), rng.choice((1, 2))
    columns = range(x, x + step * rng.randrange(2, 10), step)
    corners = ([(column, y - rng.randrange(size)) for column in columns]
               + [(column, y + rng.randint(1, size)) for column in reversed(columns)])
    if rng.random() < 0.5:
        corners = [(v, u) for u, v in corners]
    return corners[::rng.choice((1, -1))]


def text_of_polygons(polygons):
    """The polygons in WKT."""
    rings = [",".join(f"{x} {y}" for x, y in corners + corners[:1]) for corners in polygons]
    return "".join(f"POLYGON(({ring}))\n" for ring in rings)


def text_of_prisms(rng, polygons, is_sheared):
    """The prisms over the polygons, each an object of an OBJ file."""
    axes = rng.sample(range(3), 3)
    lines, first = [], 1
    for number, corners in enumerate(polygons):
        lines.append(f"o {number}")
        count = len(corners)
        for z in (0, rng.randint(1, 3)):
            for x, y in corners:
                u, v, w = ((x, y, z)[axis] for axis in axes)
                lines.append(f"v {u + 2 * v + w} {v - w} {w + u}" if is_sheared
                             else f"v {u} {v} {w}")
        faces = [range(count), range(count, 2 * count)]
        faces += [(k, (k + 1) % count, (k + 1) % count + count, k + count) for k in range(count)]
        lines += ["f " + " ".join(str(first + corner) for corner in face) for face in faces]
        first += 2 * count
    return "\n".join(lines) + "\n"


def pairs(program, file, distance, *options):
    """The pairs that near_pairs finds, and its summary."""
    run = subprocess.run([program, file, "--distance", str(distance), "--pairs", "-", *options],
                         capture_output=True, check=True, text=True)
    return {tuple(row.split(",")[:2]) for row in run.stdout.splitlines()[1:]}, run.stderr


def faults(program, folder, seed):
    """Yields what is wrong with the pairs of a scene."""
    rng = random.Random(seed)
    polygons = [polygon(rng) for _ in range(PRISMS)]
    is_sheared = seed % 2 == 1
    plane, space = folder / "polygons.wkt", folder / "prisms.obj"
    plane.write_text(text_of_polygons(polygons), encoding="ascii")
    space.write_text(text_of_prisms(rng, polygons, is_sheared), encoding="ascii")
    for distance in (0,) if is_sheared else (0, 1, 3):
        expected, _ = pairs(program, plane, distance)
        found, summary = pairs(program, space, distance, "--solids")
        if found != expected:
            yield f"seed {seed}, distance {distance}: {sorted(found ^ expected)} differ"
        if f"{PRISMS} of the solids, which are filled" not in summary or "hint" in summary:
            yield f"seed {seed}: {summary}"


def main():
    program, *seeds = sys.argv[1:]
    first, last = map(int, seeds or (0, 39))
    with tempfile.TemporaryDirectory() as path:
        found = [fault for seed in range(first, last + 1)
                 for fault in faults(program, pathlib.Path(path), seed)]
    print("\n".join(found) if found else f"{last - first + 1} scenes agree")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
