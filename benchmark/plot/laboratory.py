#!/usr/bin/env python3
# Draws the figures of the manual page "Speed and accuracy" from the CSV files of the laboratory.
#
#   plot.py <folder of the CSV files> <folder for the figures>
#
# Needs matplotlib 3.6. Colours are those of Okabe and Ito, and viridis: distinct for colour-blind
# readers, too. Nothing is computed here but shares and the Pareto fronts.
#
# SPDX-License-Identifier: LGPL-3.0-or-later

import csv
import os
import re
import sys
import textwrap
from collections import defaultdict

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.colors import ListedColormap, LogNorm
from matplotlib.ticker import NullLocator
from PIL import Image

BLACK, ORANGE, SKY, GREEN, YELLOW, BLUE, RED, PINK = (
    "#000000", "#E69F00", "#56B4E9", "#009E73", "#F0E442", "#0072B2", "#D55E00", "#CC79A7")
GREY = "#777777"
GROUP_COLORS = {"ours": GREEN, "form": ORANGE, "library": BLUE, "kernel": BLUE, "grid": PINK,
                "boxes": PINK}
MARKERS = "osD^v<>PXhp*dH8sD^v<>PXhp*"


def read(name):
    """The rows of a CSV file of the laboratory, or none if it is not there."""
    path = os.path.join(SOURCE, name)
    if not os.path.exists(path):
        return []
    with open(path) as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def save(figure, name):
    path = os.path.join(TARGET, name)
    figure.savefig(path, dpi=125)
    plt.close(figure)
    with Image.open(path) as image:
        small = image.convert("RGB").quantize(128, dither=Image.Dither.NONE)
    small.save(path, optimize=True)
    print(f"{path}: {os.path.getsize(path) // 1000} kB")


def legend_below(figure, handles, labels, columns):
    """A legend below the axes, in room that is taken from them."""
    height = (0.2 * -(-len(labels) // columns) + 0.15) / figure.get_figheight()
    figure.get_layout_engine().set(rect=(0, height, 1, 1 - height))
    figure.legend(handles, labels, loc="lower center", ncols=columns, fontsize=8)


def in_order(values):
    return list(dict.fromkeys(values))


# ---- degree -------------------------------------------------------------------------------------

def plot_degree():
    rows = [r for r in read("degree.csv") if r["input_bits"] == "24" and int(r["degree"]) > 0]
    sites = set(r["algorithm"] for r in rows if r["call_site"] != "all")
    rows = [r for r in rows if (r["call_site"] != "all") == (r["algorithm"] in sites)]
    if not rows:
        return
    figure, axes = plt.subplots(figsize=(9, 6.8), layout="constrained")
    labels = []
    for y, row in enumerate(reversed(rows)):
        degree = int(row["degree"])
        color = {1: SKY, 2: GREEN}.get(degree, RED)
        axes.barh(y, degree, color=color, height=0.66)
        axes.text(degree + 0.06, y, f"{row['longest_number_bits']} bits", va="center", fontsize=8)
        site = "" if row["call_site"] == "all" else ":  " + row["call_site"]
        labels.append(row["algorithm"] + site)
    axes.set_yticks(range(len(rows)), labels, fontsize=8)
    axes.set_ylim(-0.6, len(rows) - 0.4)
    axes.set_xlim(0, 8)
    axes.set_xlabel("highest degree of a sign; beside it, the longest number from 24-bit input",
                    fontsize=9)
    axes.spines[["top", "right"]].set_visible(False)
    save(figure, "lab_degree.png")


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


def plot_staircase():
    rows = read("staircase.csv")
    if not rows:
        return
    sets = ["near-degenerate", "random"]
    inputs = in_order(r["input_bits"] for r in rows)
    figure, grid = plt.subplots(2, len(inputs), figsize=(9.6, 6), sharex=True, sharey="row",
                                layout="constrained", gridspec_kw={"height_ratios": [3, 1.2]})
    for i, set_name in enumerate(sets):
        for j, bits in enumerate(inputs):
            axes = grid[i][j]
            for predicate, (color, marker, label) in STAIR_STYLES.items():
                some = [r for r in rows if r["set"] == set_name and r["input_bits"] == bits
                        and r["predicate"] == predicate]
                p = [int(r["precision"]) for r in some]
                wrong = [100 * int(r["wrong"]) / int(r["questions"]) for r in some]
                axes.plot(p, wrong, color=color, marker=marker, markersize=3.5, linewidth=1.2,
                          label=label, markeredgecolor="black", markeredgewidth=0.3)
                if i == 0 and predicate != "in circle, as two products":
                    axes.axvline(float(some[0]["bits_by_theory"]), color=color, linestyle=":",
                                 linewidth=1.4)
            if i == 0:
                mark_formats(axes, 71)
                axes.set_title(f"{set_name}, input of {bits} bits", fontsize=9)
                axes.set_ylim(-2, 72)
            else:
                axes.set_title(f"{set_name}, input of {bits} bits", fontsize=9)
                axes.set_xlabel("precision p, bits of the significand")
                axes.set_ylim(-0.3, 8)
        grid[i][0].set_ylabel("wrong answers, %")
    handles, labels = grid[0][0].get_legend_handles_labels()
    handles.append(plt.Line2D([], [], color=GREY, linestyle=":"))
    labels.append("bits that suffice by theory")
    legend_below(figure, handles, labels, 4)
    save(figure, "lab_staircase.png")


def plot_staircase_runs():
    rows = [r for r in read("staircase_runs.csv") if r["input_bits"] == "24"]
    if not rows:
        return
    styles = {"all pairs": (ORANGE, "o"), "[V03] in rounded numbers": (BLUE, "s"),
              "rounded Delaunay, searched exactly": (PINK, "^"),
              "wrong edges of the rounded Delaunay": (RED, "v"), "this package": (GREEN, "D")}
    sets = in_order(r["set"] for r in rows)
    figure, grid = plt.subplots(1, len(sets), figsize=(9.6, 3.9), sharey=True,
                                layout="constrained")
    for axes, set_name in zip(grid, sets):
        for index, (name, (color, marker)) in enumerate(styles.items()):
            some = [r for r in rows if r["set"] == set_name and r["algorithm"] == name]
            p = [int(r["precision"]) + 0.5 * (index - 2) for r in some]
            wrong = [int(r["missing"]) + int(r["extra"]) for r in some]
            axes.plot(p, wrong, color=color, marker=marker, markersize=5, linewidth=1.1, label=name,
                      markeredgecolor="black", markeredgewidth=0.3)
        axes.axvline(24, color=GREY, linestyle=":", linewidth=1.2)
        axes.text(24.8, 4300, "the input fits", fontsize=7, color=GREY, rotation=90, va="top")
        axes.set_yscale("symlog", linthresh=1, linscale=0.6)
        axes.set_ylim(-0.4, 5000)
        axes.set_title(f"{set_name}, input of 24 bits", fontsize=9)
        axes.set_xlabel("precision p, bits of the significand")
    grid[0].set_ylabel("wrong pairs or edges")
    handles, labels = grid[0].get_legend_handles_labels()
    legend_below(figure, handles, labels, 3)
    save(figure, "lab_staircase_runs.png")


# ---- families -----------------------------------------------------------------------------------

def short(number):
    return f"{number}" if number < 10000 else f"{number // 1000}k"


def cell_of(row):
    """The number that colours a cell, and its text: wrong pairs of 100 true ones."""
    if row["status"] != "ok":
        return None, row["status"].replace("SIG", "")
    missing, extra = int(row["missing"]), int(row["extra"])
    text = (f"−{short(missing)}" if missing else "") + (f"+{short(extra)}" if extra else "")
    if int(row["asymmetric"]) or int(row["order_dependent"]):
        text += "*"
    share = 100 * (missing + extra) / max(int(row["true_pairs"]), 1)
    return share, text.replace("+", "\n+") if missing and extra else text


def plot_families(dimension):
    rows = [r for r in read("families.csv") if r["dimension"] == str(dimension)]
    if not rows:
        return
    methods = in_order(r["method"] for r in rows)
    groups = {r["method"]: r["group"] for r in rows}
    families = in_order(r["family"] for r in rows)
    by_cell = {(r["family"], r["method"]): r for r in rows}
    figure, axes = plt.subplots(figsize=(11.5, 8.6), layout="constrained")
    shares = [[cell_of(by_cell[f, m])[0] or float("nan") for m in methods] for f in families]
    colors = plt.get_cmap("viridis_r").copy()
    colors.set_bad("white")
    image = axes.imshow(shares, cmap=colors, norm=LogNorm(0.01, 10000), aspect="auto")
    for y, family in enumerate(families):
        for x, method in enumerate(methods):
            share, text = cell_of(by_cell[family, method])
            if share is None:
                axes.add_patch(plt.Rectangle((x - 0.5, y - 0.5), 1, 1, color=BLACK))
            axes.text(x, y, text, ha="center", va="center", fontsize=5,
                      color="white" if share is None or share > 20 else "black")
    axes.set_xticks(range(len(methods)), methods, rotation=60, ha="right", fontsize=8,
                    rotation_mode="anchor")
    for label, method in zip(axes.get_xticklabels(), methods):
        label.set_color(GREEN if groups[method] == "ours" else "black")
    counts = {r["family"]: r["true_pairs"] for r in rows}
    axes.set_yticks(range(len(families)), [f"{f}   ({counts[f]})" for f in families], fontsize=7.5)
    axes.set_xticks([x - 0.5 for x in range(1, len(methods))], minor=True)
    axes.set_yticks([y - 0.5 for y in range(1, len(families))], minor=True)
    axes.grid(which="minor", color="#dddddd", linewidth=0.6)
    axes.tick_params(which="minor", length=0)
    axes.set_title(f"Missing (−) and extra (+) pairs in dimension {dimension}. White: none. Black: "
                   "crashed. *: some pairs are found from one of their points only. In brackets: "
                   "true pairs", fontsize=9)
    bar = figure.colorbar(image, ax=axes, shrink=0.6, pad=0.01)
    bar.set_label("wrong pairs per 100 true pairs")
    save(figure, f"lab_families_{dimension}d.png")


# ---- speed against accuracy ---------------------------------------------------------------------

ZERO = 3e-6  # where the zero lane is drawn on a logarithmic axis


def pareto_front(points):
    """Those that no other one beats in both time and wrong share, from fast to slow."""
    front = []
    for time, share, name in sorted(points):
        if not front or share < front[-1][1]:
            front.append((time, share, name))
    return front


def plot_chart(rows, time_of, time_label, name):
    """Time against wrong pairs, a marker per method."""
    sets = in_order(r["set"] for r in rows)
    methods = in_order(r["method"] for r in rows)
    groups = {r["method"]: r["group"] for r in rows}
    kinds = defaultdict(list)
    for method in methods:
        kinds[groups[method]].append(method)
    marker = {m: MARKERS[i] for kind in kinds.values() for i, m in enumerate(kind)}
    figure, grid = plt.subplots(1, len(sets), figsize=(11, 6.6), sharey=True, layout="constrained")
    for axes, set_name in zip(grid, sets):
        points = []
        for row in rows:
            if row["set"] != set_name or row.get("status", "ok") != "ok":
                continue
            wrong = int(row["wrong"]) if "wrong" in row else int(row["missing"]) + int(row["extra"])
            share = wrong / int(row["true_pairs"])
            points.append((time_of(row), share, row["method"]))
        # In the zero lane the heights only keep the markers apart.
        lane = sorted(p for p in points if p[1] == 0)
        height = {p[2]: ZERO * (0.36 + 0.64 * (i % 4) / 1.6) for i, p in enumerate(lane)}
        for time, share, method in points:
            axes.plot(time, share if share > 0 else height[method], linestyle="none",
                      marker=marker[method], color=GROUP_COLORS[groups[method]], markersize=7.5,
                      markeredgecolor="black", markeredgewidth=0.5, alpha=0.9)
        front = pareto_front(points)
        heights = [share if share > 0 else height[method] for _, share, method in front]
        axes.step([p[0] for p in front], heights, where="post", color=BLACK, linewidth=1,
                  linestyle="--", zorder=0)
        axes.plot([p[0] for p in front], heights, linestyle="none", marker="o", markersize=13,
                  markerfacecolor="none", markeredgecolor=BLACK)
        axes.axhspan(ZERO * 0.2, ZERO * 2.2, color="#e8f5ee", zorder=-1)
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.set_ylim(ZERO * 0.2, 5)
        axes.set_title(set_name, fontsize=10)
        axes.set_xlabel(time_label)
        axes.grid(True, color="#eeeeee", linewidth=0.6)
    grid[0].set_yticks([ZERO, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1],
                       ["no wrong\npairs", "$10^{-5}$", "$10^{-4}$", "$10^{-3}$", "$10^{-2}$",
                        "$10^{-1}$", "1"])
    grid[0].yaxis.set_minor_locator(NullLocator())
    grid[0].set_ylabel("wrong pairs per true pair")
    handles = [plt.Line2D([], [], linestyle="none", marker=marker[m], color=GROUP_COLORS[groups[m]],
                          markeredgecolor="black", markeredgewidth=0.5, markersize=7)
               for m in methods]
    handles.append(plt.Line2D([], [], color=BLACK, linewidth=1, linestyle="--", marker="o",
                              markersize=10, markerfacecolor="none"))
    legend_below(figure, handles, methods + ["Pareto front"], 5)
    save(figure, name)


def plot_charts():
    rows = read("predicates.csv")
    if rows:
        plot_chart(rows, lambda r: float(r["ns"]), "time of one predicate, ns",
                   "lab_chart_predicates.png")
    rows = read("whole_runs.csv")
    if rows:
        plot_chart(rows, lambda r: 1e9 * float(r["seconds"]) / int(r["true_pairs"]),
                   "time of the search per true pair, ns", "lab_chart_runs.png")


# ---- pictures -----------------------------------------------------------------------------------

def plot_microscope():
    rows = read("microscope.csv")
    if not rows:
        return
    views, forms = in_order(r["view"] for r in rows), in_order(r["form"] for r in rows)
    pixels = defaultdict(list)
    for row in rows:
        line = "".join(c * int(n) for n, c in re.findall(r"(\d+)(\D)", row["pixels"]))
        pixels[row["view"], row["form"]].append([".xm".index(c) for c in line])
    figure, grid = plt.subplots(len(views), len(forms), figsize=(10, 5.7), sharex=True, sharey=True,
                                layout="constrained")
    for i, view in enumerate(views):
        for j, form in enumerate(forms):
            axes = grid[i][j]
            image = pixels[view, form]
            axes.imshow(image, origin="lower", cmap=ListedColormap(["#f4f4f4", RED, BLUE]), vmin=0,
                        vmax=2, interpolation="nearest", extent=(-128, 128, -128, 128))
            wrong = sum(value != 0 for line in image for value in line)
            axes.set_title(f"{form}: {wrong} wrong", fontsize=9)
            axes.tick_params(labelsize=7)
        grid[i][0].set_ylabel(f"{view}\ny of q, in $2^{{-56}}$", fontsize=8)
    for axes in grid[-1]:
        axes.set_xlabel("x of q, in $2^{-56}$", fontsize=8)
    handles = [plt.Rectangle((0, 0), 1, 1, color=color) for color in ("#f4f4f4", RED, BLUE)]
    legend_below(figure, handles, ["right", "wrongly within r", "wrongly beyond r"], 3)
    save(figure, "lab_microscope.png")


SWEEP_STYLES = {"double": (ORANGE, "o"), "double, sqrt": (SKY, "s"), "double, hypot": (PINK, "v"),
                "double, expanded": (RED, "^"), "float": (GREY, "P"), "long double": (BLUE, "X"),
                "ours": (GREEN, "D")}


def plot_sweeps():
    offsets, scales = read("offsets.csv"), read("scales.csv")
    if not offsets or not scales:
        return
    figure, grid = plt.subplots(1, 2, figsize=(9.6, 4.6), sharey=True, layout="constrained")
    for axes, rows, label, every in (
            (grid[0], offsets, "offset of the scene, as a power of two", 2),
            (grid[1], scales, "scale of the scene, as a power of two", 4)):
        for method, (color, marker) in SWEEP_STYLES.items():
            some = [r for r in rows if r["method"] == method]
            x = [int(r["exponent"]) for r in some]
            y = [(int(r["missing"]) + int(r["extra"])) / max(int(r["true_pairs"]), 1) for r in some]
            axes.plot(x, y, color=color, marker=marker, markersize=4, linewidth=1.1, label=method,
                      markevery=every, zorder=3 if method == "ours" else 2,
                      markeredgecolor="black", markeredgewidth=0.3)
        axes.set_yscale("symlog", linthresh=1e-4, linscale=0.5)
        axes.set_ylim(-3e-5, 300)
        axes.set_xlabel(label)
        axes.grid(True, color="#eeeeee", linewidth=0.6)
    grid[0].set_title("400 random points in a unit square, r = 0.1", fontsize=9)
    grid[1].set_title("lattice of step 0.1 $\\cdot$ scale, r = 5 steps", fontsize=9)
    grid[0].set_ylabel("wrong pairs per true pair")
    handles, labels = grid[0].get_legend_handles_labels()
    legend_below(figure, handles, labels, 7)
    save(figure, "lab_sweeps.png")


def plot_tie_density():
    rows = read("tie_density.csv")
    if not rows:
        return
    styles = {"double": (ORANGE, "o"), "EPICK": (RED, "s"), "EPECK": (PINK, "v"),
              "Mpzf": (BLUE, "^"), "rational": (GREY, "P"), "ours, double": (GREEN, "D"),
              "ours, EPECK": (YELLOW, "X"), "ours, rational": (SKY, "*")}
    figure, axes = plt.subplots(figsize=(8, 4.6), layout="constrained")
    for method in in_order(r["method"] for r in rows):
        color, marker = styles[method]
        some = [r for r in rows if r["method"] == method]
        axes.plot([float(r["share_of_ties"]) for r in some], [float(r["ns"]) for r in some],
                  color=color, marker=marker, label=method, linewidth=1.3, markersize=6,
                  markeredgecolor="black", markeredgewidth=0.3)
    axes.set_xscale("symlog", linthresh=0.001, linscale=0.4)
    axes.set_xticks([0, 0.001, 0.01, 0.1, 1], ["0", "0.001", "0.01", "0.1", "1"])
    axes.set_xlim(-0.0002, 1.3)
    axes.set_yscale("log")
    axes.set_xlabel("share of pairs exactly at the distance")
    axes.set_ylabel("time of one predicate, ns")
    axes.grid(True, color="#eeeeee", linewidth=0.6)
    axes.legend(loc="center left", bbox_to_anchor=(1.01, 0.5), fontsize=9, frameon=False)
    save(figure, "lab_tie_density.png")


# ---- scenes -------------------------------------------------------------------------------------

def plot_certificates():
    rows = read("certificates.csv")
    if not rows:
        return
    tiers = in_order(r["tier"] for r in sorted(rows, key=lambda r: float(r["bits"])))
    tier_colors = dict(zip(tiers, [GREEN, SKY, BLUE, ORANGE] if len(tiers) > 2 else [GREEN, ORANGE]))
    stored = in_order(r["stored"] for r in rows)
    files = sorted(set(r["file"] for r in rows))
    figure, axes = plt.subplots(figsize=(9.6, 5.6), layout="constrained")
    for row in rows:
        axes.plot(float(row["log2_extent"]), float(row["log2_reach"]), linestyle="none",
                  marker=MARKERS[files.index(row["file"])], markersize=7.5,
                  color=tier_colors[row["tier"]], markeredgecolor="black",
                  markeredgewidth=1.3 if row["stored"] == stored[0] else 0.3)
    for bits, name in ((26, "$2^{26}$ steps: double"), (31, "$2^{31}$: 64-bit integers"),
                       (63, "$2^{63}$: 128-bit integers")):
        axes.axhline(bits, color=GREY, linewidth=1, linestyle=":")
        axes.text(0.5, bits + 0.8, name, fontsize=8, color=GREY)
    axes.set_xlim(0, 120)
    axes.set_ylim(0, 115)
    axes.set_xlabel("extent of the scene, $\\log_2$ of steps of its grid")
    axes.set_ylabel("distance bound, $\\log_2$ of steps of the grid")
    handles = [plt.Line2D([], [], linestyle="none", marker="o", color=tier_colors[t], label=t)
               for t in tiers]
    handles += [plt.Line2D([], [], linestyle="none", marker="o", color="white",
                           markeredgecolor="black", markeredgewidth=w, label=s)
                for s, w in zip(stored, (1.3, 0.3))]
    handles += [plt.Line2D([], [], linestyle="none", marker=MARKERS[i], color=GREY, label=f)
                for i, f in enumerate(files)]
    axes.legend(handles=handles, loc="center left", bbox_to_anchor=(1.01, 0.5), fontsize=8,
                frameon=False)
    save(figure, "lab_certificates.png")


def plot_work():
    rows = read("work.csv")
    if not rows:
        return
    styles = {"sweep, reach r": (GREEN, "D", "-"), "sweep, reach 2 r": (GREEN, "D", ":"),
              "walk, reach r": (BLUE, "s", "-"), "walk, reach 2 r": (BLUE, "s", ":"),
              "grid of cells r": (ORANGE, "o", "-"), "sweep along x alone": (GREY, "^", "-")}
    figure, grid = plt.subplots(1, 2, figsize=(9, 4.2), sharey=True, layout="constrained")
    for axes, dimension in zip(grid, ("2", "3")):
        for method, (color, marker, line) in styles.items():
            some = [r for r in rows if r["dimension"] == dimension and r["method"] == method]
            axes.plot([int(r["n"]) for r in some], [float(r["calls_per_output"]) for r in some],
                      color=color, marker=marker, linestyle=line, label=method, markersize=5.5,
                      markeredgecolor="black", markeredgewidth=0.3)
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.set_title(f"dimension {dimension}, uniform, k about n", fontsize=9)
        axes.set_xlabel("points n")
        axes.grid(True, color="#eeeeee", linewidth=0.6)
    grid[0].set_ylabel("predicate calls per n + k")
    handles, labels = grid[0].get_legend_handles_labels()
    legend_below(figure, handles, labels, 3)
    save(figure, "lab_work.png")


def plot_stability():
    rows = read("stability.csv") + read("fused.csv")
    if not rows:
        return
    methods, changes = in_order(r["method"] for r in rows), in_order(r["change"] for r in rows)
    share = {(r["method"], r["change"]): 100 * int(r["changed"]) / int(r["questions"])
             for r in rows}
    figure, axes = plt.subplots(figsize=(8, 3.6), layout="constrained")
    values = [[share.get((m, c), 0) or float("nan") for c in changes] for m in methods]
    colors = plt.get_cmap("viridis_r").copy()
    colors.set_bad("white")
    image = axes.imshow(values, cmap=colors, vmin=0, vmax=70, aspect="auto")
    for y, method in enumerate(methods):
        for x, change in enumerate(changes):
            value = share.get((method, change))
            axes.text(x, y, "" if value is None else "0" if value == 0 else f"{value:.1f}",
                      ha="center", va="center", fontsize=9,
                      color="white" if value and value > 35 else "black")
    axes.set_xticks(range(len(changes)), [textwrap.fill(c, 14) for c in changes], fontsize=8)
    axes.set_yticks(range(len(methods)), methods, fontsize=9)
    axes.get_yticklabels()[-1].set_color(GREEN)
    figure.colorbar(image, ax=axes, pad=0.01).set_label("changed answers, %")
    save(figure, "lab_stability.png")


def plot_section_3():
    rows = read("section_3.csv")
    if not rows:
        return
    experiments = in_order(r["experiment"] for r in rows)
    figure, grid = plt.subplots(len(experiments), 1, figsize=(9, 5.8), layout="constrained",
                                gridspec_kw={"height_ratios": [
                                    sum(r["experiment"] == e for r in rows) for e in experiments]})
    for axes, experiment in zip(grid, experiments):
        some = [r for r in rows if r["experiment"] == experiment]
        own = next(float(r["seconds"]) for r in some if r["method"] == "this package")
        for y, row in enumerate(reversed(some)):
            seconds = float(row["seconds"])
            color = GREEN if row["method"].startswith("this") else (
                BLUE if row["method"].startswith("[V03]") else
                RED if row["degree"] == "4" else GREY)
            axes.barh(y, 1000 * seconds, color=color, height=0.66)
            ratio = seconds / own
            axes.text(1000 * seconds * 1.08, y,
                      f"{1000 * seconds:,.1f} ms, {ratio:,.{0 if ratio > 10 else 1}f} ×",
                      va="center", fontsize=8)
        axes.set_yticks(range(len(some)), [r["method"] for r in reversed(some)], fontsize=8)
        axes.set_xscale("log")
        low = min(float(r["seconds"]) for r in some)
        high = max(float(r["seconds"]) for r in some)
        axes.set_xlim(400 * low, 9000 * high)
        axes.set_title(f"{experiment}: n = {int(some[0]['n']):,}, k = {int(some[-1]['k']):,}",
                       fontsize=9, loc="left")
        axes.spines[["top", "right"]].set_visible(False)
    grid[-1].set_xlabel("time, ms; × against this package")
    save(figure, "lab_section_3.png")


def main():
    os.makedirs(TARGET, exist_ok=True)
    plot_degree()
    plot_staircase()
    plot_staircase_runs()
    plot_families(2)
    plot_families(3)
    plot_charts()
    plot_microscope()
    plot_sweeps()
    plot_tie_density()
    plot_certificates()
    plot_work()
    plot_stability()
    plot_section_3()


SOURCE, TARGET = sys.argv[1], sys.argv[2]
main()
