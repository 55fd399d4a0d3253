#!/usr/bin/env python3
"""Draws which pulses overturn the block, and after how many impacts, from the report of boundary.json.

usage: experiments/pulse/draw.py OUT/report.json FOLDER

Writes FOLDER/boundary.tsv, .gp and .png (the last by gnuplot). Prints for each shape and some frequency ratios the
amplitudes that overturn with impacts and without.
"""

import json
import math
import pathlib
import subprocess
import sys

SHAPES = ["sine", "cosine", "ricker"]


def way(result, operations):
    """0: stands, 1: overturns after at least one impact, 2: overturns without impact."""
    if result["counts"].get("overturned", 0) == 0:
        return 0
    impacts = operations["events"]["impact_stick"] + operations["events"]["impact_slip"]
    return 1 if impacts > 0 else 2


def ways(report):
    """For each shape the ways by (frequency ratio, amplitude)."""
    table = {shape: {} for shape in SHAPES}
    for result, operations in zip(report["result"]["conditions"], report["internal"]["conditions"]):
        shape, ratio, amplitude = result["parameters"].values()
        table[shape][ratio, amplitude] = way(result, operations)
    return table


def slender_without_impact(ratio):
    """Least amplitude of one cycle of a sine that overturns a slender block without impact (reports/evidence/closed-forms.md)."""
    def overturns(a):
        return (math.sqrt(a * a - 1) - ratio) * math.exp((2 * math.pi - math.asin(1 / a)) / ratio) > a
    low, high = 1.0, 10.0 + ratio * ratio
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if overturns(middle) else (middle, high)
    return high


def ranges(column, wanted):
    """The runs of amplitudes whose way is `wanted`, as text."""
    found = []
    for amplitude, kind in column:
        if kind != wanted:
            found.append(None)
        elif found and found[-1]:
            found[-1] = (found[-1][0], amplitude)
        else:
            found.append((amplitude, amplitude))
    return ", ".join(f"{low:g} to {high:g}" for low, high in filter(None, found)) or "-"


def print_table(table):
    for shape, kinds in table.items():
        for ratio in [1, 2, 3, 4, 5, 6, 8]:
            column = sorted((a, kind) for (r, a), kind in kinds.items() if r == ratio)
            print(f"{shape:7} {ratio:4g}  with impact {ranges(column, 1):28}  without {ranges(column, 2)}")


def main():
    report = json.loads(pathlib.Path(sys.argv[1]).read_text())
    folder = pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    table = ways(report)
    blocks = []
    for shape, kinds in table.items():
        rows = [f"{ratio:g}\t{amplitude:g}\t{kind}" for (ratio, amplitude), kind in kinds.items()]
        blocks.append(f"# {shape}: Omega_h, A_h, 0 stands / 1 overturns after an impact / 2 without impact\n" + "\n".join(rows))
    curve = [f"{0.05 * i:g}\t{slender_without_impact(0.05 * i):.6g}" for i in range(5, 161)]
    blocks.append("# slender block, one cycle of a sine, without impact: Omega_h, A_h\n" + "\n".join(curve))
    (folder / "boundary.tsv").write_text("\n\n\n".join(blocks) + "\n")
    panels = ["""set terminal pngcairo size 1500,620 font 'DejaVu Sans,13'
set output 'boundary.png'
set multiplot layout 1,3
set xrange [0.125:8.125]
set yrange [0.05:14.05]
set xlabel 'frequency ratio Ω_h = ω/p'
set ylabel 'amplitude A_h = peak acceleration / (ψ g)'
set palette defined (0 '#f2f2f2', 1 '#e69f00', 2 '#0072b2')
set cbrange [0:2]
unset colorbox
set key top left Left reverse opaque box samplen 2 width -2
"""]
    for index, shape in enumerate(SHAPES):
        panels.append(f"set title '{'Ricker' if shape == 'ricker' else shape + ', one cycle'}'\n"
                      f"plot 'boundary.tsv' index {index} using 1:2:3 with image notitle, \\\n"
                      "  NaN with boxes fs solid fc rgb '#f2f2f2' title 'stands', \\\n"
                      "  NaN with boxes fs solid fc rgb '#e69f00' title 'overturns after an impact', \\\n"
                      "  NaN with boxes fs solid fc rgb '#0072b2' title 'overturns without impact'"
                      + (", \\\n  'boundary.tsv' index 3 using 1:2 with lines lw 3 dt 2 lc rgb 'black' "
                         "title 'without impact, slender block'\n" if shape == "sine" else "\n"))
    (folder / "boundary.gp").write_text("".join(panels))
    subprocess.run(["gnuplot", "boundary.gp"], cwd=folder, check=True)
    print_table(table)


if __name__ == "__main__":
    main()
