"""Runs in a folder that can be stopped, continued and extended, and what is published of them: enough to check the bits."""

import itertools
import json
import subprocess
import sqlite3
import time

FIRST = 50  # realisations of each condition whose digest is published, too: they can be checked alone


def modes_by_condition(folder, at_horizon=False):
    """Of a finished run: response modes of the realisations of each condition, in the end or at the fixed horizon."""
    mode = "coalesce(horizon_mode, mode)" if at_horizon else "mode"
    with sqlite3.connect(f"file:{folder / 'realisations.sqlite'}?mode=ro", uri=True) as connection:
        rows = connection.execute(f"SELECT condition, {mode} FROM realisations ORDER BY condition, realisation").fetchall()
    return [[mode for _, mode in group] for _, group in itertools.groupby(rows, key=lambda row: row[0])]


class Folder:
    """Runs of the program, each in a folder of its name below `path`."""

    def __init__(self, program, path):
        self.program, self.path = program, path
        path.mkdir(parents=True, exist_ok=True)

    def rocking(self, *arguments, text=None):
        subprocess.run([self.program, *map(str, arguments)], input=text, text=True, stdout=subprocess.DEVNULL, check=True)

    def report(self, name):
        return json.loads((self.path / name / "report.json").read_text(encoding="utf-8"))

    def finished(self, name):
        """Number of realisations of each condition in the finished run; 0 if there is none."""
        return self.report(name)["input"]["experiment"]["realisations"] if (self.path / name / "report.json").exists() else 0

    def bring_to(self, name, realisations, experiment):
        """Runs the experiment (a path, or its text) or what is missing of it."""
        folder, began = self.path / name, time.monotonic()
        if self.finished(name) >= realisations:
            return
        if not self.finished(name) and (folder / "realisations.sqlite").exists():
            self.rocking("resume", folder, "--no-page", "-q")
        if not self.finished(name):
            is_text = isinstance(experiment, str)
            self.rocking("run", "-" if is_text else experiment, "-o", folder, "--realisations", realisations, "--no-page",
                         "-q", text=experiment if is_text else None)
        elif self.finished(name) < realisations:
            self.rocking("resume", folder, "--realisations", realisations, "--no-page", "-q")
        print(f"{name}: {realisations} realisations, {time.monotonic() - began:.0f} s", flush=True)

    def first_digest(self, name):
        """Digest of the first realisations, noted while the run has no more than these."""
        noted = self.path / "first.json"
        known = json.loads(noted.read_text(encoding="utf-8")) if noted.exists() else {}
        if name not in known:
            known[name] = {"realisations": self.finished(name), "digest": self.report(name)["result"]["digest"]}
            noted.write_text(json.dumps(known, indent=1), encoding="utf-8")
        return known[name]

    def published(self, name):
        """What is published of a run: the experiment, digests, and the response mode of each realisation."""
        report = self.report(name)
        rows, early = (modes_by_condition(self.path / name, at_horizon) for at_horizon in (False, True))
        modes = sorted({mode for row in rows + early for mode in row})
        letters = {mode: chr(48 + i) for i, mode in enumerate(modes)}
        return {"experiment": report["input"]["experiment"], "sha256": report["input"]["sha256"],
                "digest": report["result"]["digest"], "first": self.first_digest(name),
                "tolerance": report["result"]["tolerance_sensitivity"],
                "system": {key: report["system"][key] for key in ("machine", "threads", "duration_s")},
                "conditions": [condition["parameters"] for condition in report["result"]["conditions"]],
                "modes": modes, "rows": ["".join(letters[mode] for mode in row) for row in rows],
                "horizon_rows": ["".join(letters[mode] for mode in row) for row in early]}


def decoded(run, rows="rows"):
    """Response modes of the realisations of each condition of a published run; of `horizon_rows` at the fixed horizon."""
    return [[run["modes"][ord(letter) - 48] for letter in row] for row in run[rows]]


def differs(folder, name, published, experiment):
    """Whether the first realisations, run again, differ from what is published: in a bit, or in a response mode."""
    size = published["first"]["realisations"]
    folder.bring_to(name, size, experiment)
    again = folder.published(name)
    early = [row[:size] for row in decoded(published)]
    return again["digest"] != published["first"]["digest"] or decoded(again) != early
