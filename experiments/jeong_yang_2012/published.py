"""Access to runs, while they are made and as published: response modes by friction, sigma and amplitude."""

import json
import lzma
import sys
from pathlib import Path

from cells import GRIDS, OPTIONS, READINGS, RUNS, STARTS, cell_name

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
from runs import decoded, modes_by_condition  # noqa: E402


def read(path):
    """A JSON file; decompressed if its name ends in .xz."""
    path = Path(path)
    with lzma.open(path, "rt") if path.suffix == ".xz" else open(path, encoding="utf-8") as file:
        return json.load(file)


def place_of(parameters, grid):
    """(reading, start, friction, sigma, amplitude) of a condition of a grid, else (friction, sigma, amplitude).

    None for what the run does not sweep.
    """
    pair = parameters.get("/friction")
    pair = None if pair is None else f"{pair['static']:.2f}/{pair['kinetic']:.2f}"
    place = (pair, parameters.get("/fluctuation/friction/sigma"), parameters.get("/excitation/amplitude"))
    if not grid:
        return place
    options = tuple(parameters.get("/" + key, default) for key, default in zip(OPTIONS, READINGS["consistent"]))
    reading = next(name for name, wanted in READINGS.items() if wanted == options)
    phase = parameters.get("/excitation/phase_rad")
    start = next((name for name, (_, wanted) in STARTS.items() if wanted == phase), "any")
    return (reading, start, *place)


def modes_of(folder):
    """Of a finished run: response modes of the realisations of each condition, by its place."""
    conditions = read(folder / "report.json")["result"]["conditions"]
    places = [place_of(condition["parameters"], folder.name in GRIDS) for condition in conditions]
    return dict(zip(places, modes_by_condition(folder), strict=True))


class Runs:
    """Response modes of all runs."""

    def modes(self, name):
        """Of one run: the modes of its realisations, by condition."""
        raise NotImplementedError

    def series(self, reading, start, friction):
        """With fixed friction: the modes of all realisations by amplitude."""
        name = ("any_start_" if start == "any" else "rest_") + ("no_sliding" if friction is None else "fixed_friction")
        if friction is None:  # without sliding only the restitution matters
            reading = "jy25" if READINGS[reading][1] == "jy25" else "consistent"
        return {place[4]: modes for place, modes in self.modes(name).items() if place[:3] == (reading, start, friction)}

    def region(self, reading, start, friction, sigma):
        """At random amplitudes: the mode of each realisation."""
        return self.modes(cell_name("regions", reading, start))[friction, sigma, None]

    def diagrams(self, reading, start):
        """With 0.35/0.30 and sigma 0.03: the modes of all realisations by amplitude."""
        return {place[2]: modes for place, modes in self.modes(cell_name("diagrams", reading, start)).items()}


class Live(Runs):
    """The runs in a folder, while they are made."""

    def __init__(self, folder):
        self._folder, self._known = folder, (None, None)

    def modes(self, name):
        if self._known[0] != name:
            self._known = (name, modes_of(self._folder / name))
        return self._known[1]


class Published(Runs):
    """All published runs of a folder."""

    def __init__(self, folder):
        self.folder = Path(folder)
        self.runs = read(self.folder / "runs.json.xz")
        self.measures = read(self.folder / "measures.json.xz")
        self._modes = {name: self._by_place(name) for name in RUNS}

    def _by_place(self, name):
        places = [place_of(condition, name in GRIDS) for condition in self.runs[name]["conditions"]]
        return dict(zip(places, decoded(self.runs[name]), strict=True))

    def modes(self, name):
        return self._modes[name]

    def at_horizon(self, name):
        """Of one run: the modes at the fixed horizon, by condition."""
        return dict(zip(self._modes[name], decoded(self.runs[name], "horizon_rows"), strict=True))
