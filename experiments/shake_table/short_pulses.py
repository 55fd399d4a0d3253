#!/usr/bin/env python3
"""Why short pulses overturn the rocks less often than predicted: six explanations, tried on rock 1.

usage: short_pulses.py FOLDER RESULTS             FOLDER and RESULTS as of shake_table.py, which has run
       short_pulses.py FOLDER RESULTS OUTCOMES    scores the best one on rock 2, too (OUTCOMES: data.py)

Each has at most one number. It is the most likely one of its grid on the first, third, fifth ... day of rock 1, with the
edges that shake_table.py inferred from these days. The other days judge it. Written down before anything was tried:

(a) The recorded acceleration holds vibration of the table that the rock does not feel. Predicts: a low-pass far below
    50 Hz makes short pulses right, and changes others little, whose strength is slower.
(b) The contact gives way: the moment grows with the tilt up to `number` rad, and is that of the edge from there on.
    Predicts: an edge lifts later; short pulses end before it does; longer ones change little.
(c) An impact takes `number` rad/s of the tilt rate beside its ratio. Predicts: small fast rocking dies; all weak motions
    overturn less often, long ones, too.
(d) Edges act farther out at small tilts: the moment is that of an edge (1 + number (1 - tilt/balance)) times as far out.
    Predicts: weak motions lift the rock less often, whatever their pulses.
(e) The rock slides: it feels at most `number` g. Predicts: only motions above that change, which the weak short pulses
    are not.
(f) Samples at 0.005 s are too few. Predicts: at 0.00125 s single tests change, their mean does not."""

import json
import math
import pathlib
import statistics
import sys

import numpy

import data
import shake_table

REALISATIONS = 100
LANES = 64  # rocks of each test in `overturned`
STEP = 0.00125  # [s] of `overturned`
GRAVITY = 9.81
# Name, and the numbers that are tried.
CANDIDATES = {"a": ("low-pass [Hz]", (5.0, 8.0, 12.0, 18.0, 25.0, 35.0)),
              "b": ("elastic up to [rad]", (3e-5, 1e-4, 3e-4, 1e-3)),
              "c": ("loss of rate [rad/s]", (0.002, 0.005, 0.015)),
              "d": ("farther out by", (-0.2, 0.2, 0.4, 0.8)),
              "e": ("friction", (0.2, 0.4, 0.8)),
              "f": ("step [s]", (0.00125,))}
FILTERS = "aef"  # are tried by the program, with other motions; the others by `overturned`


def low_passed(values, cut_off):
    """Without phase, as data.filtered."""
    mirrored = numpy.concatenate([values, values[::-1]])
    frequency = numpy.fft.rfftfreq(len(mirrored), data.KEPT * data.STEP)
    return numpy.fft.irfft(numpy.fft.rfft(mirrored) / (1.0 + (frequency / cut_off) ** (2 * data.ORDER)))[: len(values)]


def slid(values, friction):
    """Acceleration [g] of a block on a base with this acceleration that slides beyond `friction` (Newmark 1965)."""
    felt, rate = numpy.array(values), 0.0  # rate: of the base against the block, over g [s]
    for i, base in enumerate(values):
        if rate == 0.0 and abs(base) <= friction:
            continue
        felt[i] = math.copysign(friction, rate if rate != 0.0 else base)
        after = rate + data.KEPT * data.STEP * (base - felt[i])
        rate = 0.0 if rate * after < 0.0 else after
    return felt


def rocks_of(document, generator):
    """Edges, their distances, frequencies and ratios of LANES rocks, drawn from the laws of an experiment."""
    def drawn(law):
        shares = (generator.permutation(LANES) + generator.uniform(size=LANES)) / LANES  # one number in each stratum
        if "uniform" in law:
            return law["uniform"][0] + shares * (law["uniform"][1] - law["uniform"][0])
        scatter = math.sqrt(math.log1p((law["lognormal"]["sigma"] / law["lognormal"]["mean"]) ** 2))
        scores = numpy.array([statistics.NormalDist().inv_cdf(share) for share in shares])
        return law["lognormal"]["mean"] * numpy.exp(scatter * scores - 0.5 * scatter**2)

    block = document["block"]
    edges = numpy.array([drawn(edge) for edge in block["edges_m"]])
    height, gyration = block["centre_height_m"], block["radius_of_gyration_m"]
    radius = numpy.hypot(edges, height)
    return {"balance": numpy.arctan2(edges, height), "stiffness": GRAVITY * radius / (radius**2 + gyration**2),
            "ratio": numpy.array([drawn(ratio) for ratio in document["restitution"]["rate_ratio"]])}


def overturned(motions, rocks, b=0.0, c=0.0, d=0.0):
    """Share of the rocks that each motion [g] overturns; without (b), (c) and (d) the model of the program, to second order
    in the step. Positive tilts are about the left edge."""
    order = sorted(range(len(motions)), key=lambda i: -len(motions[i]))
    after = round(3.0 / (data.KEPT * data.STEP))  # samples in which a rock falls
    longest = len(motions[order[0]]) + after
    base = numpy.zeros((longest + 1, len(motions)))
    for column, i in enumerate(order):
        base[: len(motions[i]), column] = motions[i]
    ends = numpy.array([len(motions[i]) + after for i in order])
    tilt, rate = numpy.zeros((len(motions), LANES)), numpy.zeros((len(motions), LANES))
    fallen = numpy.zeros(tilt.shape, bool)
    pieces = round(data.KEPT * data.STEP / STEP)
    for k in range(longest):
        running = slice(0, int((ends > k).sum()))
        x, w = tilt[running], rate[running]
        for piece in range(pieces):
            a = (base[k] + piece / pieces * (base[k + 1] - base[k]))[running, None]
            is_left = numpy.where(x != 0.0, x > 0.0, a > 0.0)
            side = numpy.where(is_left, 1.0, -1.0)
            balance, stiffness = (numpy.where(is_left, *rocks[key]) for key in ("balance", "stiffness"))
            lift = balance - side * x
            moment = numpy.sin((1.0 + d) * lift)
            if b:
                moment *= numpy.minimum(1.0, side * x / b)
            growth = side * a * numpy.cos(lift) - moment
            stays = (x == 0.0) & (w == 0.0) & (growth <= 0.0)
            w += numpy.where(stays, 0.0, STEP * side * stiffness * growth)
            then = x + STEP * w
            lands = x * then < 0.0
            left = then / numpy.where(lands, then - x, 1.0)  # share of the step
            kept = numpy.maximum(0.0, numpy.where(then > 0.0, *rocks["ratio"]) * numpy.abs(w) - c)
            kept[kept < 1e-3] = 0.0
            w[:] = numpy.where(lands, numpy.sign(then) * kept, w)
            x[:] = numpy.where(lands, left * STEP * w, then)
        falls = numpy.abs(x) > 0.5
        fallen[running] |= falls
        x[falls] = w[falls] = 0.0
    shares = numpy.empty(len(motions))
    shares[order] = fallen.mean(axis=1)
    return shares


class Trial:
    def __init__(self, folder, results):
        self.folder, self.runs = folder, shake_table.runs_in(results)
        self.tests = data.write_motions(folder, results)
        self.motions = [numpy.loadtxt(self.runs.path / "motions" / test.file) for test in self.tests]
        days = sorted({test.day for test in self.tests})
        self.odd = numpy.array([test.day in days[::2] for test in self.tests])
        self.short = numpy.array([test.pgv_over_pga < shake_table.SHORT for test in self.tests])
        inferred = shake_table.experiment("inferred_1")
        odd_tests = [test for test, is_odd in zip(self.tests, self.odd) if is_odd]
        fit = shake_table.infer(self.runs, "fit_0", inferred, odd_tests)
        self.rock_1 = shake_table.with_edges(inferred, fit)
        self.rock_2 = shake_table.experiment("rock_2")

    def changed_motions(self, letter, number):
        """The name of a folder with the motions as a candidate changes them, and their step."""
        name = f"motions_{letter}_{number:g}"
        target = self.runs.path / name
        if not target.is_dir() or len(list(target.iterdir())) < len(self.tests):
            target.mkdir(exist_ok=True)
            for test, motion in zip(self.tests, self.motions):
                if letter == "f":
                    motion = data.filtered(data.recorded(pathlib.Path(self.folder) / data.RECORDINGS / test.file), kept=1)
                else:
                    motion = (low_passed if letter == "a" else slid)(motion, number)
                (target / test.file).write_text("".join(f"{value:.6f}\n" for value in motion), encoding="ascii")
        return name, number if letter == "f" else data.KEPT * data.STEP

    def predicted(self, rock, letter=None, number=None):
        """Probability of each test of a rock by a candidate; without a letter by the model, as the program has it."""
        document = getattr(self, rock)
        if letter is None or letter in FILTERS:
            name, step = ("motions", data.KEPT * data.STEP) if letter is None else self.changed_motions(letter, number)
            excitation = dict(document["excitation"], suite=f"{name}/*.txt", time_step_s=step)
            found = shake_table.simulate(self.runs, f"{rock}_{name}",
                                         dict(document, excitation=excitation, realisations=REALISATIONS))
            return numpy.array([found[test.file] for test in self.tests])
        rocks = rocks_of(document, numpy.random.default_rng(86))
        return overturned(self.motions, rocks, **({letter: number} if number else {}))

    def judged(self, predicted, outcomes, where):
        """The score of some tests, and how many of their short pulses overturned and were expected to."""
        p, y = predicted[where], outcomes[where]
        short = self.short[where]
        deviation = math.sqrt(float((p * (1.0 - p))[short].sum())) or math.nan
        return {"brier": float(((p - y) ** 2).mean()), "tests": int(short.sum()), "overturned": int(y[short].sum()),
                "expected": float(p[short].sum()), "deviations": float((y - p)[short].sum()) / deviation}


def log_likelihood(predicted, outcomes, realisations):
    p = (predicted * realisations + 0.5) / (realisations + 1.0)
    return float(numpy.log(numpy.where(outcomes == 1, p, 1.0 - p)).sum())


def tried(trial):
    """Each candidate with its number from the odd days, judged on the even days."""
    outcomes = numpy.array([test.outcome for test in trial.tests])
    rows = []
    for letter, numbers in [("", (None,)), ("0", (0.0,)), *((letter, grid) for letter, (_, grid) in CANDIDATES.items())]:
        predictions = {number: trial.predicted("rock_1", (letter or None) if letter != "0" else "b", number) for number in numbers}
        realisations = REALISATIONS if letter == "" or letter in FILTERS else LANES
        likely = {number: log_likelihood(p[trial.odd], outcomes[trial.odd], realisations) for number, p in predictions.items()}
        best = max(likely, key=likely.get)
        rows.append({"candidate": letter, "number": best, "log_likelihoods": list(likely.items()),
                     "odd": trial.judged(predictions[best], outcomes, trial.odd),
                     "even": trial.judged(predictions[best], outcomes, ~trial.odd)})
        print(json.dumps(rows[-1]), flush=True)
    return rows


def gain(row, rows):
    """Brier score on the even days, less that of the model by the same means."""
    base = next(each for each in rows if each["candidate"] == ("" if row["candidate"] in FILTERS else "0"))
    return row["even"]["brier"] - base["even"]["brier"]


def main(arguments):
    if len(arguments) not in (2, 3):
        sys.exit(__doc__)
    trial = Trial(*arguments[:2])
    path = trial.runs.path / "short_pulses.json"
    facts = {"candidates": json.loads(path.read_text(encoding="utf-8"))["candidates"] if path.exists() else tried(trial)}
    if len(arguments) == 3:
        outcomes = numpy.array(data.answers_of_rock_2(arguments[2], trial.tests)["outcome_2"])
        best = min((row for row in facts["candidates"] if row["candidate"] in CANDIDATES),
                   key=lambda row: gain(row, facts["candidates"]))
        all_tests = numpy.ones(len(trial.tests), bool)
        model = trial.predicted("rock_2", *((None, None) if best["candidate"] in FILTERS else ("b", 0.0)))
        facts["rock_2"] = {"candidate": best["candidate"], "model": trial.judged(model, outcomes, all_tests),
                           **trial.judged(trial.predicted("rock_2", best["candidate"], best["number"]), outcomes, all_tests)}
    path.write_text(json.dumps(facts, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
