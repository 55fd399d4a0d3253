"""Tests of the Python module: errors, arrays, what objects look like, examples of the documentation."""

import ast
import doctest
import graphlib
import importlib
import inspect
import math
import os
import pkgutil
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import rocking
from slab import SLAB, SOURCE, changed, suite_in, write


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

    def test_of_a_dictionary_name_the_place_and_no_line(self):
        bad = changed(block={"width_m": -1.0, "height_m": 4.0})
        with self.assertRaises(rocking.InputError) as of_dictionary:
            rocking.validate(bad)
        with tempfile.TemporaryDirectory() as folder, self.assertRaises(rocking.InputError) as of_file:
            rocking.validate(write(folder, bad))
        ours, theirs = of_dictionary.exception.problems[0], of_file.exception.problems[0]
        self.assertEqual(ours, theirs._replace(where=""))
        self.assertRegex(theirs.where, "experiment.json, line 1$")
        self.assertNotIn("line", str(of_dictionary.exception))
        for value in (float("nan"), np.array([1.0, np.inf]), {"uniform": (0.0, -math.inf)}):
            with self.assertRaises(rocking.InputError) as caught:
                rocking.validate(changed(restitution=value))
            self.assertIn("/restitution", caught.exception.pointer)
            self.assertNotIn("line", str(caught.exception))
            self.assertRegex(str(caught.exception), "not a finite number|must be")
            self.assertNotIn("quotes", str(caught.exception))

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
            (rocking.rare, {"source": SLAB, "event": "tilt > -1 psi"}, "event"),
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
                                   ({"max_time": 0.0}, "max_time"), ({"tolerances": [1.0]}, "tolerances/0"),
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
            with self.assertRaises(rocking.InputError):
                rocking.resume(names[2], names[:2])
            with self.assertRaises(FileNotFoundError):
                rocking.resume(names[2], [names[0], os.path.join(folder, "none")])
            self.assertFalse(os.path.exists(names[2]))
            with self.assertRaises(rocking.InputError):  # into one of the parts
                rocking.resume(names[0], names[:1])
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
        found = rocking.orbits(still, periods=1)
        self.assertRegex(repr(found), "^<rocking.Orbits .*parameter=/excitation/amplitude, .*branches=[0-9]+ entries")
        self.assertRegex(repr(found.conditions[1].orbits[0]), "^<rocking.Orbit period=1, cycles=1, ")

    def test_is_our_own_for_every_class_of_results(self):
        for name in rocking.__all__:
            kind = getattr(rocking, name)
            if isinstance(kind, type) and not issubclass(kind, (tuple, Exception, KeyboardInterrupt)):
                self.assertIs(type(kind.__repr__), type(Representation.setUp), name)


class Arrays(unittest.TestCase):
    def test_outlive_their_trajectory_and_are_read_only(self):
        events = rocking.trajectory(SLAB, condition=1).events
        copy = events.copy()
        for _ in range(20):
            rocking.trajectory(SLAB, condition=2)
        np.testing.assert_array_equal(events, copy)
        self.assertFalse(events.flags.writeable)

    def test_of_trajectories_are_those_of_the_csv_in_si(self):
        names = ["time_s", "tilt_rad", "tilt_rate_rad_s", "slip_m", "slip_rate_m_s"]
        general = changed(block={"edges_m": [0.5, 0.4], "centre_height_m": 2.0, "radius_of_gyration_m": 1.0})
        for source in (SLAB, general):
            made = rocking.trajectory(source, condition=1, samples=4)
            lines = [line.split(",") for line in made.text("csv", "si").splitlines() if not line.startswith("#")]
            self.assertEqual(lines[0][1:6], names)
            self.assertIn(f"# mode: {made.mode}\n", made.text("csv"))
            self.assertEqual(made.backed_by is None, not made.mode.startswith("("))
            for row, rows in (("strobe", made.strobe), ("event", made.events), ("sample", made.history)):
                theirs = np.array([[float(cell) for cell in line[1:6]] for line in lines if line[0] == row])
                self.assertGreater(len(theirs), 10)
                np.testing.assert_array_equal(np.stack([rows[name] for name in names], axis=1), theirs)
            self.assertFalse(made.strobe.flags.writeable)
            try:
                self.assertTrue(set(names) <= set(made.to_pandas("history").columns))
            except ImportError:
                pass

    def test_of_counted_tests_are_those_of_their_file(self):
        campaign = changed(unknown=[{"parameter": "/restitution", "from": 0.8, "to": 0.95}], sweep=[], realisations=20)
        del campaign["sweep"]
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "tests.csv")
            with open(path, "w") as file:
                file.write('amplitude,"(1,1)",overturned,other\n4.0,2,1,4\n6.0,0,3,0\n')
            expected = rocking.infer(campaign, path)
        columns = {"amplitude": np.array([4.0, 6.0]), "(1,1)": [2, 0], "overturned": [1, 3], "other": np.array([4, 0])}
        rows = [{name: values[i] for name, values in columns.items()} for i in (0, 1)]
        for given in (columns, rows):
            self.assertEqual(rocking.infer(campaign, given), expected)
        with self.assertRaises(rocking.InputError) as caught:
            rocking.infer(campaign, {**columns, "overturned": [1, -3]})
        self.assertEqual(caught.exception.pointer, "tests[1]")

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
        trajectory = rocking.trajectory(SLAB, condition=1, samples=4)
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
