#!/usr/bin/env python3
"""Computes published values again, and writes reports/evidence/published.md from values.json.

usage: write.py [--check] [--program FILE]

--check: computes and writes nothing; exit code 1 if published.md differs. Takes some seconds.

A group of values.json has what its values share; a value may have keys of its own in their place. `command` is a call of
`rocking` in this folder, `at` the place of our number in its output, `%` in both the place of the value in its list. The
number is multiplied by `factor`. Two published numbers are the ends of an interval in which the value is.
`independent` is the number that follows without this program where the published one is not exact. The test demands that
ours is `within` so much of that, or else of the published one.
"""

import argparse
import functools
import json
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
TOP = HERE.parents[1]
PAGE = TOP / "reports/evidence/published.md"
SUBJECTS = ("Free rocking", "Pulses", "Harmonic orbits", "Sliding", "Criteria")


def values_of(index):
    """Every value with all its keys."""
    for group in index["groups"]:
        for place, value in enumerate(group["values"]):
            full = {**group, **value}
            for key in ("command", "at"):
                full[key] = full[key].replace("%", str(place))
            yield full


@functools.cache
def output(program, command):
    with tempfile.TemporaryDirectory() as folder:
        call = [program, *command.replace("OUT", folder).split(), "--json", "-q"]
        done = subprocess.run(call, cwd=HERE, text=True, stdout=subprocess.PIPE, check=True)
    return json.loads(done.stdout)


def ours(program, value):
    found = output(program, value["command"])
    for key in value["at"].split("/")[1:]:
        found = found[int(key)] if isinstance(found, list) else found[key]
    return found if isinstance(found, str) else found * value.get("factor", 1.0)


def difference(number, published):
    """As text: 0 within an interval, empty if equal words."""
    if isinstance(number, str):
        return "" if number == published else "differs"
    low, high = map(float, published if isinstance(published, list) else (published, published))
    away = min(number - low, 0.0) + max(number - high, 0.0)
    return f"{away:.1e}" if away else "0"


def table(head, rows):
    return "\n".join("| " + " | ".join(row) + " |" for row in (head, ["---"] * len(head), *rows))


def row(program, index, value):
    number = ours(program, value)
    published = " to ".join(value["published"]) if isinstance(value["published"], list) else value["published"]
    unit = "" if value["unit"] == "-" else f" [{value['unit']}]"
    source = index["sources"][value["source"]]
    return [f"{source['name']}, {value['place']}" + ("" if source["listed"] else " (formula from memory)"),
            f"{value['quantity']}{unit}: {value['of']}", published, value.get("independent", ""),
            number if isinstance(number, str) else f"{number:.9g}", difference(number, value["published"])]


def text_of(program, index):
    values, parts = list(values_of(index)), []
    for subject in SUBJECTS:
        rows = [row(program, index, value) for value in values if value["subject"] == subject]
        parts.append(f"## {subject}\n\n" + table(
            ["source", "quantity", "published", "independent", "rocking", "rocking - published"], rows))
    reasons = {value["note"]: value for value in values if "note" in value}
    why = [[f"{index['sources'][value['source']]['name']}, {value['place']}", note] for note, value in reasons.items()]
    cited = [[source["name"], source["citation"],
              "a list of its values" if source["listed"] else "memory of its formula, which was derived again"]
             for source in index["sources"].values()]
    return f"""# Published results, computed again

{len(values)} numbers and responses of {len(cited)} sources beside those of this program.
`experiments/published_results/write.py` runs the experiments in its folder and writes this page;
`tests/analytic/published_results_test.cpp` tests every row. Where a source is linear, the block is slender (alpha 0.001,
of orbits 0.0001) and has the source's ratio of the tilt rates; alpha is psi, W is omega/p. Formulas are evaluated to the
digits shown. "Independent" is a number that does not come from this program, where the published one is not exact.

{chr(10).join(part + chr(10) for part in parts)}
## Recorded motions

No recorded motion is part of this project; [490 shake-table tests](../experiments/shake_table.md) of two rocks are
compared elsewhere.

## Where they differ

{table(["source", "why"], why)}

## Sources

No source was opened for this page: its numbers are those of a list that was handed to us, and the citations are from memory.

{table(["source", "", "the number is from"], cited)}
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="write nothing, compare")
    parser.add_argument("--program", default=TOP / "build/release/rocking", type=pathlib.Path)
    given = parser.parse_args()
    text = text_of(given.program.resolve(), json.loads((HERE / "values.json").read_text(encoding="utf-8")))
    if not given.check:
        PAGE.write_text(text, encoding="utf-8")
    elif PAGE.read_text(encoding="utf-8") != text:
        sys.exit(f"{PAGE} does not follow from values.json and the program")


if __name__ == "__main__":
    main()
