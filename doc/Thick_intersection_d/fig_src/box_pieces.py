#!/usr/bin/env python3
# Draws boxes of any sizes that are cut into pieces as an SVG file.
#
#   python3 fig_src/box_pieces.py > fig/box_pieces.svg
#
# Which pieces a box is in, and where a pair is reported, follow from the boxes and the cuts by the
# rules of the library.
#
# SPDX-License-Identifier: LGPL-3.0-or-later

from itertools import combinations

SCALE = 3.6       # pixels per unit
SIZE = (100, 90)  # of the scene
GAP = 14          # pixels between pieces
LEFT, MIDDLE, TOP = 24, 70, 48

BOX, COPY, CUT, PAIR, PASSED = "#1d3557", "#8fa3b8", "#b3261e", "#2a7f3f", "#7a5c99"

CUTS = [30, 60]
BOXES = [  # x and y of the lower left and of the upper right corner
    (8, 10, 58, 84), (20, 40, 95, 44), (72, 16, 77, 82), (14, 67, 21, 74), (28, 18, 37, 26),
    (50, 53, 65, 69), (86, 7, 92, 13), (75, 65, 84, 71), (86, 50, 93, 57), (65, 20, 74, 26),
    (33, 50, 38, 55), (90, 72, 96, 80)]

LIMITS = list(zip([0] + CUTS, CUTS + [SIZE[1]]))


def piece_of(y):
    return sum(cut <= y for cut in CUTS)


def pieces_of(box):
    return range(piece_of(box[1]), piece_of(box[3]) + 1)


def overlap(a, b):
    """What two boxes have in common, as a box, or None."""
    low = [max(a[i], b[i]) for i in (0, 1)]
    high = [min(a[i], b[i]) for i in (2, 3)]
    return (*low, *high) if low[0] <= high[0] and low[1] <= high[1] else None


def clip(box, piece):
    low, high = LIMITS[piece]
    return box[0], max(box[1], low), box[2], min(box[3], high)


def rectangle(box, at, style):
    x, y = at(box[0], box[3])
    return (f'<rect x="{x:.1f}" y="{y:.1f}" width="{(box[2] - box[0]) * SCALE:.1f}" '
            f'height="{(box[3] - box[1]) * SCALE:.1f}" {style}/>')


def text(x, y, words, size=13, color="#222", anchor="middle", style=""):
    return (f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" fill="{color}" '
            f'text-anchor="{anchor}" {style}>{words}</text>')


def outline(color, dashed=False):
    dashes = 'stroke-dasharray="5 3"' if dashed else ""
    return (f'fill="{color}" fill-opacity="{0.08 if dashed else 0.2}" stroke="{color}" '
            f'stroke-width="1.5" {dashes}')


def dot(x, y, is_reported):
    style = (f'fill="{PAIR}"' if is_reported
             else f'fill="white" stroke="{PASSED}" stroke-width="2"')
    return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{5 if is_reported else 4.5}" {style}/>'


def scene():
    def at(x, y):
        return LEFT + x * SCALE, TOP + GAP + (SIZE[1] - y) * SCALE
    parts = [text(at(50, 0)[0], TOP - 20, "Boxes and two cuts", 16, style='font-weight="bold"')]
    parts.append(rectangle((0, 0, *SIZE), at, 'fill="none" stroke="#bbb"'))
    parts += [rectangle(box, at, outline(BOX)) for box in BOXES]
    for cut in CUTS:
        (x1, y), (x2, _) = at(0, cut), at(SIZE[0], cut)
        parts.append(f'<line x1="{x1:.1f}" y1="{y:.1f}" x2="{x2:.1f}" y2="{y:.1f}" '
                     f'stroke="{CUT}" stroke-width="2"/>')
    return parts


def pieces():
    x0 = LEFT + SIZE[0] * SCALE + MIDDLE
    parts = [text(x0 + SIZE[0] * SCALE / 2, TOP - 20, "Three pieces", 16,
                  style='font-weight="bold"')]
    for piece, limits in enumerate(LIMITS):
        def at(x, y, shift=(len(CUTS) - piece) * GAP):
            return x0 + x * SCALE, TOP + shift + (SIZE[1] - y) * SCALE
        parts.append(rectangle((0, limits[0], SIZE[0], limits[1]), at, 'fill="none" stroke="#bbb"'))
        inside = [box for box in BOXES if piece in pieces_of(box)]
        for box in inside:
            is_copy = piece != pieces_of(box)[0]
            parts.append(rectangle(clip(box, piece), at, outline(COPY if is_copy else BOX, is_copy)))
        for a, b in combinations(inside, 2):
            common = overlap(a, b)
            if common:
                x1, y1, x2, y2 = clip(common, piece)
                is_reported = piece in (pieces_of(a)[0], pieces_of(b)[0])
                parts.append(dot(*at((x1 + x2) / 2, (y1 + y2) / 2), is_reported))
    return parts


def legend(x, y):
    return [f'<rect x="{x}" y="{y - 11}" width="22" height="13" {outline(BOX)}/>',
            text(x + 30, y, "a box where it begins", anchor="start"),
            f'<rect x="{x + 190}" y="{y - 11}" width="22" height="13" {outline(COPY, True)}/>',
            text(x + 220, y, "its copy", anchor="start"),
            dot(x + 310, y - 4, True),
            text(x + 322, y, "a pair that the piece reports", anchor="start"),
            dot(x + 530, y - 4, False),
            text(x + 542, y, "two copies: passed over", anchor="start")]


def main():
    width = int(2 * LEFT + 2 * SIZE[0] * SCALE + MIDDLE)
    height = int(TOP + len(CUTS) * GAP + SIZE[1] * SCALE + 52)
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
             f'viewBox="0 0 {width} {height}" font-family="Helvetica, Arial, sans-serif">',
             "<title>Boxes of any sizes, cut into pieces</title>",
             f'<rect width="{width}" height="{height}" fill="white"/>']
    parts += scene() + pieces() + legend(LEFT, height - 16)
    parts.append("</svg>")
    print("\n".join(parts))


main()
