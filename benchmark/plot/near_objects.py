#!/usr/bin/env python3
# Draws the chart of near objects from what `near_objects_table` printed: how long each method takes
# on uniform objects, and how many pairs it has wrong where there are ties.
#
#   near_objects.py <near.md> <folder>
#
# A scene of the tables is called <dimension>D <kinds>, <name>. Wrong pairs are counted over all
# scenes with ties of the dimension and kind.
#
# SPDX-License-Identifier: LGPL-3.0-or-later

import collections
import sys

from matplotlib.ticker import FuncFormatter, NullFormatter

from style import BLUE, GREY, ORANGE, RED, SKY, hide_sides, panels, save, where

OURS = "Thick_intersection_d"
BOXES = "grown boxes alone"
SHAPES = ("2D segments", "3D segments", "3D triangles")

Wrong = collections.namedtuple("Wrong", "missing extra")


def read_tables(path):
    """The rows of each table, by the names of its columns."""
    tables, head = [], None
    with open(path, encoding="utf-8") as file:
        for line in file:
            cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
            if not line.startswith("|"):
                head = None
            elif head is None:
                head = cells
                tables.append([])
            elif not line.startswith("|---"):
                tables[-1].append(dict(zip(head, cells)))
    return tables


def table_with(tables, column):
    found = [table for table in tables if table and column in table[0] and "scene" in table[0]]
    if len(found) != 1:
        sys.exit(f"There is to be one table with the column {column}, and there are {len(found)}.")
    return found[0]


def shape_of(row):
    return row["scene"].split(",")[0]


def wrong_pairs(rows, method):
    """Percentages of the pairs there are, or nothing if the method has no rows."""
    chosen = where(rows, method=method)
    if not chosen:
        return None
    pairs = sum(int(row["pairs"]) for row in chosen)
    return Wrong(*(100 * sum(int(row[name]) for row in chosen) / pairs for name in Wrong._fields))


def annotate(axes, value, place, text):
    axes.annotate(text, (value, place), xytext=(4, 0), textcoords="offset points", va="center",
                  fontsize=8)


def draw_times(axes, rows, methods):
    for place, method in enumerate(reversed(methods)):
        milliseconds = float(where(rows, method=method)[0]["ms"])
        colour = RED if method == OURS else GREY if method == BOXES else BLUE
        axes.barh(place, milliseconds, height=0.62, color=colour)
        annotate(axes, milliseconds, place, f"{milliseconds:.0f}")
    axes.set_xscale("log")
    axes.xaxis.set_major_formatter(FuncFormatter(lambda x, _: f"{x:g}"))
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.set_yticks(range(len(methods)), reversed(methods), fontsize=9)


def draw_wrong_pairs(axes, rows, methods):
    for place, method in enumerate(reversed(methods)):
        wrong = wrong_pairs(rows, method)
        if wrong is None:
            continue
        axes.barh(place, wrong.missing, height=0.62, color=ORANGE)
        axes.barh(place, wrong.extra, left=wrong.missing, height=0.62, color=SKY)
        total = sum(wrong)
        annotate(axes, total, place, "none" if total == 0 else f"{total:.2f} %")


def draw(path, folder):
    tables = read_tables(path)
    times, wrong = table_with(tables, "ms"), table_with(tables, "missing")
    methods = {shape: [row["method"] for row in times if shape_of(row) == shape]
               for shape in SHAPES}
    heights = [len(methods[shape]) for shape in SHAPES]
    figure, grid = panels(len(SHAPES), 2, (9, 2 + 0.27 * sum(heights)), sharex="col", sharey="row",
                          gridspec_kw={"height_ratios": heights})
    for (left, right), shape in zip(grid, SHAPES):
        draw_times(left, [row for row in times if shape_of(row) == shape], methods[shape])
        draw_wrong_pairs(right, [row for row in wrong if shape_of(row) == shape], methods[shape])
        left.set_title(f"{shape}, uniform, n = {int(times[0]['n']):,}", fontsize=10, loc="left")
        right.set_title(f"{shape}, scenes with ties", fontsize=10, loc="left")
        for axes in (left, right):
            axes.tick_params(axis="y", length=0)
            hide_sides(axes, "top", "right")
    milliseconds = [float(row["ms"]) for row in times]
    grid[0, 0].set_xlim(min(milliseconds) / 2, 3 * max(milliseconds))
    grid[0, 1].set_xlim(0, 1.3 * grid[0, 1].get_xlim()[1])
    grid[-1, 0].set_xlabel("time (ms)")
    grid[-1, 1].set_xlabel("wrong pairs, in percent of the pairs there are")
    bars = [grid[0, 1].barh(0, 0, color=colour) for colour in (ORANGE, SKY)]
    grid[0, 1].legend(bars, Wrong._fields, fontsize=8, frameon=False, loc="center right")
    save(figure, folder, "near_objects.svg")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit("usage: near_objects.py <near.md> <folder>")
    draw(*sys.argv[1:])
