#!/usr/bin/env python3
# Draws the four cases of the divide and conquer as an SVG file.
#
#   python3 fig_src/four_cases.py > fig/four_cases.svg
#
# Heights are in reaches. A case is its points (x, height), its cut, and whether it recurses below
# and above; the strip, and which pairs it reports, follow from these by the rules of the library.
#
# SPDX-License-Identifier: LGPL-3.0-or-later

REACH = 62        # pixels
WIDTH = 170       # of a panel
GAP = 46          # between panels, where the marks of the cut stand
LEFT, TOP, BOTTOM = 46, 60, 420

STRIP, POINT, LEFT_ALONE, CUT, PAIR = "#f6d9a8", "#1d3557", "#8fa3b8", "#b3261e", "#2a7f3f"
LEFT_TO_CHILD = "#7a5c99"
SOLID, DASHES = 'stroke-width="2.5"', 'stroke-width="2.5" stroke-dasharray="5 3"'

CASES = [
    dict(title="Case 1", text=["the cut is close to both ends:", "no cut, next axis"],
         points=[(30, 2.2), (84, 2.5), (140, 2.35), (62, 2.95), (118, 3.2), (36, 3.4), (146, 3.7),
                 (84, 3.85)],
         cut=None, below=False, above=False, pairs=[((84, 2.5), (62, 2.95))]),
    dict(title="Case 2", text=["close to neither end:", "recurse on both sides"],
         points=[(26, 0.3), (120, 0.7), (70, 1.2), (142, 1.5), (34, 2.5), (60, 2.2), (116, 2.55),
                 (78, 3.0), (128, 3.45), (36, 3.75), (66, 4.4), (142, 4.9), (116, 4.3), (40, 5.3),
                 (104, 5.2)],
         cut=3.0, below=True, above=True,
         pairs=[((116, 2.55), (128, 3.45)), ((34, 2.5), (60, 2.2))]),
    dict(title="Case 3", text=["close to the lowest:", "recurse above only"],
         points=[(30, 0.4), (24, 0.8), (124, 0.45), (90, 0.55), (142, 0.7), (56, 0.85),
                 (112, 1.0), (78, 1.25), (36, 1.7), (104, 2.1), (126, 2.6), (62, 3.1), (140, 4.0), (92, 5.2)],
         cut=1.25, below=False, above=True,
         pairs=[((90, 0.55), (56, 0.85)), ((112, 1.0), (78, 1.25)), ((36, 1.7), (104, 2.1))]),
    dict(title="Case 4", text=["close to the highest:", "recurse below only"],
         points=[(30, 5.6), (24, 5.25), (124, 5.55), (92, 5.5), (142, 5.3), (56, 5.1),
                 (112, 5.0), (84, 4.7), (36, 4.15), (126, 3.8), (62, 2.8), (140, 1.9), (92, 0.7)],
         cut=4.7, below=True, above=False,
         pairs=[((84, 4.7), (112, 5.0))]),
]


def y_of(height):
    return BOTTOM - height * REACH


def rectangle(x, low, high, fill):
    return (f'<rect x="{x}" y="{y_of(high):.1f}" width="{WIDTH}" '
            f'height="{(high - low) * REACH:.1f}" fill="{fill}"/>')


def line(x1, h1, x2, h2, color, style=""):
    return (f'<line x1="{x1}" y1="{y_of(h1):.1f}" x2="{x2}" y2="{y_of(h2):.1f}" '
            f'stroke="{color}" {style}/>')


def text(x, y, words, size=13, color="#222", anchor="middle", style=""):
    return (f'<text x="{x}" y="{y:.1f}" font-size="{size}" fill="{color}" '
            f'text-anchor="{anchor}" {style}>{words}</text>')


def strip_of(case):
    """The lowest and highest height that the strip may hold."""
    heights = [h for _, h in case["points"]]
    if case["cut"] is None:
        return min(heights), max(heights)
    low = case["cut"] - 1 if case["below"] else min(heights)
    high = case["cut"] + 1 if case["above"] else max(heights)
    return low, high


def is_in_one_child(case, h1, h2):
    """The separation rule: whether a recursive call will meet the pair."""
    return ((case["below"] and max(h1, h2) < case["cut"])
            or (case["above"] and min(h1, h2) > case["cut"]))


def reach_mark(x, low, high):
    """A double arrow of one reach beside the panel."""
    style = 'stroke-width="1.2" marker-start="url(#tip)" marker-end="url(#tip)"'
    return [line(x, low, x, high, "#222", style),
            text(x - 8, y_of((low + high) / 2) + 4, "r", anchor="end", style='font-style="italic"')]


def panel(case, x0):
    low, high = strip_of(case)
    parts = [text(x0 + WIDTH / 2, TOP - 36, case["title"], 16, style='font-weight="bold"')]
    parts.append(f'<rect x="{x0}" y="{y_of(6.05):.1f}" width="{WIDTH}" '
                 f'height="{6 * REACH:.1f}" fill="none" stroke="#bbb"/>')
    parts.append(rectangle(x0, low - 0.06, high + 0.06, STRIP))
    if case["cut"] is not None:
        cut = case["cut"]
        parts.append(line(x0, cut, x0 + WIDTH, cut, CUT, 'stroke-width="2"'))
        parts.append(text(x0 + WIDTH + 4, y_of(cut) + 4, "cut", 12, CUT, "start"))
        if case["below"]:
            parts += reach_mark(x0 - 7, cut - 1, cut)
            parts.append(text(x0 + WIDTH / 2, BOTTOM - 6, "recursed", 12, "#666"))
        if case["above"]:
            parts += reach_mark(x0 - 7, cut, cut + 1)
            parts.append(text(x0 + WIDTH / 2, y_of(6.05) + 15, "recursed", 12, "#666"))
    for (x1, h1), (x2, h2) in case["pairs"]:
        style = (LEFT_TO_CHILD, DASHES) if is_in_one_child(case, h1, h2) else (PAIR, SOLID)
        parts.append(line(x0 + x1, h1, x0 + x2, h2, *style))
    for x, h in case["points"]:
        fill = POINT if low <= h <= high else LEFT_ALONE
        parts.append(f'<circle cx="{x0 + x}" cy="{y_of(h):.1f}" r="4.5" fill="{fill}"/>')
    for row, words in enumerate(case["text"]):
        parts.append(text(x0 + WIDTH / 2, BOTTOM + 22 + 17 * row, words, 13))
    return parts


def legend(x, y):
    return [f'<rect x="{x}" y="{y - 11}" width="22" height="14" fill="{STRIP}"/>',
            text(x + 30, y + 1, "strip: searched in one dimension less", anchor="start"),
            f'<line x1="{x + 300}" y1="{y - 4}" x2="{x + 322}" y2="{y - 4}" stroke="{PAIR}" '
            f'{SOLID}/>',
            text(x + 330, y + 1, "a pair that is reported in the strip", anchor="start"),
            f'<line x1="{x + 574}" y1="{y - 4}" x2="{x + 596}" y2="{y - 4}" '
            f'stroke="{LEFT_TO_CHILD}" {DASHES}/>',
            text(x + 604, y + 1, "a pair left to the recursion", anchor="start")]


def main():
    width = LEFT + len(CASES) * (WIDTH + GAP)
    height = BOTTOM + 80
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
             f'viewBox="0 0 {width} {height}" font-family="Helvetica, Arial, sans-serif">',
             "<title>The four cases of the divide and conquer</title>",
             '<defs><marker id="tip" markerWidth="8" markerHeight="8" refX="6" refY="3" '
             'orient="auto-start-reverse"><path d="M0,0 L6,3 L0,6" fill="none" stroke="#222"/>'
             "</marker></defs>",
             f'<rect width="{width}" height="{height}" fill="white"/>']
    for number, case in enumerate(CASES):
        parts += panel(case, LEFT + number * (WIDTH + GAP))
    parts += legend(LEFT, BOTTOM + 68)
    parts.append("</svg>")
    print("\n".join(parts))


main()
