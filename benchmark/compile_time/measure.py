#!/usr/bin/env python3
"""Measures how long one call takes to compile, in the time of the kernel alone, and its code.

  measure.py [--quick] [--text] [<word>]...

  --quick        one round instead of 7
  --text         the code instead of the time: what one call adds to that of the kernel. Fails if it
                 is beyond its limit. Sizes repeat exactly, for one compiler
  <word>         the calls with this word in their name in calls.cpp; the kernel in any case

In each round all calls are compiled in turn, and each time is divided by that of the kernel in the
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
import sys
import tempfile

SOURCE = pathlib.Path(__file__).resolve().with_name("calls.cpp")
INCLUDE = SOURCE.parent.parent.parent / "include"
KERNEL = ("KERNEL", False)

# The call in calls.cpp, and whether it is linked: its name, target for the time, limit of the text
# in kB of g++ 12 on x86-64.
CALLS = {
    KERNEL: ("the kernel alone", None, None),
    ("NEAR_POINTS", False): ("`fixed_radius_near_neighbors`, plane", 1.6, None),
    ("NEAR_POINTS_IN_SPACE", False): ("`fixed_radius_near_neighbors`, space", 1.5, 119),
    ("NEIGHBOR_LISTS", False): ("`fixed_radius_neighbor_lists`, space", 1.6, 158),
    ("NEAR_POINTS_IN_SPACE", True): ("`fixed_radius_near_neighbors`, space, linked", 1.5, 17.2),
    ("NEIGHBOR_LISTS", True): ("`fixed_radius_neighbor_lists`, space, linked", 1.6, 18.3),
    ("CLOSEST_PAIR", False): ("`closest_pair`, plane", None, None),
    ("CLOSEST_PAIR_IN_SPACE", False): ("`closest_pair`, space", 1.5, 108.5),
    ("CLOSEST_PAIR_IN_SPACE", True): ("`closest_pair`, space, linked", 1.5, 27.9),
    ("SEGMENTS", False): ("`thick_self_intersection_d`, segments", None, None),
    ("TRIANGLES", False): ("`thick_self_intersection_d`, triangles in space", 1.4, 81),
    ("TRIANGLES", True): ("`thick_self_intersection_d`, triangles in space, linked", 1.6, 8.6),
    ("NEAR_SEGMENTS", False): ("`fixed_radius_near_neighbors`, segments in space", None, 106.5),
    ("BOXES", False): ("`thick_box_self_intersection_d`, boxes in space", 1.5, 67.5),
    ("BOXES", True): ("`thick_box_self_intersection_d`, boxes in space, linked", 1.5, 12.8),
    ("FIVE_CALLS", False): ("five calls of five kinds, space", None, None),
    ("FIVE_CALLS", True): ("five calls of five kinds, space, linked", 2.4, None),
    ("BOX_INTERSECTION", False): ("`box_self_intersection_d`", None, None),
}


def compile_file(source, output, *options):
    """Compiles a file to an object file."""
    command = [os.environ.get("CXX", "g++"), "-O2", "-std=c++17", f"-I{INCLUDE}",
               f"-fmacro-prefix-map={INCLUDE}=include",  # for sizes that do not depend on the path
               *shlex.split(os.environ.get("CXXFLAGS", "")), *options, "-c", str(source),
               "-o", str(output)]
    subprocess.run(command, check=True)


def options_of(call):
    """The macros that make calls.cpp have a call."""
    name, is_linked = call
    return [f"-DCALL_{name}"] + ["-DCGAL_THICK_INTERSECTION_D_COMPILED"] * is_linked


def seconds_to_compile(call):
    """The processor time of the compiler and what it calls."""
    before = os.times()
    compile_file(SOURCE, os.devnull, *options_of(call))
    after = os.times()
    return (after.children_user + after.children_system
            - before.children_user - before.children_system)


def text_of(call, header):
    """The bytes of code and constants. The header has been compiled."""
    output = header.with_name("call.o")
    compile_file(SOURCE, output, *options_of(call), "-include", str(header))
    table = subprocess.run(["size", str(output)], check=True, capture_output=True, text=True)
    return int(table.stdout.splitlines()[1].split()[0])


def verdict(measured, target):
    """What a row says about its target."""
    if target is None:
        return "| | |"
    return f"| <= {target:.2f} | {'met' if measured <= target else 'missed'} |"


def print_times(names, round_count):
    """Prints the table of times in Markdown."""
    rounds = [{name: seconds_to_compile(name) for name in names} for _ in range(round_count)]
    print("| call | s | time / kernel | target | verdict |")
    print("|---|--:|--:|--:|---|")
    for name in names:
        call, target, _ = CALLS[name]
        seconds = statistics.median(times[name] for times in rounds)
        measured = statistics.median(times[name] / times[KERNEL] for times in rounds)
        print(f"| {call} | {seconds:.1f} | {measured:.2f} {verdict(measured, target)}")


def print_texts(names, folder):
    """Prints the table of texts in Markdown. Returns whether all limits are kept.

    The header of the kernel is compiled once for all calls, in a folder for temporary files. Their
    code is the same to the byte.
    """
    are_kept = True
    header = pathlib.Path(folder) / "kernel.h"
    header.write_text("#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>\n",
                      encoding="utf-8")
    compile_file(header, f"{header}.gch", "-x", "c++-header")
    of_kernel = text_of(KERNEL, header)
    print("| call | kB beyond the kernel | limit | verdict |")
    print("|---|--:|--:|---|")
    for name in names:
        call, _, limit = CALLS[name]
        if limit is not None:
            measured = (text_of(name, header) - of_kernel) / 1000
            are_kept = are_kept and measured <= limit
            print(f"| {call} | {measured:.1f} {verdict(measured, limit)}")
    return are_kept


def main():
    """Prints a table in Markdown."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--text", action="store_true")
    parser.add_argument("words", nargs="*")
    options = parser.parse_args()

    names = [name for name in CALLS
             if name == KERNEL or not options.words or any(w in name[0] for w in options.words)]
    if options.text:
        with tempfile.TemporaryDirectory() as folder:
            return 0 if print_texts(names, folder) else 1
    print_times(names, 1 if options.quick else 7)
    return 0


if __name__ == "__main__":
    sys.exit(main())
