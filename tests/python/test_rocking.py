"""Tests of the Python module: the same bits as the program."""

import contextlib
import copy
import io
import json
import math
import os
import pickle
import re
import tempfile
import unittest

import numpy as np

import rocking
from slab import LONG, SLAB, ProgramTest, changed, write


class AgainstTheProgram(ProgramTest):
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
        self.assertIn("60 of 60", self.program("run", "--status", self.out))
        self.program("resume", self.out, "--no-page", "-q")
        with open(os.path.join(self.out, "report.json")) as file:
            self.assertEqual(json.load(file)["result"]["digest"], by_module.digest)
        self.assertEqual(rocking.open_run(self.out).digest, by_module.digest)

    def test_trajectory_is_that_of_the_program(self):
        theirs = json.loads(self.program("trajectory", self.path, "--condition", "1", "--realisation", "3"))
        ours = rocking.trajectory(self.path, condition=1, realisation=3, samples=4)
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
             lambda: rocking.orbits(still, periods=1, no_branches=True)),
            (["orbits", still, "--periods", "1", "--from", "3.8"], "orbits.json",
             lambda: rocking.orbits(still, periods=1, from_=3.8)),
            (["bifurcation", self.path, "--realisation", "2"], "bifurcation.json",
             lambda: rocking.bifurcation(self.path, realisation=2)),
            (["rare", self.path, "--event", "tilt > 0.3 psi", "--particles", "50", "--relative-error", "0.5"],
             "rare.json", lambda: rocking.rare(self.path, event="tilt > 0.3 psi", particles=50, relative_error=0.5)),
            (["infer", counted, "--tests", tests, "--candidates", candidates, "--next-tests", "3"], "infer.json",
             lambda: rocking.infer(counted, tests, candidates=candidates, next_tests=3)),
            (["fragility", first, "--event", "tilt > 0.5 psi", "--ida", "--json"], None,
             lambda: rocking.fragility(first, event="tilt > 0.5 psi", ida=True)),
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
                self.assertEqual(study().json, theirs)

    def test_orbits_without_branches_have_none(self):
        still = changed(excitation={"kind": "harmonic", "amplitude": 4.0, "frequency_ratio": 10.0},
                        sweep=[{"parameter": "/excitation/amplitude", "values": [3.9, 4.0]}])
        self.assertIsNone(rocking.orbits(still, periods=1, no_branches=True).branches)
        periods = [{"parameter": "/horizon/sampled_periods", "values": [20, 30]}]
        for wrong in ({"from_": 4.0, "to": 3.0},
                      {"source": changed(excitation=still["excitation"], sweep=periods), "from_": 20}):
            with self.assertRaises(rocking.InputError):
                rocking.orbits(**{"source": still, "periods": 1, **wrong})

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
        one, list_of_one = (rocking.motion(path, units="m/s2", periods=given) for given in (0.5, [0.5]))
        self.assertEqual(one.json, list_of_one.json)
        with self.assertRaises(rocking.InputError):
            rocking.motion(path, units="ft")
        with self.assertRaises(FileNotFoundError):
            rocking.motion(path + ".none")
        for wrong in ({"files": 3}, {"files": [3]}, {"vertical": 3}, {"format": None}, {"format": 3}, {"units": b"g "[0]},
                      {"units": ["g"]}, {"gravity": [1]}, {"damping": {}},
                      {"periods": [None]}, {"block": 3}, {"block": (None, 1)}):
            with self.assertRaises((TypeError, ValueError), msg=wrong):
                rocking.motion(**{"files": path, **wrong})
        for wrong in ({"block": (1, 2, 3)}, {"time_step": 0.0}, {"block": ()}, {"periods": ["a"]}, {"gravity": "g"}):
            with self.assertRaises(ValueError, msg=wrong):
                rocking.motion(**{"files": path, **wrong})

    def test_motion_gives_the_samples_as_arrays(self):
        path = os.path.join(self.folder.name, "three.txt")
        with open(path, "w") as file:
            file.write("".join(f"{0.01 * i:.2f} {0.4 * np.sin(0.3 * i)} {0.1 * np.cos(0.3 * i)}\n" for i in range(200)))
        columns = ["time", "horizontal", "vertical"]
        series = rocking.motion(path, units="g", columns=columns).motions[0].series
        np.testing.assert_allclose(series.time_s, 0.01 * np.arange(200), rtol=1e-15)
        np.testing.assert_allclose(series.acceleration_g, 0.4 * np.sin(0.3 * np.arange(200)), rtol=1e-15)
        np.testing.assert_allclose(series.vertical_g, 0.1 * np.cos(0.3 * np.arange(200)), rtol=1e-15)
        self.assertIsNone(rocking.motion(path, units="g", columns=columns, series=False).motions[0].series)

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
        ours = rocking.cost(self.path, sample=4, tolerances=[1e-5, 1e-8, 1e-14],
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
        found = rocking.cost(LONG, max_time=0.5, tolerances=[1e-5, 1e-14], threads=1)
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
        whole = rocking.resume(self.out, parts)
        self.assertEqual(whole.digest, digest)
        self.assertEqual(whole.digest, rocking.run(SLAB).digest)
        self.assertEqual(sorted(os.listdir(self.out)), ["realisations.sqlite"])
        self.assertIn("60 of 60", self.program("run", "--status", self.out))

    def test_missing_parts_are_run_by_the_next_call(self):
        part = os.path.join(self.folder.name, "part")
        rocking.run(SLAB, shard=(1, 4), folder=part)
        whole = rocking.resume(self.out, [part])
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
        self.program("report", self.out, "--format", "gnuplot", "--pictures", "gp")
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
                    rocking.trajectory(falsified, condition=condition, realisation=realisation)
                except rocking.DifferentBits:
                    different += 1
        rest = int(run.counts[:, list(run.modes).index("rest")].sum())
        self.assertEqual((rest, different), (20, 60 - rest))
        self.assertTrue(different <= found.different <= 60)
        self.assertIn("condition 0, realisation 0: the new result differs", found.findings[0])
        with self.assertRaises(rocking.DifferentBits):
            rocking.trajectory(falsified, condition=1, realisation=3)

    def test_replay_is_that_of_the_program(self):
        self.program("run", self.path, "-o", self.out, "--no-page", "-q")
        theirs = self.program("trajectory", self.out, "--condition", "1", "--realisation", "3")
        for source in (self.out, rocking.run(SLAB)):
            self.assertEqual(rocking.trajectory(source, condition=1, realisation=3).text(), theirs)
        for form in ("json", "csv"):
            for units in ("normalised", "si"):
                asked = ["--condition", "1", "--realisation", "3", "--samples", "4", "--format", form, "--units", units]
                motion = rocking.trajectory(self.path, condition=1, realisation=3, samples=4)
                self.assertEqual(motion.text(form, units), self.program("trajectory", self.path, *asked))
        with self.assertRaises(rocking.InputError):
            rocking.trajectory(self.out, realisation=20)

    def test_progress_is_told_to_its_end(self):
        for study, is_known in (
                (lambda progress: rocking.bifurcation(SLAB, progress=progress), True),
                (lambda progress: rocking.verify(rocking.run(SLAB), progress=progress), True),
                (lambda progress: rocking.rare(SLAB, event="tilt > 0.3 psi", particles=50, relative_error=0.5, progress=progress),
                 False)):
            told = []
            study(lambda done, all: told.append((done, all)))
            self.assertTrue(all(done <= every for done, every in told))
            self.assertEqual(told, sorted(told, key=lambda pair: pair[0]))
            self.assertTrue(not is_known or told[-1][0] == told[-1][1])

    def test_show_progress_ends_its_line_with_the_last_realisation(self):
        shown = io.StringIO()
        with contextlib.redirect_stdout(shown):
            rocking.run(SLAB, progress=rocking.show_progress)
        lines = shown.getvalue().split("\n")
        self.assertEqual((len(lines), lines[-1]), (2, ""))
        self.assertTrue(lines[0].endswith(f"[{'#' * 20}] 60 of 60"), lines[0][-60:])

    def test_a_range_is_a_list_of_values(self):
        swept = {**SLAB, "sweep": [{"parameter": "/excitation/amplitude", "values": range(2, 5)}]}
        self.assertEqual([rocking.experiment(swept).parameters(i)["/excitation/amplitude"] for i in range(3)], [2, 3, 4])

    def test_studies_say_what_the_program_prints(self):
        found = rocking.check_normal(500)
        self.assertEqual(found.table(), self.program("check-normal", "--n", "500"))
        amplitudes = changed(sweep=[{"parameter": "/excitation/amplitude", "values": [1.5, 2.0, 3.0]}], title="three")
        found = rocking.fragility(amplitudes)
        self.assertIn("\nthree\n", found.table())
        self.assertIn("no function is fitted", found.table())
        with self.assertRaisesRegex(AttributeError, "use json"):
            found.text

    def test_every_study_answers_in_one_sentence(self):
        still = changed(sweep=[{"parameter": "/excitation/amplitude", "values": [2.0, 4.0]}],
                        excitation={"kind": "harmonic", "amplitude": 2.0, "frequency_ratio": 10.0})
        slab = {key: value for key, value in SLAB.items() if key != "sweep"}
        pulse = {**slab, "excitation": {"kind": "pulse", "shape": "sine", "amplitude": 1.0, "frequency_ratio": 5.0}}
        run, other = rocking.run(SLAB), rocking.run(changed(restitution=0.5))
        record = os.path.join(self.folder.name, "a.txt")
        with open(record, "w") as file:
            file.write("0 0\n0.5 4.905\n1 0\n")
        unknown = {**slab, "unknown": [{"parameter": "/restitution", "from": 0.8, "to": 0.95}]}
        tests = {"amplitude": [4.0], "overturned": [0], "other": [5]}
        for found, words in (
            (rocking.bifurcation(still), r"From each start the response is the same, at all of 2 values"),
            (rocking.check_normal(500), r"500 numbers from N.*: not refuted"),
            (rocking.compare(run, other), r"\d+ of 60 realisations changed their response mode"),
            (rocking.cost(SLAB, sample=3, tolerances=[1e-6, 1e-14]), r"(Tolerance|No tolerance) "),
            (rocking.fragility(run), r"The block overturned in 0\.0 % at A_h = 1 to "),
            (rocking.infer(unknown, tests), r"Restitution e: any value from 0\.8 to 0\.95, with 95 % confidence"),
            (rocking.motion(record, units="m/s2"), r"The ground motion .* has a PGA of 0\.5 g and a PGV of 2\.45 m/s"),
            (rocking.orbits(still, periods=1, no_branches=True), r"Several stable orbits coexist in \d of 2 conditions"),
            (rocking.rare(slab, event="tilt > 0.05 psi", particles=20, relative_error=1.0),
             r"The block tilts beyond 0\.05 psi \(0\.702 degrees\) within the horizon with a probability of [^ ]+ \["),
            (rocking.threshold(pulse, of="/excitation/amplitude", from_=1, to=10, steps=20), r"The block overturns from "),
        ):
            self.assertRegex(found.answer, f"^{words}[^\n]*\\.$")
            self.assertNotRegex(found.answer, r"\.[ .]")
            self.assertTrue(found.table().lower().startswith(found.answer[:-1].lower()), found.answer)

    def test_doctor_is_that_of_the_program(self):
        theirs = json.loads(self.program("doctor", "--json"))
        ours = rocking.doctor()
        self.assertEqual({key: theirs[key] for key in ours}, ours)
        self.assertEqual(set(theirs) - set(ours), {"machine", "system", "supported_systems", "lanes"})

    def test_validate_is_that_of_the_program(self):
        theirs = json.loads(self.program("validate", self.path, "--json"))
        self.assertEqual(rocking.validate(self.path), theirs["experiment"])


if __name__ == "__main__":
    unittest.main()
