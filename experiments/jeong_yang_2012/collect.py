#!/usr/bin/env python3
"""collect.py RUNS PUBLISHED: makes the published results from what run.py and `all` have run. The attractors that it
compares are simulated here, where they are not kept in RUNS from an earlier call."""

import argparse
import itertools
import json
import lzma
import sys
from pathlib import Path

import attractors
import survival
from cells import FRICTIONS, READINGS, RUNS, STARTS, experiment
from published import Live, place_of, read

TOP = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TOP / "experiments/support"))
from runs import Folder  # noqa: E402

DIAGRAMS = {None: "figure_03", "0.40/0.35": "figure_04", "0.35/0.30": "figure_05"}


def conditions_of(file):
    """Parameters of each condition of a grid; all sweep entries must have `values`."""
    entries = read(file)["sweep"]
    for values in itertools.product(*(entry["values"] for entry in entries)):
        yield {entry["parameter"]: value for entry, value in zip(entries, values)}


def energy_rows(conditions, energies):
    """One row for each trajectory: the energy account, as shares of the work that friction and impacts take."""
    rows = []
    for parameters, energy in zip(conditions, energies, strict=True):
        reading, start, friction, _, amplitude = place_of(parameters, True)
        spent = energy["lost_in_impacts"] - energy["friction_work"]
        rows.append({"reading": reading, "start": start, "friction": friction, "amplitude": amplitude,
                     "unaccounted": energy["unaccounted"] / spent, "gained_in_impacts": energy["gained_in_impacts"] / spent})
    return rows


def diagram_rows(runs):
    """Response modes along the amplitude, from rest and by continuation, of the readings whose windows are described."""
    rows = []
    for friction, file in DIAGRAMS.items():
        for diagram in read(runs / file / "bifurcation.json")["diagrams"]:
            others, phase = diagram["others"], diagram["others"]["/excitation/phase_rad"]
            reading = others.get("/formulation", "without sliding")
            if reading == "as-printed" or others.get("/restitution") == "jy25":
                continue
            start = next(name for name, (_, wanted) in STARTS.items() if wanted == phase)
            for branch in ("initial", "upwards", "downwards"):
                steps = [[step["value"], step["mode"]] for step in diagram["steps"] if step["branch"] == branch]
                rows.append({"reading": reading, "friction": friction, "start": start, "branch": branch,
                             "steps": sorted(steps)})
    return rows


def compressed(path, found):
    with lzma.open(path, "wt", preset=9) as file:
        json.dump(found, file)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("runs", type=Path)
    parser.add_argument("published", type=Path)
    parser.add_argument("--program", default=TOP / "build/release/rocking")
    arguments = parser.parse_args()
    runs, published = arguments.runs, arguments.published
    folder = Folder(arguments.program, runs)
    compressed(published / "runs.json.xz", {name: folder.published(name) for name in RUNS})
    energies = [read(path)["energy"] for path in sorted((runs / "energy").glob("*.json"))]
    kept = runs / "attractors.json"
    if not kept.exists():
        rows = list(attractors.rows(Live(runs), arguments.program, runs / "points"))
        kept.write_text(json.dumps(rows), encoding="utf-8")
    measures = {
        "normal": read(runs / "figure_02.json"),
        "energy": energy_rows(conditions_of(Path(__file__).parent / "figure_06.json"), energies),
        "attractors": read(kept),
        "diagrams": diagram_rows(runs),
        "survival": list(survival.rows(runs)),
    }
    for orbits in sorted((runs / "branches").glob("*/orbits.json")):
        compressed(published / "branches" / f"{orbits.parent.name}.json.xz", read(orbits))
    (published / "branches" / "routes.json").write_text((runs / "routes.json").read_text(encoding="utf-8"), encoding="utf-8")
    compressed(published / "measures.json.xz", measures)


if __name__ == "__main__":
    main()
