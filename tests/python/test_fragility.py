"""Tests of the Python module: hazard curves and fragility."""

import copy
import json
import math
import os
import pickle
import tempfile
import unittest

import numpy as np

import rocking
from slab import SLAB, ProgramTest, suite_in, write


class AgainstTheProgram(ProgramTest):
    def test_hazard_gives_the_curve_of_every_format(self):
        levels, probabilities = np.array([0.1, 0.2, 0.4]), np.array([0.3, 0.1, 0.02])

        def read(text, **asked):
            path = os.path.join(self.folder.name, "hazard.csv")
            with open(path, "w") as file:
                file.write(text)
            return rocking.hazard(path, **asked)

        words = ",".join(f"poe-{level}" for level in levels)
        two_sites = (f'#,,,,"generated_by=\'OpenQuake engine 3.16.2\', start_date=\'2023-02-03T10:00:00\', '
                     f"checksum=1, kind='mean', investigation_time=50.0, imt='PGA'\"\n"
                     f"lon,lat,depth,{words}\n10.0,45.0,0.0,0.3,0.1,0.02\n11.0,45.0,0.0,0.5,0.2,0.1\n")
        for curve in (read("pga_g, poe\n0.1, 0.3\n0.2, 0.1\n0.4, 0.02\n", years=50), read(two_sites, site=(10, 45))):
            self.assertEqual((curve.measure, curve.years, len(curve.intensity)), ("pga_g", 50.0, 3))
            np.testing.assert_array_equal(curve.intensity, levels)
            np.testing.assert_allclose(curve.annual_rate, -np.log1p(-probabilities) / 50.0, rtol=1e-14)
        self.assertEqual((curve.statistic, curve.site), ("mean", (10.0, 45.0)))
        self.assertEqual(read("0.1 1e-2\n0.4 5e-4\n", imt="SA(0.5)").measure, "sa_g[0.5]")
        for again in (pickle.loads(pickle.dumps(curve)), copy.deepcopy(curve)):
            self.assertEqual(repr(again), repr(curve))
            np.testing.assert_array_equal(again.annual_rate, curve.annual_rate)
        try:
            self.assertEqual(curve.to_xarray()["annual_rate"].dims, ("pga_g",))
            self.assertEqual(len(curve.to_pandas()), 3)
        except ImportError:
            self.skipTest("xarray was not found (Debian: python3-xarray)")

    def test_hazard_refuses_what_it_cannot_read(self):
        path = os.path.join(self.folder.name, "hazard.csv")
        with open(path, "w") as file:
            file.write("pga_g, annual_rate\n0.4, 1e-2\n0.1, 5e-4\n")
        with self.assertRaisesRegex(rocking.InputError, "hazard.csv, line 3"):
            rocking.hazard(path)
        with self.assertRaises(FileNotFoundError):
            rocking.hazard(path + ".none")
        with self.assertRaises(rocking.InputError):
            rocking.hazard(path, site=(1.0,))
        for wrong in ({"file": 3}, {"years": "a"}, {"site": "here"}, {"imt": 3}):
            with self.assertRaises((TypeError, ValueError), msg=wrong):
                rocking.hazard(**{"file": path, **wrong})

    def test_fragility_is_that_of_the_program(self):
        self.program("run", self.path, "-o", self.out, "--no-page", "-q")
        theirs = json.loads(self.program("fragility", self.out, "--json"))["curves"][0]
        for source in (SLAB, self.out, rocking.run(SLAB)):
            self.assertEqual(rocking.fragility(source).data["curves"][0], theirs)
        hazard = os.path.join(self.folder.name, "hazard.csv")
        with open(hazard, "w") as file:
            file.write("amplitude,rate\n0.5,1e-2\n20,1e-4\n")
        theirs = json.loads(self.program("fragility", self.out, "--event", "overturning,tilt > 0.5 psi", "--hazard", hazard, "--json"))
        ours = rocking.fragility(self.out, event=["overturning", "tilt > 0.5 psi"], hazard=hazard)
        self.assertEqual(ours.data, theirs)
        self.assertEqual(len(ours.curves), 2)
        self.assertEqual([curve.annual_rate.data for curve in ours.curves], [c["annual_rate"] for c in theirs["curves"]])
        self.assertEqual(ours.curves[1].event.peak_tilt, 0.5)
        self.assertEqual(rocking.fragility(self.out, event="tilt > 0.5 psi").data["curves"][0]["event"], {"peak_tilt": 0.5})
        still = rocking.fragility(self.out, hazard=[hazard, hazard], years=[1, 50], survived=100)
        rate = still.curves[0].annual_rate
        self.assertEqual([each.years for each in rate.in_years], [1, 50])
        with self.assertRaisesRegex(AttributeError, "jackknife.*use interval"):
            rate.jackknife
        self.assertAlmostEqual(rate.in_years[1].probability, -math.expm1(-50 * rate.value), 12)
        self.assertAlmostEqual(still.survival.branches[1].all.probability, math.exp(-100 * rate.value), 12)
        self.assertEqual([branch.weight for branch in still.survival.branches], [0.5, 0.5])
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
        for wrong in ({"hazard": hazard}, {"event": "tilt > 2 psi"}, {"event": "slip > 0.05"}, {"event": "slip > 0.05 m"}):
            with self.assertRaises(rocking.InputError):
                rocking.fragility(self.out, **wrong)
        with self.assertRaises(FileNotFoundError):
            rocking.fragility(self.out, hazard="/nowhere/hazard.csv")

    def test_fragility_of_a_suite_is_that_of_the_program(self):
        self.program("run", suite_in(self.folder.name), "-o", self.out, "--no-page", "-q")
        theirs = json.loads(self.program("fragility", self.out, "--ida", "--json"))
        told = []
        for source in (self.out, rocking.open_run(self.out)):
            ours = rocking.fragility(source, ida=True, progress=lambda *numbers: told.append(numbers))
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


class Tables(unittest.TestCase):
    """In place of files."""

    def test_of_hazard_are_those_of_its_file(self):
        levels, rates = np.array([0.1, 0.2, 1.0]), np.array([1e-2, 3e-3, 1e-5])
        record = np.array(list(zip(levels, rates)), dtype=[("pga_g", float), ("annual_rate", float)])
        for given, asked in (({"pga_g": levels, "annual_rate": rates}, {}), (record, {}), ((levels, rates), {"imt": "PGA"}),
                             (np.stack([levels, rates]), {"imt": "PGA"}),
                             ({"PGA": levels, "poe": -np.expm1(-50 * rates)}, {"years": 50})):
            curve = rocking.hazard(given, **asked)
            self.assertEqual(curve.measure, "pga_g")
            np.testing.assert_allclose(curve.annual_rate, rates, rtol=1e-12)
        for given, place in (({"pga_g": [0.1, 0.1], "annual_rate": rates[:2]}, "hazard[1]"),
                             ({"pga": levels, "rats": rates}, "hazard")):
            with self.assertRaises(rocking.InputError) as caught:
                rocking.hazard(given)
            self.assertEqual(caught.exception.pointer, place)
            self.assertNotRegex(str(caught.exception), "line [0-9]")
        for given in (3, {"pga_g": levels, "annual_rate": [1.0]}, [{"pga_g": 1}, {"poe": 1}], None):
            with self.assertRaises((TypeError, ValueError)):
                rocking.hazard(given)

    def test_of_hazard_give_fragility_its_rate(self):
        result = rocking.run(SLAB)
        columns = {"amplitude": [0.5, 20.0], "annual_rate": [1e-2, 1e-4]}
        curve = rocking.hazard(columns)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "hazard.csv")
            with open(path, "w") as file:
                file.write(curve.text)
            expected = rocking.fragility(result, hazard=path)
            self.assertIsNotNone(expected.curves[0].annual_rate)
            for given in (columns, curve, [curve], rocking.hazard(path)):
                self.assertEqual(rocking.fragility(result, hazard=given), expected)
        pair = (columns["amplitude"], columns["annual_rate"])
        self.assertEqual(rocking.fragility(result, hazard=pair, imt="amplitude"), expected)
        two = rocking.fragility(result, hazard=[curve, columns], survived=100)
        self.assertEqual([branch.weight for branch in two.survival.branches], [0.5, 0.5])

    def test_of_rare_estimates_are_those_of_their_file(self):
        swept = {**SLAB, "sweep": [{"parameter": "/excitation/amplitude", "values": [4.0, 11.0, 12.0]}], "realisations": 40}
        columns = {"amplitude": [0.5, 20.0], "annual_rate": [1e-2, 1e-4]}
        rare = rocking.rare({**swept, "sweep": [{"parameter": "/excitation/amplitude", "values": [10.0]}]},
                            particles=100, relative_error=0.5)
        result = rocking.run(swept)
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "rare.json"), "w") as file:
                file.write(rare.json)
            expected = rocking.fragility(result, hazard=columns, rare=folder)
        self.assertEqual(rocking.fragility(result, hazard=columns, rare=rare), expected)
        again = rocking.rare({**swept, "sweep": [{"parameter": "/excitation/amplitude", "values": [10.0]}]},
                             particles=100, relative_error=0.5, resume=rare)
        self.assertEqual(again, rare)

    def test_fragility_is_exported_as_by_the_program(self):
        result = rocking.run(SLAB)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "curves.txt")
            rocking.fragility(result, export=path, as_="csv")
            with open(path) as file:
                self.assertIn("amplitude", file.read())
            with self.assertRaises(rocking.InputError):
                rocking.fragility(result, export=path)


if __name__ == "__main__":
    unittest.main()
