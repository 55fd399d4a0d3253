#!/usr/bin/env python3
"""Writes README.md and the pictures of reports/beyond_the_paper from the reports there.

usage: write_report.py [--check]

--check: writes nothing; exit code 1 if README.md differs from the text that would be written.
"""

import json
import lzma
import pathlib
import re
import sys
import textwrap

import figures
from design import COMBINATIONS, EFFECTS, MOMENTS, QUANTITIES, SOURCES, Design
from runs import decoded

HERE = pathlib.Path(__file__).resolve().parent
PUBLISHED = HERE.parents[1] / "reports" / "beyond_the_paper"
SHOWN = (2.0, 4.0, 5.0, 6.0, 8.0, 10.0)  # amplitudes of the tables of responses
ALL = (*QUANTITIES, "non-recurrence")
CURVES = ("harmonic_reference", "harmonic_slender", "recorded_reference", "recorded_slender")


def per_cent(share, digits=0):
    return f"{100 * share + 0.0:.{digits}f}"


def table(head, rows):
    lines = ["| " + " | ".join(map(str, row)) + " |" for row in (head, ["---"] * len(head), *rows)]
    return "\n".join(lines)


def name(names):
    return figures.spoken(names)


def cell_text(design, names, amplitude, quantity):
    _, estimate, low, high = design.cells[names][amplitude].term(quantity, 1, design.level(is_simultaneous=False))
    return f"{per_cent(estimate)} [{per_cent(low)}, {per_cent(high)}]"


def response_tables(design):
    parts = []
    for quantity in ALL:
        rows = [[name(names)] + [cell_text(design, names, a, quantity) for a in SHOWN] for names in COMBINATIONS]
        parts.append(f"**{quantity}, {design.moment}**\n\n" + table(["fluctuates"] + [f"A_h = {a:g}" for a in SHOWN], rows))
    return "\n\n".join(parts)


def clear_effects(design, names, quantity):
    """(amplitude, effect) where the interval does not contain 0, the largest first."""
    found = [(a, design.effect(names, quantity, a)) for a in design.amplitudes]
    return sorted(((a, e) for a, e in found if e[1] > 0 or e[2] < 0), key=lambda item: -abs(item[1][0]))


def excluded(design, names, quantity):
    """The largest effect that no interval excludes, over the amplitudes where none is clear."""
    found = [design.effect(names, quantity, a) for a in design.amplitudes]
    return max((max(-e[1], e[2]) for e in found if e[1] <= 0 <= e[2]), default=0.0)


def effect_table(design):
    rows = []
    for names in EFFECTS:
        row = [" × ".join(names)]
        for quantity in ALL:
            clear = clear_effects(design, names, quantity)
            rest = f"others below {per_cent(excluded(design, names, quantity), 1)}"
            if not clear:
                row.append("0; all" + rest[6:])
                continue
            amplitude, (value, low, high) = clear[0]
            row.append(f"{len(clear)}; {per_cent(value, 1)} [{per_cent(low, 1)}, {per_cent(high, 1)}] at {amplitude:g}"
                       + ("" if len(clear) == len(design.amplitudes) else f"; {rest}"))
        rows.append(row)
    return table(["effect"] + list(ALL), rows)


def clear_counts(design, effects):
    return {names: sum(len(clear_effects(design, names, q)) for q in QUANTITIES) for names in effects}


def summary(design):
    """Which sources and which combinations of sources have effects."""
    of = len(design.amplitudes) * len(QUANTITIES)
    parts = []
    for title, effects in (("main effects", [names for names in EFFECTS if len(names) == 1]),
                           ("interactions", [names for names in EFFECTS if len(names) > 1])):
        clear = clear_counts(design, effects)
        parts.append(f"{title}: " + ", ".join(f"{' × '.join(names)} {count}" for names, count in clear.items()))
    words = (f"At {per_cent(design.relative_sigma)} %, {design.moment}, significant effects of the {of} of each (responses times "
             f"amplitudes): " + "; ".join(parts) + ".")
    largest = max(((abs(e[0]), names, q, a, e) for names in EFFECTS if len(names) > 1 for q in QUANTITIES
                   for a, e in clear_effects(design, names, q)), default=None)
    if not largest:
        return words + " The effects of the sources add up, as far as these runs show."
    _, names, quantity, amplitude, (value, low, high) = largest
    return words + (f" The effects do not add up: the largest interaction is {' × '.join(names)} on {quantity} at A_h = "
                    f"{amplitude:g}, {per_cent(value, 1)} [{per_cent(low, 1)}, {per_cent(high, 1)}] percentage points.")


# The design of the first version of the report had 60 realisations a condition, at the fixed horizon.
FORMER = {"five_per_cent": "amplitude 30 of 57, friction 6, restitution 0; interactions: friction × amplitude 3, others 0",
          "one_per_cent": "amplitude 5 of 30, friction 0, restitution 0; no interaction"}


def changes(designs):
    rows = []
    for folder, found in designs.items():
        for design in found:
            clear = clear_counts(design, EFFECTS)
            now = ", ".join(f"{' × '.join(names)} {count}" for names, count in clear.items())
            rows.append((f"{per_cent(design.relative_sigma)} %, {design.moment}", FORMER[folder],
                         f"of {len(design.amplitudes) * len(QUANTITIES)}: {now}"))
    return table(["significant effects", "before", "now"], rows)


def bounded(found, digits=3):
    return f"{found['value']:.{digits}g} [{found['interval'][0]:.{digits}g}, {found['interval'][1]:.{digits}g}]"


def who(curve):
    """`Slender block, harmonic: does it overturn?` without the question."""
    return curve["title"].split(":")[0]


def fragility_rows(curves):
    rows = []
    for curve in curves:
        law = curve["law"]
        told = [curve["outcome"], "", ""]
        if law:
            missed = f"{curve['missed_levels']} of {len(curve['levels'])}"
            told = [bounded(law["median"]), bounded(law["dispersion"]), missed]
        rows.append([who(curve), curve["levels"][0]["realisations"], *told])
    return rows


def fragility_words(curves):
    fitted = [c for c in curves if c["law"]]
    missed = [c for c in fitted if c["missed_levels"]]
    falls = []
    for curve in curves:
        levels = curve["levels"]
        pairs = [(a, b) for i, a in enumerate(levels) for b in levels[i + 1:] if b["simultaneous"][1] < a["simultaneous"][0]]
        if pairs:
            a, b = max(pairs, key=lambda pair: pair[0]["estimate"] - pair[1]["estimate"])
            falls.append(f"{who(curve)}: {per_cent(a['estimate'])} % at {a['intensity']:g}, "
                         f"{per_cent(b['estimate'])} % at {b['intensity']:g}")
    rejected = [c for c in curves if c["outcome"] in ("rejected", "not_monotone")]
    text = f"The test rejects the lognormal function for {len(rejected)} of the {len(curves)} curves."
    if fitted:
        text += f" It misses levels of {len(missed)} of the {len(fitted)} curves for which it stands."
    if not falls:
        return text + " No curve decreases detectably."
    text += (" The probability of overturning does not always increase with the intensity. The largest decreases between levels "
             "whose simultaneous intervals do not overlap:\n\n- ")
    return text + "\n- ".join(falls)


def fragility_tables(curves):
    parts = []
    for curve in curves:
        rows = []
        for level in curve["levels"]:
            row = [f"{level['intensity']:g}", f"{level['overturned']} of {level['realisations']}",
                   "[" + ", ".join(per_cent(end, 1) for end in level["exact"]) + "]"]
            kind = "fitted" if curve["law"] else "isotonic"
            if level.get(kind) is not None:
                row += [per_cent(level[kind], 1), "[" + ", ".join(per_cent(end, 1) for end in level["band"]) + "]"]
            rows.append(row)
        head = [curve["parameter"].rsplit("/", 1)[1], "overturned", "exact, %"]
        head += [f"{kind}, %", "band, %"] if len(rows[0]) > len(head) else []
        parts.append(f"<details><summary>{curve['title']}</summary>\n\n{table(head, rows)}\n\n</details>")
    return "\n\n".join(parts)


def spoken_time(seconds):
    return f"{seconds:.0f} s" if seconds < 60 else f"{seconds // 60:.0f} min {seconds % 60:02.0f} s"


def values():
    runs = json.loads(lzma.open(PUBLISHED / "runs.json.xz", "rt").read())
    designs = {folder: [Design(runs, folder, moment) for moment in MOMENTS] for folder in ("five_per_cent", "one_per_cent")}
    (five, five_end), (one, one_end) = designs.values()
    curves = json.loads((PUBLISHED / "fragility.json").read_text())["curves"]
    over = {c: json.loads((PUBLISHED / "overturning" / c / "report.json").read_text()) for c in CURVES}
    scene = five.runs[SOURCES]["experiment"]
    harmonic, slender = (over[c]["input"]["experiment"] for c in CURVES[:2])
    block, e = scene["block"], scene["restitution"]
    squared_sine = block["width_m"] ** 2 / (block["width_m"] ** 2 + block["height_m"] ** 2)
    modes = [mode for run in runs.values() for row in decoded(run) for mode in row]
    seconds = sum(run["system"]["duration_s"] for run in runs.values()) + sum(r["system"]["duration_s"] for r in over.values())
    return {
        "width": f"{block['width_m']:g}", "height": f"{block['height_m']:g}",
        "frequency_ratio": f"{scene['excitation']['frequency_ratio']:g}",
        "friction": f"{scene['friction']['static']:g}/{scene['friction']['kinetic']:g}",
        "first_amplitude": f"{five.amplitudes[0]:g}", "last_amplitude": f"{five.amplitudes[-1]:g}",
        "sigma_five": f"{per_cent(five.relative_sigma)} %", "sigma_one": f"{per_cent(one.relative_sigma)} %",
        "n": scene["realisations"], "transient": scene["horizon"]["transient_periods"],
        "sampled": scene["horizon"]["sampled_periods"],
        "at_most": scene["horizon"]["until_classified"]["at_most_periods"], "restitution": f"{e:g}",
        "slenderness": f"{slender['block']['height_m'] / slender['block']['width_m']:g}",
        "over_periods": harmonic["horizon"]["sampled_periods"],
        "over_ratio": f"{harmonic['excitation']['frequency_ratio']:g}",
        "over_sigma": f"{per_cent(harmonic['fluctuation']['amplitude']['relative_sigma'])} %",
        "overturned_in_design": modes.count("overturned") or "none", "design_realisations": len(modes),
        "realisations": len(modes) + sum(c["realisations"] for r in over.values() for c in r["result"]["conditions"]),
        "duration": spoken_time(seconds), "machine": next(iter(runs.values()))["system"]["machine"],
        "tests": five.tests(), "confidence": f"{per_cent(five.confidence)} %",
        "power": f"{five.power(0.05):.2f}", "responses_early": response_tables(five), "responses_end": response_tables(five_end),
        "effects_five": effect_table(five), "effects_five_end": effect_table(five_end),
        "effects_one": effect_table(one), "effects_one_end": effect_table(one_end),
        "summaries": "\n".join(f"- {summary(design)}" for found in designs.values() for design in found),
        "changes": changes(designs),
        "impact_ratio": f"{1 - 1.5 * (1 + e) * squared_sine:.3f}",
        "impact_scatter": f"{1.5 * e * five.relative_sigma * squared_sine:.1g}",
        "fragility_summary": table(["curve", "realisations a level", "median", "dispersion", "levels missed"],
                                   fragility_rows(curves)),
        "fragility_words": fragility_words(curves), "fragility_tables": fragility_tables(curves)}, five, five_end


def filled(template, found):
    names = set(re.findall(r"\{\{(\w+)\}\}", template))
    if names != set(found):
        sys.exit(f"write_report.py: the template and its values differ in {sorted(names ^ set(found))}")
    return wrapped(re.sub(r"\{\{(\w+)\}\}", lambda match: str(found[match.group(1)]), template))


def wrapped(text):
    """The text with paragraphs and items in lines of at most 120 letters; tables and pictures are one line each."""
    lines, paragraph = [], []

    def end_paragraph():
        if paragraph:
            indent = "  " if paragraph[0].startswith("- ") else ""
            lines.extend(textwrap.wrap(" ".join(part.strip() for part in paragraph), 120, subsequent_indent=indent,
                                       break_long_words=False, break_on_hyphens=False))
            paragraph.clear()

    for line in text.split("\n"):
        stands_alone = not line or line.startswith(("|", "<", "!", "#", "    ", "**"))
        if stands_alone or line.startswith("- "):
            end_paragraph()
        if stands_alone:
            lines.append(line)
        else:
            paragraph.append(line)
    end_paragraph()
    return "\n".join(lines)


def main():
    found, five, five_end = values()
    text = filled((HERE / "README.template").read_text(), found)
    if "--check" in sys.argv[1:]:
        if (PUBLISHED / "README.md").read_text() != text:
            sys.exit(f"{PUBLISHED / 'README.md'} differs from what write_report.py writes for the reports in its folder: "
                     "run write_report.py without --check")
        return
    (PUBLISHED / "README.md").write_text(text)
    figures.draw("modes", figures.bands(five_end), PUBLISHED)
    figures.draw("effects", figures.effects(five_end), PUBLISHED)


if __name__ == "__main__":
    main()
