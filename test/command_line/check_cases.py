#!/usr/bin/env python3
# Copyright (c) 2026 The Thick_intersection_d authors.
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Runs near_pairs on small files, and compares what it prints and writes with what is right.

   check_cases.py NEAR_PAIRS DATA CASES...

DATA is the folder examples/data. CASES is a text of cases. A case is one or more commands, each of
which must do all that is said below them:

   $ arguments            runs near_pairs with these arguments, as bash reads them
   ! command              runs a command of bash, which finds near_pairs by its name

   NAME = value           the line NAME of the summary has this value
   pairs: 0,1 0,2         these pairs of positions are found, in any order, and no others
   says: words            the output or what is on stderr has these words
   error: words           one line on stderr, with these words; the status is 2, there is no output
                          and no new file
   hint: words            one line on stderr, a hint with these words
   status: number         the status, which is 0 where nothing else is said; if it is not 0, there
                          is no new file
   is FILE: text          this is the whole file; out and err are what is printed
   rows FILE: text        the same, but the lines are in any order
   has FILE: words        the file has these words
   matches FILE: regex    a place of the file matches; ^ and $ are the ends of lines
   lacks FILE: regex      no place does
   as: arguments          near_pairs finds the same pairs with these arguments
   by: check words        a function of checks.py has no objection
   if: command            the case is for systems on which this command succeeds

A text makes files of its own, before all cases:

   file NAME: text        a file with this text
   make NAME: command     a file with what a command of bash prints
   | line                 a line that follows in the last file

The texts of files, of "is" and of "rows" have the escapes of Python. Commands know $data and
$ships, a table of DATA. The files in the folder of the text, and those of shared.txt, are at hand.
Files that a case makes are gone in the next one; pictures and maps are checked in each. A line that
ends in a backslash goes on. Lines that begin with # are comments.
"""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

import case_texts
import expectations


class Folder:
    """A folder for the cases of a text, with the files that the text has and makes."""

    def __init__(self, path, program, data):
        self.path = path
        self.environment = dict(os.environ, data=str(data),
                                ships=str(data / "ships_us_2022-01-03.csv"),
                                PATH=f"{program.parent}:{os.environ['PATH']}")

    def fill(self, text):
        for file in text.path.parent.iterdir():
            shutil.copy(file, self.path)
        for name, content, command in text.files:
            (self.path / name).write_bytes(content)
            if command:
                with open(self.path / name, "ab") as out:
                    self.bash(command, check=True, stdout=out)
        for name in ("out", "err"):
            (self.path / name).touch()

    def bash(self, command, **options):
        return subprocess.run(["bash", "-c", command], cwd=self.path, env=self.environment,
                              stdin=subprocess.DEVNULL, timeout=300, **{"check": False, **options})

    def names(self):
        return {file.name for file in self.path.iterdir()}

    def faults(self, command, expected):
        """Runs a command, and yields a sentence for each expectation that is not met."""
        before = self.names()
        with open(self.path / "out", "wb") as out, open(self.path / "err", "wb") as err:
            status = self.bash(command, stdout=out, stderr=err).returncode
        run = expectations.Run(self, status, self.names() - before)
        yield from run.faults(expected)
        for name in self.names() - before:
            made = self.path / name
            shutil.rmtree(made) if made.is_dir() else made.unlink()


def check(text, program, data):
    """Runs the cases of a text, and returns how many commands there were, and how many failed."""
    count = failed = 0
    with tempfile.TemporaryDirectory() as path:
        folder = Folder(pathlib.Path(path), program, data)
        folder.fill(text)
        for case in text.cases:
            if case.condition and folder.bash(case.condition, capture_output=True).returncode:
                continue
            for line, command in case.commands():
                found = list(folder.faults(command, case.expected))
                count += 1
                failed += bool(found)
                for fault in found:
                    print(f"FAILED  {text.path}:{line}: {fault}")
    return count, failed


def main():
    program, data, *paths = [pathlib.Path(argument).resolve() for argument in sys.argv[1:]]
    counts = [check(case_texts.Text(path), program, data) for path in paths]
    count, failed = map(sum, zip(*counts))
    print(f"{count - failed} passed, {failed} failed")
    return 1 if failed or not count else 0


if __name__ == "__main__":
    sys.exit(main())
