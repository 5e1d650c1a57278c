# SPDX-License-Identifier: AGPL-3.0-or-later
import copy
import pickle
import tempfile
import unittest
from pathlib import Path

import numpy as np

import ameco

TET = [[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
ARRAYS = (
    "nodes elements faces patches regions labels edges edge_labels corners ridges required_nodes"
    " required_edges required_faces required_elements"
).split()


def arrays_of(mesh):
    return {name: getattr(mesh, name) for name in ARRAYS} | {"patch_names": mesh.patch_names}


class MeshTest(unittest.TestCase):
    def test_has_the_shapes_of_its_dimension(self):
        for d, case in ((2, "model-layer"), (3, "cube")):
            mesh = ameco.case(case)
            n, m, k = len(mesh.nodes), len(mesh.elements), len(mesh.faces)
            self.assertEqual(mesh.dimension, d)
            self.assertEqual((mesh.nodes.shape, mesh.nodes.dtype), ((n, d), np.float64))
            self.assertEqual((mesh.elements.shape, mesh.elements.dtype), ((m, d + 1), np.int32))
            self.assertEqual((mesh.faces.shape, mesh.regions.shape), ((k, d), (m,)))
            self.assertEqual(mesh.patches.shape, (k,))
            self.assertTrue(mesh.check().valid)

    def test_arrays_are_not_copied_and_outlive_the_mesh(self):
        mesh = ameco.case("cube")
        nodes, again = mesh.nodes, mesh.nodes
        self.assertTrue(np.shares_memory(nodes, again))
        sum_before = nodes.sum()
        del mesh, again
        self.assertEqual(nodes.sum(), sum_before)

    def test_arrays_cannot_be_written_to(self):
        mesh = ameco.case("cube")
        for array in (mesh.nodes, mesh.elements, mesh.patches):
            with self.assertRaises(ValueError):
                array[0] = 0

    def test_is_made_of_arrays_again(self):
        for case in ("onera-m6", "model-layer"):
            mesh = ameco.case(case, **({"preset": "m6-8k"} if case == "onera-m6" else {}))
            self.assertEqual(ameco.mesh(**arrays_of(mesh)), mesh)

    def test_is_the_same_after_pickle_and_copy(self):
        mesh = ameco.case("onera-m6", preset="m6-8k")
        for again in (pickle.loads(pickle.dumps(mesh)), copy.deepcopy(mesh)):
            self.assertEqual(again, mesh)
            self.assertEqual(again.patch_names, mesh.patch_names)

    def test_finds_its_boundary_when_made_of_nodes_and_elements(self):
        mesh = ameco.mesh(TET, [[0, 1, 2, 3]])
        self.assertEqual(len(mesh.faces), 4)
        self.assertTrue(mesh.check().valid)
        self.assertTrue(mesh.repairs)
        self.assertAlmostEqual(mesh.check().volume, 1 / 6)

    def test_takes_what_numpy_takes(self):
        mesh = ameco.mesh(np.array(TET, dtype=np.float32), np.array([[0, 1, 2, 3]], dtype=np.int64))
        self.assertEqual(mesh, ameco.mesh(TET, [(0, 1, 2, 3)]))
        fortran = np.asfortranarray(np.array(TET))
        self.assertEqual(ameco.mesh(fortran, [[0, 1, 2, 3]]), mesh)

    def test_refuses_arrays_that_make_no_sense(self):
        for nodes, elements, more, complaint in (
            ([0, 1, 2], [[0, 1, 2]], {}, r"nodes: .*\(n, 2\) or \(n, 3\)"),
            (TET, [[0, 1, 2]], {}, r"elements: .*\(n, 4\)"),
            (TET, [[0.0, 1, 2, 3]], {}, "elements: .*whole numbers"),
            (TET, [[0, 1, 2, 2**31]], {}, "elements: .*32 bits"),
            (TET, [[0, 1, 2, 3]], {"regions": [1, 2]}, "regions: has 2 numbers for 1 elements"),
            ([["a", "b"]], [[0, 0, 0]], {}, "nodes: .*numbers"),
        ):
            with self.assertRaisesRegex(ameco.UsageError, complaint):
                ameco.mesh(nodes, elements, **more)

    def test_names_its_defects(self):
        flat = ameco.mesh([[0.0, 0], [1, 0], [2, 0]], [[0, 1, 2]])
        report = flat.check()
        self.assertFalse(report.valid)
        self.assertIn("flat element", [finding.defect.replace("_", " ") for finding in report.errors])
        outside = ameco.mesh(TET, [[1, 2, 3, 4]]).check()
        self.assertEqual(outside.errors[0].count, 1)

    def test_that_is_not_valid_is_not_computed_with(self):
        flat = ameco.mesh([[0.0, 0], [1, 0], [2, 0]], [[0, 1, 2]])
        for compute in (ameco.natural_metric, ameco.target_metric, ameco.coarsen, ameco.hierarchy):
            with self.assertRaisesRegex(ameco.InputError, "not a valid mesh"):
                compute(flat)

    def test_drops_unused_nodes_only_when_asked_to_repair(self):
        nodes = TET + [[9.0, 9, 9]]
        self.assertEqual(len(ameco.mesh(nodes, [[0, 1, 2, 3]]).nodes), 4)
        self.assertEqual(len(ameco.mesh(nodes, [[0, 1, 2, 3]], repair=False).nodes), 5)

    def test_is_read_as_it_was_written(self):
        mesh = ameco.case("shell")
        with tempfile.TemporaryDirectory() as folder:
            for name in ("a.meshb", Path(folder) / "b.su2"):
                path = Path(folder) / name
                mesh.write(path)
                again = ameco.read(str(path))
                np.testing.assert_array_equal(again.nodes, mesh.nodes)
                np.testing.assert_array_equal(again.elements, mesh.elements)

    def test_notes_of_files_go_to_the_logger(self):
        mesh = ameco.case("onera-m6", preset="m6-8k")
        with tempfile.TemporaryDirectory() as folder:
            with self.assertLogs("ameco", "WARNING") as log:
                mesh.write(Path(folder) / "wing.stl")
            self.assertIn("wing.stl", log.output[0])

    def test_cases_take_parameters_by_keyword(self):
        self.assertEqual(len(ameco.case("layer", nx=2, ny=2, nz=3, growth=1.0).nodes), 3 * 3 * 4)
        with self.assertRaisesRegex(ameco.UsageError, "did you mean"):
            ameco.case("layer", nxx=3)
        self.assertIn("onera-m6", ameco.cases())


class ErrorTest(unittest.TestCase):
    def test_errors_have_the_exit_codes_of_the_program(self):
        codes = {
            ameco.Error: 1,
            ameco.UsageError: 2,
            ameco.CheckFailed: 3,
            ameco.NotConverged: 3,
            ameco.FileError: 4,
            ameco.InputError: 5,
            ameco.Cancelled: 130,
        }
        for error, code in codes.items():
            self.assertEqual(error.exit_code, code)
            self.assertTrue(issubclass(error, ameco.Error))

    def test_errors_are_what_python_calls_them(self):
        with self.assertRaises(OSError) as caught:
            ameco.read("/absent/wing.meshb")
        self.assertIsInstance(caught.exception, ameco.FileError)
        self.assertEqual(caught.exception.exit_code, 4)
        self.assertIn("/absent/wing.meshb", str(caught.exception))
        self.assertTrue(issubclass(ameco.InputError, ValueError))

    def test_files_that_are_no_meshes_are_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "a.meshb"
            path.write_bytes(b"nothing of that kind")
            with self.assertRaises(ameco.InputError):
                ameco.read(path)


if __name__ == "__main__":
    unittest.main()
