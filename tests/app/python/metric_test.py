# SPDX-License-Identifier: AGPL-3.0-or-later
import tempfile
import unittest
from pathlib import Path

import numpy as np

import ameco


def tensors_from_frames(metric):
    """M = V diag(h)^-2 V^T, upper triangles by rows."""
    V, h = metric.directions, metric.sizes
    M = np.einsum("nik,nk,njk->nij", V, h**-2.0, V)
    i, j = np.triu_indices(h.shape[1])
    return M[:, i, j]


class MetricTest(unittest.TestCase):
    def test_has_one_tensor_per_node(self):
        for d, case in ((2, "model-layer"), (3, "layer")):
            mesh = ameco.case(case)
            metric = ameco.natural_metric(mesh)
            n = len(mesh.nodes)
            self.assertEqual(len(metric), n)
            self.assertEqual(metric.sizes.shape, (n, d))
            self.assertEqual(metric.directions.shape, (n, d, d))
            self.assertEqual(metric.tensors.shape, (n, d * (d + 1) // 2))
            self.assertTrue((np.diff(metric.sizes, axis=1) >= 0).all())
            np.testing.assert_allclose(
                metric.aspect_ratio, metric.sizes[:, -1] / metric.sizes[:, 0]
            )

    def test_tensors_are_those_of_sizes_and_directions(self):
        for case in ("model-layer", "layer"):
            metric = ameco.natural_metric(ameco.case(case))
            expected = tensors_from_frames(metric)
            scale = np.abs(expected).max(axis=1, keepdims=True)
            self.assertLess((np.abs(metric.tensors - expected) / scale).max(), 1e-12)

    def test_natural_metric_of_a_layer_is_its_sizes(self):
        mesh = ameco.case("layer", nx=6, ny=6, nz=8, growth=1, displace=0)
        metric = ameco.natural_metric(mesh, mean="corrected")
        self.assertGreater(metric.aspect_ratio.min(), 1e3)
        # The shortest direction is across the layers, along z.
        np.testing.assert_allclose(np.abs(metric.directions[:, 2, 0]), 1, atol=1e-6)

    def test_target_metric_doubles_the_smallest_size_in_layers(self):
        mesh = ameco.case("layer", nx=6, ny=6, nz=8, growth=1)
        natural = ameco.natural_metric(mesh)
        target = ameco.target_metric(mesh, natural)
        np.testing.assert_allclose(target.sizes[:, 0] / natural.sizes[:, 0], 2)
        np.testing.assert_array_equal(target.tensors, ameco.target_metric(mesh).tensors)
        thrice = ameco.target_metric(mesh, natural, factor=3)
        np.testing.assert_allclose(thrice.sizes[:, 0] / natural.sizes[:, 0], 3)
        self.assertLess(ameco.complexity(mesh, target), ameco.complexity(mesh, natural))

    def test_is_read_as_it_was_written(self):
        metric = ameco.natural_metric(ameco.case("cube"))
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "a.solb"
            metric.write(path)
            again = ameco.read_metric(path)
        np.testing.assert_allclose(again.tensors, metric.tensors, rtol=1e-12)
        np.testing.assert_allclose(ameco.MetricField(metric.tensors).sizes, metric.sizes, rtol=1e-9)

    def test_refuses_what_is_no_metric(self):
        with self.assertRaisesRegex(ameco.InputError, "tensor 1 is not positive definite"):
            ameco.MetricField([[1.0, 0, 1], [1, 2, 1]])
        with self.assertRaisesRegex(ameco.UsageError, "shape"):
            ameco.MetricField([[1.0, 0, 1, 2]])
        mesh = ameco.case("cube")
        with self.assertRaisesRegex(ameco.UsageError, "dimension"):
            ameco.conformity(mesh, ameco.MetricField([[1.0, 0, 1]]))
        with self.assertRaisesRegex(ameco.UsageError, "1 tensors for a mesh of"):
            ameco.conformity(mesh, ameco.MetricField([[1.0, 0, 0, 1, 0, 1]]))

    def test_a_mesh_conforms_to_its_natural_metric(self):
        mesh = ameco.case("cube")
        measured = ameco.conformity(mesh, ameco.natural_metric(mesh))
        self.assertGreater(measured["in_band"], 0.7)

    def test_wrong_names_of_means_are_refused(self):
        with self.assertRaisesRegex(ameco.UsageError, "mean: bowman is not one of corrected"):
            ameco.natural_metric(ameco.case("cube"), mean="bowman")


if __name__ == "__main__":
    unittest.main()
