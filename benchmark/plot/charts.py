#!/usr/bin/env python3
"""Draws the charts of the manual and of benchmark/results.md.

    charts.py <source> <folder for the charts>

The source is a folder of the laboratory's tables, or one file: methods.csv, closest_pair.csv,
near.md or tracks.md of scripts/benchmark.

Nothing is computed here but shares, quotients, their means and medians, and the Pareto fronts.
Needs matplotlib 3.6. Colours are those of Okabe and Ito, which the colour-blind can tell apart.

SPDX-License-Identifier: LGPL-3.0-or-later
"""

import collections
import csv
import math
import pathlib
import re
import statistics
import sys
import textwrap

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.colors import ListedColormap, LogNorm
from matplotlib.ticker import FuncFormatter, NullFormatter, NullLocator
from PIL import Image

BLACK, ORANGE, SKY, GREEN = "#000000", "#E69F00", "#56B4E9", "#009E73"
YELLOW, BLUE, RED, PINK, GREY = "#B8AC00", "#0072B2", "#D55E00", "#CC79A7", "#777777"

# Files that differ in nothing but what is drawn: no random names, and letters without outlines.
matplotlib.rcParams.update({"svg.hashsalt": "Thick_intersection_d", "svg.fonttype": "none",
                            "font.size": 10, "grid.color": "#DDDDDD", "grid.linewidth": 0.6})


def read_tables(path):
    """The tables of a file, as rows by the names of columns: those of Markdown, or one of CSV without
    its lines of comments. Files that are not there have an empty one."""
    if not path.exists():
        return [[]]
    lines = path.read_text(encoding="utf-8").splitlines()
    if path.suffix == ".csv":
        return [list(csv.DictReader(line for line in lines if not line.startswith("#")))]
    tables, head = [], None
    for line in lines:
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if not line.startswith("|"):
            head = None
        elif head is None:
            head = cells
            tables.append([])
        elif not line.startswith("|---"):
            tables[-1].append(dict(zip(head, cells)))
    return tables


def save(figure, folder, name):
    """As SVG without a date, or as PNG of few colours."""
    path = folder / name
    if path.suffix == ".svg":
        figure.savefig(path, metadata={"Date": None})
    else:
        figure.savefig(path, dpi=125)
        with Image.open(path) as image:
            small = image.convert("RGB").quantize(128, dither=Image.Dither.NONE)
        small.save(path, optimize=True)
    plt.close(figure)
    print(f"{path}: {path.stat().st_size // 1000} kB")


def panels(rows, columns, size, **options):
    """A figure and the grid of its axes, always with rows and columns."""
    return plt.subplots(rows, columns, figsize=size, layout="constrained", squeeze=False, **options)


def prepare(axes, title="", x="", y="", scales=("linear", "linear")):
    axes.set_xscale(scales[0])
    axes.set_yscale(scales[1])
    axes.set_title(title, fontsize=10)
    axes.set_xlabel(x)
    axes.set_ylabel(y)
    axes.grid(True, which="major")


def draw_line(axes, points, style, label, **options):
    """Draws the points (x, y) in a style (colour, marker) or (colour, marker, line)."""
    colour, marker, line = (*style, "-")[:3]
    axes.plot(*zip(*points), color=colour, marker=marker, linestyle=line, label=label,
              **{"linewidth": 1.3, "markersize": 5, "markeredgecolor": BLACK,
                 "markeredgewidth": 0.3, **options})


def marker_for_legend(colour, marker, **options):
    return plt.Line2D([], [], linestyle="none", color=colour, marker=marker, **options)


def legend_below(figure, columns, handles=None, labels=None):
    """A legend of the first axes below all of them, in room that is taken from them."""
    if handles is None:
        handles, labels = figure.axes[0].get_legend_handles_labels()
    height = (0.2 * -(-len(labels) // columns) + 0.15) / figure.get_figheight()
    figure.get_layout_engine().set(rect=(0, height, 1, 1 - height))
    figure.legend(handles, labels, loc="lower center", ncols=columns, fontsize=8, frameon=False)


def hide_sides(axes, *sides):
    for side in sides:
        axes.spines[side].set_visible(False)


def in_order(rows, name):
    """The values in a column, each once."""
    return list(dict.fromkeys(row[name] for row in rows))


def where(rows, **values):
    return [row for row in rows if all(row[name] == value for name, value in values.items())]


GROUP_COLOURS = {"ours": GREEN, "form": ORANGE, "library": BLUE, "kernel": BLUE, "grid": PINK,
                 "boxes": PINK}
MARKERS = "osD^v<>PXhp*dH8sD^v<>PXhp*"
PRECISION = "precision p, bits of the significand"

FIGURES = []  # (tables, function): the function draws a figure and tells its name


def figure_of(*tables):
    """Marks a function that draws from tables. It is called if there are rows in the first one."""
    def mark(function):
        FIGURES.append((tables, function))
        return function
    return mark


def wrong_pairs(row):
    return int(row["missing"]) + int(row["extra"])


def points_of(rows, x, y):
    """The points (x, y), which are functions of a row or names of columns."""
    def value(key, row):
        return float(row[key]) if isinstance(key, str) else key(row)
    return [(value(x, row), value(y, row)) for row in rows]


def viridis_on_white():
    colours = plt.get_cmap("viridis_r").copy()
    colours.set_bad("white")
    return colours


# ---- degree -------------------------------------------------------------------------------------

@figure_of("degree.csv")
def draw_degree(rows):
    rows = [r for r in rows if r["input_bits"] == "24" and int(r["degree"]) > 0]
    sites = set(r["algorithm"] for r in rows if r["call_site"] != "all")
    rows = [r for r in rows if (r["call_site"] != "all") == (r["algorithm"] in sites)]
    figure, ((axes,),) = panels(1, 1, (9, 0.19 * len(rows) + 0.8))
    labels = []
    for y, row in enumerate(reversed(rows)):
        degree = int(row["degree"])
        axes.barh(y, degree, color={1: SKY, 2: GREEN, 3: ORANGE}.get(degree, RED), height=0.66)
        axes.text(degree + 0.06, y, f"{row['longest_number_bits']} bits", va="center", fontsize=8)
        site = "" if row["call_site"] == "all" else ":  " + row["call_site"]
        labels.append(row["algorithm"] + site)
    axes.set_yticks(range(len(rows)), labels, fontsize=8)
    axes.set_ylim(-0.6, len(rows) - 0.4)
    axes.set_xlim(0, max(int(row["degree"]) for row in rows) + 1.5)
    axes.set_xlabel("highest degree of a sign; beside it, the longest number from 24-bit input",
                    fontsize=9)
    hide_sides(axes, "top", "right")
    return figure, "lab_degree.png"


# ---- the precision staircase --------------------------------------------------------------------

STAIR_STYLES = {"x_A <= x_B": (SKY, "o", "degree 1: $x_A \\leq x_B$"),
                "|pq| <= r": (GREEN, "s", "degree 2: $|pq| \\leq r$"),
                "|pq| <= r1 + r2": (YELLOW, "D", "degree 2: $|pq| \\leq r_1 + r_2$"),
                "in circle, as two products": (PINK, "v", "degree 4: in circle, two products"),
                "in circle": (ORANGE, "^", "degree 4: in circle, determinant"),
                "in sphere": (RED, "P", "degree 5: in sphere")}


def mark_formats(axes, top):
    for bits, name in ((24, "float"), (53, "double"), (64, "long double"), (113, "quadruple")):
        axes.axvline(bits, color="#cccccc", linewidth=1, zorder=0)
        axes.text(bits, top, name, rotation=90, fontsize=6.5, color=GREY, ha="right", va="top")


OBJECT_STAIR_STYLES = {"Segment_2": (GREEN, "s", "degree 2: Segment_2"),
                       "Triangle_2": (YELLOW, "D", "degree 2: Triangle_2"),
                       "Segment_3": (BLUE, "o", "degree 3: Segment_3"),
                       "Triangle_3": (ORANGE, "^", "degree 3: Triangle_3"),
                       "Tetrahedron_3": (RED, "P", "degree 3: Tetrahedron_3")}


THICK_STAIR_STYLES = {"capsules, plane": (ORANGE, "^", "degree 4: capsules in the plane"),
                      "capsules, space": (RED, "P", "degree 6: capsules in space")}


TRACK_STAIR_STYLES = {
    "legs, plane, common times": (GREEN, "s", "degree 4: legs in the plane, common times"),
    "legs, space, common times": (BLUE, "o", "degree 4: legs in space, common times"),
    "legs, plane, own times": (ORANGE, "^", "degree 10: legs in the plane"),
    "legs, space, own times": (RED, "P", "degree 10: legs in space")}


def draw_stairs(axes, some_rows, styles, marks_theory):
    """A line for each predicate of the styles, whose rows are given by its name."""
    for predicate, (colour, marker, label) in styles.items():
        some = some_rows(predicate)
        points = points_of(some, "precision",
                           lambda r: 100 * int(r["wrong"]) / int(r["questions"]))
        draw_line(axes, points, (colour, marker), label, markersize=3.5)
        if marks_theory and predicate != "in circle, as two products":
            axes.axvline(float(some[0]["bits_by_theory"]), color=colour, linestyle=":",
                         linewidth=1.4)


def draw_all_stairs(rows, column, styles, tops):
    """Upper row: the first set, lower row: the second one; `tops` are the ends of their axes."""
    inputs, sets = in_order(rows, "input_bits"), in_order(rows, "set")
    figure, grid = panels(2, len(inputs), (9.6, 6), sharex=True, sharey="row",
                          gridspec_kw={"height_ratios": [3, 1.2]})
    for line, name, label, top in zip(grid, sets, ("", PRECISION), tops):
        for axes, bits in zip(line, inputs):
            prepare(axes, f"{name}, input of {bits} bits", label)
            axes.grid(False)
            draw_stairs(axes, lambda p: where(rows, set=name, input_bits=bits, **{column: p}),
                        styles, name == sets[0])
        line[0].set_ylabel("wrong answers, %")
        line[0].set_ylim(-0.03 * top, top)
    for axes in grid[0]:
        mark_formats(axes, tops[0] - 1)
    handles, labels = grid[0][0].get_legend_handles_labels()
    handles.append(plt.Line2D([], [], color=GREY, linestyle=":"))
    legend_below(figure, 4, handles, labels + ["bits that suffice by theory"])
    return figure


@figure_of("staircase.csv")
def draw_staircase(rows):
    return draw_all_stairs(rows, "predicate", STAIR_STYLES, (72, 8)), "lab_staircase.png"


@figure_of("object_staircase.csv")
def draw_object_staircase(rows):
    return (draw_all_stairs(rows, "kind", OBJECT_STAIR_STYLES, (72, 8)),
            "lab_object_staircase.png")


@figure_of("thick_staircase.csv")
def draw_thick_staircase(rows):
    return (draw_all_stairs(rows, "kind", THICK_STAIR_STYLES, (52, 1)),
            "lab_thick_staircase.png")


@figure_of("track_staircase.csv")
def draw_track_staircase(rows):
    return (draw_all_stairs(rows, "kind", TRACK_STAIR_STYLES, (52, 1)),
            "lab_track_staircase.png")


@figure_of("staircase_runs.csv")
def draw_staircase_runs(rows):
    rows = where(rows, input_bits="24")
    styles = {"all pairs": (ORANGE, "o"), "[V03] in rounded numbers": (BLUE, "s"),
              "rounded Delaunay, searched exactly": (PINK, "^"),
              "wrong edges of the rounded Delaunay": (RED, "v"), "this package": (GREEN, "D")}
    sets = in_order(rows, "set")
    figure, (grid,) = panels(1, len(sets), (9.6, 3.9), sharey=True)
    for axes, name in zip(grid, sets):
        prepare(axes, f"{name}, input of 24 bits", PRECISION)
        axes.grid(False)
        for index, (method, style) in enumerate(styles.items()):
            points = points_of(where(rows, set=name, algorithm=method),
                               lambda r: int(r["precision"]) + 0.5 * (index - 2), wrong_pairs)
            draw_line(axes, points, style, method)
        axes.axvline(24, color=GREY, linestyle=":", linewidth=1.2)
        axes.text(24.8, 4300, "the input fits", fontsize=7, color=GREY, rotation=90, va="top")
        axes.set_yscale("symlog", linthresh=1, linscale=0.6)
        axes.set_ylim(-0.4, 5000)
    grid[0].set_ylabel("wrong pairs or edges")
    legend_below(figure, 3)
    return figure, "lab_staircase_runs.png"


# ---- families -----------------------------------------------------------------------------------

def short(number):
    return f"{number}" if number < 10000 else f"{number // 1000}k"


def cell_of(row):
    """The number that colours a cell, and its text: wrong answers per 100 true pairs."""
    if row["status"] != "ok":
        return None, row["status"].replace("SIG", "")
    counts = [(sign, int(row.get(name, 0))) for sign, name in
              (("−", "missing"), ("+", "extra"), ("?", "undecided"))]
    wrong = sum(count for _, count in counts)
    text = "\n".join(sign + short(count) for sign, count in counts if count)
    star = "*" * (row.get("asymmetric", "0") != "0")
    return 100 * wrong / max(int(row["true_pairs"]), 1), text + star


def is_dark(colour):
    red, green, blue = colour[:3]
    return 0.3 * red + 0.59 * green + 0.11 * blue < 0.5


def draw_cells(axes, places, methods, cells, fontsize=6, **options):
    """A map of cells (number, text): grey where there is none, black where it has no number."""
    numbers = [[cells[p, m][0] if (p, m) in cells and cells[p, m][0] is not None
                else float("nan") for m in methods] for p in places]
    image = axes.imshow(numbers, aspect="auto", **options)
    for y, place in enumerate(places):
        for x, method in enumerate(methods):
            number, text = cells.get((place, method), (None, ""))
            if number is None:
                axes.add_patch(plt.Rectangle((x - 0.5, y - 0.5), 1, 1,
                                             color=BLACK if text else "#cccccc"))
            is_light = number is not None and (
                number <= 0 or not is_dark(image.cmap(image.norm(number))))
            axes.text(x, y, text, ha="center", va="center", fontsize=fontsize,
                      color="black" if is_light else "white")
    return image


def label_cells(axes, columns, rows, is_ours):
    """Names of columns, of which ours are green, and texts of rows, and lines between all cells."""
    axes.set_xticks(range(len(columns)), columns, rotation=60, ha="right", fontsize=8,
                    rotation_mode="anchor")
    for label, name in zip(axes.get_xticklabels(), columns):
        label.set_color(GREEN if is_ours(name) else "black")
    axes.set_yticks(range(len(rows)), rows, fontsize=7.5)


def draw_families(rows, dimension):
    rows = where(rows, dimension=dimension)
    methods, families = in_order(rows, "method"), in_order(rows, "family")
    cells = {(r["family"], r["method"]): cell_of(r) for r in rows}
    groups = {r["method"]: r["group"] for r in rows}
    counts = {r["family"]: r["true_pairs"] for r in rows}
    figure, ((axes,),) = panels(1, 1, (11.5, 8.6))
    image = draw_cells(axes, families, methods, cells, 5, cmap=viridis_on_white(),
                       norm=LogNorm(0.01, 10000))
    label_cells(axes, methods, [f"{f}   ({counts[f]})" for f in families],
                lambda method: groups[method] == "ours")
    axes.set_xticks([x - 0.5 for x in range(1, len(methods))], minor=True)
    axes.set_yticks([y - 0.5 for y in range(1, len(families))], minor=True)
    axes.grid(which="minor")
    axes.tick_params(which="minor", length=0)
    axes.set_title(f"Missing (−) and extra (+) pairs in dimension {dimension}. White: none. Black: "
                   "crashed. *: some pairs are found from one of their points only. In brackets: "
                   "true pairs", fontsize=9)
    bar = figure.colorbar(image, ax=axes, shrink=0.6, pad=0.01)
    bar.set_label("wrong pairs per 100 true pairs")
    return figure, f"lab_families_{dimension}d.png"


figure_of("families.csv")(lambda rows: draw_families(rows, "2"))
figure_of("families.csv")(lambda rows: draw_families(rows, "3"))


# ---- speed against accuracy ---------------------------------------------------------------------

ZERO = 3e-6  # where the zero lane is drawn on a logarithmic axis


def pareto_front(points):
    """Those that no other one beats in both time and wrong share, from fast to slow."""
    front = []
    for time, share, method in sorted(points):
        if not front or share < front[-1][1]:
            front.append((time, share, method))
    return front


def speed_and_accuracy(rows, time_of):
    """(time, share of wrong pairs, method) of each row that came to its end."""
    return [(time_of(row), (int(row["wrong"]) if "wrong" in row else wrong_pairs(row))
             / int(row["true_pairs"]), row["method"])
            for row in rows if row.get("status", "ok") == "ok"]


def draw_methods(axes, points, styles):
    # In the zero lane the heights only keep the markers apart.
    lane = sorted(p for p in points if p[1] == 0)
    height = {p[2]: ZERO * (0.36 + 0.64 * (i % 4) / 1.6) for i, p in enumerate(lane)}
    for time, share, method in points:
        draw_line(axes, [(time, share or height[method])], styles[method], method, markersize=7.5,
                  markeredgewidth=0.5, alpha=0.9)
    front = [(time, share or height[method]) for time, share, method in pareto_front(points)]
    axes.step(*zip(*front), where="post", color=BLACK, linewidth=1, linestyle="--", zorder=0)
    axes.plot(*zip(*front), linestyle="none", marker="o", markersize=13, markerfacecolor="none",
              markeredgecolor=BLACK)
    axes.axhspan(ZERO * 0.2, ZERO * 2.2, color="#e8f5ee", zorder=-1)
    axes.set_ylim(ZERO * 0.2, 5)


def draw_chart(rows, time_of, time_label, name):
    """Time against wrong pairs, a marker per method."""
    kinds = collections.defaultdict(list)
    for method, group in {r["method"]: r["group"] for r in rows}.items():
        kinds[GROUP_COLOURS[group]].append(method)
    styles = {method: (colour, marker, "none") for colour, methods in kinds.items()
              for method, marker in zip(methods, MARKERS)}
    sets, methods = in_order(rows, "set"), in_order(rows, "method")
    figure, (grid,) = panels(1, len(sets), (11, 6.6), sharey=True)
    for axes, set_name in zip(grid, sets):
        prepare(axes, set_name, time_label, scales=("log", "log"))
        draw_methods(axes, speed_and_accuracy(where(rows, set=set_name), time_of), styles)
    grid[0].set_yticks([ZERO, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1],
                       ["no wrong\npairs", "$10^{-5}$", "$10^{-4}$", "$10^{-3}$", "$10^{-2}$",
                        "$10^{-1}$", "1"])
    grid[0].yaxis.set_minor_locator(NullLocator())
    grid[0].set_ylabel("wrong pairs per true pair")
    handles = [marker_for_legend(*styles[m][:2], markeredgecolor=BLACK, markeredgewidth=0.5,
                                 markersize=7) for m in methods]
    handles.append(plt.Line2D([], [], color=BLACK, linewidth=1, linestyle="--", marker="o",
                              markersize=10, markerfacecolor="none"))
    legend_below(figure, 5, handles, methods + ["Pareto front"])
    return figure, name


figure_of("predicates.csv")(lambda rows: draw_chart(
    rows, lambda r: float(r["ns"]), "time of one predicate, ns", "lab_chart_predicates.png"))
figure_of("whole_runs.csv")(lambda rows: draw_chart(
    rows, lambda r: 1e9 * float(r["seconds"]) / int(r["true_pairs"]),
    "time of the search per true pair, ns", "lab_chart_runs.png"))


# ---- families of sizes --------------------------------------------------------------------------

def nanoseconds_of(row):
    """The time per object and pair."""
    return 1e9 * float(row["seconds"]) / (int(row["objects"]) + int(row["true_pairs"]))


def of_two_digits(number):
    return f"{number:.0f}" if number >= 10 else f"{number:.2g}"


def place_of(row):
    return row["shape"], row["family"]


def times_over_ours(rows):
    """(row, its time over that of this package) of each row that came to its end."""
    own = {place_of(r): float(r["seconds"]) for r in where(rows, method="ours")}
    return [(r, float(r["seconds"]) / own[place_of(r)]) for r in rows if r["status"] == "ok"]


def label_places(axes, places, methods, rows):
    counts = {place_of(r): f"{short(int(r['objects']))}, {short(int(r['true_pairs']))}"
              for r in rows}
    label_cells(axes, methods, [f"{shape}, {family}   ({counts[shape, family]})"
                                for shape, family in places],
                lambda method: method.startswith("ours"))
    for y in range(1, len(places)):
        if places[y][0] != places[y - 1][0]:
            axes.axhline(y - 0.5, color=BLACK, linewidth=1)


def draw_times_and_wrong(rows, methods, times, wrong, height, limits, titles):
    """Two panels, with a column for each method and a row for each place. The limits are the least
    ratio of times and the largest share of wrong pairs."""
    places = list(dict.fromkeys(place_of(r) for r in rows))
    least_time, most_wrong = limits
    figure, ((left, right),) = panels(1, 2, (11.5, height), sharey=True)
    image = draw_cells(left, places, methods, times, cmap="PuOr_r", norm=LogNorm(0.01, 100))
    bar = figure.colorbar(image, ax=left, location="bottom", shrink=0.8, pad=0.01, extend="max")
    bar.ax.set_xlim(least_time, 100)
    image = draw_cells(right, places, methods, wrong, cmap=viridis_on_white(),
                       norm=LogNorm(0.01, most_wrong))
    figure.colorbar(image, ax=right, location="bottom", shrink=0.8, pad=0.01)
    for axes, title in zip((left, right), titles):
        label_places(axes, places, methods, rows)
        axes.set_title(title, fontsize=9)
    return figure


@figure_of("sizes.csv")
def draw_sizes(rows):
    methods = in_order(where(rows, shape=rows[-1]["shape"]), "method")
    times = {(place_of(r), r["method"]): (None, "> 120 s") for r in rows}
    for row, time in times_over_ours(rows):
        is_ours = row["method"] == "ours"
        text = f"{of_two_digits(nanoseconds_of(row))} ns" if is_ours else of_two_digits(time)
        times[place_of(row), row["method"]] = time, text
    wrong = {(place_of(r), r["method"]): cell_of(r) for r in rows}
    figure = draw_times_and_wrong(rows, methods, times, wrong, 7.6, (0.5, 100),
                                  ("time over ours; of ours, per object and pair",
                                   "missing (−) and extra (+) pairs; color: per 100 true pairs"))
    return figure, "lab_sizes.png"


def summary_of(rows, times):
    """A row of a method: the mean time over ours, and the family with most wrong pairs."""
    worst = max(rows, key=lambda r: wrong_pairs(r) / int(r["true_pairs"]))
    logarithms = [math.log(times[place_of(r), r["method"]]) for r in rows if r["status"] == "ok"]
    return {**worst, "set": worst["shape"], "status": "ok",
            "time": math.exp(sum(logarithms) / len(logarithms))}


@figure_of("sizes.csv")
def draw_chart_of_sizes(rows):
    times = {(place_of(r), r["method"]): time for r, time in times_over_ours(rows)}
    summaries = [summary_of(where(rows, shape=shape, method=method), times)
                 for shape in in_order(rows, "shape")
                 for method in in_order(where(rows, shape=shape), "method")]
    figure, name = draw_chart(summaries, lambda r: r["time"],
                              "time over ours, geometric mean of all families",
                              "lab_chart_sizes.png")
    end = 1.3 * max(r["time"] for r in summaries)
    ticks = [t for t in (1, 2, 5, 10, 20, 50, 100, 200, 500) if t < end]
    for axes in figure.axes:
        axes.set_xlim(0.8, end)
        axes.set_xticks(ticks, ticks)
        axes.xaxis.set_minor_locator(NullLocator())
    figure.axes[0].set_ylabel("wrong pairs per true pair, in the worst family")
    return figure, name


# ---- segments, triangles and tetrahedra ---------------------------------------------------------

def time_cells(rows, own_method):
    """Times over those of our method; the text of our columns is their time."""
    own = {place_of(r): float(r["ns"]) for r in where(rows, method=own_method)}
    cells = {}
    for row in rows:
        if row["status"] != "ok":
            cells[place_of(row), row["method"]] = None, row["status"].replace("SIG", "")
            continue
        ratio = float(row["ns"]) / own[place_of(row)]
        text = of_two_digits(float(row["ns"]) if row["group"] == "ours" else ratio)
        cells[place_of(row), row["method"]] = ratio, text
    return cells


def draw_object_families(rows, dimension, height, own_method, name):
    rows = [{**r, "shape": r["kind"], "objects": r["questions"]}
            for r in where(rows, dimension=dimension)]
    ours = in_order(where(rows, group="ours"), "method")
    methods = [m for m in in_order(rows, "method") if m not in ours] + ours
    wrong = {(place_of(r), r["method"]): cell_of(r) for r in rows}
    times = time_cells(rows, own_method)
    figure = draw_times_and_wrong(rows, methods, times, wrong, height, (0.1, 1000),
                                  (f"time over \"{own_method}\"; of ours, ns per answer",
                                   "missing (−), extra (+), undecided (?); color: per 100 true pairs"))
    return figure, f"{name}_{dimension}d.png"


def draws_object_families(table, dimension, height, own_method, name):
    figure_of(table)(lambda rows: draw_object_families(rows, dimension, height, own_method, name))


draws_object_families("object_families.csv", "2", 8.6, "ours, EPICK", "lab_object_families")
draws_object_families("object_families.csv", "3", 11, "ours, EPICK", "lab_object_families")
draws_object_families("thick_families.csv", "2", 6.2, "ours, search", "lab_thick_families")
draws_object_families("thick_families.csv", "3", 8, "ours, search", "lab_thick_families")
draws_object_families("track_families.csv", "2", 4.6, "ours, search", "lab_track_families")
draws_object_families("track_families.csv", "3", 4.6, "ours, search", "lab_track_families")


def draw_chart_of_families(rows, kind, families, name):
    some = [{**r, "set": f"{kind}, {r['family']}",
             "wrong": sum(int(r[name]) for name in ("missing", "extra", "undecided"))}
            for family in families for r in where(rows, kind=kind, family=family)]
    return draw_chart(some, lambda r: float(r["ns"]), "time of one answer, ns", name)


@figure_of("object_families.csv")
def draw_object_chart(rows):
    """Of triangles in space: one family where nothing touches, and two where much does."""
    return draw_chart_of_families(rows, "Triangle_3",
                                  ("general", "shared vertices", "tilted plane, 50 bits"),
                                  "lab_object_chart.png")


@figure_of("track_families.csv")
def draw_track_chart(rows):
    """Of points that move in space: one family without ties, and two of ties."""
    return draw_chart_of_families(rows, "legs, space",
                                  ("general", "in between, tenths", "shifted by an ulp"),
                                  "lab_track_chart.png")


@figure_of("object_stages.csv")
def draw_object_stages(rows):
    colours = {"double": GREEN, "int64": SKY, "int128": BLUE, "int192": ORANGE, "exact": RED}
    kinds = in_order(rows, "kind")
    figure, (grid,) = panels(1, len(kinds), (11.5, 4.6))
    for axes, kind in zip(grid, kinds):
        some = where(rows, kind=kind)
        for y, row in enumerate(reversed(some)):
            counts = [int(row[tier]) for tier in colours]
            left = 0
            for count, colour in zip(counts, colours.values()):
                share = 100 * count / sum(counts)
                axes.barh(y, share, left=left, color=colour, height=0.7)
                left += share
            axes.text(103, y, f"{float(row['bits']):.0f}", va="center", fontsize=7.5)
        is_labelled = kind in (kinds[0], "Segment_3")
        axes.set_yticks(range(len(some)),
                        [r["family"] if is_labelled else "" for r in reversed(some)], fontsize=7.5)
        axes.set_title(kind, fontsize=9)
        axes.text(103, len(some) - 0.4, "bits", fontsize=7.5)
        axes.set_xlim(0, 100)
        axes.set_ylim(-0.5, len(some) - 0.5)
        axes.set_xlabel("pairs of boxes, %", fontsize=8)
        axes.tick_params(labelsize=7.5)
        hide_sides(axes, "top", "right")
    handles = [plt.Rectangle((0, 0), 1, 1, color=colour) for colour in colours.values()]
    legend_below(figure, 5, handles, list(colours))
    return figure, "lab_object_stages.png"


# ---- pictures -----------------------------------------------------------------------------------

@figure_of("microscope.csv")
def draw_microscope(rows):
    views, forms = in_order(rows, "view"), in_order(rows, "form")
    colours = ("#f4f4f4", RED, BLUE)
    figure, grid = panels(len(views), len(forms), (10, 5.7), sharex=True, sharey=True)
    for line, view in zip(grid, views):
        for axes, form in zip(line, forms):
            image = [[".xm".index(kind) for count, kind in re.findall(r"(\d+)(\D)", row["pixels"])
                      for _ in range(int(count))] for row in where(rows, view=view, form=form)]
            axes.imshow(image, origin="lower", cmap=ListedColormap(colours), vmin=0, vmax=2,
                        interpolation="nearest", extent=(-128, 128, -128, 128))
            wrong = sum(value != 0 for pixels in image for value in pixels)
            axes.set_title(f"{form}: {wrong} wrong", fontsize=9)
            axes.tick_params(labelsize=7)
        line[0].set_ylabel(f"{view}\ny of q, in $2^{{-56}}$", fontsize=8)
    for axes in grid[-1]:
        axes.set_xlabel("x of q, in $2^{-56}$", fontsize=8)
    handles = [plt.Rectangle((0, 0), 1, 1, color=colour) for colour in colours]
    legend_below(figure, 3, handles, ["right", "wrongly within r", "wrongly beyond r"])
    return figure, "lab_microscope.png"


@figure_of("offsets.csv", "scales.csv")
def draw_sweeps(offsets, scales):
    styles = {"double": (ORANGE, "o"), "double, sqrt": (SKY, "s"), "double, hypot": (PINK, "v"),
              "double, expanded": (RED, "^"), "float": (GREY, "P"), "long double": (BLUE, "X"),
              "ours": (GREEN, "D")}
    figure, (grid,) = panels(1, 2, (9.6, 4.6), sharey=True)
    for axes, rows, what, title, every in (
            (grid[0], offsets, "offset", "400 random points in a unit square, r = 0.1", 2),
            (grid[1], scales, "scale", "lattice of step 0.1 $\\cdot$ scale, r = 5 steps", 4)):
        prepare(axes, title, f"{what} of the scene, as a power of two")
        for method, style in styles.items():
            points = points_of(where(rows, method=method), "exponent",
                               lambda r: wrong_pairs(r) / max(int(r["true_pairs"]), 1))
            draw_line(axes, points, style, method, markersize=4, markevery=every,
                      zorder=3 if method == "ours" else 2)
        axes.set_yscale("symlog", linthresh=1e-4, linscale=0.5)
        axes.set_ylim(-3e-5, 300)
    grid[0].set_ylabel("wrong pairs per true pair")
    legend_below(figure, 7)
    return figure, "lab_sweeps.png"


@figure_of("tie_density.csv")
def draw_tie_density(rows):
    styles = {"double": (ORANGE, "o"), "EPICK": (RED, "s"), "EPECK": (PINK, "v"),
              "Mpzf": (BLUE, "^"), "rational": (GREY, "P"), "ours, double": (GREEN, "D"),
              "ours, EPECK": (YELLOW, "X"), "ours, rational": (SKY, "*")}
    figure, ((axes,),) = panels(1, 1, (8, 4.6))
    prepare(axes, "", "share of pairs exactly at the distance", "time of one predicate, ns",
            ("linear", "log"))
    for method in in_order(rows, "method"):
        draw_line(axes, points_of(where(rows, method=method), "share_of_ties", "ns"),
                  styles[method], method)
    axes.set_xscale("symlog", linthresh=0.001, linscale=0.4)
    axes.set_xticks([0, 0.001, 0.01, 0.1, 1], ["0", "0.001", "0.01", "0.1", "1"])
    axes.set_xlim(-0.0002, 1.3)
    axes.legend(loc="center left", bbox_to_anchor=(1.01, 0.5), fontsize=9, frameon=False)
    return figure, "lab_tie_density.png"


# ---- scenes -------------------------------------------------------------------------------------

@figure_of("certificates.csv")
def draw_certificates(rows):
    tiers = in_order(sorted(rows, key=lambda r: float(r["bits"])), "tier")
    colours = dict(zip(tiers, [GREEN, SKY, BLUE, ORANGE] if len(tiers) > 2 else [GREEN, ORANGE]))
    widths = dict(zip(in_order(rows, "stored"), (1.3, 0.3)))
    markers = dict(zip(sorted(in_order(rows, "file")), MARKERS))
    figure, ((axes,),) = panels(1, 1, (9.6, 5.6))
    for row in rows:
        draw_line(axes, points_of([row], "log2_extent", "log2_reach"),
                  (colours[row["tier"]], markers[row["file"]], "none"), None, markersize=7.5,
                  markeredgewidth=widths[row["stored"]])
    for bits, name in ((26, "$2^{26}$ steps: double"), (31, "$2^{31}$: 64-bit integers"),
                       (63, "$2^{63}$: 128-bit integers")):
        axes.axhline(bits, color=GREY, linewidth=1, linestyle=":")
        axes.text(0.5, bits + 0.8, name, fontsize=8, color=GREY)
    axes.set_xlim(0, 120)
    axes.set_ylim(0, 115)
    axes.set_xlabel("extent of the scene, $\\log_2$ of steps of its grid")
    axes.set_ylabel("distance bound, $\\log_2$ of steps of the grid")
    handles = [marker_for_legend(colour, "o", label=tier) for tier, colour in colours.items()]
    handles += [marker_for_legend("white", "o", label=stored, markeredgecolor=BLACK,
                                  markeredgewidth=width) for stored, width in widths.items()]
    handles += [marker_for_legend(GREY, marker, label=file) for file, marker in markers.items()]
    axes.legend(handles=handles, loc="center left", bbox_to_anchor=(1.01, 0.5), fontsize=8,
                frameon=False)
    return figure, "lab_certificates.png"


@figure_of("work.csv")
def draw_work(rows):
    styles = {"sweep, reach r": (GREEN, "D"), "sweep, reach 2 r": (GREEN, "D", ":"),
              "grid of cells r": (ORANGE, "o"), "sweep along x alone": (GREY, "^")}
    figure, (grid,) = panels(1, 2, (9, 4.2), sharey=True)
    for axes, dimension in zip(grid, "23"):
        prepare(axes, f"dimension {dimension}, uniform, k about n", "points n",
                scales=("log", "log"))
        for method, style in styles.items():
            draw_line(axes, points_of(where(rows, dimension=dimension, method=method), "n",
                                      "calls_per_output"), style, method)
    grid[0].set_ylabel("predicate calls per n + k")
    legend_below(figure, 3)
    return figure, "lab_work.png"


# ---- answers that change, and the paper once more -----------------------------------------------

@figure_of("stability.csv", "fused.csv")
def draw_stability(of_one_build, of_two_builds):
    rows = of_one_build + of_two_builds
    methods, changes = in_order(rows, "method"), in_order(rows, "change")
    cells = {(m, c): (0, "") for m in methods for c in changes}
    for row in rows:
        share = 100 * int(row["changed"]) / int(row["questions"])
        cells[row["method"], row["change"]] = share, f"{share:.1f}" if share else "0"
    figure, ((axes,),) = panels(1, 1, (8, 3.6))
    cells = {place: (share or float("nan"), text) for place, (share, text) in cells.items()}
    image = draw_cells(axes, methods, changes, cells, 9, cmap=viridis_on_white(), vmin=0, vmax=70)
    axes.set_xticks(range(len(changes)), [textwrap.fill(c, 14) for c in changes], fontsize=8)
    axes.set_yticks(range(len(methods)), methods, fontsize=9)
    axes.get_yticklabels()[-1].set_color(GREEN)
    figure.colorbar(image, ax=axes, pad=0.01).set_label("changed answers, %")
    return figure, "lab_stability.png"


def draw_experiment(axes, experiment, rows):
    own = float(where(rows, method="this package")[0]["seconds"])
    for y, row in enumerate(reversed(rows)):
        seconds = float(row["seconds"])
        colour = (GREEN if row["method"].startswith("this") else
                  BLUE if row["method"].startswith("[V03]") else
                  RED if row["degree"] == "4" else GREY)
        axes.barh(y, 1000 * seconds, color=colour, height=0.66)
        ratio = seconds / own
        axes.text(1000 * seconds * 1.08, y,
                  f"{1000 * seconds:,.1f} ms, {ratio:,.{0 if ratio > 10 else 1}f} ×",
                  va="center", fontsize=8)
    axes.set_yticks(range(len(rows)), [r["method"] for r in reversed(rows)], fontsize=8)
    axes.set_xscale("log")
    all_seconds = [float(r["seconds"]) for r in rows]
    axes.set_xlim(400 * min(all_seconds), 9000 * max(all_seconds))
    axes.set_title(f"{experiment}: n = {int(rows[0]['n']):,}, k = {int(rows[-1]['k']):,}",
                   fontsize=9, loc="left")
    hide_sides(axes, "top", "right")


@figure_of("section_3.csv")
def draw_section_3(rows):
    experiments = in_order(rows, "experiment")
    some = [where(rows, experiment=e) for e in experiments]
    figure, grid = panels(len(experiments), 1, (9, 5.8),
                          gridspec_kw={"height_ratios": [len(s) for s in some]})
    for (axes,), experiment, own_rows in zip(grid, experiments, some):
        draw_experiment(axes, experiment, own_rows)
    grid[-1][0].set_xlabel("time, ms; × against this package")
    return figure, "lab_section_3.png"


# ---- methods -------------------------------------------------------------------------------------

OURS = "Thick_intersection_d"
OURS_2 = OURS + ", 2 threads"
SORT = "std::sort of x"
BOX_DEFAULT = "box_self_intersection_d, cutoff 10"
BOX_BEST = "box_self_intersection_d, best cutoff"

STYLES = {  # colour, marker, line
    OURS: (RED, "o", "-"),
    OURS_2: (RED, "o", ":"),
    SORT: (BLACK, "", "--"),
    "[V03]": (BLUE, "s", "-"),
    BOX_BEST: (GREEN, "^", "-"),
    "Delaunay EPICK + search": (PINK, "D", "-"),
    "Kd_tree + Fuzzy_sphere": (ORANGE, "v", "-"),
    "nanoflann": (SKY, "P", "-"),
    "all pairs": (GREY, "", ":"),
}

CLOSEST_STYLES = {
    "closest_pair": (RED, "o", "-"),
    "has_close_pair, no": (BLUE, "s", "-"),
    "has_close_pair, yes": (GREEN, "^", "-"),
    SORT: (BLACK, "", "--"),
    "divide and conquer": (RED, "o", ":"),
    "grid of cells r, no": (BLUE, "s", ":"),
    "Delaunay": (PINK, "D", "-"),
    "Kd_tree": (ORANGE, "v", "-"),
}

Result = collections.namedtuple("Result", "dimension neighbours n method k ms")


def results_of(rows):
    """The results of a table, and as a method of its own the best cutoff for each scene."""
    results = [Result(r["dimension"], float(r["neighbours"]), int(r["n"]), r["method"],
                      int(r["k"]), float(r["ms"])) for r in rows]
    best = {}
    for result in results:
        if result.method.startswith("box_self"):
            place = result[:3]
            best[place] = min(best.get(place, result), result, key=lambda r: r.ms)
    return results + [result._replace(method=BOX_BEST) for result in best.values()]


def plain(value, _=None):
    """0.1, 1, 10, 1000, 10⁵, as text, so that the file needs no outlines of letters."""
    if value < 1e4:
        return f"{value:g}"
    return "10" + str(len(f"{value:.0f}") - 1).translate(str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹"))


def show_plainly(axis):
    axis.set_major_formatter(FuncFormatter(plain))
    axis.set_minor_formatter(NullFormatter())


def prepare_axes(axes, title, x, y=""):
    prepare(axes, title, x, y, ("log", "log"))
    show_plainly(axes.xaxis)
    show_plainly(axes.yaxis)


def words(neighbours):
    return "n/2" if neighbours == 0.5 else f"{neighbours:g} n"


def draw_lines(axes, results, chosen, point):
    """Draws a line per method through point(result) for the results that are chosen."""
    for method, style in STYLES.items():
        points = sorted(point(r) for r in results if r.method == method and chosen(r))
        if points:
            draw_line(axes, points, style, method, linewidth=2.2 if method == OURS else 1.3,
                      zorder=3 if method == OURS else 2)


@figure_of("methods.csv")
def draw_time_against_n(rows):
    results = results_of(rows)
    figure, grid = panels(2, 2, (8, 8.2), sharex=True, sharey=True)
    for line, dimension, x in zip(grid, ("2D", "3D"), ("", "points n")):
        for axes, neighbours, y in zip(line, (0.5, 10.0), ("time per point (ns)", "")):
            prepare_axes(axes, f"{dimension}, uniform, k ≈ {words(neighbours)}", x, y)
            draw_lines(axes, results, lambda r: r[:2] == (dimension, neighbours),
                       lambda r: (r.n, 1e6 * r.ms / r.n))
    legend_below(figure, 3)
    return figure, "time_against_n.svg"


def largest_common_n(results):
    """The number of points at which k/n was varied."""
    return max(r.n for r in results if r.neighbours == 100)


@figure_of("methods.csv")
def draw_time_against_k(rows):
    results = results_of(rows)
    n = largest_common_n(results)
    figure, (grid,) = panels(1, 2, (8, 5), sharey=True)
    for axes, dimension, y in zip(grid, ("2D", "3D"), ("time (ms)", "")):
        prepare_axes(axes, f"{dimension}, uniform, n = {plain(n)}", "pairs per point k/n", y)
        draw_lines(axes, results, lambda r: r.dimension == dimension and r.n == n,
                   lambda r: (r.k / r.n, r.ms))
    legend_below(figure, 3)
    return figure, "time_against_k.svg"


def draw_bars(axes, methods, times, unit):
    """A bar per method, from the time `unit` to its own."""
    for place, method in enumerate(reversed(methods)):
        ratio = times[method] / unit
        axes.barh(place, ratio - 1, left=1, height=0.62,
                  color=RED if method.startswith(OURS) else BLUE)
        axes.annotate(f"{ratio:.2f}" if ratio < 10 else f"{ratio:.0f}", (ratio, place),
                      xytext=(4 if ratio >= 1 else -4, 0), textcoords="offset points",
                      va="center", ha="left" if ratio >= 1 else "right", fontsize=8)
    axes.axvline(1, color=BLACK, linewidth=1)
    axes.set_yticks(range(len(methods)), reversed(methods), fontsize=9)
    axes.tick_params(axis="y", length=0)
    hide_sides(axes, "top", "right", "left")


@figure_of("methods.csv")
def draw_rivals(rows):
    """Bars on four scenes, the methods in the order of their geometric means."""
    results = results_of(rows)
    n = largest_common_n(results)
    scenes = [(dimension, k) for dimension in ("2D", "3D") for k in (0.5, 10.0)]
    times = [{r.method: r.ms for r in results if (r.dimension, r.neighbours, r.n) == (*scene, n)}
             for scene in scenes]
    methods = sorted((m for m in [*STYLES, BOX_DEFAULT] if m != SORT and m in times[0]),
                     key=lambda m: statistics.geometric_mean(t[m] for t in times))
    figure, grid = panels(2, 2, (8.4, 1.5 + 0.44 * len(methods)), sharex=True, sharey=True)
    for axes, scene, scene_times in zip(grid.flat, scenes, times):
        unit = scene_times[SORT]
        axes.set_xscale("log")
        draw_bars(axes, methods, scene_times, unit)
        axes.set_title(f"{scene[0]}, k ≈ {words(scene[1])}: 1 is {unit:.0f} ms", fontsize=10,
                       loc="left")
        show_plainly(axes.xaxis)
    low, high = grid[0, 0].get_xlim()
    grid[0, 0].set_xlim(low / 3, 2 * high)
    figure.supxlabel("time / time of std::sort", fontsize=10)
    figure.suptitle(f"uniform, n = {plain(n)}", fontsize=11)
    return figure, "rivals.svg"


@figure_of("closest_pair.csv")
def draw_closest_pair(rows):
    figure, (grid,) = panels(1, 2, (8, 5.4), sharey=True)
    for axes, dimension, y in zip(grid, "23", ("time per point (ns)", "")):
        prepare_axes(axes, f"{dimension}D, uniform, 1 thread", "points n", y)
        for method, style in CLOSEST_STYLES.items():
            points = [(int(row["n"]), 1e9 * float(row["seconds"]) / int(row["n"]))
                      for row in where(rows, dimension=dimension, method=method)]
            if points:
                draw_line(axes, points, style, method)
    legend_below(figure, 3)
    return figure, "closest_pair_time.svg"

# ---- near objects --------------------------------------------------------------------------------

BOXES = "grown boxes alone"
SHAPES = ("2D segments", "3D segments", "3D triangles")



def shape_of(row):
    return row["scene"].split(",")[0]


def wrong_shares(rows, method):
    """Missing and extra pairs in percent of the pairs there are, or nothing without rows."""
    chosen = where(rows, method=method)
    pairs = sum(int(row["pairs"]) for row in chosen)
    return [100 * sum(int(row[name]) for row in chosen) / pairs
            for name in ("missing", "extra") if chosen]


def annotate(axes, value, place, text):
    axes.annotate(text, (value, place), xytext=(4, 0), textcoords="offset points", va="center",
                  fontsize=8)


def draw_near_times(axes, rows, methods):
    for place, method in enumerate(reversed(methods)):
        milliseconds = float(where(rows, method=method)[0]["ms"])
        colour = RED if method == OURS else GREY if method == BOXES else BLUE
        axes.barh(place, milliseconds, height=0.62, color=colour)
        annotate(axes, milliseconds, place, f"{milliseconds:.0f}")
    axes.set_xscale("log")
    show_plainly(axes.xaxis)
    axes.set_yticks(range(len(methods)), reversed(methods), fontsize=9)


def draw_wrong_pairs(axes, rows, methods):
    for place, method in enumerate(reversed(methods)):
        if not (shares := wrong_shares(rows, method)):
            continue
        axes.barh(place, shares[0], height=0.62, color=ORANGE)
        axes.barh(place, shares[1], left=shares[0], height=0.62, color=SKY)
        total = sum(shares)
        annotate(axes, total, place, "none" if total == 0 else f"{total:.2f} %")


@figure_of("near.md")
def draw_near_objects(times, wrong, *_):
    """A scene is called <dimension>D <kinds>, <name>. Wrong pairs are counted over all scenes with
    ties of the dimension and kind."""
    methods = {shape: [row["method"] for row in times if shape_of(row) == shape]
               for shape in SHAPES}
    heights = [len(methods[shape]) for shape in SHAPES]
    figure, grid = panels(len(SHAPES), 2, (9, 2 + 0.27 * sum(heights)), sharex="col", sharey="row",
                          gridspec_kw={"height_ratios": heights})
    for (left, right), shape in zip(grid, SHAPES):
        draw_near_times(left, [row for row in times if shape_of(row) == shape], methods[shape])
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
    grid[0, 1].legend(bars, ("missing", "extra"), fontsize=8, frameon=False, loc="center right")
    return figure, "near_objects.svg"


TRACK_STYLES = {"boxes of legs alone": (GREY, "s", "none"),
                "sweep in doubles": (ORANGE, "^", "none"),
                "positions each minute": (PINK, "D", "none"), "PostGIS": (BLUE, "o", "none")}


@figure_of("tracks.md")
def draw_near_tracks(times, *_):
    """A row for each scene; above a marker, the pairs that the method misses."""
    scenes = in_order(times, "scene")
    figure, ((axes,),) = panels(1, 1, (9, 0.42 * len(scenes) + 1.3))
    for method, style in TRACK_STYLES.items():
        points = [(float(row["time / ours"]), -scenes.index(row["scene"]))
                  for row in where(times, method=method)]
        if points:
            draw_line(axes, points, style, method, markersize=7)
    for row in times:
        missing = int(row["missing, extra"].split(",")[0] or 0)
        if missing:
            axes.annotate(f"−{100 * missing / (int(row['pairs']) + missing):.2g} %",
                          (float(row["time / ours"]), -scenes.index(row["scene"])), xytext=(0, 6),
                          textcoords="offset points", ha="center", fontsize=7.5)
    prepare(axes, x="time / ours; above a marker, the share of pairs that are missing",
            scales=("log", "linear"))
    show_plainly(axes.xaxis)
    axes.axvline(1, color=BLACK, linewidth=1)
    axes.set_yticks([-y for y in range(len(scenes))], scenes)
    legend_below(figure, 4)
    return figure, "near_tracks.svg"


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: charts.py <folder of the laboratory's tables, or a file> <folder>")
    source, target = map(pathlib.Path, sys.argv[1:])
    target.mkdir(parents=True, exist_ok=True)
    for tables, draw in FIGURES:
        if source.is_dir() or source.name == tables[0]:
            folder = source if source.is_dir() else source.parent
            rows = [table for name in tables for table in read_tables(folder / name)]
            if rows[0]:
                figure, name = draw(*rows)
                save(figure, target, name)


if __name__ == "__main__":
    main()
