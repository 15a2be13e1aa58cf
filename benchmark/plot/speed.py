#!/usr/bin/env python3
# Draws the charts of the manual from what `compare` and `closest_pair_table --chart` wrote.
#
#   python3 plot.py <compare.json> <folder>
#   python3 plot.py <closest_pair.csv> <folder>
#
# A measurement of `compare` is called <dimension>/<scene>/<k/n aimed at>/<n>/<method>; repetitions of it are
# reduced to their median. Of box_self_intersection_d the best cutoff is shown for each scene, besides
# the default.
#
# SPDX-License-Identifier: LGPL-3.0-or-later

import collections
import csv
import json
import pathlib
import statistics
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.ticker import FuncFormatter, NullFormatter

# The colours of Okabe and Ito, which the colour-blind can tell apart.
BLACK, ORANGE, SKY, GREEN = "#000000", "#E69F00", "#56B4E9", "#009E73"
YELLOW, BLUE, RED, PURPLE, GREY = "#B8AC00", "#0072B2", "#D55E00", "#CC79A7", "#8A8A8A"

OURS = "Thick_intersection_d"
OURS_2 = OURS + ", 2 threads"
SORT = "std::sort of x"
BOX_DEFAULT = "box_self_intersection_d, cutoff 10"
BOX_BEST = "box_self_intersection_d, best cutoff"
BOOK = "[V03]"

STYLES = {  # colour, marker, line
    OURS: (RED, "o", "-"),
    OURS_2: (RED, "o", ":"),
    SORT: (BLACK, "", "--"),
    BOOK: (BLUE, "s", "-"),
    BOX_BEST: (GREEN, "^", "-"),
    "Delaunay EPICK + search": (PURPLE, "D", "-"),
    "Delaunay EPECK + search": (PURPLE, "D", ":"),
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
    "Delaunay": (PURPLE, "D", "-"),
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


def prepare_axes(axes):
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.grid(True, which="major", color="#DDDDDD", linewidth=0.6)
    axes.set_axisbelow(True)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)


def words(neighbours):
    return "n/2" if neighbours == 0.5 else f"{neighbours:g} n"


def save(figure, folder, name):
    """The same bytes for the same data: no date, no random names."""
    path = pathlib.Path(folder) / name
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)
    print(f"{path}: {path.stat().st_size // 1024} kB")


def draw_lines(axes, results, chosen, point):
    """Draws a line per method through point(key, result) for the keys that are chosen."""
    for method, (colour, marker, line) in STYLES.items():
        points = sorted(point(key, result) for key, result in results.items()
                        if key.method == method and chosen(key))
        if points:
            axes.plot(*zip(*points), color=colour, marker=marker, linestyle=line, label=method,
                      linewidth=2.2 if method == OURS else 1.3, markersize=5,
                      zorder=3 if method == OURS else 2)


def add_legend(figure, panels, columns=3, styles=STYLES):
    entries = {}
    for axes in panels:
        for handle, label in zip(*axes.get_legend_handles_labels()):
            entries.setdefault(label, handle)
    labels = [method for method in styles if method in entries]
    figure.legend([entries[label] for label in labels], labels, loc="lower center", ncol=columns,
                  frameon=False, fontsize=9)


def draw_time_against_n(results, folder):
    figure, grid = plt.subplots(2, 2, figsize=(8, 8.2), sharex=True, sharey=True)
    for row, dimension in zip(grid, ("2D", "3D")):
        for axes, neighbours in zip(row, (0.5, 10.0)):
            prepare_axes(axes)
            draw_lines(axes, results,
                       lambda key: key[:3] == (dimension, "uniform", neighbours),
                       lambda key, result: (result.n, 1e6 * result.milliseconds / result.n))
            axes.set_title(f"{dimension}, uniform, k ≈ {words(neighbours)}", fontsize=11)
            for axis in (axes.xaxis, axes.yaxis):
                axis.set_major_formatter(FuncFormatter(plain))
                axis.set_minor_formatter(NullFormatter())
    for axes in grid[1]:
        axes.set_xlabel("points n")
    for axes in grid[:, 0]:
        axes.set_ylabel("time per point (ns)")
    add_legend(figure, grid.flat)
    figure.tight_layout(rect=(0, 0.12, 1, 1))
    save(figure, folder, "time_against_n.svg")


def largest_common_n(results):
    """The number of points at which k/n was varied."""
    return max(key.n for key in results if key.neighbours == 100)


def draw_time_against_k(results, folder):
    n = largest_common_n(results)
    figure, panels = plt.subplots(1, 2, figsize=(8, 5), sharey=True)
    for axes, dimension in zip(panels, ("2D", "3D")):
        prepare_axes(axes)
        draw_lines(axes, results,
                   lambda key: key[:2] == (dimension, "uniform") and key.n == n,
                   lambda key, result: (result.k / result.n, result.milliseconds))
        axes.set_title(f"{dimension}, uniform, n = {plain(n)}", fontsize=11)
        axes.set_xlabel("pairs per point k/n")
        for axis in (axes.xaxis, axes.yaxis):
            axis.set_major_formatter(FuncFormatter(plain))
            axis.set_minor_formatter(NullFormatter())
    panels[0].set_ylabel("time (ms)")
    add_legend(figure, panels)
    figure.tight_layout(rect=(0, 0.2, 1, 1))
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
    for side in ("top", "right", "left"):
        axes.spines[side].set_visible(False)


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

    figure, grid = plt.subplots(2, 2, figsize=(8.4, 1.5 + 0.44 * len(methods)), sharex=True,
                                sharey=True)
    for axes, scene, scene_times in zip(grid.flat, scenes, times):
        unit = scene_times[reference]
        axes.set_xscale(scale)
        draw_bars(axes, methods, scene_times, unit)
        axes.set_title(f"{scene[0]}, k ≈ {words(scene[1])}: 1 is {unit:.0f} ms", fontsize=10,
                       loc="left")
        axes.xaxis.set_major_formatter(FuncFormatter(plain))
        axes.xaxis.set_minor_formatter(NullFormatter())
    low, high = grid[0, 0].get_xlim()
    grid[0, 0].set_xlim((low / 3, 2 * high) if scale == "log" else (low - 0.2, high + 0.2))
    figure.supxlabel(label, fontsize=10)
    figure.suptitle(f"uniform, n = {plain(n)}", fontsize=11)
    figure.tight_layout()
    save(figure, folder, name)


def draw_rivals(results, folder):
    methods = [m for m in STYLES if m not in (SORT, "all pairs")] + [BOX_DEFAULT]
    draw_scenes(results, folder, "rivals.svg", methods, SORT, "time / time of std::sort", "log")


def draw_book_variants(results, folder):
    methods = sorted({key.method for key in results if key.method.startswith(BOOK + ",")})
    draw_scenes(results, folder, "book_variants.svg", methods, BOOK,
                "time / time of [V03] with median pivot, sweep and reach D", "linear")


def draw_closest_pair(path, folder):
    seconds = collections.defaultdict(list)
    with open(path, encoding="utf-8") as file:
        for row in csv.DictReader(file):
            seconds[row["dimension"], row["method"]].append((int(row["n"]), float(row["seconds"])))
    figure, panels = plt.subplots(1, 2, figsize=(8, 5.4), sharey=True)
    for axes, dimension in zip(panels, "23"):
        prepare_axes(axes)
        for method, (colour, marker, line) in CLOSEST_STYLES.items():
            points = seconds.get((dimension, method), [])
            axes.plot([n for n, _ in points], [1e9 * s / n for n, s in points], color=colour,
                      marker=marker, linestyle=line, label=method, linewidth=1.5, markersize=5)
        axes.set_title(f"{dimension}D, uniform, 1 thread", fontsize=11)
        axes.set_xlabel("points n")
        for axis in (axes.xaxis, axes.yaxis):
            axis.set_major_formatter(FuncFormatter(plain))
            axis.set_minor_formatter(NullFormatter())
    panels[0].set_ylabel("time per point (ns)")
    add_legend(figure, panels, styles=CLOSEST_STYLES)
    figure.tight_layout(rect=(0, 0.2, 1, 1))
    save(figure, folder, "closest_pair_time.svg")


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: plot.py <compare.json or closest_pair.csv> <folder>")
    matplotlib.rcParams.update({"svg.hashsalt": "Thick_intersection_d", "svg.fonttype": "none",
                                "font.size": 10})
    if sys.argv[1].endswith(".csv"):
        draw_closest_pair(*sys.argv[1:])
        return
    results = read_results(sys.argv[1])
    for draw in (draw_time_against_n, draw_time_against_k, draw_rivals, draw_book_variants):
        draw(results, sys.argv[2])


if __name__ == "__main__":
    main()
