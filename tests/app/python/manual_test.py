# SPDX-License-Identifier: AGPL-3.0-or-later
"""Runs the sessions in docs/user/python.md. What they print must be what stands there, but for the
numbers; AMECO_UPDATE_DOCS=1 writes the page anew."""

import contextlib
import doctest
import io
import os
import re
import tempfile
import unittest
from pathlib import Path

import ameco

PAGE = Path(os.environ["AMECO_SOURCE_DIR"]) / "docs/user/python.md"
BLOCK = re.compile(r"(?<=^```pycon\n).*?(?=^```$)", re.DOTALL | re.MULTILINE)


def words(text):
    """Words of a text, without numbers and layout."""
    return re.sub(r"[0-9][0-9.,e+-]*", "0", text).split()


def session(block, names):
    """A block with what its statements print now."""
    text = ""
    for example in doctest.DocTestParser().get_examples(block):
        lines = example.source.rstrip("\n").split("\n")
        text += "".join(
            (">>> " if i == 0 else "... ") + line + "\n" for i, line in enumerate(lines)
        )
        out = io.StringIO()
        with contextlib.redirect_stdout(out):
            exec(compile(example.source, str(PAGE), "single"), names)
        text += out.getvalue()
    return text


class ManualTest(unittest.TestCase):
    def test_prints_what_python_prints(self):
        page = PAGE.read_text()
        names = {}
        here = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            try:
                ameco.case("onera-m6", preset="m6-8k").write("wing.meshb")
                new = BLOCK.sub(lambda match: session(match[0], names), page)
            finally:
                os.chdir(here)
        if "AMECO_UPDATE_DOCS" in os.environ:
            PAGE.write_text(new)
        self.assertEqual(words(new), words(PAGE.read_text()))


if __name__ == "__main__":
    unittest.main()
