#!/usr/bin/env python3
"""Writes motion.txt: a synthetic horizontal earthquake motion. It is not measured but computed from a formula and a seed.

A sum of 80 sines from 0.2 to 6 Hz with phases from a seeded generator and amplitudes from the Kanai-Tajimi spectrum
(Tajimi 1960, Proc. 2nd World Conf. Earthquake Eng., 781-797) for a ground of 1.2 Hz and damping 0.5. The envelope increases
with the square of time for 2 s, is constant until 8 s and decreases as exp(-(t - 8)/3) until 20 s. The motion is scaled to a
peak of 1 m/s^2, so that the scale in an experiment file is the peak in m/s^2. Rounded to four decimals, every 0.02 s.
"""

import math
import pathlib
import random

STEP, SAMPLES, SEED = 0.02, 1001, 2012
GROUND, DAMPING = 1.2, 0.5  # frequency [Hz] and damping of the ground


def kanai_tajimi(frequency):
    r = (frequency / GROUND) ** 2
    d = 4.0 * DAMPING * DAMPING * r
    return (1.0 + d) / ((1.0 - r) ** 2 + d)


def envelope(time):
    if time < 2.0:
        return (time / 2.0) ** 2
    return 1.0 if time < 8.0 else math.exp(-(time - 8.0) / 3.0)


def motion():
    phases = random.Random(SEED)
    waves = []
    for i in range(80):
        frequency = 0.2 * 30.0 ** ((i + 0.5) / 80.0)
        # The spectrum is per Hz, and waves are evenly spaced in the logarithm of the frequency.
        waves.append((math.sqrt(kanai_tajimi(frequency) * frequency), frequency, phases.random()))
    return [envelope(k * STEP) * sum(a * math.sin(2.0 * math.pi * (f * k * STEP + p)) for a, f, p in waves)
            for k in range(SAMPLES)]


def main():
    samples = motion()
    peak = max(abs(sample) for sample in samples)
    lines = ["# Synthetic: sines under an envelope, made by make_record.py; no measured motion.",
             f"# horizontal [m/s^2], every {STEP} s"]
    lines += [f"{sample / peak + 0.0:.4f}".replace("-0.0000", "0.0000") for sample in samples]
    pathlib.Path(__file__).with_name("motion.txt").write_text("\n".join(lines) + "\n")


main()
