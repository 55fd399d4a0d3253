"""Exact binomial intervals, and tests of a share against one half."""

import math


def _upper_tail(k, n, p):
    """Probability of k or more of n."""
    return math.fsum(math.comb(n, i) * p**i * (1.0 - p) ** (n - i) for i in range(k, n + 1))


def _root(function, low, high):
    """The zero of an increasing function, by bisection."""
    for _ in range(60):
        middle = 0.5 * (low + high)
        if function(middle) < 0.0:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


def clopper_pearson(k, n, significance=0.05):
    """The exact interval of a share, k of n independent trials (Clopper & Pearson 1934)."""
    low = 0.0 if k == 0 else _root(lambda p: _upper_tail(k, n, p) - significance / 2, 0.0, 1.0)
    high = 1.0 if k == n else _root(lambda p: significance / 2 - (1.0 - _upper_tail(k + 1, n, p)), 0.0, 1.0)
    return low, high


def share(k, n):
    """`k of n, P % [low, high]`."""
    if n == 0:
        return "none of 0"
    low, high = clopper_pearson(k, n)
    return f"{k} of {n}, {100 * k / n:.0f} % [{100 * low:.0f}, {100 * high:.0f}]"


def beyond_half(k, n):
    """True: the share is above one half; False: below; None: undecided. With 95 % confidence."""
    if n == 0:
        return None
    low, high = clopper_pearson(k, n)
    return True if low > 0.5 else False if high < 0.5 else None
