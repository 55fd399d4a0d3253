"""The 2^3 design in the published reports: the fluctuating sources of each run and their effects, with intervals."""

import itertools
import json
import math
import sys
from pathlib import Path
from statistics import NormalDist

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
from rocking_module import rocking  # noqa: E402

SOURCES = ("friction", "restitution", "amplitude")
COMBINATIONS = [tuple(s for s, on in zip(SOURCES, bits) if on) for bits in itertools.product((0, 1), repeat=3)]
COMBINATIONS.sort(key=lambda names: (len(names), [SOURCES.index(n) for n in names]))
EFFECTS = [names for names in COMBINATIONS if names]
QUANTITIES = {"(1,1)": lambda mode: mode == "(1,1)", "(1,3)": lambda mode: mode == "(1,3)",
              "irregular": lambda mode: mode in ("chaotic", "unresolved")}


def path_of(folder, names):
    """Path of the report of a combination, below reports/beyond_the_paper."""
    return f"{folder}/{'_'.join(names)}/report.json" if names else "none/report.json"


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
    """One condition of one run: counts of its response modes, and the probability that two realisations differ."""

    def __init__(self, condition):
        self.n = condition["realisations"]
        self.counts = condition["counts"]
        self.probabilities = condition["probabilities"]
        self.non_recurrence = condition["non_recurrence"]
        self.reasons = condition["validity"]["unresolved"]

    def count(self, quantity):
        return sum(k for mode, k in self.counts.items() if QUANTITIES[quantity](mode))

    def term(self, quantity, weight, confidence):
        if quantity == "non-recurrence":
            return (weight, self.non_recurrence["differ"], *self.non_recurrence["differ_interval"])
        k = self.count(quantity)
        return (weight, k / self.n, *rocking.wilson(k, self.n, confidence).tolist())


class Design:
    """The eight runs at one relative sigma, as cells by combination and amplitude."""

    def __init__(self, published, folder):
        self.reports = {names: json.loads((published / path_of(folder, names)).read_text()) for names in COMBINATIONS}
        self.cells = {names: {c["parameters"]["/excitation/amplitude"]: Cell(c) for c in report["result"]["conditions"]}
                      for names, report in self.reports.items()}
        self.amplitudes = sorted(set.intersection(*(set(cells) for cells in self.cells.values())))
        everything = self.reports[SOURCES]["input"]["experiment"]
        self.confidence = everything["confidence"]
        self.relative_sigma = everything["fluctuation"]["amplitude"]["relative_sigma"]

    def tests(self):
        return len(EFFECTS) * len(self.amplitudes)

    def level(self, is_simultaneous):
        """Confidence of one interval: simultaneous with those of the other tests, or of it alone."""
        return 1 - (1 - self.confidence) / self.tests() if is_simultaneous else self.confidence

    def z(self, is_simultaneous):
        return NormalDist().inv_cdf(0.5 + self.level(is_simultaneous) / 2)

    def effect(self, names, quantity, amplitude):
        """Estimate, low, high. One source: the increase of the probability by the source, mean over the others. Two: the
        change of the effect of one by the other, mean over the third. Three: the change of that interaction by the third.

        Simultaneous over all effects and amplitudes, except for non-recurrence, whose intervals are individual.
        """
        level = self.level(is_simultaneous=quantity != "non-recurrence")
        mean_over = 2 ** (len(SOURCES) - len(names))
        terms = []
        for combination, cells in self.cells.items():
            sign = math.prod(1 if name in combination else -1 for name in names)
            terms.append(cells[amplitude].term(quantity, sign / mean_over, level))
        return mover(terms)
