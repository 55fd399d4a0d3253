"""How well probabilities agree with what happened."""

import dataclasses
import math
import random

import numpy

from rocking_module import rocking

BINS = 10


@dataclasses.dataclass
class Bin:
    low: float
    high: float
    tests: int
    mean: float  # of the predicted probabilities
    overturned: int
    interval: tuple  # exact, of the observed share

    @property
    def holds(self):
        return self.interval[0] <= self.mean <= self.interval[1]


def calibration(predicted, outcomes, confidence=0.95):
    """Bins of equal width of the predicted probability, with Clopper-Pearson intervals of the observed share."""
    bins = []
    for k in range(BINS):
        inside = [i for i, p in enumerate(predicted) if min(int(p * BINS), BINS - 1) == k]
        if not inside:
            continue
        overturned = sum(outcomes[i] for i in inside)
        interval = tuple(map(float, rocking.clopper_pearson(overturned, len(inside), confidence)))
        bins.append(Bin(k / BINS, (k + 1) / BINS, len(inside), float(numpy.mean([predicted[i] for i in inside])), overturned,
                        interval))
    return bins


def brier(predicted, outcomes):
    return float(numpy.mean((numpy.asarray(predicted) - numpy.asarray(outcomes)) ** 2))


def decomposition(predicted, outcomes):
    """Reliability, resolution and uncertainty (Murphy 1973) over the bins. The score of the means of the bins is
    reliability - resolution + uncertainty."""
    base = float(numpy.mean(outcomes))
    bins = calibration(predicted, outcomes)
    total = len(outcomes)
    reliability = sum(b.tests * (b.mean - b.overturned / b.tests) ** 2 for b in bins) / total
    resolution = sum(b.tests * (b.overturned / b.tests - base) ** 2 for b in bins) / total
    return reliability, resolution, base * (1.0 - base)


def accuracy(predicted, outcomes):
    return float(numpy.mean([(p > 0.5) == bool(y) for p, y in zip(predicted, outcomes)]))


def f1(predicted, outcomes):
    both = sum(p > 0.5 and y for p, y in zip(predicted, outcomes))
    either = sum(p > 0.5 for p in predicted) + sum(outcomes)
    return 2.0 * both / either if either else math.nan


def roc_area(predicted, outcomes):
    """Probability that a test in which the rock overturned has the larger prediction (Mann & Whitney); ties count half."""
    fallen = [p for p, y in zip(predicted, outcomes) if y]
    stood = [p for p, y in zip(predicted, outcomes) if not y]
    if not fallen or not stood:
        return math.nan
    wins = sum((a > b) + 0.5 * (a == b) for a in fallen for b in stood)
    return wins / (len(fallen) * len(stood))


SCORES = {"accuracy": accuracy, "F1": f1, "Brier": brier, "ROC area": roc_area}


def cluster_intervals(predicted, outcomes, clusters, repetitions=1000, confidence=0.95, seed=1):
    """Percentile intervals of all scores by resampling whole clusters of tests."""
    groups = {}
    for i, cluster in enumerate(clusters):
        groups.setdefault(cluster, []).append(i)
    members, generator, found = list(groups.values()), random.Random(seed), {name: [] for name in SCORES}
    for _ in range(repetitions):
        chosen = [i for group in generator.choices(members, k=len(members)) for i in group]
        p, y = [predicted[i] for i in chosen], [outcomes[i] for i in chosen]
        for name, score in SCORES.items():
            value = score(p, y)
            if not math.isnan(value):
                found[name].append(value)
    tail = 50.0 * (1.0 - confidence)
    return {name: [float(v) for v in numpy.percentile(values, [tail, 100.0 - tail])] for name, values in found.items()}


def logistic(points, outcomes, iterations=50, penalty=1e-6):
    """Coefficients of a logistic regression with a constant, by Newton's method."""
    x = numpy.column_stack([numpy.ones(len(points)), points])
    y, beta = numpy.asarray(outcomes, float), numpy.zeros(x.shape[1])
    for _ in range(iterations):
        p = 1.0 / (1.0 + numpy.exp(-x @ beta))
        step = numpy.linalg.solve(x.T * (p * (1.0 - p)) @ x + penalty * numpy.eye(len(beta)), x.T @ (y - p) - penalty * beta)
        beta = beta + step
        if numpy.abs(step).max() < 1e-10:
            break
    return beta


def logistic_of(points, outcomes):
    """Gives the predictions of the regression at points."""
    beta = logistic(points, outcomes)
    return lambda at: (1.0 / (1.0 + numpy.exp(-(beta[0] + numpy.asarray(at) @ beta[1:])))).tolist()


def difference_interval(one, other, outcomes, clusters, repetitions=1000, seed=1):
    """Difference of the Brier scores of two predictions, and its 95 % interval by resampling whole clusters."""
    more = (numpy.asarray(one) - outcomes) ** 2 - (numpy.asarray(other) - outcomes) ** 2
    groups = {}
    for i, cluster in enumerate(clusters):
        groups.setdefault(cluster, []).append(i)
    generator, found = random.Random(seed), []
    for _ in range(repetitions):
        chosen = [i for group in generator.choices(list(groups.values()), k=len(groups)) for i in group]
        found.append(float(more[chosen].mean()))
    return [float(more.mean()), *map(float, numpy.percentile(found, [2.5, 97.5]))]


def logistic_by_day(points, outcomes, days):
    """Predictions for each day of the regression over all other days."""
    points, predicted = numpy.asarray(points, float), numpy.zeros(len(outcomes))
    for day in sorted(set(days)):
        left_out = numpy.array([d == day for d in days])
        predicted[left_out] = logistic_of(points[~left_out], numpy.asarray(outcomes)[~left_out])(points[left_out])
    return predicted.tolist()
