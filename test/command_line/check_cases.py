#!/usr/bin/env python3
# Copyright (c) 2026 The Thick_intersection_d authors.
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Runs near_pairs on small files, and compares what it prints with what is right.

   check_cases.py NEAR_PAIRS CASES...

CASES is a text. A case is a line "$ arguments", run in the folder of the text, and what is expected:

   pairs: 0,1 0,2     these pairs of positions, in any order, and no others; may be empty
   says: words        a line of the summary or a hint has these words; may be repeated
   error: words       one line on stderr has these words, the status is 2, and there is no output

Lines that begin with # are comments. Each case has "pairs:" or "error:" or "says:"; without
"error:" the program must end well.
"""

import pathlib
import shlex
import subprocess
import sys
import tempfile


def cases_of(text):
    """Returns the cases of a text: the arguments, and a list of (word, expected text) for each."""
    cases = []
    for number, line in enumerate(text.read_text(encoding="utf-8").splitlines(), 1):
        if line.startswith("$ "):
            cases.append((line[2:], []))
        elif line.strip() and not line.startswith("#"):
            word, colon, expected = line.partition(":")
            if not cases or not colon or word not in ("pairs", "says", "error"):
                sys.exit(f"{text}:{number}: neither a case nor what is expected: {line}")
            cases[-1][1].append((word, expected.strip()))
    return cases


def pairs_of(file):
    """Returns the pairs of a file that near_pairs wrote, in ascending order."""
    rows = file.read_text(encoding="utf-8").splitlines()[1:]
    return sorted(tuple(map(int, row.split(",")[:2])) for row in rows)


def faults(program, folder, arguments, expected):
    """Runs a case, and returns a sentence for each expectation that is not met."""
    with tempfile.TemporaryDirectory() as scratch:
        pairs_file = pathlib.Path(scratch) / "pairs.csv"
        command = [program] + shlex.split(arguments)
        if any(word == "pairs" for word, _ in expected):
            command += ["--pairs", str(pairs_file)]
        run = subprocess.run(command, cwd=folder, capture_output=True, timeout=300, check=False,
                             stdin=subprocess.DEVNULL)
        out, err = (stream.decode("utf-8", "replace") for stream in (run.stdout, run.stderr))
        wants_error = any(word == "error" for word, _ in expected)
        if not expected:
            yield "nothing is expected"
        if wants_error and (run.returncode != 2 or out or len(err.splitlines()) != 1):
            yield f"status {run.returncode}, where one line of an error is expected: {out}{err}"
        if not wants_error and run.returncode != 0:
            yield f"status {run.returncode}: {err}"
            return
        for word, text in expected:
            if word == "pairs":
                wanted = sorted(tuple(map(int, pair.split(","))) for pair in text.split())
                found = pairs_of(pairs_file)
                if found != wanted:
                    yield f"pairs {found[:20]}, where {wanted} are right"
            elif text not in (err if word == "error" else out + err):
                yield f"'{text}' is not in: {out}{err}"


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    count = failed = 0
    for text in map(pathlib.Path, sys.argv[2:]):
        for arguments, expected in cases_of(text):
            found = list(faults(program, text.parent, arguments, expected))
            count += 1
            failed += bool(found)
            for fault in found:
                print(f"FAILED  {text}: {arguments}\n        {fault}")
    print(f"{count - failed} passed, {failed} failed")
    return 1 if failed or not count else 0


if __name__ == "__main__":
    sys.exit(main())
