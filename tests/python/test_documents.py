"""Tests of the classes of documents: attributes, types and tables follow from the lists of fields.

Environment: ROCKING_SOURCE, the root of the clone.
"""

import os
import pickle
import shutil
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import rocking
from rocking import documents

SOURCE = os.environ["ROCKING_SOURCE"]

STILL = {
    "format": "rocking.experiment/1",
    "block": {"width_m": 1.0, "height_m": 4.0},
    "excitation": {"kind": "harmonic", "amplitude": 4.0, "frequency_ratio": 10.0},
    "restitution": 0.9,
    "horizon": {"transient_periods": 20, "sampled_periods": 20},
    "sweep": [{"parameter": "/excitation/amplitude", "values": [3.9, 4.0, 12.0]}],
    "seed": "0x1",
}
RANDOM = {
    **STILL,
    "excitation": {**STILL["excitation"], "phase_rad": {"uniform": [0.0, 6.28]}},
    "realisations": 20,
}
COUNTED = {
    **{key: value for key, value in RANDOM.items() if key != "sweep"},
    "unknown": [{"parameter": "/restitution", "from": 0.8, "to": 0.95}],
}


def counted_tests(folder):
    path = os.path.join(folder, "tests.csv")
    with open(path, "w") as file:
        file.write("amplitude,overturned,other\n4.0,1,4\n")
    return path


def pulse(folder):
    path = os.path.join(folder, "pulse.txt")
    with open(path, "w") as file:
        file.write("".join(f"{0.01 * i} {4 * np.sin(0.3 * i)}\n" for i in range(200)))
    return path


def of_every_study():
    run = rocking.run(RANDOM)
    with tempfile.TemporaryDirectory() as folder:
        return [
            run.report(),
            rocking.orbits(STILL, periods=1),
            rocking.bifurcation(STILL),
            rocking.fragility(run, event=["overturning", "tilt > 0.1 psi"], ida=True),
            rocking.compare(run, rocking.run({**RANDOM, "restitution": 0.5})),
            rocking.rare(RANDOM, event="tilt > 0.1 psi", particles=20, relative_error=1.0),
            rocking.cost(STILL, sample=1, tolerances=[1e-5, 1e-8, 1e-14]),
            rocking.motion(pulse(folder), units="m/s2", block=(1.0, 4.0), series=True),
            rocking.check_normal(100),
            rocking.infer(COUNTED, counted_tests(folder)),
            rocking.threshold(STILL, of="/excitation/amplitude", from_=1, to=20, steps=5),
        ]


def objects_in(value):
    """All objects with fields in a value, itself among them."""
    if isinstance(value, rocking.Fields):
        yield value
        for key in value.data:
            yield from objects_in(getattr(value, "from_" if key == "from" else key))
    elif isinstance(value, dict):
        for each in value.values():
            yield from objects_in(each)
    elif isinstance(value, list):
        for each in value:
            yield from objects_in(each)


class Documents(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.found = of_every_study()

    def test_have_an_attribute_for_each_key(self):
        for document in self.found:
            for each in objects_in(document):
                declared = type(each).__annotations__
                for key, value in each.data.items():
                    name = "from_" if key == "from" else key
                    self.assertIn(name, declared)
                    self.assertEqual(getattr(each, name) is None, value is None, f"{each} {name}")
                    self.assertIn(f"- ``{name}``: ", type(each).__doc__)
                    self.assertIn(name, dir(each))

    def test_have_attributes_of_the_declared_types(self):
        orbit = self.found[1].conditions[1].orbits[0]
        self.assertEqual((orbit.multipliers.dtype, orbit.points.shape), (complex, (orbit.period, 3)))
        self.assertEqual(list(orbit.multipliers[0:1]), [complex(*orbit.data["multipliers"][0])])
        branch = self.found[1].branches[0]
        self.assertEqual(branch.from_, branch.data["from"])
        estimate = self.found[5].conditions[0]
        self.assertEqual(estimate.interval, tuple(estimate.data["interval"]))
        condition = self.found[0].result.conditions[0]
        self.assertEqual(set(condition.probabilities), set(condition.data["probabilities"]))
        self.assertIsInstance(next(iter(condition.probabilities.values())), documents.Estimate)

    def test_lack_no_key_silently(self):
        state = documents.State({"tilt": 0.5})
        self.assertIsNone(state.tilt_rate)
        with self.assertRaises(AttributeError):
            state.tilts

    def test_are_tables(self):
        steps = self.found[2].diagrams[0].steps
        self.assertEqual(steps.column("value").tolist(), [step.value for step in steps])
        points = self.found[1].branches[0].points
        self.assertEqual(points.column("points").shape, (len(points), self.found[1].branches[0].period, 3))
        errors = self.found[6].result.tolerances.column("departure.error.median")
        self.assertEqual(np.isnan(errors).tolist(), [False] * (len(errors) - 1) + [True])
        try:
            import pandas  # noqa: F401
        except ImportError:
            self.skipTest("pandas was not found (Debian: python3-pandas)")
        self.assertEqual(self.found[3].curves[0].levels.to_pandas()["intensity"].tolist(), [3.9, 4.0, 12.0])

    def test_survive_pickling_and_compare_by_their_data(self):
        for document in self.found:
            self.assertEqual(pickle.loads(pickle.dumps(document)), document)
        self.assertNotEqual(self.found[1].conditions[0], self.found[1].conditions[1])

    def test_are_shown_in_notebooks(self):
        drawn = {type(document).__name__: document._repr_html_().count("<img") for document in self.found}
        page = self.found[3].curves[0].levels._repr_html_()
        self.assertEqual(page.count("<tr>"), 4)
        self.assertIn("<td>3.9</td>", page)
        if shutil.which("gnuplot") and hasattr(rocking._core, "draw"):
            self.assertTrue(all(drawn[name] for name in ("Orbits", "CostOfAccuracy", "GroundMotions", "Fragility")), drawn)
            self.assertIn("<img", rocking.run(RANDOM)._repr_html_())

    def test_have_types_that_a_strict_checker_accepts(self):
        if not shutil.which("mypy"):
            self.skipTest("mypy was not found (Debian: mypy)")
        with tempfile.TemporaryDirectory() as folder:
            for words, is_accepted in (("orbit.period + 1", True), ("orbit.periods", False), ("orbit.kind.real", False)):
                path = os.path.join(folder, "notebook.py")
                with open(path, "w") as file:
                    file.write("import rocking\n\n\ndef look(orbit: rocking.documents.Orbit) -> None:\n"
                               f"    print({words}, rocking.run('a.json').counts.sum())\n")
                checked = subprocess.run(["mypy", "--strict", "--ignore-missing-imports", "--cache-dir", folder, path],
                                         capture_output=True, text=True,
                                         env={**os.environ, "MYPYPATH": os.path.dirname(rocking.__path__[0])})
                self.assertEqual(checked.returncode == 0, is_accepted, checked.stdout + checked.stderr)
        self.assertTrue(os.path.exists(os.path.join(SOURCE, "lib/python/rocking/py.typed")))


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
