#!/usr/bin/env python3
# Copyright (c) 2026 The Thick_intersection_d authors.
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Checks the pairs of features that near_pairs finds by GEOS, on many random scenes and a shore.

  check_features.py BINARY DATA [FIRST_SEED LAST_SEED]

The features are points, polylines, polygons, polygons with holes that touch their boundary and each
other, and collections of these, in WKT and in GeoJSON. Their corners are in a lattice, so many
features touch, and holes have features inside. GEOS tells which features intersect, without error
for such corners, and which are near. No bound is the distance of two of them: cases/features/ has
such ties, and functions/test_features.cpp has all kinds of them. DATA is examples/data, which has
ships and the shore of Puget Sound.

Prints the pairs that differ, and ends with the status 1 if there are any.
"""

import csv
import fractions
import json
import random
import subprocess
import sys
import tempfile

from shapely.geometry import (GeometryCollection, LineString, MultiPoint, MultiPolygon, Point,
                              Polygon, box, mapping, shape)


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
        kind = self.random.randrange(9)
        if kind == 0:
            return Point(x, y)
        if kind == 7:
            return MultiPoint([(x, y), self.corner(x, y, extent)])
        if kind == 8:
            return GeometryCollection([Point(x, y), self.polygon(*self.corner(), 2),
                                       LineString([(x, y), self.corner(x + 1, y, extent)])])
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

    def moved(self, geometry):
        """The mapping of a geometry with integers for coordinates, away from the origin."""
        if "geometries" in geometry:
            return {**geometry, "geometries": list(map(self.moved, geometry["geometries"]))}

        def move(c):
            return int(c) + self.origin if isinstance(c, (int, float)) else list(map(move, c))
        return {**geometry, "coordinates": move(geometry["coordinates"])}

    def write(self, file, features, as_json):
        moved = [self.moved(mapping(feature)) for feature in features]
        if as_json:
            json.dump({"type": "FeatureCollection", "features": [
                {"type": "Feature", "properties": {}, "geometry": geometry}
                for geometry in moved]}, file)
        else:
            file.writelines(wkt(geometry) + "\n" for geometry in moved)


def is_position(coordinates):
    return isinstance(coordinates[0], (int, float))


def wkt(geometry):
    def nested(c):
        return " ".join(map(str, c)) if is_position(c) else f"({','.join(map(nested, c))})"
    parts = ",".join(map(wkt, geometry.get("geometries", [])))
    inner = parts or nested(geometry["coordinates"])
    return geometry["type"].upper() + (inner if inner[0] == "(" else f"({inner})")


def is_near(a, b, squared_bound, is_open):
    if a.intersects(b):
        return squared_bound > 0 or not is_open
    return squared_bound > 0 and a.distance(b) ** 2 < squared_bound


def bounds_of(scene):
    """Bounds that no distance equals: the prime number is greater than squared lengths of edges."""
    yield fractions.Fraction(0), False
    for is_open in (False, True, False, True):
        yield fractions.Fraction(scene.random.randrange(1, 6 * 99991), 99991), is_open


def differing(binary, folder, files, expected, *options):
    """Returns how many pairs of the program are not those that are expected, and prints which."""
    command = [binary, *files, *options, "--pairs", "pairs.csv"]
    subprocess.run(command, cwd=folder, check=True, stdout=subprocess.DEVNULL,
                   stderr=subprocess.DEVNULL)
    with open(f"{folder}/pairs.csv", encoding="utf-8") as lines:
        found = sorted(tuple(map(int, line.split(",")[:2])) for line in list(lines)[1:])
    if found == sorted(expected):
        return 0
    print(f"{folder} {' '.join(command)}: found {sorted(set(found) - set(expected))}, missed "
          f"{sorted(set(expected) - set(found))}, of {len(found)}")
    return len(set(found) ^ set(expected)) or abs(len(found) - len(expected))


def check(binary, folder, seed):
    """Returns the numbers of searches, of pairs, and of pairs that differ."""
    scene = Scene(seed)
    parts = scene.features[:scene.first_count], scene.features[scene.first_count:]
    suffix = ("wkt", "geojson")[seed % 2]
    for name, features in zip(("all", "a", "b"), (scene.features, *parts)):
        with open(f"{folder}/{name}.{suffix}", "w", encoding="utf-8") as file:
            scene.write(file, features, suffix == "geojson")
    searches = count = wrong = 0
    for squared_bound, is_open in bounds_of(scene):
        of_one = [(i, j) for j, b in enumerate(scene.features)
                  for i, a in enumerate(scene.features[:j])
                  if is_near(a, b, squared_bound, is_open)]
        of_two = [(i, j - scene.first_count) for i, j in of_one if i < scene.first_count <= j]
        options = ["--squared-distance", str(squared_bound)] + ["--open"] * is_open
        for names, expected in ((["all"], of_one), (["a", "b"], of_two)):
            searches += 1
            count += len(expected)
            wrong += differing(binary, folder, [f"{name}.{suffix}" for name in names], expected,
                               *options)
    return searches, count, wrong


def check_shore(binary, data, folder):
    """Returns the same of the ships by a shore."""
    files = [f"{data}/ships_us_2022-01-03.csv", f"{data}/puget_sound.geojson"]
    with open(files[0], encoding="utf-8") as rows:
        ships = [(float(row["lon_deg"]), float(row["lat_deg"])) for row in csv.DictReader(rows)]
    with open(files[1], encoding="utf-8") as file:
        shores = [shape(feature["geometry"]) for feature in json.load(file)["features"]]
    expected = []
    for j, shore in enumerate(shores):
        left, bottom, right, top = shore.bounds
        expected += [(i, j) for i, (x, y) in enumerate(ships)
                     if left - 1 < x < right + 1 and bottom - 1 < y < top + 1
                     and shore.distance(Point(x, y)) <= 0.002]
    return 1, len(expected), differing(binary, folder, files, expected, "--distance", "0.002")


def main():
    if len(sys.argv) not in (3, 5):
        sys.exit(__doc__)
    binary, data = sys.argv[1:3]
    seeds = range(*map(int, sys.argv[3:])) if len(sys.argv) == 5 else range(60)
    with tempfile.TemporaryDirectory() as folder:
        counts = [check(binary, folder, seed) for seed in seeds]
        counts.append(check_shore(binary, data, folder))
    totals = [sum(column) for column in zip(*counts)]
    print(f"{totals[0]} searches, {totals[1]} pairs, {totals[2]} wrong")
    sys.exit(1 if totals[2] or not totals[1] else 0)


if __name__ == "__main__":
    main()
