# SPDX-License-Identifier: AGPL-3.0-or-later
"""Links, anchors, pictures and paths in the documentation lead somewhere. Uses no network."""

import os
import re
import unittest
from pathlib import Path
from urllib.parse import unquote

SOURCE = Path(os.environ["AMECO_SOURCE_DIR"])
FENCE = re.compile(r"^(```|~~~).*?^\1[ \t]*$", re.DOTALL | re.MULTILINE)
CODE = re.compile(r"`[^`\n]+`")
LINK = re.compile(r"!?\[(?:[^\[\]]|\[[^\]]*\])*\]\(\s*<?([^)\s>]+)>?(?:\s+\"[^\"]*\")?\s*\)")
ATTRIBUTE = re.compile(r"<(?:img|a|source)\b[^>]*?\b(?:src|href|srcset)=\"([^\"]+)\"")
PATH = re.compile(r"`((?:app|cmake|core|docs|gui|resources|sample_meshes|scripts|tests)/[\w./+-]*)`")


def pages():
    """All pages but those below folders that are built, or hidden."""
    for page in sorted(SOURCE.rglob("*.md")):
        first = page.relative_to(SOURCE).parts[0]
        if not first.startswith((".", "build", "demo-out", "reproduce-out")):
            yield page


def anchors(text):
    """The anchors of a page's headings, as GitHub makes them."""
    found, times = set(), {}
    for heading in re.findall(r"^#{1,6}\s+(.+?)\s*#*$", FENCE.sub("", text), re.MULTILINE):
        heading = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading)
        anchor = re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")
        n = times.get(anchor, 0)
        times[anchor] = n + 1
        found.add(f"{anchor}-{n}" if n else anchor)
    found.update(re.findall(r"<a\b[^>]*\b(?:id|name)=\"([^\"]+)\"", text))
    return found


class LinksTest(unittest.TestCase):
    def test_there_are_pages(self):
        self.assertGreater(len(list(pages())), 15)

    def test_links_and_pictures_lead_somewhere(self):
        for page in pages():
            text = CODE.sub("", FENCE.sub("", page.read_text()))
            for target in LINK.findall(text) + ATTRIBUTE.findall(text):
                if re.match(r"[a-z][a-z0-9+.-]*:", target):
                    continue
                with self.subTest(page=str(page.relative_to(SOURCE)), link=target):
                    path, _, anchor = unquote(target).partition("#")
                    other = (page.parent / path).resolve() if path else page
                    self.assertFalse(path.startswith("/"), "not relative")
                    self.assertTrue(other.is_relative_to(SOURCE), "leads out of the repository")
                    self.assertTrue(other.exists(), "is not there")
                    if anchor:
                        self.assertIn(anchor, anchors(other.read_text()))

    def test_paths_of_the_repository_exist(self):
        for page in pages():
            for path in PATH.findall(page.read_text()):
                with self.subTest(page=str(page.relative_to(SOURCE)), path=path):
                    # Tests are named as CTest does, without the suffix and the first folder.
                    places = [SOURCE / path, SOURCE / "tests" / path]
                    found = any(p.exists() or any(p.parent.glob(p.name + ".*")) for p in places)
                    self.assertTrue(found, "is not there")

    def test_every_page_is_reached_from_the_index(self):
        index = SOURCE / "docs/README.md"
        reached, waiting = {index}, [index]
        while waiting:
            page = waiting.pop()
            text = FENCE.sub("", page.read_text())
            for target in LINK.findall(text):
                other = (page.parent / unquote(target).partition("#")[0]).resolve()
                if other.suffix == ".md" and other.exists() and other not in reached:
                    reached.add(other)
                    waiting.append(other)
        lost = [str(p.relative_to(SOURCE)) for p in pages() if p.resolve() not in reached]
        self.assertEqual(lost, [])


if __name__ == "__main__":
    unittest.main()
