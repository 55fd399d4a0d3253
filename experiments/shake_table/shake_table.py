#!/usr/bin/env python3
"""Predicts 490 shake-table tests with two rocks, and compares them with what happened.

usage: shake_table.py FOLDER RESULTS [OUTCOMES]  runs everything; FOLDER has the public data, OUTCOMES is the file of rock 2
                                                 (both as in data.py), RESULTS is written
       shake_table.py --check                    whether shake_table.md follows from shake_table.json, in reports/experiments

Writes shake_table.json, shake_table.md, the figures and shake_table_rock_2.csv into RESULTS; with --publish at the end into
reports/experiments. What short_pulses.py wrote into RESULTS stands in the page, too. A run that was stopped goes on. Takes about
ten minutes on two cores.
"""

import csv
import hashlib
import json
import math
import os
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
TOP = HERE.parents[1]
sys.path[:0] = [str(TOP / "experiments/support")]
import data  # noqa: E402
import scores  # noqa: E402
import text  # noqa: E402
from runs import Folder  # noqa: E402

PUBLISHED = TOP / "reports/experiments"
REALISATIONS = 400
EDGES = ("/block/edges_m/0/lognormal/mean", "/block/edges_m/1/lognormal/mean")
GRAVITY = 9.81


SHORT = 0.03  # [s]: PGV/PGA of short pulses, below it
STRENGTHS = (0.0, 0.1, 0.15, 0.2, 0.3, 0.5, 1.0, math.inf)  # [g]
DURATIONS = (0.0, 25.0, 35.0, 45.0, math.inf)  # [s]


def class_of(value, limits, unit):
    k = max(i for i, limit in enumerate(limits) if limit <= value)
    return f"from {limits[k]:g} {unit}"


def experiment(name):
    return json.loads((HERE / f"{name}.json.in").read_text(encoding="utf-8"))


def probabilities(runs, name):
    """Share of the realisations in which the rock overturned, by the name of the recording."""
    return {pathlib.Path(condition["parameters"]["/excitation/file"]).name:
            condition["counts"]["overturned"] / condition["realisations"]
            for condition in runs.report(name)["result"]["conditions"]}


def simulate(runs, name, document):
    """Runs an experiment over all recordings."""
    path = runs.path / f"{name}.json"
    path.write_text(json.dumps(document, indent=1), encoding="utf-8")
    runs.bring_to(name, document["realisations"], path)
    return probabilities(runs, name)


def infer(runs, name, document, tests):
    """Estimates the means of the edges from the outcomes of some tests."""
    folder = runs.path / name
    if not (folder / "infer.json").exists():
        motion = {key: value for key, value in document["excitation"].items() if key != "suite"}
        first = dict(document, excitation={**motion, "file": f"motions/{tests[0].file}"})
        (runs.path / f"{name}.json").write_text(json.dumps(first, indent=1), encoding="utf-8")
        with open(runs.path / f"{name}.csv", "w", encoding="utf-8", newline="") as file:
            rows = csv.writer(file)
            rows.writerow(["/excitation", "overturned", "other"])
            for test in tests:
                rows.writerow([json.dumps({**motion, "file": f"motions/{test.file}"}), test.outcome, 1 - test.outcome])
        runs.rocking("infer", runs.path / f"{name}.json", "--tests", runs.path / f"{name}.csv", "-o", folder, "-q")
    answer = json.loads((folder / "infer.json").read_text(encoding="utf-8"))
    return {"tests": len(tests),
            "edges_m": [{"estimate": each["estimate"], "interval": each["interval"]} for each in answer["unknowns"]],
            "fit": answer["fit"], "log_likelihood": answer["log_likelihood"]}


def with_edges(document, fit):
    """The experiment with the estimated means, and nothing unknown."""
    found = {key: value for key, value in document.items() if key != "unknown"}
    found["realisations"] = REALISATIONS
    found["block"] = dict(found["block"], edges_m=[
        {"lognormal": {**edge["lognormal"], "mean": fitted["estimate"]}}
        for edge, fitted in zip(found["block"]["edges_m"], fit["edges_m"])])
    return found


def scored(predicted, outcomes, tests):
    clusters = [(test.day, test.motion) for test in tests]
    return {"scores": {name: score(predicted, outcomes) for name, score in scores.SCORES.items()},
            "intervals": scores.cluster_intervals(predicted, outcomes, clusters),
            "decomposition": scores.decomposition(predicted, outcomes),
            "bins": [vars(b) | {"holds": b.holds} for b in scores.calibration(predicted, outcomes)]}


def groups(predicted, outcomes, tests, key, order=lambda test: test.number):
    """Tests, overturned ones, and how many were expected, by a key."""
    found = {}
    for p, outcome, test in sorted(zip(predicted, outcomes, tests), key=lambda each: order(each[2])):
        row = found.setdefault(key(test), [0, 0, 0.0, 0.0])
        row[0] += 1
        row[1] += outcome
        row[2] += p
        row[3] += p * (1.0 - p)
    return [{"group": name, "tests": n, "overturned": k, "expected": e, "deviation": math.sqrt(v)}
            for name, (n, k, e, v) in found.items()]


def by_pulse(predicted, outcomes, tests):
    return groups(predicted, outcomes, tests, lambda test: class_of(test.pgv_over_pga, (0.0, SHORT, math.inf), "s"),
                  lambda test: test.pgv_over_pga)


def rock_2_scored(path, predicted, tests, points):
    """The prediction of rock 2 and what stands beside it, scored. Nothing is fitted to the outcomes of rock 2."""
    answers = data.answers_of_rock_2(path, tests)
    outcomes, first = answers.pop("outcome_2"), [test.outcome for test in tests]
    beside = {"logistic": scores.logistic_of(points, first)(points), "rock_1": list(map(float, first)),
              "base_rate": [sum(outcomes) / len(outcomes)] * len(outcomes),
              **{name: list(map(float, answer)) for name, answer in answers.items()}}
    return {"overturned": sum(outcomes), **scored(predicted, outcomes, tests),
            "beside": {name: {"scores": {key: score(p, outcomes) for key, score in scores.SCORES.items()},
                              "brier_more": scores.difference_interval(p, predicted, outcomes, [test.day for test in tests])}
                       for name, p in beside.items()},
            "by_day": groups(predicted, outcomes, tests, lambda test: test.day),
            "by_pulse": by_pulse(predicted, outcomes, tests)}


def runs_in(results):
    return Folder(os.environ.get("ROCKING", TOP / "build/release/rocking"), pathlib.Path(results))


def measure(folder, results, rock_2):
    """All runs and scores."""
    runs = runs_in(results)
    different = data.check_digests(folder)
    if different:
        print(f"not the recordings of the commit: {', '.join(different[:5])}{', ...' if different[5:] else ''}", file=sys.stderr)
    tests = data.write_motions(folder, results)
    days = sorted({test.day for test in tests})
    halves = [set(days[::2]), set(days[1::2])]
    in_half = [[test for test in tests if test.day in half] for half in halves]
    points = [(math.log(test.pga), math.log(test.pgv / test.pga)) for test in tests]

    nominal = simulate(runs, "nominal_1", experiment("nominal_1"))
    untuned = simulate(runs, "untuned_1", experiment("untuned_1"))
    inferred = experiment("inferred_1")
    fits = [infer(runs, f"fit_{k}", inferred, half) for k, half in enumerate(in_half)]
    by_halves = [simulate(runs, f"inferred_1_{k}", with_edges(inferred, fit)) for k, fit in enumerate(fits)]
    second = simulate(runs, "rock_2", experiment("rock_2"))

    near = experiment("nominal_1")["block"]
    models = {
        "West": [float(test.pga > min(near["edges_m"]) / near["centre_height_m"]) for test in tests],
        "logistic": scores.logistic_by_day(points, [test.outcome for test in tests], [test.day for test in tests]),
        "nominal": [nominal[test.file] for test in tests],
        "untuned": [untuned[test.file] for test in tests],
        # Each test is predicted by the numbers inferred from the other half of the days.
        "inferred": [by_halves[0 if test.day in halves[1] else 1][test.file] for test in tests],
    }
    outcomes = [test.outcome for test in tests]
    facts = {"tests": len(tests), "overturned": sum(outcomes), "different_files": len(different),
             "days": [sorted(half) for half in halves], "fits": fits,
             "models": {name: scored(predicted, outcomes, tests) for name, predicted in models.items()},
             "by_day": {name: groups(models[name], outcomes, tests, lambda test: test.day) for name in ("untuned", "inferred")},
             "by_motion": groups(models["inferred"], outcomes, tests, lambda test: test.motion),
             "by_strength": groups(models["inferred"], outcomes, tests, lambda test: class_of(test.pga, STRENGTHS, "g"),
                                   lambda test: test.pga),
             "by_duration": groups(models["inferred"], outcomes, tests, lambda test: class_of(test.duration, DURATIONS, "s"),
                                   lambda test: test.duration),
             "by_pulse": by_pulse(models["inferred"], outcomes, tests),
             "predicted": {test.file[:-4]: {name: models[name][i] for name in ("untuned", "inferred")}
                           for i, test in enumerate(tests)}}
    rows = [[test.number, f"{second[test.file]:.4f}"] for test in tests]
    predicted = [float(p) for _, p in rows]
    facts["rock_2"] = {"expected": sum(predicted), **(rock_2_scored(rock_2, predicted, tests, points) if rock_2 else {})}
    short_pulses = runs.path / "short_pulses.json"
    if short_pulses.exists():
        facts["short_pulses"] = json.loads(short_pulses.read_text(encoding="utf-8"))
    return facts, models, tests, rows


def write(folder, results, rock_2, target):
    facts, models, tests, second = measure(folder, results, rock_2)
    target.mkdir(parents=True, exist_ok=True)
    table = "test,probability\n" + "".join(f"{number},{p}\n" for number, p in second)
    (target / "shake_table_rock_2.csv").write_text(table, encoding="ascii")
    facts["rock_2"]["sha256"] = hashlib.sha256(table.encode()).hexdigest()
    (target / "shake_table.json").write_text(json.dumps(facts, indent=1) + "\n", encoding="utf-8")
    (target / "shake_table.md").write_text(text.page(facts), encoding="utf-8")
    text.draw(facts, models, tests, target)


def main(arguments):
    if arguments == ["--check"]:
        page = PUBLISHED / "shake_table.md"
        if page.read_text(encoding="utf-8") != text.page(json.loads((PUBLISHED / "shake_table.json").read_text())):
            sys.exit(f"{page} does not follow from shake_table.json")
        return
    is_published = arguments[-1:] == ["--publish"]
    files = arguments[:-1] if is_published else arguments
    if len(files) not in (2, 3) or any(name.startswith("--") for name in files):
        sys.exit(__doc__)
    try:
        write(*files[:2], files[2] if files[2:] else None, PUBLISHED if is_published else pathlib.Path(files[1]))
    except (data.Unusable, OSError) as error:
        sys.exit(f"shake_table.py: {error}")


if __name__ == "__main__":
    main(sys.argv[1:])
