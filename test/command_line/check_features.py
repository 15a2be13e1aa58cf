#!/usr/bin/env python3
# Copyright (c) 2026 The Thick_intersection_d authors.
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Checks the pairs of features that near_pairs finds by GEOS, on many random scenes.

  check_features.py BINARY [FIRST_SEED LAST_SEED]

The features are points, polylines, polygons, and polygons with holes that touch their boundary and
each other. Their corners are in a lattice, so many features touch, and many distances are equal. A
bound is the exact squared distance of two of them, and holes have features inside. GEOS tells which
features intersect, without error for such corners, and which are near. If its distance is as good
as the bound, fractions decide, from all vertices and all segments.

Prints the pairs that differ, and ends with the status 1 if there are any.
"""

import fractions
import random
import subprocess
import sys
import tempfile

from shapely.geometry import LineString, MultiPolygon, Point, Polygon, box


class Scene:
    """Random features, in two files."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.side = self.random.choice([8, 20, 40])
        self.origin = self.random.choice([0, -2 ** 24, 2 ** 30])
        count = self.random.randrange(10, 40)
        self.features = [self.feature() for _ in range(2 * count)]
        self.first_count = count

    def corner(self, x=0, y=0, extent=None):
        extent = self.side if extent is None else extent
        return x + self.random.randrange(extent), y + self.random.randrange(extent)

    def polygon(self, x, y, extent, attempts=20):
        """A simple polygon, which may be far from convex."""
        for _ in range(attempts):
            ring = [self.corner(x, y, extent) for _ in range(self.random.randrange(3, 8))]
            polygon = Polygon(ring)
            if polygon.is_valid and polygon.area > 0:
                return polygon
        return box(x, y, x + extent, y + extent)

    def with_holes(self, outer):
        holes = []
        x, y, right, top = map(int, outer.bounds)
        for _ in range(self.random.randrange(1, 12)):
            extent = self.random.choice([2, 3, max(right - x, top - y) + 1])
            hole = self.polygon(*self.corner(x, y, max(right - x, top - y)), extent)
            polygon = Polygon(outer.exterior, holes + [hole.exterior])
            if polygon.is_valid:
                holes.append(hole.exterior)
        return Polygon(outer.exterior, holes)

    def feature(self):
        x, y = self.corner()
        extent = self.random.choice([2, 4, 7, self.side])
        kind = self.random.randrange(7)
        if kind == 0:
            return Point(x, y)
        if kind < 3:
            line = [self.corner(x, y, extent) for _ in range(self.random.randrange(2, 7))]
            return LineString(line) if len(set(line)) > 1 else Point(line[0])
        outer = self.polygon(x, y, extent)
        if kind == 3:
            return outer
        if kind == 4:
            two = MultiPolygon([self.polygon(x, y, extent), self.polygon(x + extent, y, extent)])
            return two if two.is_valid else outer
        if kind == 5:  # a frame, around others
            outer = box(x, y, x + extent + 4, y + extent + 4)
        return self.with_holes(outer)

    def text(self, feature):
        def chain(points):
            return "(" + ",".join(f"{int(x) + self.origin} {int(y) + self.origin}"
                                  for x, y in points) + ")"

        def rings(polygon):
            return "(" + ",".join(chain(ring) for ring in rings_of(polygon)) + ")"
        if feature.geom_type == "MultiPolygon":
            return "MULTIPOLYGON(" + ",".join(rings(polygon) for polygon in feature.geoms) + ")"
        if feature.geom_type == "Polygon":
            return "POLYGON" + rings(feature)
        return feature.geom_type.upper() + chain(feature.coords)


def rings_of(polygon):
    return [list(ring.coords) for ring in (polygon.exterior, *polygon.interiors)]


def chains_of(feature):
    """The vertices of a feature, whose polygons end where they begin."""
    if feature.geom_type == "MultiPolygon":
        chains = [ring for polygon in feature.geoms for ring in rings_of(polygon)]
    elif feature.geom_type == "Polygon":
        chains = rings_of(feature)
    else:
        chains = [list(feature.coords)]
    return [[(int(x), int(y)) for x, y in chain] for chain in chains]


def squared_distance_to_segment(p, a, b):
    along = (b[0] - a[0], b[1] - a[1])
    to_p = (p[0] - a[0], p[1] - a[1])
    length = along[0] ** 2 + along[1] ** 2
    where = to_p[0] * along[0] + to_p[1] * along[1]
    if where <= 0:
        return fractions.Fraction(to_p[0] ** 2 + to_p[1] ** 2)
    if where >= length:
        return fractions.Fraction((p[0] - b[0]) ** 2 + (p[1] - b[1]) ** 2)
    return fractions.Fraction((along[0] * to_p[1] - along[1] * to_p[0]) ** 2, length)


def squared_distance(a, b):
    """That of two features that do not intersect: a vertex of one is closest to the other."""
    return min(squared_distance_to_segment(p, s, t)
               for one, other in ((a, b), (b, a))
               for points in chains_of(one) for p in points
               for chain in chains_of(other) for s, t in zip(chain, chain[1:] or chain))


def is_near(a, b, squared_bound, is_open):
    if a.intersects(b):
        return squared_bound > 0 or not is_open
    if squared_bound == 0:
        return False
    distance = a.distance(b) ** 2
    if abs(distance - float(squared_bound)) > 1e-6 * (1 + distance):
        return distance < squared_bound
    exact = squared_distance(a, b)
    return exact < squared_bound if is_open else exact <= squared_bound


def bounds_of(scene):
    yield fractions.Fraction(0), False
    for _ in range(2):
        a, b = scene.random.sample(scene.features, 2)
        if a.intersects(b) or a.distance(b) > scene.side / 4:
            yield fractions.Fraction(scene.random.randrange(1, 6)), False
        else:
            bound = squared_distance(a, b)
            yield bound, False
            yield bound, True


def pairs_of_program(binary, folder, files, squared_bound, is_open):
    command = [binary, *files, "--squared-distance", str(squared_bound), "--pairs", "pairs.csv"]
    subprocess.run(command + ["--open"] * is_open, cwd=folder, check=True,
                   stdout=subprocess.DEVNULL)
    with open(f"{folder}/pairs.csv", encoding="utf-8") as lines:
        return sorted(tuple(map(int, line.split(",")[:2])) for line in list(lines)[1:])


def check(binary, folder, seed):
    """Returns the numbers of searches, of pairs, and of pairs that differ."""
    scene = Scene(seed)
    parts = scene.features[:scene.first_count], scene.features[scene.first_count:]
    for name, features in zip(("all", "a", "b"), (scene.features, *parts)):
        with open(f"{folder}/{name}.wkt", "w", encoding="utf-8") as file:
            file.writelines(scene.text(feature) + "\n" for feature in features)
    searches = count = wrong = 0
    for squared_bound, is_open in bounds_of(scene):
        of_one = [(i, j) for j, b in enumerate(scene.features)
                  for i, a in enumerate(scene.features[:j])
                  if is_near(a, b, squared_bound, is_open)]
        of_two = [(i, j - scene.first_count) for i, j in of_one if i < scene.first_count <= j]
        for files, expected in ((["all.wkt"], of_one), (["a.wkt", "b.wkt"], of_two)):
            found = pairs_of_program(binary, folder, files, squared_bound, is_open)
            searches += 1
            count += len(expected)
            if found != sorted(expected):
                wrong += len(set(found) ^ set(expected)) or abs(len(found) - len(expected))
                print(f"seed {seed}, {' '.join(files)}, squared distance {squared_bound}"
                      f"{', open' * is_open}: found {sorted(set(found) - set(expected))}, missed "
                      f"{sorted(set(expected) - set(found))}, of {len(found)}")
    return searches, count, wrong


def main():
    if len(sys.argv) not in (2, 4):
        sys.exit(__doc__)
    seeds = range(*map(int, sys.argv[2:])) if len(sys.argv) == 4 else range(60)
    with tempfile.TemporaryDirectory() as folder:
        totals = [sum(column) for column in zip(*(check(sys.argv[1], folder, seed)
                                                  for seed in seeds))]
    print(f"{totals[0]} searches, {totals[1]} pairs, {totals[2]} wrong")
    sys.exit(1 if totals[2] or not totals[1] else 0)


if __name__ == "__main__":
    main()
