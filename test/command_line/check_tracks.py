#!/usr/bin/env python3
# Copyright (c) 2026 The Thick_intersection_d authors.
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Checks the pairs of ships and aircraft that near_pairs finds by comparing all legs in fractions.

  check_tracks.py NEAR_PAIRS DATA

DATA is the folder examples/data. Ships move for 12 minutes by their speeds and courses, and
aircraft from minute to minute. Only legs whose boxes are near are compared.

Prints the pairs and the distances that differ, and ends with the status 1 if there are any.
"""

import collections
import csv
import datetime
import fractions
import itertools
import math
import pathlib
import subprocess
import sys

RADIUS = 6371008.8
UNKNOWN_SPEEDS, UNKNOWN_COURSE = (102.2, 102.3), 360

Leg = collections.namedtuple("Leg", "track begin end low high")  # each end is a time and a place


def place(row, altitude=0.0):
    """The place of a row in space."""
    latitude, longitude = (math.radians(float(row[name])) for name in ("lat_deg", "lon_deg"))
    radius = RADIUS + altitude
    return (radius * math.cos(latitude) * math.cos(longitude),
            radius * math.cos(latitude) * math.sin(longitude), radius * math.sin(latitude))


def place_ahead(row, seconds):
    """The place of a ship after so many seconds on its great circle, by spherical trigonometry."""
    speed, course = float(row["sog_kn"]), float(row["cog_deg"])
    if speed in UNKNOWN_SPEEDS or course == UNKNOWN_COURSE:
        return place(row)
    latitude, course = math.radians(float(row["lat_deg"])), math.radians(course)
    arc = speed * 1852 / 3600 * seconds / RADIUS
    sine = (math.sin(latitude) * math.cos(arc)
            + math.cos(latitude) * math.sin(arc) * math.cos(course))
    turn = math.atan2(math.sin(course) * math.sin(arc) * math.cos(latitude),
                      math.cos(arc) - math.sin(latitude) * sine)
    return place({"lat_deg": math.degrees(math.asin(sine)),
                  "lon_deg": float(row["lon_deg"]) + math.degrees(turn)})


def make_leg(track, begin, end):
    axes = list(zip((begin[0], *begin[1]), (end[0], *end[1])))
    return Leg(track, begin, end, [min(axis) for axis in axes], [max(axis) for axis in axes])


def legs_of_ships(path, seconds):
    with open(path, encoding="ascii") as file:
        for row in csv.DictReader(file):
            yield make_leg(row["id"], (0, place(row)), (seconds, place_ahead(row, seconds)))


def legs_of_aircraft(path):
    tracks = collections.defaultdict(list)
    with open(path, encoding="ascii") as file:
        for row in csv.DictReader(file):
            time = datetime.datetime.fromisoformat(row["utc"].replace("Z", "+00:00")).timestamp()
            tracks[row["id"]].append((int(time), place(row, float(row["alt_ft"]) * 0.3048)))
    for track, fixes in tracks.items():
        yield from (make_leg(track, *ends) for ends in zip(sorted(fixes), sorted(fixes)[1:]))
        if len(fixes) == 1:
            yield make_leg(track, fixes[0], fixes[0])


def at(leg, time):
    """The place of a leg at a time, exactly."""
    (begin, p), (end, q) = leg.begin, leg.end
    part = fractions.Fraction(time - begin) / (end - begin) if end != begin else 0
    ends = ((fractions.Fraction(a), fractions.Fraction(b)) for a, b in zip(p, q))
    return [a + part * (b - a) for a, b in ends]


def least_square(one, other):
    """The square of the least distance of two legs at a common time, exactly."""
    first, last = max(one.begin[0], other.begin[0]), min(one.end[0], other.end[0])
    start, stop = ([a - b for a, b in zip(at(one, time), at(other, time))]
                   for time in (first, last))
    change = [b - a for a, b in zip(start, stop)]
    square = sum(step * step for step in change)
    part = 0 if square == 0 else -sum(a * step for a, step in zip(start, change)) / square
    part = min(max(part, 0), 1)
    return sum((a + part * step) ** 2 for a, step in zip(start, change))


def near_boxes(legs, distance):
    """Yields legs of two tracks whose boxes are within a distance along each axis, and in time."""
    reach = (0, *3 * [distance + 1])
    legs = sorted(legs, key=lambda leg: leg.low[1])
    for i, one in enumerate(legs):
        for other in itertools.islice(legs, i + 1, None):
            if other.low[1] > one.high[1] + reach[1]:
                break
            if one.track != other.track and all(
                    a - r <= d and c <= b + r for a, b, c, d, r in
                    zip(one.low, one.high, other.low, other.high, reach)):
                yield one, other


def expected_pairs(legs, distance):
    """The squared distances of the pairs of tracks."""
    pairs = {}
    for one, other in near_boxes(legs, distance):
        square = least_square(one, other)
        pair = tuple(sorted((one.track, other.track), key=int))
        if square <= distance ** 2:
            pairs[pair] = min(square, pairs.get(pair, square))
    return pairs


def faults(expected, program, *arguments):
    """Yields what differs between the expected pairs and those of near_pairs."""
    run = subprocess.run([program, *map(str, arguments), "--geographic", "--pairs", "-"],
                         capture_output=True, check=True, text=True)
    found = {(row["id_i"], row["id_j"]): float(row["distance"])
             for row in csv.DictReader(run.stdout.splitlines())}
    print(f"{len(expected)} pairs of {pathlib.Path(arguments[0]).name}")
    if not expected:
        yield "no pairs"
    yield from (f"pair {pair}" for pair in sorted(expected.keys() ^ found.keys()))
    yield from (f"distance {pair}: {found[pair]}" for pair in expected.keys() & found.keys()
                if abs(found[pair] - math.sqrt(expected[pair])) > 1e-5)


def main():
    program, data = sys.argv[1], pathlib.Path(sys.argv[2])
    ships, aircraft = data / "ships_us_2022-01-03.csv", data / "aircraft_ch_2018-08-01.csv"
    found = [*faults(expected_pairs(legs_of_ships(ships, 720), 500), program, ships,
                     "--velocity", "sog_kn,cog_deg", "--until", "12min", "--distance", "500m"),
             *faults(expected_pairs(legs_of_aircraft(aircraft), 9260), program, aircraft,
                     "--time", "utc", "--altitude", "alt_ft,ft", "--distance", "5nmi")]
    print("\n".join(found) if found else "all agree")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
