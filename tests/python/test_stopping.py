"""Tests of the Python module: Ctrl-C, several threads, folders that are continued."""

import math
import multiprocessing
import os
import signal
import subprocess
import tempfile
import threading
import time
import unittest

import numpy as np

import rocking
from slab import LONG, PROGRAM, SLAB, changed, suite_in, write


def digest_with_seed(seed):
    return rocking.run(SLAB, seed=seed).digest


class Interrupting(unittest.TestCase):
    def setUp(self):  # a background process of a shell ignores the signal
        before = signal.signal(signal.SIGINT, signal.default_int_handler)
        self.addCleanup(signal.signal, signal.SIGINT, before)

    def test_ctrl_c_keeps_what_is_done(self):
        def interrupt(done, all):
            if done > 20:
                os.kill(os.getpid(), signal.SIGINT)

        with self.assertRaises(rocking.Interrupted) as caught:
            rocking.run(LONG, progress=interrupt)
        result = caught.exception.result
        self.assertIsInstance(caught.exception, KeyboardInterrupt)
        self.assertTrue(20 < result.done < result.all)
        self.assertEqual(result.counts.sum(), result.done)
        with self.assertRaises(ValueError):
            result.probabilities

    def test_ctrl_c_stops_a_run_that_tells_of_no_progress(self):
        # The main thread runs no Python meanwhile, so only the core can see the signal.
        with tempfile.TemporaryDirectory() as folder:

            def interrupt_when_it_has_begun():
                while not os.path.exists(os.path.join(folder, "realisations.sqlite")):
                    time.sleep(0.01)
                os.kill(os.getpid(), signal.SIGINT)

            threading.Thread(target=interrupt_when_it_has_begun).start()
            with self.assertRaises(rocking.Interrupted) as caught:
                rocking.run(LONG, folder=folder, threads=1)
        self.assertLess(caught.exception.result.done, caught.exception.result.all)

    def test_ctrl_c_stops_a_measurement_of_cost(self):
        def interrupt(done, all):
            os.kill(os.getpid(), signal.SIGINT)

        with self.assertRaises(KeyboardInterrupt):
            rocking.cost(LONG, sample=100000, progress=interrupt)

    def test_ctrl_c_stops_a_bifurcation(self):
        def interrupt(done, all):
            os.kill(os.getpid(), signal.SIGINT)

        values = np.linspace(1.0, 4.0, 200)
        long = changed(sweep=[{"parameter": "/excitation/amplitude", "values": values}],
                       horizon={"transient_periods": 2000, "sampled_periods": 20})
        with self.assertRaises(KeyboardInterrupt):
            rocking.bifurcation(long, threads=1, progress=interrupt)

    def test_ctrl_c_stops_fragility(self):
        def interrupt(done, all):
            os.kill(os.getpid(), signal.SIGINT)

        with tempfile.TemporaryDirectory() as folder:
            result = rocking.run(suite_in(folder))
            with self.assertRaises(KeyboardInterrupt):
                rocking.fragility(result, event=[f"tilt > {tilt} psi" for tilt in np.linspace(0.001, 0.9, 200)], threads=1, progress=interrupt)

    def test_ctrl_c_stops_rare_and_verify_and_orbits(self):
        told = []

        def interrupt(done, all):
            told.append((done, all))
            os.kill(os.getpid(), signal.SIGINT)

        result = rocking.run(changed(realisations=2000))
        several = changed(excitation={"kind": "harmonic", "amplitude": 4.0, "frequency_ratio": 10.0}, realisations=1,
                          sweep=[{"parameter": "/excitation/amplitude", "values": np.linspace(1.0, 4.0, 200)}])
        for call in (lambda: rocking.rare(SLAB, relative_error=1e-3, threads=1, progress=interrupt),
                     lambda: rocking.verify(result, threads=1, progress=interrupt),
                     lambda: rocking.orbits(several, periods=1, threads=1, progress=interrupt)):
            with self.assertRaises(KeyboardInterrupt):
                call()
            done, all = told[-1]
            self.assertLess(done, all or math.inf)  # zero: not known

    def test_ctrl_c_stops_a_trajectory(self):
        # Of a block that rocks, and of one that stays at rest.
        rest = changed(excitation={"kind": "harmonic", "amplitude": 0.5, "frequency_ratio": 10.0},
                       sweep=[{"parameter": "/excitation/amplitude", "values": [0.5]}],
                       friction={"static": 0.5, "kinetic": 0.4}, fluctuation={"friction": {"sigma": 0.01}})
        long = {"periods": 50_000_000}
        result = rocking.run(SLAB)
        with tempfile.TemporaryDirectory() as folder:
            page = os.path.join(folder, "page.html")
            for call in (lambda: rocking.trajectory(SLAB, condition=1, **long), lambda: rocking.trajectory(rest, **long),
                         lambda: rocking.trajectory(SLAB, condition=1, samples=2, **long),
                         lambda: rocking.trajectory(result, condition=1, **long),
                         lambda: rocking.write_trajectory_page(SLAB, page, condition=1, **long)):
                timer = threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT))
                with self.assertRaises(KeyboardInterrupt):
                    timer.start()
                    call()
                timer.join()
            self.assertEqual(os.listdir(folder), [])

    def test_runs_of_several_threads_in_one_folder_exclude_each_other(self):
        seeds = range(6)
        for _ in range(5):
            outcomes = {}
            with tempfile.TemporaryDirectory() as folder:
                gate = threading.Barrier(len(seeds))

                def work(seed):
                    gate.wait()
                    try:
                        outcomes[seed] = rocking.run(SLAB, seed=seed, threads=1, folder=folder).digest
                    except (OSError, rocking.InputError) as error:
                        outcomes[seed] = error

                threads = [threading.Thread(target=work, args=(seed,)) for seed in seeds]
                for thread in threads:
                    thread.start()
                for thread in threads:
                    thread.join()
                done = [outcome for outcome in outcomes.values() if isinstance(outcome, str)]
                self.assertEqual(done, [rocking.open_run(folder).digest], outcomes)
                # An error keeps the frames in which a store is open, with its log beside it.
                left = {name for name in os.listdir(folder) if not name.endswith(("-wal", "-shm"))}
                self.assertEqual(left, {"realisations.sqlite"})
                for error in outcomes.values():
                    if not isinstance(error, str):
                        self.assertRegex(str(error), "is working in this folder|contains a run|realisations of another experiment")

    def test_a_run_in_progress_can_be_looked_at(self):
        with tempfile.TemporaryDirectory() as folder:
            out = os.path.join(folder, "out")
            running = subprocess.Popen([PROGRAM, "run", write(folder, LONG), "-o", out, "--no-page", "-q", "-j", "1",
                                        "--realisations", "1000000"])
            self.addCleanup(running.wait)
            self.addCleanup(running.kill)
            store = os.path.join(out, "realisations.sqlite")
            done = 0
            while done == 0 and running.poll() is None:
                time.sleep(0.1)
                if os.path.exists(store) and os.path.getsize(store):
                    done = rocking.open_run(out).done
            self.assertIsNone(running.poll(), "it is in progress")
            running.kill()
            running.wait()
        self.assertTrue(0 < done < 1000000)

    def test_a_stopped_run_goes_on_in_its_folder(self):
        longer = changed(realisations=1500)
        with tempfile.TemporaryDirectory() as folder:
            class Enough(Exception):
                pass

            def stop(done, all):
                if done > 100:
                    raise Enough

            with self.assertRaises(Enough):
                rocking.run(longer, folder=folder, progress=stop)
            part = rocking.open_run(folder)
            self.assertTrue(100 < part.done < part.all)
            self.assertEqual(rocking.run(longer, folder=folder).digest, rocking.run(longer).digest)

    def test_a_run_is_extended_in_its_folder(self):
        with tempfile.TemporaryDirectory() as folder:
            rocking.run(SLAB, folder=folder)
            longer = rocking.run(SLAB, realisations=31, folder=folder)
            self.assertEqual(longer.digest, rocking.run(SLAB, realisations=31).digest)
            self.assertTrue(rocking.verify(folder).is_verified)
            for other in (SLAB, changed(restitution=0.8, realisations=40)):
                with self.assertRaises(rocking.InputError):
                    rocking.run(other, folder=folder)
            self.assertEqual(rocking.open_run(folder).digest, longer.digest)
            open(os.path.join(folder, "report.json"), "w").close()
            with self.assertRaises(rocking.InputError):
                rocking.run(SLAB, realisations=40, folder=folder)

    def test_a_run_is_extended_by_levels(self):
        wider = changed(sweep=[{"parameter": "/excitation/amplitude", "values": [1.0, 2.0, 4.0, 12.0]}])
        with tempfile.TemporaryDirectory() as folder:
            rocking.run(SLAB, folder=folder)
            longer = rocking.resume(folder, levels=[2.0])
            self.assertEqual(longer.parameter("/excitation/amplitude").tolist(), [1.0, 2.0, 4.0, 12.0])
            self.assertEqual(longer.digest, rocking.run(wider).digest)
            self.assertEqual(rocking.resume(folder).digest, longer.digest)
            more = rocking.resume(folder, levels=np.array([3.0]), realisations=25, threads=1)
            self.assertEqual((more.done, more.all), (125, 125))
            for wrong in ({"realisations": 3}, {"levels": [-1.0]}):
                with self.assertRaises((OSError, rocking.InputError)):
                    rocking.resume(folder, **wrong)
            with self.assertRaises(TypeError):
                rocking.resume(folder, [folder], levels=[2.0])
        with self.assertRaises(FileNotFoundError):
            rocking.resume("/nowhere/run")

    def test_a_run_ends_when_its_time_is_up(self):
        long = changed(realisations=2000)
        with tempfile.TemporaryDirectory() as folder:
            part = rocking.run(LONG, max_time=0.2, threads=1, folder=folder)
            self.assertTrue(0 < part.done < part.all)
            self.assertFalse(part.is_complete)
            more = rocking.resume(folder, max_time=0.2, threads=1)
            self.assertTrue(part.done < more.done < more.all)
        self.assertTrue(rocking.run(long, max_time=600).is_complete)
        with self.assertRaises(ValueError):
            rocking.run(SLAB, max_time=0)

    def test_ctrl_c_stops_resume(self):
        def interrupt(done, all):
            os.kill(os.getpid(), signal.SIGINT)

        with tempfile.TemporaryDirectory() as folder:
            rocking.run(LONG, max_time=0.1, threads=1, folder=folder)
            with self.assertRaises(rocking.Interrupted) as caught:
                rocking.resume(folder, progress=interrupt, threads=1)
            self.assertLess(caught.exception.result.done, caught.exception.result.all)

    def test_a_damaged_store_is_repaired(self):
        with tempfile.TemporaryDirectory() as folder:
            store = os.path.join(folder, "realisations.sqlite")
            digest = rocking.run(SLAB, folder=folder).digest
            with open(store, "r+b") as file:
                file.seek(os.path.getsize(store) * 3 // 4)
                file.write(b"\xff" * 300)
            with self.assertRaises(rocking.StoreError):
                rocking.run(SLAB, folder=folder)
            repaired = rocking.run(SLAB, folder=folder, repair=True)
            self.assertEqual(repaired.digest, digest)
            self.assertTrue(os.path.exists(repaired.damaged_file))
            self.assertIsNone(rocking.run(SLAB, folder=folder, repair=True).damaged_file)

    def test_exceptions_of_the_function_that_is_told_reach_the_caller(self):
        class Enough(Exception):
            pass

        def tell(done, all):
            raise Enough

        still = changed(excitation={"kind": "harmonic", "amplitude": 4.0, "frequency_ratio": 10.0})
        result = rocking.run(SLAB)
        for study in (lambda: rocking.run(LONG, progress=tell), lambda: rocking.cost(LONG, progress=tell),
                      lambda: rocking.rare(SLAB, relative_error=1e-3, progress=tell),
                      lambda: rocking.orbits(still, periods=2, progress=tell),
                      lambda: rocking.bifurcation(SLAB, progress=tell), lambda: rocking.verify(result, progress=tell)):
            with self.assertRaises(Enough):
                study()
        self.assertEqual(rocking.run(SLAB).digest, result.digest)

    def test_a_forked_process_computes_the_same(self):
        digest = rocking.run(SLAB).digest
        with multiprocessing.get_context("fork").Pool(2) as pool:
            self.assertEqual(pool.map(digest_with_seed, ["0x1", "0x1"]), [digest] * 2)

    def test_runs_of_several_threads_are_independent(self):
        digests = {}

        def work(seed):
            digests[seed] = rocking.run(SLAB, seed=seed, threads=1).digest

        threads = [threading.Thread(target=work, args=(seed,)) for seed in (1, 2, 3, 4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(digests[1], rocking.run(SLAB, seed=1).digest)
        self.assertEqual(len(set(digests.values())), 4)


if __name__ == "__main__":
    unittest.main()
