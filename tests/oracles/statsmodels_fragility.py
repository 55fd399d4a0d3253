#!/usr/bin/env python3
"""Makes statsmodels_fragility.json: lognormal laws fitted by statsmodels, a probit regression on ln intensity, with the
covariance over trial numbers (clusters) and G/(G - 1) for few of them. Trials come from a seeded generator.

Needs what statsmodels_intervals.py says, and python3-numpy, -pandas, -dateutil, -tz, -six, libblas3, liblapack3, libgfortran5.
"""

import json
import math
import random

import numpy
import statsmodels
from scipy import stats
from statsmodels.discrete.discrete_model import Probit


def trials(intensities, numbers, median, dispersion, shared):
    """`shared`: share of the variance of a trial's logarithm that trials with the same number have in common."""
    levels = [[] for _ in intensities]
    for _ in range(numbers):
        common = generator.gauss(0.0, math.sqrt(shared))
        for happened, x in zip(levels, intensities):
            capacity = math.log(median) + dispersion * (common + generator.gauss(0.0, math.sqrt(1.0 - shared)))
            happened.append(int(capacity < math.log(x)))
    return levels


def fitted(intensities, levels):
    centre = sum(math.log(x) for x in intensities) / len(intensities)
    y = numpy.concatenate(levels)
    u = numpy.concatenate([[math.log(x) - centre] * len(h) for x, h in zip(intensities, levels)])
    number = numpy.concatenate([range(len(h)) for h in levels])
    result = Probit(y, numpy.column_stack([numpy.ones(len(u)), u])).fit(
        method="newton", maxiter=200, tol=1e-14, disp=False, cov_type="cluster",
        cov_kwds={"groups": number, "use_correction": False})
    groups = len(set(number))
    (aa, ab), (_, bb) = result.cov_params() * (groups / (groups - 1))
    a, b = result.params
    return {"centre": centre, "intercept": a, "slope": b, "covariance": [aa, ab, bb]}


generator = random.Random(2015)
cases = []
for intensities, numbers, median, dispersion, shared in (
        ([1.0, 2.0, 3.0, 4.0], 40, 2.5, 0.5, 0.0), ([1.0, 2.0, 3.0, 4.0], 40, 2.5, 0.5, 0.9),
        ([0.5, 1.0, 1.5, 2.0, 3.0, 5.0, 8.0], 300, 2.0, 0.6, 1.0), ([2.0, 2.2, 2.4], 15, 2.2, 0.1, 0.5),
        ([1e-3, 1e-2, 0.1, 1.0, 10.0], 100, 0.05, 2.0, 0.3), ([4.0, 5.0], 2000, 9.0, 0.4, 0.2)):
    levels = trials(intensities, numbers, median, dispersion, shared)
    levels[-1] = levels[-1][:numbers - numbers // 4]
    cases.append({"intensities": intensities, "happened": ["".join(map(str, level)) for level in levels],
                  **fitted(intensities, levels)})

quantile = stats.norm.ppf(0.975)
print(json.dumps({"statsmodels": statsmodels.__version__, "z": quantile, "cases": cases}))
