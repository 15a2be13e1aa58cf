#!/usr/bin/env python3
# Copyright (c) 2026 The Thick_intersection_d authors.
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Compares what near_pairs reads from files of molecules with what readers of the field read.

   compare_molecules.py NEAR_PAIRS FILE...

Files are .xyz, .pdb, .ent, .cif or .mmcif, perhaps with .gz behind. ASE reads .xyz, and gemmi the
others (Debian: python3-ase, python3-gemmi). Compared are the number of frames or models, and the
coordinates and the cell of each of them, as doubles. Atoms are compared as multisets: gemmi orders
them by chains. A file that the other reader refuses, or whose name says that it should fail
(tests_fail*, bad/*), is to be refused.

Prints each file that differs, and why, and a count at the end. No test runs this: the files of
others are fetched by hand. doc/readers.md has what came of it.
"""

import csv
import gzip
import pathlib
import re
import subprocess
import sys
import tempfile
import warnings

import ase.io
import gemmi
import numpy

MOST_FRAMES = 20  # of a file, whose atoms are compared


class Refused(Exception):
    """What a reader says about a file that it does not read."""


def format_of(file):
    name = file.name.removesuffix(".gz")
    return name[name.rfind(".") + 1:].lower()


def theirs(file):
    """Returns the frames of a file: coordinates, and the vectors of the cell or None."""
    try:
        return of_ase(file) if format_of(file) == "xyz" else of_gemmi(file)
    except Exception as error:  # each reader raises what it likes
        raise Refused(f"{type(error).__name__}: {error}") from error


def of_ase(file):
    with (gzip.open if file.suffix == ".gz" else open)(file, "rt", encoding="latin-1") as lines:
        comment = "".join(next(lines, "") for _ in range(2))
        lines.seek(0)
        is_extended = re.search(r"(Properties|Lattice)\W*=", comment)
        frames = ase.io.read(lines, index=":", format="extxyz" if is_extended else "xyz")
    return [(frame.positions, [vector if repeats else None for vector, repeats
                               in zip(frame.cell, frame.pbc)] if frame.cell.any() else None)
            for frame in frames]


def of_gemmi(file):
    structure = gemmi.read_structure(str(file), merge_chain_parts=False)
    cell = None
    if structure.cell.is_crystal():
        cell = list(numpy.array(structure.cell.orthogonalization_matrix.tolist()).T)
    frames = [[cra.atom.pos.tolist() for cra in model.all()] for model in structure]
    if not frames or not any(frames):
        raise ValueError("no atoms")
    return [(frame, cell) for frame in frames]


def run(program, file, *options):
    command = [program, str(file), "--distance", "0", *options]
    done = subprocess.run(command, capture_output=True, text=True, timeout=600, check=False)
    if done.returncode != 0:
        raise Refused(done.stderr.strip())
    return dict(re.split(r"  +", line, maxsplit=1) for line in done.stdout.splitlines())


def ours(program, file, frame):
    """Returns the number of frames of a file, and the coordinates and the cell of one."""
    with tempfile.TemporaryDirectory() as folder:
        table = pathlib.Path(folder) / "points.csv"
        summary = run(program, file, "--frame", str(frame), "--points", str(table),
                      "--coordinates")
        with open(table, encoding="utf-8", newline="") as rows:
            points = [[float(row[axis]) for axis in "xyz"] for row in csv.DictReader(rows)]
    try:
        cell = cell_of(run(program, file, "--frame", str(frame), "--periodic", "file")["cell"])
    except Refused:
        cell = None
    count = int(summary.get("frame", "1 of 1").split()[-1])
    return count, points, cell


def cell_of(words):
    """Reads the cell of a summary: sides, vectors in parentheses, or none."""
    vectors = []
    for axis, word in enumerate(re.findall(r"\([^)]*\)|[^,\s]+", words.replace(", rounded", ""))):
        if word == "none":
            vectors.append(None)
        elif word.startswith("("):
            vectors.append([float(number) for number in word[1:-1].split()])
        else:
            vectors.append([float(word) if k == axis else 0. for k in range(3)])
    return vectors


def same_points(a, b):
    return sorted(map(tuple, a)) == sorted(map(tuple, b))


def same_cells(a, b):
    if a is None or b is None:
        return a is b
    return all((u is None) == (v is None) and (u is None or numpy.allclose(u, v, 1e-9, 1e-6))
               for u, v in zip(a, b))


def difference(program, file):
    """Returns in what the readers differ, or an empty text."""
    try:
        frames = theirs(file)
    except Refused as refused:
        frames, reason = None, str(refused)
    if file.name.startswith("tests_fail") or file.parent.name == "bad":
        frames, reason = None, "its name"
    try:
        count = ours(program, file, 1)[0]
    except Refused as refused:
        return "" if frames is None else f"refused: {refused}"
    if frames is None:
        return f"read, where the other refuses: {reason}"
    if count != len(frames):
        return f"{count} frames, where the other has {len(frames)}"
    for number, (points, cell) in enumerate(frames[:MOST_FRAMES], 1):
        _, our_points, our_cell = ours(program, file, number)
        if not same_points(points, our_points):
            return f"frame {number}: other atoms: {len(our_points)} and {len(points)}"
        if not same_cells(cell, our_cell):
            return f"frame {number}: another cell: {our_cell} and {cell}"
    return ""


def main():
    warnings.simplefilter("ignore")
    program = str(pathlib.Path(sys.argv[1]).resolve())
    files = list(map(pathlib.Path, sys.argv[2:]))
    differing = 0
    for file in files:
        what = difference(program, file)
        differing += bool(what)
        if what:
            print(f"{file}: {what}")
    print(f"{len(files)} files: {len(files) - differing} alike, {differing} different")
    return 1 if differing or not files else 0


if __name__ == "__main__":
    sys.exit(main())
