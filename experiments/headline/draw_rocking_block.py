"""Draws the moving picture of the README: two tests under the same shaking, in periods 618 to 620.

usage: draw_rocking_block.py [PROGRAM [FILE]]     (build/release/rocking, reports/headline/rocking_block.svg)

Writes an SVG with CSS keyframes and without scripts. Both tests are realisations of
in_the_end.json at A_h = 4 and friction 0.40/0.35. They differ in the random numbers of their friction alone. In the last
three periods each repeats itself to rounding, so that the picture can go round.
"""

import json
import math
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
CONDITION, TESTS = 25, ((3, "one test ends in (1,1)", "rocks once in each period"),
                        (5, "another ends in (1,3)", "rocks once in three periods"))
PERIODS, SAMPLES, STRIDE = 3, 120, 3  # shown; per period of the trajectory; of a frame
SLOWER, ENLARGED = 6.0, 5.0
WIDTH, HEIGHT, FLOOR, STRIP, SCALE = 720, 390, 260, 335, 48.0  # pixels; pixels of a metre


def trajectory(program, realisation):
    command = [program, "trajectory", str(HERE / "in_the_end.json"), "--condition", str(CONDITION), "--realisation",
               str(realisation), "--periods", "620", "--samples", str(SAMPLES), "-q"]
    return json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout)


def keyframes(name, states):
    """Frames at equal distances; the last one is the first one again."""
    steps = "".join(f"{100 * i / (len(states) - 1):.2f}%{{transform:{state}}}" for i, state in enumerate(states))
    return f"@keyframes {name}{{{steps}}}\n"


def pose(block, tilt):
    """How the middle of the base lies, and how the block is turned: about its left edge if the tilt is positive."""
    angle = ENLARGED * block["shape_angle_rad"] * tilt
    half = 0.5 * SCALE * block["width_m"]
    aside = half * (math.cos(angle) - 1.0) * math.copysign(1.0, angle)
    return (f"translate({aside:.2f}px,{-half * abs(math.sin(angle)):.2f}px) "
            f"rotate({-math.degrees(angle):.2f}deg)")


def panel(left, number, title, words, found):
    """A block on its floor, and its tilt against time below."""
    block, history = found["block"], found["history"][-PERIODS * SAMPLES - 1:]
    assert abs(history[0]["tilt"] - history[-1]["tilt"]) < 1e-9, "the motion does not repeat"
    shown = history[::STRIDE]
    wide, tall = SCALE * block["width_m"], SCALE * block["height_m"]
    middle, across, high = left + 170, 300, 34
    begin = middle - across // 2
    path = " ".join(f"{begin + across * i / (len(shown) - 1):.1f},{STRIP - high * state['tilt'] / 0.13:.1f}"
                    for i, state in enumerate(shown))
    marks = "".join(f"M{x} 0l-5 7" for x in range(-145, 150, 14))
    lines = "".join(f"M{begin + i * across // PERIODS} {STRIP - high}v{2 * high}" for i in range(PERIODS + 1))
    style = keyframes(f"block{number}", [pose(block, state["tilt"]) for state in shown])
    style += f".block{number}{{animation-name:block{number}}}\n"
    drawing = f"""<text x="{middle}" y="24" class="title">{title}</text>
<text x="{middle}" y="42">{words}</text>
<g transform="translate({middle} {FLOOR})"><g class="moves floor">
<path d="M-150 0H150" class="ground"/><path d="{marks}" class="pale"/>
<g class="moves block{number}" style="transform:{pose(block, shown[0]['tilt'])}">
<rect x="{-wide / 2:g}" y="{-tall:g}" width="{wide:g}" height="{tall:g}" class="body"/>
<circle cy="{-tall / 2:g}" r="3"/></g></g></g>
<path d="M{begin} {STRIP}h{across}{lines}" class="pale"/>
<polyline points="{path}" class="tilt"/>
<path d="M{begin} {STRIP - high}v{2 * high}" class="moves now"/>
<text x="{begin - 8}" y="{STRIP + 4}" class="end">tilt</text>
"""
    return style, drawing


def picture(found):
    block = found[0]["block"]
    rate = 10.0 * block["frequency_parameter_rad_s"]  # Omega_h p
    amplitude = 4.0 * block["shape_angle_rad"] * block["gravity_m_s2"] / rate**2
    frames = PERIODS * SAMPLES // STRIDE
    waves = [-ENLARGED * SCALE * amplitude * math.sin(2.0 * math.pi * PERIODS * i / frames) for i in range(frames + 1)]
    seconds = SLOWER * PERIODS * 2.0 * math.pi / rate
    style = keyframes("floor", [f"translate({wave:.2f}px,0)" for wave in waves])
    style += keyframes("now", ["translate(0,0)", "translate(300px,0)"])
    panels = [panel(left, number, title, words, one)
              for number, (left, (_, title, words), one) in enumerate(zip((10, 370), TESTS, found), 1)]
    note = f"{SLOWER:g} times slower; tilt and floor motion {ENLARGED:g} times enlarged; from line to line one period"
    return f"""<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}"
 role="img">
<title>Two blocks on the same shaken floor: one rocks once in each period, the other once in three</title>
<style>
text{{font:13px system-ui,"DejaVu Sans",sans-serif;text-anchor:middle;fill:#1a1a1a}}
.title{{font-weight:bold}}.end{{text-anchor:end}}.small{{font-size:11px;fill:#555}}
.ground{{stroke:#1a1a1a;stroke-width:2}}.pale{{stroke:#8a929b;fill:none}}.body{{fill:#dbe9f6;stroke:#1a1a1a;stroke-width:2}}
.tilt{{fill:none;stroke:#1a1a1a;stroke-width:1.5}}
.now{{stroke:#d55e00;stroke-width:2;animation-name:now}}.floor{{animation-name:floor}}
.moves{{animation-duration:{seconds:.2f}s;animation-timing-function:linear;animation-iteration-count:infinite}}
@media (prefers-reduced-motion:reduce){{.moves{{animation-play-state:paused}}}}
{"".join(style for style, _ in panels)}{style}</style>
<rect width="{WIDTH}" height="{HEIGHT}" rx="8" fill="#fff"/>
{"".join(drawing for _, drawing in panels)}<text x="{WIDTH / 2:g}" y="{HEIGHT - 6}" class="small">{note}</text>
</svg>
"""


def main():
    given = sys.argv[1:]
    program = given[0] if given else str(ROOT / "build/release/rocking")
    file = pathlib.Path(given[1]) if len(given) > 1 else ROOT / "reports/headline/rocking_block.svg"
    found = [trajectory(program, realisation) for realisation, _, _ in TESTS]
    file.write_text(picture(found), encoding="utf-8")


if __name__ == "__main__":
    main()
