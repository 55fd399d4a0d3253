"""Draws the pictures of the page that no command of the program draws, with gnuplot. Equal results give equal bytes."""

import colorsys
import shutil
import subprocess

from cells import FRICTIONS, READINGS, SIGMAS, STARTS
from claims import region_change
from intervals import Share, rocking
from survival import INITIAL, escapes

COLOURS = {name: rocking.colour(mode) for name, mode in
           zip(("rest, 0", "rest, pi/2", "any", 0.003, 0.03), ("(1,1)", "(1,3)", "chaotic", "(1,1)", "(1,3)"))}
TICS = "set xtics (" + ", ".join(f"'{name}' {i}" for i, name in enumerate(READINGS)) + ") rotate by 40 right\n"


def panel(number, title, series, unit):
    """Points with intervals for each reading; series: name to (value, low, high) by reading."""
    text, layers = "", []
    for k, (name, found) in enumerate(series.items()):
        side = (k - (len(series) - 1) / 2) * 0.22
        lines = [f"{i + side:.3f} {100 * v:.6f} {100 * low:.6f} {100 * high:.6f}" for i, (v, low, high) in enumerate(found)]
        text += f"$d{number}_{k} << EOD\n" + "\n".join(lines) + "\nEOD\n"
        layers.append(f"$d{number}_{k} with yerrorbars lc rgb '{COLOURS[name]}' pt 7 ps 0.6 lw 1.3 title '{name}'")
    return text + f"set title '{title}'\nset ylabel '{unit}'\nplot " + ", ".join(layers) + "\n"


def chaos(data):
    """The share of A_h from 1 to 10 with chaos, from any start."""
    text = TICS + "set multiplot layout 1,2\nset yrange [0:*]\n"
    for number, pair in enumerate(FRICTIONS):
        series = {}
        for sigma in SIGMAS:
            runs = [data.region(reading, "any", pair, sigma) for reading in READINGS]
            shares = [Share(modes.count("chaotic"), len(modes)) for modes in runs]
            series[sigma] = [(share.k / share.n, *share.interval) for share in shares]
        text += panel(number, f"chaos, {pair}, by sigma", series, "per cent of A_h from 1 to 10")
    return text + "unset multiplot\n"


def changes(data):
    """By how much each region changes from sigma 0.003 to 0.03."""
    text = TICS + "set multiplot layout 2,2\nset xzeroaxis lt 1 lc rgb '#404040'\n"
    panels = [(mode, pair) for mode in ("(1,3)", "chaotic") for pair in FRICTIONS]
    for number, (mode, pair) in enumerate(panels):
        series = {start: [region_change(data, reading, start, pair, mode) for reading in READINGS] for start in STARTS}
        text += panel(number, f"region of {mode}, {pair}, by start", series, "change, points")
    return text + "unset multiplot\n"


SHOWN = 6000  # periods


def graded(i, n):
    """A colour from blue to red, of n."""
    return "#" + "".join(f"{round(255 * part):02x}" for part in colorsys.hsv_to_rgb(0.66 * (1.0 - i / (n - 1)), 0.9, 0.8))


def survival(data):
    """The share of chaotic motions that have not overturned, by amplitude, with the exponential of the rate."""
    text = f"set multiplot layout 2,2\nset logscale y\nset xrange [0:{SHOWN}]\nset yrange [0.01:1.3]\nset grid\nset key outside right top vertical\n"
    for number, ((reading, pair), by) in enumerate(escapes(data).items()):
        layers = []
        for i, (amplitude, escape) in enumerate(by.items()):
            if not escape.at_risk:
                continue
            steps = [(INITIAL, 1.0), *escape.survival()]
            steps.append((SHOWN, [share for period, share in steps if period <= SHOWN][-1]))
            lines = "\n".join(f"{period} {share:.6f}" for period, share in sorted(steps) if period <= SHOWN and share > 0.0)
            text += f"$s{number}_{i} << EOD\n{lines}\nEOD\n"
            layers.append(f"$s{number}_{i} with steps lc rgb '{graded(i, len(by))}' lw 2 title 'A_h = {amplitude:g}'")
            if escape.periods:
                rate = len(escape.periods) / escape.exposure
                layers.append(f"(x > {INITIAL} ? exp(-{rate:.6e}*(x - {INITIAL})) : 1/0) with lines lc rgb '#404040' dt 2 lw 1 notitle")
        text += (f"set title '{reading}, {pair}'\nset xlabel 'periods'\nset ylabel 'share not overturned'\n"
                 f"plot {', '.join(layers)}\n")
    return text + "unset multiplot\n"


def draw_all(data, folder):
    if not shutil.which("gnuplot"):
        print("no figures were drawn because gnuplot is missing; install it (Debian: gnuplot-nox) and run again")
        return
    for name, text, height in (("chaos", chaos(data), 560), ("changes", changes(data), 1000),
                               ("survival", survival(data), 900)):
        terminal = f"pngcairo enhanced size 1300,{height} font 'DejaVu Sans,9' fontscale 1.3 background '#ffffff'"
        script = (f"set encoding utf8\nset terminal {terminal}\nset output '{folder / name}.png'\nset xrange [-0.6:7.6]\n"
                  "set grid ytics lc rgb '#d0d0d0'\nset key outside top center horizontal\n" + text)
        subprocess.run(["gnuplot"], input=script, text=True, check=True)
