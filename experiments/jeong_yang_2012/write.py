#!/usr/bin/env python3
"""write.py PUBLISHED [--check]: README.md, reference.md and windows.md of the published results.

With --check it writes nothing, and fails if a page differs from the text that would be written."""

import argparse
import re
import string
import sys
import textwrap
from pathlib import Path

import figures
import survival
import tables
import windows
from attractors import POINTS
from cells import CELLS, FRICTIONS, READINGS, RUNS, STARTS, experiment
from claims import ENOUGH, HOLDS, occurrence, is_mode
from intervals import LEVEL, Share, above, level_of
from published import Published

PAGES = {"README.md": "page.template", "reference.md": "reference.template"}


def runs_table(data):
    """Runs, those of one file in one row."""
    rows = []
    kinds = {name: CELLS[name][0] if name in CELLS else name for name in RUNS}
    for kind in dict.fromkeys(kinds.values()):
        found = [run for name, run in data.runs.items() if kinds[name] == kind]
        sizes = sorted({max(map(len, run["rows"])) for run in found})
        rows.append((f"`{kind}.json`", found[0]["experiment"]["title"].split(" Reading:")[0], len(found),
                     sum(len(run["rows"]) for run in found), " to ".join(map(str, dict.fromkeys((sizes[0], sizes[-1])))),
                     sum(len(row) for run in found for row in run["rows"]),
                     f"{sum(run['system']['duration_s'] for run in found) / 60:.0f} min"))
    return tables.table(("experiment", "title", "runs", "conditions", "realisations of each", "realisations", "time"), rows)


def skewness_words(check):
    found = check["skewness"]
    near = found["nearness"][0]
    sure = ("so this criterion does not distinguish samplers" if 0.05 < near["probability"] < 0.95
            else "so this criterion distinguishes samplers")
    held = "holds" if abs(found["value"]) < near["distance"] else "fails"
    return (f"This program: {found['value']:+.4f}, standard error {found['standard_error']:.4f}; the claim {held} for this "
            f"sample. The skewness of a true normal sample of this size is that close to 0 with probability "
            f"{near['probability']:.2f}, {sure}.")


def numbers(findings, reading, verdict):
    """Claims with this verdict from every start, as text."""
    found = [str(i) for i, (_, cells) in enumerate(findings, 1)
             if all(cells[reading, start].verdict == verdict for start in STARTS)]
    return ", ".join(found) or "none"


def answers(data, findings):
    lines = []
    for reading, words in (("consistent", "Under right mechanics"), ("as-printed", "Under the equations as printed"),
                           ("as-plotted", "Under the reading nearest to the figures")):
        told = "; ".join(f"{verdict}: {numbers(findings, reading, verdict)}" for verdict in tables.VERDICTS)
        lines.append(f"{words} (`{reading}`), claims with one verdict from all starts: {told}. The others depend on the start.")
    lines[-1] += " Claims marked ‡ below are no evidence for this reading."
    lines += [f"{tables.independent_words(findings)}.", chaos_words(data), f"{tables.quasi_periodic_words(data)}.",
              energy_words(data)]
    return "\n".join("- " + line for line in lines)


def chaos_words(data):
    """The cause of the chaos at the paper's amplitudes. Starts are the independent trials; the readings share them."""
    right, edge = (tables.attractor_chaos(data, inertia) for inertia in ("centroidal", "edge"))
    more, less = (sum(sign * (b - a) > 0 for a, b in zip(right, edge)) for sign in (1, -1))
    never = Share(sum(count == 0 for count in right), len(right))
    more = Share(more, more + less)
    rests = above(more.interval, 0.5) and above(never.interval, 0.5)
    opening = ("The chaos at A_h = 6.6, 8 and 9 is due to the inertia about the edge, with which energy does not balance"
               if rests else "Whether the chaos at A_h = 6.6, 8 and 9 is due to the inertia about the edge is not decided")
    cells = len(READINGS) * 3
    elsewhere = "; ".join(f"{occurrence(data.series('consistent', 'any', pair), is_mode('chaotic'))[1]} with {pair}"
                          for pair in FRICTIONS)
    return (f"{opening}. From any start, {sum(edge)} of {cells * len(edge)} realisations are chaotic with it, and "
            f"{sum(right)} of {cells * len(right)} with the inertia about the centre of mass, over all values of the other "
            f"two options. Of the starts for which the inertia makes a difference, {more} have more chaos with the inertia "
            f"about the edge; {never} have no chaos at all with the inertia about the centre of mass. Under `consistent`, "
            f"chaos with fixed friction at one of all amplitudes or more: {elsewhere}.")


def energy_words(data):
    good = [reading for reading in READINGS if tables.balances(data, reading)]
    bad = [reading for reading in READINGS if reading not in good]
    return (f"Energy balances under {', '.join(f'`{name}`' for name in good)}; it does not under "
            f"{', '.join(f'`{name}`' for name in bad)}.")


def values(data):
    findings = tables.all_findings(data)
    horizon = experiment("regions_consistent_any")["horizon"]
    counts = tables.tallies(findings)
    systems = [run["system"] for run in data.runs.values()]
    flips = [run["tolerance"] for run in data.runs.values() if run["tolerance"]]
    return {
        "answers": answers(data, findings),
        "claims_table": tables.claims_table(findings),
        "level_words": tables.level_words(findings),
        "level_table": tables.table(("claim", "reading", "start", "verdict", "over all claims"), tables.level_changes(findings)),
        "level_over_all": f"{100 * level_of(len(findings)):.4f}",
        "independent_table": tables.independent_table(findings),
        "used": "{} to {}".format(*(tables.of_fixed_friction(findings)[i] for i in (0, -1))),
        "survival_words": survival.page_words(data),
        "looked_table": survival.looked_table(data),
        "later_words": survival.later_words(data),
        "rates_table": survival.rates_table(data),
        "exponential_words": survival.exponential_words(data),
        "initial": survival.INITIAL,
        "limit": survival.LIMIT,
        "figures_table": tables.figures_table(data),
        "runs_table": runs_table(data),
        "skewness": skewness_words(data.measures["normal"]),
        "claim_sections": tables.claim_sections(findings),
        "claim_count": len(findings),
        "tally_table": tables.tally_table(findings),
        "energy_table": tables.energy_table(data),
        "chaos_table": tables.chaos_table(data),
        "chaos_by_option": tables.chaos_by_option(data),
        "attractors_table": tables.attractors_table(data),
        "recurrence_table": tables.recurrence_table(data),
        "between_table": tables.between_table(data),
        "settling_table": tables.settling_table(data),
        "level": f"{100 * LEVEL:.2f}",
        "points": f"{ENOUGH * POINTS:,}".replace(",", " "),
        "enough": ENOUGH,
        "segment": POINTS,
        "dropped": horizon["transient_periods"],
        "sampled": horizon["sampled_periods"],
        "at_most": horizon["until_classified"]["at_most_periods"],
        "at_most_diagrams": experiment("diagrams_consistent_any")["horizon"]["until_classified"]["at_most_periods"],
        "at_most_fixed": experiment("rest_fixed_friction")["horizon"]["until_classified"]["at_most_periods"],
        "undecidable": sum(count[-1] for count in counts.values()),
        "holding": sum(finding.verdict == HOLDS for _, found in findings for finding in found.values()),
        "all_verdicts": len(findings) * len(counts),
        "realisations": f"{sum(len(row) for run in data.runs.values() for row in run['rows']):,}".replace(",", " "),
        "minutes": f"{sum(system['duration_s'] for system in systems) / 60:.0f}",
        "machine": systems[0]["machine"],
        "reruns": f"{sum(each['flips'] for each in flips)} of {sum(each['of'] for each in flips)}",
    }


def wrapped(text):
    """The text with its prose wrapped at 120 characters; tables, titles, pictures and code are not changed."""
    blocks = []
    for block in text.split("\n\n"):
        if block.startswith(("|", "#", "!", "    ")):
            blocks.append(block)
            continue
        items = re.split(r"\n(?=- )", block)
        wrap = textwrap.TextWrapper(120, break_long_words=False, break_on_hyphens=False)
        for i, item in enumerate(items):
            wrap.subsequent_indent = "  " if item.startswith("- ") else ""
            items[i] = wrap.fill(" ".join(item.split()))
        blocks.append("\n".join(items))
    return "\n\n".join(blocks).rstrip() + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("published", type=Path)
    parser.add_argument("--check", action="store_true")
    arguments = parser.parse_args()
    data, here = Published(arguments.published), Path(__file__).parent
    found = values(data)
    pages = {page: string.Template((here / template).read_text(encoding="utf-8")).substitute(found)
             for page, template in PAGES.items()}
    pages["windows.md"] = windows.text(data)
    for page, text in pages.items():
        path = arguments.published / page
        if not arguments.check:
            path.write_text(wrapped(text), encoding="utf-8")
        elif not path.exists() or path.read_text(encoding="utf-8") != wrapped(text):
            sys.exit(f"{path} differs from what write.py writes for the results in its folder: run write.py without --check")
    if not arguments.check:
        figures.draw_all(data, arguments.published / "figures")


if __name__ == "__main__":
    main()
