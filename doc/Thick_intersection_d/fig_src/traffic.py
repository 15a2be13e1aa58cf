#!/usr/bin/env python3
# Draws two points that move, and their distance over time, as an SVG file.
#
#   python3 fig_src/traffic.py fig                                       writes fig/traffic.svg
#
# SPDX-License-Identifier: LGPL-3.0-or-later

import math
import sys
from fractions import Fraction

from drawing import CUT, Drawing, PAIR, PALE, POINT

TRACKS = [  # fixes: a minute, and a place
    [(0, (10, 20)), (2, (90, 50)), (4, (150, 130)), (6, (260, 150))],
    [(0, (190, 5)), (2, (122, 52)), (6, (12, 142))]]
BOUND = 20


def place(track, time):
    """Where a point is, in exact numbers."""
    for (t, p), (u, q) in zip(track, track[1:]):
        if t <= time <= u:
            share = Fraction(time - t) / (u - t)
            return tuple(p[k] + share * (q[k] - p[k]) for k in (0, 1))
    raise ValueError("The track does not exist at this time.")


def square(time):
    p, q = (place(track, time) for track in TRACKS)
    return sum((p[k] - q[k]) ** 2 for k in (0, 1))


def closest_approach():
    """The time at which the squared distance, a parabola between fixes, is least."""
    fixes = sorted({t for track in TRACKS for t, _ in track})
    times = [Fraction(t) for t in fixes]
    for t, u in zip(fixes, fixes[1:]):
        f, g, h = square(t), square(Fraction(t + u, 2)), square(u)
        bend, slope = 2 * (f + h - 2 * g), 4 * g - 3 * f - h
        if bend > 0 and 0 < -slope < 2 * bend:
            times.append(t - (u - t) * slope / (2 * bend))
    return min(times, key=square)


def draw(folder):
    drawing = Drawing(640, 250, "Two points that move, and their distance over time")
    least = closest_approach()
    at = lambda p: (27 + float(p[0]), 195 - float(p[1]))
    for track, color in zip(TRACKS, (POINT, CUT)):
        for (_, p), (_, q) in zip(track, track[1:]):
            drawing.line(at(p), at(q), color)
        for minute in range(track[0][0], track[-1][0] + 1):
            is_fix = minute in [t for t, _ in track]
            drawing.circle(at(place(track, minute)), 5 if is_fix else 3,
                           color if is_fix else "white", f'stroke="{color}" stroke-width="1.5"')
    closest = [at(place(track, least)) for track in TRACKS]
    drawing.line(*closest, PAIR, 'stroke-width="3"')
    for point in closest:
        drawing.circle(point, 4, PAIR)
    drawing.text(162, 236, "fixes (full), minutes, closest approach (green)")

    at = lambda time, distance: (340 + 45 * float(time), 200 - 0.72 * float(distance))
    drawing.line(at(0, 0), at(6, 0), "#222", 'stroke-width="1.2"')
    drawing.line(at(0, 0), at(0, 250), "#222", 'stroke-width="1.2"')
    drawing.line(at(0, BOUND), at(6, BOUND), PAIR, 'stroke-width="1.5" stroke-dasharray="5 3"')
    drawing.text(at(6, 0)[0], at(6, BOUND)[1] - 6, "the bound", "end", PAIR)
    times = sorted([Fraction(k, 20) for k in range(121)] + [least])
    for t, u in zip(times, times[1:]):
        drawing.line(*(at(x, math.sqrt(square(x))) for x in (t, u)), PALE)
    for minute in range(7):
        drawing.circle(at(minute, math.sqrt(square(minute))), 3, "white",
                       'stroke="#222" stroke-width="1.5"')
        drawing.text(at(minute, 0)[0], 216, str(minute))
    drawing.circle(at(least, math.sqrt(square(least))), 5, PAIR)
    drawing.text(475, 236, "their distance over time, in minutes")
    drawing.write(f"{folder}/traffic.svg")


if __name__ == "__main__":
    draw(sys.argv[1])
