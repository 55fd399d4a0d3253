"""Tests of the Python module: pages, errors, what objects look like, examples of the documentation."""

import ast
import copy
import doctest
import graphlib
import importlib
import inspect
import json
import os
import pickle
import pkgutil
import shutil
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import rocking
from slab import PROGRAM, SLAB, SOURCE, changed, suite_in, write


def copies_of(made):
    return pickle.loads(pickle.dumps(made)), copy.deepcopy(made)


@unittest.skipUnless(hasattr(rocking._core, "write_page"), "built without fmt (Debian: libfmt-dev)")
class Pages(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = write(self.folder.name, SLAB)
        self.out = os.path.join(self.folder.name, "out")
        self.ours = os.path.join(self.folder.name, "ours")

    def program(self, *arguments):
        return subprocess.run([PROGRAM, *arguments], check=True, capture_output=True, text=True).stdout

    def expect_same(self, written, folder):
        """The files that were written, and those of the program in a folder, have the same names and bytes."""
        self.assertEqual(sorted(path.name for path in written), sorted(os.listdir(folder)))
        for path in written:
            if path.suffix == ".pdf":  # has the time at which it was drawn
                continue
            with open(os.path.join(folder, path.name), "rb") as file:
                self.assertEqual(path.read_bytes(), file.read(), path.name)

    def test_figures_and_tables_are_those_of_the_program(self):
        self.program("run", self.path, "-o", self.out, "--no-page", "-q")
        self.program("report", self.out, "--format", "gnuplot,csv,latex")
        for source in (self.out, rocking.run(SLAB)):
            self.expect_same(rocking.write_figures(source, self.ours).files, os.path.join(self.out, "figures"))
            self.expect_same(rocking.write_tables(source, self.ours).files, os.path.join(self.out, "tables"))
        shutil.rmtree(os.path.join(self.out, "figures"))
        pictures = ["png", "gp"]
        journal = ["--style", "journal", "--width", "double", "--pictures", ",".join(pictures)]
        self.program("report", self.out, "--format", "gnuplot", *journal)
        written = rocking.write_figures(self.out, self.ours, column="journal_double", pictures=pictures)
        self.expect_same(written.files, os.path.join(self.out, "figures"))
        with self.assertRaises(ValueError):
            rocking.write_figures(self.out, self.ours, column="wide")
        with self.assertRaises(rocking.InputError):
            rocking.write_figures(self.out, self.ours, pictures=["eps"])

    def test_page_of_a_trajectory_is_that_of_the_program(self):
        theirs = os.path.join(self.folder.name, "theirs.html")
        ours = os.path.join(self.folder.name, "ours.html")
        self.program("trajectory", self.path, "--condition", "1", "--realisation", "3", "--html", theirs)
        rocking.write_trajectory_page(self.path, ours, condition=1, realisation=3)
        with open(theirs, "rb") as one, open(ours, "rb") as other:
            self.assertEqual(one.read(), other.read())

    def test_page_is_that_of_the_program(self):
        self.program("run", self.path, "-o", self.out, "-q")
        with open(os.path.join(self.out, "report.json")) as file:
            system = json.load(file)["system"]
        result = rocking.open_run(self.out)
        page = rocking.write_page(result, os.path.join(self.folder.name, "page.html")).files[0].read_text()
        with open(os.path.join(self.out, "report.html")) as file:
            theirs = file.read()
        self.assertGreater(len(page), 50000)
        self.assertIn(result.digest, page)
        # All but machine and time, which a store does not know.
        self.assertGreater(len(set(theirs.splitlines()) & set(page.splitlines())), 0.9 * len(set(theirs.splitlines())))
        self.assertNotIn(system["start"] if "start" in system else "2012-01-01T", page)

    def test_studies_are_drawn_as_by_the_program(self):
        motion = ["trajectory", self.path, "--condition", "1", "--samples", "20"]
        file = os.path.join(self.folder.name, "motion.json")
        with open(file, "w") as out:
            out.write(self.program(*motion))
        self.program("report", file, "-o", self.out)
        self.expect_same(rocking.draw(file, folder=self.ours).files, self.out)
        own = rocking.draw(rocking.trajectory(self.path, condition=1, samples_per_period=20), folder=self.ours)
        self.assertEqual(sorted(path.name for path in own.files), sorted(os.listdir(self.out)))
        result = rocking.run(SLAB)
        still = changed(excitation={"kind": "harmonic", "amplitude": 4.0, "frequency_ratio": 10.0},
                        sweep=[{"parameter": "/excitation/amplitude", "values": [3.9, 4.0]}])
        record = os.path.join(self.folder.name, "pulse.txt")
        with open(record, "w") as out:
            out.write("".join(f"{0.01 * i} {4 * np.sin(0.3 * i)}\n" for i in range(200)))
        for found in (rocking.bifurcation(SLAB), rocking.fragility(result), rocking.check_normal(100),
                      rocking.orbits(still, longest=1, branches=True), rocking.motion(record, units="g", series=True)):
            self.assertTrue(rocking.draw(found, folder=self.ours).files)
        with self.assertRaises(rocking.InputError):
            rocking.draw(rocking.compare(result, result), folder=self.ours)
        for other in ({"a": 1}, result):
            with self.assertRaises(TypeError):
                rocking.draw(other, folder=self.ours)

    def test_missing_gnuplot_is_told(self):
        path = os.environ["PATH"]
        self.addCleanup(os.environ.__setitem__, "PATH", path)
        os.environ["PATH"] = self.folder.name
        written = rocking.write_figures(rocking.run(SLAB), self.ours)
        self.assertEqual(len(written.not_drawn), 1)
        self.assertIn("gnuplot", written.not_drawn[0])
        self.assertEqual({path.suffix for path in written.files}, {".tsv", ".gp"})

    def test_what_cannot_be_written_is_refused(self):
        with self.assertRaises(OSError):
            rocking.write_page(rocking.run(SLAB), "/nowhere/report.html")
        part = rocking.run(SLAB, shard=(1, 2), folder=self.out)
        for write_it in (rocking.write_page, rocking.write_figures, rocking.write_tables):
            with self.assertRaises(ValueError):
                write_it(part, self.ours)


class Errors(unittest.TestCase):
    def test_has_every_problem_with_its_pointer(self):
        bad = changed(block={"width_m": -1.0, "height_m": 4.0}, restitution=7)
        with self.assertRaises(rocking.InputError) as caught:
            rocking.run(bad)
        self.assertIsInstance(caught.exception, ValueError)
        places = [problem.place for problem in caught.exception.problems]
        self.assertEqual(places[:1], [caught.exception.pointer])
        self.assertIn("/block/width_m", places)
        self.assertIn("/restitution", places)
        self.assertIn("metres", str(caught.exception))

    def test_unknown_keys_are_errors(self):
        with self.assertRaises(rocking.InputError) as caught:
            rocking.validate(changed(blok={}))
        self.assertEqual(caught.exception.pointer, "/blok")

    def test_survives_pickling_and_copying(self):
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

    def test_missing_files_are_oserrors(self):
        with self.assertRaises(FileNotFoundError):
            rocking.run("/nowhere/experiment.json")
        with self.assertRaises(FileNotFoundError):
            rocking.open_run("/nowhere")

    def test_bad_arguments_are_refused(self):
        with self.assertRaises(rocking.InputError):
            rocking.trajectory(SLAB, condition=3)
        with self.assertRaises(rocking.InputError):
            rocking.run(SLAB, realisations=0)
        with self.assertRaises(ValueError):
            rocking.run(SLAB, threads=0)
        with self.assertRaises(TypeError):
            rocking.run(rocking.experiment(SLAB), seed=3)

    def test_runs_that_cannot_be_paired_are_refused(self):
        first = rocking.run(SLAB)
        with self.assertRaises(rocking.InputError) as caught:
            rocking.compare(first, rocking.run(SLAB, seed=2))
        self.assertEqual(caught.exception.pointer, "/seed")
        shorter = changed()
        del shorter["sweep"]
        with self.assertRaises(rocking.InputError) as caught:
            rocking.compare(first, rocking.run(shorter))
        self.assertEqual(caught.exception.pointer, "/sweep")
        with self.assertRaises(rocking.InputError) as caught:
            rocking.bifurcation(shorter)
        self.assertEqual(caught.exception.pointer, "/sweep")
        with self.assertRaises(FileNotFoundError):
            rocking.compare(first, "/nowhere")

    def test_bad_proportions_are_refused(self):
        for arguments, pointer in (((3, 2), "successes"), ((1, 2, 1.0), "confidence")):
            with self.assertRaises(rocking.InputError) as caught:
                rocking.clopper_pearson(*arguments)
            self.assertEqual(caught.exception.pointer, pointer)
        for successes in (-1, 0.5):
            with self.assertRaises(ValueError):
                rocking.wilson(successes, 2)

    def test_bad_checks_are_refused(self):
        for call, arguments, pointer in (
            (rocking.check_normal, {"n": 19}, "n"),
            (rocking.check_normal, {"sigma": 0.0}, "sigma"),
            (rocking.check_normal, {"mean": 1e6, "sigma": 1e-300}, "sigma"),
            (rocking.check_normal, {"mean": float("nan")}, "mean"),
            (rocking.check_normal, {"sampler": "dice"}, "sampler"),
            (rocking.rare, {"source": SLAB, "particles": 19}, "particles"),
            (rocking.rare, {"source": SLAB, "relative_error": 0.0}, "relative_error"),
            (rocking.rare, {"source": SLAB, "peak_tilt": -1.0}, "peak_tilt"),
            (rocking.verify, {"source": rocking.run(SLAB), "sample": 0}, "sample"),
        ):
            with self.assertRaises(rocking.InputError) as caught:
                call(**arguments)
            self.assertEqual(caught.exception.pointer, pointer)
        still = changed(excitation={"kind": "harmonic", "amplitude": 4.0, "frequency_ratio": 10.0})
        with self.assertRaises(rocking.InputError):  # nothing is random
            rocking.rare(still)

    def test_bad_measurements_of_cost_are_refused(self):
        for arguments, pointer in (({"sample": 0}, "sample"), ({"sample": 10**6}, "sample"),
                                   ({"seconds": 0.0}, "seconds"), ({"tolerances": [1.0]}, "tolerances/0"),
                                   ({"tolerances": [float("nan")]}, "tolerances/0"),
                                   ({"tolerances": [1e-8]}, "tolerances")):
            with self.assertRaises(rocking.InputError, msg=arguments) as caught:
                rocking.cost(SLAB, **arguments)
            self.assertEqual(caught.exception.pointer, pointer)

    def test_parts_that_do_not_belong_together_are_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            names = [os.path.join(folder, name) for name in ("one", "two", "whole")]
            rocking.run(SLAB, shard=(1, 2), folder=names[0])
            rocking.run(SLAB, shard=(2, 2), folder=names[1], seed=2)
            for parts in ([], names[:2]):
                with self.assertRaises(rocking.InputError):
                    rocking.merge(names[2], parts)
            with self.assertRaises(FileNotFoundError):
                rocking.merge(names[2], [names[0], os.path.join(folder, "none")])
            self.assertFalse(os.path.exists(names[2]))
            with self.assertRaises(rocking.InputError):  # into one of the parts
                rocking.merge(names[0], names[:1])
            with self.assertRaises(rocking.InputError):  # another part of the same experiment
                rocking.run(SLAB, shard=(2, 2), folder=names[0])
            for shard in ((0, 2), (3, 2)):
                with self.assertRaises(rocking.InputError) as caught:
                    rocking.run(SLAB, shard=shard)
                self.assertEqual(caught.exception.pointer, "shard")
            until = changed(realisations={"until": {"half_width": 0.2, "at_most": 100}})
            with self.assertRaises(rocking.InputError) as caught:
                rocking.run(until, shard=(1, 2))
            self.assertEqual(caught.exception.pointer, "/realisations")

    def test_a_folder_of_another_experiment_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            rocking.run(SLAB, folder=folder)
            with self.assertRaises(rocking.InputError):
                rocking.run(SLAB, seed=2, folder=folder)

    def test_a_damaged_store_is_a_store_error(self):
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "realisations.sqlite"), "w") as file:
                file.write("no store " * 1000)
            with self.assertRaises(rocking.StoreError):
                rocking.open_run(folder)


class Representation(unittest.TestCase):
    def test_says_what_an_object_holds(self):
        still = changed(excitation={"kind": "harmonic", "amplitude": 4.0, "frequency_ratio": 10.0}, realisations=1,
                        sweep=[{"parameter": "/excitation/amplitude", "values": [3.5, 4.0]}])
        trajectory = rocking.trajectory(SLAB, condition=1, realisation=2, periods=7)
        self.assertRegex(repr(trajectory), "^<rocking.Trajectory of condition 1, realisation 2: 7 periods, [0-9]+ events, "
                                           "reached_horizon>$")
        found = rocking.orbits(still, longest=1, branches=True)
        self.assertRegex(repr(found), "^<rocking.Orbits .*parameter=/excitation/amplitude, .*branches=[0-9]+ entries")
        self.assertRegex(repr(found.conditions[1].orbits[0]), "^<rocking.Orbit period=1, cycles=1, ")

    def test_is_our_own_for_every_class_of_results(self):
        for name in rocking.__all__:
            kind = getattr(rocking, name)
            if isinstance(kind, type) and not issubclass(kind, (tuple, Exception, KeyboardInterrupt)):
                self.assertIs(type(kind.__repr__), type(Representation.setUp), name)


class Arrays(unittest.TestCase):
    def test_are_views_that_outlive_their_trajectory(self):
        events = rocking.trajectory(SLAB, condition=1).events
        copy = events.copy()
        for _ in range(20):
            rocking.trajectory(SLAB, condition=2)
        np.testing.assert_array_equal(events, copy)
        self.assertFalse(events.flags.writeable)
        self.assertFalse(events.flags.owndata)

    def test_realisations_have_the_counts(self):
        result = rocking.run(SLAB)
        rows = result.realisations()
        self.assertEqual(len(rows), 60)
        for j in range(len(result.modes)):
            for condition in range(3):
                here = rows[(rows["condition"] == condition) & (rows["mode"] == j)]
                self.assertEqual(len(here), result.counts[condition, j])

    def test_parameters_are_those_of_the_sweep(self):
        result = rocking.run(SLAB)
        np.testing.assert_array_equal(result.parameter("/excitation/amplitude"), [1.0, 4.0, 12.0])
        self.assertEqual(result.experiment.shape, (3,))
        with self.assertRaises(KeyError):
            result.parameter("/seed")

    def test_accepts_numbers_of_numpy(self):
        swept = changed(sweep=[{"parameter": "/excitation/amplitude", "values": np.array([1.0, 4.0, 12.0])}])
        self.assertEqual(rocking.run(swept).digest, rocking.run(SLAB).digest)
        self.assertEqual(rocking.validate(changed(realisations=np.int64(20)))["realisations"], 20)

    def test_to_pandas(self):
        try:
            import pandas  # noqa: F401
        except ImportError:
            self.skipTest("pandas was not found (Debian: python3-pandas)")
        result = rocking.run(SLAB)
        table = result.to_pandas()
        self.assertEqual(len(table), result.counts.size)
        self.assertEqual(table["count"].sum(), 60)
        self.assertEqual(rocking.trajectory(SLAB, condition=1).to_pandas("events")["kind"][0], "lift")


class Copies(unittest.TestCase):
    def expect_equal(self, again, result):
        self.assertEqual((again.modes, again.digest, again.folder), (result.modes, result.digest, result.folder))
        np.testing.assert_array_equal(again.counts, result.counts)
        np.testing.assert_array_equal(again.intervals, result.intervals)
        np.testing.assert_array_equal(again.realisations(), result.realisations())
        self.assertEqual(again.report().text, result.report().text)
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
            trajectory = rocking.trajectory(source, condition=1, realisation=2, samples_per_period=4)
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


class Labelled(unittest.TestCase):
    """Arrays with the names of their dimensions."""

    def setUp(self):
        try:
            import xarray  # noqa: F401
        except ImportError:
            self.skipTest("xarray was not found (Debian: python3-xarray)")

    def test_results_have_the_dimensions_of_the_sweep(self):
        swept = changed(sweep=[{"parameter": "/excitation/amplitude", "values": [1.0, 4.0, 12.0]},
                               {"parameter": "/restitution", "values": [0.8, 0.9]}], realisations=5)
        result = rocking.run(swept)
        found = result.to_xarray()
        self.assertEqual(dict(found.sizes), {"amplitude": 3, "restitution": 2, "mode": len(result.modes)})
        for i in range(len(result.experiment)):
            here = {pointer.split("/")[-1]: value for pointer, value in result.experiment.parameters(i).items()}
            np.testing.assert_array_equal(found["count"].sel(here), result.counts[i])
            np.testing.assert_array_equal(found["low"].sel(here), result.intervals[i, :, 0])
            self.assertEqual(found["realisations"].sel(here), 5)
        single = {key: value for key, value in SLAB.items() if key != "sweep"}
        self.assertEqual(rocking.run(single).to_xarray()["count"].dims, ("mode",))

    def test_trajectories_have_their_times(self):
        trajectory = rocking.trajectory(SLAB, condition=1, samples_per_period=4)
        for rows, place in (("strobe", "period"), ("events", "tau"), ("history", "tau")):
            found = trajectory.to_xarray(rows)
            self.assertEqual(found["tilt"].dims, (place,))
            np.testing.assert_array_equal(found["tilt"], getattr(trajectory, rows)["tilt"])
        self.assertEqual(str(trajectory.to_xarray("events")["kind"].values[0]), "lift")

    def test_documents_have_their_lists(self):
        with tempfile.TemporaryDirectory() as folder:
            suite_in(folder)
            motions = rocking.motion(os.path.join(folder, "r0.txt"), units="m/s2").motions
        series = motions[0].series.to_xarray()
        self.assertEqual(series["velocity_m_s"].dims, ("time_s",))
        np.testing.assert_array_equal(series["acceleration_g"], motions[0].series.acceleration_g)
        self.assertEqual(motions[0].spectrum.to_xarray()["sa_g"].dims, ("row",))


class Memory(unittest.TestCase):
    def test_many_calls_keep_no_memory(self):
        one = changed(realisations=1)
        del one["sweep"]

        def resident():
            with open("/proc/self/statm") as file:
                return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")

        def calls():
            for _ in range(1000):
                rocking.run(one, threads=1).realisations()
                rocking.trajectory(one)

        calls()
        before = resident()
        calls()
        self.assertLess(resident() - before, 4_000_000)


class Modules(unittest.TestCase):
    def test_import_one_another_in_one_direction_only(self):
        imports = {}
        for module in pkgutil.iter_modules(rocking.__path__):
            path = os.path.join(rocking.__path__[0], module.name + ".py")
            if not os.path.exists(path):  # the core
                continue
            with open(path) as file:
                tree = ast.parse(file.read())
            imports[module.name] = {name for node in ast.walk(tree) if isinstance(node, ast.ImportFrom) and node.level
                                    for name in ([node.module] if node.module else [each.name for each in node.names])}
        self.assertIn("fields", imports["documents"])
        graphlib.TopologicalSorter(imports).prepare()  # raises CycleError


class Packaging(unittest.TestCase):
    @unittest.skipUnless(np.__version__.startswith("1."), "systems with numpy 2 have a pybind11 that knows it")
    def test_numpy_2_is_refused_where_arrays_would_be_wrong(self):
        code = "import numpy; numpy.__version__ = '2.0.0'; import rocking"
        refused = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
        self.assertIn("which does not know numpy 2.0.0: install numpy<2", refused.stderr)


class Stubs(unittest.TestCase):
    def test_name_everything_in_the_core(self):
        with open(os.path.join(SOURCE, "lib/python/rocking/_core.pyi")) as file:
            stub = file.read()
        for name in dir(rocking._core):
            if not name.startswith("_"):
                self.assertRegex(stub, rf"(def|class) {name}\b|^{name}:|\n{name}:")
        self.assertTrue(os.path.exists(os.path.join(SOURCE, "lib/python/rocking/py.typed")))

    def test_every_function_has_an_example_and_every_name_is_in_the_reference(self):
        with open(os.path.join(SOURCE, "lib/docs/reference/python.rst")) as file:
            reference = file.read()
        for name in rocking.__all__:
            public = getattr(rocking, name)
            if name != "ExperimentLike":  # a union of types
                self.assertRegex(reference, rf"rocking\.{name}\b")
            if inspect.isroutine(public):
                self.assertIn(">>>", public.__doc__, name)
            elif inspect.isclass(public):
                self.assertTrue(public.__doc__, name)


def load_tests(loader, tests, pattern):
    for module in pkgutil.iter_modules(rocking.__path__):
        tests.addTests(doctest.DocTestSuite(importlib.import_module(f"rocking.{module.name}")))
    tests.addTests(doctest.DocTestSuite(rocking))
    return tests


if __name__ == "__main__":
    unittest.main()
