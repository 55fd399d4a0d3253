#!/usr/bin/env python3
"""Prints the cost of each effect for the reference block per excitation period: the table of reports/evidence/effects.md.

usage: experiments/effects/cost_table.py [build/release/rocking]

Counts are those of `internal` in the reports of 20 realisations of 300 periods (of one realisation if nothing is random).
Instructions are counted by valgrind (without it the column has a dash): those of one realisation of 300 periods minus
those of 100 periods, divided by 200, which excludes the start and the end of the run.
"""

import json
import math
import pathlib
import shutil
import subprocess
import sys
import tempfile

PROGRAM = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "build/release/rocking").resolve()
STICK_SLIP = {"static": 0.40, "kinetic": 0.35}
HARMONIC = {"amplitude": 4.5, "frequency_ratio": 10.0}
STRONGER = {"amplitude": 7.0, "frequency_ratio": 10.0}
RECORDED = {"kind": "recorded", "file": "sine.txt", "frequency_ratio": 10.0}
WITH_VERTICAL = {"kind": "recorded", "file": "sine_with_vertical.txt", "columns": ["time", "horizontal", "vertical"],
                 "frequency_ratio": 10.0}
FRICTION_SCATTER = {"static_friction": {"sigma": 0.03}, "kinetic_friction": {"sigma": 0.03}}
OTHER_SCATTER = {"restitution": {"sigma": 0.05}, "amplitude": {"sigma": 0.2}}
SCENES = {
    "no friction, A_h = 4.5": {"excitation": HARMONIC},
    "the same, with friction 5, at which the block never slides": {
        "excitation": HARMONIC, "friction": {"static": 5.0, "kinetic": 1.0}},
    "the same, restitution fluctuates": {"excitation": HARMONIC, "fluctuation": {"restitution": {"sigma": 0.05}}},
    "the same, amplitude fluctuates": {"excitation": HARMONIC, "fluctuation": {"amplitude": {"sigma": 0.2}}},
    "the same motion as recorded excitation, 20 samples per period": {"excitation": RECORDED},
    "the same, with vertical motion": {"excitation": WITH_VERTICAL},
    "friction 0.40/0.35, A_h = 7": {"excitation": STRONGER, "friction": STICK_SLIP},
    "the same, static friction fluctuates": {
        "excitation": STRONGER, "friction": STICK_SLIP, "fluctuation": {"static_friction": {"sigma": 0.03}}},
    "the same, kinetic friction fluctuates": {
        "excitation": STRONGER, "friction": STICK_SLIP, "fluctuation": {"kinetic_friction": {"sigma": 0.03}}},
    "the same, everything fluctuates": {
        "excitation": STRONGER, "friction": STICK_SLIP, "fluctuation": FRICTION_SCATTER | OTHER_SCATTER},
}


def write_ground_motions(folder):
    """The harmonic base motion of A_h = 4.5 for 320 periods, piecewise linear; vertical: a fifth at twice the frequency."""
    pace = 10.0 * math.sqrt(0.75 * 9.81 / (0.5 * math.hypot(1.0, 4.0)))  # [rad/s]
    peak = 4.5 * math.atan(0.25) * 9.81
    lines, both = [], []
    for sample in range(320 * 20 + 1):
        angle = 2.0 * math.pi * sample / 20.0
        lines.append(f"{angle / pace:.12f} {peak * math.sin(angle):.9f}")
        both.append(f"{lines[-1]} {0.2 * peak * math.sin(2.0 * angle):.9f}")
    (folder / "sine.txt").write_text("\n".join(lines) + "\n")
    (folder / "sine_with_vertical.txt").write_text("\n".join(both) + "\n")


def write_experiment(folder, scene, periods):
    path = folder / "experiment.json"
    path.write_text(json.dumps({
        "format": "rocking.experiment/1",
        "block": {"width_m": 1.0, "height_m": 4.0},
        "horizon": {"transient_periods": 50, "sampled_periods": periods - 50}} | scene))
    return path


def run(folder, scene, periods, realisations, before=()):
    output = folder / "out"
    shutil.rmtree(output, ignore_errors=True)
    experiment = write_experiment(folder, scene, periods)
    done = subprocess.run([*before, PROGRAM, "run", experiment, "-o", output, "-j", "1", "--quiet", "--no-progress",
                           "--realisations", str(realisations)], capture_output=True, text=True, check=True)
    return json.loads((output / "report.json").read_text()), done.stderr


def instructions(folder, scene):
    counted = []
    for periods in (100, 300):
        _, said = run(folder, scene, periods, 1, ("valgrind", "--tool=cachegrind", "--cache-sim=no",
                                                  "--cachegrind-out-file=/dev/null"))
        counted.append(int(next(line for line in said.splitlines() if "I" in line and "refs:" in line)
                           .split(":")[1].replace(",", "")))
    return (counted[1] - counted[0]) / 200.0


def row(folder, scene):
    realisations = 20 if "fluctuation" in scene else 1
    report, _ = run(folder, scene, 300, realisations)
    counts = report["internal"]["total"]
    if counts["events"].get("overturn", 0) > 0:
        raise SystemExit("a block overturned: its periods are not 300")
    periods = 300.0 * realisations
    numbers = [counts["steps"], counts["slip_steps"], counts["root_isolations"], sum(counts["draws"].values()),
               counts["ground_motion_segments"], counts["exponent_periods"]]
    cells = [f"{number / periods:.2f}" if number else "0" for number in numbers]
    return cells + ([f"{instructions(folder, scene) / 1000.0:.1f}"] if shutil.which("valgrind") else ["-"])


def main():
    print("| scene | steps | steps with slip | root isolations | random numbers | ground motion segments "
          "| exponent periods | thousand instructions |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- |")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        write_ground_motions(folder)
        for title, scene in SCENES.items():
            print("| " + " | ".join([title, *row(folder, scene)]) + " |", flush=True)


main()
