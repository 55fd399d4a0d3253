"""Writes reports/jeong_yang_2012/branches.md from the results of `rocking orbits` in reports/jeong_yang_2012/branches.

Each was computed by `rocking orbits FILE.json -o DIR --from 1 --to 10 --periods 3` from the file of its name here."""

import json
import lzma
import math
import pathlib

REPORT = pathlib.Path(__file__).resolve().parents[3] / "reports" / "jeong_yang_2012"
RESULTS = {
    "consistent, 0.40/0.35": "consistent_040_035",
    "consistent, 0.35/0.30": "consistent_035_030",
    "as-plotted, 0.40/0.35": "as_plotted_040_035",
    "as-plotted, 0.35/0.30": "as_plotted_035_030",
}

WORDS = {
    "fold": "fold",
    "grazing": "a guard is reached at a rate of 0",
    "contact_change": "the order of contact changes becomes another",
    "symmetry_breaking": "symmetry breaks",
    "period_doubling": "period doubling",
    "range": "end of the range",
    "joins": "branches off",
    "last_point": "last point followed",
    "known": "continues on a branch listed",
    "points": "end of the list",
    "closed": "closed",
}


def stable_parts(branch):
    """Ranges of successive stable orbits of a branch."""
    parts = []
    before = False
    for point in branch["points"]:
        if point["stable"]:
            if before:
                parts[-1].append(point["value"])
            else:
                parts.append([point["value"]])
        before = point["stable"]
    return [(min(part), max(part)) for part in parts]


def end_row(branch, found, index, end):
    """The value at an end of a branch, with its error where a bifurcation was located there."""
    point = branch["points"][0 if end == 0 else -1]
    why = branch["ends"][end]
    near = [
        b for b in found if b["branch"] == index and b["kind"] == why and abs(b["value"] - point["value"]) < 1e-4
    ]
    if not near:
        return f"{point['value']:.6f} ({WORDS[why]})"
    at = min(near, key=lambda b: abs(b["value"] - point["value"]))
    digits = math.ceil(-math.log10(at["error"]))
    return f"{at['value']:.{digits}f} ± {at['error']:.0e} ({WORDS[why]})"


def section(name, data):
    lines = [f"## {name}", ""]
    rows = []
    for index, branch in enumerate(data["branches"]):
        cycles = {point["cycles"] for point in branch["points"]}
        if branch["period"] != 3 or cycles != {1}:
            continue
        inner = [
            f"{b['kind'].replace('_', ' ')} at {b['value']:.9f}"
            for b in data["bifurcations"]
            if b["branch"] == index and b["kind"] not in branch["ends"]
        ]
        parts = ", ".join(f"{low:.4f} to {high:.4f}" for low, high in stable_parts(branch)) or "nowhere"
        ends = [end_row(branch, data["bifurcations"], index, end) for end in (0, 1)]
        if branch["points"][0]["value"] > branch["points"][-1]["value"]:
            ends.reverse()
        rows.append(f"| {index} | {ends[0]} | {ends[1]} | {parts} | {'; '.join(inner) or '-'} |")
    if not rows:
        return lines + ["No orbit (1,3) was found.", ""]
    lines += ["| branch of (1,3) | one end, A_h | other end, A_h | stable | between |", "| --- | --- | --- | --- | --- |"]
    lines += rows + [""]
    return lines


def routes(name, data):
    """Period doublings, and losses of symmetry: how aperiodic responses can begin."""
    found = []
    for kind in ("period_doubling", "symmetry_breaking"):
        values = []
        for b in data["bifurcations"]:
            if b["kind"] != kind:
                continue
            branch = data["branches"][b["branch"]]
            values.append(f"{b['value']:.6f} (n = {branch['period']})")
        found.append(", ".join(values) or "none")
    chaos = [str(c["parameters"]["/excitation/amplitude"]) for c in data["conditions"] if c["run"]["mode"] == "chaotic"] if (
        data["conditions"] and "run" in data["conditions"][0] and "parameters" in data["conditions"][0]
    ) else []
    return f"| {name} | {found[0]} | {found[1]} | {', '.join(chaos) or 'none'} |"


def main():
    results = [
        (name, json.loads(lzma.open(REPORT / "branches" / f"{file}.json.xz").read())) for name, file in RESULTS.items()
    ]
    text = [
        "# Where (1,3) begins and ends",
        "",
        "Periodic orbits of the block of Jeong & Yang (2012), B = 1 m, H = 4 m, Omega_h = 10, with fixed friction, followed over",
        "A_h from 1 to 10 by `rocking orbits` ([branches](../../lib/docs/branches.md)). `experiments/jeong_yang_2012/branches/write.py`",
        "writes this page. Ranges of stable orbits are those of the points followed, whose spacing is at most 0.18.",
        "Between its ends a branch may turn back at a fold, beyond both of them. A value without an error is an end of the range,",
        "or the last point that was followed: where the branch ends beyond it was not located. Orbits come from the runs and the",
        "grid at six amplitudes: there may be others.",
        "",
        "The two branches that begin at A_h = 1 have no slip. Their orbits are those of a block that cannot slide, which go on",
        "beyond the ends given here (`rocking orbits experiments/reference_block/no_sliding.json`). So the guard reached is the",
        "friction limit: (1,3) without slip ends at the onset of slip.",
        "",
        "![Orbits and bifurcations, consistent, 0.40/0.35](figures/branches_consistent_040_035.png)",
        "",
        "![Orbits and bifurcations, consistent, 0.35/0.30](figures/branches_consistent_035_030.png)",
        "",
    ]
    for name, data in results:
        text += section(name, data)
    text += [
        "## How other responses can begin",
        "",
        "| reading | period doublings | losses of symmetry | chaotic runs, of the six amplitudes |",
        "| --- | --- | --- | --- |",
    ]
    text += [routes(name, data) for name, data in results]
    text += [""]
    text += [
        "A chaotic run is no proof of a window of chaos, and no branch tells where a window ends: that is not computed here.",
        "",
    ]
    (REPORT / "branches.md").write_text("\n".join(text), encoding="utf-8")


if __name__ == "__main__":
    main()
