"""The runs behind the claims: readings of the equations, starts, and the experiment of each run."""

import copy
import json
from pathlib import Path

HERE = Path(__file__).parent

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
OPTIONS = ("slide_inertia", "restitution", "impact_slip_rule")
_BOX = {"uniform": [-0.5, 0.5]}
# Initial state and phase of each start.
STARTS = {
    "rest, 0": ({"tilt": 0.0, "tilt_rate": 0.0}, 0.0),
    "rest, pi/2": ({"tilt": 0.0, "tilt_rate": 0.0}, 1.5707963267948966),
    "any": ({"tilt": _BOX, "tilt_rate": _BOX}, {"uniform": [0.0, 6.283185307179586]}),
}
FRICTIONS = ("0.40/0.35", "0.35/0.30")
SIGMAS = (0.003, 0.03)
ATTRACTORS = (6.6, 8.0, 9.0)  # A_h

# Runs of a whole file, and files of which each reading and start has a run. Numbers of realisations: the first, and those
# to which a run is extended while a claim that rests on it is undecided.
GRIDS = {"rest_no_sliding": (1,), "any_start_no_sliding": (200, 800), "rest_fixed_friction": (1,),
         "any_start_fixed_friction": (200, 800), "survival_rest": (1,), "survival_near_rest": (160,),
         "survival_any_start": (160,)}
FAMILIES = {"regions": (1000, 4000), "attractors": (80, 240), "diagrams": (200, 400)}
OTHERS = {"regions": (500, 2000), "attractors": (80, 240), "diagrams": (160, 480)}  # of the readings that are not MAIN
COARSE = 0.6  # step of A_h in their diagrams, to save time
MAIN = ("consistent", "as-printed", "as-plotted")
LOOKS = 2  # at most, for each claim


def cell_name(family, reading, start):
    """For example regions_edge-jy25_any."""
    words = (reading.replace(", ", "-"), start.replace(", ", "-").replace("pi/2", "90"))
    return "_".join((family, *words))


CELLS = {cell_name(family, reading, start): (family, reading, start)
         for family in FAMILIES for reading in READINGS for start in STARTS}
RUNS = (*GRIDS, *CELLS)


def sizes(name):
    if name in GRIDS:
        return GRIDS[name]
    family, reading, _ = CELLS[name]
    return (FAMILIES if reading in MAIN else OTHERS)[family]


def experiment_of(family, reading, start):
    """The experiment file of the family, with this reading and start."""
    found = json.loads((HERE / f"{family}.json").read_text(encoding="utf-8"))
    found.update(zip(OPTIONS, READINGS[reading]))
    found["initial"], found["excitation"]["phase_rad"] = copy.deepcopy(STARTS[start])
    if family == "diagrams" and reading not in MAIN:
        found["sweep"][0]["step"] = COARSE
    found["title"] += f" Reading: {reading}. Start: {start}."
    return found


def experiment(name):
    """The experiment of a run, with its first number of realisations."""
    if name in GRIDS:
        return json.loads((HERE / f"{name}.json").read_text(encoding="utf-8"))
    return {**experiment_of(*CELLS[name]), "realisations": sizes(name)[0]}
