#!/usr/bin/env python3
# Draws the strip of the divide and conquer, and the grid for a close pair, as SVG files.
#
#   python3 fig_src/closest_pair.py fig          writes fig/closest_strip.svg, fig/close_pair_grid.svg
#
# The distances, the strip and the cells follow from the points by the rules of the library.
#
# SPDX-License-Identifier: LGPL-3.0-or-later

import math
import sys

from drawing import CELL, CUT, Drawing, PAIR, PALE, POINT, STRIP

# Left and right of the line at 0; the closest pair crosses it.
LEFT = [(-205, 30), (-188, 150), (-150, 92), (-128, 232), (-96, 40), (-84, 168), (-46, 106),
        (-36, 24), (-30, 226), (-12, 166)]
RIGHT = [(10, 66), (22, 128), (40, 190), (56, 12), (84, 92), (104, 236), (124, 150), (158, 44),
         (176, 196), (204, 118)]

GRID_POINTS = [(24, 30), (152, 52), (52, 118), (205, 96), (96, 236), (212, 212), (148, 158),
               (170, 186), (28, 214), (262, 30), (268, 148)]
RADIUS = 60


def closest(points):
    pairs = [(math.dist(p, q), p, q) for i, p in enumerate(points) for q in points[:i]]
    return min(pairs)


def strip(folder):
    d1, *pair1 = closest(LEFT)
    d2, *pair2 = closest(RIGHT)
    d = min(d1, d2)
    drawing = Drawing(640, 350, "The strip of the divide and conquer")
    cx, top, bottom = 320, 40, 300
    at = lambda p: (cx + p[0], bottom - p[1])
    drawing.rectangle(cx - d, top, 2 * d, bottom - top + 10, STRIP)

    # Candidates of the lowest point of the closest crossing pair: at most d above it in the strip.
    crossing = min((math.dist(p, q), p, q) for p in LEFT for q in RIGHT)
    q = min(crossing[1:], key=lambda p: p[1])
    base = at(q)[1]
    for side in (cx - d, cx):
        drawing.rectangle(side, base - d, d, d, "none", CUT)
    drawing.line((cx, top), (cx, bottom + 10), CUT)
    for pair, name, shift in ((pair1, "d1", (-8, -12)), (pair2, "d2", (14, 14))):
        drawing.line(at(pair[0]), at(pair[1]), PALE)
        middle = [(at(pair[0])[k] + at(pair[1])[k]) / 2 for k in (0, 1)]
        drawing.text(middle[0] + shift[0], middle[1] + shift[1], name, color="#555",
                     style='font-style="italic"')
    drawing.line(at(crossing[1]), at(crossing[2]), PAIR, 'stroke-width="2.5"')
    for p in LEFT + RIGHT:
        drawing.circle(at(p), fill=POINT if abs(p[0]) <= d else PALE)
    drawing.text(at(q)[0] + 10, at(q)[1] + 15, "q", "start", style='font-style="italic"')
    for left in (cx - d, cx):
        drawing.arrow((left, top - 8), (left + d, top - 8))
        drawing.text(left + d / 2, top - 14, "d", style='font-style="italic"')
    drawing.text(cx - d - 12, bottom + 8, "left half", "end", "#666")
    drawing.text(cx + d + 12, bottom + 8, "right half", "start", "#666")
    drawing.text(cx, bottom + 38, "d = min(d1, d2); q is compared with the points in two squares")
    drawing.write(f"{folder}/closest_strip.svg")


def grid(folder):
    drawing = Drawing(640, 350, "The grid for a close pair")
    x0, y0, columns, rows = 40, 30, 5, 4
    at = lambda p: (x0 + p[0], y0 + p[1])
    cell = lambda p: (int(p[0] // RADIUS), int(p[1] // RADIUS))
    chosen = GRID_POINTS[6]
    cx, cy = cell(chosen)
    for dx in (-1, 0, 1):
        for dy in (-1, 0, 1):
            if 0 <= cx + dx < columns and 0 <= cy + dy < rows:
                drawing.rectangle(x0 + (cx + dx) * RADIUS, y0 + (cy + dy) * RADIUS, RADIUS, RADIUS,
                                  STRIP if (dx, dy) == (0, 0) else CELL)
    for i in range(columns + 1):
        drawing.line((x0 + i * RADIUS, y0), (x0 + i * RADIUS, y0 + rows * RADIUS), "#bbb",
                     'stroke-width="1"')
    for j in range(rows + 1):
        drawing.line((x0, y0 + j * RADIUS), (x0 + columns * RADIUS, y0 + j * RADIUS), "#bbb",
                     'stroke-width="1"')
    drawing.circle(at(chosen), RADIUS, "none", f'stroke="{CUT}" stroke-width="1.5"')
    for p in GRID_POINTS:
        if p != chosen and math.dist(p, chosen) <= RADIUS:
            drawing.line(at(p), at(chosen), PAIR, 'stroke-width="2.5"')
        drawing.circle(at(p))
    drawing.arrow((x0, y0 - 10), (x0 + RADIUS, y0 - 10))
    drawing.text(x0 + RADIUS / 2, y0 - 15, "r", style='font-style="italic"')
    drawing.text(x0 + columns * RADIUS / 2, y0 + rows * RADIUS + 30,
                 "a close pair is in one cell or in two that touch")

    # The packing argument: quarters of a cell, each with a diameter below r.
    side, left, up = 160, 430, 60
    drawing.rectangle(left, up, side, side, STRIP, "#888")
    half = side / 2
    drawing.line((left + half, up), (left + half, up + side), "#888", 'stroke-dasharray="5 3"')
    drawing.line((left, up + half), (left + side, up + half), "#888", 'stroke-dasharray="5 3"')
    five = [(22, 30), (118, 14), (34, 126), (104, 104), (142, 146)]
    quarters = {}
    for p in five:
        quarters.setdefault((p[0] >= half, p[1] >= half), []).append((left + p[0], up + p[1]))
    for inside in quarters.values():
        if len(inside) > 1:
            drawing.line(inside[0], inside[1], PAIR, 'stroke-width="2.5"')
        for p in inside:
            drawing.circle(p)
    drawing.arrow((left, up - 10), (left + side, up - 10))
    drawing.text(left + half, up - 15, "r", style='font-style="italic"')
    drawing.text(left + half, up + side + 24, "five points: two are in one quarter,")
    drawing.text(left + half, up + side + 42, "closer than r")
    drawing.write(f"{folder}/close_pair_grid.svg")


strip(sys.argv[1])
grid(sys.argv[1])
