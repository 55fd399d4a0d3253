#!/usr/bin/env python3
"""Draws the basins of attraction of the block of no_sliding.json at A_h = 4.5 and phase 0, with its saddles.

usage: experiments/basins/draw.py FOLDER [CELLS [STARTS]]     (300 along each axis, 2000 starts: a minute)

Runs one realisation from each state of a grid, takes the saddles from `orbits`, and follows their unstable manifolds:
states next to a saddle in the direction that grows, mapped forward. A response and its mirror image (the other side of
overturning, the other one of two orbits that mirror each other) have two colours. The sizes of the basins in the legend are
the shares of STARTS states at random in the same box, each with its exact 95 % interval. Writes FOLDER/basins.csv and
sizes.csv, basins.tsv and .gp, and .png and .svg by gnuplot.
"""

import collections
import csv
import json
import math
import pathlib
import random
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "support"))
from rocking_module import rocking  # noqa: E402

TILTS, RATES = (-0.4, 0.4), (-1.1, 0.7)
MODES = ["(1,1)", "(1,3)", "(1,5)", "overturned to the left", "overturned to the right"]  # first in the legend
END = 620  # periods after which an orbit is reached
LONGEST = 5  # period of the orbits that are searched, in excitation periods
NEAR, FAR, STARTS = 1e-5, 30.0, 400  # distances from the saddle, as if it grew as next to it; starts on each side


def experiment():
    """Without random numbers."""
    text = json.loads((HERE / "no_sliding.json").read_text())
    text["excitation"].update(amplitude=4.5, phase_rad=0.0)
    text["initial"] = {"tilt": 0.0, "tilt_rate": 0.0}
    text.update(realisations=1, accuracy={"tolerance": 1e-10, "rerun_every": 0})
    del text["sweep"]
    return text


def centres(ends, cells):
    width = (ends[1] - ends[0]) / cells
    return [ends[0] + (i + 0.5) * width for i in range(cells)]


def responses(states, pairs):
    """The response from each initial state, with those that mirror each other told apart."""
    text = experiment()
    text["sweep"] = [{"parameter": "/initial", "values": [{"tilt": tilt, "tilt_rate": rate} for tilt, rate in states]}]
    result = rocking.run(text)
    found = []
    for state, condition, counts in zip(states, result.report().result.conditions, result.counts):
        mode = result.modes[counts.argmax()]
        if mode == "overturned":
            mode += " to the left" if condition.overturned_left.count > 0 else " to the right"
        found.append(on_mirror(mode, state, pairs))
    return found


def on_mirror(mode, state, pairs):
    """The name of a response whose orbit has a mirror image, by the orbit that is nearer in the end."""
    if mode not in pairs:
        return mode
    end = mapped(state, END)[-1]
    distances = [min(math.hypot(end[0] - tilt, end[1] - rate) for tilt, rate, *_ in orbit.points) for orbit in pairs[mode]]
    return mode if distances[0] <= distances[1] else mode + " mirrored"


def mirror_pairs(orbits):
    """By their response, two stable orbits that mirror each other."""
    pairs = {}
    for orbit in orbits:
        if orbit.stable and not orbit.symmetric and orbit.mirror is not None:
            pairs.setdefault(f"({orbit.cycles},{orbit.period})", (orbit, orbits[orbit.mirror]))
    return pairs


def sizes(starts, pairs):
    """By response its count among random initial states, its share and the ends of its interval."""
    draw = random.Random(0x2012)
    counts = collections.Counter(responses([(draw.uniform(*TILTS), draw.uniform(*RATES)) for _ in range(starts)], pairs))
    return {mode: (count, count / starts, *rocking.clopper_pearson(count, starts)) for mode, count in counts.items()}


def colour(mode):
    """Of a mirrored response a lighter one."""
    plain = mode.removesuffix(" to the left").removesuffix(" mirrored").removesuffix(" to the right")
    is_second = mode.endswith((" mirrored", " to the right"))
    parts = [int(rocking.colour(plain)[i : i + 2], 16) for i in (1, 3, 5)]
    return "#" + "".join(f"{(part + 255) // 2 if is_second else part:02x}" for part in parts)


def legend(mode, size):
    if mode not in size:
        return f"{mode}: 0 %"
    _, share, low, high = size[mode]
    return f"{mode}: {100 * share:.1f} [{100 * low:.1f}, {100 * high:.1f}] %"


def mapped(state, periods):
    """The state at each strobe from `state` on."""
    text = experiment() | {"initial": {"tilt": state[0], "tilt_rate": state[1]}}
    strobe = rocking.trajectory(text, periods=periods).strobe
    return [state] + list(zip(strobe["tilt"], strobe["tilt_rate"]))


def growing_direction(saddle, period):
    """A small displacement, mapped until it grows along one direction."""
    end = mapped((saddle[0] + 1e-9, saddle[1] + 1e-9), 3 * period)[-1]
    step = (end[0] - saddle[0], end[1] - saddle[1])
    return [part / math.hypot(*step) for part in step]


def manifold(orbit):
    """Lines of states on the unstable manifold of a saddle, one line for each side and number of mapped periods."""
    saddle = (orbit.points[0][0], orbit.points[0][1])
    direction = growing_direction(saddle, orbit.period)
    growth = max(abs(orbit.multipliers)) ** 2  # over two cycles: a multiplier may be negative
    cycles = 2 * math.ceil(math.log(FAR / NEAR) / math.log(growth))
    lines = []
    for side in (-1.0, 1.0):
        starts = [side * NEAR * growth ** (i / STARTS) for i in range(STARTS + 1)]
        paths = [mapped([place + start * part for place, part in zip(saddle, direction)], cycles * orbit.period)
                 for start in starts]
        lines += [[path[i] for path in paths if i < len(path)] for i in range(len(paths[0]))]
    return lines


def line_text(line):
    """Interrupted at an impact, where the tilt rate jumps."""
    rows = [f"{tilt:.7g}\t{rate:.7g}" for tilt, rate in line]
    gaps = ["\n" if before[0] * after[0] < 0 else "" for before, after in zip(line, line[1:])]
    return "\n".join(gap + row for gap, row in zip([""] + gaps, rows))


def write_csv(path, names, rows):
    with path.open("w", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([names, *rows])


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    cells = int(sys.argv[2]) if len(sys.argv) > 2 else 300
    starts = int(sys.argv[3]) if len(sys.argv) > 3 else 2000
    orbits = rocking.orbits(experiment(), periods=LONGEST, no_branches=True).conditions[0].orbits
    pairs = mirror_pairs(orbits)
    states = [(tilt, rate) for tilt in centres(TILTS, cells) for rate in centres(RATES, cells)]
    found, size = responses(states, pairs), sizes(starts, pairs)
    modes = [mode for mode in MODES if mode in {*found, *size}] + sorted({*found, *size} - set(MODES))
    grid = [(*state, modes.index(mode)) for state, mode in zip(states, found)]
    write_csv(folder / "basins.csv", ["tilt", "tilt_rate", "response"], [(*state, mode) for state, mode in zip(states, found)])
    write_csv(folder / "sizes.csv", ["response", "count", "share", "low", "high"], [(mode, *size[mode]) for mode in modes if mode in size])
    saddles = [orbit for orbit in orbits if orbit.kind == "saddle" and abs(orbit.points[0][0]) < 0.9]
    stable = [orbit for orbit in orbits if orbit.stable]
    lines = [line for orbit in saddles for line in manifold(orbit)]
    blocks = ["# tilt, tilt rate, response: " + ", ".join(f"{i} {mode}" for i, mode in enumerate(modes))]
    blocks[0] += "".join(f"\n{tilt:.5g}\t{rate:.5g}\t{mode}" for tilt, rate, mode in grid)
    for name, found in (("stable orbits", stable), ("saddles", saddles)):
        blocks.append(f"# {name}: tilt, tilt rate, period" + "".join(
            f"\n{point[0]:.9g}\t{point[1]:.9g}\t{orbit.period}" for orbit in found for point in orbit.points))
    blocks.append("# unstable manifolds of the saddles: tilt, tilt rate\n" + "\n\n".join(map(line_text, lines)))
    (folder / "basins.tsv").write_text("\n\n\n".join(blocks) + "\n")
    palette = ", ".join(f"{i} '{colour(mode)}'" for i, mode in enumerate(modes))
    keys = "".join(f", \\\n  NaN with boxes fs solid fc rgb '{colour(mode)}' title '{legend(mode, size)}'" for mode in modes)
    (folder / "basins.gp").write_text(f"""set terminal pngcairo size 1100,1000 font 'DejaVu Sans,13'
set output 'basins.png'
set xrange [{TILTS[0]}:{TILTS[1]}]
set yrange [{RATES[0]}:{RATES[1]}]
set xlabel 'initial tilt Θ_0'
set ylabel 'initial tilt rate Θ′_0'
set palette maxcolors {len(modes)} defined ({palette})
set cbrange [-0.5:{len(modes) - 0.5}]
unset colorbox
set key outside bottom center horizontal Left reverse maxcols 2 width 2
set title 'Basins, with their share of {starts} initial states at random in this box [exact 95 % interval of each]'
plot 'basins.tsv' index 0 using 1:2:3 with image notitle{keys}, \\
  '' index 3 using 1:2 with lines lw 1.2 lc rgb 'black' title 'unstable manifold', \\
  '' index 2 using 1:2 with points pt 2 ps 1.6 lw 2.5 lc rgb 'black' title 'saddle', \\
  '' index 1 using 1:2 with points pt 7 ps 1.3 lc rgb 'white' notitle, \\
  '' index 1 using 1:2 with points pt 6 ps 1.3 lw 2 lc rgb 'black' title 'stable orbit'
set terminal svg size 1100,1000 font 'DejaVu Sans,13'
set output 'basins.svg'
replot
""")
    subprocess.run(["gnuplot", "basins.gp"], cwd=folder, check=True)
    for orbit in saddles + stable:
        print(f"({orbit.cycles},{orbit.period}) {orbit.kind} {orbit.points[0][0]:.6f} {orbit.points[0][1]:.6f}")


if __name__ == "__main__":
    main()
