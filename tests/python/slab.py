"""What the tests of the Python module share.

Environment: ROCKING_PROGRAM, the program; ROCKING_SOURCE, the root of the clone.
"""

import json
import os
import subprocess
import tempfile
import unittest

import numpy as np

PROGRAM = os.environ["ROCKING_PROGRAM"]
SOURCE = os.environ["ROCKING_SOURCE"]

SLAB = {
    "format": "rocking.experiment/1",
    "block": {"width_m": 1.0, "height_m": 4.0},
    "excitation": {
        "kind": "harmonic",
        "amplitude": 2.0,
        "frequency_ratio": 10.0,
        "phase_rad": {"uniform": [0.0, 6.28]},
    },
    "restitution": 0.9,
    "horizon": {"transient_periods": 20, "sampled_periods": 20},
    "sweep": [{"parameter": "/excitation/amplitude", "values": [1.0, 4.0, 12.0]}],
    "realisations": 20,
    "seed": "0x1",
}


def changed(**keys):
    return {**SLAB, **keys}


def write(folder, experiment):
    path = os.path.join(folder, "experiment.json")
    with open(path, "w") as file:
        json.dump(experiment, file)
    return path


def suite_in(folder):
    """Four sines of different frequency; the path of the experiment."""
    for k in range(4):
        with open(os.path.join(folder, f"r{k}.txt"), "w") as file:
            file.write("".join(f"{0.02 * i} {3 * np.sin((3 + 1.5 * k) * 0.02 * i)}\n" for i in range(150)))
    path = os.path.join(folder, "suite.json")
    with open(path, "w") as file:
        json.dump({"format": "rocking.experiment/1", "block": {"width_m": 0.35, "height_m": 1.6},
                   "excitation": {"kind": "recorded", "suite": "r*.txt", "format": "columns", "units": "m/s2"},
                   "fluctuation": {"restitution": {"sigma": 0.05}},
                   "sweep": [{"parameter": "/excitation/pga_g", "values": [0.2, 0.3, 0.5, 0.8]}],
                   "realisations": 8, "seed": "0x1"}, file)
    return path


LONG = changed(realisations=100000, sweep=[{"parameter": "/excitation/amplitude", "values": [4.0]}])


class ProgramTest(unittest.TestCase):
    """A test in a folder of its own, with the experiment SLAB and the program at hand."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = write(self.folder.name, SLAB)
        self.out = os.path.join(self.folder.name, "out")

    def program(self, *arguments):
        return subprocess.run([PROGRAM, *arguments], check=True, capture_output=True, text=True).stdout
