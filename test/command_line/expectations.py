# Copyright (c) 2026 The Thick_intersection_d authors.
# SPDX-License-Identifier: LGPL-3.0-or-later
"""What may be expected of a run of near_pairs; check_cases.py tells what each word means."""

import re

import case_texts
import checks

METHODS = {"=": "has_line", "is": "equals", "as": "finds_as", "by": "is_right_by"}


def positions(row):
    return tuple(map(int, row.split(",")[:2]))


class Run:
    """What a command has left in a folder."""

    def __init__(self, folder, status, new_files):
        self.folder = folder
        self.exit_status = status
        self.new_files = new_files
        self.out, self.err = self.text("out"), self.text("err")

    def text(self, name):
        return self.bytes_of(name).decode("utf-8", "replace")

    def bytes_of(self, name):
        return (self.folder.path / name).read_bytes()

    def faults(self, expected):
        """Yields a sentence for each expectation that is not met."""
        if "built without TBB" in self.err:
            expected = [("error", None, "--parallel")]
        words = {word: text for word, _, text in expected}
        wanted_status = 2 if "error" in words else int(words.get("status", 0))
        if self.exit_status != wanted_status:
            yield f"status {self.exit_status}: {self.out[:2000]}{self.err[:2000]}"
            return
        left = [name for name in self.new_files if wanted_status or ".part" in name]
        if left:
            yield f"leaves {left}"
        for name in sorted(self.new_files):
            yield from checks.faults_of_file(self.folder.path / name)
        for word, subject, text in expected:
            if not self.meets(METHODS.get(word, word), subject, text):
                yield f"{subject or ''} {word} {text[:200]}\n{self.out[:2000]}{self.err[:2000]}"

    def meets(self, method, subject, text):
        test = getattr(self, method)
        try:
            return test(text) if subject is None else test(subject, text)
        except OSError:  # a file is missing
            return False

    def has_line(self, name, value):
        """The summary is on stderr if pairs are printed."""
        return re.search(f"^{name} +{re.escape(value)} *$", self.out + self.err, re.M)

    def pairs(self, text):
        return self.found_pairs() == sorted(positions(pair) for pair in text.split())

    def found_pairs(self):
        """Returns the pairs of the file that near_pairs wrote, in ascending order."""
        return sorted(positions(row) for row in self.text("pairs.csv").splitlines()[1:])

    def finds_as(self, arguments):
        found = self.found_pairs()
        self.folder.bash(f"near_pairs --pairs pairs.csv {arguments}", check=True,
                         capture_output=True)
        return found == self.found_pairs()

    def is_right_by(self, text):
        name, *words = text.split()
        return getattr(checks, name)(self, *words)

    def says(self, words):
        return words in self.out + self.err

    def error(self, words):
        return not self.out and self.is_one_line("near_pairs: ") and words in self.err

    def hint(self, words):
        return self.is_one_line("near_pairs: hint: ") and words in self.err

    def is_one_line(self, beginning):
        return self.err.startswith(beginning) and self.err.count("\n") == 1

    def status(self, _):
        return True

    def equals(self, name, text):
        return self.bytes_of(name) == case_texts.unescaped(text)

    def rows(self, name, text):
        found, wanted = self.bytes_of(name), case_texts.unescaped(text)
        return sorted(found.splitlines()) == sorted(wanted.splitlines())

    def has(self, name, words):
        return words in self.text(name)

    def matches(self, name, regex):
        return re.search(regex, self.text(name), re.M)

    def lacks(self, name, regex):
        return not re.search(regex, self.text(name), re.M)
