"""Exact binomial intervals, and tests of a share against one half."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
from rocking_module import rocking  # noqa: E402


def clopper_pearson(k, n):
    """The exact 95 % interval of a share, k of n independent trials, as in the reports."""
    return tuple(rocking.clopper_pearson(k, n).tolist())


def share(k, n):
    """`k of n, P % [low, high]`."""
    if n == 0:
        return "none of 0"
    low, high = clopper_pearson(k, n)
    low, high = (round(100 * end, 9) for end in (low, high))  # 2.5 %, of 1 of 1, whatever the last bit
    return f"{k} of {n}, {100 * k / n:.0f} % [{low:.0f}, {high:.0f}]"


def beyond_half(k, n):
    """True: the share is above one half; False: below; None: undecided. With 95 % confidence."""
    if n == 0:
        return None
    low, high = clopper_pearson(k, n)
    return True if low > 0.5 else False if high < 0.5 else None
