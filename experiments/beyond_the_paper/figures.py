"""Draws the pictures of the design with gnuplot, as PNG. Equal runs give equal bytes."""

import shutil
import subprocess

from design import COMBINATIONS, EFFECTS, rocking

# Colours are those of every figure of rocking; all other (m,n) have that of (1,2).
MODES = [(mode, rocking.colour("(1,2)" if mode == "other (m,n)" else mode))
         for mode in ("(1,1)", "(1,3)", "other (m,n)", "rest", "chaotic", "unresolved")]
QUANTITY_LOOKS = {"(1,1)": (rocking.colour("(1,1)"), 7, -1), "(1,3)": (rocking.colour("(1,3)"), 9, 0),
                  "irregular": (rocking.colour("chaotic"), 5, 1)}


def spoken(names):
    return " + ".join(names) if names else "nothing"


def share(cell, mode):
    known = {name for name, _ in MODES} | {"overturned"}
    if mode == "other (m,n)":
        return sum(k for name, k in cell.counts.items() if name not in known) / cell.n
    return cell.counts.get(mode, 0) / cell.n


def bands(design):
    """A panel for each combination: probabilities of the response modes, stacked."""
    amplitudes = design.amplitudes
    step = min(b - a for a, b in zip(amplitudes, amplitudes[1:]))
    text = "set multiplot layout 3,3 margins 0.06,0.98,0.10,0.93 spacing 0.05,0.10\n"
    text += f"set boxwidth {step:g}\nset style fill solid 1.0 border lc '#404040'\nset yrange [0:1]\n"
    text += f"set xrange [{amplitudes[0] - step / 2:g}:{amplitudes[-1] + step / 2:g}]\nunset key\nset ytics 0.5\n"
    for number, names in enumerate(COMBINATIONS):
        rows = []
        for amplitude in amplitudes:
            cell, total, row = design.cells[names][amplitude], 0.0, [f"{amplitude:g}"]
            for mode, _ in MODES:
                total += share(cell, mode)
                row.append(f"{total:.6f}")
            rows.append(" ".join(row))
        text += f"$d{number} << EOD\n" + "\n".join(rows) + "\nEOD\n"
        text += f"set title '{spoken(names)}'\n" + ("set xlabel 'A_h'\n" if number > 4 else "unset xlabel\n")
        layers = [f"$d{number} using 1:{2 + i} with boxes lc rgb '{MODES[i][1]}'" for i in reversed(range(len(MODES)))]
        text += "plot " + ", ".join(layers) + "\n"
    text += "unset title\nunset border\nunset tics\nunset xlabel\nset key center center\n"
    layers = [f"NaN with boxes lc rgb '{colour}' title '{mode}'" for mode, colour in MODES]
    return text + "plot " + ", ".join(layers) + "\nunset multiplot\n"


def effects(design):
    """A panel for each effect: the change of each probability, with its simultaneous interval."""
    amplitudes = design.amplitudes
    step = min(b - a for a, b in zip(amplitudes, amplitudes[1:]))
    text = "set multiplot layout 3,3 margins 0.06,0.98,0.10,0.93 spacing 0.05,0.10\n"
    text += f"set xrange [{amplitudes[0] - step:g}:{amplitudes[-1] + step:g}]\nset yrange [-1.1:1.1]\n"
    text += "unset key\nset ytics 1\nset xzeroaxis lt 1 lc rgb '#404040'\n"
    for number, names in enumerate(EFFECTS):
        layers = []
        for place, (quantity, (colour, marker, side)) in enumerate(QUANTITY_LOOKS.items()):
            rows = [(a + 0.22 * side * step, *design.effect(names, quantity, a)) for a in amplitudes]
            lines = [" ".join(f"{x:.6f}" for x in row) for row in rows]
            text += f"$e{number}_{place} << EOD\n" + "\n".join(lines) + "\nEOD\n"
            layers.append(f"$e{number}_{place} with yerrorbars lc rgb '{colour}' pt {marker} ps 0.5 lw 1.2")
        text += f"set title '{' × '.join(names)}'\n" + ("set xlabel 'A_h'\n" if number > 3 else "unset xlabel\n")
        text += "plot " + ", ".join(layers) + "\n"
    text += "unset title\nunset border\nunset tics\nunset xlabel\nunset xzeroaxis\nset key center center\n"
    layers = [f"NaN with points lc rgb '{c}' pt {m} ps 0.8 title 'P {q}'" for q, (c, m, _) in QUANTITY_LOOKS.items()]
    return text + "plot " + ", ".join(layers) + "\nunset multiplot\n"


def draw(name, text, folder):
    """Writes NAME.png; prints a message if gnuplot is missing."""
    if not shutil.which("gnuplot"):
        print(f"{name}.png was not drawn because gnuplot is missing; install it (Debian: gnuplot-nox) and run again")
        return
    terminal = ("pngcairo enhanced size 1440,1080 font 'DejaVu Sans,9' fontscale 1.5 linewidth 1.5 pointscale 1.5 "
                "background '#ffffff'")
    script = f"set encoding utf8\nset terminal {terminal}\nset output '{folder / name}.png'\n" + text
    subprocess.run(["gnuplot"], input=script, text=True, check=True)
