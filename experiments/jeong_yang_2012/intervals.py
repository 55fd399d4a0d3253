"""Exact intervals of shares and of paired differences, at a confidence that allows for every cell and look of a claim."""

import sys
from dataclasses import dataclass
from pathlib import Path

from cells import LOOKS, READINGS, STARTS

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
from rocking_module import rocking  # noqa: E402

# Each claim is judged in every cell, and up to LOOKS times in each while it is sampled: together at most 5 % (Bonferroni).
LEVEL = 1.0 - 0.05 / (len(READINGS) * len(STARTS) * LOOKS)


def clopper_pearson(k, n, level=LEVEL):
    """The exact interval of a share, k of n independent trials (Clopper & Pearson 1934)."""
    return tuple(rocking.clopper_pearson(int(k), int(n), level).tolist())


def paired_difference(up, down, n, level=LEVEL):
    """The exact interval of (up - down)/n: of n pairs, `up` have the response in the second run only, `down` in the first.

    The difference is r (2 q - 1). The interval of r has a tenth of the significance level, that of q the rest, as in
    `rocking compare` (lib/docs/methods.md, section 5).
    """
    alpha = 1.0 - level
    rates = clopper_pearson(up + down, n, 1.0 - 0.1 * alpha)
    low, high = (2.0 * q - 1.0 for q in clopper_pearson(up, up + down, 1.0 - 0.9 * alpha))
    return min(low * r for r in rates), max(high * r for r in rates)


def per_cent(share, digits=0):
    return f"{100 * share + 0.0:.{digits}f}"


@dataclass(frozen=True)
class Share:
    """A share, k of n independent trials, with its exact interval: `P % [low, high] of n`."""
    k: int
    n: int

    @property
    def interval(self):
        return clopper_pearson(self.k, self.n)

    def percent(self, digits=0):
        return per_cent(self.k / self.n, digits)

    def __str__(self):
        if self.n == 0:
            return "none of 0"
        digits = 1 if 0 < min(self.k, self.n - self.k) < 0.02 * self.n else 0
        low, high = (per_cent(end, digits) for end in self.interval)
        return f"{self.percent(digits)} % [{low}, {high}] of {self.n}"


def above(interval, bound):
    """True: the whole interval is above the bound; False: below it; None: it contains the bound."""
    return True if interval[0] > bound else False if interval[1] < bound else None
