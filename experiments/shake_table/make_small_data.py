#!/usr/bin/env python3
"""Writes a made-up data set with the layout of the public one (data.py): eight tests on four days.

usage: make_small_data.py FOLDER

The table moves by one sine pulse in each test; both rocks "overturned" in the stronger ones, of which rock 2, in outcomes_2.csv,
survived one. Nothing here was measured."""

import csv
import math
import pathlib
import sys

import data

TESTS = ((1, "20210101", 0.05, 0), (2, "20210101", 0.30, 1), (3, "20210102", 0.12, 0), (5, "20210102", 0.25, 1),
         (6, "20210103", 0.14, 1), (7, "20210103", 0.06, 0), (8, "20210104", 0.20, 1), (10, "20210104", 0.10, 0))
OFFSET = 0.018  # [g], as an instrument has
START, FREQUENCY, END = 0.5, 2.0, 2.5  # [s], [Hz], [s]


def acceleration(time, peak):
    phase = FREQUENCY * (time - START)
    return OFFSET + (peak * math.sin(2.0 * math.pi * phase) if 0.0 <= phase <= 1.0 else 0.0)


def main(folder):
    recordings = pathlib.Path(folder) / data.RECORDINGS
    recordings.mkdir(parents=True, exist_ok=True)
    with open(pathlib.Path(folder) / "tests.csv", "w", encoding="utf-8", newline="") as file:
        rows = csv.writer(file)
        rows.writerow(["test", "date", "motion", "pgv_over_pga_s", "outcome_1"])
        rows.writerows([number, day, "sine pulse", 0.16 if number % 2 else 0.02, outcome] for number, day, _, outcome in TESTS)
    rock_2 = "".join(f"{number},{int(outcome and peak > 0.15)},1\n" for number, _, peak, outcome in TESTS)
    (pathlib.Path(folder) / "outcomes_2.csv").write_text("test,outcome_2,always\n" + rock_2, encoding="utf-8")
    for number, _, peak, _ in TESTS:
        times = [data.STEP * k for k in range(int(END / data.STEP))]
        lines = [f"{t:.5f}\t{acceleration(t, peak):.6f}\t{t:.5f}\t0\t{t:.5f}\t0\t{t:.5f}\t0\t\r\n" for t in times]
        path = recordings / f"Test{number:03d}.txt"
        path.write_text("Time [s]\tAmplitude\t" * 4 + "\r\n" + "".join(lines), encoding="latin-1")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
