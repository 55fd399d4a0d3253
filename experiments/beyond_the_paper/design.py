"""The 2^3 design in the published runs: the fluctuating sources of each run and their effects, with intervals."""

import collections
import itertools
import math
import sys
from pathlib import Path
from statistics import NormalDist

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
from rocking_module import rocking  # noqa: E402
from runs import decoded  # noqa: E402

SOURCES = ("friction", "restitution", "amplitude")
COMBINATIONS = [tuple(s for s, on in zip(SOURCES, bits) if on) for bits in itertools.product((0, 1), repeat=3)]
COMBINATIONS.sort(key=lambda names: (len(names), [SOURCES.index(n) for n in names]))
EFFECTS = [names for names in COMBINATIONS if names]
QUANTITIES = {"(1,1)": lambda mode: mode == "(1,1)", "(1,3)": lambda mode: mode == "(1,3)",
              "irregular": lambda mode: mode in ("chaotic", "unresolved")}


MOMENTS = {"at the fixed horizon": "horizon_rows", "in the end": "rows"}


def name_of(folder, names):
    """Name of the run of a combination."""
    return f"{folder}/{'_'.join(names)}" if names else "none"


def mover(terms):
    """Sum of weight x estimate over (weight, estimate, low, high), and its interval from theirs; they must be independent.

    Source: Zou & Donner (2008), Stat. Med. 27, 1693-1702; for two proportions it is Newcombe's (1998) method 10.
    """
    total = sum(weight * estimate for weight, estimate, _, _ in terms)
    below = above = 0.0
    for weight, estimate, low, high in terms:
        ends = sorted((weight * min(low, estimate), weight * max(high, estimate)))
        below += (weight * estimate - ends[0]) ** 2
        above += (ends[1] - weight * estimate) ** 2
    return total, total - math.sqrt(below), total + math.sqrt(above)


class Cell:
    """One condition of one run at one moment: its response modes."""

    def __init__(self, modes):
        self.modes, self.n = modes, len(modes)
        self.counts = collections.Counter(modes)

    def count(self, quantity):
        return sum(k for mode, k in self.counts.items() if QUANTITIES[quantity](mode))

    def differ(self):
        """Probability that two realisations differ in response, with its exact interval on disjoint pairs."""
        pairs = list(zip(self.modes[::2], self.modes[1::2]))
        estimate = 1 - sum(k * (k - 1) for k in self.counts.values()) / (self.n * (self.n - 1))
        low, high = rocking.clopper_pearson(sum(a != b for a, b in pairs), len(pairs)).tolist()
        return estimate, min(low, estimate), max(high, estimate)

    def term(self, quantity, weight, confidence):
        if quantity == "non-recurrence":
            return (weight, *self.differ())
        k = self.count(quantity)
        return (weight, k / self.n, *rocking.wilson(k, self.n, confidence).tolist())


class Design:
    """The eight runs at one relative sigma, as cells by combination and amplitude, at one moment."""

    def __init__(self, runs, folder, moment):
        self.moment = moment
        self.runs = {names: runs[name_of(folder, names)] for names in COMBINATIONS}
        self.cells = {}
        for names, run in self.runs.items():
            amplitudes = [condition["/excitation/amplitude"] for condition in run["conditions"]]
            self.cells[names] = dict(zip(amplitudes, map(Cell, decoded(run, MOMENTS[moment])), strict=True))
        self.amplitudes = sorted(set.intersection(*(set(cells) for cells in self.cells.values())))
        everything = self.runs[SOURCES]["experiment"]
        self.confidence = everything["confidence"]
        self.relative_sigma = everything["fluctuation"]["amplitude"]["relative_sigma"]

    def tests(self):
        return len(EFFECTS) * len(self.amplitudes)

    def level(self, is_simultaneous):
        """Confidence of one interval: simultaneous with those of the other tests, or of it alone."""
        return 1 - (1 - self.confidence) / self.tests() if is_simultaneous else self.confidence

    def power(self, effect):
        """Probability that the simultaneous interval of this effect does not contain 0, if all eight probabilities are near
        1/2, where their variance is largest."""
        z = NormalDist().inv_cdf(0.5 + self.level(True) / 2)
        n = min(cell.n for cells in self.cells.values() for cell in cells.values())
        return NormalDist().cdf(effect / math.sqrt(0.25 / (2 * n)) - z)

    def effect(self, names, quantity, amplitude):
        """Estimate, low, high: the mean over the four combinations with an even number of these sources off, minus that over
        the other four (Box, Hunter & Hunter 2005, chapter 5). One source: the increase of the probability by the source. Two:
        half the change of the effect of one by the other. Three: half the change of that interaction by the third.

        Simultaneous over all effects and amplitudes, except for non-recurrence, whose intervals are individual.
        """
        level = self.level(is_simultaneous=quantity != "non-recurrence")
        terms = []
        for combination, cells in self.cells.items():
            sign = math.prod(1 if name in combination else -1 for name in names)
            terms.append(cells[amplitude].term(quantity, sign / 4, level))
        return mover(terms)
