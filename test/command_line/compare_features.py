#!/usr/bin/env python3
# Copyright (c) 2026 The Thick_intersection_d authors.
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Compares what near_pairs reads of files of features with what GEOS reads of them (by Shapely).

  compare_features.py PRINT_FEATURES FILE...

PRINT_FEATURES is the program of print_features.cpp. A FILE is GeoJSON, WKT with a geometry on each
line, or a test of GEOS' xmltester, of which each geometry is taken. doc/readers.md has the files
and the figures. Prints what differs, and ends with the status 1 if the readers read something
different; that only one of them reads a geometry is no fault.
"""

import collections
import json
import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

import shapely.errors
import shapely.geos
import shapely.wkt
from shapely.geometry import shape


def texts_of(file):
    """The texts of a file, of one or more geometries each, and their format."""
    if file.suffix == ".xml":
        root = xml.etree.ElementTree.parse(file).getroot()
        texts = {(element.text or "").strip() for name in ("a", "b", "op")
                 for element in root.iter(name)}
        return [(text, ".wkt") for text in sorted(texts) if "(" in text or "EMPTY" in text]
    text = file.read_text(encoding="utf-8")
    if file.suffix == ".wkt":
        return [(line, ".wkt") for line in text.splitlines() if line.strip()]
    return [(text, ".geojson")]


def parts_of(geometry):
    """The lines and polygons of a geometry, as near_pairs has them."""
    lines, polygons = [], []
    if geometry.is_empty:
        pass
    elif hasattr(geometry, "geoms"):
        for part in geometry.geoms:
            of_part = parts_of(part)
            lines += of_part["lines"]
            polygons += of_part["polygons"]
    elif geometry.geom_type == "Polygon":
        polygons = [[[list(p[:2]) for p in ring.coords][:-1]
                     for ring in (geometry.exterior, *geometry.interiors) if not ring.is_empty]]
    else:
        lines = [[list(p[:2]) for p in geometry.coords]]
    return {"lines": lines, "polygons": polygons}


def by_geos(text, suffix):
    """The features of a text; a string if GEOS refuses it."""
    try:
        if suffix == ".wkt":
            return [parts_of(shapely.wkt.loads(text))]
        found = json.loads(text)
        features = found["features"] if found["type"] == "FeatureCollection" else [found]
        return [parts_of(shape(feature["geometry"] if feature["type"] == "Feature" else feature))
                for feature in features]
    except (shapely.errors.ShapelyError, ValueError, AttributeError) as error:
        return str(error)


def by_near_pairs(program, texts):
    with tempfile.TemporaryDirectory() as folder:
        files = []
        for number, (text, suffix) in enumerate(texts):
            files.append(pathlib.Path(folder) / f"{number}{suffix}")
            files[-1].write_text(text, encoding="utf-8")
        run = subprocess.run([program, *map(str, files)], capture_output=True, check=True)
        return [json.loads(line) for line in run.stdout.splitlines()]


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    counts = collections.Counter()
    for file in map(pathlib.Path, sys.argv[2:]):
        texts = texts_of(file)
        for (text, suffix), ours in zip(texts, by_near_pairs(sys.argv[1], texts)):
            theirs = by_geos(text, suffix)
            refused = [isinstance(read, str) for read in (ours, theirs)]
            verdict = {(True, True): "refused by both", (True, False): "refused by near_pairs",
                       (False, True): "refused by GEOS"}.get(
                           tuple(refused), "the same" if ours == theirs else "different")
            counts[verdict] += 1
            if verdict != "the same":
                print(f"{file.name}: {verdict}: {text[:100]!r}")
                print(*(f"  {str(read)[-100:]}" for read in (ours, theirs)), sep="\n")
        counts["files"] += 1
    print(", ".join(f"{count} {name}" for name, count in sorted(counts.items())))
    sys.exit(1 if counts["different"] else 0)


if __name__ == "__main__":
    main()
