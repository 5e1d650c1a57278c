# SPDX-License-Identifier: AGPL-3.0-or-later
"""docs/theory/README.md: each idea names a function that its header declares. And the other way round:
pages and sections that the sources refer to are there."""

import os
import re
import unittest
from pathlib import Path

SOURCE = Path(os.environ["AMECO_SOURCE_DIR"])


class IdeasTest(unittest.TestCase):
    def test_functions_are_where_they_are_said_to_be(self):
        page = (SOURCE / "docs/theory/README.md").read_text()
        places = re.findall(r"\| `(core/[^`]+\.h)`: `(\w+)` \|", page)
        self.assertGreater(len(places), 30)
        for header, name in places:
            with self.subTest(header=header, name=name):
                text = re.sub(r"//[^\n]*", "", (SOURCE / header).read_text())
                self.assertRegex(text, rf"\b{name}\b")

    def test_every_idea_has_a_function_and_a_page(self):
        page = (SOURCE / "docs/theory/README.md").read_text()
        ideas = [line for line in page.split("\n## Metrics\n")[1].split("\n") if line.startswith("| ")]
        for line in ideas:
            if not line.startswith("| idea |"):
                self.assertRegex(line, r"`core/[^`]+\.h`: `\w+` \| \[[^\]]+\]\([a-z_]+\.md")

    def test_pages_that_sources_refer_to_are_there(self):
        pattern = re.compile(r"(docs/\w+/\w+\.md)(?:,\s*(?:///\s*)?\"([^\"]+)\")?")
        found = 0
        for folder in ("app", "core", "gui"):
            for file in sorted((SOURCE / folder).rglob("*")):
                if file.suffix not in (".h", ".cpp", ".py"):
                    continue
                for page, section in pattern.findall(file.read_text()):
                    found += 1
                    with self.subTest(file=str(file.relative_to(SOURCE)), page=page):
                        self.assertTrue((SOURCE / page).exists(), "is not there")
                        if section:
                            self.assertIn(f"# {section}\n", (SOURCE / page).read_text())
        self.assertGreater(found, 10)


if __name__ == "__main__":
    unittest.main()
