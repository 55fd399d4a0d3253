"""Exact intervals of shares and of paired differences, at a confidence that allows for every cell and look of a claim."""

import sys
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from statistics import NormalDist

from cells import LOOKS, READINGS, STARTS

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
from rocking_module import rocking  # noqa: E402


def level_of(claims):
    """Each claim is judged in every cell, and up to LOOKS times in each while it is sampled: the intervals of so many claims
    miss with at most 5 % together (Bonferroni)."""
    return 1.0 - 0.05 / (claims * len(READINGS) * len(STARTS) * LOOKS)


LEVEL = level_of(1)  # of all intervals outside of at()
_now = LEVEL


@contextmanager
def at(level):
    """Within this context intervals have another level."""
    global _now
    before, _now = _now, level
    try:
        yield
    finally:
        _now = before


def half_width():
    """Of an interval of a normal estimate, in standard errors."""
    return NormalDist().inv_cdf(0.5 + _now / 2)


def clopper_pearson(k, n, level=None):
    """The exact interval of a share, k of n independent trials (Clopper & Pearson 1934)."""
    return tuple(rocking.clopper_pearson(int(k), int(n), _now if level is None else level).tolist())


def paired_difference(up, down, n, level=None):
    """The exact interval of (up - down)/n: of n pairs, `up` have the response in the second run only, `down` in the first.

    The difference is r (2 q - 1). The interval of r has a tenth of the significance level, that of q the rest, as in
    `rocking compare` (lib/docs/methods.md, section 5).
    """
    alpha = 1.0 - (_now if level is None else level)
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
