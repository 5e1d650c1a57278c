# SPDX-License-Identifier: AGPL-3.0-or-later
import json
import os
import subprocess
import tempfile
import threading
import unittest
from pathlib import Path

import numpy as np

import ameco

PROGRAM = os.environ["AMECO_PROGRAM"]
SAMPLES = Path(os.environ["AMECO_SOURCE_DIR"]) / "sample_meshes"


def cube():
    """The boundary of the unit cube."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "cube.meshb"
        ameco.case("cube", n=3).write(path)
        return ameco.read_surface(path)


class SurfaceTest(unittest.TestCase):
    def test_has_faces_and_no_elements(self):
        surface = cube()
        self.assertEqual((len(surface.nodes), len(surface.faces)), (56, 108))
        self.assertEqual(len(surface.elements), 0)
        self.assertEqual(surface.patch_names[1], "bottom")
        with self.assertRaisesRegex(ameco.UsageError, "two dimensions"):
            ameco.read_surface(SAMPLES / "box_2d.mesh")


class FillTest(unittest.TestCase):
    def setUp(self):
        try:
            ameco.fill(ameco.read_surface(SAMPLES / "box.mesh"))
        except ameco.Error as error:
            if error.exit_code == 8:
                self.skipTest("built without TetGen")
            raise

    def test_makes_the_mesh_that_the_program_makes(self):
        with tempfile.TemporaryDirectory() as folder:
            here = Path(folder)
            ameco.case("cube", n=3).write(here / "cube.meshb")
            surface = ameco.read_surface(here / "cube.meshb")
            ameco.MetricField(np.tile([100.0, 0, 0, 100, 0, 900], (56, 1))).write(here / "m.solb")
            for given, options in (
                ([], {}),
                (["--size", "0.2", "--boundary", "split"], dict(size=0.2, boundary="split")),
                (
                    ["--farfield", "box:4", "--region", "0.5,0.5,0.5:7:0.2"],
                    dict(farfield="box:4", regions=[([0.5, 0.5, 0.5], 7, 0.2)]),
                ),
                (["--hole", "0.5,0.5,0.5", "--farfield", "sphere:4"], None),
                (
                    ["--metric", "m.solb", "--growth", "0.5", "--boundary", "split"],
                    dict(metric=ameco.read_metric(here / "m.solb"), growth=0.5, boundary="split"),
                ),
            ):
                if options is None:
                    options = dict(holes=[[0.5, 0.5, 0.5]], farfield="sphere:4")
                run = [PROGRAM, "fill", "cube.meshb", "-o", "made.meshb", "--json", *given]
                told = subprocess.run(run, cwd=here, check=True, capture_output=True).stdout
                made = ameco.fill(surface, **options)
                self.assertEqual(made.mesh, ameco.read(here / "made.meshb"), given)
                expected = json.loads(told)
                for key in set(made.report) - {"seconds"}:
                    self.assertEqual(made.report[key], expected[key], key)

    def test_keeps_the_faces_it_is_given(self):
        surface = cube()
        mesh, report = ameco.fill(surface)
        np.testing.assert_array_equal(mesh.nodes[:56], surface.nodes)
        np.testing.assert_array_equal(
            sorted(map(tuple, np.sort(mesh.faces, axis=1))),
            sorted(map(tuple, np.sort(surface.faces, axis=1))),
        )
        self.assertTrue(mesh.check().valid)
        self.assertEqual(report["nodes"] - report["added_nodes"], 56)

    def test_takes_the_boundary_of_a_mesh(self):
        self.assertEqual(ameco.fill(ameco.case("cube", n=3)).mesh, ameco.fill(cube()).mesh)

    def test_refuses_what_bounds_no_volume(self):
        for file in sorted((SAMPLES / "broken_surfaces").glob("*.mesh")):
            with self.assertRaises(ameco.InputError, msg=file.name):
                ameco.fill(ameco.read_surface(file))

    def test_refuses_what_makes_no_sense(self):
        surface = cube()
        for given, complaint in (
            ({"size": 0}, "size: 0 is not a number from"),
            ({"growth": 11}, "growth: 11 is not a number from 0 to 10"),
            ({"boundary": "coarsen"}, "boundary: coarsen is not one of keep, split"),
            ({"radius_edge": 1}, "radius_edge: below 1.1"),
            ({"farfield": "cube"}, "cube is neither box nor sphere"),
            ({"holes": [0, 0, 0]}, "holes: must be an array of shape"),
            ({"regions": [([0, 0, 0], 0)]}, "regions: 0 is not a number from 1"),
            ({"regions": [([0, 0], 1)]}, "regions: .*shape"),
            ({"regions": [([0, 0, 0],)]}, "regions: must be a list of"),
            ({"metric": [[1.0, 0, 0, 1, 0, 1]]}, "1 tensors for a mesh of 56"),
        ):
            with self.assertRaisesRegex(ameco.UsageError, complaint, msg=str(given)):
                ameco.fill(surface, **given)
        with self.assertRaisesRegex(ameco.UsageError, "two dimensions"):
            ameco.fill(ameco.case("cube", dim=2))

    def test_stops_when_asked(self):
        stop = threading.Event()
        stop.set()
        with self.assertRaises(ameco.Cancelled):
            ameco.fill(cube(), size=0.02, cancel=stop)


if __name__ == "__main__":
    unittest.main()
