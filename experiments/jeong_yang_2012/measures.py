"""Measures of strobe points and energies, from the outputs of `rocking bifurcation` and `rocking trajectory`."""

import itertools
import random
import statistics

from intervals import clopper_pearson
from published import FRICTIONS, place_of

SEGMENT = 120  # strobe points
VISIBLE = 0.01  # in Theta: a hundredth of the tilt of balance, as for the divergence of two runs


def transport(a, b):
    """Wasserstein distance of two samples of equal size: the mean distance of their sorted values."""
    return statistics.fmean(abs(x - y) for x, y in zip(sorted(a), sorted(b), strict=True))


def area(points):
    """Root of the determinant of the covariance: the size of a cloud in the plane."""
    xs, ys = zip(*points)
    return (statistics.pvariance(xs) * statistics.pvariance(ys) - statistics.covariance(xs, ys) ** 2) ** 0.5


def shift(a, b, scales):
    """Distance of two clouds: the larger of those in Theta and Theta', in units of the attractor's standard deviation."""
    return max(transport([p[i] for p in a], [p[i] for p in b]) / scales[i] for i in (0, 1))


def segments(points):
    return [points[i:i + SEGMENT] for i in range(0, len(points), SEGMENT)]


def steps(bifurcation):
    """Conditions with their steps, of the branch that begins from the initial state in the file."""
    for diagram in bifurcation["diagrams"]:
        for step in diagram["steps"]:
            if step["branch"] == "initial":
                yield place_of({**diagram["others"], bifurcation["parameter"]: step["value"]}), step


def attractor_rows(fixed, fluctuating):
    """One row for each reading, start, friction, amplitude."""
    shaken = dict(steps(fluctuating))
    rows = []
    for (reading, start, friction, _, amplitude), step in steps(fixed):
        row = {"reading": reading, "start": start, "friction": friction, "amplitude": amplitude,
               "chaotic": step["mode"] == "chaotic"}
        small, large = (shaken[reading, start, friction, sigma, amplitude] for sigma in (0.003, 0.03))
        if row["chaotic"] and len(small["points"]) == len(large["points"]) == len(step["points"]):
            own = segments(step["points"])
            scales = [statistics.pstdev(column) for column in zip(*step["points"])]
            row["shift_within"] = max(shift(a, b, scales) for a, b in itertools.combinations(own, 2))
            between = [shift(a, b, scales) for a, b in itertools.product(own, segments(small["points"]))]
            row["shift_small"] = statistics.median(between)
            row["shift_small_least"] = min(between)
            ratios = [area(b) / area(a) for a, b in itertools.product(own, segments(large["points"]))]
            row["stays_chaotic"] = large["mode"] == "chaotic"
            row["growth"] = area(large["points"]) / area(step["points"])
            row["growth_range"] = [min(ratios), max(ratios)]
        else:
            row["chaotic"] = False
        rows.append(row)
    return rows


def bootstrap(numbers, resamples=2000, seed=2012):
    """The 95 % bootstrap interval of the mean of numbers."""
    source = random.Random(seed)
    n = len(numbers)
    means = sorted(sum(numbers[int(n * source.random())] for _ in range(n)) / n for _ in range(resamples))
    return [means[int(0.025 * resamples)], means[int(0.975 * resamples) - 1]]


def interval_of_mean(shares):
    """Of independent numbers from 0 to 1. If all are 0, it is the exact interval of the share that is not 0."""
    return bootstrap(shares) if any(shares) else list(clopper_pearson(0, len(shares)))


def diagram_rows(diagrams):
    """For each reading: the amplitudes at which two diagrams of equal conditions visibly differ, by disjoint pairs."""
    by_reading = {}
    for diagram in diagrams:
        for (reading, _, _, _, amplitude), step in steps(diagram):
            by_reading.setdefault(reading, {}).setdefault(amplitude, []).append(step["points"])
    rows = []
    for reading, clouds in by_reading.items():
        distances = []  # a list of distances for each pair
        for i in range(0, len(diagrams) - 1, 2):
            pairs = [(points[i], points[i + 1]) for points in clouds.values()]
            distances.append([transport(*([p[0] for p in cloud] for cloud in pair)) if all(pair) else None
                              for pair in pairs])
        shares = [sum(d is None or d > VISIBLE for d in row) / len(row) for row in distances]
        told = [d for row in distances for d in row if d is not None]
        rows.append({"reading": reading, "pairs": len(shares), "amplitudes": len(clouds),
                     "differ": statistics.fmean(shares), "differ_interval": interval_of_mean(shares),
                     "least": min(shares), "most": max(shares),
                     "median_distance": statistics.median(told), "largest_distance": max(told)})
    return rows


def energy_rows(conditions, energies):
    """One row for each trajectory: the energy account, as shares of the work that friction and impacts take."""
    rows = []
    for parameters, energy in zip(conditions, energies, strict=True):
        reading, start, friction, _, amplitude = place_of(parameters)
        spent = energy["lost_in_impacts"] - energy["friction_work"]
        rows.append({"reading": reading, "start": start, "friction": friction, "amplitude": amplitude,
                     "unaccounted": energy["unaccounted"] / spent, "gained_in_impacts": energy["gained_in_impacts"] / spent})
    assert {row["friction"] for row in rows} == set(FRICTIONS)
    return rows
