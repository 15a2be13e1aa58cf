#!/usr/bin/env python3
# Draws objects with radii, parcels, solids and arcs of circles as SVG files.
#
#   python3 fig_src/thick_objects.py fig          writes fig/capsules.svg, fig/touch_or_overlap.svg,
#                                                 fig/solids.svg, fig/arcs.svg
#
# What intersects, overlaps and is inside follows from the objects by the definitions of the manual.
#
# SPDX-License-Identifier: LGPL-3.0-or-later

import cmath
import math
import random
import sys
from fractions import Fraction
from itertools import combinations, product

from drawing import CELL, CUT, Drawing, PAIR, PALE, POINT, STRIP

DASHES = 'stroke-width="1.5" stroke-dasharray="5 3"'

# ---- radii: all numbers are integers ------------------------------------------------------------

CAPSULES = [  # the ends of a segment, and a radius
    ((30, 50), (130, 50), 20), ((50, 130), (100, 98), 20), ((228, 134), (228, 134), 45),
    ((300, 30), (372, 126), 15), ((350, 40), (446, 168), 25), ((185, 60), (255, 60), 18),
    ((480, 50), (570, 50), 18), ((500, 108), (580, 108), 40)]


def closest_to(p, a, b):
    """The point of a segment that is closest to p, in exact numbers."""
    v = [b[k] - a[k] for k in (0, 1)]
    square = v[0] ** 2 + v[1] ** 2
    along = sum((p[k] - a[k]) * v[k] for k in (0, 1))
    t = min(Fraction(1), max(Fraction(0), Fraction(along, square))) if square else Fraction(0)
    return tuple(a[k] + t * v[k] for k in (0, 1))


def closest_points(c, d):
    """The squared distance of two segments that do not cross, and where it is."""
    found = [(p, closest_to(p, *d[:2])) for p in c[:2]]
    found += [(closest_to(p, *c[:2]), p) for p in d[:2]]
    return min((sum((p[k] - q[k]) ** 2 for k in (0, 1)), p, q) for p, q in found)


def capsules(folder):
    drawing = Drawing(630, 256, "Segments with a radius each")
    at = lambda p: (float(p[0]), 210 - float(p[1]))
    for a, b, r in CAPSULES:
        drawing.line(at(a), at(b), CELL, f'stroke-width="{2 * r}" stroke-linecap="round"')
    for a, b, r in CAPSULES:
        drawing.line(at(a), at(b), POINT)
        for p in {a, b}:
            drawing.circle(at(p), 3)
    for c, d in combinations(CAPSULES, 2):
        square, p, q = closest_points(c, d)
        reach = c[2] + d[2]
        if square <= (reach + 12) ** 2:
            is_pair = square <= reach ** 2
            drawing.line(at(p), at(q), PAIR if is_pair else CUT,
                         'stroke-width="2.5"' if is_pair else DASHES)
            sign = "=" if square == reach ** 2 else "&lt;" if is_pair else "&gt;"
            sides = [end[0] + s * r for *ends, r in (c, d) for end in ends for s in (-1, 1)]
            drawing.text((min(sides) + max(sides)) / 2, 216,
                         f"{math.sqrt(square):.4g} {sign} {c[2]} + {d[2]}",
                         color=PAIR if is_pair else CUT, style='font-weight="bold"')
    drawing.text(315, 244, "distance of the segments and sum of the radii, of pairs (green) and of "
                 "others (red)")
    drawing.write(f"{folder}/capsules.svg")


# ---- parcels, of unit squares -------------------------------------------------------------------


def squares(x, y, width, height):
    return {(i, j) for i in range(x, x + width) for j in range(y, y + height)}


PARCELS = [
    ("a common border", squares(0, 1, 3, 4), squares(3, 0, 3, 4)),
    ("a common corner", squares(0, 0, 3, 2), squares(3, 2, 3, 3)),
    ("one in a hole", squares(0, 0, 6, 5) - squares(2, 1, 2, 3), squares(2, 1, 2, 3)),
    ("an overlap", squares(0, 0, 4, 3), squares(3, 2, 3, 3)),
    ("a common part", squares(0, 0, 6, 5), squares(3, 2, 3, 2))]


def draw_parcel(drawing, parcel, at, side, fill, stroke):
    for i, j in parcel:
        x, y = at(i, j + 1)
        drawing.parts.append(f'<rect x="{x:.1f}" y="{y:.1f}" width="{side}" height="{side}" '
                             f'fill="{fill}" fill-opacity="0.55" shape-rendering="crispEdges"/>')
    for i, j in sorted(parcel):
        for u, v in ((-1, 0), (1, 0), (0, -1), (0, 1)):
            if (i + u, j + v) not in parcel:
                a = i + (u > 0), j + (v > 0)
                drawing.line(at(*a), at(a[0] + abs(v), a[1] + abs(u)), stroke,
                             'stroke-width="2" stroke-linecap="square" '
                             'shape-rendering="crispEdges"')


def parcels(folder):
    side, step = 17, 152
    drawing = Drawing(step * len(PARCELS), 175, "Parcels that touch, and that overlap")
    for panel, (title, a, b) in enumerate(PARCELS):
        x0 = panel * step + (step - 6 * side) / 2
        at = lambda i, j, x0=x0: (x0 + i * side, 122 - j * side)
        middle = x0 + 3 * side
        do_overlap = bool(a & b)
        do_intersect = any(abs(i - k) <= 1 and abs(j - l) <= 1 for (i, j), (k, l) in product(a, b))
        draw_parcel(drawing, a, at, side, CELL, POINT)
        draw_parcel(drawing, b, at, side, STRIP, CUT)
        drawing.text(middle, 24, title, style='font-weight="bold"')
        for y, words, is_pair in ((146, "closed", do_intersect), (164, "interiors", do_overlap)):
            drawing.text(middle, y, f"{words}: {'a pair' if is_pair else 'no pair'}",
                         color=PAIR if is_pair else CUT)
    drawing.write(f"{folder}/touch_or_overlap.svg")


# ---- solids, cut by a plane ---------------------------------------------------------------------

SHELL = [[(30, 60), (60, 20), (250, 10), (330, 50), (345, 150), (280, 205), (90, 200), (25, 150)],
         [(150, 70), (250, 55), (290, 110), (245, 160), (165, 150), (130, 110)]]
SMALL = [[(70, 70), (105, 80), (100, 115), (65, 105)],
         [(190, 85), (225, 90), (230, 125), (185, 120)],
         [(385, 60), (425, 55), (440, 100), (395, 105)]]


def crossings(p):
    """Where the ray upwards from p crosses the edges of the shell."""
    found = []
    for ring in SHELL:
        for a, b in zip(ring, ring[1:] + ring[:1]):
            if (a[0] <= p[0]) != (b[0] <= p[0]):
                y = a[1] + Fraction((p[0] - a[0]) * (b[1] - a[1]), b[0] - a[0])
                if y > p[1]:
                    found.append(float(y))
    return found


def path(rings, at, fill, stroke):
    data = " ".join("M" + " L".join("{:.1f},{:.1f}".format(*at(p)) for p in ring) + " Z"
                    for ring in rings)
    return (f'<path d="{data}" fill="{fill}" fill-rule="evenodd" stroke="{stroke}" '
            'stroke-width="2"/>')


def solids(folder):
    drawing = Drawing(670, 250, "Solids inside of a solid, in its hollow and beside it")
    at = lambda p: (20 + p[0], 245 - p[1])
    drawing.parts.append(path(SHELL, at, CELL, POINT))
    for ring in SMALL:
        drawing.parts.append(path([ring], at, STRIP, POINT))
        p, found = ring[0], crossings(ring[0])
        is_inside = len(found) % 2 == 1
        color = PAIR if is_inside else CUT
        drawing.line(at(p), at((p[0], 232)), color, 'stroke-width="1.5" marker-end="url(#tip)"')
        for y in found:
            drawing.circle(at((p[0], y)), 5, "white", f'stroke="{color}" stroke-width="2"')
        drawing.circle(at(p), fill=color)
        drawing.text(at(p)[0] + 8, at((0, 226))[1], str(len(found)), "start", color,
                     'font-weight="bold"')
    for y, fill, words in ((70, CELL, "a solid with a hollow"), (95, STRIP, "small solids")):
        drawing.rectangle(485, y - 12, 18, 14, fill, POINT)
        drawing.text(511, y, words, "start")
    for y, color, words in ((120, PAIR, "odd: inside"), (145, CUT, "even: outside")):
        drawing.circle((494, y - 4), fill=color)
        drawing.text(511, y, words, "start")
    drawing.write(f"{folder}/solids.svg")


# ---- arcs: points are complex numbers -----------------------------------------------------------


class Arc:
    def __init__(self, p, q, r):
        self.ends = p, r
        a, b = q - p, r - p
        cross = (a.conjugate() * b).imag
        self.center = p + 1j * (b * abs(a) ** 2 - a * abs(b) ** 2) / (-2 * cross)
        self.radius = abs(p - self.center)
        self.is_left = cross > 0  # counterclockwise
        self.angle = self.turn_to(r)

    def turn_to(self, x):
        turn = cmath.phase((x - self.center) / (self.ends[0] - self.center))
        return (turn if self.is_left else -turn) % (2 * math.pi)

    def meets(self, other):
        v = other.center - self.center
        along = (self.radius ** 2 - other.radius ** 2 + abs(v) ** 2) / (2 * abs(v))
        square = self.radius ** 2 - along ** 2
        if square < 0:
            return []
        points = [self.center + v / abs(v) * complex(along, s * math.sqrt(square)) for s in (-1, 1)]
        return [x for x in points if self.turn_to(x) <= self.angle
                and other.turn_to(x) <= other.angle]

    def box(self):
        points = list(self.ends) + [x for x in (self.center + self.radius * 1j ** k
                                                for k in range(4)) if self.turn_to(x) <= self.angle]
        xs, ys = [x.real for x in points], [x.imag for x in points]
        return min(xs), min(ys), max(xs) - min(xs), max(ys) - min(ys)


def make_arcs(columns, rows):
    chance, found = random.Random(5), []
    near = lambda middle: middle + complex(chance.uniform(-50, 50), chance.uniform(-50, 50))
    for column, row in product(range(columns), range(rows)):
        middle = complex(75 + 78 * column, 70 + 50 * row)
        while True:
            p, q, r = near(middle), near(middle), near(middle)
            if abs(((q - p).conjugate() * (r - p)).imag) > 900:
                arc = Arc(p, q, r)
                x, y, width, height = arc.box()
                if max(width, height) < 90 and y > 8 and x > 8 and y + height < 225:
                    found.append(arc)
                    break
    return found


def arcs(folder):
    drawing = Drawing(620, 262, "Arcs of circles, their boxes, and where they intersect")
    all_arcs = make_arcs(7, 3)
    for arc in all_arcs:
        drawing.rectangle(*arc.box(), "none", "#ccc")
    for arc in all_arcs:
        (p, r), radius = arc.ends, f"{arc.radius:.2f}"
        flags = f"{int(arc.angle > math.pi)} {int(arc.is_left)}"
        drawing.parts.append(f'<path d="M{p.real:.1f},{p.imag:.1f} A{radius},{radius} 0 {flags} '
                             f'{r.real:.1f},{r.imag:.1f}" fill="none" stroke="{POINT}" '
                             'stroke-width="2"/>')
    for a, b in combinations(all_arcs, 2):
        for x in a.meets(b):
            drawing.circle((x.real, x.imag), 5, "none", f'stroke="{PAIR}" stroke-width="2.5"')
    drawing.text(310, 252, "arcs of circles, their boxes, and where arcs intersect")
    drawing.write(f"{folder}/arcs.svg")


for draw in (capsules, parcels, solids, arcs):
    draw(sys.argv[1])
