# SPDX-License-Identifier: AGPL-3.0-or-later
import functools
import json
import os
import signal
import subprocess
import tempfile
import threading
import unittest
from pathlib import Path

import numpy as np

import ameco

PROGRAM = os.environ["AMECO_PROGRAM"]


def wing():
    return ameco.case("onera-m6", preset="m6-8k")


def small():
    return ameco.case("layer", nx=12, ny=12, nz=16)


@functools.cache
def two_levels():
    return ameco.hierarchy(wing(), 2)


def bigger_wing():
    """Takes long enough to be stopped."""
    return ameco.case("onera-m6", preset="m6-67k")


class CoarsenTest(unittest.TestCase):
    def test_makes_the_levels_that_the_program_makes(self):
        levels = two_levels()
        self.assertEqual((len(levels), levels.status), (3, "complete"))
        with tempfile.TemporaryDirectory() as here:
            wing().write(Path(here) / "wing.meshb")
            run = [PROGRAM, "coarsen", "wing.meshb", "-o", "levels", "-n", "2", "--json"]
            out = subprocess.run(run, cwd=here, check=True, capture_output=True).stdout
            for entry, level in zip(json.loads(out)["hierarchy"]["levels"], levels):
                for key in level.statistics:
                    self.assertEqual(entry[key], level.statistics[key], key)
            self.assertEqual(ameco.read(Path(here) / "levels/level_2.meshb"), levels[2].mesh)

    def test_makes_a_level_from_a_level(self):
        mesh = wing()
        levels = ameco.hierarchy(mesh, 2)
        first = ameco.coarsen(mesh)
        second = ameco.coarsen(first)
        self.assertEqual(first.mesh, levels[1].mesh)
        self.assertEqual(second.mesh, levels[2].mesh)
        self.assertEqual(second.statistics, levels[2].statistics)
        self.assertEqual(second.number, 2)

    def test_coarse_nodes_are_where_their_parents_are(self):
        mesh = wing()
        level = ameco.coarsen(mesh)
        self.assertEqual(len(level.parent), len(level.mesh.nodes))
        kept = level.parent >= 0
        np.testing.assert_array_equal(mesh.nodes[level.parent[kept]], level.mesh.nodes[kept])

    def test_reports_what_was_measured(self):
        level = ameco.coarsen(wing())
        s = level.statistics
        self.assertEqual(s["nodes"], len(level.mesh.nodes))
        self.assertAlmostEqual(s["ratio"], 8337 / s["nodes"])
        self.assertLess(abs(s["predicted_nodes"] / s["nodes"] - 1), 0.1)
        self.assertGreater(s["verdicts"]["removal"]["accepted"], 0)
        self.assertGreaterEqual(level.seconds["total"], 0)

    def test_takes_the_options_of_the_program(self):
        mesh = wing()
        frozen = ameco.coarsen(mesh, freeze=["wing"])
        wing_faces = sum(mesh.patches == 1)
        self.assertEqual(sum(frozen.mesh.patches == 1), wing_faces)
        self.assertEqual(ameco.coarsen(mesh, freeze=[1]).mesh, frozen.mesh)
        self.assertEqual(ameco.coarsen(frozen, freeze=["wing"]).number, 2)
        with self.assertRaisesRegex(ameco.UsageError, "finest mesh"):
            ameco.coarsen(frozen, freeze=["farfield"])
        with self.assertRaisesRegex(ameco.UsageError, "did you mean wing"):
            ameco.coarsen(mesh, freeze=["wnig"])
        kept = ameco.coarsen(mesh, boundary="keep")
        self.assertEqual(len(kept.mesh.faces), len(mesh.faces))
        self.assertLess(len(kept.mesh.nodes), len(mesh.nodes))
        with self.assertRaisesRegex(ameco.UsageError, "boundary: a level keeps"):
            ameco.coarsen(frozen, boundary="keep")
        factors = ameco.hierarchy(mesh, 2, factor=[2, 3])
        self.assertEqual([level.statistics["factor"] for level in factors], [1, 2, 3])
        ratio = ameco.coarsen(mesh, target_ratio=1.9).statistics["ratio"]
        self.assertLess(abs(ratio - 1.9), 0.1)

    def test_refuses_values_that_make_no_sense(self):
        mesh = ameco.case("cube")
        for given, complaint in (
            ({"slack": 0.5}, "slack: 0.5 is not a number of at least 1"),
            ({"factor": 1}, "factor: 1 is not a number greater than 1"),
            ({"factor": []}, "factor: an empty list"),
            ({"levels": 0}, "levels: 0 is not a whole number from 1 to 100"),
            ({"levels": 1.5}, "levels: 1.5 is not"),
            ({"algorithm": "mac"}, "algorithm: mac is not one of basic"),
            ({"ridge_angle": None}, "ridge_angle: None is not"),
            ({"freeze": "wing"}, "freeze: must be a list"),
            ({"factor": 3, "target_ratio": 2}, "factor: excluded by target_ratio"),
        ):
            with self.assertRaisesRegex(ameco.UsageError, complaint):
                ameco.hierarchy(mesh, **given)

    def test_says_when_nothing_can_be_removed(self):
        one = ameco.mesh([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 1, 2, 3]])
        with self.assertRaises(ameco.CheckFailed):
            ameco.coarsen(one)
        self.assertEqual(ameco.hierarchy(one).status, "cannot be coarsened further")

    def test_does_not_depend_on_the_number_of_threads(self):
        mesh = small()
        try:
            ameco.set_threads(1)
            self.assertEqual(ameco.threads(), 1)
            alone = ameco.coarsen(mesh).mesh
        finally:
            ameco.set_threads(0)
        self.assertEqual(ameco.coarsen(mesh).mesh, alone)


    def test_can_be_done_in_several_threads_at_once(self):
        mesh = wing()
        made = [None, None]

        def work(i):
            made[i] = ameco.coarsen(mesh).mesh

        threads = [threading.Thread(target=work, args=(i,)) for i in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(made[0], made[1])
        self.assertEqual(made[0], two_levels()[1].mesh)


class ProgressTest(unittest.TestCase):
    def test_grows_from_the_calling_thread(self):
        told = []
        main = threading.get_ident()

        def progress(fraction, step):
            told.append((fraction, step, threading.get_ident() == main))

        ameco.hierarchy(small(), 2, progress=progress)
        fractions = [fraction for fraction, _, _ in told]
        self.assertGreater(len(told), 10)
        self.assertEqual(fractions, sorted(fractions))
        self.assertLessEqual(max(fractions), 1)
        self.assertTrue(all(on_main for _, _, on_main in told))
        self.assertTrue(any(step.startswith("level 2") for _, step, _ in told))

    def test_an_exception_comes_back_as_it_was_raised(self):
        class Enough(Exception):
            pass

        def progress(fraction, step):
            raise Enough(step)

        for compute in (ameco.natural_metric, ameco.coarsen, ameco.hierarchy):
            with self.assertRaises(Enough):
                compute(small(), progress=progress)

    def test_false_stops(self):
        with self.assertRaises(ameco.Cancelled):
            ameco.coarsen(small(), progress=lambda fraction, step: False)
        with self.assertRaises(ameco.Cancelled):
            ameco.hierarchy(small(), progress=lambda fraction, step: False)

    def test_finished_levels_are_kept_when_stopped(self):
        levels = ameco.hierarchy(
            small(), 4, progress=lambda fraction, step: not step.startswith("level 3")
        )
        self.assertEqual((len(levels), levels.status), (3, "cancelled"))

    def test_an_event_stops_from_another_thread(self):
        # That the timer runs at all shows that the lock is released.
        mesh = bigger_wing()
        event = threading.Event()
        timer = threading.Timer(0.3, event.set)
        timer.start()
        with self.assertRaises(ameco.Cancelled):
            ameco.coarsen(mesh, target_ratio=2, cancel=event)
        timer.join()

    def test_ctrl_c_stops(self):
        mesh = bigger_wing()
        timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            ameco.coarsen(mesh, target_ratio=2)
        timer.join()


class HierarchyTest(unittest.TestCase):
    def test_is_a_sequence_of_levels(self):
        levels = two_levels()
        self.assertEqual([level.number for level in levels], [0, 1, 2])
        self.assertEqual(levels[-1].number, 2)
        self.assertIn("8337 > ", repr(levels))

    def test_is_written_as_the_program_reads_it(self):
        levels = two_levels()
        with tempfile.TemporaryDirectory() as here:
            folder = Path(here) / "levels"
            levels.write(folder, transfer=True)
            with self.assertRaisesRegex(ameco.UsageError, "not empty"):
                levels.write(folder)
            levels.write(folder, force=True, transfer=True)
            self.assertEqual(ameco.read(folder / "level_2.meshb"), levels[2].mesh)
            written = json.loads((folder / "hierarchy.json").read_text())
            self.assertEqual(written["status"], "complete")
            self.assertEqual(written["levels"][1]["nodes"], levels[1].statistics["nodes"])
            self.assertTrue((folder / "P_1.mtx").exists())
            # The program goes on from there as if it had made the levels itself.
            run = [PROGRAM, "coarsen", "levels/level_0.meshb", "-o", "more", "--levels", "3"]
            subprocess.run(run, cwd=here, check=True, capture_output=True)
            more = ameco.coarsen(levels[2])
            self.assertEqual(ameco.read(Path(here) / "more/level_3.meshb"), more.mesh)
            report = [PROGRAM, "report", "levels", "-o", "report.html"]
            subprocess.run(report, cwd=here, check=True, capture_output=True)


if __name__ == "__main__":
    unittest.main()
