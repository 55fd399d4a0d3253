"""Access to the published results: response modes by reading, start, friction, sigma and amplitude."""

import json
import lzma
from pathlib import Path

# The readings of the paper's equations: inertia in the slip equations, restitution, rule of impact slip.
READINGS = {
    "consistent": ("centroidal", 0.0, "absolute"),
    "edge": ("edge", 0.0, "absolute"),
    "jy25": ("centroidal", "jy25", "absolute"),
    "signed": ("centroidal", 0.0, "signed"),
    "edge, jy25": ("edge", "jy25", "absolute"),
    "jy25, signed": ("centroidal", "jy25", "signed"),
    "as-plotted": ("edge", 0.0, "signed"),
    "as-printed": ("edge", "jy25", "signed"),
}
STARTS = ("rest, 0", "rest, pi/2", "any")
FRICTIONS = ("0.40/0.35", "0.35/0.30")
SIGMAS = (0.003, 0.016, 0.03)
RUNS = (
    "rest_no_sliding", "rest_fixed_friction", "rest_fluctuating_friction",
    "any_start_no_sliding", "any_start_fixed_friction", "any_start_fluctuating_friction",
    "non_recurrence", "figure_09", "figure_10",
)


def read(path):
    """A JSON file; decompressed if its name ends in .xz."""
    path = Path(path)
    with lzma.open(path, "rt") if path.suffix == ".xz" else open(path, encoding="utf-8") as file:
        return json.load(file)


def place_of(parameters):
    """(reading, start, friction, sigma, amplitude) of a condition; None for a parameter that is not swept."""
    reading = parameters.get("/formulation")
    if reading is None and "/restitution" in parameters:
        options = tuple(parameters.get("/" + key, default) for key, default in
                        (("slide_inertia", "centroidal"), ("restitution", 0.0), ("impact_slip_rule", "absolute")))
        reading = next(name for name, wanted in READINGS.items() if wanted == options)
    phase = parameters.get("/excitation/phase_rad")
    start = None if phase is None else STARTS[0] if phase == 0.0 else STARTS[1]
    friction = parameters.get("/friction")
    pair = None if friction is None else f"{friction['static']:.2f}/{friction['kinetic']:.2f}"
    return reading, start, pair, parameters.get("/fluctuation/friction/sigma"), parameters["/excitation/amplitude"]


class Published:
    """All published runs of a folder."""

    def __init__(self, folder):
        self.folder = Path(folder)
        self.reports = {name: read(self.folder / f"{name}.json.xz") for name in RUNS}
        self.measures = read(self.folder / "measures.json")
        rows = read(self.folder / "realisations.json.xz")
        self._modes = {name: self._by_place(name, rows[name]) for name in RUNS}

    def _by_place(self, name, rows):
        places = {}
        for condition, numbers in zip(self.reports[name]["result"]["conditions"], rows["conditions"], strict=True):
            modes = [rows["modes"][number] for number in numbers]
            counts = {mode: count for mode, count in condition["counts"].items() if count}
            if counts != {mode: modes.count(mode) for mode in set(modes)}:
                raise ValueError(f"{name}: the counts of the report differ from the response modes of the realisations")
            places[place_of(condition["parameters"])] = modes
        return places

    def modes(self, run):
        """Of one run: the modes of its realisations, by condition."""
        return self._modes[run]

    def non_recurrence(self, run):
        """Of one run: each condition with its non-recurrence in the report."""
        return [(place_of(condition["parameters"]), condition["non_recurrence"])
                for condition in self.reports[run]["result"]["conditions"]]

    def series(self, reading, start, friction, sigma=0.0):
        """The modes of all realisations by amplitude, from the run that contains this cell."""
        kind = "no_sliding" if friction is None else "fixed_friction" if sigma == 0.0 else "fluctuating_friction"
        run = ("any_start_" if start == "any" else "rest_") + kind
        if friction is None:  # without sliding only the restitution matters
            reading = "jy25" if READINGS[reading][1] == "jy25" else "consistent"
        wanted = (reading, None if start == "any" else start, friction, sigma or None)
        return {place[4]: modes for place, modes in self._modes[run].items() if place[:4] == wanted}
