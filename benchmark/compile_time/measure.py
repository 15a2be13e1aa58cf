#!/usr/bin/env python3
"""Measures how long one call takes to compile, in the time of the kernel alone.

  measure.py [--quick] [--rounds <n>] [<word>]...

  --quick        one round
  --rounds <n>   7 rounds unless said otherwise
  <word>         the files with this word in their name; kernel.cpp in any case

In each round all files are compiled in turn, and each time is divided by that of kernel.cpp in the
same round. Times are those of the processor in the compiler. The figures are medians. CXX names the
compiler, CXXFLAGS more options, such as -I for a CGAL elsewhere.

SPDX-License-Identifier: LGPL-3.0-or-later
"""

import argparse
import os
import pathlib
import shlex
import statistics
import subprocess

FOLDER = pathlib.Path(__file__).resolve().parent
INCLUDE = FOLDER.parent.parent / "include"
KERNEL = "kernel"

FILES = {  # file: the call, target
    KERNEL: ("the kernel alone", None),
    "near_points": ("`fixed_radius_near_neighbors`, plane", 1.6),
    "near_points_in_space": ("`fixed_radius_near_neighbors`, space", None),
    "closest_pair": ("`closest_pair`, plane", None),
    "thick_objects": ("`thick_self_intersection_d`, segments", None),
    "boxes": ("`thick_box_self_intersection_d`, boxes in space", None),
    "box_intersection": ("`box_self_intersection_d`", None),
}


def seconds_to_compile(name):
    """The processor time of the compiler and what it calls."""
    command = [os.environ.get("CXX", "g++"), "-O2", "-std=c++17", f"-I{INCLUDE}",
               *shlex.split(os.environ.get("CXXFLAGS", "")), "-c", str(FOLDER / f"{name}.cpp"),
               "-o", os.devnull]
    before = os.times()
    subprocess.run(command, check=True)
    after = os.times()
    return (after.children_user + after.children_system
            - before.children_user - before.children_system)


def verdict(measured, target):
    """What a row says about its target."""
    if target is None:
        return "| | |"
    return f"| <= {target:.2f} | {'met' if measured <= target else 'missed'} |"


def main():
    """Prints a table in Markdown."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("words", nargs="*")
    options = parser.parse_args()

    names = [name for name in FILES
             if name == KERNEL or not options.words or any(w in name for w in options.words)]
    rounds = [{name: seconds_to_compile(name) for name in names}
              for _ in range(1 if options.quick else options.rounds)]
    print("| call | s | time / kernel | target | verdict |")
    print("|---|--:|--:|--:|---|")
    for name in names:
        call, target = FILES[name]
        seconds = statistics.median(times[name] for times in rounds)
        measured = statistics.median(times[name] / times[KERNEL] for times in rounds)
        print(f"| {call} | {seconds:.1f} | {measured:.2f} {verdict(measured, target)}")


if __name__ == "__main__":
    main()
