#!/usr/bin/env python3
"""collect.py RUNS PUBLISHED: makes the published results from what `all` has run; reads only, simulates nothing."""

import itertools
import json
import lzma
import sqlite3
import sys
from pathlib import Path

from measures import attractor_rows, diagram_rows, energy_rows
from published import RUNS, read


def modes_of(store):
    """The modes that occur, and for each condition a list of the index of each realisation's mode among them."""
    with sqlite3.connect(f"file:{store}?mode=ro", uri=True) as connection:
        rows = connection.execute("SELECT condition, mode FROM realisations ORDER BY condition, realisation").fetchall()
    modes = sorted({mode for _, mode in rows})
    conditions = itertools.groupby(rows, key=lambda row: row[0])
    return {"modes": modes, "conditions": [[modes.index(mode) for _, mode in group] for _, group in conditions]}


def conditions_of(experiment):
    """Parameters of each condition of a grid; all sweep entries must have `values`."""
    entries = experiment["sweep"]
    for values in itertools.product(*(entry["values"] for entry in entries)):
        yield {entry["parameter"]: value for entry, value in zip(entries, values)}


def write_compressed(path, text):
    with lzma.open(path, "wt", preset=9) as file:
        file.write(text)


def main(runs, published):
    here = Path(__file__).parent
    published.mkdir(parents=True, exist_ok=True)
    for name in RUNS:
        write_compressed(published / f"{name}.json.xz", (runs / name / "report.json").read_text(encoding="utf-8"))
    stores = {name: modes_of(runs / name / "realisations.sqlite") for name in RUNS}
    write_compressed(published / "realisations.json.xz", json.dumps(stores))
    attractors = read(here / "figure_06.json")
    energies = [read(path)["energy"] for path in sorted((runs / "energy").glob("*.json"))]
    diagrams = [read(runs / f"figure_09_{k}" / "bifurcation.json") for k in range(10)]
    measures = {
        "normal": read(runs / "figure_02.json"),
        "energy": energy_rows(conditions_of(attractors), energies),
        "attractors": attractor_rows(*(read(runs / name / "bifurcation.json") for name in ("figure_06", "figure_08"))),
        "diagrams": diagram_rows(diagrams),
    }
    (published / "measures.json").write_text(json.dumps(measures, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
