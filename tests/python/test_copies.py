"""Tests of the Python module: pickled and copied objects are the same to the bit."""

import copy
import multiprocessing
import os
import pickle
import tempfile
import unittest

import numpy as np

import rocking
from slab import SLAB, changed, suite_in


def copies_of(made):
    return pickle.loads(pickle.dumps(made)), copy.deepcopy(made), copy.copy(made)


def in_another_process(experiment):
    return rocking.run(experiment, threads=1), rocking.trajectory(experiment, condition=1, samples=2)


def failing(experiment):
    return rocking.trajectory(experiment, condition=99)


class Copies(unittest.TestCase):
    def expect_equal(self, again, result):
        self.assertEqual((again.modes, again.digest, again.folder), (result.modes, result.digest, result.folder))
        np.testing.assert_array_equal(again.counts, result.counts)
        np.testing.assert_array_equal(again.intervals, result.intervals)
        np.testing.assert_array_equal(again.realisations(), result.realisations())
        self.assertEqual(again.report().json, result.report().json)
        self.assertEqual(again.experiment.to_dict(), result.experiment.to_dict())
        self.assertTrue(rocking.verify(again, sample=3).is_verified)

    def test_of_results_have_the_same_bits(self):
        with tempfile.TemporaryDirectory() as folder:
            stored = os.path.join(folder, "stored")
            suite = rocking.run(suite_in(folder))
            for result in (rocking.run(SLAB), rocking.run(SLAB, folder=stored), rocking.open_run(stored), suite):
                for again in copies_of(result):
                    self.expect_equal(again, result)

    def test_of_parts_have_their_counts(self):
        part = rocking.run(SLAB, shard=(1, 2))
        for again in copies_of(part):
            self.assertEqual((again.done, again.all, again.is_complete), (part.done, part.all, False))
            np.testing.assert_array_equal(again.counts, part.counts)

    def test_of_trajectories_are_the_same(self):
        general = changed(block={"edges_m": [0.5, 0.4], "centre_height_m": 2.0, "radius_of_gyration_m": 1.0})
        for source in (SLAB, general):
            trajectory = rocking.trajectory(source, condition=1, realisation=2, samples=4)
            for again in copies_of(trajectory):
                for rows in ("strobe", "events", "history"):
                    np.testing.assert_array_equal(getattr(again, rows), getattr(trajectory, rows))
                for units in ("normalised", "si"):
                    self.assertEqual(again.text(units=units), trajectory.text(units=units))
        kind = type(trajectory._core)
        with self.assertRaisesRegex(ValueError, "another version"):
            kind.__new__(kind).__setstate__(("0.0", b""))

    def test_of_bytes_of_another_run_are_refused(self):
        result = rocking.run(SLAB)
        with self.assertRaises(rocking.InputError):
            rocking._core.run_of(rocking.experiment(changed(restitution=0.8))._core, result._core.bytes(), None)
        with self.assertRaises(rocking.StoreError):
            rocking._core.run_of(result.experiment._core, b"no store", None)

    def test_of_small_objects_are_the_same(self):
        for made in (rocking.experiment(SLAB), rocking.plan(SLAB), rocking.verify(rocking.run(SLAB), sample=3)):
            for again in copies_of(made):
                self.assertEqual(repr(again), repr(made))

    def test_of_errors_have_all_fields(self):
        with self.assertRaises(rocking.InputError) as caught:
            rocking.validate(changed(restitution=7))
        for again in copies_of(caught.exception):
            self.assertEqual(again.problems, caught.exception.problems)
        for error in (rocking.DifferentBits("other bits"), rocking.StoreError("a damaged store")):
            for again in copies_of(error):
                self.assertEqual((type(again), str(again)), (type(error), str(error)))
        interrupted = rocking.Interrupted(rocking.run(SLAB))
        for again in copies_of(interrupted):
            self.assertEqual((str(again), again.result.digest), (str(interrupted), interrupted.result.digest))

    def test_of_an_experiment_without_unreadable_records_need_not_leave_them_out_again(self):
        with tempfile.TemporaryDirectory() as folder:
            path = suite_in(folder)
            with open(os.path.join(folder, "r9.txt"), "w") as file:
                file.write("no record\n")
            with self.assertRaises(rocking.InputError):
                rocking.run(path)
            result = rocking.run(path, skip_unreadable=True)
            self.assertEqual(result.experiment.to_dict()["excitation"]["left_out"], ["r9.txt"])
            self.assertEqual(rocking.validate(path, skip_unreadable=True), result.experiment.to_dict())
            for again in copies_of(result):
                self.expect_equal(again, result)

    def test_come_from_other_processes(self):
        with multiprocessing.get_context("spawn").Pool(1) as pool:
            experiment = rocking.experiment(SLAB)
            result, motion = pool.apply(in_another_process, (experiment,))
            self.assertEqual(result.digest, rocking.run(SLAB).digest)
            self.assertTrue(rocking.verify(result).is_verified)
            np.testing.assert_array_equal(motion.strobe, rocking.trajectory(SLAB, condition=1).strobe)
            with self.assertRaises(rocking.InputError) as caught:
                pool.apply(failing, (experiment,))
            self.assertEqual(caught.exception.pointer, "condition")


if __name__ == "__main__":
    unittest.main()
