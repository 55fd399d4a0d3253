"""Tests of the Python module: pages, figures and tables have the bytes of the program's."""

import json
import os
import shutil
import unittest

import numpy as np

import rocking
from slab import SLAB, ProgramTest, changed, suite_in, write


@unittest.skipUnless(hasattr(rocking._core, "write_page"), "built without fmt (Debian: libfmt-dev)")
class Pages(ProgramTest):
    def setUp(self):
        super().setUp()
        self.ours = os.path.join(self.folder.name, "ours")

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
        journal = ["--style", "journal", "--width", "double", "--pictures", "png,gp"]
        self.program("report", self.out, "--format", "gnuplot", *journal)
        written = rocking.write_figures(self.out, self.ours, style="journal", width="double", pictures=["png", "gp"])
        self.expect_same(written.files, os.path.join(self.out, "figures"))
        with self.assertRaises(ValueError):
            rocking.write_figures(self.out, self.ours, style="wide")
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
        part = os.path.join(self.folder.name, "part")
        self.program("report", file, "-o", part, "--from", "5", "--to", "9", "--style", "journal")
        self.expect_same(rocking.draw(file, folder=self.ours, from_=5, to=9, style="journal").files, part)
        with self.assertRaises(rocking.InputError):
            rocking.draw(file, folder=self.ours, from_=9, to=9)
        own = rocking.draw(rocking.trajectory(self.path, condition=1, samples=20), folder=self.ours)
        self.assertEqual(sorted(path.name for path in own.files), sorted(os.listdir(self.out)))
        result = rocking.run(SLAB)
        still = changed(excitation={"kind": "harmonic", "amplitude": 4.0, "frequency_ratio": 10.0},
                        sweep=[{"parameter": "/excitation/amplitude", "values": [3.9, 4.0]}])
        record = os.path.join(self.folder.name, "pulse.txt")
        with open(record, "w") as out:
            out.write("".join(f"{0.01 * i} {4 * np.sin(0.3 * i)}\n" for i in range(200)))
        for found in (rocking.bifurcation(SLAB), rocking.fragility(result), rocking.check_normal(100),
                      rocking.orbits(still, periods=1), rocking.motion(record, units="g", series=True)):
            self.assertTrue(rocking.draw(found, folder=self.ours).files)
        with self.assertRaises(rocking.InputError):
            rocking.draw(rocking.compare(result, result), folder=self.ours)
        for other in ({"a": 1}, result):
            with self.assertRaises(TypeError):
                rocking.draw(other, folder=self.ours)

    def test_figures_of_a_suite_tell_its_rates_as_the_program_does(self):
        self.program("run", suite_in(self.folder.name), "-o", self.out, "--no-page", "-q")
        hazard = os.path.join(self.folder.name, "hazard.csv")
        columns = {"pga_g": [0.1, 10.0], "annual_rate": [1e-2, 1e-5]}
        with open(hazard, "w") as file:
            file.write(rocking.hazard(columns).text)
        self.program("report", self.out, "--format", "gnuplot", "--hazard", hazard)
        self.expect_same(rocking.write_figures(self.out, self.ours, hazard=hazard).files, os.path.join(self.out, "figures"))
        page = os.path.join(self.folder.name, "page.html")
        plain, told = (rocking.write_page(self.out, page, hazard=given).files[0].read_text() for given in (None, columns))
        self.assertGreater(told.count("annual rate"), plain.count("annual rate"))
        with self.assertRaises(rocking.InputError):
            rocking.write_page(rocking.run(SLAB), page, hazard=columns)

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


if __name__ == "__main__":
    unittest.main()
