#!/usr/bin/env python3
"""Unanchored bookcases of FEMA P-58 on made-up floors. Writes p58_bookcases.json, .md and .png of reports/experiments.

usage: p58_bookcases.py [--check]

Takes five minutes on one processor. --check: computes and writes nothing; exit code 1 if p58_bookcases.md differs from the
text that follows from p58_bookcases.json.
"""

import json
import math
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile

TOP = pathlib.Path(__file__).resolve().parents[2]
HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(TOP / "experiments" / name) for name in ("support", "beyond_the_paper", "museum", "shake_table")]
import make_motions  # noqa: E402
import text as shake_table  # noqa: E402
from rocking_module import rocking  # noqa: E402
from write_report import filled, table  # noqa: E402

PUBLISHED = TOP / "reports/experiments"
FACTS = PUBLISHED / "p58_bookcases.json"
TABLE = (0.724, 0.493, 0.361, 0.290, 0.251)  # FEMA P-58: medians of the peak floor velocity [m/s]
TABLE_DISPERSION = 0.5
SCENE = json.loads((HERE / "bookcases.json.in").read_text())
DEPTH = SCENE["block"]["width_m"]
HEIGHTS = SCENE["sweep"][0]["values"]
MOTIONS = 40
SEED = 58
ROCKS = 0.1  # peak tilt over psi of a bookcase that rocks visibly
DAMPING = 0.05  # of the building
PERIOD = 0.6  # of the building [s]
BASE = {"period": PERIOD, "duration": 1.0, "scene": {}}
SLIPPERY = {"static": {"uniform": [0.2, 0.3]}, "kinetic": {"ratio": 0.85}}
# What differs from the base case, one at a time.
VARIATIONS = {
    "base": BASE,
    "no sliding": BASE | {"scene": {"friction": None}},
    "friction 0.2 to 0.3": BASE | {"scene": {"friction": SLIPPERY}},
    "less loss at impacts, e = -0.5": BASE | {"scene": {"restitution": -0.5}},
    "more loss at impacts, e = 0.5": BASE | {"scene": {"restitution": 0.5}},
    "on the ground": BASE | {"period": None},
    "building of 0.3 s": BASE | {"period": 0.3},
    "building of 1.2 s": BASE | {"period": 1.2},
    "building of 2.4 s": BASE | {"period": 2.4},
    "shaking half as long": BASE | {"duration": 0.5},
    "shaking twice as long": BASE | {"duration": 2.0},
}


def floor_of(ground, period):
    """Absolute acceleration of an oscillator on the ground: Newmark's method of constant average acceleration."""
    step, omega = make_motions.STEP, 2.0 * math.pi / period
    u = v = a = 0.0
    floor = []
    for value in ground:
        u_next, v_next = u + step * v + 0.25 * step**2 * a, v + 0.5 * step * a
        a = (-value - 2.0 * DAMPING * omega * v_next - omega**2 * u_next) / (1.0 + DAMPING * omega * step + 0.25 * (omega * step) ** 2)
        u, v = u_next + 0.25 * step**2 * a, v_next + 0.5 * step * a
        floor.append(value + a)
    return floor


def make_floors(folder, variation):
    """The same ground motions in each variation, but for their duration; on a floor, until the building is nearly at rest."""
    median, deviation = make_motions.PARAMETERS["duration"][1:]
    law = ("lognormal", median * variation["duration"], deviation)
    parameters, make_motions.PARAMETERS = make_motions.PARAMETERS, make_motions.PARAMETERS | {"duration": law}
    for number in range(1, MOTIONS + 1):
        p, motion = make_motions.motion(random.Random(SEED * 100_000 + number))
        if variation["period"]:
            rest = int(math.log(1e3) / (2.0 * math.pi * DAMPING) * variation["period"] / make_motions.STEP)
            motion = floor_of(motion + [0.0] * rest, variation["period"])
        make_motions.write(folder / f"floor_{number:03d}.at2", number, SEED, p, motion)
    make_motions.PARAMETERS = parameters


def number_of(estimate):
    interval = estimate.bootstrap if estimate.bootstrap is not None else estimate.interval
    return [float(estimate.value), *(None if end is None else float(end) for end in interval)]


def law_of(curve):
    """None where so few fall that there is no law."""
    law = curve.pooled
    return law and {"median": number_of(law.median), "dispersion": number_of(law.dispersion),
            "between": float(law.between_records.value), "outcome": str(curve.outcome)}


def measured(variation):
    """Laws of the bookcases, by height, and what the floors are like."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        make_floors(folder, variation)
        scene = SCENE | variation["scene"] | {"excitation": {"kind": "recorded", "suite": str(folder / "*.at2")}}
        scene = {key: value for key, value in scene.items() if value is not None}
        motions = rocking.motion([str(path) for path in sorted(folder.glob("*.at2"))], series=False).motions
        run = rocking.run(scene, threads=1)
        curves = rocking.fragility(run, event=["overturning", f"tilt > {ROCKS} psi"], threads=1).curves
    ratios = sorted(float(each.pgv_m_s / (9.81 * each.pga_g)) for each in motions)
    durations = sorted(float(each.significant_duration_s) for each in motions)
    falls, rocks = ([curve for curve in curves if (curve.event == "overturned") == is_fall] for is_fall in (True, False))
    return {"laws": [law_of(curve) for curve in falls],
            "rocking": [curve.pooled and number_of(curve.pooled.median) for curve in rocks],
            "ratio": ratios[len(ratios) // 2], "duration": durations[len(durations) // 2]}


def measure():
    facts = {}
    for name, variation in VARIATIONS.items():
        facts[name] = measured(variation)
        print(name, *(f"{law['median'][0]:.3f}" if law else "-" for law in facts[name]["laws"]), flush=True)
    return facts


def step(height):
    """The least step of the floor's velocity that overturns a block at rest [m/s]: its tilt rate is 3 v cos(psi)/(4 R)."""
    psi, half_diagonal = math.atan(DEPTH / height), 0.5 * math.hypot(DEPTH, height)
    return math.sqrt(8.0 * 9.81 * half_diagonal * (1.0 - math.cos(psi)) / 3.0) / math.cos(psi)


def with_interval(estimate, digits):
    if estimate is None:
        return "-"
    value, low, high = (f"{number:.{digits}f}" for number in estimate)
    return f"{value} [{low}, {high}]"


def beside(base):
    rows = [[f"{height:.2f}", f"{published:.3f}", with_interval(law["median"], 2), TABLE_DISPERSION,
             with_interval(law["dispersion"], 2), f"{law['between']:.2f}", with_interval(rocks, 2), f"{step(height):.2f}"]
            for height, published, law, rocks in zip(HEIGHTS, TABLE, base["laws"], base["rocking"])]
    return table(["height, m", "median, P-58", "median, here", "dispersion, P-58", "dispersion, here", "between motions", "rocks", "step"],
                 rows)


def variations(facts):
    rows = [[name, f"{found['ratio']:.3f} s", f"{found['duration']:.0f} s",
             *(f"{law['median'][0]:.2f} ({law['dispersion'][0]:.2f})" if law else "-" for law in found["laws"])]
            for name, found in facts.items()]
    published = [f"{median:.2f} ({TABLE_DISPERSION})" for median in TABLE]
    return table(["", "PFV/PFA", "duration", *(f"{height:.2f} m" for height in HEIGHTS)], [["P-58", "", "", *published], *rows])


def span(numbers, digits=2):
    low, high = (f"{end:.{digits}f}" for end in (min(numbers), max(numbers)))
    return low if low == high else f"{low} to {high}"


def medians(found):
    return [law["median"][0] if law else None for law in found["laws"]]


def change(facts, name, heights=range(len(HEIGHTS))):
    """Medians of a variation over those of the base case, as words."""
    base = medians(facts["base"])
    ratios = [medians(facts[name])[i] / base[i] for i in heights if medians(facts[name])[i]]
    return span(ratios)


def rocking_table(facts):
    """Where bookcases begin to rock, on each floor."""
    floors = ["on the ground", "building of 0.3 s", "base", "no sliding", "building of 1.2 s", "building of 2.4 s"]
    rows = [[name, f"{facts[name]['ratio']:.3f} s", *(f"{rocks[0]:.2f}" if rocks else "-" for rocks in facts[name]["rocking"])]
            for name in floors]
    return table(["", "PFV/PFA", *(f"{height:.2f} m" for height in HEIGHTS)],
                 [["P-58, falls", "", *(f"{median:.2f}" for median in TABLE)], *rows])


def ratio_span(upper, lower):
    return span([a / b for a, b in zip(upper, lower) if a and b])


def share_below(law, velocity):
    """The share of bookcases that fall below this velocity, in per cent."""
    z = math.log(velocity / law["median"][0]) / law["dispersion"][0]
    return 100.0 * 0.5 * math.erfc(-z / math.sqrt(2.0))


def findings(facts):
    base, tall = facts["base"], range(1, len(HEIGHTS))
    rocks = [each and each[0] for each in facts["no sliding"]["rocking"]]
    needed = [median * height / (DEPTH * 9.81) for median, height in zip(TABLE, HEIGHTS)]
    slow = facts["building of 2.4 s"]
    above = span([median / published for found in facts.values() for median, published in zip(medians(found), TABLE) if median])
    spread = [facts[name]["laws"][0]["dispersion"][0] for name in ("base", "no sliding")]
    return f"""- *Rocking and falling.* A block that cannot slide begins to rock where the floor's acceleration exceeds b/h g, at a PFV of
  b/h g times PFV/PFA. For the table's medians this is a PFV/PFA of {span(needed)} s: they rise with b/h as if a bookcase fell as soon
  as it rocks. Without sliding, the medians at which it rocks here are {ratio_span(TABLE, rocks)} times below those of the table, all five
  alike; on the ground those of the four taller ones are {ratio_span(TABLE[1:], [each and each[0] for each in
  facts["on the ground"]["rocking"][1:]])} times below. To fall, it needs {ratio_span(medians(facts["no sliding"]), rocks)} times the velocity at which it rocks. Of the bookcases here
  {span([share_below(law, median) for law, median in zip(base["laws"], TABLE)], 0)} % fall below the table's median.
- *Sliding* concerns the lowest bookcase. Without it the median is {medians(facts["no sliding"])[0]:.2f} in place of {medians(base)[0]:.2f} m/s, and
  the dispersion {spread[1]:.2f} in place of {spread[0]:.2f}; those of the others are {change(facts, "no sliding", tall)} times as large. With friction of 0.2 to 0.3 the two lowest
  hardly fall, and that of 1.40 m falls at {medians(facts["friction 0.2 to 0.3"])[2]:.2f} m/s; those of the two tallest are {change(facts, "friction 0.2 to 0.3", (3, 4))} times as large.
- *Impacts.* With less loss the medians are {change(facts, "less loss at impacts, e = -0.5")} times those of the base case, with more loss {change(facts, "more loss at impacts, e = 0.5")}.
- *Frequency of the floor.* On the building of 0.3 s the bookcases rock at the smallest velocities, and fall at
  {change(facts, "building of 0.3 s")} times the velocity of the base case. Short pulses lift a block, and end before it turns over. On the building of 2.4 s a
  block that rocks falls: the medians are {ratio_span(medians(slow), [each and each[0] for each in slow["rocking"]])} times those of rocking, and {change(facts, "building of 2.4 s")}
  times those of the base case.
- *Duration.* Half as long: {change(facts, "shaking half as long")}; twice as long: {change(facts, "shaking twice as long")}.
- *Together.* None of these brings the medians to the table: over all variations and heights they are {above} times as large.
  The table agrees with where a bookcase begins to rock on a floor of PFV/PFA near {sum(needed) / len(needed):.2f} s. Whether it was meant so,
  the numbers do not say.
"""


def text_of(facts):
    base = facts["base"]
    laws, own = base["laws"], medians(base)
    rejected = [f"{height:.2f} m" for height, law in zip(HEIGHTS, laws) if law["outcome"] == "rejected"]
    return filled((HERE / "page.template").read_text(), {
        "beside": beside(base), "MOTIONS": MOTIONS, "REALISATIONS": SCENE["realisations"], "LEVELS": len(SCENE["sweep"][1]["values"]),
        "HIGHEST": max(SCENE["sweep"][1]["values"]), "ROCKS": ROCKS, "PERIOD": PERIOD,
        "over": span([a / b for a, b in zip(own, TABLE)]), "fall": f"{own[0] / own[-1]:.1f}",
        "table_fall": f"{TABLE[0] / TABLE[-1]:.1f}", "step_fall": f"{step(HEIGHTS[0]) / step(HEIGHTS[-1]):.1f}",
        "slenderness": span([median * height / DEPTH for median, height in zip(TABLE, HEIGHTS)]),
        "dispersions": span([law["dispersion"][0] for law in laws]), "variations": variations(facts),
        "rocking": rocking_table(facts),
        "findings": findings(facts).strip(), "rejected": f"The test rejects the lognormal law for {', '.join(rejected) or 'none'}; the median and "
        "the dispersion there are those of the nearest one."})


def draw(facts):
    """Medians by height beside the table's, and what each variation changes."""
    def bars(medians_and_dispersions, shift):
        return "\n".join(f"{height + shift} {m} {m * math.exp(-d)} {m * math.exp(d)}"
                         for height, (m, d) in zip(HEIGHTS, medians_and_dispersions))

    base = facts["base"]
    here = [(law["median"][0], law["dispersion"][0]) for law in base["laws"]]
    script = (f"$table << EOD\n{bars([(median, TABLE_DISPERSION) for median in TABLE], -0.012)}\nEOD\n"
              f"$here << EOD\n{bars(here, 0.012)}\nEOD\n"
              "$step << EOD\n" + "\n".join(f"{height} {step(height)}" for height in HEIGHTS) + "\nEOD\n"
              "$rocks << EOD\n" + "\n".join(f"{height} {rocks[0]}" for height, rocks in zip(HEIGHTS, base["rocking"]) if rocks) + "\nEOD\n"
              "set multiplot layout 1,2\nset logscale y\nset xrange [0.65:2.15]\nset yrange [0.1:4]\nset key top right\n"
              "set xlabel 'height [m]'\nset ylabel 'median of the peak floor velocity [m/s]'\n"
              "set ytics (0.1, 0.2, 0.5, 1, 2, 4)\n"
              "plot $here with yerrorbars lc rgb '#0072b2' pt 7 title 'here', $table with yerrorbars lc rgb '#000000' pt 5 title 'P-58', "
              "$step with lines lc rgb '#999999' dt 2 title 'step of the velocity', "
              "$rocks with lines lc rgb '#009e73' lw 2 title 'rocks'\n")
    names = [name for name in facts if name != "base"]
    for i, name in enumerate(names):
        rows = "\n".join(f"{height} {median / own}" for height, median, own in zip(HEIGHTS, medians(facts[name]), medians(base)) if median)
        script += f"$v{i} << EOD\n{rows}\nEOD\n"
    colours = ["#000000", "#000000", "#e69f00", "#e69f00", "#0072b2", "#0072b2", "#0072b2", "#0072b2", "#d55e00", "#d55e00"]
    script += ("set yrange [0.6:14]\nset ytics (0.7, 1, 1.4, 2, 3)\nset ylabel 'median over that of the base case'\nplot "
               + ", ".join(f"$v{i} with linespoints lc rgb '{colours[i]}' pt {i + 4} ps 0.9 dt {i % 2 + 1} title '{name}'"
                           for i, name in enumerate(names)) + "\nunset multiplot\n")
    shake_table.draw_with_gnuplot("p58_bookcases", script, PUBLISHED)


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
    draw(json.loads(FACTS.read_text()))


if __name__ == "__main__":
    main()
