"""The paper's claims, each with the criterion by which it holds or fails in a cell: one reading, one start."""

from dataclasses import dataclass
from typing import Callable

from intervals import beyond_half, share
from published import FRICTIONS, READINGS, STARTS

NEUTRAL = ("rest", "unresolved", "overturned")  # no response, no name, a gap
MORE, LESS = FRICTIONS
ATTRACTORS = (6.6, 8.0, 9.0)


@dataclass
class Finding:
    measured: str
    holds: bool | None  # None: open, or nothing there to judge


def together(verdicts):
    """All hold; one fails; or it is open."""
    return False if False in verdicts else None if None in verdicts else True


def transposed(series):
    """For each realisation its modes along the amplitudes."""
    return list(zip(*series.values()))


def runs_with(series, wanted):
    """How many realisations meet wanted(mode) at some amplitude, of how many."""
    rows = transposed(series)
    return sum(any(wanted(mode) for mode in row) for row in rows), len(rows)


def places(series, wanted):
    """Amplitudes at which the one realisation, or some realisation, meets wanted(mode)."""
    return [amplitude for amplitude, modes in series.items() if any(wanted(mode) for mode in modes)]


def told(series, wanted):
    """From rest: at how many amplitudes; from any start: of how many starts, with the exact interval."""
    k, n = runs_with(series, wanted)
    if n == 1:
        return f"{len(places(series, wanted))} of {len(series)} amplitudes"
    return f"{share(k, n)} of the realisations"


def only(series, allowed):
    def other(mode):
        return mode not in allowed and mode not in NEUTRAL
    seen = sorted({mode for modes in series.values() for mode in modes if other(mode)})
    missing = [wanted for wanted in allowed if not places(series, lambda mode, wanted=wanted: mode == wanted)]
    words = f"others: {told(series, other)}"
    if seen:
        words += " (" + ", ".join(seen[:3]) + (", ..." if len(seen) > 3 else "") + ")"
    if missing:
        words += "; no " + ", no ".join("chaos" if mode == "chaotic" else mode for mode in missing)
    return Finding(words, not missing and not seen)


def regions(series):
    """The order of the regions of (1,1), (1,3) and chaos, along the amplitudes, by the most frequent response. From rest a
    region is two amplitudes or more."""
    least = 2 if len(next(iter(series.values()))) == 1 else 1
    names = []
    for modes in series.values():
        names.append(max(sorted(set(modes)), key=modes.count))
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
    return Finding(", ".join(order), order == ["(1,1)", "(1,3)", "(1,1)", "chaotic"])


def occurs(series, wanted):
    return Finding(told(series, lambda mode: mode == wanted), bool(places(series, lambda mode: mode == wanted)))


def subharmonic_by_friction(data, reading, start):
    more, less = (occurs(data.series(reading, start, pair), "(1,3)") for pair in FRICTIONS)
    return Finding(f"{MORE}: {more.measured}; {LESS}: {less.measured}", more.holds and not less.holds)


def chaos_at_attractors(friction):
    def judge(data, reading, start):
        series = {a: modes for a, modes in data.series(reading, start, friction).items() if a in ATTRACTORS}
        named = [[mode for mode in modes if mode != "unresolved"] for modes in series.values()]
        counts = [(modes.count("chaotic"), len(modes)) for modes in named]
        if start != "any":
            verdicts = [k == n if n else None for k, n in counts]
            words = ", ".join(modes[0] for modes in series.values())
        else:
            verdicts = [beyond_half(k, n) for k, n in counts]
            words = "; ".join(share(k, n) for k, n in counts)
        return Finding(words, together(verdicts))
    return judge


def overturns(data, reading, start):
    found = [occurs(data.series(reading, start, pair), "overturned") for pair in FRICTIONS]
    words = "; ".join(f"{pair}: {finding.measured}" for pair, finding in zip(FRICTIONS, found))
    return Finding(words, any(finding.holds for finding in found))


def change_of_region(friction, mode, grows):
    """Of realisations with the same draws: has the region at the large sigma more amplitudes than at the small one?"""
    def judge(data, reading, start):
        small, large = (transposed(data.series(reading, start, friction, sigma)) for sigma in (0.003, 0.03))
        pairs = [(a.count(mode), b.count(mode)) for a, b in zip(small, large)]
        means = [sum(counts) / len(pairs) for counts in zip(*pairs)]
        if means == [0.0, 0.0]:
            return Finding("none at either sigma", None)
        up = sum(b > a for a, b in pairs)
        down = sum(b < a for a, b in pairs)
        words = f"{means[0]:.1f} to {means[1]:.1f} amplitudes; {'more' if grows else 'fewer'} in "
        k = up if grows else down
        return Finding(words + share(k, up + down) + " that change", beyond_half(k, up + down))
    return judge


def both_between(data, reading, start):
    series = {a: m for a, m in data.series(reading, start, LESS, 0.03).items() if 3.2 <= a <= 4.6}
    found = [occurs(series, mode) for mode in ("(1,1)", "(1,3)")]
    return Finding(f"(1,3): {found[1].measured}", all(finding.holds for finding in found))


def no_two_alike(data, reading, start):
    rows = transposed(data.series(reading, start, LESS, 0.03))
    pairs = list(zip(rows[::2], rows[1::2]))
    k = sum(a != b for a, b in pairs)
    return Finding(f"{share(k, len(pairs))} of the pairs differ", k == len(pairs))


def does_not_recur(data, reading, start):
    """Some condition's two runs differ with a probability whose exact interval stays above 0."""
    place = (reading, None if start == "any" else start, LESS, 0.03)
    run = ("any_start_" if start == "any" else "rest_") + "fluctuating_friction"
    where, best = max((found for found in data.non_recurrence(run) if found[0][:4] == place),
                      key=lambda found: found[1]["differ"])
    low, high = best["differ_interval"]
    return Finding(f"A_h = {where[4]:g}: {100 * best['differ']:.0f} % [{100 * low:.0f}, {100 * high:.0f}]", low > 0.0)


def attractor(friction, question):
    def judge(data, reading, start):
        measured = [row for row in data.measures["attractors"]
                    if (row["reading"], row["start"], row["friction"]) == (reading, start, friction)]
        rows = [row for row in measured if row["chaotic"]]
        if not rows:
            return Finding("no chaos there" if measured else "not run", None)
        if question == "shape":
            words = "; ".join(f"{row['amplitude']:g}: {row['shift_small']:.2f} against {row['shift_within']:.2f}"
                              for row in rows)
            near = [row["shift_small"] <= row["shift_within"] for row in rows]
            far = [row["shift_small_least"] > row["shift_within"] for row in rows]
            return Finding(words, together([True if a else False if b else None for a, b in zip(near, far)]))
        rows = [row for row in rows if row["stays_chaotic"]]
        if not rows:
            return Finding("sigma 0.03 ends the chaos", None)
        words = "; ".join(f"{row['amplitude']:g}: {row['growth']:.2f} [{row['growth_range'][0]:.2f}, "
                          f"{row['growth_range'][1]:.2f}]" for row in rows)
        verdicts = [True if row["growth_range"][0] > 1.0 else False if row["growth_range"][1] < 1.0 else None
                    for row in rows]
        return Finding(words, together(verdicts))
    return judge


@dataclass
class Claim:
    words: str
    criterion: str
    judge: Callable

    def findings(self, data):
        return {(reading, start): self.judge(data, reading, start) for reading in READINGS for start in STARTS}


def _fixed(friction, question, *arguments):
    return lambda data, reading, start: question(data.series(reading, start, friction), *arguments)


CLAIMS = (
    Claim("Without sliding there are only (1,1) and (1,3).",
          "both occur, and no other response; rest, unresolved and overturned count for nothing, here and below",
          _fixed(None, only, ("(1,1)", "(1,3)"))),
    Claim("With 0.40/0.35 and rising A_h: (1,1), (1,3), (1,1), chaos.",
          "the regions of these three come in this order; from rest a region is two neighbouring amplitudes or more, from "
          "any start the most frequent response counts", order_of_regions),
    Claim("With 0.35/0.30 there are only (1,1) and chaos.", "both occur, and no other response",
          _fixed(LESS, only, ("(1,1)", "chaotic"))),
    Claim("(1,3) occurs with 0.40/0.35 and not with 0.35/0.30.", "at one amplitude or more, and at none",
          subharmonic_by_friction),
    Claim("With 0.40/0.35 the response is chaotic at A_h = 6.6, 8.0 and 9.0.",
          "at all three; from any start for more than half of the realisations that have a name, by the exact interval; "
          "unresolved is open",
          chaos_at_attractors(MORE)),
    Claim("With 0.35/0.30 the response is chaotic at A_h = 6.6, 8.0 and 9.0.", "likewise", chaos_at_attractors(LESS)),
    Claim("With sliding the block overturns at some amplitude up to 10: gaps in the bifurcation diagrams.",
          "it does, with one pair of coefficients at least", overturns),
    Claim("sigma = 0.003 leaves the chaotic attractor's shape as it is (0.40/0.35).",
          "where fixed friction gives chaos, the median distance between stretches of the two attractors (section 3) is not "
          "above the largest between stretches of the one without fluctuation; it fails where the least one is above",
          attractor(MORE, "shape")),
    Claim("sigma = 0.003 leaves the chaotic attractor's shape as it is (0.35/0.30).", "likewise", attractor(LESS, "shape")),
    Claim("sigma = 0.03 makes the chaotic attractor larger (0.40/0.35).",
          "where chaos stays chaos, the ratio of the areas is above 1 for every pair of stretches; it fails where it is "
          "below 1 for every pair", attractor(MORE, "size")),
    Claim("sigma = 0.03 makes the chaotic attractor larger (0.35/0.30).", "likewise", attractor(LESS, "size")),
    Claim("The region of (1,3) grows with sigma (0.35/0.30).",
          "of realisations that have it at another number of amplitudes with sigma 0.03 than with 0.003, more than half "
          "have it at more, by the exact interval (a sign test)", change_of_region(LESS, "(1,3)", True)),
    Claim("The region of (1,3) grows with sigma (0.40/0.35).", "likewise", change_of_region(MORE, "(1,3)", True)),
    Claim("The region of chaos shrinks with sigma (0.35/0.30).", "likewise, at fewer",
          change_of_region(LESS, "chaotic", False)),
    Claim("The region of chaos shrinks with sigma (0.40/0.35).", "likewise", change_of_region(MORE, "chaotic", False)),
    Claim("With 0.35/0.30 and sigma 0.03 both (1,1) and (1,3) occur between A_h = 3.2 and 4.6.",
          "each in one realisation or more", both_between),
    Claim("No two bifurcation diagrams under equal conditions are alike (0.35/0.30, sigma 0.03).",
          "every one of the disjoint pairs of realisations differs in response at one amplitude or more; from any start "
          "the two have other starts, too", no_two_alike),
    Claim("Equal conditions do not give equal responses (0.35/0.30, sigma 0.03).",
          "at some amplitude the probability that two runs differ has an exact interval above 0; from any start, likewise",
          does_not_recur),
)
