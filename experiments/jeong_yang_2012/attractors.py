"""Shape and size of chaotic attractors with and without fluctuating friction, from the strobe points of their runs."""

import itertools
import json
import math
import subprocess

import numpy as np

from cells import ATTRACTORS, FRICTIONS, READINGS, STARTS, cell_name, experiment_of
from claims import ENOUGH

POINTS = 1250  # of each: 50 000 together
LEAST = 10  # parts of a single motion
DIRECTIONS = 8
BINS = 500
SIGMAS = (0.0, 0.003, 0.03)


def conditions():
    """Number of each condition of attractors.json: (friction, sigma, amplitude) to its place in the grid."""
    return {place: i for i, place in enumerate(itertools.product(FRICTIONS, SIGMAS, ATTRACTORS))}


def chaotic(modes, friction, sigma, amplitude):
    return [k for k, mode in enumerate(modes[friction, sigma, amplitude]) if mode == "chaotic"]


def is_one_motion(modes, place):
    """From rest without fluctuation all realisations are equal, and the run has one."""
    return len(modes[place]) == 1


def too_few(modes):
    """Whether a condition is chaotic, with fixed friction too, but in fewer than ENOUGH realisations."""
    return any(chaotic(modes, friction, 0.0, amplitude) and 0 < len(chaotic(modes, friction, sigma, amplitude)) < ENOUGH
               and not is_one_motion(modes, (friction, sigma, amplitude)) for friction, sigma, amplitude in modes)


class Clouds:
    """Strobe points by realisation, kept in a folder once they are computed."""

    def __init__(self, program, folder):
        self.program, self.folder = program, folder
        folder.mkdir(parents=True, exist_ok=True)

    def points(self, reading, start, place, realisations, is_one):
        """Array (attractors, points, 2). A single motion is as long as all of them, and cut in as many parts: those before it
        overturns or becomes periodic."""
        kept = self.folder / f"{cell_name('points', reading, start)}_{conditions()[place]}.npy"
        if kept.exists():
            return np.load(kept)
        text = json.dumps(experiment_of("attractors", reading, start))
        if is_one:
            motions = chaotic_parts(self._motion(text, place, 0, ENOUGH * POINTS))
        else:
            motions = [self._motion(text, place, k, POINTS) for k in realisations[:ENOUGH]]
        clouds = np.array(motions)
        np.save(kept, clouds)
        return clouds

    def _motion(self, text, place, realisation, points):
        run = subprocess.run([self.program, "trajectory", "-", "--condition", str(conditions()[place]), "--realisation",
                              str(realisation), "--periods", str(500 + points), "--no-progress"],
                             input=text, text=True, stdout=subprocess.PIPE, check=True)
        strobe = json.loads(run.stdout)["strobe"][500:]
        return np.array([[point["tilt"], point["tilt_rate"]] for point in strobe])


def chaotic_parts(motion):
    parts = [motion[i:i + POINTS] for i in range(0, len(motion) - POINTS + 1, POINTS)]
    areas = [np.linalg.det(np.cov(part.T)) for part in parts]
    return list(itertools.takewhile(lambda part: np.linalg.det(np.cov(part.T)) > 1e-4 * areas[0], parts))


def jackknife(statistic, *samples):
    """The statistic of samples of attractors, with the standard error of the jackknife over attractors (Efron 1982).

    A single sample may have pairs of attractors as its members."""
    value, variance = statistic(*samples), 0.0
    for i, sample in enumerate(samples):
        n = len(sample)
        left_out = [statistic(*samples[:i], np.delete(sample, k, axis=0), *samples[i + 1:]) for k in range(n)]
        variance += (n - 1) / n * float(np.sum((np.array(left_out) - np.mean(left_out)) ** 2))
    return float(value), math.sqrt(variance)


def in_own_units(fixed, shaken):
    """Pairs of attractors, each pair in standard deviations of its member without fluctuation, from the mean of that.

    From any start the phase is random: the strobe points of a pair lie in one section, those of two pairs do not."""
    middle, scale = fixed.mean(axis=1, keepdims=True), fixed.std(axis=1, keepdims=True)
    return (fixed - middle) / scale, (shaken - middle) / scale


def shift(fixed, shaken, paired):
    """The largest distance of two attractors over the directions of the plane (Theta, Theta'), each in standard deviations
    of the attractor without fluctuation: the mean distance of their sorted projections (Wasserstein distance)."""
    if paired:
        fixed, shaken = in_own_units(fixed, shaken)
    pooled = fixed.reshape(-1, 2)
    middle, scale = pooled.mean(axis=0), pooled.std(axis=0)
    angles = np.arange(DIRECTIONS) * math.pi / DIRECTIONS
    axes = np.array([np.cos(angles), np.sin(angles)]) / scale[:, None]
    projected = [(cloud - middle) @ axes for cloud in (fixed, shaken)]
    ends = (min(p.min() for p in projected), max(p.max() for p in projected))
    edges = np.linspace(ends[0], ends[1], BINS + 1)
    scales = projected[0].reshape(-1, DIRECTIONS).std(axis=0)

    def distributions(p):
        counts = np.array([[np.histogram(p[k, :, d], edges)[0] for d in range(DIRECTIONS)] for k in range(len(p))])
        return np.cumsum(counts, axis=2) / p.shape[1]

    def distance(a, b):
        return np.max(np.abs(a.mean(axis=0) - b.mean(axis=0)).sum(axis=1) * (edges[1] - edges[0]) / scales)

    found = list(map(distributions, projected))
    value, error = (jackknife(lambda both: distance(both[:, 0], both[:, 1]), np.stack(found, axis=1)) if paired
                    else jackknife(distance, *found))
    return {"value": value, "error": error}


def growth(fixed, shaken, paired):
    """The ratio of the areas, the roots of the determinants of the covariance; of pairs the mean of their logarithms. The
    error is that of its logarithm."""
    def moments(cloud):
        x, y = cloud[..., 0], cloud[..., 1]
        return np.array([m.mean(axis=1) for m in (x, y, x * x, y * y, x * y)]).T

    def area(m):
        x, y, xx, yy, xy = m.T
        return 0.5 * np.log((xx - x * x) * (yy - y * y) - (xy - x * y) ** 2)

    one, other = moments(fixed), moments(shaken)
    value, error = (jackknife(np.mean, area(other) - area(one)) if paired
                    else jackknife(lambda a, b: area(b.mean(axis=0)) - area(a.mean(axis=0)), one, other))
    return {"value": math.exp(value), "error": error}


def rows(data, program, folder):
    """One row for each reading, start, friction and amplitude; `shift` and `growth` where both attractors are chaotic."""
    clouds = Clouds(program, folder)
    for reading, start in itertools.product(READINGS, STARTS):
        modes = data.modes(cell_name("attractors", reading, start))
        for friction, amplitude in itertools.product(FRICTIONS, ATTRACTORS):
            found = {sigma: chaotic(modes, friction, sigma, amplitude) for sigma in SIGMAS}
            counts = {sigma: [len(each), len(modes[friction, sigma, amplitude])] for sigma, each in found.items()}

            def points(sigma):
                place = (friction, sigma, amplitude)
                return clouds.points(reading, start, place, found[sigma], is_one_motion(modes, place))
            one = is_one_motion(modes, (friction, 0.0, amplitude))
            regime = bool(found[0.0]) and len(points(0.0)) >= LEAST if one else len(found[0.0]) >= ENOUGH
            row = {"reading": reading, "start": start, "friction": friction, "amplitude": amplitude,
                   "chaotic": {f"{sigma:g}": count for sigma, count in counts.items()}, "regime": regime}
            for name, sigma, measure in (("shift", 0.003, shift), ("growth", 0.03, growth)):
                if regime and len(found[sigma]) >= ENOUGH:
                    pair = [points(0.0), points(sigma)]
                    if not one:  # the realisations that are in both samples
                        first = [found[s][:ENOUGH] for s in (0.0, sigma)]
                        common = sorted(set(first[0]) & set(first[1]))
                        pair = [cloud[[own.index(k) for k in common]] for cloud, own in zip(pair, first)]
                    row[name] = {**measure(*pair, not one), "attractors": len(pair[1])}
            print(json.dumps(row), flush=True)
            yield row
