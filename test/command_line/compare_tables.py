#!/usr/bin/env python3
# Copyright (c) 2026 The Thick_intersection_d authors.
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Compares how near_pairs reads files with how the readers of the field do; see doc/readers.md.

   compare_tables.py NEAR_PAIRS [FILE...]

Tables (.csv, .tsv, .txt) are compared with Python's csv, two columns of numbers at a time, and
nodes (.tsp) with the package tsplib95. Without files, Python's csv writes random tables in its
dialects. For each file that differs, it is said how; the last line counts.
"""

import collections
import csv
import io
import itertools
import pathlib
import random
import subprocess
import sys
import tempfile


def points_of(program, file, arguments):
    """Returns what near_pairs reads: rows of id and coordinates, or its error as a text."""
    run = subprocess.run([program, str(file), "--distance", "0", "--points", "-", "--coordinates",
                          *arguments], capture_output=True, check=False, timeout=300)
    if run.returncode:
        return run.stderr.decode("utf-8", "replace").strip()
    table = io.StringIO(run.stdout.decode("utf-8", "replace"), newline="")
    rows = list(csv.reader(table))
    ends = len(rows[0]) - 2  # the neighbors and the component come last
    begin = 1 + ("id" in rows[0])
    return [(row[1] if begin == 2 else "", *map(float, row[begin:ends])) for row in rows[1:]]


def number(text):
    try:
        value = float(text)
    except ValueError:
        return None
    return value if abs(value) < float("inf") and "_" not in text else None


def plain(text):
    """Returns a name without what near_pairs does not keep: blanks around it, and kinds of line ends."""
    return text.replace("\r\n", "\n").replace("\r", "\n").strip()


def table_of(file, separator):
    """Returns the rows of a table by Python's csv; a row has at least one field with text."""
    text = pathlib.Path(file).read_bytes().decode("utf-8-sig", "replace")
    rows = csv.reader(io.StringIO(text, newline=""), delimiter=separator)
    return [row for row in rows if any(row)]


def faults_of_table(program, file, separator=None):
    """Yields how the readers differ; nothing if they agree. Raises LookupError if the file has no
    header and two columns of numbers."""
    if separator is None:
        first = pathlib.Path(file).read_bytes().decode("utf-8", "replace").split("\n")[0]
        separator = max(",;\t|", key=first.count)
    rows = table_of(file, separator)
    width = len(rows[0]) if rows else 0
    regular = [row for row in rows[1:] if len(row) == width]
    numbers = [k for k in range(width) if regular and all(number(row[k]) is not None
                                                          for row in regular)]
    if len(numbers) < 2 or all(number(name) is not None for name in rows[0]):
        raise LookupError
    x, y = numbers[:2]
    names = [k for k in range(width) if k not in (x, y)] or [x]
    wanted = [(k, [(plain(row[k]), number(row[x]), number(row[y])) for row in rows[1:]
                   if len(row) == width]) for k in names]
    fields = sorted({len(row) for row in rows})
    for k, expected in wanted:
        found = points_of(program, file, ["--separator", "tab" if separator == "\t" else separator,
                                          "--columns", f"{x + 1},{y + 1}", "--id", str(k + 1)])
        if isinstance(found, str):
            yield found if fields == [width] else f"{found} (Python: rows of {fields} fields)"
            return
        found = [(plain(name), *rest) for name, *rest in found]
        if found != expected:
            differing = next((pair for pair in itertools.zip_longest(found, expected)
                              if pair[0] != pair[1]), None)
            yield f"column {k + 1}: {differing[0]}, where Python has {differing[1]}"


def faults_of_nodes(program, file):
    import tsplib95
    try:
        problem = tsplib95.load(file)
    except Exception as error:  # of many kinds
        raise LookupError from error
    if not problem.node_coords:
        raise LookupError
    is_geo = problem.edge_weight_type == "GEO"
    found = points_of(program, file, ["--geographic"] if is_geo else [])
    if isinstance(found, str):
        yield found
        return
    expected = list(problem.node_coords.values())
    if is_geo:
        expected = [[int(value) + (value - int(value)) * 5 / 3 for value in node]
                    for node in expected]
    if len(found) != len(expected) or any(abs(a - b) > 1e-8 for (_, *p), q in zip(found, expected)
                                          for a, b in zip(p, q)):
        yield f"{len(found)} nodes, and they are not the {len(expected)} of tsplib95"


def random_field(rng):
    pieces = ["a", " b", "\"", "'", ",", ";", "\t", "|", "\n", "\r\n", "#", "5\"", "\u00e4", "1,5", ""]
    return "".join(rng.choice(pieces) for _ in range(rng.randrange(5)))


def write_random_table(rng, file):
    """Writes a table in one of the dialects of Python's csv; returns its separator."""
    separator = rng.choice(",;\t|")
    with open(file, "w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream, delimiter=separator, lineterminator=rng.choice(["\n", "\r\n"]),
                            quoting=rng.choice([csv.QUOTE_MINIMAL, csv.QUOTE_ALL]))
        writer.writerow(["name", "x", "y", "note"])
        for _ in range(rng.randrange(1, 8)):
            name, note = random_field(rng), random_field(rng)
            if name.startswith("#"):  # near_pairs takes such a row if it has one line
                name, note = (text.replace("\n", "").replace("\r", "") for text in (name, note))
            writer.writerow([name, rng.randrange(-9, 9), rng.uniform(-1, 1), note])
    return separator


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    counts = collections.Counter()

    def count(name, find_faults):
        try:
            found = list(find_faults())
        except LookupError:
            counts["not comparable"] += 1
            return
        counts["differ" if found else "agree"] += 1
        for fault in found[:1]:
            print(f"{name}: {fault}")

    for file in sys.argv[2:]:
        faults = faults_of_nodes if file.endswith(".tsp") else faults_of_table
        count(file, lambda: faults(program, file))
    if len(sys.argv) == 2:
        with tempfile.TemporaryDirectory() as scratch:
            for seed in range(300):
                file = pathlib.Path(scratch) / f"random_{seed}.csv"
                separator = write_random_table(random.Random(seed), file)
                count(file.name, lambda: faults_of_table(program, file, separator))
    print(", ".join(f"{counts[word]} {word}" for word in ("agree", "differ", "not comparable")))
    return 1 if counts["differ"] else 0


if __name__ == "__main__":
    sys.exit(main())
