#!/usr/bin/env python3
# Draws a model of the search on many processes as an SVG file, and prints the times that it draws.
#
#   python3 fig_src/distributed_scaling.py fig          writes fig/distributed_scaling.svg
#
# Uniform points in space with about 4 n pairs. Times for more than two processes are of the model.
# Needs matplotlib 3.6, and looks as the charts of the benchmarks do.
#
# SPDX-License-Identifier: LGPL-3.0-or-later

import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "benchmark" / "plot"))
from charts import (BLACK, BLUE, GREEN, GREY, ORANGE, PINK, RED, draw_line, legend_below, panels,
                    prepare, save)

# Seconds for each point of a process: what the page measured with this many points on each of one
# process and of two.
MEASURED_POINTS = 1e6
ALONE = {"check": 18e-9, "search": 126e-9}
SHARED = {"partition": 21e-9, "migration": 118e-9, "halo": 29e-9}

# Assumptions about the network, for each process.
BYTES_PER_SECOND = 1e9
LATENCY = 2e-6  # seconds for a message, also if it is empty

# Measured by itself: sorting a sample of 524,288 points and cutting it on the way to one of 1024
# parts takes 92 ms. For 64 parts, 131,072 points take 17 ms.
SECONDS_PER_CUT = 92e-3 / 524288  # for a point of a sample
BYTES_PER_CUT = 100

REACH = (8 * 3 / (4 * math.pi)) ** (1 / 3)  # for 8 neighbors, if there is a point per unit cube
BYTES_PER_POINT = 32

PHASE_STYLES = {  # in the order in which they are drawn
    "search": (RED, "o"),
    "check": (GREY, "s"),
    "migration": (BLUE, "^"),
    "halo": (GREEN, "v"),
    "partition": (ORANGE, "D"),
    "uneven parts": (PINK, "P"),
    "all": (BLACK, "", "-"),
}


def sample_size(processes):
    """As sample_size_of_parts() of parts/Point_sample.h."""
    return 1024 * processes / max(1, math.sqrt(processes / 64))


def halo_points(processes, points):
    """The points that a process receives: half of those near a cube, at its inner sides."""
    inner = 1 - processes ** (-1 / 3)
    return points * ((1 + 2 * REACH / points ** (1 / 3) * inner) ** 3 - 1) / 2


def gather(processes, all_bytes):
    return math.ceil(math.log2(processes)) * LATENCY + all_bytes / BYTES_PER_SECOND


def partition(processes, points):
    """Two samples and all cuts are gathered on all processes; counts of cells are added up."""
    size = sample_size(processes)
    looks = SHARED["partition"] * min(points, MEASURED_POINTS)  # 2^17 points at most
    slots = 2 ** (math.ceil(math.log2(size)) + 1)
    return (looks + 2 * size * SECONDS_PER_CUT + 2 * gather(processes, size * BYTES_PER_POINT)
            + gather(processes, processes * BYTES_PER_CUT) + 2 * gather(processes, slots * 8))


def migration(processes, points):
    """As if points that stay cost nothing: half of them moved between two processes."""
    moved = points * (1 - 1 / processes)
    return (2 * SHARED["migration"] * moved + moved * BYTES_PER_POINT / BYTES_PER_SECOND
            + 2 * processes * LATENCY)


def halo(processes, points):
    return (SHARED["halo"] * points
            + halo_points(processes, points) * BYTES_PER_POINT / BYTES_PER_SECOND
            + processes * LATENCY)


def seconds(processes, points):
    """The time of each phase, for so many points on each process."""
    times = {"check": ALONE["check"] * points, "search": ALONE["search"] * points,
             "migration": 0, "halo": 0, "partition": 0, "uneven parts": 0}
    if processes > 1:
        times["search"] += ALONE["search"] * halo_points(processes, points)
        times["partition"] = partition(processes, points)
        times["migration"] = migration(processes, points)
        times["halo"] = halo(processes, points)
        deviation = math.sqrt(processes / sample_size(processes))  # of the points of a part
        largest = deviation * math.sqrt(2 * math.log(processes))  # of so many parts
        times["uneven parts"] = largest * times["search"]
    times["all"] = sum(times.values())
    return times


def draw(axes, counts, points_of, title):
    prepare(axes, title, "processes", "seconds, of the model", ("log", "log"))
    for phase, style in PHASE_STYLES.items():
        times = [(p, seconds(p, points_of(p))[phase]) for p in counts]
        draw_line(axes, [point for point in times if point[1] > 0], style, phase)


def main():
    figure, ((left, right),) = panels(1, 2, (9, 4.4))
    counts = [2 ** i for i in range(11)]
    draw(left, counts[4:], lambda p: 1e9 / p, "10⁹ points on all processes")
    draw(right, counts, lambda p: 1e6, "10⁶ points on each process")
    for p in counts:
        for points in [1e6] + [1e9 / p] * (p >= 16):
            print(p, f"{points:.0f} points on each, halo {halo_points(p, points) / points:.3f}",
                  *(f"{phase} {s:.3f}" for phase, s in seconds(p, points).items()))
    legend_below(figure, 4)
    save(figure, pathlib.Path(sys.argv[1]), "distributed_scaling.svg")


main()
