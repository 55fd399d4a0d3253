#!/usr/bin/env python3
"""What the sampling of a ground motion changes in the answer: the motions of this example at several time steps, and
with other interpolations between samples. Needs only the standard library of Python, and `rocking`.

    sampling.py FOLDER [--rocking PROGRAM] [--realisations 100]

FOLDER is that of `run`. Each motion is scaled to a peak of 1 g at its own samples and then written in these ways:

    given    its own samples, 0.01 s apart
    halves   0.005 s apart, on the straight lines between its samples: the same motion, in more steps
    every2   every second sample, 0.02 s apart
    band     0.0025 s apart, band-limited interpolation (a sinc with a Kaiser window) of its samples

`rocking` draws straight lines between the samples of each. The experiment sweeps the scale, so that all have the same
factor, and all have common random numbers.
"""

import argparse
import json
import math
import pathlib
import subprocess

LEVELS = [0.2, 0.3, 0.4, 0.5, 0.6, 0.8]  # factors of motions with a peak of 1 g
REACH = 32  # samples on each side
BETA = 10.0  # of the Kaiser window


def read(path):
    lines = path.read_text().splitlines()
    step = float(lines[3].split("DT=")[1].split()[0])
    return step, [float(line[i : i + 15]) for line in lines[4:] for i in range(0, len(line), 15)]


def write(path, step, values):
    head = ["SYNTHETIC GROUND MOTION", path.stem, "ACCELERATION TIME HISTORY IN UNITS OF G"]
    head.append(f"NPTS= {len(values)}, DT= {step:.6f} SEC")
    path.write_text("\n".join(head + [f"{value:.12E}" for value in values]) + "\n")


def bessel(x):
    """Modified Bessel function of the first kind, of order 0."""
    total = term = 1.0
    for k in range(1, 60):
        term *= (0.5 * x / k) ** 2
        total += term
    return total


def kernel(distance):
    if distance == 0.0:
        return 1.0
    if abs(distance) >= REACH:
        return 0.0
    window = bessel(BETA * math.sqrt(1.0 - (distance / REACH) ** 2)) / bessel(BETA)
    return window * math.sin(math.pi * distance) / (math.pi * distance)


def band_limited(values, parts):
    weights = [[kernel(k - part / parts) for k in range(-REACH, REACH + 1)] for part in range(parts)]
    padded = [0.0] * REACH + values + [0.0] * REACH
    dense = []
    for i in range(len(values) - 1):
        near = padded[i : i + 2 * REACH + 1]
        dense += [values[i]] + [sum(w * a for w, a in zip(weights[part], near)) for part in range(1, parts)]
    return dense + [values[-1]]


def halves(values):
    dense = []
    for a, b in zip(values, values[1:]):
        dense += [a, 0.5 * (a + b)]
    return dense + [values[-1]]


WAYS = {
    "given": lambda step, values: (step, values),
    "halves": lambda step, values: (step / 2, halves(values)),
    "every2": lambda step, values: (2 * step, values[::2]),
    "band": lambda step, values: (step / 4, band_limited(values, 4)),
}


def called(program, *arguments):
    done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(done.stderr)
    return done.stdout


def main():
    parser = argparse.ArgumentParser(description="What the sampling of a ground motion changes in the answer.")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--rocking", default="rocking")
    parser.add_argument("--realisations", type=int, default=100)
    request = parser.parse_args()
    experiment = json.loads((request.folder / "museum.json").read_text())
    experiment["realisations"] = request.realisations
    experiment["sweep"] = [{"parameter": "/excitation/scale", "values": LEVELS}]
    experiment["horizon"] = {"sampled_periods": 60}  # strobe periods of 1 s, the same for all
    motions = sorted((request.folder / "records").glob("*.at2"))
    outcomes = {}
    for way, resampled in WAYS.items():
        here = request.folder / "sampling" / way
        (here / "records").mkdir(parents=True, exist_ok=True)
        for path in motions:
            step, values = read(path)
            peak = max(abs(value) for value in values)
            write(here / "records" / path.name, *resampled(step, [value / peak for value in values]))
        (here / "e.json").write_text(json.dumps(experiment))
        called(request.rocking, "run", here / "e.json", "-o", here / "run", "--overwrite", "--no-page", "-q")
        motion = json.loads(called(request.rocking, "motion", *sorted(here.glob("records/*.at2")), "--json", "-q"))
        curve = json.loads(called(request.rocking, "fragility", here / "run", "--json", "-q"))["curves"][0]
        outcomes[way] = {
            "measures": [(each["pga_g"], each["pgv_m_s"]) for each in motion["motions"]],
            "overturned": sum(level["overturned"] for level in curve["levels"]),
            "realisations": sum(level["realisations"] for level in curve["levels"]),
            "changed": 0,
            "law": {key: curve["pooled"][key]["value"] for key in ("median", "dispersion", "between_records")},
        }
        if way != "given":
            first = here.parent / "given" / "run"
            compared = json.loads(called(request.rocking, "compare", first, here / "run", "--json"))
            outcomes[way]["changed"] = sum(each["changed"]["count"] for each in compared["conditions"])
    report(outcomes)


def report(outcomes):
    given = outcomes["given"]
    print("way      PGA [%]       PGV [%]       overturned  changed  median  dispersion  between records")
    for way, found in outcomes.items():
        changes = []
        for which in (0, 1):
            ratios = [100 * (a[which] / b[which] - 1) for a, b in zip(found["measures"], given["measures"])]
            changes.append(f"{min(ratios):+.1f} {max(ratios):+.1f}")
        law = found["law"]
        print(
            f"{way:8} {changes[0]:13} {changes[1]:13} {found['overturned']:<11} {found['changed']:<8} "
            f"{law['median']:.4f}  {law['dispersion']:.4f}      {law['between_records']:.4f}"
        )
    print(f"{given['realisations']} realisations; changed: their response mode is not that of the motion as given")


main()
