"""Tests of the Python module: the same bits as the program, errors, Ctrl-C, cost.

Environment: ROCKING_PROGRAM, the program; ROCKING_SOURCE, the root of the clone.
"""

import ast
import doctest
import graphlib
import importlib
import inspect
import json
import math
import multiprocessing
import os
import pickle
import pkgutil
import re
import signal
import subprocess
import tempfile
import threading
import time
import unittest

import numpy as np

import rocking

PROGRAM = os.environ["ROCKING_PROGRAM"]
SOURCE = os.environ["ROCKING_SOURCE"]

SLAB = {
    "format": "rocking.experiment/1",
    "block": {"width_m": 1.0, "height_m": 4.0},
    "excitation": {
        "kind": "harmonic",
        "amplitude": 2.0,
        "frequency_ratio": 10.0,
        "phase_rad": {"uniform": [0.0, 6.28]},
    },
    "restitution": 0.9,
    "horizon": {"transient_periods": 20, "sampled_periods": 20},
    "sweep": [{"parameter": "/excitation/amplitude", "values": [1.0, 4.0, 12.0]}],
    "realisations": 20,
    "seed": "0x1",
}


def changed(**keys):
    return {**SLAB, **keys}


def write(folder, experiment):
    path = os.path.join(folder, "experiment.json")
    with open(path, "w") as file:
        json.dump(experiment, file)
    return path


def digest_with_seed(seed):
    return rocking.run(SLAB, seed=seed).digest


class AgainstTheProgram(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = write(self.folder.name, SLAB)
        self.out = os.path.join(self.folder.name, "out")

    def program(self, *arguments):
        return subprocess.run([PROGRAM, *arguments], check=True, capture_output=True, text=True).stdout

    def test_has_the_bits_of_the_program(self):
        self.program("run", self.path, "-o", self.out, "--no-page", "-q")
        with open(os.path.join(self.out, "report.json")) as file:
            report = json.load(file)
        for source in (SLAB, self.path, rocking.experiment(SLAB)):
            for threads in (1, 3):
                result = rocking.run(source, threads=threads)
                self.assertEqual(result.digest, report["result"]["digest"])
                own = result.report().data
                for key in report:
                    if key != "system":
                        self.assertEqual(own[key], report[key], key)

    def test_has_the_numbers_of_the_report(self):
        result = rocking.run(SLAB)
        for i, condition in enumerate(result.report().data["result"]["conditions"]):
            for name, count in condition["counts"].items():
                j = result.modes.index(name)
                self.assertEqual(result.counts[i, j], count)
                probability = condition["probabilities"][name]
                self.assertEqual(result.probabilities[i, j], probability["estimate"])
                np.testing.assert_array_equal(result.intervals[i, j], probability["simultaneous"])

    def test_program_and_module_read_each_others_folders(self):
        by_module = rocking.run(self.path, folder=self.out)
        self.assertIn("60 of 60", self.program("status", self.out))
        self.program("resume", self.out, "--no-page", "-q")
        with open(os.path.join(self.out, "report.json")) as file:
            self.assertEqual(json.load(file)["result"]["digest"], by_module.digest)
        self.assertEqual(rocking.open_run(self.out).digest, by_module.digest)

    def test_trajectory_is_that_of_the_program(self):
        theirs = json.loads(self.program("trajectory", self.path, "--condition", "1", "--realisation", "3"))
        ours = rocking.trajectory(self.path, condition=1, realisation=3, samples_per_period=4)
        self.assertEqual(len(ours.strobe), len(theirs["strobe"]))
        self.assertEqual([rocking.EVENTS[kind] for kind in ours.events["kind"]], [e["kind"] for e in theirs["events"]])
        for name in ("tau", "tilt", "tilt_rate"):
            np.testing.assert_array_equal(ours.events[name], [event[name] for event in theirs["events"]])
        self.assertEqual(ours.termination, theirs["termination"])
        self.assertEqual(len(ours.history), 4 * 40 + 1)

    def test_every_study_has_the_bytes_of_the_program(self):
        still = changed(excitation={"kind": "harmonic", "amplitude": 4.0, "frequency_ratio": 10.0},
                        sweep=[{"parameter": "/excitation/amplitude", "values": [3.9, 4.0]}])
        still = write(tempfile.mkdtemp(dir=self.folder.name), still)
        pulse = os.path.join(self.folder.name, "pulse.txt")
        with open(pulse, "w") as file:
            file.write("".join(f"{0.01 * i} {4 * np.sin(0.3 * i)}\n" for i in range(200)))
        counted = write(tempfile.mkdtemp(dir=self.folder.name),
                        changed(unknown=[{"parameter": "/restitution", "from": 0.8, "to": 0.95}]))
        tests, candidates = (os.path.join(self.folder.name, name) for name in ("tests.csv", "candidates.csv"))
        with open(tests, "w") as file:
            file.write("amplitude,overturned,other\n4.0,1,4\n")
        with open(candidates, "w") as file:
            file.write("amplitude\n6.0\n")
        first, second = (os.path.join(self.folder.name, name) for name in ("first", "second"))
        rocking.run(self.path, folder=first)
        rocking.run(changed(restitution=0.5), folder=second)
        # command; its file in the folder (None: standard output); the same in Python
        studies = [
            (["orbits", still, "--periods", "1", "--no-branches"], "orbits.json",
             lambda: rocking.orbits(still, longest=1)),
            (["orbits", still, "--periods", "1", "--from", "3.8"], "orbits.json",
             lambda: rocking.orbits(still, longest=1, branches=True, branch_range=(3.8, None))),
            (["bifurcation", self.path, "--realisation", "2"], "bifurcation.json",
             lambda: rocking.bifurcation(self.path, realisation=2)),
            (["rare", self.path, "--peak-tilt", "0.3", "--particles", "50", "--relative-error", "0.5"],
             "rare.json", lambda: rocking.rare(self.path, peak_tilt=0.3, particles=50, relative_error=0.5)),
            (["infer", counted, "--tests", tests, "--candidates", candidates, "--next-tests", "3"], "infer.json",
             lambda: rocking.infer(counted, tests, candidates=candidates, next_tests=3)),
            (["fragility", first, "--peak-tilt", "0.5", "--ida", "--json"], None,
             lambda: rocking.fragility(first, peak_tilts=[0.5], incremental=True)),
            (["compare", first, second, "--json"], None, lambda: rocking.compare(first, second)),
            (["motion", pulse, "--units", "m/s2", "--block", "1", "4", "--periods", "0.2", "1", "--series", "--json"], None,
             lambda: rocking.motion(pulse, units="m/s2", block=(1, 4), periods=[0.2, 1], series=True)),
            (["check-normal", "--n", "500", "--sampler", "ziggurat", "--json"], None,
             lambda: rocking.check_normal(500, sampler="ziggurat")),
        ]
        for arguments, name, study in studies:
            with self.subTest(arguments[0]):
                if name is None:
                    theirs = self.program(*arguments)
                else:
                    out = tempfile.mkdtemp(dir=self.folder.name)
                    self.program(*arguments, "-o", out, "-q")
                    with open(os.path.join(out, name)) as file:
                        theirs = file.read()
                self.assertEqual(study().text, theirs)

    def test_orbits_without_branches_have_none(self):
        still = changed(excitation={"kind": "harmonic", "amplitude": 4.0, "frequency_ratio": 10.0},
                        sweep=[{"parameter": "/excitation/amplitude", "values": [3.9, 4.0]}])
        self.assertIsNone(rocking.orbits(still, longest=1).branches)
        for wrong in ({"branch_range": (4.0, 3.0)}, {"source": changed(excitation=still["excitation"], sweep=[
                {"parameter": "/horizon/sampled_periods", "values": [20, 30]}])},
                      {"source": SLAB, "second_parameter": "/excitation/frequency_ratio"}):
            with self.assertRaises(rocking.InputError):
                rocking.orbits(**{"source": still, "longest": 1, "branches": True, **wrong})

    def test_table_and_plan_are_those_of_the_program(self):
        theirs = self.program("run", self.path, "-o", self.out, "--no-page", "-q")
        self.assertEqual(theirs, rocking.run(SLAB).table() + f"report: {self.out}/report.json\n")
        theirs = json.loads(self.program("run", self.path, "--dry-run", "--json", "-j", "1"))
        ours = rocking.plan(SLAB, threads=1)
        measured = {"seconds", "sampled_realisations", "sampled_share_of_horizon"}
        self.assertEqual({k: v for k, v in ours.data.items() if k not in measured},
                         {k: v for k, v in theirs.items() if k not in measured})
        self.assertGreater(ours.seconds, 0.0)

    def test_a_report_without_a_store_is_verified(self):
        self.program("run", self.path, "-o", self.out, "--no-page", "-q")
        os.remove(os.path.join(self.out, "realisations.sqlite"))
        theirs = json.loads(self.program("verify", self.out, "--json"))
        found = rocking.verify(self.out)
        self.assertEqual((found.checked, found.findings), (theirs["realisations_run_again"], theirs["findings"]))
        self.assertEqual(found.checked, 60)
        with self.assertRaises(ValueError):
            rocking.verify(self.out, sample=3)

    def test_motion_refuses_what_it_cannot_read(self):
        path = os.path.join(self.folder.name, "pulse.txt")
        with open(path, "w") as file:
            file.write("".join(f"{0.01 * i} {4 * np.sin(0.3 * i)}\n" for i in range(200)))
        with self.assertRaises(rocking.InputError):
            rocking.motion(path, units="ft")
        with self.assertRaises(FileNotFoundError):
            rocking.motion(path + ".none")
        for wrong in ({"files": 3}, {"files": [3]}, {"vertical": 3}, {"format": None}, {"format": 3}, {"units": b"g "[0]},
                      {"units": ["g"]}, {"gravity": [1]}, {"damping": {}}, {"periods": 3},
                      {"periods": [None]}, {"block": 3}, {"block": (None, 1)}):
            with self.assertRaises((TypeError, ValueError), msg=wrong):
                rocking.motion(**{"files": path, **wrong})
        for wrong in ({"block": (1, 2, 3)}, {"time_step": 0.0}, {"block": ()}, {"periods": ["a"]}, {"gravity": "g"}):
            with self.assertRaises(ValueError, msg=wrong):
                rocking.motion(**{"files": path, **wrong})

    def test_fragility_is_that_of_the_program(self):
        self.program("run", self.path, "-o", self.out, "--no-page", "-q")
        theirs = json.loads(self.program("fragility", self.out, "--json"))["curves"][0]
        for source in (SLAB, self.out, rocking.run(SLAB)):
            self.assertEqual(rocking.fragility(source).data["curves"][0], theirs)
        hazard = os.path.join(self.folder.name, "hazard.csv")
        with open(hazard, "w") as file:
            file.write("amplitude,rate\n0.5,1e-2\n20,1e-4\n")
        theirs = json.loads(self.program("fragility", self.out, "--peak-tilt", "0.5", "--hazard", hazard, "--json"))
        ours = rocking.fragility(self.out, peak_tilts=[0.5], hazard=hazard)
        self.assertEqual(ours.data, theirs)
        self.assertEqual(len(ours.curves), 2)
        self.assertEqual([curve.annual_rate.data for curve in ours.curves], [c["annual_rate"] for c in theirs["curves"]])
        self.assertEqual(ours.curves[1].event.peak_tilt, 0.5)
        probabilities = os.path.join(self.folder.name, "poe.csv")
        with open(probabilities, "w") as file:
            file.write(f"0.5,{-math.expm1(-0.5)!r}\n20,{-math.expm1(-0.005)!r}\n")
        ours = rocking.fragility(self.out, hazard=probabilities, years=50, imt="amplitude")
        self.assertAlmostEqual(ours.curves[0].annual_rate.value, theirs["curves"][0]["annual_rate"]["value"], 12)
        for wrong in ({}, {"years": 50}, {"imt": "amplitude", "years": 0}):
            with self.assertRaises(rocking.InputError):
                rocking.fragility(self.out, hazard=probabilities, **wrong)
        with self.assertRaises(ValueError):
            rocking.fragility(self.out, years=50)
        with open(hazard, "w") as file:
            file.write("pga_g,rate\n0.5,1e-2\n20,1e-4\n")
        for wrong in ({"hazard": hazard}, {"peak_tilts": [0.0]}):
            with self.assertRaises(rocking.InputError):
                rocking.fragility(self.out, **wrong)
        with self.assertRaises(FileNotFoundError):
            rocking.fragility(self.out, hazard="/nowhere/hazard.csv")

    def test_fragility_of_a_suite_is_that_of_the_program(self):
        self.program("run", suite_in(self.folder.name), "-o", self.out, "--no-page", "-q")
        theirs = json.loads(self.program("fragility", self.out, "--ida", "--json"))
        told = []
        for source in (self.out, rocking.open_run(self.out)):
            ours = rocking.fragility(source, incremental=True, progress=lambda *numbers: told.append(numbers))
            self.assertEqual(ours.data, theirs)
        curve, = ours.curves
        self.assertIsInstance(curve, rocking.documents.SuiteFragility)
        self.assertEqual(curve.levels.column("realisations").tolist(), [32] * 4)
        self.assertEqual(told[-1][0], told[-1][1])

    def test_sheet_of_a_suite_is_that_of_the_program(self):
        hazard = os.path.join(self.folder.name, "hazard.csv")
        with open(hazard, "w", encoding="utf-8") as file:
            file.write("pga_g, annual_rate\n0.1, 1e-2\n10, 1e-5\n")
        self.program("run", suite_in(self.folder.name), "-o", self.out, "--no-page", "-q")
        ours, theirs = os.path.join(self.folder.name, "ours.html"), os.path.join(self.folder.name, "theirs.html")
        self.program("fragility", self.out, "--hazard", hazard, "--sheet", theirs, "-q")
        self.assertEqual([path.name for path in rocking.write_sheet(self.out, ours, hazard=hazard).files], ["ours.html"])
        texts = []
        for path in (ours, theirs):
            with open(path, encoding="utf-8") as file:
                texts.append(file.read().partition("Made by")[0])
        self.assertEqual(*texts)

    def test_comparison_is_that_of_the_program(self):
        softer = changed(sweep=[{"parameter": "/excitation/amplitude", "values": [0.5, 8.0, 4.0]}])
        folders = [os.path.join(self.folder.name, name) for name in ("first", "second")]
        for experiment, folder in zip((SLAB, softer), folders):
            rocking.run(experiment, folder=folder)
        theirs = json.loads(self.program("compare", *folders, "--json"))
        self.assertGreater(sum(condition["changed"]["count"] for condition in theirs["conditions"]), 0)
        for first, second in (folders, (rocking.run(SLAB), rocking.run(softer))):
            ours = rocking.compare(first, second)
            self.assertEqual(ours.data, theirs)
            for one, other in zip(ours.conditions, theirs["conditions"]):
                self.assertEqual(one.changed.count, other["changed"]["count"])
                for name, mode in one.modes.items():
                    self.assertEqual(mode.mcnemar_p_value, other["modes"][name]["mcnemar_p_value"])

    def test_cost_is_that_of_the_program(self):
        asked = ["--sample", "4", "--tolerances", "1e-5,1e-8,1e-14"]
        theirs = json.loads(self.program("cost", self.path, *asked, "--json", "-q"))
        told = []
        ours = rocking.cost(self.path, sample=4, tolerances=[1e-5, 1e-8, 1e-14], seconds=0.1,
                            progress=lambda done, all: told.append(done))
        self.assertEqual(told[-1], 4)
        for key in ("format", "input", "result"):
            self.assertEqual(ours.data[key], theirs[key], key)
        self.assertEqual(set(ours.data["system"]), set(theirs["system"]))
        self.assertEqual(ours.result.sample.realisations, 4)
        curve = theirs["result"]["tolerances"]
        errors = ours.result.tolerances.column("departure.error.median")
        self.assertEqual(errors[:-1].tolist(), [entry["departure"]["error"]["median"] for entry in curve[:-1]])
        self.assertTrue(np.isnan(errors[-1]))
        self.assertTrue((ours.system.processor_s_per_period > 0).all())

    def test_cost_ends_when_its_time_is_up(self):
        found = rocking.cost(LONG, seconds=0.5, tolerances=[1e-5, 1e-14], threads=1)
        self.assertTrue(1 <= found.result.sample.realisations < 100000)

    def test_parts_merge_to_the_whole(self):
        parts = [os.path.join(self.folder.name, f"part{i}") for i in (1, 2, 3)]
        self.program("run", self.path, "--shard", "1/3", "-o", parts[0], "--no-page", "-q")
        for i in (2, 3):
            part = rocking.run(SLAB, shard=(i, 3), folder=parts[i - 1])
            self.assertEqual(part.done, part.all)
            self.assertFalse(part.is_complete)
            with self.assertRaises(ValueError):
                part.probabilities
        self.assertEqual(sum(rocking.open_run(part).done for part in parts), 60)
        by_program = os.path.join(self.folder.name, "whole")
        self.program("merge", by_program, *parts, "--no-page", "-q")
        with open(os.path.join(by_program, "report.json")) as file:
            digest = json.load(file)["result"]["digest"]
        whole = rocking.merge(self.out, parts)
        self.assertEqual(whole.digest, digest)
        self.assertEqual(whole.digest, rocking.run(SLAB).digest)
        self.assertEqual(sorted(os.listdir(self.out)), ["realisations.sqlite"])
        self.assertIn("60 of 60", self.program("status", self.out))

    def test_missing_parts_are_run_by_the_next_call(self):
        part = os.path.join(self.folder.name, "part")
        rocking.run(SLAB, shard=(1, 4), folder=part)
        whole = rocking.merge(self.out, [part])
        self.assertTrue(0 < whole.done < whole.all)
        self.assertFalse(whole.is_complete)
        self.assertEqual(rocking.run(SLAB, folder=self.out).digest, rocking.run(SLAB).digest)

    def test_intervals_are_those_of_the_report(self):
        for condition in rocking.run(SLAB).report().data["result"]["conditions"]:
            for name, found in condition["probabilities"].items():
                k, n = condition["counts"].get(name, 0), condition["realisations"]
                for method in ("clopper_pearson", "wilson"):
                    self.assertEqual(getattr(rocking, method)(k, n).tolist(), found[method], (name, method))
        table = rocking.wilson(np.array([[0], [3]]), [4, 5, 6], confidence=0.5)
        self.assertEqual(table.shape, (2, 3, 2))
        self.assertEqual(table[1, 2].tolist(), rocking.wilson(3, 6, 0.5).tolist())
        self.assertEqual(rocking.clopper_pearson([], []).shape, (0, 2))

    def test_colours_are_those_of_the_figures(self):
        self.program("run", self.path, "-o", self.out, "--no-page", "-q")
        self.program("report", self.out, "--format", "gnuplot")
        with open(os.path.join(self.out, "figures", "mode_bands.gp")) as file:
            drawn = file.read()
        result = rocking.run(SLAB)
        occurred = [mode for mode, count in zip(result.modes, result.counts.sum(axis=0)) if count]
        self.assertGreater(len(occurred), 1)
        for mode in occurred:
            self.assertTrue(f"fc rgb '{rocking.colour(mode)}' fs transparent solid 1" in drawn, mode)
        with self.assertRaises(ValueError):
            rocking.colour("(1;1)")

    def test_verification_is_that_of_the_program(self):
        self.program("run", self.path, "-o", self.out, "--no-page", "-q")
        for source in (self.out, rocking.run(SLAB)):
            told = []
            found = rocking.verify(source, progress=lambda done, all: told.append((done, all)))
            self.assertTrue(found.is_verified)
            self.assertEqual((found.checked, found.different), (60, 0))
            self.assertEqual(told[-1][0], told[-1][1])
        self.assertLess(rocking.verify(self.out, sample=4).checked, 10)
        report = os.path.join(self.out, "report.json")
        with open(report) as file:
            text = file.read()
        with open(report, "w") as file:
            file.write(re.sub(r'("estimate": ?)[0-9.]+', r"\g<1>0.125", text, count=1))
        found = rocking.verify(self.out, sample=2)
        self.assertEqual((found.different, len(found.findings)), (0, 1))
        self.assertIn("estimate", found.findings[0])

    def test_other_bits_are_found(self):
        run = rocking.run(SLAB)
        falsified = rocking.Result(rocking.experiment(SLAB, seed=2), run._core, run._provenance, None)
        found = rocking.verify(falsified)
        self.assertEqual((found.checked, found.is_verified), (60, False))
        # Of blocks that never move the digest is the same with either seed; verify compares the whole row.
        different = 0
        for condition in range(3):
            for realisation in range(20):
                try:
                    rocking.replay(falsified, condition=condition, realisation=realisation)
                except rocking.DifferentBits:
                    different += 1
        rest = int(run.counts[:, list(run.modes).index("rest")].sum())
        self.assertEqual((rest, different), (20, 60 - rest))
        self.assertTrue(different <= found.different <= 60)
        self.assertIn("condition 0, realisation 0: the new result differs", found.findings[0])
        with self.assertRaises(rocking.DifferentBits):
            rocking.replay(falsified, condition=1, realisation=3)

    def test_replay_is_that_of_the_program(self):
        self.program("run", self.path, "-o", self.out, "--no-page", "-q")
        theirs = self.program("replay", self.out, "--condition", "1", "--realisation", "3")
        for source in (self.out, rocking.run(SLAB)):
            self.assertEqual(rocking.replay(source, condition=1, realisation=3).text(), theirs)
        for form in ("json", "csv"):
            for units in ("normalised", "si"):
                asked = ["--condition", "1", "--realisation", "3", "--samples", "4", "--format", form, "--units", units]
                motion = rocking.trajectory(self.path, condition=1, realisation=3, samples_per_period=4)
                self.assertEqual(motion.text(form, units), self.program("trajectory", self.path, *asked))
        with self.assertRaises(rocking.InputError):
            rocking.replay(self.out, realisation=20)

    def test_progress_is_told_to_its_end(self):
        for study, is_known in (
                (lambda progress: rocking.bifurcation(SLAB, progress=progress), True),
                (lambda progress: rocking.verify(rocking.run(SLAB), progress=progress), True),
                (lambda progress: rocking.rare(SLAB, peak_tilt=0.3, particles=50, relative_error=0.5, progress=progress),
                 False)):
            told = []
            study(lambda done, all: told.append((done, all)))
            self.assertTrue(all(done <= every for done, every in told))
            self.assertEqual(told, sorted(told, key=lambda pair: pair[0]))
            self.assertTrue(not is_known or told[-1][0] == told[-1][1])

    def test_doctor_is_that_of_the_program(self):
        theirs = json.loads(self.program("doctor", "--json"))
        ours = rocking.doctor()
        self.assertEqual({key: theirs[key] for key in ours}, ours)
        self.assertEqual(set(theirs) - set(ours), {"machine", "system", "supported_systems", "lanes"})

    def test_a_run_in_progress_can_be_looked_at(self):
        running = subprocess.Popen([PROGRAM, "run", write(self.folder.name, LONG), "-o", self.out, "--no-page", "-q",
                                    "-j", "1", "--realisations", "1000000"])
        self.addCleanup(running.wait)
        self.addCleanup(running.kill)
        store = os.path.join(self.out, "realisations.sqlite")
        done = 0
        while done == 0 and running.poll() is None:
            time.sleep(0.1)
            if os.path.exists(store) and os.path.getsize(store):
                done = rocking.open_run(self.out).done
        self.assertIsNone(running.poll(), "it is in progress")
        self.assertTrue(0 < done < 1000000)

    def test_validate_is_that_of_the_program(self):
        theirs = json.loads(self.program("validate", self.path, "--json"))
        self.assertEqual(rocking.validate(self.path), theirs["experiment"])


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
        self.program("report", self.out, "--format", "gnuplot", "--style", "journal", "--width", "double")
        written = rocking.write_figures(self.out, self.ours, column="journal_double")
        self.expect_same(written.files, os.path.join(self.out, "figures"))
        with self.assertRaises(ValueError):
            rocking.write_figures(self.out, self.ours, column="wide")

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
        self.program("figure", file, "-o", self.out)
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
        self.assertEqual({path.suffix for path in written.files}, {".tsv", ".gp", ".py"})

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

    def test_survives_pickling(self):
        with self.assertRaises(rocking.InputError) as caught:
            rocking.validate(changed(restitution=7))
        again = pickle.loads(pickle.dumps(caught.exception))
        self.assertEqual(again.problems, caught.exception.problems)

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


def suite_in(folder):
    """Four sines of different frequency; the path of the experiment."""
    for k in range(4):
        with open(os.path.join(folder, f"r{k}.txt"), "w") as file:
            file.write("".join(f"{0.02 * i} {3 * np.sin((3 + 1.5 * k) * 0.02 * i)}\n" for i in range(150)))
    path = os.path.join(folder, "suite.json")
    with open(path, "w") as file:
        json.dump({"format": "rocking.experiment/1", "block": {"width_m": 0.35, "height_m": 1.6},
                   "excitation": {"kind": "recorded", "suite": "r*.txt", "format": "columns", "units": "m/s2"},
                   "fluctuation": {"restitution": {"sigma": 0.05}},
                   "sweep": [{"parameter": "/excitation/pga_g", "values": [0.2, 0.3, 0.5, 0.8]}],
                   "realisations": 8, "seed": "0x1"}, file)
    return path


LONG = changed(realisations=100000, sweep=[{"parameter": "/excitation/amplitude", "values": [4.0]}])


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
                rocking.fragility(result, peak_tilts=np.linspace(0.001, 0.9, 200), threads=1, progress=interrupt)

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
                     lambda: rocking.orbits(several, longest=1, threads=1, progress=interrupt)):
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
                         lambda: rocking.trajectory(SLAB, condition=1, samples_per_period=2, **long),
                         lambda: rocking.replay(result, condition=1, **long),
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
                        self.assertRegex(str(error), "is working in this folder|realisations of another experiment")

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
                      lambda: rocking.orbits(still, longest=2, progress=tell),
                      lambda: rocking.bifurcation(SLAB, progress=tell), lambda: rocking.verify(result, progress=tell)):
            with self.assertRaises(Enough):
                study()
        self.assertEqual(rocking.run(SLAB).digest, result.digest)

    def test_a_forked_process_computes_the_same(self):
        digest = rocking.run(SLAB).digest
        with multiprocessing.get_context("fork").Pool(2) as pool:
            self.assertEqual(pool.map(digest_with_seed, ["0x1", "0x1"]), [digest] * 2)

    def test_other_threads_go_on_meanwhile(self):
        ticks = []
        over = threading.Event()

        def tick():
            while not over.wait(0.01):
                ticks.append(None)

        thread = threading.Thread(target=tick)
        thread.start()
        rocking.run(changed(realisations=1000), threads=1)
        over.set()
        thread.join()
        self.assertGreater(len(ticks), 3)

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
