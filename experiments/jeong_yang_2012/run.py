#!/usr/bin/env python3
"""run.py RUNS: runs what the claims rest on, and samples more where a claim is undecided. It can be stopped and started
again at any time: what is finished is kept.

run.py --check PUBLISHED: runs the first realisations of every published run again, and compares bits and responses.

run.py --experiment NAME: prints the experiment of a run, for example of regions_as-plotted_any."""

import argparse
import json
import sys
import tempfile
from pathlib import Path

from attractors import too_few
from cells import RUNS, experiment, sizes
from claims import undecided
from published import Live, read

TOP = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TOP / "experiments/support"))
from runs import FIRST, Folder, differs  # noqa: E402


def sample(folder, name):
    """Runs until the claims that rest on the run are decided, or to the limit."""
    text = json.dumps(experiment(name))
    folder.bring_to(name, min(FIRST, sizes(name)[0]), text)
    folder.first_digest(name)
    for size in sizes(name):
        folder.bring_to(name, size, text)
        data = Live(folder.path)
        if not (too_few(data.modes(name)) if name.startswith("attractors") else undecided(name, data)):
            return


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", type=Path, nargs="?")
    parser.add_argument("--check", type=Path, metavar="PUBLISHED")
    parser.add_argument("--experiment", choices=RUNS, metavar="NAME")
    parser.add_argument("--program", default=TOP / "build/release/rocking")
    arguments = parser.parse_args()
    if arguments.experiment:
        print(json.dumps(experiment(arguments.experiment), indent=1))
        return
    if not arguments.check:
        for name in RUNS:
            sample(Folder(arguments.program, arguments.runs), name)
        return
    published = read(arguments.check / "runs.json.xz")
    with tempfile.TemporaryDirectory() as path:
        folder = Folder(arguments.program, Path(path))
        wrong = [name for name in RUNS if differs(folder, name, published[name], json.dumps(experiment(name)))]
    sys.exit(f"other results than published: {', '.join(wrong)}" if wrong else 0)


if __name__ == "__main__":
    main()
