# Copyright (c) 2026 The Thick_intersection_d authors.
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Checks what near_pairs writes by definitions, in words of their own; see check_cases.py."""

import collections
import csv
import fractions
import itertools
import json
import math
import re
import xml.dom.minidom
import xml.parsers.expat

Fraction = fractions.Fraction


def faults_of_file(path):
    """Yields what is wrong with a picture or a map, whatever it shows."""
    try:
        if path.suffix == ".svg":
            yield from texts_outside(path)
        elif path.suffix == ".geojson":
            json.loads(path.read_bytes())
    except (ValueError, xml.parsers.expat.ExpatError) as error:
        yield f"{path.name}: {error}"


def texts_outside(path):
    """Yields each text of a picture that is cut off; letters are as wide as in DejaVu Sans."""
    svg = xml.dom.minidom.parse(str(path)).documentElement
    width, height = float(svg.getAttribute("width")), float(svg.getAttribute("height"))
    for text in svg.getElementsByTagName("text"):
        left, top, right, bottom = box_of(text)
        if left < 0 or top < 0 or right > width or bottom > height:
            yield f"outside of {path.name}: {text.toxml()}"


def box_of(text):
    size = float(text.getAttribute("font-size") or 13)
    length = 0.58 * size * sum(len(node.data) for node in text.childNodes)
    x, y = (float(text.getAttribute(name)) for name in "xy")
    left = x - {"": 0, "middle": 0.5, "end": 1}[text.getAttribute("text-anchor")] * length
    box = (left, y - 0.8 * size, left + length, y + 0.3 * size)
    turned = re.match(r"translate\((\S+) (\S+)\) rotate", text.parentNode.getAttribute("transform"))
    if not turned:
        return box
    x, y = map(float, turned.groups())
    return x + box[1], y - box[2], x + box[3], y - box[0]


def components(run):
    """The neighbors and components of points.csv are those of the pairs of pairs.csv."""
    pairs, points = (list(csv.DictReader(run.text(f"{name}.csv").splitlines()))
                     for name in ("pairs", "points"))
    neighbors = collections.defaultdict(list)
    for pair in pairs:
        i, j = int(pair["i"]), int(pair["j"])
        neighbors[i].append(j)
        neighbors[j].append(i)
    component, count = [None] * len(points), 0
    for begin in range(len(points)):
        reached = [begin] if component[begin] is None else []
        count += len(reached)
        while reached:
            point = reached.pop()
            if component[point] is None:
                component[point] = count - 1
                reached += neighbors[point]
    found = [(int(point["neighbors"]), int(point["component"])) for point in points]
    return found == [(len(neighbors[i]), component[i]) for i in range(len(points))]


def images(run, vectors, repeats, squared, kind, *files):
    """pairs.csv and the summary have the images within a squared distance, in rational numbers."""
    found = list(near_images(run, cell_of(vectors, len(repeats)), repeats, Fraction(squared),
                             Fraction if kind == "decimal" else lambda word: Fraction(float(word)),
                             files))
    is_periodic = "T" in repeats
    columns = 2 + len(repeats) * is_periodic
    rows = [tuple(map(int, row.split(",")[:columns]))
            for row in run.text("pairs.csv").splitlines()[1:]]
    crossing = f"{sum(map(any, (row[2:] for row, _ in found)))}, the boundary of the cell"
    return (sorted(rows) == sorted(row[:columns] for row, _ in found)
            and run.has_line("pairs", str(len(found)))
            and run.has_line("on boundary", str(sum(d == Fraction(squared) for _, d in found)))
            and (not is_periodic or run.has_line("crossing", crossing)))


def cell_of(vectors, dimension):
    numbers = [Fraction(word) for word in vectors.split(",")]
    return [numbers[k:k + dimension] for k in range(0, len(numbers), dimension)]


def near_images(run, cell, repeats, squared, number, files):
    """Yields the positions and the offset of each pair, and its squared distance."""
    most = 7
    points = [[[number(word) for word in re.split("[, ]", line)]
               for line in run.text(file).splitlines() if line[0] != "x"] for file in files]
    moves = {offset: [sum(n * vector[axis] for n, vector in zip(offset, cell))
                      for axis in range(len(cell))]
             for offset in itertools.product(*(range(-most, most + 1) if repeat == "T" else [0]
                                               for repeat in repeats))}
    for (i, p), (j, q) in itertools.product(enumerate(points[0]), enumerate(points[-1])):
        for offset, move in moves.items():
            if len(files) == 1 and (j < i or (j == i and offset <= (0,) * len(cell))):
                continue
            distance = sum((b + m - a) ** 2 for a, b, m in zip(p, q, move))
            if distance <= squared:
                assert max(map(abs, offset)) < most
                yield (i, j, *offset), distance


def cell(run, *sides_and_angles):
    """The vectors of the cell, of which the first one is along the first axis, have these lengths
    and angles."""
    words = re.search("^cell +(.*), rounded$", run.out, re.M)[1]
    a, b, c = [float(words.split(",")[0]), 0, 0], *(
        list(map(float, vector.split())) for vector in re.findall(r"\((.*?)\)", words))

    def angle(v, w):
        cosine = sum(x * y for x, y in zip(v, w)) / (math.hypot(*v) * math.hypot(*w))
        return math.degrees(math.acos(cosine))
    found = [*(math.hypot(*vector) for vector in (a, b, c)), angle(b, c), angle(a, c), angle(a, b)]
    return all(abs(float(x) - y) < 1e-10 for x, y in zip(sides_and_angles, found))


def halves(run):
    """The picture of a pair across the boundary, 9 apart in a cell of 10, has two lines, from each
    of its points to the middle."""
    path = re.search("#0072B2' d='(.*?)'/", run.text("picture.svg"))[1]
    lines = [tuple(map(float, line.replace("L", " ").split())) for line in path.split("M")[1:]]
    (x, y, x_end, y_end), (u, v, u_end, v_end) = sorted(lines)
    unit = (u - x) / 9
    return (y == v == y_end == v_end and abs(x_end - (x - unit / 2)) < 0.2
            and abs(u_end - (u + unit / 2)) < 0.2)
