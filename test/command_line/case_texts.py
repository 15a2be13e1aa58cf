# Copyright (c) 2026 The Thick_intersection_d authors.
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Reads texts of cases; check_cases.py tells how they are written."""

import re
import sys

FORMS = (r"(?P<word>pairs|says|error|hint|status|as|by|if): ?(?P<text>.*)",
         r"(?P<word>is|rows|has|matches|lacks) (?P<subject>\S+): ?(?P<text>.*)",
         r"(?P<subject>[a-z][a-z ]*) (?P<word>=) (?P<text>.*)")
OUTPUTS = "--(pairs|picture|points|coordinates|memory)"  # or what would need one


def unescaped(text):
    """Returns the bytes of a text with escapes."""
    return text.encode("utf-8").decode("unicode_escape").encode("latin-1")


def lines_of(path):
    """Yields the lines that say something with their numbers; those that go on are joined."""
    begun = ""
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        line = begun + (line.lstrip() if begun else line)
        begun = line[:-1] if line.endswith("\\") else ""
        if line and line[0] != "#" and not begun:
            yield number, line


class Case:
    """Commands, and what is expected of each of them."""

    def __init__(self):
        self.lines = []  # a number, "$" or "!", and the rest of the line
        self.expected = []  # a word, its subject or None, and a text
        self.condition = None

    def expect(self, word, subject, text):
        if word == "if":
            self.condition = text
        else:
            self.expected.append((word, subject, text))

    def commands(self):
        """Yields the number of each line, and a command of bash. A line of arguments alone also gets
        the outputs that the expectations look at."""
        words = {word for word, _, _ in self.expected}
        for number, kind, text in self.lines:
            outputs = ""
            if words & {"pairs", "as", "by"} and "--pairs" not in text:
                outputs = "--pairs pairs.csv"
            if "error" in words and not re.search(OUTPUTS, text):
                outputs = "--pairs none.csv --picture none.svg"
            yield number, text if kind == "!" else f"exec near_pairs {outputs} {text}"


class Text:
    """The cases of a text, and the files that it makes."""

    def __init__(self, path):
        self.path = path
        self.cases = []
        self.files = []  # a name, bytes, and a command of bash that prints more, or None
        for file in (path.parent.parent / "shared.txt", path):
            for number, line in lines_of(file):
                if not self.reads(number, line):
                    sys.exit(f"{file}:{number}: neither a case nor what is expected: {line}")
        for case in self.cases:
            if not case.expected:
                sys.exit(f"{path}:{case.lines[0][0]}: nothing is expected")

    def reads(self, number, line):
        if line[:2] in ("$ ", "! "):
            if not self.cases or self.cases[-1].expected:
                self.cases.append(Case())
            self.cases[-1].lines.append((number, line[0], line[2:]))
        elif line[:2] == "| ":
            name, content, command = self.files.pop()
            self.files.append((name, content + line[2:].encode("utf-8") + b"\n", command))
        elif match := re.fullmatch(r"(file|make) (.+?): ?(.*)", line):
            kind, name, text = match.groups()
            self.files.append((name, *((unescaped(text), None) if kind == "file" else (b"", text))))
        else:
            match = next(filter(None, (re.fullmatch(form, line) for form in FORMS)), None)
            if match and self.cases:
                found = match.groupdict()
                self.cases[-1].expect(found["word"], found.get("subject"), found["text"])
            return match and self.cases
        return True
