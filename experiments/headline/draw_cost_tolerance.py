"""Draws what a tolerance costs and what it changes: error, changed response modes and time against the tolerance.

usage: draw_cost_tolerance.py [FILE]     (reports/headline/cost_tolerance.svg)

The tables in reports/headline are those that `rocking report` writes beside its figures of cost.json:
    rocking cost experiments/headline/headline.json --sample 1223 -o cost
    rocking report cost/cost.json -o drawn     # drawn/cost_tolerance.tsv
and the same of experiments/reference_block/no_sliding.json, of which all realisations are measured.
"""

import math
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
TABLES = ROOT / "reports/headline"
SERIES = (("cost_tolerance.tsv", "fluctuating friction (headline)", "first"),
          ("cost_tolerance_no_sliding.tsv", "no sliding", "second"))
COMPARED = 1e-13  # the default tolerance
WIDTH, HEIGHT, TOP, BOTTOM, ACROSS = 720, 258, 62, 208, 180  # pixels; of a panel
LEFT = (62, 296, 530)
TITLES = ("median error of a trajectory", "changed response modes, %", "time, relative to default")


def table(name):
    """Rows of numbers by the names of the columns."""
    lines = (TABLES / name).read_text(encoding="utf-8").splitlines()
    columns = next(line for line in reversed(lines) if line.startswith("# "))[2:].split("\t")
    rows = [dict(zip(columns, map(float, line.replace('"', "").split("\t")))) for line in lines
            if line and not line.startswith("#")]
    unit = next(row["time"] for row in rows if math.isclose(row["tolerance"], COMPARED))
    return [{**row, "time": row["time"] / unit} for row in rows]


def across(left, tolerance):
    return left + 6 + (ACROSS - 12) * (math.log10(tolerance) + 14) / 10


class Axis:
    """The vertical axis of a panel from `low` to `high`; if `is_log`, of logarithms, with zero at the lower end."""

    def __init__(self, low, high, is_log=False):
        self.low, self.high, self.is_log = low, high, is_log

    def __call__(self, value):
        if self.is_log:
            value = math.log10(max(value, 10.0**self.low))
        return BOTTOM - (BOTTOM - TOP) * (value - self.low) / (self.high - self.low)


def power(x, y, exponent, kind):
    """The text 10 to the exponent."""
    raised = f'<tspan dy="-4" class="small">−{-exponent}</tspan>'
    return f'<text x="{x:.1f}" y="{y:.1f}" class="{kind}">10{raised}</text>'


def frame(left, title, axis, marks):
    """Title, axes and their marks."""
    lines = f"M{left} {TOP}V{BOTTOM}H{left + ACROSS}"
    words = f'<text x="{left + ACROSS / 2:g}" y="{TOP - 12}" class="title">{title}</text>'
    for mark in marks:
        y = axis(10.0**mark if mark < 0 else mark)
        lines += f"M{left} {y:.1f}h-4"
        words += (power(left - 7, y + 4, mark, "end") if mark < 0 else
                  f'<text x="{left - 7}" y="{y + 4:.1f}" class="end">{mark:g}</text>')
    for exponent in (-14, -11, -8, -5):
        x = across(left, 10.0**exponent)
        lines += f"M{x:.1f} {BOTTOM}v4"
        words += power(x, BOTTOM + 20, exponent, "middle")
    words += f'<text x="{left + ACROSS / 2:g}" y="{BOTTOM + 38}">tolerance</text>'
    return f'<path d="{lines}" class="axis"/>{words}\n'


def marker(x, y, series):
    if series == "first":
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.5" class="{series} mark"/>'
    return f'<rect x="{x - 3:.1f}" y="{y - 3:.1f}" width="6" height="6" class="{series} mark"/>'


def curve(left, axis, rows, column, series):
    """Line and markers, and intervals where the table has them."""
    points = [(across(left, row["tolerance"]), axis(row[column]), row) for row in rows if not math.isnan(row[column])]
    ends = ""
    if column == "changed":
        ends = "".join(f"M{x:.1f} {axis(row['changed_low']):.1f}V{axis(row['changed_high']):.1f}"
                       for x, _, row in points if not math.isnan(row["changed_low"]))
    path = " ".join(f"{x:.1f},{y:.1f}" for x, y, _ in points)
    return (f'<polyline points="{path}" class="{series} line"/><path d="{ends}" class="{series}"/>'
            + "".join(marker(x, y, series) for x, y, _ in points) + "\n")


def picture():
    """The figure as text."""
    axes = ((Axis(-14.5, -3, True), (-14, -11, -8, -5)), (Axis(-1.6, 1.6, True), (0, 0.1, 1, 10)),
            (Axis(0, 1.2), (0, 0.5, 1)))
    drawn = "".join(frame(left, title, *axis) for left, title, axis in zip(LEFT, TITLES, axes))
    key, rows = "", [table(name) for name, _, _ in SERIES]
    for (_, words, series), of_series, x in zip(SERIES, rows, (150, 470)):
        key += (f'<path d="M{x} 18h34" class="{series} line"/>{marker(x + 17, 18, series)}'
                f'<text x="{x + 42}" y="22" class="begin">{words}</text>\n')
        for left, (axis, _), column in zip(LEFT, axes, ("median_error", "changed", "time")):
            drawn += curve(left, axis, of_series, column, series)
    return f"""<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}"
 role="img">
<title>Median error, changed response modes and time per period against the tolerance</title>
<style>
text{{font:13px system-ui,"DejaVu Sans",sans-serif;text-anchor:middle;fill:#1a1a1a}}
.title{{font-size:12.5px;font-weight:bold}}.end{{text-anchor:end}}.begin{{text-anchor:start}}.small{{font-size:9.5px}}
.axis{{stroke:#1a1a1a;fill:none}}.line{{stroke-width:1.8;fill:none}}
.first{{stroke:#0072b2}}.second{{stroke:#d55e00}}.second.line{{stroke-dasharray:5 3}}
.first.mark{{fill:#0072b2}}.second.mark{{fill:#fff;stroke-width:1.5}}
</style>
<rect width="{WIDTH}" height="{HEIGHT}" rx="8" fill="#fff"/>
{key}{drawn}</svg>
"""


def main():
    given = sys.argv[1:]
    file = pathlib.Path(given[0]) if given else TABLES / "cost_tolerance.svg"
    file.write_text(picture(), encoding="utf-8")


if __name__ == "__main__":
    main()
