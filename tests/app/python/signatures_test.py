# SPDX-License-Identifier: AGPL-3.0-or-later
"""Names, signatures and types: of the module, of its stub, and of the command line."""

import ast
import inspect
import os
import re
import subprocess
import sys
import unittest
from pathlib import Path

import ameco
from ameco import _core

SOURCE = Path(os.environ["AMECO_SOURCE_DIR"])
PACKAGE = SOURCE / "app/python/ameco"
PROGRAM = os.environ["AMECO_PROGRAM"]


def stub_names(tree):
    """Public names of the stub, those of classes with their members: "Mesh.nodes"."""
    for node in tree.body:
        if isinstance(node, ast.AnnAssign):
            yield node.target.id
        elif isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            yield node.name
            for member in getattr(node, "body", ()) if isinstance(node, ast.ClassDef) else ():
                if isinstance(member, ast.FunctionDef) and not member.name.startswith("__"):
                    yield f"{node.name}.{member.name}"


def module_names():
    for name, value in vars(_core).items():
        if name.startswith("__"):
            continue
        yield name
        if inspect.isclass(value) and not issubclass(value, Exception):
            yield from (f"{name}.{m}" for m in vars(value) if not m.startswith("_"))


class StubTest(unittest.TestCase):
    def test_has_the_names_of_the_module(self):
        stub = ast.parse((PACKAGE / "_core.pyi").read_text())
        self.assertEqual(sorted(stub_names(stub)), sorted(module_names()))

    def test_functions_take_as_many_arguments_as_in_the_module(self):
        stub = ast.parse((PACKAGE / "_core.pyi").read_text())
        for node in stub.body:
            if isinstance(node, ast.FunctionDef):
                # pybind11 writes "name(arg0: T, arg1: U) -> V" into the docstring.
                signature = re.match(r"\w+\((.*)\) ->", getattr(_core, node.name).__doc__)
                taken = len(re.findall(r"\barg\d+:", signature[1]))
                self.assertEqual(len(node.args.args), taken, node.name)

    def test_every_public_name_is_there_and_explained(self):
        for name in ameco.__all__:
            self.assertTrue(hasattr(ameco, name), name)
        stub = ast.parse((PACKAGE / "_core.pyi").read_text())
        explained = {n.name for n in stub.body if hasattr(n, "name") and ast.get_docstring(n)}
        for name in ameco.__all__:
            doc = getattr(ameco, name).__doc__ or ""
            self.assertTrue(name in explained or len(doc) > 20 or name == "threads", name)

    def test_types_fit_strictly(self):
        try:
            import mypy.api
        except ImportError:
            self.skipTest("mypy is missing (Debian: python3-mypy)")
        example = Path(__file__).with_name("typed_example.py")
        out, err, code = mypy.api.run(
            ["--strict", "--no-incremental", "--cache-dir=" + os.devnull, str(PACKAGE), str(example)]
        )
        self.assertEqual(code, 0, out + err)


class DefaultsTest(unittest.TestCase):
    def test_are_those_of_the_command_line(self):
        table = ameco.settings()
        for function in (
            ameco.hierarchy,
            ameco.coarsen,
            ameco.remesh,
            ameco.target_metric,
            ameco.natural_metric,
        ):
            for name, parameter in inspect.signature(function).parameters.items():
                if name in table:
                    where = f"{function.__name__}: {name}"
                    self.assertEqual(parameter.default, table[name]["default"], where)
        self.assertEqual(
            set(table) - set(inspect.signature(ameco.hierarchy).parameters), set()
        )

    def test_are_those_that_the_help_tells(self):
        self.assertEqual(self.compared("coarsen", ameco.hierarchy), 13)
        # Of no quality, and of no size, the help does not tell.
        self.assertEqual(self.compared("remesh", ameco.remesh, leave_out={"quality"}), 5)
        self.assertEqual(self.compared("fill", ameco.fill), 3)

    def compared(self, command, function, leave_out=frozenset()):
        """Compares defaults of a function with those in the help of a command; returns how many."""
        run = subprocess.run([PROGRAM, command, "--help"], capture_output=True, text=True)
        blocks = re.split(r"^  (?:-\w, |    )--(?=[a-z])", run.stdout, flags=re.MULTILINE)[1:]
        defaults = {}
        for block in blocks:
            text = " ".join(block.split("\n\n")[0].split())
            if match := re.match(r"([a-z-]+) .*\[(.*)\]$", text):
                defaults[match[1].replace("-", "_")] = match[2]
        compared = 0
        for name, parameter in inspect.signature(function).parameters.items():
            if name in defaults and name not in leave_out | {"progress"}:
                default = "off" if parameter.default is None else str(parameter.default)
                self.assertEqual(defaults[name], re.sub(r"\.0$", "", default), name)
                compared += 1
        return compared


if __name__ == "__main__":
    unittest.main()
