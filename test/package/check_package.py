#!/usr/bin/env python3
"""Lays this tree out as a package of CGAL, and checks it with the CGAL that cmake finds.

  check_package.py <folder> [<option of cmake>]...

The folder is made anew. Each part of the package must configure, with all files that it names; the
manual must find its examples and figures; headers must name CGAL; one example must build and run;
and laying it out again must change nothing.

SPDX-License-Identifier: LGPL-3.0-or-later
"""

import pathlib
import re
import shutil
import subprocess
import sys

TOP = pathlib.Path(__file__).resolve().parent.parent.parent
PACKAGE = "Thick_intersection_d"
WRONG = []


def expect(condition, sentence):
    if not condition:
        WRONG.append(sentence)


def run(*command):
    done = subprocess.run([str(word) for word in command], text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    expect(done.returncode == 0, done.stdout)
    return done.stdout


def check_configuration(package, part, builds, options):
    said = run("cmake", "-S", package / part / PACKAGE, "-B", builds / part,
               "-DCMAKE_BUILD_TYPE=Debug", f"-DCMAKE_CXX_FLAGS_DEBUG=-O0 -I{package}/include",
               *options)
    for line in re.findall(r"^ *(.*does\s+not\s+exist.*)$", said, re.MULTILINE):
        WRONG.append(f"{part}: {line}")
    names = (package / part / PACKAGE / "CMakeLists.txt").read_text()
    for source in sorted((package / part / PACKAGE).glob("*.cpp")):
        expect(f'"{source.name}"' in names, f"{part}: {source.name} is not built")


def check_manual(package):
    for path in sorted((package / "doc" / PACKAGE).rglob("*.txt")):
        text = path.read_text(encoding="utf-8")
        for name in re.findall(r"\\(?:cgalExample\{|example |snippet )(\S+?\.cpp)", text):
            expect((package / "examples" / name).exists(), f"{path.name}: there is no {name}")
        for name in re.findall(r"\\cgal(?:FigureBegin\{\w+,|PkgPicture\{)([\w.]+)\}", text):
            expect((path.parent / "fig" / name).exists(), f"{path.name}: there is no {name}")


def check_headers(package):
    for path in sorted((package / "include").rglob("*.*")):
        lines = path.read_text(encoding="utf-8").splitlines()[:8]
        for line in ("// This file is part of CGAL (www.cgal.org).", "// $URL$", "// $Id$"):
            expect(line in lines, f"{path.name} has no line {line}")
    here = {path.relative_to(TOP) for path in (TOP / "include").rglob("*.*")}
    expect(here == {path.relative_to(package) for path in (package / "include").rglob("*.*")},
           "the headers are not those of the tree")


def main():
    folder, options = pathlib.Path(sys.argv[1]), sys.argv[2:]
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for changed in (r"[1-9]\d*", "0"):
        said = run(TOP / "scripts/cgal_package", folder)
        expect(re.search(rf"{changed} of them changed$", said), f"not {changed} files: {said}")
    package, builds = folder / PACKAGE, folder / "build"
    check_headers(package)
    check_manual(package)
    for part in ("examples", "test", "benchmark"):
        check_configuration(package, part, builds, options)
    run("cmake", "--build", builds / "examples", "--target", "near_points")
    if not WRONG:
        said = run(builds / "examples/near_points")
        expect(sorted(said.splitlines()) == ["0 1", "1 2"], f"near_points says {said}")
    print(*WRONG, f"{len(WRONG)} errors in the package", sep="\n")
    return 1 if WRONG else 0


if __name__ == "__main__":
    sys.exit(main())
