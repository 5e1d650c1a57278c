# SPDX-License-Identifier: AGPL-3.0-or-later
"""docs/user/troubleshooting.md treats every exit code, kind of error, defect and verdict there is, and
quotes messages as the program has them."""

import os
import re
import unittest
from pathlib import Path

SOURCE = Path(os.environ["AMECO_SOURCE_DIR"])
PAGE = (SOURCE / "docs/user/troubleshooting.md").read_text()


def rows(heading):
    """The tables below a heading, as lists of cells."""
    text = PAGE.split(f"\n## {heading}\n")[1].split("\n## ")[0]
    lines = [line for line in text.split("\n") if line.startswith("| ")]
    return [[cell.strip() for cell in line.strip("|").split(" | ")] for line in lines[1:]]


def names_of(file, function):
    """The words in the table of names that a function of the sources has."""
    text = (SOURCE / file).read_text()
    return re.findall(r'"([^"]+)"', text.split(function)[1].split("};")[0])


def literals():
    """All string literals of the program, those that follow each other joined."""
    text = ""
    for folder in ("core", "app", "gui"):
        for file in sorted((SOURCE / folder).rglob("*.cpp")):
            text += re.sub(r'"\s*\n\s*"', "", file.read_text()) + "\n"
    return " ".join(re.findall(r'"((?:[^"\\\n]|\\.)*)"', text))


class TroubleshootingTest(unittest.TestCase):
    def test_treats_every_exit_code(self):
        header = (SOURCE / "core/base/error.h").read_text()
        enum = header.split("enum class ExitCode")[1].split("};")[0]
        codes = re.findall(r"^\s*\w+ = (\d+),?", enum, re.MULTILINE)
        self.assertEqual([row[0] for row in rows("By exit code")], codes)
        self.assertGreater(len(codes), 8)

    def test_treats_every_error_by_its_code(self):
        header = (SOURCE / "core/base/error.h").read_text()
        numbers = dict(re.findall(r"^\s*(\w+) = (\d+),?", header, re.MULTILINE))
        errors = re.findall(r"class (\w+) : public Error \{.*?ExitCode::(\w+)", header, re.DOTALL)
        expected = {name: numbers[code] for name, code in errors}
        found = {}
        for row in rows("By exit code"):
            for name in re.findall(r"`([A-Z]\w+)`", row[1]):
                found[name] = row[0]
        self.assertEqual(found, expected)
        self.assertEqual(len(errors), header.count(": public Error"))

    def test_treats_every_defect(self):
        names = names_of("core/mesh/check.cpp", "name(Defect")
        self.assertEqual([row[0] for row in rows("Meshes that are not valid")], names)

    def test_treats_every_verdict(self):
        names = names_of("core/remesh/verdict.cpp", "name(Verdict")
        self.assertEqual([row[0] for row in rows("Less is removed than wanted")], names)

    def test_quotes_messages_as_they_are(self):
        said = literals()
        messages = [row[0] for row in rows("By message") + rows("Pictures and the window")]
        self.assertGreater(len(messages), 15)
        for message in messages:
            for part in message.strip("`").split("…"):
                with self.subTest(message=message, part=part):
                    self.assertTrue(part.strip(" ()") in said, "no message says so")


if __name__ == "__main__":
    unittest.main()
