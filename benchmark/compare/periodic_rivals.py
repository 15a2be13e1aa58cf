#!/usr/bin/env python3
"""Sets searches of Python's libraries beside ours: points in boxes that repeat.

    periodic_table --scenes=<folder>       # or periodic_pairs of the laboratory
    periodic_rivals.py <folder>            # prints times as rows in Markdown, and wrong pairs
    periodic_rivals.py <folder> <csv>      # appends rows to the table of the laboratory

Reads the scenes of a folder, and their pairs. Libraries that are missing are left out (Debian:
python3-scipy, python3-ase, python3-mdanalysis). They run in one thread.

SPDX-License-Identifier: LGPL-3.0-or-later
"""

import os

for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
    os.environ[variable] = "1"

import csv
import pathlib
import sys
import time
import warnings

import numpy as np

warnings.filterwarnings("ignore")


class Scene:
    """Points, the vectors of the lattice, the distance, and the pairs with a mark of ties.

    All lengths are scaled by a power of two, which rounds nothing, so that the distance is from 4
    to 8: libraries for atoms have cells that are not much shorter.
    """

    def __init__(self, path):
        facts = path.with_suffix(".scene").read_text().splitlines()
        self.name = facts[4] if len(facts) > 4 else path.stem
        scale = 2.0 ** np.ceil(np.log2(4 / float(facts[0])))
        self.r = scale * float(facts[0])
        self.vectors = scale * np.array([line.split() for line in facts[1:4]], dtype=float)
        self.points = scale * np.fromfile(path.with_suffix(".points")).reshape(-1, 3)
        rows = np.fromfile(path.with_suffix(".pairs"), dtype=np.int32).reshape(-1, 6)
        self.pairs, self.are_ties = rows[:, :5], rows[:, 5] != 0
        self.is_box = np.count_nonzero(self.vectors - np.diag(np.diag(self.vectors))) == 0


def by_scipy(scene):
    """A tree of points in a box, without offsets."""
    from scipy.spatial import cKDTree
    tree = cKDTree(scene.points, boxsize=np.diag(scene.vectors))
    return tree.query_pairs(scene.r, output_type="ndarray")


def by_ase(scene):
    """Lists of neighbors by cells, in NumPy: both ways of each pair, with offsets."""
    from ase.neighborlist import primitive_neighbor_list
    i, j, offsets = primitive_neighbor_list("ijS", (True, True, True), scene.vectors, scene.points,
                                            scene.r)
    return np.column_stack((i, j, offsets))


def by_mdanalysis(scene):
    """Cells of a compiled library, which takes positions as floats, without offsets."""
    from MDAnalysis.lib import distances, mdamath
    box = mdamath.triclinic_box(*scene.vectors)
    return distances.self_capped_distance(scene.points.astype(np.float32), scene.r, box=box,
                                          method="nsgrid", return_distances=False)


# Name, search, whether it takes skewed boxes, whether a pair at the distance counts for it, and the
# most points. ASE takes more than 10 kB of memory for each.
METHODS = [
    ("scipy cKDTree", by_scipy, False, True, 10**7),
    ("ASE", by_ase, True, False, 10**5),
    ("MDAnalysis", by_mdanalysis, True, True, 10**7),
]


def in_order(pairs):
    """Each pair once, as i < j, or i = j and a positive offset."""
    i, j, offsets = pairs[:, 0], pairs[:, 1], pairs[:, 2:]
    if offsets.shape[1] == 0:
        return np.column_stack((np.minimum(i, j), np.maximum(i, j)))
    x, y, z = offsets.T
    is_positive = (x > 0) | ((x == 0) & ((y > 0) | ((y == 0) & (z > 0))))
    return pairs[(i < j) | ((i == j) & is_positive)]


def keys(pairs):
    """A number for each row."""
    pairs = pairs.astype(np.int64)
    key = pairs[:, 0] * (1 << 22) + pairs[:, 1]
    for axis in range(2, pairs.shape[1]):
        key = key * 16 + (pairs[:, axis] + 8)
    return np.sort(key)


def difference(a, b):
    """How many of a are not in b, with repetitions."""
    values, counts = np.unique(a, return_counts=True)
    others, other_counts = np.unique(b, return_counts=True)
    places = np.searchsorted(others, values)
    has = np.zeros(len(values), dtype=np.int64)
    inside = places < len(others)
    found = np.zeros(len(values), dtype=bool)
    found[inside] = others[places[inside]] == values[inside]
    has[found] = other_counts[places[found]]
    return int(np.maximum(counts - has, 0).sum())


def wrong_pairs(scene, found, is_closed):
    """How many pairs are missing, and how many are too many."""
    true_pairs = scene.pairs if is_closed else scene.pairs[~scene.are_ties]
    found = in_order(found)
    true_keys, found_keys = keys(true_pairs[:, :found.shape[1]]), keys(found)
    return len(true_pairs), difference(true_keys, found_keys), difference(found_keys, true_keys)


def least_time(search, scene, most):
    """Returns the least of times of the processor, until they are `most`, and what was found."""
    least, spent = None, 0
    while least is None or spent < most:
        start = time.process_time()
        found = search(scene)
        seconds = time.process_time() - start
        least = seconds if least is None else min(least, seconds)
        spent += seconds
    return least, found


def main():
    folder = pathlib.Path(sys.argv[1])
    scenes = [Scene(path) for path in sorted(folder.glob("*.scene"))]
    rows = []
    for name, search, takes_skewed, is_closed, most in METHODS:
        for scene in scenes:
            if not (takes_skewed or scene.is_box) or len(scene.points) > most:
                continue
            try:
                seconds, found = least_time(search, scene, 0 if len(sys.argv) > 2 else 3)
            except ImportError:
                print(f"{name} is left out", file=sys.stderr)
                break
            true, missing, extra = wrong_pairs(scene, found, is_closed)
            rows.append([scene.name, len(scene.points), true, int(scene.are_ties.sum()), name,
                         "<=" if is_closed else "<", missing, extra])
            wrong = f", {missing} missing, {extra} extra" if missing + extra else ""
            print(f"| {scene.name} | {name}{wrong} | {len(found)} | {1000 * seconds:.4g} | | |",
                  flush=True)
    if len(sys.argv) > 2:
        with open(sys.argv[2], "a", newline="", encoding="utf-8") as out:
            csv.writer(out, quoting=csv.QUOTE_NONNUMERIC, lineterminator="\n").writerows(rows)


main()
