#!/usr/bin/env python3
# Draws the images that a periodic search makes, and the pairs across the boundary as near_pairs
# draws them, as an SVG file.
#
#   python3 fig_src/periodic_images.py > fig/periodic_images.svg
#
# The images, the pairs and the halves of pairs follow from the points, the sides and the distance.
#
# SPDX-License-Identifier: LGPL-3.0-or-later

import itertools
import math
import random
import sys

POINT, IMAGE, PAIR, ACROSS, CELL, REACH = ("#1d3557", "#8fa3b8", "#2a7f3f", "#b3261e", "#222",
                                           "#f6d9a8")
FONT = 'font-family="Helvetica, Arial, sans-serif"'
SIDES, DISTANCE = (230, 190), 46
LEFT, RIGHT = (20, 84), (370, 84)


def points_apart(count, least, seed):
    """Returns points of the box at least so far from each other and from images of each other."""
    numbers = random.Random(seed)
    points = []
    while len(points) < count:
        p = tuple(numbers.uniform(0, side) for side in SIDES)
        if all(math.dist(p, moved(q, o)) > least for q in points for o in offsets()):
            points.append(p)
    return points


def offsets():
    return itertools.product((-1, 0, 1), repeat=2)


def moved(p, offset):
    return tuple(x + o * side for x, o, side in zip(p, offset, SIDES))


def pairs_of(points):
    """Yields each pair of images once, as the library does."""
    for (i, p), (j, q) in itertools.product(enumerate(points), repeat=2):
        for offset in offsets():
            if (i, (0, 0)) < (j, offset) and i <= j and math.dist(p, moved(q, offset)) <= DISTANCE:
                yield p, q, offset


def is_within_reach(p):
    return all(-DISTANCE <= x <= side + DISTANCE for x, side in zip(p, SIDES))


class Panel:
    """Draws in the coordinates of the box, with y upwards."""

    def __init__(self, parts, corner, title):
        self.parts, self.corner = parts, corner
        self.text(title, (SIDES[0] / 2, SIDES[1] + DISTANCE + 22))

    def place(self, p):
        return self.corner[0] + p[0], self.corner[1] + SIDES[1] - p[1]

    def rectangle(self, low, high, style):
        (x, y), (right, bottom) = self.place((low[0], high[1])), self.place((high[0], low[1]))
        self.parts.append(f'<rect x="{x:.1f}" y="{y:.1f}" width="{right - x:.1f}" '
                          f'height="{bottom - y:.1f}" {style}/>')

    def line(self, p, q, color, style=""):
        (x, y), (u, v) = self.place(p), self.place(q)
        self.parts.append(f'<line x1="{x:.1f}" y1="{y:.1f}" x2="{u:.1f}" y2="{v:.1f}" '
                          f'stroke="{color}" stroke-width="2" {style}/>')

    def dot(self, p, color):
        x, y = self.place(p)
        self.parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="{color}"/>')

    def text(self, words, p):
        x, y = self.place(p)
        self.parts.append(f'<text x="{x:.1f}" y="{y:.1f}" font-size="13" fill="{CELL}" '
                          f'text-anchor="middle">{words}</text>')


def draw_images(panel, points):
    width, height = SIDES
    right, top = width + DISTANCE, height + DISTANCE
    panel.rectangle((0, height), (width, top), f'fill="{REACH}"')
    panel.rectangle((width, -DISTANCE), (right, top), f'fill="{REACH}"')
    panel.rectangle((0, 0), SIDES, f'fill="white" stroke="{CELL}"')
    for p, q, offset in pairs_of(points):
        if offset < (0, 0): # the same pair, with the second point at home
            p, q, offset = q, p, tuple(-o for o in offset)
        panel.line(p, moved(q, offset), PAIR if offset == (0, 0) else ACROSS)
    for offset in offsets():
        for p in points:
            if offset > (0, 0) and is_within_reach(moved(p, offset)):
                panel.dot(moved(p, offset), IMAGE)


def draw_halves(panel, points):
    panel.rectangle((0, 0), SIDES, f'fill="white" stroke="{CELL}"')
    for p, q, offset in pairs_of(points):
        if offset == (0, 0):
            panel.line(p, q, PAIR)
            continue
        half = tuple((b - a) / 2 for a, b in zip(p, moved(q, offset)))
        panel.line(p, (p[0] + half[0], p[1] + half[1]), ACROSS)
        panel.line(q, (q[0] - half[0], q[1] - half[1]), ACROSS)


def main():
    width, height = RIGHT[0] + SIDES[0] + 30, RIGHT[1] + SIDES[1] + DISTANCE + 10
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
             f'viewBox="0 0 {width} {height}" {FONT}>',
             "<title>Images beyond the boundary, and halves of pairs across it</title>",
             f'<rect width="{width}" height="{height}" fill="white"/>']
    points = points_apart(24, 20, 7)
    for corner, title, draw in ((LEFT, "points, and images at positive offsets", draw_images),
                                (RIGHT, "the same pairs, as near_pairs draws them", draw_halves)):
        panel = Panel(parts, corner, title)
        draw(panel, points)
        for p in points:
            panel.dot(p, POINT)
    parts.append("</svg>")
    sys.stdout.write("\n".join(parts) + "\n")


main()
