#!/usr/bin/env python3
"""run.py RUNS PUBLISHED [--check]: runs the design, and publishes responses and digests as runs.json.xz. It can be stopped and
started again at any time. With --check it runs the first realisations of every published run again, and compares bits."""

import argparse
import json
import lzma
import sys
import tempfile
from pathlib import Path

from design import COMBINATIONS, name_of
from runs import FIRST, Folder, differs

HERE = Path(__file__).resolve().parent
NAMES = list(dict.fromkeys(name_of(folder, names) for folder in ("five_per_cent", "one_per_cent") for names in COMBINATIONS))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("runs", type=Path)
    parser.add_argument("published", type=Path)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--program", default=HERE.parents[1] / "build/release/rocking")
    arguments = parser.parse_args()
    kept = arguments.published / "runs.json.xz"
    if arguments.check:
        published = json.loads(lzma.open(kept, "rt").read())
        with tempfile.TemporaryDirectory() as path:
            folder = Folder(arguments.program, Path(path))
            wrong = [name for name in NAMES if differs(folder, name, published[name], HERE / f"{name}.json")]
        sys.exit(f"other results than published: {', '.join(wrong)}" if wrong else 0)
    folder = Folder(arguments.program, arguments.runs)
    for name in NAMES:
        file = HERE / f"{name}.json"
        folder.bring_to(name, FIRST, file)
        folder.first_digest(name)
        folder.bring_to(name, json.loads(file.read_text(encoding="utf-8"))["realisations"], file)
    with lzma.open(kept, "wt", preset=9) as out:
        json.dump({name: folder.published(name) for name in NAMES}, out)


if __name__ == "__main__":
    main()
