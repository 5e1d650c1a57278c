#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Who may include whom: the dependency rule of docs/dev/architecture.md, as a test.

Run by CTest as core/layering_test; the environment tells where things are:
AMECO_SOURCE_DIR        the repository
AMECO_CORE_INCLUDES     include path of the target ameco_core, ';' between folders
"""

import os
import re
import unittest
from pathlib import Path

SOURCE = Path(os.environ["AMECO_SOURCE_DIR"])

# Each folder of core may include itself and these. The chain, then the branches.
CHAIN = ["base", "geometry", "mesh", "metric", "remesh", "adapt", "coarsen", "hierarchy", "multigrid"]
MAY_INCLUDE = {folder: set(CHAIN[:i]) for i, folder in enumerate(CHAIN)}
MAY_INCLUDE["io"] = {"base", "geometry", "mesh", "metric"}
MAY_INCLUDE["cases"] = {"base", "geometry", "mesh", "metric", "surface", "recovery"}
MAY_INCLUDE["surface"] = {"base", "geometry", "mesh"}
MAY_INCLUDE["recovery"] = {"base", "geometry", "mesh", "surface"}
# A level can be made anew from its surface.
MAY_INCLUDE["coarsen"] |= {"surface", "recovery"}
# A hierarchy is a folder of files.
MAY_INCLUDE["hierarchy"].add("io")
MAY_INCLUDE["multigrid"].add("io")
# A report is about a hierarchy and what multigrid does on it; nobody in core needs it.
MAY_INCLUDE["report"] = set(CHAIN) | {"io"}

# The parts of the program: core knows nobody, the window knows core, the program knows both.
PARTS = {"core": {"core"}, "gui": {"core", "gui"}, "app": {"core", "gui", "app"}}

OWN = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)
FOREIGN = re.compile(r"^\s*#\s*include\s*<([^>]+)>", re.MULTILINE)
# VTK's file modules need no window; these files are the only ones to see them.
VTK_FILES = {f"vtk_{name}" for name in ("messages.h", "messages.cpp", "read.cpp", "write.cpp")}
WINDOW_SYSTEM = re.compile(r"^(Q[A-Z]|Qt|q[a-z]+\.h$|vtk)")
WINDOW_SYSTEM_FOLDER = re.compile(r"^(qt|vtk)[-.\d]*", re.IGNORECASE)


def complaints(path, text):
    """What is wrong with the includes of one file; `path` is relative to the repository."""
    part, folder = path.parts[0], path.parts[1]
    found = []
    for include in OWN.findall(text):
        target = Path(include).parts
        if len(target) < 2 or target[0] not in PARTS:
            found.append(f'{path}: "{include}" is no address from the root of the repository')
        elif target[0] not in PARTS[part]:
            found.append(f'{path}: {part} must not know {target[0]} ("{include}")')
        elif part == "core" and folder not in MAY_INCLUDE:
            found.append(f"{path}: {folder} has no place in the order of docs/dev/architecture.md")
        elif part == "core" and target[1] != folder and target[1] not in MAY_INCLUDE[folder]:
            found.append(f'{path}: {folder} must not know {target[1]} ("{include}")')
    if part == "core":
        for include in FOREIGN.findall(text):
            own_vtk = folder == "io" and path.name in VTK_FILES and include.startswith("vtk")
            if WINDOW_SYSTEM.match(include) and not own_vtk:
                found.append(f"{path}: core builds without a window system (<{include}>)")
    return found


class LayeringTest(unittest.TestCase):
    def sources(self):
        for part in PARTS:
            for path in sorted((SOURCE / part).rglob("*")):
                if path.suffix in (".h", ".cpp"):
                    yield path.relative_to(SOURCE), path.read_text(encoding="utf-8")

    def test_includes_follow_the_dependency_rule(self):
        found = []
        count = 0
        for path, text in self.sources():
            found += complaints(path, text)
            count += 1
        self.assertGreater(count, 50, "the sources were not found")
        self.assertEqual(found, [])

    def test_own_includes_exist(self):
        missing = [
            f"{path}: {include}"
            for path, text in self.sources()
            for include in OWN.findall(text)
            if not (SOURCE / include).is_file()
        ]
        self.assertEqual(missing, [])

    def test_core_has_no_window_system_on_its_include_path(self):
        folders = [f for f in os.environ["AMECO_CORE_INCLUDES"].split(";") if f]
        self.assertNotEqual(folders, [])
        for folder in folders:
            if Path(folder) == SOURCE:
                continue
            for component in Path(folder).parts:
                self.assertIsNone(WINDOW_SYSTEM_FOLDER.match(component), folder)

    def test_wrong_includes_are_seen(self):
        mesh = Path("core/mesh/check.cpp")
        for text in (
            '#include "core/metric/metric.h"',
            '  # include "app/cli/command.h"',
            '#include "gui/main_window.h"',
            '#include "check.h"',
            "#include <QString>",
            "#include <QtCore/qglobal.h>",
            "#include <vtkPoints.h>",
        ):
            self.assertEqual(len(complaints(mesh, text)), 1, text)
        self.assertEqual(len(complaints(Path("core/new/x.h"), '#include "core/base/id.h"')), 1)
        self.assertEqual(len(complaints(Path("gui/x.h"), '#include "app/cli/command.h"')), 1)

    def test_right_includes_pass(self):
        mesh = Path("core/mesh/check.cpp")
        text = '#include "core/mesh/check.h"\n#include "core/base/id.h"\n#include <vector>\n'
        self.assertEqual(complaints(mesh, text), [])
        self.assertEqual(complaints(Path("gui/x.h"), "#include <QWidget>"), [])


if __name__ == "__main__":
    unittest.main()
