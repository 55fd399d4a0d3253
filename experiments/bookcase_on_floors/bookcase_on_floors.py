#!/usr/bin/env python3
"""A bookcase on the floors of buildings, free and at a wall. Writes bookcase_on_floors.json, .md and .png of
reports/experiments.

usage: bookcase_on_floors.py [--check]

Takes eleven minutes on one processor. The program is $ROCKING, or that of build/release. --check: computes and writes nothing;
exit code 1 if bookcase_on_floors.md differs from the text that follows from bookcase_on_floors.json.
"""

import copy
import json
import os
import pathlib
import random
import subprocess
import sys
import tempfile

TOP = pathlib.Path(__file__).resolve().parents[2]
HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(TOP / "experiments" / name) for name in ("support", "beyond_the_paper", "shake_table")]
import text as shake_table  # noqa: E402
from write_report import filled, table  # noqa: E402

FACTS = TOP / "reports/experiments/bookcase_on_floors.json"
SCENE = json.loads((HERE / "bookcase.json.in").read_text())
HEIGHTS = SCENE["sweep"][0]["values"]
FREQUENCIES = [0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 5.0, 8.0]  # of buildings [Hz]
SCATTER = 0.2  # of a frequency
WALL = {"side": "right", "rate_ratio": 0.5}
MOTIONS = 60
SEED = 89
RESAMPLED = 2000  # times
OTHER_RATIOS = [0.0, 0.25, 0.75]  # that a wall may give back
VARIED = "3"  # the building of which they are computed [Hz]
KINDS = {"free": "Free", "wall": "At a wall"}


def at(frequency, wall):
    """The experiment of a building; without a wall None."""
    scene = copy.deepcopy(SCENE)
    scene["excitation"]["building"]["frequency_hz"] = {"lognormal": {"mean": frequency, "sigma": SCATTER * frequency}}
    if wall:
        scene["block"]["wall"] = wall
    return scene


def measured(rocking, folder, scene):
    """By floor: the rate with its interval, the share of it that the levels leave open, and the rates of the records."""
    (folder / "bookcase.json").write_text(json.dumps(scene))

    def call(*arguments):
        return subprocess.run([rocking, *arguments, "-q"], cwd=folder, check=True, capture_output=True, text=True).stdout

    call("run", "bookcase.json", "-o", "run", "--overwrite", "--no-page", "--threads", "1")
    floors = []
    for curve in json.loads(call("fragility", "run", "--hazard", str(HERE / "hazard.csv"), "--json"))["curves"]:
        rate = curve["annual_rate"]
        shares = next(each for each in rate["estimates"] if each["from"] == "isotonic")
        floors.append({"rate": [shares["value"], *shares["interval"]], "open": rate["undecided_share"],
                       "records": [each["rate"] for each in rate["by_record"]]})
    return floors


def ratio(rates, base):
    """Of two means over the same records, with a bootstrap interval of 95 % that draws the records."""
    source, ratios = random.Random(SEED), []
    for _ in range(RESAMPLED):
        drawn = [source.randrange(len(base)) for _ in base]
        ratios.append(sum(rates[i] for i in drawn) / sum(base[i] for i in drawn))
    ratios.sort()
    return [sum(rates) / sum(base), ratios[RESAMPLED // 40], ratios[-1 - RESAMPLED // 40]]


def published(floors, free):
    """Rounded, with ratios to the ground and to the free block."""
    return [{name: [float(f"{number:.4g}") for number in numbers] for name, numbers in (
                ("rate", floor["rate"]), ("over_ground", ratio(floor["records"], floors[0]["records"])),
                ("over_free", ratio(floor["records"], base["records"])),
                ("of_motions", ratio(floor["records"], [1.0] * MOTIONS)))} | {"open": round(floor["open"], 4)}
            for floor, base in zip(floors, free)]


def facts_of(buildings, others):
    """What is published of the rates by frequency, and by what the wall gives back."""
    return {"buildings": {frequency: {kind: published(kinds[kind], kinds["free"]) for kind in KINDS}
                          for frequency, kinds in buildings.items()},
            "ratios": {name: published(floors, buildings[VARIED]["free"]) for name, floors in others.items()}}


def measure():
    rocking = pathlib.Path(os.environ.get("ROCKING", TOP / "build/release/rocking")).resolve()
    buildings = {}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        subprocess.run([sys.executable, TOP / "experiments/museum/make_motions.py", folder / "records", "--count", str(MOTIONS),
                        "--seed", str(SEED)], check=True)
        for frequency in FREQUENCIES:
            buildings[f"{frequency:g}"] = {kind: measured(rocking, folder, at(frequency, WALL if kind == "wall" else None)) for kind in KINDS}
            print(f"{frequency:g} Hz:", *(f"{floor['rate'][0]:.2e}" for kind in KINDS for floor in buildings[f"{frequency:g}"][kind]),
                  flush=True)
        others = {f"{ratio:g}": measured(rocking, folder, at(float(VARIED), WALL | {"rate_ratio": ratio})) for ratio in OTHER_RATIOS}
    return facts_of(buildings, others)


def rate_text(numbers):
    return f"{1e3 * numbers[0]:.2f} [{1e3 * numbers[1]:.2f}, {1e3 * numbers[2]:.2f}]"


def ratio_text(numbers):
    digits = 1 if numbers[0] >= 10 else 2
    return "{} [{}, {}]".format(*(f"{number:.{digits}f}" for number in numbers))


def by_floor(facts, kind, quantity, text, floors=range(1, len(HEIGHTS))):
    """A table with the top floor above."""
    rows = [[f"{HEIGHTS[i]:g}", *(text(kinds[kind][i][quantity]) for kinds in facts.values())] for i in reversed(floors)]
    return table(["floor", *(f"{frequency} Hz" for frequency in facts)], rows)


def span(numbers, digits=2):
    low, high = (f"{end:.{digits}g}" for end in (min(numbers), max(numbers)))
    return low if low == high else f"{low} to {high}"


def demand(is_so, finding):
    if not is_so:
        sys.exit(f"the results no longer show this, change the text: {finding}")


def findings(facts):
    buildings, top, words = facts["buildings"], len(HEIGHTS) - 1, []
    rates = {kind: {name: [floor["rate"][0] for floor in kinds[kind]] for name, kinds in buildings.items()} for kind in KINDS}
    for kind, name in KINDS.items():
        worst = max(rates[kind], key=lambda frequency: max(rates[kind][frequency]))
        demand(all(max(floors) == floors[top] for floors in rates[kind].values()), "the rate is largest at the top")
        least = min(buildings, key=lambda frequency: buildings[frequency][kind][top]["over_ground"][0])
        words.append(
            f"- *{name}.* In each building the rate is largest at the top, and largest of all in that of {worst} Hz: "
            f"{ratio_text(buildings[worst][kind][top]['over_ground'])} times that on the ground. At the top of that of {least} Hz it is "
            f"{ratio_text(buildings[least][kind][top]['over_ground'])} times, at a quarter of the height "
            f"{span([kinds[kind][1]['over_ground'][0] for kinds in buildings.values()])} times.")
    slow = rates["free"]["0.5"]
    demand(slow[3] < slow[2], "at 0.5 Hz the rate does not rise with each floor")
    words.append("- *Not each floor up is worse.* In the building of 0.5 Hz the free bookcase falls less often at 0.75 of the height than at "
                 "0.5: its second mode, of 1.5 Hz, moves the floor at 0.75 half as much.")
    shares = {name: kinds["wall"] for name, kinds in buildings.items()}
    most = max(shares, key=lambda frequency: shares[frequency][top]["over_free"][0])
    demand(shares[most][top]["over_free"][1] > 1.0, "there is a building in which the wall does harm")
    demand(max(each["over_free"][0] for name in ("0.5", "0.75", "1", "8") for each in shares[name]) < 0.4, "elsewhere the wall helps")
    slowest = {kind: max(rates[kind], key=lambda frequency: rates[kind][frequency][top]) for kind in KINDS}
    demand(slowest == {"free": "1", "wall": "2"}, "at a wall the worst building is twice as stiff")
    words.append(
        f"- *The wall* leaves {ratio_text(shares[most][0]['over_free'])} of the rate on the ground, and at most 0.4 of it on the floors of "
        f"buildings up to 1 Hz and of 8 Hz. At the top of that of {most} Hz it does harm: "
        f"{ratio_text(shares[most][top]['over_free'])} times the free rate. The worst building has twice the frequency of that of a free "
        "bookcase. This agrees with how they land: one that rocks both ways lands twice in a period of the floor that drives it, one at a "
        "wall once.")
    none, most_back = (facts["ratios"][f"{each:g}"][top]["over_free"] for each in (OTHER_RATIOS[0], OTHER_RATIOS[-1]))
    words.append(f"- *What it gives back decides.* At the top of the building of {VARIED} Hz a wall that gives no tilt rate back leaves "
                 f"{ratio_text(none)} of the free rate, one that gives {OTHER_RATIOS[-1]:g} of it back {ratio_text(most_back)} times.")
    return "\n".join(words)


def text_of(facts):
    buildings, ratios = facts["buildings"], facts["ratios"]
    measured = [each for kinds in buildings.values() for kind in KINDS for each in kinds[kind]]
    intervals = [each["rate"] for each in measured]
    motions = [each["of_motions"] for each in measured]
    ground = {kind: next(iter(buildings.values()))[kind][0]["rate"] for kind in KINDS}
    kinds = dict(sorted({**ratios, f"{WALL['rate_ratio']:g}": buildings[VARIED]["wall"]}.items()))
    varied = table(["comes back", *(f"floor {HEIGHTS[i]:g}" for i in range(len(HEIGHTS)))],
                   [[name, *(ratio_text(floor["over_free"]) for floor in floors)] for name, floors in kinds.items()])
    return filled((HERE / "page.template").read_text(), {
        "free": by_floor(buildings, "free", "rate", rate_text), "wall": by_floor(buildings, "wall", "rate", rate_text),
        "shares": by_floor(buildings, "wall", "over_free", ratio_text), "ground_free": rate_text(ground["free"]),
        "ground_wall": rate_text(ground["wall"]), "findings": findings(facts), "varied": varied, "VARIED": VARIED,
        "MOTIONS": MOTIONS, "REALISATIONS": SCENE["realisations"], "LEVELS": len(SCENE["sweep"][1]["values"]),
        "RESAMPLED": RESAMPLED, "WIDTH": SCENE["block"]["width_m"], "HEIGHT": SCENE["block"]["height_m"],
        "RATIO": WALL["rate_ratio"], "SCATTER": round(100 * SCATTER), "open": f"{100 * max(each['open'] for each in measured):.0f}",
        "upper": span([high / value for value, _, high in intervals]), "lower": span([low / value for value, low, _ in intervals]),
        "upper_motions": span([high / value for value, _, high in motions]),
        "lower_motions": span([low / value for value, low, _ in motions])})


def draw(facts):
    """The rate over that of the free block on the ground as a map, with the rates."""
    buildings = facts["buildings"]
    base = next(iter(buildings.values()))["free"][0]["rate"][0]
    names = ", ".join(f"'{name}' {i}" for i, name in enumerate(buildings))
    floors = ", ".join(f"'{height:g}' {i}" for i, height in enumerate(HEIGHTS))
    script = (f"set multiplot layout 1,2\nset xrange [-0.5:{len(buildings) - 0.5}]\nset yrange [-0.5:{len(HEIGHTS) - 0.5}]\n"
              "set logscale cb\nset cbrange [0.1:12]\nset palette defined (0 '#2166ac', 0.48 '#f7f7f7', 1 '#b2182b')\n"
              "set cbtics (0.1, 0.3, 1, 3, 10)\nset xlabel 'frequency of the building [Hz]'\n"
              f"set ylabel 'height of the floor over that of the building'\nset key off\nset xtics ({names})\nset ytics ({floors})\n")
    for kind, name in KINDS.items():
        rows = "\n".join(f"{x} {y} {floor['rate'][0] / base} {1e3 * floor['rate'][0]:.2g}"
                         for x, kinds in enumerate(buildings.values()) for y, floor in enumerate(kinds[kind]))
        script += (f"${kind} << EOD\n{rows}\nEOD\nset title '{name}: falls in a thousand years'\n"
                   f"plot ${kind} with image, ${kind} using 1:2:(sprintf('%.2g', $4)) with labels font ',8'\n")
    shake_table.draw_with_gnuplot(FACTS.stem, script + "unset multiplot\n", FACTS.parent)


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
