#!/usr/bin/env python3
# Draws how a search on many processes would scale, by a model with constants of real runs.
#
#   scaling.py <1 process.json> <2 processes.json> <folder>
#
# The files are what near_pairs_mpi prints for uniform points in space with about 4 n pairs: n points
# on one process, and 2 n points on two. The model takes from them what a point costs in each phase.
# What it assumes of a network, and how much work there is for p processes, is written below. Prints
# the times that it draws. Everything for more than two processes is of the model.
#
# SPDX-License-Identifier: LGPL-3.0-or-later

import json
import math
import sys

from style import (BLACK, BLUE, GREEN, GREY, ORANGE, PINK, RED, draw_line, legend_below, panels,
                   prepare, save)

# Assumptions about the network, for each process.
BYTES_PER_SECOND = 1e9
LATENCY = 2e-6  # seconds for a message, also if it is empty

# Measured by itself: sorting a sample of 524,288 points and cutting it on the way to one of 1024
# parts takes 92 ms. For 64 parts, 131,072 points take 17 ms.
SECONDS_PER_CUT = 92e-3 / 524288  # for a point of a sample
BYTES_PER_CUT = 100

REACH = (8 * 3 / (4 * math.pi)) ** (1 / 3)  # for 8 neighbors, if there is a point per unit cube
BYTES_PER_POINT = 32

STYLES = {  # in the order in which they are drawn
    "search": (RED, "o"),
    "check": (GREY, "s"),
    "migration": (BLUE, "^"),
    "halo": (GREEN, "v"),
    "partition": (ORANGE, "D"),
    "uneven parts": (PINK, "P"),
    "all": (BLACK, "", "-"),
}


def read_run(path):
    """The number of processes, and per point of a process the seconds of each phase."""
    with open(path, encoding="utf-8") as file:
        run = json.load(file)
    profile = run["profile"]
    points = sum(rank["points"] for rank in profile) / len(profile)
    seconds = {key[len("seconds_"):]: max(rank[key] for rank in profile) / points
               for key in profile[0] if key.startswith("seconds_")}
    return run["processes"], points, seconds


def sample_size(processes):
    """As sample_size_of_parts() of parts/Point_sample.h."""
    return 1024 * processes / max(1, math.sqrt(processes / 64))


def halo(processes, points):
    """The points that a process receives: half of those near a cube, at its inner sides."""
    inner = 1 - processes ** (-1 / 3)
    return points * ((1 + 2 * REACH / points ** (1 / 3) * inner) ** 3 - 1) / 2


def gather(processes, all_bytes):
    return math.ceil(math.log2(processes)) * LATENCY + all_bytes / BYTES_PER_SECOND


class Model:
    def __init__(self, one, two):
        (_, _, self.alone), (_, self.points_of_two, self.shared) = one, two

    def seconds(self, processes, points):
        """The time of each phase, for so many points on each process."""
        times = {"check": self.alone["check"] * points, "search": self.alone["search"] * points,
                 "migration": 0, "halo": 0, "partition": 0, "uneven parts": 0}
        if processes > 1:
            times["search"] += self.alone["search"] * halo(processes, points)
            times["partition"] = self.partition(processes, points)
            times["migration"] = self.migration(processes, points)
            times["halo"] = self.halo(processes, points)
            deviation = math.sqrt(processes / sample_size(processes))  # of the points of a part
            largest = deviation * math.sqrt(2 * math.log(processes))  # of so many parts
            times["uneven parts"] = largest * times["search"]
        times["all"] = sum(times.values())
        return times

    def partition(self, processes, points):
        """Two samples and all cuts are gathered on all processes; counts of cells are added up."""
        size = sample_size(processes)
        looks = self.shared["partition"] * min(points, self.points_of_two)  # 2^17 points at most
        slots = 2 ** (math.ceil(math.log2(size)) + 1)
        return (looks + 2 * size * SECONDS_PER_CUT
                + 2 * gather(processes, size * BYTES_PER_POINT)
                + gather(processes, processes * BYTES_PER_CUT)
                + 2 * gather(processes, slots * 8))

    def migration(self, processes, points):
        """As if points that stay cost nothing: half of them moved between two processes."""
        moved = points * (1 - 1 / processes)
        return (2 * self.shared["migration"] * moved + moved * BYTES_PER_POINT / BYTES_PER_SECOND
                + 2 * processes * LATENCY)

    def halo(self, processes, points):
        return (self.shared["halo"] * points
                + halo(processes, points) * BYTES_PER_POINT / BYTES_PER_SECOND
                + processes * LATENCY)


def draw(axes, model, counts, points_of, title):
    prepare(axes, title, "processes", "seconds, of the model", ("log", "log"))
    for phase, style in STYLES.items():
        times = [(p, model.seconds(p, points_of(p))[phase]) for p in counts]
        draw_line(axes, [point for point in times if point[1] > 0], style, phase)


def main():
    one_path, two_path, folder = sys.argv[1:]
    model = Model(read_run(one_path), read_run(two_path))
    print("seconds per point, one process: ", model.alone)
    print("seconds per point, two processes:", model.shared)
    figure, axes = panels(1, 2, (9, 4.4), sharey=False)
    counts = [2 ** i for i in range(11)]
    strong = [p for p in counts if p >= 16]
    draw(axes[0][0], model, strong, lambda p: 1e9 / p, "10⁹ points on all processes")
    draw(axes[0][1], model, counts, lambda p: 1e6, "10⁶ points on each process")
    for name, p, points in [(name, p, points) for p in counts
                            for name, points in (("strong", 1e9 / p), ("weak", 1e6))]:
        if name == "weak" or p in strong:
            times = model.seconds(p, points)
            print(name, p, f"halo {halo(p, points) / points:.3f}",
                  *(f"{phase} {seconds:.3f}" for phase, seconds in times.items()))
    legend_below(figure, 4)
    save(figure, folder, "distributed_scaling.svg")


if __name__ == "__main__":
    main()
