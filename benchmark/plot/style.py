# What all charts have in common: colours, axes, lines, legends, and how files are read and written.
#
# Needs matplotlib 3.6. Colours are those of Okabe and Ito, which the colour-blind can tell apart.
#
# SPDX-License-Identifier: LGPL-3.0-or-later

import csv
import pathlib

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
from PIL import Image

BLACK, ORANGE, SKY, GREEN = "#000000", "#E69F00", "#56B4E9", "#009E73"
YELLOW, BLUE, RED, PINK, GREY = "#B8AC00", "#0072B2", "#D55E00", "#CC79A7", "#777777"

# Files that differ in nothing but what is drawn: no random names, and letters without outlines.
matplotlib.rcParams.update({"svg.hashsalt": "Thick_intersection_d", "svg.fonttype": "none",
                            "font.size": 10, "grid.color": "#DDDDDD", "grid.linewidth": 0.6})


def read_csv(path):
    """The rows of a CSV file without the lines of comments, or none if it is not there."""
    path = pathlib.Path(path)
    if not path.exists():
        return []
    with path.open(encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def save(figure, folder, name):
    """As SVG without a date, or as PNG of few colours."""
    path = pathlib.Path(folder) / name
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
