#!/usr/bin/env python3
"""write.py PUBLISHED [--check]: README.md of the published results, from the template and the results.

With --check it writes nothing, and fails if README.md differs from the text that would be written."""

import argparse
import math
import re
import string
import sys
import textwrap
from pathlib import Path

import tables
from intervals import beyond_half, share
from measures import SEGMENT, VISIBLE
from published import FRICTIONS, READINGS, Published
from tables import result, table


def runs_table(data):
    rows = []
    for name, report in data.reports.items():
        conditions = report["result"]["conditions"]
        total = sum(condition["realisations"] for condition in conditions)
        rows.append((f"`{name}.json`", report["input"]["experiment"]["title"], len(conditions), total,
                     f"`{report['result']['digest'][:12]}`"))
    return table(("experiment", "title", "conditions", "realisations", "digest begins"), rows)


def skewness_words(check):
    found = check["skewness"]
    near = found["nearness"][0]
    by_chance = 0.05 < near["probability"] < 0.95
    sure = ("so this criterion does not distinguish samplers" if by_chance
            else "so this criterion distinguishes samplers")
    held = "holds" if abs(found["value"]) < near["distance"] else "fails"
    return (f"This program: {found['value']:+.4f}, standard error {found['standard_error']:.4f}; the claim {held} for this "
            f"sample. The skewness of a true normal sample of this size is that close to 0 with probability "
            f"{near['probability']:.2f}, {sure}.")


def answers(data, findings):
    results = [result(found) for _, found in findings]

    def numbers(first):
        return [str(i) for i, words in enumerate(results, 1) if words.startswith(first)]
    def told(first):
        return f"{len(numbers(first))} ({', '.join(numbers(first)) or 'none'})"
    lines = [f"Of {len(findings)} claims: hold in all cells that can be judged: {told('holds')}; fail in all of them: "
             f"{told('fails')}; depend on the reading or the start: {told('depends')}; cannot be judged: "
             f"{len(numbers('open'))}.", tables.nearest(findings),
             tables.under(findings, "consistent"), chaos_words(data), energy_words(data),
             recurrence_words(data)]
    return "\n".join("- " + line for line in lines)


def chaos_words(data):
    """The cause of the chaos at the paper's amplitudes. Starts are the independent trials; the readings share them."""
    right, edge = (tables.attractor_chaos(data, inertia) for inertia in ("centroidal", "edge"))
    more = sum(b > a for a, b in zip(right, edge))
    less = sum(b < a for a, b in zip(right, edge))
    never = sum(count == 0 for count in right)
    rests = beyond_half(more, more + less) and beyond_half(never, len(right))
    opening = ("The chaos at A_h = 6.6, 8 and 9 is due to the inertia about the edge, with which energy does not balance"
               if rests else "Whether the chaos at A_h = 6.6, 8 and 9 is due to the inertia about the edge is open")
    cells = 2 * len(READINGS) // 2 * len(tables.ATTRACTORS)
    elsewhere = "; ".join(f"{tables.chaos_somewhere(data.series('consistent', 'any', pair))} with {pair}"
                          for pair in FRICTIONS)
    alone = []
    for pair in FRICTIONS:
        series = data.series("edge", "any", pair)
        alone.append(f"{tables.chaos_somewhere({a: series[a] for a in tables.ATTRACTORS})} with {pair}")
    return (f"{opening}. From any start, {sum(edge)} of {cells * len(edge)} realisations are chaotic with it, and "
            f"{sum(right)} of {cells * len(right)} with the inertia about the centre of mass, over all values of the other "
            f"two options. Of the starts for which the inertia makes a difference, {share(more, more + less)} have more "
            f"chaos with the inertia about the edge; {share(never, len(right))} of the starts have no chaos at all with "
            f"the inertia about the centre of mass. With the inertia about the edge as the only deviation (`edge`), the starts "
            f"that are chaotic at one of the three amplitudes or more are {'; '.join(alone)}. With consistent mechanics "
            f"(`consistent`), the starts that are chaotic at one of all amplitudes or more are {elsewhere}.")


def energy_words(data):
    good = [reading for reading in READINGS if tables.balances(data, reading)]
    bad = [reading for reading in READINGS if reading not in good]
    return (f"Energy balances under {', '.join(f'`{name}`' for name in good)}; it does not under "
            f"{', '.join(f'`{name}`' for name in bad)} (section 6).")


def recurrence_words(data):
    parts = []
    for reading in ("consistent", "as-plotted"):
        for pair in FRICTIONS:
            friction, start, flipped = tables.recurrence_means(data, reading, pair, 0.03)
            parts.append(f"`{reading}`, {pair}: {friction} % by friction, {start} % by the initial state; {flipped} modes "
                         f"changed in reruns at a tighter tolerance")
    return ("The probability that two runs under equal conditions with sigma 0.03 differ in response, as a mean over the "
            "amplitudes (section 7): " + ". ".join(parts) + ".")


def step_of(data, name):
    """Between the amplitudes of a run."""
    entries = data.reports[name]["input"]["experiment"]["sweep"]
    return next(entry["step"] for entry in entries if entry["parameter"] == "/excitation/amplitude")


def values(data):
    findings = tables.all_findings(data)
    horizon = data.reports["rest_fixed_friction"]["input"]["experiment"]["horizon"]
    block = data.reports["rest_fixed_friction"]["input"]["experiment"]["block"]
    reports = data.reports.values()
    recurring = data.reports["non_recurrence"]["result"]["conditions"][0]["realisations"]
    few = min(c["realisations"] for name in ("rest_fluctuating_friction", "any_start_fluctuating_friction")
              for c in data.reports[name]["result"]["conditions"])
    starts = data.reports["any_start_fixed_friction"]["result"]["conditions"][0]["realisations"]
    amplitudes, shaken = (sorted(data.series("consistent", "any", FRICTIONS[0], sigma)) for sigma in (0.0, 0.03))
    return {
        "answers": answers(data, findings),
        "jy25": f"{1.0 - 1.5 * math.sin(math.atan2(block['width_m'], block['height_m'])) ** 2:.3f}",
        "runs_table": runs_table(data),
        "amplitudes": ", ".join(f"{a:g}" for a in amplitudes),
        "shaken_amplitudes": ", ".join(f"{a:g}" for a in shaken),
        "claims_table": tables.claims_table(findings),
        "skewness": skewness_words(data.measures["normal"]),
        "claim_sections": tables.claim_sections(findings),
        "claim_count": len(findings),
        "tally_table": tables.tally_table(findings),
        "nearest": tables.nearest(findings),
        "energy_table": tables.energy_table(data),
        "chaos_table": tables.chaos_table(data),
        "chaos_at_three": tables.chaos_at_three(data),
        "chaos_by_option": tables.chaos_by_option(data),
        "chaos_words": chaos_words(data),
        "recurrence_n": recurring,
        "start_n": starts,
        "recurrence_summary": tables.recurrence_summary(data),
        "recurrence_consistent": tables.recurrence_by_amplitude(data, "consistent"),
        "recurrence_plotted": tables.recurrence_by_amplitude(data, "as-plotted"),
        "diagrams_by_mode": tables.diagrams_by_mode(data),
        "diagram_table": tables.diagram_table(data),
        "visible": VISIBLE,
        "between_table": tables.between_table(data),
        "few": few,
        "rare": f"{1 - 0.05 ** (1 / few):.2f}",
        "shaken_count": len(shaken),
        "steady_count": len(amplitudes),
        "dropped": horizon["transient_periods"],
        "sampled": horizon["sampled_periods"],
        **{f"step_of_{name}": step_of(data, name)
           for name in ("rest_no_sliding", "rest_fixed_friction", "figure_09", "figure_10")},
        "segment": SEGMENT,
        "attractor_points": 4 * SEGMENT,
        "repeats": data.reports["figure_10"]["result"]["conditions"][0]["realisations"],
        "chaos_windows": tables.chaos_windows(data, "consistent"),
        "minutes": f"{sum(report['system']['duration_s'] for report in reports) / 60:.0f} min",
        "threads": max(report["system"]["threads"] for report in reports),
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
    template = (Path(__file__).parent / "report.template").read_text(encoding="utf-8")
    text = wrapped(string.Template(template).substitute(values(Published(arguments.published))))
    readme = arguments.published / "README.md"
    if not arguments.check:
        readme.write_text(text, encoding="utf-8")
    elif not readme.exists() or readme.read_text(encoding="utf-8") != text:
        sys.exit(f"{readme} differs from what write.py writes for the results in its folder: run write.py without --check")


if __name__ == "__main__":
    main()
