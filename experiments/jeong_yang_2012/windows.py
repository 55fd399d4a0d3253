"""The page on windows: where each response begins and ends along the amplitude, and by what."""

import sys
from pathlib import Path

from published import read
from tables import table

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE / "branches"))
from routes import stable_intervals  # noqa: E402

FILES = {("without sliding", None): "no_sliding", ("consistent", "0.40/0.35"): "consistent_040_035", ("consistent", "0.35/0.30"): "consistent_035_030",
         ("as-plotted", "0.40/0.35"): "as_plotted_040_035", ("as-plotted", "0.35/0.30"): "as_plotted_035_030"}
WORDS = {"fold": "fold", "grazing": "grazing", "contact_change": "change of the order of contacts",
         "symmetry_breaking": "loss of symmetry", "period_doubling": "period doubling", "neimark_sacker": "Neimark-Sacker bifurcation", "range": "end of the range",
         "joins": "branches off", "last_point": "last point followed", "torus": "a complex pair of multipliers",
         "unknown": "unknown"}
CRISIS = 0.001  # distance of attractor and saddle at the last amplitude with chaos, in Theta and Theta'


def told(end):
    kind, value = end
    return "the end of the range" if kind == "range" else f"{WORDS[kind]} at {value:.6f}"


def shown(mode):
    """Chaotic and unresolved responses alternate without a rule, and count as one region."""
    return "irregular" if mode in ("chaotic", "unresolved") else mode


def regions(steps):
    """Successive amplitudes with one response: [mode, first, last, value before, value after]."""
    found = []
    for i, (value, mode) in enumerate((value, shown(mode)) for value, mode in steps):
        if found and found[-1][0] == mode:
            found[-1][2] = value
        else:
            found.append([mode, value, value, steps[i - 1][0] if i else None, None])
        if len(found) > 1 and found[-2][4] is None:
            found[-2][4] = value
    return found


class Orbits:
    """Stable orbits of one reading and friction."""

    def __init__(self, data):
        self.found = []  # (mode, low, how it ends there, high, how it ends there)
        for number, branch in enumerate(data["branches"]):
            own = [b for b in data["bifurcations"] if b["branch"] == number]
            for first, last, (one, other) in stable_intervals(branch, own):
                mode = f"({first['cycles']},{first['period']})"
                low, high = sorted((one, other), key=lambda end: end[1])
                self.found.append((mode, low, high))
        self.data = data

    def cause(self, mode, inside, outside):
        """By what a response ends between two neighbouring amplitudes, by the stable orbits of this mode at the inner one."""
        up = outside > inside
        here = [(low, high) for name, low, high in self.found if name == mode and low[1] - 1e-9 <= inside <= high[1] + 1e-9]
        if not here:
            return "unknown: no such orbit was found there"
        ends = [high if up else low for low, high in here]
        over = [end for end in ends if (end[1] >= outside if up else end[1] <= outside)]
        if over:
            end = max(over, key=lambda e: e[1]) if up else min(over, key=lambda e: e[1])
            return f"another basin: the orbit stays stable to {told(end)}"
        end = max(ends, key=lambda e: e[1]) if up else min(ends, key=lambda e: e[1])
        return told(end) if end[0] != "unknown" else f"unknown, at {end[1]:.4f}"


def region_rows(orbits, steps):
    rows = []
    for mode, first, last, before, after in regions(steps):
        if mode not in ("(1,1)", "(1,3)", "irregular", "overturned", "quasi-periodic"):
            continue
        ends = []
        for inside, outside, edge in ((first, before, "begins"), (last, after, "ends")):
            if outside is None:
                ends.append("end of the range")
            elif mode.startswith("("):
                ends.append(orbits.cause(mode, inside, outside))
            else:  # what ends at the other side
                other = shown(dict(map(tuple, steps))[outside])
                ends.append(f"where {other} {'ends' if edge == 'begins' else 'begins'}: {orbits.cause(other, outside, inside)}"
                            if other.startswith("(") else f"next to {other}: unknown")
        rows.append((mode, f"{first:g} to {last:g}", *ends))
    return rows


def continued_chaos(diagrams):
    """Amplitudes with chaos when the response is followed upwards and downwards, from the one start or the other."""
    parts = []
    for branch in ("upwards", "downwards"):
        found = sorted({value for row in diagrams if row["branch"] == branch for value, mode in row["steps"] if mode == "chaotic"})
        parts.append(f"{branch} at {len(found)} of {len(diagrams[0]['steps'])} amplitudes"
                     + (f" from {found[0]:g} to {found[-1]:g}" if found else ""))
    return "; ".join(parts)


def end_of_chaos(orbits, route):
    """By what the chaos of a route ends, if that is known."""
    if not route["chaos"]:
        return "-"
    if not route["after"]:
        return "beyond the scan"
    last, (value, mode) = route["chaos"][1], route["after"]
    words = f"then {mode} at {value:.7g}; "
    cause = orbits.cause(mode, value, last) if mode.startswith("(") else "unknown"
    if not cause.startswith(("unknown", "another")):
        return f"{words}this orbit begins there: {cause}"
    if not route.get("saddle"):
        return words + "unknown"
    first, near = (route["saddle"]["distances"][i] for i in (0, -1))
    name = "boundary crisis" if near < CRISIS else "unknown"
    return f"{words}{name}: the saddle {route['saddle']['orbit']} is {first:.4f} to {near:.4f} away"


def sequence(data, value):
    """Values of the doublings that follow on each other from this one, on the branches of `rocking orbits`."""
    found = [value]
    while True:
        parents = [i for i, b in enumerate(data["bifurcations"])
                   if b["kind"] == "period_doubling" and abs(b["value"] - found[-1]) < 1e-6]
        children = [i for i, branch in enumerate(data["branches"]) if branch["from"] in parents]
        later = [b["value"] for b in data["bifurcations"] if b["kind"] == "period_doubling" and b["branch"] in children
                 and all(abs(b["value"] - known) > 1e-6 for known in found)]
        if not later:
            return found
        found.append(min(later, key=lambda each: abs(each - found[-1])))


def route_rows(orbits, routes):
    rows = []
    for route in routes:
        values = max([value for value, _ in route["doublings"]], sequence(orbits.data, route["doublings"][0][0]), key=len)
        ratios = [(b - a) / (c - b) for a, b, c in zip(values, values[1:], values[2:])]
        chaos = route["chaos"]
        rows.append((route["orbit"], ", ".join(f"{value:.8f}" for value in values),
                     ", ".join(f"{ratio:.2f}" for ratio in ratios) or "-",
                     f"{chaos[0]:.7g} to {chaos[1]:.7g}" if chaos else "none found", end_of_chaos(orbits, route)))
    return rows


def stable_rows(orbits):
    return [(mode, f"{low[1]:.6f}", WORDS[low[0]], f"{high[1]:.6f}", WORDS[high[0]])
            for mode, low, high in sorted(orbits.found, key=lambda each: (each[0], each[1][1]))]


def section(data, reading, friction):
    file = FILES[reading, friction]
    orbits = Orbits(read(data.folder / "branches" / f"{file}.json.xz"))
    routes = read(data.folder / "branches" / "routes.json")[file]
    diagrams = [row for row in data.measures["diagrams"] if (row["reading"], row["friction"]) == (reading, friction)]
    parts = [f"## {reading}, {friction}" if friction else "## Without sliding, restitution 0"]
    for row in diagrams:
        if row["branch"] == "initial":
            parts.append(f"From {row['start'].replace('rest,', 'rest, Phi =')}:\n\n" + table(
                ("response", "A_h", "begins by", "ends by"), region_rows(orbits, row["steps"])))
    parts.append(f"Chaos when the response is followed from step to step: {continued_chaos(diagrams)}. Chaos of the runs from "
                 f"rest that is not found so is a transient, or has a small basin.")
    parts.append("Stable orbits, and by what each of them ends:\n\n" + table(
        ("orbit", "from", "by", "to", "by"), stable_rows(orbits)))
    if routes:
        parts.append("Doubling sequences of stable orbits:\n\n" + table(
            ("orbit", "period doublings at", "ratio of successive distances", "chaos", "end of the chaos"), route_rows(orbits, routes)))
    else:
        parts.append("No stable orbit ends by a period doubling.")
    return "\n\n".join(parts)


def text(data):
    return (HERE / "windows.template").read_text(encoding="utf-8") + "\n\n" + "\n\n".join(
        section(data, *key) for key in FILES)
