"""Tests of the Python module: its names and defaults are those of the program's flags, and dir() shows the interface.

What differs stands in the lists below, with the reason.
"""

import inspect
import os
import re
import sys
import unittest

import rocking
from slab import PROGRAM, SLAB, SOURCE, changed

sys.path.insert(0, os.path.join(SOURCE, "experiments", "rocking"))
from help_text import commands_of, entries, help_of, parts_of  # noqa: E402

# The functions that do together what a command does.
FUNCTIONS = {
    "run": (rocking.run, rocking.plan),
    "report": (rocking.write_page, rocking.write_figures, rocking.write_tables, rocking.draw),
    "trajectory": (rocking.trajectory, rocking.Trajectory.text),
    "fragility": (rocking.fragility, rocking.write_sheet),
    "completion": (),
    "archive": (),
}
# Words of a command line that have another place in Python.
POSITIONALS = {"EXPERIMENT": "source", "PATH": "source", "FILE": "source", "SHARD": "shards", "DIR_A": "first",
               "DIR_B": "second", "NAME": "name", "DIR": "source"}
OTHER_POSITIONALS = {("resume", "DIR"): "folder", ("motion", "FILE"): "files", ("check-normal", "FILE"): "file",
                     ("completion", "SHELL"): None}
# Flags without a keyword: what they say is about files that commands write and text that they print.
OF_COMMANDS = {
    "--help": "help()",
    "--json": "documents have `json` and `data`",
    "--quiet": "a call prints nothing",
    "--verbose": "a call prints nothing",
    "--no-progress": "`progress` is called where it is given",
    "--output": "a call returns what it has found; `folder` of run() keeps the realisations alone",
    "--overwrite": "see --output",
    "--all": "tables of documents are whole; Result.table() has `width`",
    "--figure": "draw() draws what a study returned",
    "--no-page": "write_page() writes it",
    "--dry-run": "plan()",
    "--status": "open_run().done",
    "--html": "write_trajectory_page()",
    "--sheet": "write_sheet()",
    "--suggest": "annual_rate.add_levels of the document",
    "--per-record": "the document has the records",
    "--keys": "help(rocking.documents.Report) and the like",
}
OF_ONE_COMMAND = {("report", "--format"): "a function for each", ("archive", "--with-records"): "of the program alone",
                  **{(command, flag): "draw()" for command in ("motion", "fragility", "threshold")
                     for flag in ("--pictures", "--style", "--width")}}
# Keywords without a flag.
OF_CALLS = {
    "progress": "in place of the line of progress",
    "repair": "of run(); resume() always does it",
    "folder": "of run() and of what writes several files, in place of --output",
    "file": "of what writes one file, in place of --output or --sheet",
    "timed": "of plan()",
    "sources": "of draw(), in place of PATH",
}
OF_ONE_CALL = {("validate", "seed"), ("validate", "realisations"), ("fragility", "threads"), ("rare", "resume")}
OTHER_DEFAULTS = {("motion", "series"): "a call returns arrays"}
WITHOUT = (None, False, "", (), inspect.Parameter.empty)


def functions_of(command):
    return FUNCTIONS.get(command, (getattr(rocking, command.replace("-", "_"), None),))


def keyword_of(name):
    keyword = name[2:].replace("-", "_")
    return keyword + "_" if keyword in ("from", "as") else keyword


def flags_of(command):
    """(first long name, default as the help tells it or None)."""
    for term, sentence in entries(dict(parts_of(help_of(PROGRAM, command))[2])["Options"]):
        name = re.search(r"--[a-z-]+", term)[0]
        told = re.search(r" \((.*)\)$", term)
        listed = re.search(r"; default:((?: [0-9.]+)+)$", sentence)
        yield name, told[1] if told else listed[1] if listed else None


def parameters_of(command):
    return {name: parameter for function in functions_of(command)
            for name, parameter in inspect.signature(function).parameters.items() if name != "self"}


def is_same(told, default):
    """Whether a default is what the help tells."""
    if told in (None, "required"):
        return default in WITHOUT or told is None and default == 0  # `condition` starts at 0 in both
    values = default if isinstance(default, (tuple, list)) else (default,)
    words = re.sub(r"(?<=\d)s$", "", told).split()
    numbers = [int(word, 0) if word.startswith("0x") else float(word) for word in words] if words[0][0].isdigit() else words
    return list(values) == numbers


class Names(unittest.TestCase):
    def test_of_flags_are_keywords_with_the_same_default(self):
        used = set()
        for command in commands_of(PROGRAM):
            parameters = parameters_of(command)
            for name, told in flags_of(command):
                with self.subTest(command=command, flag=name):
                    if name in OF_COMMANDS or (command, name) in OF_ONE_COMMAND:
                        used |= {name, (command, name)}
                        continue
                    keyword = keyword_of(name)
                    self.assertIn(keyword, parameters)
                    used.add((command, keyword))
                    is_other = (command, keyword) in OTHER_DEFAULTS
                    self.assertEqual(is_same(told, parameters[keyword].default), not is_other, parameters[keyword])
        listed = {*OF_COMMANDS, *OF_ONE_COMMAND, *OTHER_DEFAULTS}
        self.assertEqual(listed - used, set(), "no command has these any more")

    def test_of_keywords_are_flags(self):
        used = set()
        for command in commands_of(PROGRAM):
            known = {keyword_of(name) for name, _ in flags_of(command)}
            sections = dict(parts_of(help_of(PROGRAM, command))[2])
            for term, _ in entries(sections.get("Positionals", [])):
                word = term.split()[0]
                known.add(OTHER_POSITIONALS.get((command, word), POSITIONALS.get(word)))
            for keyword in parameters_of(command):
                with self.subTest(command=command, keyword=keyword):
                    used |= {keyword, (command, keyword)}
                    self.assertTrue(keyword in known or keyword in OF_CALLS or (command, keyword) in OF_ONE_CALL)
        self.assertEqual({*OF_CALLS, *OF_ONE_CALL} - used, set(), "no call has these any more")

    def test_of_every_command_are_functions(self):
        for command in commands_of(PROGRAM):
            self.assertTrue(all(functions_of(command)), command)


class Dir(unittest.TestCase):
    def test_of_modules_shows_their_interface(self):
        self.assertEqual(sorted(dir(rocking)), sorted([*rocking.__all__, "__version__"]))
        for name in dir(rocking.documents):
            self.assertTrue(issubclass(getattr(rocking.documents, name), rocking.Fields), name)
        self.assertIn("Report", dir(rocking.documents))

    def test_of_objects_shows_their_interface(self):
        result = rocking.run(SLAB)
        with self.assertRaises(rocking.InputError) as caught:
            rocking.validate(changed(restitution=7))
        hazard = rocking.hazard({"pga_g": [0.1, 1.0], "annual_rate": [1e-2, 1e-4]})
        for made in (result, result.experiment, rocking.trajectory(SLAB), rocking.plan(SLAB, timed=False), hazard,
                     rocking.verify(result, sample=1), result.report(), result.report().result.conditions,
                     caught.exception, caught.exception.problems[0], rocking.Interrupted(result)):
            self.assertEqual([name for name in dir(made) if name.startswith("_")], [], made)
            for name in dir(made):
                if name not in ("probabilities",):
                    getattr(made, name)
        self.assertIn("counts", dir(result))
        self.assertIn("result", dir(result.report()))


class Defaults(unittest.TestCase):
    def test_of_orbits_follow_branches(self):
        still = changed(excitation={"kind": "harmonic", "amplitude": 4.0, "frequency_ratio": 10.0},
                        sweep=[{"parameter": "/excitation/amplitude", "values": [3.9, 4.0]}])
        self.assertTrue(rocking.orbits(still, periods=1).branches)
        self.assertIsNone(rocking.orbits(still, periods=1, no_branches=True).branches)
        single = {key: value for key, value in still.items() if key != "sweep"}
        self.assertIsNone(rocking.orbits(single, periods=1).branches)

    def test_seed_and_realisations_replace_those_of_studies(self):
        asked = {"event": "tilt > 0.3 psi", "particles": 50, "relative_error": 0.5}
        self.assertEqual(rocking.rare(SLAB, seed=7, **asked), rocking.rare(changed(seed="0x7"), **asked))
        found = rocking.bifurcation(SLAB, seed=7)
        self.assertEqual(found, rocking.bifurcation(changed(seed="0x7")))
        self.assertNotEqual(found, rocking.bifurcation(SLAB))

    def test_errors_name_keywords(self):
        still = changed(excitation={"kind": "harmonic", "amplitude": 4.0, "frequency_ratio": 10.0},
                        sweep=[{"parameter": "/excitation/amplitude", "values": [3.9, 4.0]}])
        for call, place in ((lambda: rocking.orbits(still, periods=13), "periods"),
                            (lambda: rocking.orbits(still, from_=4.0, to=3.0), "from"),
                            (lambda: rocking.rare(SLAB, max_time=-1.0), "max_time"),
                            (lambda: rocking.cost(SLAB, tolerances=[1.0]), "tolerances/0"),
                            (lambda: rocking.hazard(([0.1, 1.0], [1e-2, 1e-4])), "hazard")):
            with self.assertRaises(rocking.InputError) as caught:
                call()
            self.assertEqual(caught.exception.pointer, place)
            self.assertNotIn(" --", str(caught.exception))


if __name__ == "__main__":
    unittest.main()
