"""The paper's claims, each with the criterion by which it is decided in a cell: one reading, one start."""

import math
from dataclasses import dataclass, replace
from typing import Callable

from cells import ATTRACTORS, FRICTIONS, READINGS, SIGMAS, STARTS, cell_name
from intervals import Share, above, at, half_width, level_of, paired_difference

HOLDS, FAILS, NO_REGIME, UNDECIDABLE = "holds", "fails", "no such regime", "undecidable"
NEUTRAL = ("rest", "unresolved", "overturned")  # no response, not classified, a gap
MORE, LESS = FRICTIONS

RARE = 0.05  # a response that fewer starts or runs show does not count
NEAR = "a response occurs in about 5 % of the runs"
STEP = 0.1 / 9.0  # one step of the paper's diagrams, as a share of their range: no smaller change can be seen in them
ALIKE = 0.1  # two diagrams that are alike with a smaller probability count as never alike
SHIFT = 0.1  # in standard deviations: no change of shape can be seen below it
GROWTH = 1.1  # of the area: 5 % in each direction
ENOUGH = 40  # chaotic attractors of a condition, below which there is no such regime


@dataclass
class Finding:
    measured: str
    verdict: str
    reason: str = ""
    over_all: str = ""  # the verdict with intervals that hold together over all claims


def verdict_of(answer):
    return {True: HOLDS, False: FAILS, None: UNDECIDABLE}[answer]


def both(answers):
    """True: all are; False: one is not; None: undecided."""
    return False if False in answers else None if None in answers else True


def transposed(series):
    """For each realisation, its response modes in the order of the amplitudes."""
    return list(zip(*series.values()))


def occurrence(series, wanted):
    """Of a run that meets wanted(mode) at one amplitude or more: whether that occurs, and how often.

    A single run without anything random: it does or does not. Else the share of the runs is compared with RARE.
    """
    rows = transposed(series)
    k, n = sum(any(wanted(mode) for mode in row) for row in rows), len(rows)
    if n == 1:
        return bool(k), f"{sum(map(wanted, rows[0]))} of {len(rows[0])} amplitudes"
    return above(Share(k, n).interval, RARE), f"{Share(k, n)} runs"


def is_mode(name):
    return lambda mode: mode == name


def only(series, allowed):
    def other(mode):
        return mode not in allowed and mode not in NEUTRAL
    answers, words = [], []
    for mode in allowed:
        found, told = occurrence(series, is_mode(mode))
        answers.append(found)
        words.append(f"{mode}: {told}")
    found, told = occurrence(series, other)
    seen = sorted({mode for modes in series.values() for mode in modes if other(mode)})
    words.append(f"others: {told}" + (f" ({', '.join(seen[:3])}{', ...' if len(seen) > 3 else ''})" if seen else ""))
    return Finding("; ".join(words), verdict_of(both([*answers, None if found is None else not found])), NEAR)


def regions(series):
    """The regions of (1,1), (1,3) and chaos in the order of the amplitudes, by the most frequent response. From rest a
    region has two amplitudes or more."""
    least = 2 if len(next(iter(series.values()))) == 1 else 1
    names = [max(sorted(set(modes)), key=modes.count) for modes in series.values()]
    order, i = [], 0
    while i < len(names):
        j = i
        while j < len(names) and names[j] == names[i]:
            j += 1
        if j - i >= least and names[i] in ("(1,1)", "(1,3)", "chaotic") and (not order or order[-1] != names[i]):
            order.append(names[i])
        i = j
    return order


def order_of_regions(data, reading, start):
    order = regions(data.series(reading, start, MORE))
    return Finding(", ".join(order), verdict_of(order == ["(1,1)", "(1,3)", "(1,1)", "chaotic"]))


def subharmonic_by_friction(data, reading, start):
    found = [occurrence(data.series(reading, start, pair), is_mode("(1,3)")) for pair in FRICTIONS]
    words = "; ".join(f"{pair}: {told}" for pair, (_, told) in zip(FRICTIONS, found))
    (more, _), (less, _) = found
    return Finding(words, verdict_of(both([more, None if less is None else not less])), NEAR)


def chaos_at_attractors(friction):
    def judge(data, reading, start):
        series = {a: modes for a, modes in data.series(reading, start, friction).items() if a in ATTRACTORS}
        counts = [(modes.count("chaotic"), len(modes) - modes.count("unresolved")) for modes in series.values()]
        if start != "any":
            words = ", ".join(modes[0] for modes in series.values())
            return Finding(words, verdict_of(both([k == n if n else None for k, n in counts])),
                           "a response is neither periodic, nor is its exponent clear, to the end of the observation")
        return Finding("; ".join(str(Share(k, n)) for k, n in counts),
                       verdict_of(both([above(Share(k, n).interval, 0.5) for k, n in counts])),
                       "chaos is about as likely as another response")
    return judge


def overturns(data, reading, start):
    found = [occurrence(data.series(reading, start, pair), is_mode("overturned")) for pair in FRICTIONS]
    words = "; ".join(f"{pair}: {told}" for pair, (_, told) in zip(FRICTIONS, found))
    answers = [answer for answer, _ in found]
    return Finding(words, verdict_of(True if True in answers else None if None in answers else False), NEAR)


def region_change(data, reading, start, friction, mode):
    """By how much the share of A_h with this mode grows from sigma 0.003 to 0.03, with the exact interval.

    Realisation by realisation, at the same random amplitude, with common random numbers."""
    small, large = (data.region(reading, start, friction, sigma) for sigma in SIGMAS)
    up = sum(a != mode and b == mode for a, b in zip(small, large))
    down = sum(a == mode and b != mode for a, b in zip(small, large))
    return ((up - down) / len(small), *paired_difference(up, down, len(small)))


def change_of_region(friction, mode, sign):
    """Does the region of a mode grow (sign 1) or shrink (sign -1) by more than a STEP?"""
    def judge(data, reading, start):
        runs = [data.region(reading, start, friction, sigma) for sigma in SIGMAS]
        n = len(runs[0])
        sizes = [Share(modes.count(mode), n) for modes in runs]
        words = f"{sizes[0].percent(1)} % to {sizes[1].percent(1)} % of the range"
        if all(above(size.interval, STEP) is False for size in sizes):
            return Finding(f"{words}, of {n} runs", NO_REGIME, "the region is smaller than a step of 0.1 in A_h")
        change, low, high = region_change(data, reading, start, friction, mode)
        words += f": {100 * change:+.1f} [{100 * low:+.1f}, {100 * high:+.1f}] points, of {n} runs"
        grown = (low, high) if sign > 0 else (-high, -low)
        return Finding(words, verdict_of(above(grown, STEP)), f"the change is too near to the bound of {100 * STEP:.1f}")
    return judge


def both_between(data, reading, start):
    series = {a: modes for a, modes in data.diagrams(reading, start).items() if 3.2 <= a <= 4.6}
    found = [occurrence(series, is_mode(mode)) for mode in ("(1,1)", "(1,3)")]
    words = "; ".join(f"{mode}: {told}" for mode, (_, told) in zip(("(1,1)", "(1,3)"), found))
    return Finding(words, verdict_of(both([answer for answer, _ in found])), NEAR)


def pairs_that_differ(data, reading, start):
    rows = transposed(data.diagrams(reading, start))
    pairs = list(zip(rows[::2], rows[1::2]))
    places = sum(sum(a != b for a, b in zip(*pair)) for pair in pairs) / len(pairs)
    return Share(sum(a != b for a, b in pairs), len(pairs)), places


def no_two_alike(data, reading, start):
    differ, places = pairs_that_differ(data, reading, start)
    return Finding(f"{differ} pairs differ, at {places:.1f} amplitudes on the average",
                   verdict_of(above(differ.interval, 1.0 - ALIKE)), "two diagrams are alike about once in ten times")


def does_not_recur(data, reading, start):
    differ, places = pairs_that_differ(data, reading, start)
    return Finding(f"{differ} pairs differ, at {places:.1f} amplitudes on the average",
                   verdict_of(above(differ.interval, ALIKE)), "two diagrams differ about once in ten times")


def interval_of(found, question):
    """Of a measure of attractors with its error; that of a growth is the error of the logarithm."""
    half, value = half_width() * found["error"], found["value"]
    return (max(0.0, value - half), value + half) if question == "shift" else (value * math.exp(-half), value * math.exp(half))


def attractor(friction, question):
    def judge(data, reading, start):
        rows = [row for row in data.measures["attractors"]
                if (row["reading"], row["start"], row["friction"]) == (reading, start, friction)]
        answers, words = [], []
        for row in rows:
            found = row.get(question)
            if found is None:
                continue
            low, high = interval_of(found, question)
            words.append(f"{row['amplitude']:g}: {found['value']:.2f} [{low:.2f}, {high:.2f}]")
            larger = above((low, high), SHIFT if question == "shift" else GROWTH)
            answers.append(larger if question == "growth" else None if larger is None else not larger)
        ended = [row for row in rows if row["regime"] and question not in row]
        words += [f"{row['amplitude']:g}: the chaos ends" for row in ended]
        if question == "shift":
            answers += [False] * len(ended)
        if not answers:
            return Finding("; ".join(words) or "no chaos", NO_REGIME,
                           "sigma 0.03 ends the chaos" if ended else "no chaos with fixed friction at these amplitudes")
        return Finding("; ".join(words), verdict_of(both(answers)), "the measure is too near to the bound")
    return judge


@dataclass
class Claim:
    figures: str  # of the paper, as far as known, that show what is claimed
    words: str
    criterion: str
    judge: Callable
    run: Callable  # of reading and start: the name of the run that is sampled further while the verdict is open

    def findings(self, data):
        def judged():
            return {(reading, start): self.judge(data, reading, start) for reading in READINGS for start in STARTS}
        with at(level_of(len(CLAIMS))):
            over_all = judged()
        return {cell: replace(finding, over_all=over_all[cell].verdict) for cell, finding in judged().items()}


def _fixed(friction, question, *arguments):
    return lambda data, reading, start: question(data.series(reading, start, friction), *arguments)


def _grid(kind):
    return lambda reading, start: ("any_start_" if start == "any" else "rest_") + kind


def _cell(family):
    return lambda reading, start: cell_name(family, reading, start)


_ANY = (" From any start a response occurs if more than 5 % of the starts show it at one amplitude or more (exact interval); "
        "from rest if one amplitude does")

CLAIMS = (
    Claim("3", "Without sliding there are only (1,1) and (1,3).",
          "both occur, and no other response does; rest, unresolved and overturned are ignored, here and below." + _ANY,
          _fixed(None, only, ("(1,1)", "(1,3)")), _grid("no_sliding")),
    Claim("4", "With 0.40/0.35 and rising A_h: (1,1), (1,3), (1,1), chaos.",
          "the regions of these three are in this order; from rest a region has two neighbouring amplitudes or more; from "
          "any start the region is that of the most frequent response", order_of_regions, _grid("fixed_friction")),
    Claim("5", "With 0.35/0.30 there are only (1,1) and chaos.", "both occur, and no other response does (as for claim 1)",
          _fixed(LESS, only, ("(1,1)", "chaotic")), _grid("fixed_friction")),
    Claim("4, 5", "(1,3) occurs with 0.40/0.35 and not with 0.35/0.30.",
          "it occurs with 0.40/0.35 and does not with 0.35/0.30 (as for claim 1)",
          subharmonic_by_friction, _grid("fixed_friction")),
    Claim("6", "With 0.40/0.35 the response is chaotic at A_h = 6.6, 8.0 and 9.0.",
          "at all three; from any start for more than half of the realisations that are classified, by the exact interval",
          chaos_at_attractors(MORE), _grid("fixed_friction")),
    Claim("6", "With 0.35/0.30 the response is chaotic at A_h = 6.6, 8.0 and 9.0.", "as for claim 5",
          chaos_at_attractors(LESS), _grid("fixed_friction")),
    Claim("4, 5", "With sliding the block overturns at some amplitude up to 10: gaps in the bifurcation diagrams.",
          "it occurs (as for claim 1) with at least one pair of coefficients. The verdict depends on how long one looks: a run "
          "ends here when two windows in succession are chaotic, at 620 periods or later; section 5 has longer observations",
          overturns, _grid("fixed_friction")),
    Claim("8", "sigma = 0.003 does not change the shape of the chaotic attractor (0.40/0.35).",
          "at each of A_h = 6.6, 8 and 9 at which fixed friction gives chaos, the distance of the attractors without and with "
          "fluctuation is below 0.1 standard deviations; it fails if the distance is above that at one of them, or if the "
          "fluctuation ends the chaos. The cells give A_h and the distance with its interval",
          attractor(MORE, "shift"), None),
    Claim("8", "sigma = 0.003 does not change the shape of the chaotic attractor (0.35/0.30).", "as for claim 8",
          attractor(LESS, "shift"), None),
    Claim("8", "sigma = 0.03 makes the chaotic attractor larger (0.40/0.35).",
          "at each of A_h = 6.6, 8 and 9 at which the response is chaotic with fixed friction and with sigma 0.03, the area "
          "of the attractor grows by more than 10 %, a factor of 1.1; it fails if it grows by less at one of them. The cells "
          "give A_h and the factor with its interval", attractor(MORE, "growth"), None),
    Claim("8", "sigma = 0.03 makes the chaotic attractor larger (0.35/0.30).", "as for claim 10", attractor(LESS, "growth"), None),
    Claim("7", "The region of (1,3) grows with sigma (0.35/0.30).",
          "from sigma 0.003 to 0.03 the share of A_h from 1 to 10 with this response grows by more than one step of 0.1, that "
          "is by 1.1 percentage points of the range; it fails if it grows by less. There is no such regime if at both sigmas "
          "the region is smaller than a step", change_of_region(LESS, "(1,3)", 1), _cell("regions")),
    Claim("7", "The region of (1,3) grows with sigma (0.40/0.35).", "as for claim 12", change_of_region(MORE, "(1,3)", 1),
          _cell("regions")),
    Claim("7", "The region of chaos shrinks with sigma (0.35/0.30).", "as for claim 12, with chaos that shrinks",
          change_of_region(LESS, "chaotic", -1), _cell("regions")),
    Claim("7", "The region of chaos shrinks with sigma (0.40/0.35).", "as for claim 14",
          change_of_region(MORE, "chaotic", -1), _cell("regions")),
    Claim("10", "With 0.35/0.30 and sigma 0.03 both (1,1) and (1,3) occur between A_h = 3.2 and 4.6.",
          "each in more than 5 % of the realisations, at one of the amplitudes there or more (steps as for claim 17)",
          both_between, _cell("diagrams")),
    Claim("9", "No two bifurcation diagrams under equal conditions are alike (0.35/0.30, sigma 0.03).",
          "two diagrams have the same responses with a probability below 10 %, by the exact interval on disjoint pairs of "
          "realisations; A_h from 1 to 10 in steps of 0.2 under `consistent`, `as-printed` and `as-plotted`, and of 0.6 under "
          "the others; from any start the two also have different initial states",
          no_two_alike, _cell("diagrams")),
    Claim("9, 10", "Equal conditions do not give equal responses (0.35/0.30, sigma 0.03).",
          "two diagrams differ in response with a probability above 10 %, as for claim 17",
          does_not_recur, _cell("diagrams")),
)


def undecided(name, data):
    """Whether more realisations of this run could decide a claim in a cell."""
    return any(claim.judge(data, reading, start).verdict == UNDECIDABLE
               for claim in CLAIMS if claim.run is not None
               for reading in READINGS for start in STARTS if claim.run(reading, start) == name)
