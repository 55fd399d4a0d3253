#!/usr/bin/env python3
"""Writes the two synthetic ground motions of this folder. They are not measured but computed from a formula.

A Ricker pulse of peak frequency f is r(u) = (1 - 2 x) exp(-x), x = (pi f u)^2 (Ricker 1953, Geophysics 18, 10-40).
Horizontal: three pulses of alternating sign, centred at 2.0, 2.9 and 4.1 s. Vertical: shorter pulses that arrive earlier,
as faster waves do. In m/s^2, rounded to four decimals, every 0.01 s for 8 s.
"""

import math
import pathlib

STEP = 0.01
HORIZONTAL = [(4.0, 1.6, 2.0), (-3.6, 1.5, 2.9), (2.8, 1.4, 4.1)]  # peak [m/s^2], frequency [Hz], centre [s]
VERTICAL = [(2.5, 3.0, 1.6), (-2.0, 2.5, 2.3), (1.5, 3.5, 3.3)]


def pulses(train, time):
    total = 0.0
    for peak, frequency, centre in train:
        x = (math.pi * frequency * (time - centre)) ** 2
        total += peak * (1.0 - 2.0 * x) * math.exp(-x)
    return f"{total + 0.0:.4f}".replace("-0.0000", "0.0000")


def write(name, columns, trains):
    lines = [
        "# Synthetic: a train of Ricker pulses, made by make_records.py; no measured motion.",
        f"# {columns} [m/s^2], every {STEP} s",
    ]
    for sample in range(801):
        lines.append(", ".join(pulses(train, sample * STEP) for train in trains))
    pathlib.Path(__file__).with_name(name).write_text("\n".join(lines) + "\n")


write("pulses.txt", "horizontal", [HORIZONTAL])
write("pulses_with_vertical.txt", "horizontal, vertical", [HORIZONTAL, VERTICAL])
