#!/usr/bin/env python3
"""How often the inferred intensity of a cemetery covers the true one. Writes cemeteries.json and .md of reports/experiments.

usage: coverage.py [--check]

Takes a quarter of an hour on one processor. --check: computes and writes nothing; exit code 1 if cemeteries.md differs from the text
that follows from cemeteries.json.
"""

import functools
import json
import math
import pathlib
import random
import statistics
import subprocess
import sys
import tempfile

TOP = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(TOP / "experiments/support"), str(TOP / "experiments/beyond_the_paper")]
from rocking_module import rocking  # noqa: E402
from write_report import table, wrapped  # noqa: E402

SCENE = json.loads(pathlib.Path(__file__).with_name("cemetery.json").read_text())
FACTS = TOP / "reports/experiments/cemeteries.json"
CEMETERIES = 200
MOTIONS = 20
STONES = 40  # of a cemetery whose motion is not known
HIDDEN = (0.15, 0.7)  # PGA [g], uniform in its logarithm
SEARCHED = {"pga_g": (0.02, 1.5), "pgv_m_s": (0.02, 2.0)}
KINDS = (0.7, 1.1)  # mean heights [m]
HEIGHT = "/block/height_m/lognormal/mean"


def scene(motion, **changed):
    """The experiment of this folder under another motion."""
    return SCENE | {"excitation": {"kind": "recorded", "file": str(motion), "pga_g": 0.3}, "realisations": 200} | changed


def fallen(motion, pga, stones, seed, height=0.9):
    """How many of the stones of a made-up cemetery overturn."""
    block = SCENE["block"] | {"height_m": {"lognormal": {"mean": height, "sigma": 0.2}}}
    cemetery = scene(motion, block=block, realisations=stones, seed=hex(seed))
    del cemetery["unknown"]
    cemetery["excitation"]["pga_g"] = pga
    result = rocking.run(cemetery, threads=1)
    return int(result.counts[0][result.modes.index("overturned")])


def inferred(motion, rows, seed, measure="pga_g"):
    """The interval of the measure from lines of counts, and the ends of its range that it reaches."""
    low, high = SEARCHED[measure]
    asked = scene(motion, seed=hex(seed), unknown=[{"parameter": f"/excitation/{measure}", "from": low, "to": high}])
    asked["excitation"] = {"kind": "recorded", "file": str(motion), measure: 0.3}
    with tempfile.NamedTemporaryFile("w", suffix=".csv") as tests:
        tests.write("\n".join(rows) + "\n")
        tests.flush()
        unknown, = rocking.infer(asked, tests.name, threads=1).unknowns
    return *(float(end) for end in unknown.interval), str(unknown.reaches)


def facts_of(truths, intervals):
    """Counts of the intervals that contain the truth, and the typical width of those with two ends."""
    closed = [high / low for low, high, reaches in intervals if reaches == "none"]
    return {"covered": sum(low <= truth <= high for truth, (low, high, _) in zip(truths, intervals)),
            "below": sum(truth < low for truth, (low, _, _) in zip(truths, intervals)),
            "above": sum(truth > high for truth, (_, high, _) in zip(truths, intervals)),
            "reaching": sum(reaches != "none" for _, _, reaches in intervals), "width": statistics.median(closed)}


def hull(intervals):
    """From the least end to the largest one."""
    ends = {end for _, _, reaches in intervals for end in ("from", "to") if reaches in (end, "both")}
    return (min(low for low, _, _ in intervals), max(high for _, high, _ in intervals),
            "both" if len(ends) == 2 else (ends or {"none"}).pop())


def known_motions(hidden, motions):
    """Cemeteries whose motion is recorded: with stones of one kind, and of two kinds."""
    one, two = [], []
    for i, (pga, motion, stones) in enumerate(hidden):
        count = fallen(motions[motion], pga, stones, 1_000_000 + i)
        one.append(inferred(motions[motion], ["overturned,other", f"{count},{stones - count}"], i + 1))
        rows = ["/block/height_m/lognormal/mean,overturned,other"]
        for k, height in enumerate(KINDS):
            count = fallen(motions[motion], pga, stones // 2, 2_000_000 + 2 * i + k, height)
            rows.append(f"{height},{count},{stones // 2 - count}")
        two.append(inferred(motions[motion], rows, i + 1))
        if i % 20 == 19:
            print(f"known motions: {i + 1} cemeteries", flush=True)
    truths = [pga for pga, _, _ in hidden]
    return {"one kind": facts_of(truths, one), "two kinds": facts_of(truths, two)}


def unknown_motions(hidden, motions, velocities):
    """Cemeteries whose motion is not recorded: inferred with one other motion, and with all the others."""
    counts = [fallen(motions[motion], pga, STONES, 3_000_000 + i) for i, (pga, motion, _) in enumerate(hidden)]
    found = {}
    for measure in SEARCHED:
        @functools.cache
        def of(motion, count, measure=measure):
            return inferred(motions[motion], ["overturned,other", f"{count},{STONES - count}"], 1 + motion, measure)

        truths = [pga if measure == "pga_g" else pga * velocities[motion] for pga, motion, _ in hidden]
        single = [of((motion + 1) % MOTIONS, count) for count, (_, motion, _) in zip(counts, hidden)]
        others = [hull([of(other, count) for other in range(MOTIONS) if other != motion])
                  for count, (_, motion, _) in zip(counts, hidden)]
        found[measure] = {"one other": facts_of(truths, single), "all others": facts_of(truths, others)}
        print(f"unknown motions: {measure}", flush=True)
    return found


def measure():
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([sys.executable, TOP / "experiments/museum/make_motions.py", folder, "--count", str(MOTIONS),
                        "--seed", "1975"], check=True)
        motions = sorted(pathlib.Path(folder).glob("*.at2"))
        measures = rocking.motion([str(path) for path in motions], series=False).motions
        source = random.Random(72)
        hidden = [(math.exp(source.uniform(*map(math.log, HIDDEN))), i % MOTIONS, source.randrange(20, 61))
                  for i in range(CEMETERIES)]
        facts = {"known": known_motions(hidden, motions),
                 "unknown": unknown_motions(hidden, motions, [each.pgv_m_s / each.pga_g for each in measures])}
    return facts


def row(name, facts):
    low, high = rocking.clopper_pearson(facts["covered"], CEMETERIES)
    return [name, f"{facts['covered']} of {CEMETERIES}", f"{100 * low:.1f} to {100 * high:.1f} %",
            f"{facts['below']}, {facts['above']}", facts["reaching"], f"{facts['width']:.2f}"]


def text_of(facts):
    head = ["inferred with", "cover the truth", "exact 95 % interval of the share", "truth below, above", "reach an end", "high/low"]
    known = [row("the motion; stones of one kind", facts["known"]["one kind"]),
             row("the motion; stones of two kinds", facts["known"]["two kinds"])]
    names = {"pga_g": "PGA", "pgv_m_s": "PGV"}
    unknown = [row(f"{'one other motion' if way == 'one other' else f'{MOTIONS - 1} other motions'}, {names[measure]}",
                   facts["unknown"][measure][way]) for measure in SEARCHED for way in ("one other", "all others")]
    one, all_pga, all_pgv = (facts["unknown"]["pga_g"]["one other"], facts["unknown"]["pga_g"]["all others"],
                             facts["unknown"]["pgv_m_s"]["all others"])
    return wrapped(f"""# {CEMETERIES} cemeteries with a hidden intensity

Each cemetery is made up: stones of random size (`experiments/cemetery/cemetery.json`) stand under one of {MOTIONS} synthetic
motions, scaled to a hidden PGA between {HIDDEN[0]} and {HIDDEN[1]} g, and the fallen ones are counted. `rocking infer` then searches
for the intensity. `experiments/cemetery/coverage.py` computes all numbers; stones and inference have different random numbers.

## The motion is known

A cemetery has 20 to 60 stones. *One kind*: all have the law of the file. *Two kinds*: half of them have a mean height of
{KINDS[0]} m, half of {KINDS[1]} m, counted apart.

{table(head, known)}

The intervals are to contain the truth in 95 % of the cemeteries. *Reach an end*: intervals that begin or end with the range that
was searched, as where no stone fell or all did; there the answer is `at most` or `at least`. *high/low*: median ratio of the ends
of the others.

## The motion is not known

{STONES} stones; the motion that shook them is not among those of the inference.

{table(head, unknown)}

- *One motion that is not the right one is not enough.* {one['covered']} of {CEMETERIES} intervals of the PGA contain the truth. They hold
  the chance of the stones, and not that of the motion.
- *Many motions.* Infer with each motion that is possible, and take the answer from the least end of all intervals to the largest one. With
  {MOTIONS - 1} motions {all_pga['covered']} of {CEMETERIES} of these contain the PGA and {all_pgv['covered']} the PGV.
- *Which measure.* The answer in PGA spans a factor of {all_pga['width']:.1f}, the one in PGV of {all_pgv['width']:.1f}.
""")


def main():
    if sys.argv[1:] not in ([], ["--check"]):
        sys.exit(__doc__)
    page = FACTS.with_suffix(".md")
    if sys.argv[1:]:
        if page.read_text() != text_of(json.loads(FACTS.read_text())):
            sys.exit(f"{page} does not follow from {FACTS}")
        return
    FACTS.write_text(json.dumps(measure(), indent=1) + "\n")
    page.write_text(text_of(json.loads(FACTS.read_text())))


if __name__ == "__main__":
    main()
