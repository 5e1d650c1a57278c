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


def cube():
    return ameco.case("cube", n=4, displace=0.2)


class RemeshTest(unittest.TestCase):
    def test_makes_the_mesh_that_the_program_makes(self):
        mesh = cube()
        target = ameco.target_metric(mesh)
        with tempfile.TemporaryDirectory() as folder:
            here = Path(folder)
            mesh.write(here / "cube.meshb")
            target.write(here / "target.solb")
            for given, options in (
                (["--size", "0.2"], dict(size=0.2)),
                (
                    ["--metric", "target.solb", "--node-nested", "--freeze", "1"],
                    dict(metric=ameco.read_metric(here / "target.solb"), node_nested=True, freeze=[1]),
                ),
                (
                    ["--size", "0.3", "--engine", "mtc", "--quality", "original"],
                    dict(size=0.3, engine="mtc", quality="original"),
                ),
            ):
                run = [PROGRAM, "remesh", "cube.meshb", "-o", "made.meshb", "--json", *given]
                told = subprocess.run(run, cwd=here, check=True, capture_output=True).stdout
                made = ameco.remesh(mesh, **options)
                self.assertEqual(made.mesh, ameco.read(here / "made.meshb"), given)
                expected = json.loads(told)
                for key in set(made.report) - {"seconds"}:
                    self.assertEqual(made.report[key], expected[key], key)

    def test_gives_mesh_metric_and_report(self):
        mesh = cube()
        adapted, metric, report = ameco.remesh(mesh, size=0.15)
        self.assertTrue(adapted.check().valid)
        self.assertEqual(len(metric), len(adapted.nodes))
        np.testing.assert_allclose(metric.sizes, 0.15)
        self.assertEqual(report["nodes"], len(adapted.nodes))
        self.assertGreater(report["nodes"], len(mesh.nodes))
        self.assertEqual(report["conformity"], ameco.conformity(adapted, metric))
        self.assertAlmostEqual(adapted.check().volume, 1)

    def test_takes_tensors_as_an_array(self):
        mesh = ameco.case("cube", dim=2, n=6)
        tensors = np.tile([25.0, 0, 100.0], (len(mesh.nodes), 1))
        adapted = ameco.remesh(mesh, tensors)
        self.assertEqual(adapted.mesh, ameco.remesh(mesh, ameco.MetricField(tensors)).mesh)
        self.assertGreater(adapted.report["conformity"]["in_band"], 0.8)

    def test_only_takes_nodes_away_when_asked(self):
        mesh = cube()
        nested = ameco.remesh(mesh, size=0.5, node_nested=True).mesh
        self.assertLess(len(nested.nodes), len(mesh.nodes))
        self.assertLessEqual(set(map(tuple, nested.nodes)), set(map(tuple, mesh.nodes)))

    def test_leaves_frozen_patches_alone(self):
        mesh = cube()
        frozen = ameco.remesh(mesh, size=0.6, freeze=["bottom"]).mesh
        self.assertEqual((frozen.patches == 1).sum(), (mesh.patches == 1).sum())
        self.assertLess((frozen.patches == 2).sum(), (mesh.patches == 2).sum())

    def test_refuses_what_makes_no_sense(self):
        mesh = cube()
        metric = ameco.natural_metric(mesh)
        flat = ameco.MetricField([[1.0, 0, 1]])
        for given, complaint in (
            ({}, "takes a metric or a size"),
            ({"metric": metric, "size": 1}, "takes a metric or a size"),
            ({"size": 0}, "size: 0.0 is not a number greater than 0"),
            ({"size": float("nan")}, "size: nan is not"),
            ({"metric": flat}, "another dimension"),
            ({"metric": [[1.0, 0, 0, 1, 0, 1]]}, "1 tensors for a mesh of"),
            ({"size": 1, "engine": "slow"}, "engine: slow is not one of fast, mtc"),
            ({"size": 1, "quality": "good"}, "quality: good is not one of shape, original"),
            ({"size": 1, "interpolation": "geodesic"}, "interpolation: geodesic is not one of"),
            ({"size": 1, "passes": 0}, "passes: 0 is not a whole number from 1 to 1000"),
            ({"size": 1, "passes": 1.5}, "passes: 1.5 is not"),
            ({"size": 1, "ridge_angle": 200}, "ridge_angle: 200 is not"),
            ({"size": 1, "freeze": ["top", "botom"]}, "did you mean bottom"),
            ({"size": 1, "engine": "mtc", "quality": "shape"}, "shape"),
        ):
            with self.assertRaisesRegex(ameco.UsageError, complaint, msg=str(given)):
                ameco.remesh(mesh, **given)
        with self.assertRaisesRegex(ameco.InputError, "can be numbered"):
            ameco.remesh(mesh, size=1e-6)

    def test_stops_when_asked(self):
        mesh = cube()
        steps = []
        ameco.remesh(mesh, size=0.1, progress=lambda share, step: steps.append(share))
        self.assertEqual(steps, sorted(steps))
        self.assertGreater(len(steps), 3)
        with self.assertRaises(ameco.Cancelled):
            ameco.remesh(mesh, size=0.02, progress=lambda share, step: False)
        stop = threading.Event()
        stop.set()
        with self.assertRaises(ameco.Cancelled):
            ameco.remesh(mesh, size=0.02, cancel=stop)


if __name__ == "__main__":
    unittest.main()
