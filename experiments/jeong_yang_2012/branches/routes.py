#!/usr/bin/env python3
"""routes.py ORBITS OUT [--program FILE]: follows each period doubling at which a stable orbit ends: the doublings after
it, the chaos, its end, and there the distance of the attractor from the saddles. ORBITS: folder with a folder of
`rocking orbits` for each file of this folder. Writes OUT, JSON."""

import argparse
import json
import math
import subprocess
import tempfile
from pathlib import Path

HERE = Path(__file__).parent
TOP = HERE.parents[2]
SAMPLED = 480


def stable_intervals(branch, bifurcations):
    """Successive stable orbits of a branch: (first point, last point, how each of the two ends)."""
    points = branch["points"]
    found, i = [], 0
    while i < len(points):
        if not points[i]["stable"]:
            i += 1
            continue
        j = i
        while j + 1 < len(points) and points[j + 1]["stable"]:
            j += 1
        ends = []
        for inside, outside, end in ((i, i - 1, 0), (j, j + 1, 1)):
            if not 0 <= outside < len(points):
                near = [b for b in bifurcations if b["kind"] == branch["ends"][end]
                        and abs(b["value"] - points[inside]["value"]) < 1e-4]
                ends.append((branch["ends"][end], near[0]["value"] if near else points[inside]["value"]))
                continue
            low, high = sorted((points[inside]["value"], points[outside]["value"]))
            near = [b for b in bifurcations if low - 1e-6 <= b["value"] <= high + 1e-6]
            near.sort(key=lambda b: (b["kind"] == "contact_change", abs(b["value"] - points[inside]["value"])))
            unlocated = "torus" if points[outside]["kind"] == "unstable_focus" else "unknown"
            ends.append((near[0]["kind"], near[0]["value"]) if near else (unlocated, points[inside]["value"]))
        found.append((points[i], points[j], ends))
        i = j + 1
    return found


class Scan:
    """Runs of the program on variants of one experiment."""

    def __init__(self, program, experiment, folder):
        self.program, self.experiment, self.folder = program, experiment, folder

    def _run(self, command, state, sweep, horizon, *flags):
        amplitude = sweep.get("values", [sweep.get("from")])[0]
        changed = {**self.experiment, "initial": state, "horizon": horizon,
                   "excitation": {**self.experiment["excitation"], "amplitude": amplitude},
                   "sweep": [{"parameter": "/excitation/amplitude", **sweep}],
                   "accuracy": {"tolerance": 1e-13}}
        file = self.folder / "experiment.json"
        file.write_text(json.dumps(changed), encoding="utf-8")
        subprocess.run([self.program, command, file, "-o", self.folder, "--overwrite", "-q", *flags],
                       stdout=subprocess.DEVNULL, check=True)

    def along(self, state, values):
        """Steps of the attractor that is followed along these amplitudes, each from the end of the step before."""
        self._run("bifurcation", state, {"values": values}, {"transient_periods": 2000, "sampled_periods": SAMPLED})
        steps = json.loads((self.folder / "bifurcation.json").read_text())["diagrams"][0]["steps"]
        return [step for step in steps if step["branch"] == "upwards"]

    def doublings(self, value, state, low, high):
        """Period doublings on the branch of the orbit to which this state leads, between low and high."""
        self._run("orbits", state, {"values": [value]}, {"transient_periods": 5000, "sampled_periods": SAMPLED},
                  "--periods", "1", "--from", repr(low), "--to", repr(high))
        found = json.loads((self.folder / "orbits.json").read_text())
        return [(b["value"], b["error"]) for b in found["bifurcations"]
                if b["kind"] == "period_doubling" and found["branches"][b["branch"]]["period"] > 2]


def period(mode):
    return int(mode[1:-1].split(",")[1]) if mode.startswith("(") else None


def state_of(point):
    return {"tilt": point[0], "tilt_rate": point[1]}


def saddles(branches, value):
    """Points of the unstable orbits at an amplitude, interpolated between neighbours on their branches."""
    for number, branch in enumerate(branches):
        for a, b in zip(branch["points"], branch["points"][1:]):
            low, high = sorted((a["value"], b["value"]))
            if low <= value <= high and low < high and not a["stable"] and not b["stable"]:
                share = (value - a["value"]) / (b["value"] - a["value"])
                yield number, [[x + share * (y - x) for x, y in zip(p[:2], q[:2])]
                               for p, q in zip(a["points"], b["points"])]


def distance(cloud, orbit):
    return min(math.dist(p, q) for p in cloud for q in orbit)


def nearest_saddle(branches, steps):
    """Of the saddles along several amplitudes that are outside of the attractor: the nearest at the last one, with distances."""
    found = {}
    for step in steps:
        for number, orbit in saddles(branches, step["value"]):
            found.setdefault(number, []).append(distance(step["points"], orbit))
    falls = [(d[-1], number, d) for number, d in found.items() if len(d) == len(steps) and max(d) > 0.002]
    if not falls:
        return None
    _, number, distances = min(falls)
    points = branches[number]["points"][0]
    return {"orbit": f"({points['cycles']},{points['period']})", "distances": distances}


def follow(scan, orbits, inside, end, width):
    """The route beyond a doubling `end` = (kind, value) of a stable orbit `inside`, on the scale of a width in A_h; None if
    fewer than four steps show the doubled orbit."""
    n, v = inside["period"], end[1]
    direction = 1.0 if inside["value"] < v else -1.0
    # from the orbit to the doubling in ten steps, finely beyond it, then coarsely
    values = [inside["value"] + (v - inside["value"]) * i / 10 for i in range(10)]
    values += [v + direction * width * (i + 0.5) / 60 for i in range(120)]
    values += [v + direction * width * (2 + i / 6) for i in range(60)]
    values = list(dict.fromkeys(round(x, 10) for x in values if 1.0 <= x <= 10.0))
    steps = sorted(scan.along(inside["state"], values if direction > 0 else values[::-1]),
                   key=lambda step: direction * step["value"])
    beyond = [step for step in steps if direction * (step["value"] - v) > 0]
    if sum(period(step["mode"]) == 2 * n for step in beyond) < 4:
        return None
    found = {"orbit": f"({inside['cycles']},{n})", "doublings": [[v, None]], "chaos": None, "after": None}
    for factor in (2, 4, 8):
        steps_of = [step for step in beyond if period(step["mode"]) == factor * n]
        if not steps_of:
            break
        middle, last = steps_of[len(steps_of) // 2], found["doublings"][-1][0]
        ends = sorted((last - direction * 1e-7, middle["value"] + direction * 2 * abs(middle["value"] - last)))
        later = [d for d in scan.doublings(middle["value"], state_of(middle["points"][-1]), *ends)
                 if direction * (d[0] - last) > 1e-9]
        if not later:
            break
        found["doublings"].append(list(min(later, key=lambda d: abs(d[0] - last))))
    chaotic = [step for step in beyond
               if step["mode"] == "chaotic" and direction * (step["value"] - found["doublings"][-1][0]) > 0]
    if chaotic:
        after = [step for step in beyond if direction * (step["value"] - chaotic[-1]["value"]) > 0]
        found["chaos"] = [chaotic[0]["value"], chaotic[-1]["value"]]
        if after:
            found["after"] = [after[0]["value"], after[0]["mode"]]
            found["saddle"] = nearest_saddle(orbits["branches"], chaotic[-min(5, len(chaotic)):])
    return found


def route(scan, orbits, inside, end):
    """The route with most doublings, on the largest scale on which one is seen or on the next."""
    seen = []
    for width in (1e-1, 1e-2, 1e-3, 1e-4, 1e-5):
        found = follow(scan, orbits, inside, end, width)
        if found or seen:
            seen.append(found)
        if len(seen) == 2:
            break
    return max(filter(None, seen), key=lambda each: (len(each["doublings"]), each["chaos"] is not None), default=None)


def routes(program, experiment, orbits):
    found = []
    with tempfile.TemporaryDirectory() as folder:
        scan = Scan(program, experiment, Path(folder))
        for number, branch in enumerate(orbits["branches"]):
            own = [b for b in orbits["bifurcations"] if b["branch"] == number]
            for first, last, ends in stable_intervals(branch, own):
                for inside, end in ((first, ends[0]), (last, ends[1])):
                    if end[0] == "period_doubling":
                        one = route(scan, orbits, inside, end)
                        found += [one] if one else []
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("orbits", type=Path)
    parser.add_argument("out", type=Path)
    parser.add_argument("--program", default=TOP / "build/release/rocking")
    arguments = parser.parse_args()
    found = {}
    for file in sorted(HERE.glob("*.json")):
        experiment = json.loads(file.read_text(encoding="utf-8"))
        orbits = json.loads((arguments.orbits / file.stem / "orbits.json").read_text(encoding="utf-8"))
        found[file.stem] = routes(arguments.program, experiment, orbits)
        print(file.stem, json.dumps(found[file.stem]), flush=True)
    arguments.out.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
