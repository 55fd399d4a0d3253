#!/usr/bin/env python3
"""Writes a suite of synthetic ground motions, made by the stochastic model of Rezaeian & Der Kiureghian (2010,
Earthquake Engng Struct. Dyn. 39, 1155-1180). They are not measured. Only the standard library of Python is needed.

    make_motions.py FOLDER [--seed 2010] [--count 20]

The acceleration is white noise through a filter whose frequency changes with time, times a modulating function, and
then through a high-pass filter:

    x(t) = q(t) sum_i h(t - t_i; omega(t_i), zeta) u_i / sqrt(sum_i h(t - t_i; omega(t_i), zeta)^2)
    h(s; omega, zeta) = exp(-zeta omega s) sin(omega sqrt(1 - zeta^2) s),  omega(t) = omega_mid + rate (t - t_mid)
    q(t)^2 = Arias intensity (2 g/pi) times a gamma density with the given D5-95 and t_mid (45 % of the intensity)
    z'' + 2 omega_c z' + omega_c^2 z = x(t); the ground acceleration is z''

u_i are standard normal numbers, one each time step. Each motion draws its parameters from the distributions in
PARAMETERS. These are chosen for this example, within the ranges that the paper reports for stiff soil; they are no
result of a seismic hazard analysis. Equal seeds give equal files.
"""

import argparse
import math
import pathlib
import random
import statistics

STEP = 0.01  # [s]
GRAVITY = 9.81  # [m/s^2]
CORNER = 2.0 * math.pi * 0.12  # omega_c of the high-pass filter [rad/s]
QUIET = 1e-4  # response of the filter that is left out
PARAMETERS = {
    "arias": ("lognormal", 0.6, 0.5),  # median [m/s], standard deviation of the logarithm
    "duration": ("lognormal", 12.0, 0.35),  # D5-95 [s]
    "middle": ("uniform", 0.4, 0.8),  # t_mid over D5-95
    "frequency": ("lognormal", 3.0, 0.4),  # omega_mid/(2 pi) [Hz]
    "rate": ("uniform", -0.15, 0.02),  # of that frequency [Hz/s]
    "damping": ("uniform", 0.12, 0.4),  # zeta
}


def normal(source):
    return statistics.NormalDist().inv_cdf(source.random() or 0.5)


def drawn(source, law):
    kind, a, b = law
    return a * math.exp(b * normal(source)) if kind == "lognormal" else a + (b - a) * source.random()


def gamma_quantiles(shape, probabilities):
    """Quantiles of the gamma law of rate 1, by summing its density."""
    width = (shape + 12.0 * math.sqrt(shape) + 12.0) / 4000
    sums = [0.0]
    for i in range(4000):
        t = (i + 0.5) * width
        sums.append(sums[-1] + width * math.exp((shape - 1.0) * math.log(t) - t - math.lgamma(shape)))
    found = []
    for p in probabilities:
        i = next((k for k, s in enumerate(sums) if s >= p * sums[-1]), len(sums) - 1)
        found.append(width * (i - (sums[i] - p * sums[-1]) / (sums[i] - sums[i - 1])))
    return found


def gamma_law(duration, middle):
    """Shape and rate for which 5 to 95 % take `duration` and 45 % are reached at `middle`."""
    low, high = 1.0, 60.0  # a larger shape: the middle is later, compared with the duration
    for _ in range(25):
        shape = math.sqrt(low * high)
        q05, q45, q95 = gamma_quantiles(shape, [0.05, 0.45, 0.95])
        low, high = (shape, high) if q45 / (q95 - q05) < middle / duration else (low, shape)
    return shape, (q95 - q05) / duration


def filtered_noise(numbers, length, omega, zeta):
    """White noise through the filter of changing frequency, of unit variance at every step."""
    total, squares = [0.0] * length, [0.0] * length
    for i in range(length):
        w = omega(i * STEP)
        damped, decay = w * math.sqrt(1.0 - zeta * zeta), math.exp(-zeta * w * STEP)
        reach = min(length - i, int(-math.log(QUIET) / (zeta * w * STEP)) + 2)
        size = 1.0
        for j in range(1, reach):
            size *= decay
            h = size * math.sin(damped * j * STEP)
            total[i + j] += h * numbers[i]
            squares[i + j] += h * h
    return [t / math.sqrt(s) if s > 0.0 else 0.0 for t, s in zip(total, squares)]


def high_pass(x):
    """z'' of an oscillator of critical damping under x, by Newmark's method of constant average acceleration."""
    z, v, a, filtered = 0.0, 0.0, 0.0, []
    for value in x:
        z_next, v_next = z + STEP * v + 0.25 * STEP**2 * a, v + 0.5 * STEP * a
        a = (value - 2.0 * CORNER * v_next - CORNER**2 * z_next) / (1.0 + CORNER * STEP + 0.25 * (CORNER * STEP) ** 2)
        z, v = z_next + 0.25 * STEP**2 * a, v_next + 0.5 * STEP * a
        filtered.append(a)
    return filtered


def motion(source):
    p = {name: drawn(source, law) for name, law in PARAMETERS.items()}
    middle = p["middle"] * p["duration"]
    shape, rate = gamma_law(p["duration"], middle)
    end = gamma_quantiles(shape, [0.999])[0] / rate
    shaking = int(end / STEP)
    length = shaking + int(2.0 * 2.0 * math.pi / CORNER / STEP)  # until the filter has come to rest
    numbers = [normal(source) for _ in range(length)]
    slope = 2.0 * math.pi * p["rate"]
    omega = lambda t: max(2.0 * math.pi * p["frequency"] + slope * (t - middle), 2.0 * math.pi * 0.3)
    noise = filtered_noise(numbers, length, omega, p["damping"])
    density = lambda t: rate * math.exp((shape - 1.0) * math.log(rate * t) - rate * t - math.lgamma(shape))
    q = [math.sqrt(2.0 * GRAVITY / math.pi * p["arias"] * density(i * STEP)) if i else 0.0 for i in range(length)]
    return p, high_pass([a * b if i <= shaking else 0.0 for i, (a, b) in enumerate(zip(q, noise))])


def write(path, number, seed, p, accelerations):
    said = ", ".join(f"{name} {value:.4g}" for name, value in p.items())
    lines = [
        f"SYNTHETIC GROUND MOTION {number}, SEED {seed}: MADE BY make_motions.py, NOT MEASURED",
        f"STOCHASTIC MODEL OF REZAEIAN AND DER KIUREGHIAN (2010), {said}",
        "ACCELERATION TIME HISTORY IN UNITS OF G",
        f"NPTS= {len(accelerations)}, DT= {STEP:.5f} SEC",
    ]
    values = [f"{a / GRAVITY + 0.0:15.7E}" for a in accelerations]
    lines += ["".join(values[i : i + 5]) for i in range(0, len(values), 5)]
    path.write_text("\n".join(lines) + "\n")


def main():
    parser = argparse.ArgumentParser(description="Writes synthetic ground motions.")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--seed", type=int, default=2010)
    parser.add_argument("--count", type=int, default=20)
    request = parser.parse_args()
    request.folder.mkdir(parents=True, exist_ok=True)
    for number in range(1, request.count + 1):
        p, accelerations = motion(random.Random(request.seed * 100_000 + number))
        write(request.folder / f"synthetic_{number:03d}.at2", number, request.seed, p, accelerations)


if __name__ == "__main__":
    main()
