"""Gain of `rocking rare` over `rocking run` in scenes drawn at random: reports/evidence/rare.md, "Scenes drawn at random".

    python3 experiments/rare/gain.py PROGRAM FOLDER [SEED [SCENES]]

Writes FOLDER/scenes.json, unless it is there, and prints the table. The gain is the variance of plain sampling, per
processor time of `rocking run`, over that of `rocking rare` with its default options: (1 - p)/(p e^2) t_plain/t_rare,
with the mean of the squared errors e that several seeds state.
"""

import json
import math
import os
import random
import resource
import statistics
import subprocess
import sys

SEEDS = range(1, 6)
PLAIN = 20000  # realisations whose time is measured


def scene_of(draw):
    height = draw.uniform(0.3, 2.0)
    return {"height": round(height, 3), "width": round(height / draw.uniform(2.5, 6.0), 3),
            "omega": round(draw.uniform(2.0, 15.0), 2), "scatter": round(draw.uniform(0.05, 0.15), 3),
            "wanted": 10.0 ** draw.uniform(-7.0, -4.0)}


def experiment(scene, seed):
    amplitude = scene["amplitude"]
    return {"format": "rocking.experiment/1",
            "block": {"width_m": scene["width"], "height_m": scene["height"]},
            "excitation": {"kind": "harmonic", "amplitude": amplitude, "frequency_ratio": scene["omega"]},
            "fluctuation": {"amplitude": {"sigma": scene["scatter"] * amplitude}},
            "horizon": {"transient_periods": 10, "sampled_periods": 30}, "realisations": PLAIN, "seed": hex(seed)}


def call(program, folder, command, scene, seed, *flags):
    """The processor time [s]."""
    file = os.path.join(folder, "scene.json")
    with open(file, "w", encoding="utf-8") as out:
        json.dump(experiment(scene, seed), out)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([program, command, file, "-o", os.path.join(folder, command), "--overwrite", "-j", "1", "-q", *flags],
                   check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def rare(program, folder, scene, seed, *flags):
    time = call(program, folder, "rare", scene, seed, *flags)
    with open(os.path.join(folder, "rare", "rare.json"), encoding="utf-8") as file:
        return json.load(file)["conditions"][0], time


def find_amplitude(program, folder, scene):
    """By halving the interval of its logarithm."""
    low, high = None, None
    scene["amplitude"] = round(0.7 * scene["omega"] ** 0.8, 4)
    for _ in range(20):
        found = rare(program, folder, scene, 1, "--relative-error", "0.5", "--max-time", "30s")[0]["probability"] or 0.0
        if found > 0.0 and abs(math.log(found / scene["wanted"])) < 0.3:
            return
        if found < scene["wanted"]:
            low = scene["amplitude"]
        else:
            high = scene["amplitude"]
        guess = math.sqrt(low * high) if low and high else 1.3 * low if low else high / 1.3
        scene["amplitude"] = round(guess, 4)
    raise SystemExit(f"no amplitude found for {scene}")


def scenes_in(program, folder, seed, count):
    path = os.path.join(folder, "scenes.json")
    if not os.path.exists(path):
        draw = random.Random(seed)
        scenes = [scene_of(draw) for _ in range(count)]
        for scene in scenes:
            find_amplitude(program, folder, scene)
        with open(path, "w", encoding="utf-8") as file:
            json.dump(scenes, file, indent=1)
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def measure(program, folder, scene):
    runs = [rare(program, folder, scene, seed) for seed in SEEDS]
    estimates = [found["probability"] or 0.0 for found, _ in runs]
    mean = statistics.fmean(estimates)
    square = statistics.fmean((found["relative_error"] or 1.0) ** 2 for found, _ in runs)
    time = statistics.fmean(time for _, time in runs)
    plain = call(program, folder, "run", scene, 1) / PLAIN
    return {"p": mean, "error": math.sqrt(square), "time": time, "plain": plain,
            "spread": statistics.variance(estimates) / mean ** 2 / square,
            "gain": (1.0 - mean) / (mean * square) * plain / time, "work": statistics.fmean(f["work"] for f, _ in runs)}


def main():
    program, folder = sys.argv[1:3]
    seed, count = (int(sys.argv[3]) if len(sys.argv) > 3 else 73), (int(sys.argv[4]) if len(sys.argv) > 4 else 10)
    os.makedirs(folder, exist_ok=True)
    print("| H [m] | B [m] | Omega_h | scatter | amplitude | p | error | work | time | plain, each | gain |\n|" + " --- |" * 11)
    gains, spreads = [], []
    for scene in scenes_in(program, folder, seed, count):
        found = measure(program, folder, scene)
        gains.append(found["gain"])
        spreads.append(found["spread"])
        print(f"| {scene['height']} | {scene['width']} | {scene['omega']} | {scene['scatter']} | {scene['amplitude']} | "
              f"{found['p']:.2e} | {100 * found['error']:.1f} % | {found['work']:.3g} | {found['time']:.2f} s | "
              f"{1e6 * found['plain']:.0f} us | {found['gain']:.3g} |", flush=True)
    print(f"\nmedian gain {statistics.median(gains):.3g}, least {min(gains):.3g}; "
          f"squared spread of seeds over that stated, mean {statistics.fmean(spreads):.2f}")


if __name__ == "__main__":
    main()
