#!/usr/bin/env python3
"""Which conclusions hang on how friction scatters? Writes friction_scatter.json, .md and .png of reports/beyond_the_paper.

usage: friction_scatter.py [--check]

Runs the headline experiment under each way in which friction may scatter: about 36 minutes on two processors, 22 of
them for cells of 0.1 mm. --check: runs and writes nothing; exit code 1 if friction_scatter.md differs from the text that
follows from friction_scatter.json.
"""

import copy
import json
import math
import pathlib
import sys
import time

import figures
from design import mover, rocking
from write_report import PUBLISHED, per_cent, table, wrapped

TOP = pathlib.Path(__file__).resolve().parents[2]
HEADLINE = TOP / "experiments/headline/headline.json"
FACTS = PUBLISHED / "friction_scatter.json"
REALISATIONS = 400
SIGMA = 0.03
SIX = (("0.35/0.3", 4.5), ("0.35/0.3", 5.5), ("0.4/0.35", 4.0), ("0.4/0.35", 5.5), ("0.4/0.35", 6.0), ("0.4/0.35", 8.0))


def along_the_way(**keys):
    """Friction drawn again along the way, otherwise as in the headline experiment."""
    return {"along_the_way": {"sigma": SIGMA, **keys}}


HALF = SIGMA / math.sqrt(2.0)
VARIANTS = {
    "as the headline": along_the_way(),
    "common deviations": along_the_way(correlation=1.0),
    "lognormal": along_the_way(law="lognormal"),
    "uniform": along_the_way(law="uniform"),
    "50 a period": along_the_way(refreshes_per_period=50),
    "800 a period": along_the_way(refreshes_per_period=800),
    "cells of 0.1 mm": along_the_way(refresh_slip_m=0.0001),
    "cells of 1 mm": along_the_way(refresh_slip_m=0.001),
    "cells of 10 mm": along_the_way(refresh_slip_m=0.01),
    "between tests": {"once": SIGMA},
    "half between, half within": {"along_the_way": {"sigma": HALF}, "once": HALF},
}
HEADLINE_NAME = next(iter(VARIANTS))
STAYING = ("cells of 0.1 mm", "cells of 1 mm", "cells of 10 mm", "between tests", "half between, half within")
DRAWS = ("50 a period", "800 a period")
LAWS = ("common deviations", "lognormal", "uniform")


def experiment_of(variant):
    """The headline experiment with this scatter of friction."""
    experiment = json.loads(HEADLINE.read_text())
    experiment.update(realisations=REALISATIONS, title="How does friction scatter?")
    experiment["fluctuation"] = {"friction": variant["along_the_way"]} if "along_the_way" in variant else {}
    if "once" in variant:
        axis = experiment["sweep"][0]
        axis["values"] = [{key: {"normal": {"mean": mean, "sigma": variant["once"]}} for key, mean in friction.items()}
                          for friction in copy.deepcopy(axis["values"])]
    return experiment


def friction_of(condition):
    """`0.35/0.3`: the means."""
    means = condition["parameters"]["/friction"]
    numbers = (m if isinstance(m, (int, float)) else m["normal"]["mean"] for m in (means["static"], means["kinetic"]))
    return "/".join(f"{number:g}" for number in numbers)


def facts_of(variant):
    began = time.monotonic()
    report = rocking.run(experiment_of(variant)).report().data
    seconds = round(time.monotonic() - began, 1)
    conditions = [{"friction": friction_of(c), "amplitude": c["parameters"]["/excitation/amplitude"],
                   "counts": {mode: k for mode, k in c["counts"].items() if k}, "differ": c["non_recurrence"]["differ"],
                   "differ_interval": c["non_recurrence"]["differ_interval"], "clamped": c["validity"]["clamped"]}
                  for c in report["result"]["conditions"]]
    return {"digest": report["result"]["digest"], "seconds": seconds, "conditions": conditions}


class Findings:
    """What was found under each variant, by friction and amplitude."""

    def __init__(self, facts):
        self.variants = {name: {(c["friction"], c["amplitude"]): c for c in found["conditions"]}
                         for name, found in facts["variants"].items()}
        self.places = list(self.variants[HEADLINE_NAME])
        others = len(self.variants) - 1
        self.level = 1 - 0.05 / (others * len(self.places))  # simultaneous over all comparisons (Bonferroni)

    def most_frequent(self, place):
        counts = self.variants[HEADLINE_NAME][place]["counts"]
        return max(counts, key=lambda mode: counts[mode])

    def share(self, name, place, mode, level=0.95):
        """(estimate, low, high) of Wilson's interval."""
        count = self.variants[name][place]["counts"].get(mode, 0)
        return count / REALISATIONS, *rocking.wilson(count, REALISATIONS, level).tolist()

    def change(self, name, place):
        """Change of the share of the response that is most frequent in the headline, with its simultaneous interval."""
        mode = self.most_frequent(place)
        return mover([(1, *self.share(name, place, mode, self.level)),
                      (-1, *self.share(HEADLINE_NAME, place, mode, self.level))])

    def changed(self, name):
        changes = {place: self.change(name, place) for place in self.places}
        return {place: c for place, c in changes.items() if c[1] > 0 or c[2] < 0}

    def certain(self, name):
        """Places at which all realisations have one response."""
        return {place for place in self.places if len(self.variants[name][place]["counts"]) == 1}

    def others(self, name):
        """Share of all realisations with another (m,n) than (1,1) and (1,3)."""
        others = sum(k for c in self.variants[name].values() for mode, k in c["counts"].items()
                     if mode.startswith("(") and mode not in ("(1,1)", "(1,3)"))
        return others / (REALISATIONS * len(self.places))

    def disputed(self):
        """Places at which some variant changes the share."""
        changed = {place for name in self.variants if name != HEADLINE_NAME for place in self.changed(name)}
        return [place for place in self.places if place in changed]


def interval_text(estimate, low, high):
    return f"{per_cent(estimate)} [{per_cent(low)}, {per_cent(high)}]"


def place_text(place):
    return f"{place[0]}, A_h = {place[1]:g}"


def summary_rows(found, facts):
    rows = []
    for name in found.variants:
        changed = found.changed(name) if name != HEADLINE_NAME else {}
        largest = max(changed, key=lambda p: abs(changed[p][0]), default=None)
        told = "-"
        if largest is not None:
            told = f"{100 * changed[largest][0]:+.0f} of {found.most_frequent(largest)} at {place_text(largest)}"
        differ = sum(c["differ_interval"][0] > 0.01 for c in found.variants[name].values())
        clamped = sum(c["clamped"] for c in found.variants[name].values())
        rows.append([name, len(found.certain(name)), differ, len(changed) if name != HEADLINE_NAME else "-", told,
                     per_cent(clamped / (len(found.places) * REALISATIONS)), f"{facts['variants'][name]['seconds']:g}"])
    return rows


def listed(names):
    names = [f"*{name}*" for name in names]
    return "none" if not names else names[0] if len(names) == 1 else ", ".join(names[:-1]) + " and " + names[-1]


def conclusions(found):
    """A line for each: under which variants it holds."""
    stands = {
        "**Two runs of one test can differ.** There are conditions whose non-recurrence is above 1 % beyond doubt (lower "
        "end of its interval)": lambda name: any(c["differ_interval"][0] > 0.01 for c in found.variants[name].values()),
        "**Most tests recur.** At two thirds of the conditions or more, two runs differ with a probability of at most 5 %":
            lambda name: 3 * sum(c["differ"] <= 0.05 for c in found.variants[name].values()) >= 2 * len(found.places),
        "**More friction brings (1,3).** With 0.40/0.35 and A_h = 5 most responses are (1,3), with 0.35/0.30 most are (1,1)":
            lambda name: found.share(name, ("0.4/0.35", 5.0), "(1,3)")[1] > 0.5
            and found.share(name, ("0.35/0.3", 5.0), "(1,1)")[1] > 0.5,
        **{f"**(1,3) and (1,1) share the {edge} edge of that range.** With 0.40/0.35 and A_h = {a:g} each of the two has at "
           "least a tenth of the responses beyond doubt (lower end of its interval)": lambda name, a=a: min(
               found.share(name, ("0.4/0.35", a), mode)[1] for mode in ("(1,1)", "(1,3)")) > 0.1
           for edge, a in (("lower", 4.0), ("upper", 6.0))},
        "**Other periods are rare.** At most 1 % of all realisations have another (m,n) than (1,1) or (1,3)":
            lambda name: found.others(name) <= 0.01,
    }
    lines = []
    for sentence, holds in stands.items():
        without = [name for name in found.variants if not holds(name)]
        lines.append(f"- {sentence}. " + ("It stands under all of them." if not without else
                                          f"It hangs on the choice: not under {listed(without)}."))
    return "\n".join(lines)


def span(numbers):
    low, high = min(numbers), max(numbers)
    return f"{low}" if low == high else f"{low} to {high}"


def other_modes(found, names):
    """The two most frequent (m,n) but (1,1) and (1,3) under these variants."""
    counts = {}
    for name in names:
        for condition in found.variants[name].values():
            for mode, count in condition["counts"].items():
                if mode.startswith("(") and mode not in ("(1,1)", "(1,3)"):
                    counts[mode] = counts.get(mode, 0) + count
    return " and ".join(sorted(counts, key=lambda mode: -counts[mode])[:2])


def in_words(found):
    """What the law, the number of draws and the memory of friction change."""
    changed = {name: found.changed(name) for name in found.variants if name != HEADLINE_NAME}
    of_number = [len(changed[name]) for name in DRAWS]
    of_law = [len(changed[name]) for name in LAWS]
    most, where = max(((abs(c[0]), (name, place)) for name in LAWS for place, c in changed[name].items()),
                      default=(0.0, None))
    text = (f"How often friction is drawn in a period changes {span(of_number)} of the {len(found.places)} conditions, its "
            f"law and its correlation change {span(of_law)}")
    if where:
        text += (f", by up to {100 * most:.0f} percentage points (*{where[0]}* at {place_text(where[1])}). What is drawn "
                 f"again in time thus does not average out within a test: its tails decide. One draw of static friction "
                 f"above what an orbit without slip demands ends slipping for good "
                 f"([model.md](../../lib/docs/model.md), section 5), and a uniform law has no draw above the mean + "
                 f"{math.sqrt(3.0):.2f} sigma")
    return (f"{text}. Friction that stays, with the place or for a whole test, changes "
            f"{span([len(changed[name]) for name in STAYING])}. In cells the block comes to a cycle of its slip over places "
            f"that keep their friction, and the response takes the period of that cycle: other (m,n), most often "
            f"{other_modes(found, STAYING[:3])}, are {span([round(100 * found.others(name)) for name in STAYING[:3]])} % of "
            f"all realisations. Scatter between tests and scatter within a test are thus different causes, and a measured "
            f"share of responses alone does not show which of them it comes from.")


def report_text(facts):
    found = Findings(facts)
    non_recurrence = [[place_text(place)] + [interval_text(c["differ"], *c["differ_interval"]) for c in
                                             (found.variants[name][place] for name in found.variants)] for place in SIX]
    shares = [[place_text(place), found.most_frequent(place)] +
              [interval_text(*found.share(name, place, found.most_frequent(place))) for name in found.variants]
              for place in found.disputed()]
    return wrapped(f"""# How does friction scatter, and does it matter?

Generated by `experiments/beyond_the_paper/friction_scatter.py`: every number below is computed.

Jeong & Yang (2012) draw friction again and again along the way, by normal numbers. The headline experiment does the same:
sigma = {SIGMA:g} about 0.35/0.30 and 0.40/0.35, kinetic friction drawn 200 times an excitation period, static friction at
each stop, one independently of the other. None of that is a property of a surface. Here the headline experiment is run
under {len(VARIANTS)} assumptions of equal variance, with {REALISATIONS} realisations of each of its {len(found.places)}
conditions: static and kinetic friction that deviate in common (correlation 1); lognormal and uniform laws; 50 and 800
draws a period; friction that belongs to the place, in cells of 0.1, 1 and 10 mm along the slip; friction that is drawn
once a test and then stays; and half of the variance of each kind.

![Non-recurrence of six conditions under each assumption](friction_scatter.png)

## What stands, and what hangs on the choice

{conclusions(found)}

{in_words(found)}

{table(["friction", "certain", "differ", "changed", "largest change, percentage points", "clamped, %", "time, s"],
       summary_rows(found, facts))}

*Certain*: conditions in which all {REALISATIONS} realisations have one response. *Differ*: conditions whose non-recurrence
is above 1 % beyond doubt; `unresolved` after 620 periods counts as a response of its own. *Changed*: conditions in which the share of the response that is most frequent under the first
assumption differs from that share; the intervals of these differences (Zou & Donner 2008, from Wilson's) are simultaneous
at 95 % over all comparisons. *Clamped*: realisations with a draw that was limited. All have the seed of the headline, so
that equal draws are used where the assumption allows it; the intervals do not rely on that.

## Non-recurrence of six conditions

Probability that two runs differ in their response, per cent, with its individual 95 % interval.

{table(["condition", *found.variants], non_recurrence)}

## Table of the headline, where it changes

Share of the response that is most frequent under the first assumption, per cent, with Wilson's 95 % interval: the
{len(shares)} of {len(found.places)} conditions in which some assumption changes it.

{table(["condition", "response", *found.variants], shares)}
""")


def picture(facts):
    """A panel for each of the six conditions: non-recurrence under each assumption."""
    found = Findings(facts)
    names = list(found.variants)
    tics = ", ".join(f"'{name}' {len(names) - k}" for k, name in enumerate(names))
    unlabelled = ", ".join(f"'' {k + 1}" for k in range(len(names)))
    text = "set multiplot layout 2,3 margins 0.19,0.985,0.08,0.95 spacing 0.02,0.12\n"
    text += f"set yrange [0.4:{len(names) + 0.6}]\nset xrange [0:0.85]\nset xtics 0.2\nset grid xtics lc rgb '#d0d0d0'\n"
    text += "unset key\n"
    for number, place in enumerate(SIX):
        rows = [f"{c['differ']:.6f} {len(names) - k} {c['differ_interval'][0]:.6f} {c['differ_interval'][1]:.6f}"
                for k, c in enumerate(found.variants[name][place] for name in names)]
        text += f"$d{number} << EOD\n" + "\n".join(rows) + "\nEOD\n"
        text += f"set ytics ({tics if number % 3 == 0 else unlabelled})\n"
        text += f"set title '{place_text(place)}'\n" + ("set xlabel 'two runs differ'\n" if number > 2 else "unset xlabel\n")
        base = found.variants[HEADLINE_NAME][place]["differ"]
        text += (f"set arrow 1 from {base:.6f},0.4 to {base:.6f},{len(names) + 0.6} nohead lc rgb '#a0a0a0' dt 2\n"
                 f"plot $d{number} using 1:2:3:4 with xerrorbars lc rgb '{rocking.colour('(1,1)')}' pt 7 ps 0.7 lw 1.3\n")
    return text + "unset multiplot\n"


def write(facts):
    lines = ",\n".join(f"{json.dumps(name)}: {json.dumps(found)}" for name, found in facts["variants"].items())
    FACTS.write_text('{ "variants": {\n' + lines.replace(', {"friction"', ',\n  {"friction"') + "\n} }\n")
    (PUBLISHED / "friction_scatter.md").write_text(report_text(facts))
    figures.draw("friction_scatter", picture(facts), PUBLISHED)


def main():
    if "--check" in sys.argv[1:]:
        if (PUBLISHED / "friction_scatter.md").read_text() != report_text(json.loads(FACTS.read_text())):
            sys.exit("friction_scatter.md differs from what follows from friction_scatter.json: run friction_scatter.py")
        return
    facts = {"variants": {}}
    for name, variant in VARIANTS.items():
        facts["variants"][name] = facts_of(variant)
        print(f"{name}: {facts['variants'][name]['seconds']} s", flush=True)
    write(facts)


if __name__ == "__main__":
    main()
