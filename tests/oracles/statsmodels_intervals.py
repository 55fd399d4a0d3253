#!/usr/bin/env python3
"""Makes statsmodels_intervals.json: intervals and tests of statsmodels, or of SciPy where it has none, for a grid of counts.

Needs python3-statsmodels and python3-scipy of Debian 12, which cannot be installed beside Boost 1.81. Unpacked they serve:

    apt-get download python3-statsmodels python3-statsmodels-lib python3-scipy python3-patsy python3-decorator \
        python3-packaging liblbfgsb0
    for package in *.deb; do dpkg-deb -x "$package" root; done
    PYTHONPATH=root/usr/lib/python3/dist-packages LD_LIBRARY_PATH=root/usr/lib/x86_64-linux-gnu \
        /usr/bin/python3 tests/oracles/statsmodels_intervals.py > tests/oracles/statsmodels_intervals.json
"""

import json
import math
import warnings

import numpy
import scipy
import statsmodels
from scipy import optimize, stats
from statsmodels.stats.contingency_tables import mcnemar
from statsmodels.stats.proportion import proportion_confint

warnings.filterwarnings("ignore")

CONFIDENCES = (0.8, 0.95, 0.999)
TABLES = ([0, 0, 0, 5], [1, 1, 7, 12], [1, 5, 16, 3], [0, 3, 0, 4], [80, 12, 12, 96], [59, 6, 16, 80], [2, 0, 9, 0],
          [900, 31, 12, 57], [7000, 420, 510, 2070])


def proportion(k, n, confidence):
    """The intervals of one proportion; `seven`: one of seven at once; `not_prespecified`: level = share p, see family.hpp."""
    alpha = 1 - confidence
    row = {"k": k, "n": n, "confidence": confidence}
    for name, method in (("wilson", "wilson"), ("clopper_pearson", "beta")):
        row[name] = proportion_confint(k, n, alpha, method)
    row["seven"] = proportion_confint(k, n, alpha / 7, "beta")
    half_share = alpha / 14

    def edge(tail):
        return optimize.brentq(lambda t: tail(math.exp(t)) - math.log(half_share) - t, -200, -1e-16, xtol=1e-13)

    low = math.exp(edge(lambda p: stats.binom.logsf(k - 1, n, p))) if k >= 2 else 0  # k = 1: no crossing
    high = 1
    if k < n:
        high = optimize.brentq(lambda p: stats.binom.logcdf(k, n, p) - math.log(half_share * p), max(k / n, 1e-12),
                               1 - 1e-16, xtol=1e-15)
    row["not_prespecified"] = (low, high)
    return row


def score(table, difference):
    """Tango's score statistic for a paired difference (1998, Stat. Med. 17, 891-908)."""
    n, b, c = sum(table), table[1], table[2]
    half = -b - c + (2 * n - b + c) * difference
    root = math.sqrt(half**2 + 8 * n * c * difference * (1 - difference))
    q = (root - half) / (4 * n)
    return (b - c - n * difference) / math.sqrt(n * (2 * q + difference * (1 - difference)))


def pairs(table):
    """McNemar's exact test from statsmodels; mid-p and Tango's interval from their definitions."""
    both, first, second, neither = table
    p_value = mcnemar([[both, first], [second, neither]], exact=True).pvalue
    fewer, discordant = min(first, second), first + second
    mid_p = 2 * stats.binom.cdf(fewer, discordant, 0.5) - stats.binom.pmf(fewer, discordant, 0.5)
    n, z = sum(table), stats.norm.isf(0.025)
    estimate = (first - second) / n
    interval = []
    for end, level in ((-1, z), (1, -z)):
        if estimate == end:
            interval.append(float(end))
        else:
            lo, hi = sorted((estimate, end * (1 - 1e-15)))
            interval.append(optimize.brentq(lambda d: score(table, d) - level, lo + 1e-15, hi - 1e-15, xtol=1e-14))
    return {"table": table, "exact": float(p_value), "mid_p": float(mid_p), "tango": interval}


def main():
    grid = [(k, n) for n in (1, 2, 5, 20, 200, 1000, 20000, 1000000)
            for k in sorted({0, 1, 2, n // 10, n // 3, n // 2, n - 1, n}) if k <= n]
    result = {
        "about": "made by statsmodels_intervals.py, beside this file",
        "versions": {"statsmodels": statsmodels.__version__, "scipy": scipy.__version__, "numpy": numpy.__version__},
        "proportions": [proportion(k, n, c) for k, n in grid for c in CONFIDENCES],
        "pairs": [pairs(table) for table in TABLES],
    }
    lines = []
    for key, value in result.items():
        if isinstance(value, list):
            rows = ",\n".join("  " + json.dumps(row) for row in value)
            lines.append(f"{json.dumps(key)}: [\n{rows}\n]")
        else:
            lines.append(f"{json.dumps(key)}: {json.dumps(value)}")
    print("{\n" + ",\n".join(lines) + "\n}")


main()
