"""How long chaos lasts with fixed friction: when the block overturns, the rate at which chaotic motions do, and what follows
for claim 7. The runs are survival_*.json: the settling period of a block that overturns is the period in which it does."""

import math
import sqlite3

from cells import FRICTIONS, READINGS
from intervals import clopper_pearson
from published import place_of, read
from tables import table

LIMIT = 20000  # periods of each motion
INITIAL = 120  # periods after which the chaotic set is taken to be reached
LOOKED = (120, 620, 1560, 5000, LIMIT)
EDGE = ("as-plotted", "as-printed")  # readings in which chaos from rest ends by overturning
ENSEMBLES = ("survival_near_rest", "survival_any_start")


def rows(runs):
    """Of each condition of the runs: place, response modes in the end, and the period of overturning of each realisation."""
    for name in ("survival_rest", *ENSEMBLES):
        conditions = read(runs / name / "report.json")["result"]["conditions"]
        found = [{"run": name, "place": place_of(each["parameters"], True), "modes": {}, "overturned": []} for each in conditions]
        with sqlite3.connect(f"file:{runs / name / 'realisations.sqlite'}?mode=ro", uri=True) as connection:
            for condition, mode, period in connection.execute("SELECT condition, mode, settling_period FROM realisations "
                                                              "ORDER BY condition, realisation"):
                row = found[condition]
                row["modes"][mode] = row["modes"].get(mode, 0) + 1
                row["overturned"].append(period if mode == "overturned" else None)
        yield from found


def periods_of(row):
    """Infinite where the block did not overturn."""
    return [math.inf if period is None else period for period in row["overturned"]]


class Escape:
    """Chaotic motions of one reading, friction and amplitude, from all starts: how many overturn after INITIAL periods.

    Motions that are not chaotic in the end, and did not overturn, are left out: they are in another basin."""

    def __init__(self, found):
        periods = [period for row in found for period in periods_of(row)]
        self.periods = sorted(period - INITIAL for period in periods if INITIAL < period < math.inf)
        self.early = sum(period <= INITIAL for period in periods)
        self.lasting = sum(row["modes"].get("chaotic", 0) for row in found)
        self.exposure = sum(self.periods) + self.lasting * (LIMIT - INITIAL)  # motions times periods

    @property
    def at_risk(self):
        return len(self.periods) + self.lasting

    def rate(self, level):
        """Per period, with the exact interval: each period at risk is a trial."""
        return len(self.periods) / self.exposure, *clopper_pearson(len(self.periods), self.exposure, level)

    def survival(self):
        """Steps (period, share of those at risk that have not overturned)."""
        return [(period + INITIAL, 1.0 - (i + 1) / self.at_risk) for i, period in enumerate(self.periods)]

    def departure(self):
        """The probability of so large a departure from a constant rate (Kolmogorov & Smirnov, Stephens' approximation): the
        total time at risk at each overturning, as a share of all, is then uniform."""
        n, spent, at, shares = len(self.periods), 0.0, 0, []
        for i, period in enumerate(self.periods):
            spent += (self.at_risk - i) * (period - at)
            at = period
            shares.append(spent / self.exposure)
        if not self.lasting:
            n, shares = n - 1, shares[:-1]  # the last one ends the time at risk
        if n < 5:
            return None
        distance = max(max((i + 1) / n - u, u - i / n) for i, u in enumerate(shares))
        scaled = (math.sqrt(n) + 0.12 + 0.11 / math.sqrt(n)) * distance
        return min(1.0, 2.0 * sum((-1) ** (k - 1) * math.exp(-2.0 * (k * scaled) ** 2) for k in range(1, 101)))


def escapes(data):
    """By (reading, friction): amplitude to Escape."""
    found = {}
    for row in data.measures["survival"]:
        reading, _, pair, _, amplitude = row["place"]
        if row["run"] in ENSEMBLES:
            found.setdefault((reading, pair), {}).setdefault(amplitude, []).append(row)
    return {key: {a: Escape(each) for a, each in by.items()} for key, by in found.items()}


def level(data):
    """All intervals of the table hold together with 95 %."""
    return 1.0 - 0.05 / sum(map(len, escapes(data).values()))


def told(escape, level):
    if not escape.at_risk:
        return "no chaos"
    value, low, high = (1e6 * each for each in escape.rate(level))
    if not escape.periods:
        return f"none of {escape.at_risk}: below {high:.2g}"
    return f"{value:.3g} [{low:.3g}, {high:.3g}], {len(escape.periods)} of {escape.at_risk}"


def rates_table(data):
    found, sure = escapes(data), level(data)
    amplitudes = sorted({a for by in found.values() for a in by})
    return table(("A_h", *(f"{reading}, {pair}" for reading, pair in found)),
                 [(f"{a:g}", *(told(by[a], sure) for by in found.values())) for a in amplitudes])


def exponential_words(data):
    tested = {(key, a): p for key, by in escapes(data).items() for a, escape in by.items()
              for p in [escape.departure()] if p is not None}
    (reading, pair), a = worst = min(tested, key=tested.get)
    adjusted = min(1.0, tested[worst] * len(tested))
    words = "No departure from a constant rate shows" if adjusted > 0.05 else "The rate is not constant everywhere"
    return (f"{words} in the {len(tested)} cells with six overturned motions or more: the smallest probability of the test of "
            f"Kolmogorov and Smirnov is {tested[worst]:.2g} ({reading}, {pair}, A_h = {a:g}), {adjusted:.2g} with Bonferroni's "
            "correction")


def overturned_from_rest(data):
    """By (reading, start, friction): amplitude to the period of overturning."""
    found = {}
    for row in data.measures["survival"]:
        reading, start, pair, _, amplitude = row["place"]
        if row["run"] == "survival_rest":
            found.setdefault((reading, start, pair), {})[amplitude], = periods_of(row)
    return found


def usual(data, cell, limit):
    """Of runs from rest whose Omega_h differs by less than 1e-6: at how many amplitudes the block overturns; the middle 90 %."""
    rows = [periods_of(row) for row in data.measures["survival"]
            if row["run"] == "survival_near_rest" and tuple(row["place"][:3]) == cell]
    counts = sorted(sum(period <= limit for period in run) for run in zip(*rows, strict=True))
    return f"{counts[len(counts) // 20]} to {counts[-1 - len(counts) // 20]}"


def looked_table(data):
    """From rest: at how many amplitudes the block has overturned, by the length of the observation."""
    found, lines = overturned_from_rest(data), []
    for cell, periods in found.items():
        if min(periods.values()) < math.inf:
            lines.append((*cell, *(f"{sum(period <= limit for period in periods.values())} ({usual(data, cell, limit)})"
                                   for limit in LOOKED), f"{min(a for a, p in periods.items() if p < math.inf):g}"))
    never = [reading for reading in READINGS if not any(line[0] == reading for line in lines)]
    n = len(next(iter(found.values())))
    return (table(("reading", "start", "friction", *(f"{limit} periods" for limit in LOOKED), "lowest A_h"), lines)
            + f"\n\nOf {n} amplitudes from 1 to 10. At none within {LIMIT} periods: {', '.join(f'`{name}`' for name in never)}.")


def later_words(data):
    """From rest: where no block overturns within the shortest observation and some do later."""
    late = [f"{reading}, {start}, {pair}" for (reading, start, pair), periods in overturned_from_rest(data).items()
            if LOOKED[0] < min(periods.values()) < math.inf]
    return f"No block overturns within {LOOKED[0]} periods and some do later: {'; '.join(late) or 'in no cell'}"


def page_words(data):
    """Chaos within an observation, and chaos that lasts: the short form."""
    found, sure = escapes(data), level(data)
    lasts, ends, chaotic = [], [], 0
    for (reading, pair), by in found.items():
        for a, escape in by.items():
            if escape.at_risk:
                chaotic += 1
                (ends if escape.periods else lasts).append((reading, pair, a, escape))
    bound = max(escape.rate(sure)[2] for *_, escape in lasts)
    rates = [(escape.rate(sure)[0], reading, pair, a) for reading, pair, a, escape in ends]
    fast, slow = max(rates), min(rates)
    rest = overturned_from_rest(data)["as-plotted", "rest, pi/2", FRICTIONS[0]].values()
    counts = ", ".join(f"{sum(period <= limit for period in rest)} within {limit}" for limit in LOOKED)
    return (f"*Chaotic* means chaotic within the observation, {LOOKED[1]} periods or more. That is not chaos that lasts. Of "
            f"{chaotic} chaotic cells followed over {LIMIT} periods (`as-plotted`, `as-printed`; A_h = 6.6 to 10), chaos ends by "
            f"overturning in {len(ends)}, at rates from {slow[0]:.1g} per period ({slow[1]}, {slow[2]}, A_h = {slow[3]:g}) to "
            f"{fast[0]:.1g} ({fast[1]}, {fast[2]}, A_h = {fast[3]:g}). In the other {len(lasts)} no motion overturns after the "
            f"first {INITIAL} periods: the rate is below {bound:.1g} per period, and cannot be told from zero. **Claim 7 "
            f"depends on how long one looks:** from rest (pi/2) under `as-plotted`, {FRICTIONS[0]}, the block overturns at "
            f"{counts} periods, of {len(rest)} amplitudes.")
