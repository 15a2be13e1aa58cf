#!/usr/bin/env python3
# Draws the charts of the manual from what `compare` and `closest_pair_table --chart` wrote.
#
#   speed.py <methods.json> <folder>
#   speed.py <closest_pair.csv> <folder>
#
# A measurement of `compare` is called <dimension>/<scene>/<k/n aimed at>/<n>/<method>; repetitions
# are reduced to their median. Of box_self_intersection_d the best cutoff is shown for each scene,
# besides the default.
#
# SPDX-License-Identifier: LGPL-3.0-or-later

import collections
import json
import statistics
import sys

from matplotlib.ticker import FuncFormatter, NullFormatter

from style import (BLACK, BLUE, GREEN, GREY, ORANGE, PINK, RED, SKY, YELLOW, draw_line, hide_sides,
                   legend_below, panels, prepare, read_csv, save, where)

OURS = "Thick_intersection_d"
OURS_2 = OURS + ", 2 threads"
SORT = "std::sort of x"
BOX_DEFAULT = "box_self_intersection_d, cutoff 10"
BOX_BEST = "box_self_intersection_d, best cutoff"
PAPER = "[V03]"

STYLES = {  # colour, marker, line
    OURS: (RED, "o", "-"),
    OURS_2: (RED, "o", ":"),
    SORT: (BLACK, "", "--"),
    PAPER: (BLUE, "s", "-"),
    BOX_BEST: (GREEN, "^", "-"),
    "Delaunay EPICK + search": (PINK, "D", "-"),
    "Delaunay EPECK + search": (PINK, "D", ":"),
    "Kd_tree + Fuzzy_sphere": (ORANGE, "v", "-"),
    "nanoflann": (SKY, "P", "-"),
    "Boost.Geometry rtree": (YELLOW, "X", "-"),
    "ANN": (GREY, "*", "-"),
    "all pairs": (GREY, "", ":"),
}

CLOSEST_STYLES = {
    "closest_pair": (RED, "o", "-"),
    "has_close_pair, no": (BLUE, "s", "-"),
    "has_close_pair, yes": (GREEN, "^", "-"),
    SORT: (BLACK, "", "--"),
    "divide and conquer": (RED, "o", ":"),
    "incremental grid": (RED, "X", ":"),
    "grid of cells r, hashing, no": (BLUE, "s", ":"),
    "grid of cells r, order, no": (BLUE, "P", ":"),
    "Delaunay": (PINK, "D", "-"),
    "Kd_tree": (ORANGE, "v", "-"),
    "nanoflann": (SKY, "P", "-"),
}

Key = collections.namedtuple("Key", "dimension kind neighbours n method")
Result = collections.namedtuple("Result", "milliseconds n k")


def read_results(path):
    """The median of each measurement."""
    found = collections.defaultdict(list)
    with open(path, encoding="utf-8") as file:
        for run in json.load(file)["benchmarks"]:
            if run.get("error_occurred"):
                sys.exit(f"{run['name']}: {run['error_message']}")
            if run["run_type"] == "iteration":
                dimension, kind, neighbours, n, method = run["name"].split("/")[:5]
                key = Key(dimension, kind, float(neighbours), int(n), method)
                found[key].append(Result(run["real_time"], run["n"], run["k"]))
    results = {key: Result(statistics.median(r.milliseconds for r in runs), runs[0].n, runs[0].k)
               for key, runs in found.items()}
    for key, result in list(results.items()):
        if key.method.startswith("box_self") and not key.method.endswith("threads"):
            best = key._replace(method=BOX_BEST)
            if best not in results or result.milliseconds < results[best].milliseconds:
                results[best] = result
    return results


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


def draw_methods(axes, results, chosen, point):
    """Draws a line per method through point(result) for the keys that are chosen."""
    for method, style in STYLES.items():
        points = sorted(point(result) for key, result in results.items()
                        if key.method == method and chosen(key))
        if points:
            draw_line(axes, points, style, method, linewidth=2.2 if method == OURS else 1.3,
                      zorder=3 if method == OURS else 2)


def draw_time_against_n(results, folder):
    figure, grid = panels(2, 2, (8, 8.2), sharex=True, sharey=True)
    for row, dimension, x in zip(grid, ("2D", "3D"), ("", "points n")):
        for axes, neighbours, y in zip(row, (0.5, 10.0), ("time per point (ns)", "")):
            prepare_axes(axes, f"{dimension}, uniform, k ≈ {words(neighbours)}", x, y)
            draw_methods(axes, results,
                         lambda key: key[:3] == (dimension, "uniform", neighbours),
                         lambda result: (result.n, 1e6 * result.milliseconds / result.n))
    legend_below(figure, 3)
    save(figure, folder, "time_against_n.svg")


def largest_common_n(results):
    """The number of points at which k/n was varied."""
    return max(key.n for key in results if key.neighbours == 100)


def draw_time_against_k(results, folder):
    n = largest_common_n(results)
    figure, (grid,) = panels(1, 2, (8, 5), sharey=True)
    for axes, dimension, y in zip(grid, ("2D", "3D"), ("time (ms)", "")):
        prepare_axes(axes, f"{dimension}, uniform, n = {plain(n)}", "pairs per point k/n", y)
        draw_methods(axes, results,
                     lambda key: key[:2] == (dimension, "uniform") and key.n == n,
                     lambda result: (result.k / result.n, result.milliseconds))
    legend_below(figure, 3)
    save(figure, folder, "time_against_k.svg")


def draw_bars(axes, methods, times, unit):
    """A bar per method, from the time `unit` to its own."""
    for place, method in enumerate(reversed(methods)):
        if method in times:
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


def times_of(results, dimension, neighbours, n, methods):
    keys = {method: Key(dimension, "uniform", neighbours, n, method) for method in methods}
    return {method: results[key].milliseconds for method, key in keys.items() if key in results}


def draw_scenes(results, folder, name, methods, reference, label, scale):
    """Bars on the four uniform scenes, the methods in the order of their geometric means."""
    n = largest_common_n(results)
    scenes = [(dimension, k) for dimension in ("2D", "3D") for k in (0.5, 10.0)]
    times = [times_of(results, *scene, n, methods + [reference]) for scene in scenes]
    methods = sorted((m for m in methods if m in times[0]),
                     key=lambda m: statistics.geometric_mean(t[m] for t in times if m in t))

    figure, grid = panels(2, 2, (8.4, 1.5 + 0.44 * len(methods)), sharex=True, sharey=True)
    for axes, scene, scene_times in zip(grid.flat, scenes, times):
        unit = scene_times[reference]
        axes.set_xscale(scale)
        draw_bars(axes, methods, scene_times, unit)
        axes.set_title(f"{scene[0]}, k ≈ {words(scene[1])}: 1 is {unit:.0f} ms", fontsize=10,
                       loc="left")
        show_plainly(axes.xaxis)
    low, high = grid[0, 0].get_xlim()
    grid[0, 0].set_xlim((low / 3, 2 * high) if scale == "log" else (low - 0.2, high + 0.2))
    figure.supxlabel(label, fontsize=10)
    figure.suptitle(f"uniform, n = {plain(n)}", fontsize=11)
    save(figure, folder, name)


def draw_rivals(results, folder):
    methods = [m for m in STYLES if m not in (SORT, "all pairs")] + [BOX_DEFAULT]
    draw_scenes(results, folder, "rivals.svg", methods, SORT, "time / time of std::sort", "log")


def draw_paper_variants(results, folder):
    methods = sorted({key.method for key in results if key.method.startswith(PAPER + ",")})
    draw_scenes(results, folder, "book_variants.svg", methods, PAPER,
                "time / time of [V03] with median pivot, sweep and reach D", "linear")


def draw_closest_pair(path, folder):
    rows = read_csv(path)
    figure, (grid,) = panels(1, 2, (8, 5.4), sharey=True)
    for axes, dimension, y in zip(grid, "23", ("time per point (ns)", "")):
        prepare_axes(axes, f"{dimension}D, uniform, 1 thread", "points n", y)
        for method, style in CLOSEST_STYLES.items():
            points = [(int(row["n"]), 1e9 * float(row["seconds"]) / int(row["n"]))
                      for row in where(rows, dimension=dimension, method=method)]
            if points:
                draw_line(axes, points, style, method)
    legend_below(figure, 3)
    save(figure, folder, "closest_pair_time.svg")


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: speed.py <methods.json or closest_pair.csv> <folder>")
    if sys.argv[1].endswith(".csv"):
        draw_closest_pair(*sys.argv[1:])
        return
    results = read_results(sys.argv[1])
    for draw in (draw_time_against_n, draw_time_against_k, draw_rivals, draw_paper_variants):
        draw(results, sys.argv[2])


if __name__ == "__main__":
    main()
