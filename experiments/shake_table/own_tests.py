#!/usr/bin/env python3
"""Scores the prediction of an experiment against tests of a laboratory's own.

usage: own_tests.py EXPERIMENT TESTS RESULTS

EXPERIMENT: of the object, with a suite of the recorded motions. TESTS, CSV: a line for each test, `file,overturned` with the
name of the motion's file and 1 or 0, and any columns by which misfits are to be grouped; with `day` the intervals draw whole
days. Writes RESULTS/scores.md, and RESULTS/prediction.csv before it reads an outcome: publish that first."""

import csv
import json
import os
import pathlib
import sys

import shake_table  # before scores: it finds the module
import scores
import text

MOST_GROUPS = 30  # of a column that is shown


def predicted(experiment, results):
    """Share of realisations in which each motion overturns the object, by the name of its file; written into prediction.csv."""
    runs = shake_table.Folder(os.environ.get("ROCKING", shake_table.TOP / "build/release/rocking"), results)
    document = json.loads(experiment.read_text(encoding="utf-8"))
    runs.bring_to("run", document.get("realisations", 400), experiment.resolve())
    found = shake_table.probabilities(runs, "run")
    lines = "".join(f"{name},{p:.4f}\n" for name, p in sorted(found.items()))
    (results / "prediction.csv").write_text("file,probability\n" + lines, encoding="utf-8")
    return found


def tests_in(path, found):
    with open(path, encoding="utf-8", newline="") as file:
        rows = csv.DictReader(file)
        shake_table.data.check_columns(rows, path, {"file", "overturned"})
        tests = [dict(row, overturned=shake_table.data.answer_in(row, "overturned", rows, path)) for row in rows]
    absent = sorted({test["file"] for test in tests} - set(found))
    if absent or not tests:
        raise shake_table.data.Unusable(f"{path}: {f'{absent[0]} is not in the suite' if absent else 'has no test'}")
    return tests


def misfits(p, outcomes, tests, column):
    values = {test[column] for test in tests}
    if len(values) > MOST_GROUPS:
        return ""
    rows = shake_table.groups(p, outcomes, tests, lambda test: test[column], lambda test: test[column])
    return f"\n{text.group_table(rows, column)}\n"


def page(found, tests):
    p, outcomes = [found[test["file"]] for test in tests], [test["overturned"] for test in tests]
    clusters = [test.get("day", i) for i, test in enumerate(tests)]
    intervals = scores.cluster_intervals(p, outcomes, clusters)
    rows = [[name, f"{score(p, outcomes):.3f}", "[{:.3f}, {:.3f}]".format(*intervals[name]) if name in intervals else "-"]
            for name, score in scores.SCORES.items()]
    columns = [name for name in tests[0] if name not in ("file", "overturned")]
    return text.wrapped(f"""
# {len(tests)} tests: {sum(outcomes)} overturned, {sum(p):.1f} expected

{text.table(["score", "value", "95 % interval"], rows)}

{text.calibration_table([vars(b) | {"holds": b.holds} for b in scores.calibration(p, outcomes)])}
{"".join(misfits(p, outcomes, tests, column) for column in columns)}
Deviations: observed less expected, over the standard deviation of independent tests.
""")


def main(arguments):
    if len(arguments) != 3:
        sys.exit(__doc__)
    experiment, tests, results = map(pathlib.Path, arguments)
    try:
        results.mkdir(parents=True, exist_ok=True)
        found = predicted(experiment, results)
        (results / "scores.md").write_text(page(found, tests_in(tests, found)), encoding="utf-8")
    except (shake_table.data.Unusable, OSError) as error:
        sys.exit(f"own_tests.py: {error}")


if __name__ == "__main__":
    main(sys.argv[1:])
