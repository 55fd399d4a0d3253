"""The paper's claims, each with the criterion by which it holds or fails in a cell: one reading, one start."""

from dataclasses import dataclass
from typing import Callable

from intervals import beyond_half, share
from published import FRICTIONS, READINGS, STARTS

NEUTRAL = ("rest", "unresolved", "overturned")  # no response, not classified, a gap
MORE, LESS = FRICTIONS
ATTRACTORS = (6.6, 8.0, 9.0)


@dataclass
class Finding:
    measured: str
    holds: bool | None  # None: open, or no case to judge


def together(results):
    """True: all hold; False: one fails; None: open."""
    return False if False in results else None if None in results else True


def transposed(series):
    """For each realisation, its response modes in the order of the amplitudes."""
    return list(zip(*series.values()))


def runs_with(series, wanted):
    """Number of realisations that meet wanted(mode) at one amplitude or more, and number of realisations."""
    rows = transposed(series)
    return sum(any(wanted(mode) for mode in row) for row in rows), len(rows)


def places(series, wanted):
    """Amplitudes at which at least one realisation meets wanted(mode)."""
    return [amplitude for amplitude, modes in series.items() if any(wanted(mode) for mode in modes)]


def told(series, wanted):
    """From rest: the number of amplitudes; from any start: the share of the starts, with the exact interval."""
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
    """The regions of (1,1), (1,3) and chaos in the order of the amplitudes, by the most frequent response. From rest a
    region has two amplitudes or more."""
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
        classified = [[mode for mode in modes if mode != "unresolved"] for modes in series.values()]
        counts = [(modes.count("chaotic"), len(modes)) for modes in classified]
        if start != "any":
            results = [k == n if n else None for k, n in counts]
            words = ", ".join(modes[0] for modes in series.values())
        else:
            results = [beyond_half(k, n) for k, n in counts]
            words = "; ".join(share(k, n) for k, n in counts)
        return Finding(words, together(results))
    return judge


def overturns(data, reading, start):
    found = [occurs(data.series(reading, start, pair), "overturned") for pair in FRICTIONS]
    words = "; ".join(f"{pair}: {finding.measured}" for pair, finding in zip(FRICTIONS, found))
    return Finding(words, any(finding.holds for finding in found))


def change_of_region(friction, mode, grows):
    """With common random numbers: does the region have more amplitudes at the large sigma than at the small one?"""
    def judge(data, reading, start):
        small, large = (transposed(data.series(reading, start, friction, sigma)) for sigma in (0.003, 0.03))
        pairs = [(a.count(mode), b.count(mode)) for a, b in zip(small, large)]
        means = [sum(counts) / len(pairs) for counts in zip(*pairs)]
        if means == [0.0, 0.0]:
            return Finding("none at either sigma", None)
        up = sum(b > a for a, b in pairs)
        down = sum(b < a for a, b in pairs)
        words = f"mean number of amplitudes {means[0]:.1f} to {means[1]:.1f}; {'more' if grows else 'fewer'} in "
        k = up if grows else down
        return Finding(words + share(k, up + down) + " of the realisations that change", beyond_half(k, up + down))
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
    """In at least one condition, two runs differ with a probability whose exact interval is above 0."""
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
            return Finding("no chaos" if measured else "not run", None)
        if question == "shape":
            words = "; ".join(f"{row['amplitude']:g}: {row['shift_small']:.2f} between, "
                              f"{row['shift_within']:.2f} within"
                              for row in rows)
            near = [row["shift_small"] <= row["shift_within"] for row in rows]
            far = [row["shift_small_least"] > row["shift_within"] for row in rows]
            return Finding(words, together([True if a else False if b else None for a, b in zip(near, far)]))
        rows = [row for row in rows if row["stays_chaotic"]]
        if not rows:
            return Finding("sigma 0.03 ends the chaos", None)
        words = "; ".join(f"{row['amplitude']:g}: {row['growth']:.2f} [{row['growth_range'][0]:.2f}, "
                          f"{row['growth_range'][1]:.2f}]" for row in rows)
        results = [True if row["growth_range"][0] > 1.0 else False if row["growth_range"][1] < 1.0 else None
                   for row in rows]
        return Finding(words, together(results))
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
          "both occur, and no other response; rest, unresolved and overturned are ignored, here and below",
          _fixed(None, only, ("(1,1)", "(1,3)"))),
    Claim("With 0.40/0.35 and rising A_h: (1,1), (1,3), (1,1), chaos.",
          "the regions of these three are in this order; from rest a region has two neighbouring amplitudes or more; from "
          "any start the region is that of the most frequent response", order_of_regions),
    Claim("With 0.35/0.30 there are only (1,1) and chaos.", "both occur, and no other response",
          _fixed(LESS, only, ("(1,1)", "chaotic"))),
    Claim("(1,3) occurs with 0.40/0.35 and not with 0.35/0.30.",
          "with 0.40/0.35 at one amplitude or more, with 0.35/0.30 at none",
          subharmonic_by_friction),
    Claim("With 0.40/0.35 the response is chaotic at A_h = 6.6, 8.0 and 9.0.",
          "at all three; from any start for more than half of the realisations that are classified, by the exact interval; "
          "an unresolved response leaves the claim open",
          chaos_at_attractors(MORE)),
    Claim("With 0.35/0.30 the response is chaotic at A_h = 6.6, 8.0 and 9.0.", "as for claim 5", chaos_at_attractors(LESS)),
    Claim("With sliding the block overturns at some amplitude up to 10: gaps in the bifurcation diagrams.",
          "it does, with at least one pair of coefficients", overturns),
    Claim("sigma = 0.003 does not change the shape of the chaotic attractor (0.40/0.35).",
          "where fixed friction gives chaos, the median distance between segments of the two attractors (section 3) is not "
          "larger than the largest distance within the attractor without fluctuation; the claim fails if the smallest "
          "distance between the two is larger. The cells give A_h, the median distance between the attractors, and the "
          "largest distance within the attractor without fluctuation",
          attractor(MORE, "shape")),
    Claim("sigma = 0.003 does not change the shape of the chaotic attractor (0.35/0.30).", "as for claim 8",
          attractor(LESS, "shape")),
    Claim("sigma = 0.03 makes the chaotic attractor larger (0.40/0.35).",
          "where the response remains chaotic, the ratio of the areas is above 1 for every pair of segments; the claim "
          "fails if it is below 1 for every pair", attractor(MORE, "size")),
    Claim("sigma = 0.03 makes the chaotic attractor larger (0.35/0.30).", "as for claim 10", attractor(LESS, "size")),
    Claim("The region of (1,3) grows with sigma (0.35/0.30).",
          "of the realisations with different numbers of amplitudes of (1,3) at sigma 0.03 and 0.003, more than half have "
          "more at 0.03, by the exact interval (a sign test)", change_of_region(LESS, "(1,3)", True)),
    Claim("The region of (1,3) grows with sigma (0.40/0.35).", "as for claim 12", change_of_region(MORE, "(1,3)", True)),
    Claim("The region of chaos shrinks with sigma (0.35/0.30).",
          "as for claim 12, with chaos instead of (1,3) and fewer instead of more",
          change_of_region(LESS, "chaotic", False)),
    Claim("The region of chaos shrinks with sigma (0.40/0.35).", "as for claim 14", change_of_region(MORE, "chaotic", False)),
    Claim("With 0.35/0.30 and sigma 0.03 both (1,1) and (1,3) occur between A_h = 3.2 and 4.6.",
          "each in one realisation or more", both_between),
    Claim("No two bifurcation diagrams under equal conditions are alike (0.35/0.30, sigma 0.03).",
          "every disjoint pair of realisations differs in response at one amplitude or more; from any start the two "
          "realisations of a pair also have different initial states", no_two_alike),
    Claim("Equal conditions do not give equal responses (0.35/0.30, sigma 0.03).",
          "at one amplitude or more, the exact interval of the probability that two runs differ is above 0",
          does_not_recur),
)
