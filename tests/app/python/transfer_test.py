# SPDX-License-Identifier: AGPL-3.0-or-later
import unittest

import numpy as np
import scipy.sparse
from two_grid import contraction, inner, stiffness

import ameco


class TransferTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.levels = ameco.hierarchy(ameco.case("onera-m6", preset="m6-8k"), 2)

    def test_is_a_sparse_matrix_from_coarse_to_fine(self):
        for k in range(2):
            P = self.levels.transfer(k)
            self.assertTrue(scipy.sparse.isspmatrix_csr(P))
            fine, coarse = self.levels[k].mesh, self.levels[k + 1].mesh
            self.assertEqual(P.shape, (len(fine.nodes), len(coarse.nodes)))
            np.testing.assert_allclose(P.sum(axis=1), 1, atol=1e-12)
            self.assertTrue(((P.data >= 0) & (P.data <= 1)).all())

    def test_injects_at_common_nodes(self):
        P = self.levels.transfer(0)
        parent = self.levels[1].parent
        picked = P[parent]
        self.assertEqual((picked != scipy.sparse.identity(len(parent))).nnz, 0)

    def test_interpolates_linear_functions(self):
        fine = ameco.case("layer", nx=8, ny=8, nz=16)
        level = ameco.coarsen(fine)
        P = ameco.transfer(fine, level)
        np.testing.assert_allclose(P @ level.mesh.nodes, fine.nodes, atol=1e-12)

    def test_meshes_do_as_well_as_levels(self):
        by_levels = self.levels.transfer(0)
        by_meshes = ameco.transfer(self.levels[0].mesh, self.levels[1].mesh)
        self.assertEqual((by_levels != by_meshes).nnz, 0)

    def test_the_matrix_outlives_the_levels(self):
        P = ameco.hierarchy(ameco.case("cube"), 1).transfer(0)
        np.testing.assert_allclose(P.sum(axis=1), 1, atol=1e-12)

    def test_meshes_of_other_dimensions_are_refused(self):
        with self.assertRaisesRegex(ameco.UsageError, "dimension"):
            ameco.transfer(ameco.case("cube"), ameco.case("model-layer"))

    def test_there_is_none_beyond_the_coarsest_level(self):
        with self.assertRaises(IndexError):
            self.levels.transfer(2)


class TwoGridTest(unittest.TestCase):
    def test_converges_on_a_layer_by_theorys_factor_where_jacobi_does_not(self):
        # Semi-coarsening by 2 with damped Jacobi: 1/9 in theory, whatever the aspect ratio.
        for aspect_ratio in (1e2, 1e6):
            fine = ameco.case("layer", nx=8, ny=8, nz=32, growth=1, aspect_ratio=aspect_ratio)
            level = ameco.coarsen(fine)
            f, c = inner(fine), inner(level.mesh)
            P = ameco.transfer(fine, level)[f][:, c]
            A = stiffness(fine)[f][:, f]
            self.assertGreater(contraction(A), 0.9)
            self.assertAlmostEqual(contraction(A, P), 1 / 9, delta=0.02)


if __name__ == "__main__":
    unittest.main()
