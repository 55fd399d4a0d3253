"""The page and the figures of the shake-table tests."""

import re
import shutil
import subprocess
import textwrap

import scores

NAMES = {"West": "(a) West's formula, PGA above b/h g", "logistic": "(b) logistic regression, leaving out each day",
         "nominal": "(d) nominal numbers, no scatter", "untuned": "(e) spread of the geometry, untuned",
         "inferred": "(f) edges inferred from the other half of the days"}
# As published for these 490 tests: predictions of the discrete-element program of the data's authors (VSR2), by its stiffness.
PUBLISHED = (("(c) discrete elements, KN 5", 0.851, 0.827, 0.149), ("(c) discrete elements, KN 10", 0.876, 0.840, 0.124),
             ("(c) discrete elements, KN 15", 0.874, 0.827, 0.127))
# Of rock 2: the same program's answers of 0 or 1, of which the Brier score is the share of wrong ones.
PUBLISHED_2 = (("discrete elements, best of eight settings", 0.904, 0.096), ("discrete elements, setting (15, 1)", 0.900, 0.100))
BESIDE = {"logistic": "logistic regression of rock 1 on PGA and PGV/PGA", "rock_1": "what rock 1 did in the same test",
          "base_rate": "share of the tests in which rock 2 overturned"}
PREDICTED = "`07be71fb` on 28 November 2026"  # the commit with shake_table_rock_2.csv
COMPARED = "29 November 2026"
EXPLANATIONS = {"": "none", "0": "none, the integrator of (b) to (d)", "a": "(a) vibration that the rock does not feel",
                "b": "(b) the contact gives way", "c": "(c) an impact takes a fixed rate",
                "d": "(d) edges farther out at small tilts", "e": "(e) sliding", "f": "(f) finer samples"}


def table(head, rows):
    return "\n".join("| " + " | ".join(map(str, row)) + " |" for row in (head, ["---"] * len(head), *rows))


def filled(text, first="", rest=""):
    return textwrap.fill(" ".join(text.split()), 120, initial_indent=first, subsequent_indent=rest, break_long_words=False,
                         break_on_hyphens=False)


def wrapped(text):
    """Paragraphs filled to 120 columns; tables, lists and headings as they are."""
    parts = []
    for part in text.strip().split("\n\n"):
        if part.startswith("- "):
            items = re.split(r"^- ", part, flags=re.MULTILINE)[1:]
            parts.append("\n".join(filled(item, "- ", "  ") for item in items))
        else:
            parts.append(part if part.startswith(("|", "#", "!")) else filled(part))
    return "\n\n".join(parts) + "\n"


def with_interval(facts, model, name):
    value, (low, high) = facts["models"][model]["scores"][name], facts["models"][model]["intervals"][name]
    return f"{value:.3f} [{low:.3f}, {high:.3f}]"


def score_table(facts):
    rows = [[NAMES[model], *(with_interval(facts, model, name) for name in scores.SCORES)]
            for model in ("West", "logistic")]
    rows += [[name, *(f"{value:.3f}" for value in values), "-"] for name, *values in PUBLISHED]
    rows += [[NAMES[model], *(with_interval(facts, model, name) for name in scores.SCORES)]
             for model in ("nominal", "untuned", "inferred")]
    return table(["model", *scores.SCORES], rows)


def calibration_table(bins):
    rows = [[f"{b['low']:.1f} to {b['high']:.1f}", b["tests"], f"{b['mean']:.3f}", f"{b['overturned'] / b['tests']:.3f}",
             f"[{b['interval'][0]:.3f}, {b['interval'][1]:.3f}]", "yes" if b["holds"] else "**no**"]
            for b in bins]
    return table(["predicted", "tests", "mean", "observed", "exact interval", "holds"], rows)


def decomposition_table(facts):
    return table(["model", "reliability", "resolution", "uncertainty"],
                 [[NAMES[name], *(f"{value:.4f}" for value in facts["models"][name]["decomposition"])] for name in NAMES])


def group_table(rows, head):
    shown = [[r["group"], r["tests"], r["overturned"], f"{r['expected']:.1f}",
              f"{(r['overturned'] - r['expected']) / r['deviation']:+.1f}" if r["deviation"] > 0.05 else "-"] for r in rows]
    return table([head, "tests", "overturned", "expected", "deviations"], shown)


def far_off(rows):
    return [r for r in rows if r["deviation"] > 0.05 and abs(r["overturned"] - r["expected"]) > 2.0 * r["deviation"]]


def fit_table(facts):
    rows = []
    for k, fit in enumerate(facts["fits"]):
        edges = [f"{1e3 * e['estimate']:.1f} [{1e3 * e['interval'][0]:.1f}, {1e3 * e['interval'][1]:.1f}]"
                 for e in fit["edges_m"]]
        rows.append([("first, third, ... day", "second, fourth, ... day")[k], fit["tests"], *edges,
                     f"{fit['fit']['p_value']:.2g}"])
    return table(["inferred from", "tests", "left edge, mm", "right edge, mm", "fit, p"], rows)


def rock_2_table(rock):
    names = list(scores.SCORES)
    rows = [["this program, predicted", *(f"{rock['scores'][name]:.3f} [{low:.3f}, {high:.3f}]"
                                          for name, (low, high) in ((name, rock["intervals"][name]) for name in names)), ""]]
    rows += [[name, f"{accuracy:.3f}", "-", f"{brier:.3f}", "-", "-"] for name, accuracy, brier in PUBLISHED_2]
    for key, beside in rock["beside"].items():
        value, low, high = beside["brier_more"]
        has_order = len(set(beside["scores"].values())) > 1 and key != "base_rate"
        rows.append([BESIDE.get(key, key), *(f"{beside['scores'][name]:.3f}" if has_order or name in ("accuracy", "Brier") else "-"
                                             for name in names), f"{value:.3f} [{low:.3f}, {high:.3f}]"])
    return table(["model", *names, "Brier more"], rows)


def rock_2_section(facts):
    rock = facts["rock_2"]
    text = f"""
## Rock 2, predicted before its outcomes were seen

[shake_table_rock_2.csv](shake_table_rock_2.csv) has the probability that rock 2 overturns in each test, SHA-256
`{rock["sha256"]}`. It was committed as {PREDICTED}; the rule is in the README of the folder. Expected: {rock["expected"]:.1f} of {facts["tests"]}.
"""
    if "overturned" not in rock:
        return text
    held = [b for b in rock["bins"] if b["holds"]]
    days = far_off(rock["by_day"])
    return text + f"""
Compared on {COMPARED}: rock 2 overturned in **{rock["overturned"]}**. Nothing was fitted to these outcomes.

{rock_2_table(rock)}

Intervals as for rock 1. *Brier more*: than the prediction, with an interval by resampling of days. Discrete elements as
published, answers of 0 or 1, which a Brier score treats partly unfairly. Beside their setting (15, 1) a program outside of this
project found the accuracy higher by 0.029 [-0.002, 0.062], which is not significant.

{calibration_table(rock["bins"])}

The mean of the predictions lies in the exact interval in {len(held)} of {len(rock["bins"])} bins.
{f"More than two deviations off, of {len(rock['by_day'])} days: {', '.join(r['group'] for r in days)}." if days else ""}

**Short pulses** overturn both rocks less often than predicted; all others as often. By the published PGV/PGA, rock 2, then (f)
of rock 1:

{group_table(rock["by_pulse"], "PGV/PGA")}

{group_table(facts["by_pulse"], "PGV/PGA")}
"""


def short_pulse_section(facts):
    if "short_pulses" not in facts:
        return ""
    short = facts["short_pulses"]
    rows = []
    for row in short["candidates"]:
        is_filter = row["candidate"] in ("", "a", "e", "f")
        base = next(each for each in short["candidates"] if each["candidate"] == ("" if is_filter else "0"))
        number = "-" if row["candidate"] in ("", "0", "f") else f"{row['number']:g}"
        rows.append([EXPLANATIONS[row["candidate"]], number, f"{row['odd']['brier']:.4f}", f"{row['even']['brier']:.4f}",
                     f"{row['even']['brier'] - base['even']['brier']:+.4f}",
                     f"{row['even']['overturned']} / {row['even']['expected']:.1f}", f"{row['even']['deviations']:+.1f}"])
    tries = [row for row in short["candidates"] if row["candidate"] not in ("", "0")]
    fit = [row for row in tries if abs(row["even"]["deviations"]) < 2.0]
    verdict = "" if fit else "None makes the short pulses fit, so that none is proposed for the model. The misfit is unexplained."
    scored = ""
    if "rock_2" in short:
        best = short["rock_2"]
        scored = f"""
The best on the even days, {EXPLANATIONS[best["candidate"]]}, was scored once on rock 2: Brier {best["brier"]:.4f}, without it
{best["model"]["brier"]:.4f} by the same means; {best["expected"]:.1f} short pulses were expected to overturn it, not {best["model"]["expected"]:.1f}, and
{best["overturned"]} did ({best["deviations"]:+.1f} deviations)."""
    return f"""
## Explanations of short pulses

Six were written down, with what each predicts, before any was tried (`experiments/shake_table/short_pulses.py`). Each has at most
one number, the most likely one of its grid on rock 1's odd days; its even days judge it.

{table(["explanation", "number", "Brier, odd days", "Brier, even days", "change", "short pulses, overturned / expected", "deviations"], rows)}
*Change*: against the model by the same means, the program for (a), (e) and (f), an integrator of that folder for the others. The
edges stay as inferred without the explanation. {verdict}
{scored}
"""


def page(facts):
    models = facts["models"]
    untuned, inferred = models["untuned"], models["inferred"]
    missed = {name: [b for b in models[name]["bins"] if not b["holds"]] for name in ("untuned", "inferred")}
    days = far_off(facts["by_day"]["inferred"])
    motions = far_off(facts["by_motion"])
    return wrapped(f"""
# {facts["tests"]} shake-table tests of two rocks

Two granite blocks of 354 kg stood on one shaking table. In {facts["tests"]} tests on one axis the motion of the table was recorded,
and whether each rock overturned. Rock 1 overturned in {facts["overturned"]}. This file compares the probability that this program gives
for each test with what happened. `experiments/shake_table/shake_table.py` computes all numbers; the folder's
[README](../../experiments/shake_table/README.md) states the source, the numbers of the rocks and the rules, which were
written down before rock 2 was predicted. The data are not part of this project.
{rock_2_section(facts)}
{short_pulse_section(facts)}
## Scores of rock 1

{score_table(facts)}

Intervals: 95 %, by resampling of clusters; tests of one day and one motion are a cluster. Accuracy and F1 at 0.5. (c) as
published, without intervals. (a) and (d) have no probability between 0 and 1. (f) predicts each half of the days from the other one.

{decomposition_table(facts)}

(Murphy's decomposition over ten bins.)

## Calibration

Without any outcome, (e):

{calibration_table(untuned["bins"])}

With edges inferred from the other half of the days, (f):

{calibration_table(inferred["bins"])}

The mean of the predictions lies in the exact interval in {len(untuned["bins"]) - len(missed["untuned"])} of {len(untuned["bins"])} bins of (e) and in
{len(inferred["bins"]) - len(missed["inferred"])} of {len(inferred["bins"])} of (f).

![Calibration](shake_table_calibration.png)

![Outcomes and probabilities](shake_table_outcomes.png)

## What was inferred

{fit_table(facts)}

Two numbers are inferred, the means of both edges, by `rocking infer`. The scatter of the edges (4 mm) and the ratios of the
tilt rates are those of (e). A small p says that these two numbers alone do not explain the outcomes.

## What does not fit

By day, (f). Deviations: observed less expected, over the standard deviation that independent tests would have.

{group_table(facts["by_day"]["inferred"], "day")}

{f"More than two deviations off: {', '.join(str(r['group']) for r in days)}." if days else "No day is off by more than two deviations."}
A rock that chips, is set up anew or stands a few millimetres elsewhere has other edges on another day; the model has one
law for all days. The days that are off are in the second half of July and in August: the rock fell more often than expected
late in the first campaign, and less often after the pause. That is what chips and another place on the table would do; it was
not tested.

By strength, (f):

{group_table(facts["by_strength"], "PGA")}

By duration of the recording, (f):

{group_table(facts["by_duration"], "duration")}

Of {len(facts["by_motion"])} motions, {len(motions)} are off by more than two deviations{": " + ", ".join(r["group"] for r in motions) if motions else ""}.

- *The edges decide.* The nominal edges, 28 and 207 mm, are those of the outline. A rock on three points turns about
  the lines between them, and the shaking crosses these lines much nearer to the centre: 13 to 56 mm on one side and 25 to 49 mm on the other.
  With these numbers the rock may fall to both sides.
- *The loss at impacts is that of the wide base.* With edges of 20 mm Housner's ratio would be 0.99. The ratios here, 0.68 to 0.97, are
  Housner's ratios of the outline. One planar block has not both; that is why the ratios are given as measured ones.
- *Not modelled:* rocking about oblique lines and rolling on a corner, chips, rotation of the table, the second rock beside it.
  The direction in which the rock fell was not recorded, so that the sides cannot be compared.
""")


def draw_with_gnuplot(name, script, folder):
    if not shutil.which("gnuplot"):
        print(f"{name}.png was not drawn because gnuplot is missing; install it (Debian: gnuplot-nox) and run again")
        return
    head = (f"set encoding utf8\nset terminal pngcairo enhanced size 1440,720 font 'DejaVu Sans,9' fontscale 1.6 linewidth 1.5 "
            f"pointscale 1.5 background '#ffffff'\nset output '{folder / name}.png'\n")
    subprocess.run(["gnuplot"], input=head + script, text=True, check=True)


def draw(facts, models, tests, folder):
    """Calibration of (e) and (f); outcomes against PGA and PGV/PGA, coloured by the probability of (f)."""
    script = ("set multiplot layout 1,2\nset size square\nset xrange [0:1]\nset yrange [0:1]\nset key off\n"
              "set xlabel 'predicted probability'\nset ylabel 'observed share'\n")
    for name in ("untuned", "inferred"):
        rows = "\n".join(f"{b['mean']:.5f} {b['overturned'] / b['tests']:.5f} {b['interval'][0]:.5f} {b['interval'][1]:.5f}"
                         for b in facts["models"][name]["bins"])
        script += (f"$d << EOD\n{rows}\nEOD\nset title '{NAMES[name]}'\n"
                   "plot x with lines lc rgb '#999999', $d using 1:2:3:4 with yerrorbars lc rgb '#0072b2' pt 7 ps 0.8\n")
    draw_with_gnuplot("shake_table_calibration", script + "unset multiplot\n", folder)
    rows = {outcome: "\n".join(f"{t.pga:.5f} {t.pgv / t.pga:.5f} {p:.4f}" for p, t in zip(models["inferred"], tests)
                               if t.outcome == outcome) for outcome in (0, 1)}
    script = (f"$stood << EOD\n{rows[0]}\nEOD\n$fell << EOD\n{rows[1]}\nEOD\nset xlabel 'PGA [g]'\nset ylabel 'PGV/PGA [s]'\n"
              "set logscale xy\nset xrange [0.02:8]\nset yrange [0.008:0.3]\nset palette defined (0 '#2166ac', 0.5 '#dddddd', 1 '#b2182b')\nset cbrange [0:1]\n"
              "set cblabel 'probability (f)'\nset key top right box opaque\n"
              "plot $stood using ($1):($2 * 9.81):3 with points pt 6 ps 1.1 lw 2 lc palette title 'stood', "
              "$fell using ($1):($2 * 9.81):3 with points pt 7 ps 1.1 lc palette title 'overturned'\n")
    draw_with_gnuplot("shake_table_outcomes", script.replace("($2 * 9.81)", "($2 / 9.81)"), folder)
