"""Tests of the Python module: whatever a study is asked, it answers or raises InputError.

Environment: ROCKING_CALLS, how often each study is asked (300; before a release 3000).
"""

import inspect
import os
import pathlib
import random
import tempfile
import unittest
import warnings

import numpy as np

import rocking
from slab import SLAB, changed, suite_in

CALLS = int(os.environ.get("ROCKING_CALLS", "300"))

TINY = changed(horizon={"transient_periods": 1, "sampled_periods": 2}, realisations=4)
STILL = changed(horizon={"transient_periods": 1, "sampled_periods": 2}, realisations=1,
                excitation={"kind": "harmonic", "amplitude": 3.9, "frequency_ratio": 10.0},
                sweep=[{"parameter": "/excitation/amplitude", "values": [3.9, 4.0]}])
UNKNOWN = {**TINY, "unknown": [{"parameter": "/restitution", "from": 0.8, "to": 0.95}]}

WRONG = [None, (), [], {}, "", "x", "\0", b"x", 0, -1, 1.5, 10**400, float("nan"), float("inf"), True, False, [None], [[1]],
         ["x"], [1, 2, 3], (0.5, 0.5), {"a": 1}, {"a": [1, 2], "b": [1]}, [{"a": 1}, {"b": 2}], object(), max, {1, 2},
         np.array([]), np.arange(3.0), np.float32(2.0), np.datetime64("2026-11-28"), 1j, pathlib.Path("nowhere"),
         range(3)]


class EveryStudy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.addClassCleanup(os.chdir, os.getcwd())
        os.chdir(cls.folder.name)
        suite = rocking.run(suite_in(cls.folder.name))
        run = rocking.run(TINY)
        part = rocking.run(TINY, shard=(1, 2))
        hazard = {"amplitude": [0.5, 20.0], "annual_rate": [1e-2, 1e-4]}
        of_suite = {"pga_g": [0.1, 0.9], "annual_rate": [1e-2, 1e-4]}
        cells = {"pga_g": [0.3, 0.5], "sa_p_g": [0.3, 0.4], "annual_rate": [1e-3, 1e-4]}
        motion = os.path.join(cls.folder.name, "r0.txt")
        cls.sensible = {
            "fragility": {"source": [run, suite, [run], [suite, suite], [run, suite], [], part, TINY],
                          "hazard": [hazard, of_suite, [of_suite, of_suite]], "event": ["overturning", "tilt > 0.5", ["tilt > 0.3 psi", "tilt > 0.6 psi"]],
                          "years": [50, [1, 50]], "survived": [100.0], "ida": [True],
                          "imt": ["PGA"], "site": [(10, 45)], "statistic": ["mean"], "joint_hazard": [cells],
                          "surface": [["pga_g", "sa_p_g"], ["pga_g"]]},
            "compare": {"first": [run, TINY, part], "second": [run, suite]},
            "bifurcation": {"source": [STILL, TINY], "realisation": [0, 3]},
            "orbits": {"source": [STILL], "periods": [1], "no_branches": [True], "from": [3.9], "to": [4.0]},
            "threshold": {"source": [STILL, TINY], "of": ["/excitation/amplitude", "/block"], "from": [1.0], "to": [2.0, 20.0],
                          "steps": [3], "accuracy": [0.01], "event": ["tilt > 0.5 psi"]},
            "rare": {"source": [TINY], "particles": [20], "max_time": [1e-3], "realisations": [2], "event": ["tilt > 0.5 psi"]},
            "infer": {"source": [UNKNOWN], "tests": [{"amplitude": [4.0], "overturned": [1], "other": [4]}],
                      "candidates": [{"amplitude": [6.0]}], "max_time": [1e-3], "realisations": [2]},
            "cost": {"source": [TINY], "sample": [1], "max_time": [1e-3], "tolerances": [[1e-8, 1e-11, 1e-14]]},
            "motion": {"files": [motion, [motion]], "units": ["g", "m/s2"], "columns": [["time", "horizontal"]],
                       "block": [(1.0, 4.0)], "periods": [[0.5, 1.0]], "time_step": [0.01], "format": ["columns"]},
            "check_normal": {"n": [20, 100], "mean": [0.4], "sigma": [0.03], "seed": [7, "0x2012"], "law": ["uniform"]},
        }

    #: Without these a study takes its time.
    ALWAYS = {"cost": ["sample"], "rare": ["max_time", "particles"], "infer": ["max_time", "realisations"]}

    def arguments(self, study, draw):
        sensible = self.sensible[study]
        arguments = {}
        # Most calls have one or two faults, so that what comes behind them is reached.
        is_wrong = draw.choice([0.02, 0.3, 0.9])
        is_given = draw.choice([0.1, 0.5])
        for name, parameter in inspect.signature(getattr(rocking, study)).parameters.items():
            must = parameter.default is inspect.Parameter.empty or name in self.ALWAYS.get(study, [])
            if not must and draw.random() > is_given:
                continue
            known = sensible.get(name.rstrip("_"), [])
            is_sensible = known and draw.random() > is_wrong
            given = draw.choice(known) if is_sensible else draw.choice(WRONG)
            if given is not None or name not in self.ALWAYS.get(study, []):
                arguments[name] = given
            else:
                arguments[name] = draw.choice(known)
        return arguments

    def test_answers_or_refuses_whatever_it_is_asked(self):
        self.assertEqual(sorted(self.sensible), sorted(rocking.studies.__all__))
        for study in rocking.studies.__all__:
            draw = random.Random(study)
            answered = 0
            for call in range(CALLS):
                arguments = self.arguments(study, draw)
                with self.subTest(study=study, call=call, arguments=arguments), warnings.catch_warnings():
                    warnings.simplefilter("ignore")
                    try:
                        getattr(rocking, study)(**arguments)
                        answered += 1
                    except rocking.InputError as error:
                        self.assertTrue(error.problems)
                    except OSError as error:  # a path to nowhere
                        self.assertIsNotNone(error.errno, error)
            self.assertGreater(answered, 0, study)

    def test_names_the_argument_that_is_wrong(self):
        run = self.sensible["fragility"]["source"][0]
        hazard = self.sensible["fragility"]["hazard"][0]
        for asked, place in ((dict(joint_hazard={}), "joint_hazard"), (dict(survived=100.0), "survived"),
                             (dict(hazard=[]), "hazard"), (dict(event="much"), "event/0"),
                             (dict(hazard=hazard, years=[None]), "years/0"), (dict(threads="two"), "threads"),
                             (dict(hazard=5), "hazard"), (dict(progress=1), "progress")):
            with self.assertRaises(rocking.InputError, msg=asked) as raised:
                rocking.fragility(run, **asked)
            self.assertEqual(raised.exception.pointer, place)
        for asked in ({}, dict(hazard=hazard, survived=100.0)):
            with self.assertRaisesRegex(rocking.InputError, "source = 0 runs: must be at least one run"):
                rocking.fragility([], **asked)


if __name__ == "__main__":
    unittest.main()
