#!/usr/bin/env python3
"""Writes reports/paper/paper.md, a manuscript, from paper.template and the published results.

usage: write.py [--check]

All numbers are taken from reports/ and from the headline's table; figures are those of the reports. It ends with exit code 1
where a finding no longer follows from the results, or where a work is cited that paper.bib lacks, or the other way round.
--check: writes nothing; exit code 1 if paper.md differs from the text that would be written.
"""

import json
import re
import string
import sys
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(TOP / "experiments" / name) for name in ("jeong_yang_2012", "shake_table")]
import tables  # noqa: E402
import text as shake_table  # noqa: E402
from cells import ATTRACTORS, READINGS, STARTS  # noqa: E402
from claims import FAILS, HOLDS, NO_REGIME, is_mode, occurrence  # noqa: E402
from intervals import Share, above  # noqa: E402
from published import Published  # noqa: E402

PAPER = TOP / "reports/paper/paper.md"


def read(path):
    return (TOP / path).read_text(encoding="utf-8")


def the(pattern, text):
    """The groups of the only match."""
    found = re.findall(pattern, text, re.MULTILINE)
    if len(found) != 1:
        sys.exit(f"{pattern!r} matches {len(found)} times")
    return found[0]


def demand(is_so, finding):
    if not is_so:
        sys.exit(f"the results no longer show this, change the template: {finding}")


def citation():
    text = read("CITATION.cff")
    keywords = the(r"^keywords:\n((?:  - .*\n)+)", text)
    return {"title": the(r'^title: "(.*)"', text), "tags": keywords.rstrip() + "\n  - C++\n  - Python",
            "authors": the(r'^authors:\n  - name: "(.*)"', text)}


def headline(friction="0.40/0.35", amplitude="4"):
    text = read("reports/headline/README.md")
    once, in_three = the(rf"^\| {friction} \| {amplitude} \| (\S+) \[.*?\] \| (\S+) \[", text)
    return {"headline_friction": friction, "headline_amplitude": amplitude, "headline_11": once, "headline_13": in_three,
            "headline_n": the(r"Per cent of (\d+) realisations", text)}


def quality():
    text = read("reports/evidence/differential.md")
    disagree = the(r"^\| disagreement \| (\d+)", text)
    return {"differential_scenes": the(r"^A manual run of (\d+) scenes", text),
            "differential_agree": the(r"^\| agreement to the end \| (\d+)", text),
            "differential_until": the(r"^\| agreement until .*? \| (\d+)", text),
            "differential_list": the(r"^\| a different list of events, .*? \| (\d+)", text),
            "differential_disagree": "none" if disagree == "0" else disagree,
            "false_alarms": the(r"^\| all \| (\d+)", read("reports/evidence/false-alarms.md"))}


def chaos():
    data = Published(TOP / "reports/jeong_yang_2012")
    right, edge = (tables.attractor_chaos(data, inertia) for inertia in ("centroidal", "edge"))
    more, less = (sum(sign * (b - a) > 0 for a, b in zip(right, edge, strict=True)) for sign in (1, -1))
    more, never = Share(more, more + less), Share(sum(count == 0 for count in right), len(right))
    demand(above(more.interval, 0.5) and above(never.interval, 0.5), "chaos needs the inertia about the edge")
    demand(all(tables.balances(data, reading) == (options[0] != "edge") for reading, options in READINGS.items()),
           "energy does not balance with the inertia about the edge")
    occurs, elsewhere = occurrence(data.series("consistent", "any", "0.35/0.30"), is_mode("chaotic"))
    demand(occurs, "there is chaos with correct mechanics")
    findings = tables.all_findings(data)
    alike = {verdict: sum(all(found["consistent", start].verdict == verdict for start in STARTS) for _, found in findings)
             for verdict in (HOLDS, FAILS, NO_REGIME)}
    *early, last = (f"{a:g}" for a in ATTRACTORS)
    return {"readings": len(READINGS), "starts": len(edge), "attractors": f"{', '.join(early)} and {last}",
            "chaos_edge": sum(edge), "chaos_right": sum(right), "chaos_of": len(READINGS) * len(ATTRACTORS) * len(edge),
            "chaos_more": more, "chaos_never": never, "chaos_elsewhere": elsewhere, "claims": len(findings),
            "claims_hold": f"{alike[HOLDS] or 'none'} hold{'s' if alike[HOLDS] < 2 else ''}",
            "claims_fail": f"{alike[FAILS]} fail", "claims_none": alike[NO_REGIME]}


def shaking_table():
    facts = json.loads(read("reports/experiments/shake_table.json"))
    score = {model: shake_table.with_interval(facts, model, "Brier") for model in facts["models"]}
    ends = {model: facts["models"][model]["intervals"]["Brier"] for model in facts["models"]}
    engine = min(brier for *_, brier in shake_table.PUBLISHED)
    demand(ends["nominal"][0] > ends["logistic"][1] and ends["inferred"][1] < ends["logistic"][0],
           "scatter makes the prediction better than the regression, no scatter worse")
    days = [abs(r["overturned"] - r["expected"]) / r["deviation"] for r in facts["by_day"]["inferred"] if r["deviation"] > 0.05]
    held = {model: f"{sum(b['holds'] for b in bins)} of {len(bins)}" for model in ("untuned", "inferred")
            for bins in [facts["models"][model]["bins"]]}
    rock_2, engine_2 = facts["rock_2"], min(brier for *_, brier in shake_table.PUBLISHED_2)
    low, high = rock_2["intervals"]["Brier"]
    demand(high < engine_2, "the second rock is predicted better than by discrete elements")
    return {"rock_2_expected": f"{rock_2['expected']:.0f}", "rock_2_overturned": rock_2["overturned"], "rock_2_engine": engine_2,
            "rock_2_brier": f"{rock_2['scores']['Brier']:.3f} [{low:.3f}, {high:.3f}]",
            "table_tests": facts["tests"], "table_overturned": facts["overturned"], "day_worst": f"{max(days):.1f}",
            "brier_engine": engine, **{f"brier_{model}": words for model, words in score.items()},
            **{f"bins_{model}": words for model, words in held.items()}}


def check_citations(text, bibliography):
    cited = set(re.findall(r"@(\w+\d{4})", text))
    known = set(re.findall(r"^@\w+\{(\w+),", bibliography, re.MULTILINE))
    if cited != known:
        sys.exit(f"cited and not in paper.bib, or in it and not cited: {', '.join(sorted(cited ^ known))}")


def main():
    if sys.argv[1:] not in ([], ["--check"]):
        sys.exit(__doc__)
    template = string.Template((Path(__file__).parent / "paper.template").read_text(encoding="utf-8"))
    text = template.substitute(citation() | headline() | quality() | chaos() | shaking_table())
    check_citations(text, read("reports/paper/paper.bib"))
    if not sys.argv[1:]:
        PAPER.write_text(text, encoding="utf-8")
    elif not PAPER.exists() or PAPER.read_text(encoding="utf-8") != text:
        sys.exit(f"{PAPER} differs from what follows from the results: run {sys.argv[0]} without --check")


main()
