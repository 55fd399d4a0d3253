"""The tables of the published README, from the published results."""

import itertools
import statistics

from claims import ATTRACTORS, CLAIMS, transposed
from intervals import beyond_half, share
from measures import interval_of_mean
from published import FRICTIONS, READINGS, SIGMAS, STARTS

OPTIONS = ("slide_inertia `edge`", "restitution `jy25`", "impact_slip_rule `signed`")
PLAIN = READINGS["consistent"]
MARKS = {True: "holds", False: "fails", None: "open"}


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + " --- |" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows])


def flips():
    """(option, reading without it, reading with it), for every reading without it."""
    for option, (without, options) in itertools.product(range(3), READINGS.items()):
        if options[option] == PLAIN[option]:
            flipped = tuple(READINGS["as-printed"][i] if i == option else options[i] for i in range(3))
            yield option, without, next(name for name, other in READINGS.items() if other == flipped)


def result(findings):
    """In words: holds, fails, or on what it depends."""
    judged = {cell: finding.holds for cell, finding in findings.items() if finding.holds is not None}
    open_cells = len(findings) - len(judged)
    rest = f" ({open_cells} of {len(findings)} cells open)" if open_cells else ""
    if not judged:
        return "open"
    if len(set(judged.values())) == 1:
        mark = MARKS[next(iter(judged.values()))]
        return f"{mark} in {len(judged)} of {len(findings)} cells, open in the others" if open_cells else mark

    def differ(fixed, names):
        return any(len({judged[cell] for cell in judged if cell[fixed] == name}) > 1 for name in names)
    causes = [word for word, found in (("reading", differ(1, STARTS)), ("start", differ(0, READINGS))) if found]
    if not causes:  # no two cells judged differ in one of them alone
        return "depends on the reading or the start" + rest
    return "depends on the " + " and the ".join(causes) + rest


def deciding(findings):
    """For each option: the number of pairs of cells that differ in it alone and have different results."""
    words = []
    for option in range(3):
        pairs = [(findings[a, start].holds, findings[b, start].holds)
                 for number, a, b in flips() if number == option for start in STARTS]
        told = [pair for pair in pairs if None not in pair]
        changed = sum(a != b for a, b in told)
        if changed:
            words.append(f"{OPTIONS[option]} {changed} of {len(told)}")
    return "; ".join(words) or "none"


def where(findings):
    """The readings under which it holds, each with its starts unless it holds from all."""
    words = []
    for reading in READINGS:
        starts = [start for start in STARTS if findings[reading, start].holds]
        judged = [start for start in STARTS if findings[reading, start].holds is not None]
        if starts:
            words.append(reading if starts == judged else f"{reading} ({'; '.join(starts)})")
    return " · ".join(words) or "nowhere"


def claims_table(all_findings):
    rows = [(i, claim.words, result(findings), where(findings), deciding(findings))
            for i, (claim, findings) in enumerate(all_findings, 1)]
    return table(("", "claim", "result", "holds under (start)", "changes with the option"), rows)


def claim_sections(all_findings):
    parts = []
    for i, (claim, findings) in enumerate(all_findings, 1):
        rows = []
        for reading in READINGS:
            cells = [findings[reading, start] for start in STARTS]
            rows.append([reading, *(f"**{MARKS[cell.holds]}**: {cell.measured}" for cell in cells)])
        parts.append(f"**{i}. {claim.words}** Criterion: {claim.criterion}.\n\n" + table(("reading", *STARTS), rows))
    return "\n\n".join(parts)


def tallies(all_findings):
    """For each reading and start: how many claims hold, fail, are open."""
    found = {}
    for cell in itertools.product(READINGS, STARTS):
        marks = [findings[cell].holds for _, findings in all_findings]
        found[cell] = tuple(marks.count(mark) for mark in (True, False, None))
    return found


def tally_table(all_findings):
    counts = tallies(all_findings)
    rows = [(reading, *("{} / {} / {}".format(*counts[reading, start]) for start in STARTS)) for reading in READINGS]
    return table(("reading", *STARTS), rows)


def nearest(all_findings):
    """Text on the readings under which most claims hold, and which claims fail there."""
    counts = tallies(all_findings)
    best = max(held for held, _, _ in counts.values())
    lines = []
    for (reading, start), (held, failed, unknown) in counts.items():
        if held == best:
            fails = [str(i) for i, (_, findings) in enumerate(all_findings, 1) if findings[reading, start].holds is False]
            unsure = [str(i) for i, (_, findings) in enumerate(all_findings, 1) if findings[reading, start].holds is None]
            line = f"`{reading}`, start {start}: {held} of {len(all_findings)}"
            line += f"; failing claims: {', '.join(fails)}" if fails else "; none fails"
            lines.append(line + (f"; open: {', '.join(unsure)}" if unsure else ""))
    complete = [f"`{reading}`, start {start}" for (reading, start), (_, failed, _) in counts.items() if not failed]
    first = ("No claim fails under: " + ", ".join(complete) if complete
             else "At least one claim fails under every reading and start. The largest number of claims holds under")
    return first + ": " + ". ".join(lines) + "."


def under(all_findings, reading):
    """Which claims hold and fail under a reading, start by start."""
    parts = []
    for start in STARTS:
        lists = [[str(i) for i, (_, findings) in enumerate(all_findings, 1) if findings[reading, start].holds is holds]
                 for holds in (True, False)]
        held, failed = (", ".join(numbers) or "none" for numbers in lists)
        parts.append(f"start {start}: claims that hold: {held}; claims that fail: {failed}")
    return f"Under `{reading}`, " + ". ".join(parts).replace(". start", ". Start") + ". The others are open."


def energy_of(data, reading, what):
    return [row[what] for row in data.measures["energy"] if row["reading"] == reading]


def balances(data, reading):
    """To rounding and tolerance, over all trajectories."""
    return max(map(abs, energy_of(data, reading, "unaccounted") + energy_of(data, reading, "gained_in_impacts"))) < 1e-9


def energy_table(data):
    rows = []
    for reading in READINGS:
        shares, gains = (energy_of(data, reading, what) for what in ("unaccounted", "gained_in_impacts"))
        balanced = balances(data, reading)
        rows.append((reading, "yes" if balanced else "no",
                     "below 1e-9" if balanced else f"{100 * min(shares):+.1f} to {100 * max(shares):+.1f} %",
                     f"{100 * max(gains):.2g} %" if max(gains) > 1e-9 else "none"))
    return table(("reading", "balances", "gained (+) or lost (-) by the equations, minimum to maximum",
                  "gained in impacts, at most"), rows)


def chaos_somewhere(series):
    rows = transposed(series)
    return share(sum("chaotic" in row for row in rows), len(rows))


def chaos_table(data):
    """The amount of chaos, by reading: the share of amplitudes from rest; the share of runs from any start."""
    rows = []
    for reading in READINGS:
        cells = []
        for pair in FRICTIONS:
            from_rest = [data.series(reading, start, pair) for start in STARTS[:2]]
            found = [modes[0] for series in from_rest for modes in series.values()]
            cells.append(f"{found.count('chaotic')} of {len(found)}")
        for pair in FRICTIONS:
            cells.append(chaos_somewhere(data.series(reading, "any", pair)))
        for pair in FRICTIONS:
            cells.append(chaos_somewhere(data.series(reading, "any", pair, 0.03)))
        rows.append((reading, *cells))
    head = ["reading"] + [f"{kind}, {pair}" for kind in ("rest", "any start", "any start, sigma 0.03") for pair in FRICTIONS]
    return table(head, rows)


def chaos_at_three(data):
    """Chaos at the paper's three amplitudes, from any start."""
    rows = []
    for reading, pair in itertools.product(("consistent", "as-plotted", "as-printed"), FRICTIONS):
        series = data.series(reading, "any", pair)
        rows.append((reading, pair, *(share(series[a].count("chaotic"), len(series[a])) for a in ATTRACTORS)))
    return table(("reading", "friction", *(f"A_h = {a:g}" for a in ATTRACTORS)), rows)


def attractor_chaos(data, inertia):
    """For each start: the number of the paper's amplitudes with chaos, summed over the readings with this inertia."""
    counts = 0
    for reading, pair in itertools.product(READINGS, FRICTIONS):
        if READINGS[reading][0] == inertia:
            series = {a: modes for a, modes in data.series(reading, "any", pair).items() if a in ATTRACTORS}
            row = [run.count("chaotic") for run in transposed(series)]
            counts = [a + b for a, b in zip(counts, row)] if counts else row
    return counts


def chaos_windows(data, reading):
    """Where a reading has chaos from any start: friction pair, amplitude, share."""
    rows = []
    for pair in FRICTIONS:
        for amplitude, modes in data.series(reading, "any", pair).items():
            if "chaotic" in modes:
                rows.append((pair, f"{amplitude:g}", share(modes.count("chaotic"), len(modes))))
    return table(("friction", "A_h", "chaotic"), rows) if rows else "None."


def chaos_by_option(data):
    """Sign tests over starts: does an option alone cause chaos at more amplitudes?"""
    rows = []
    for option, without, with_it in flips():
        for pair in FRICTIONS:
            counts = [[row.count("chaotic") for row in transposed(data.series(reading, "any", pair))]
                      for reading in (without, with_it)]
            more = sum(b > a for a, b in zip(*counts))
            less = sum(b < a for a, b in zip(*counts))
            answer = {True: "more", False: "less", None: "open"}[beyond_half(more, more + less)]
            means = " to ".join(f"{statistics.fmean(column):.1f}" for column in counts)
            rows.append((OPTIONS[option], without, pair, means, share(more, more + less), answer))
    return table(("option added", "to", "friction", "chaotic amplitudes per start, mean",
                  "starts with more, of those that change", "chaos"), rows)


def initial_differ(data, reading, pair):
    """Amplitude to the probability that two random starts end in different responses, with its interval."""
    return {place[4]: found for place, found in data.non_recurrence("any_start_fixed_friction")
            if place[0] == reading and place[2] == pair}


def per_cent(found):
    low, high = found["differ_interval"]
    return f"{100 * found['differ']:.0f} [{100 * low:.0f}, {100 * high:.0f}]"


def recurrences(data, reading, pair, sigma):
    return [(place[4], entry) for place, entry in data.non_recurrence("non_recurrence")
            if (place[0], place[2], place[3]) == (reading, pair, sigma)]


def mean_difference(series):
    """The share of amplitudes at which two runs differ in response, per cent, mean over the disjoint pairs, which are the
    independent trials. The interval is a bootstrap over the pairs; where no pair differs at any amplitude, it is the exact
    interval of the share of pairs that differ."""
    rows = transposed(series)
    shares = [statistics.fmean(a != b for a, b in zip(*pair)) for pair in zip(rows[::2], rows[1::2])]
    low, high = interval_of_mean(shares)
    return f"{100 * statistics.fmean(shares):.1f} [{100 * low:.1f}, {100 * high:.1f}]"


def recurrence_means(data, reading, pair, sigma):
    """Means over the amplitudes by friction and by the initial state; modes changed in the reruns at another tolerance."""
    found = recurrences(data, reading, pair, sigma)
    amplitudes = {amplitude for amplitude, _ in found}
    shaken = {place[4]: modes for place, modes in data.modes("non_recurrence").items()
              if (place[0], place[2], place[3]) == (reading, pair, sigma)}
    started = {amplitude: modes for amplitude, modes in data.series(reading, "any", pair).items() if amplitude in amplitudes}
    flipped = sum(entry["arithmetic_flips"]["count"] for _, entry in found)
    repeats = sum(entry["arithmetic_flips"]["of"] for _, entry in found)
    return mean_difference(shaken), mean_difference(started), f"{flipped} of {repeats}"


def recurrence_summary(data):
    rows = []
    for reading, pair, sigma in itertools.product(("consistent", "as-plotted"), FRICTIONS, SIGMAS):
        friction, start, flipped = recurrence_means(data, reading, pair, sigma)
        amplitude, worst = max(recurrences(data, reading, pair, sigma), key=lambda row: row[1]["differ"])
        rows.append((reading, pair, sigma, friction, f"{amplitude:g}: {per_cent(worst)}", flipped, start))
    return table(("reading", "friction", "sigma", "friction: mean over A_h, %", "largest, at A_h: % [interval]",
                  "tolerance: modes changed", "initial state: mean over A_h, %"), rows)


def recurrence_by_amplitude(data, reading):
    found = {(place[2], place[3], place[4]): entry for place, entry in data.non_recurrence("non_recurrence")
             if place[0] == reading}
    starts = {pair: initial_differ(data, reading, pair) for pair in FRICTIONS}
    amplitudes = sorted({key[2] for key in found})
    rows = [[f"{a:g}", *(per_cent(found[pair, sigma, a]) for pair in FRICTIONS for sigma in SIGMAS),
             *(per_cent(starts[pair][a]) for pair in FRICTIONS)] for a in amplitudes]
    head = ["A_h", *(f"{pair}, {sigma}" for pair in FRICTIONS for sigma in SIGMAS),
            *(f"start, {pair}" for pair in FRICTIONS)]
    return table(head, rows)


def tiny(number):
    return f"{number:.2g}" if number > 1e-9 else "below 1e-9"


def diagram_table(data):
    rows = []
    for row in data.measures["diagrams"]:
        low, high = row["differ_interval"]
        rows.append((row["reading"], row["pairs"], row["amplitudes"],
                     f"{100 * row['differ']:.0f} [{100 * low:.0f}, {100 * high:.0f}]",
                     f"{100 * row['least']:.0f} to {100 * row['most']:.0f}", tiny(row["median_distance"]),
                     tiny(row["largest_distance"])))
    return table(("reading", "pairs", "amplitudes", "visibly different amplitudes, % [bootstrap]", "minimum to maximum, %",
                  "median distance in Theta", "largest distance"), rows)


def diagrams_by_mode(data):
    rows = []
    for reading in ("consistent", "as-plotted"):
        series = {place[4]: modes for place, modes in data.modes("figure_09").items() if place[0] == reading}
        runs = transposed(series)
        pairs = list(zip(runs[::2], runs[1::2]))
        counts = [sum(a != b for a, b in zip(*pair)) for pair in pairs]
        rows.append((reading, share(sum(count > 0 for count in counts), len(pairs)), f"{min(counts)} to {max(counts)}",
                     len(series)))
    return table(("reading", "pairs of diagrams that differ in a response", "amplitudes at which they differ",
                  "of"), rows)


def between_table(data):
    """Figure 10: responses between 3.2 and 4.6, over all realisations."""
    rows = []
    for reading, start in itertools.product(("consistent", "as-plotted"), STARTS[:2]):
        series = {place[4]: modes for place, modes in data.modes("figure_10").items() if place[:2] == (reading, start)}
        runs = transposed(series)
        both = sum("(1,1)" in run and "(1,3)" in run for run in runs)
        third = [f"{a:g}" for a, modes in series.items() if "(1,3)" in modes]
        rows.append((reading, start, share(sum("(1,3)" in run for run in runs), len(runs)), share(both, len(runs)),
                     ", ".join(third) or "none"))
    return table(("reading", "start", "realisations with (1,3) at one A_h or more", "with (1,1) and (1,3)",
                  "A_h with (1,3)"), rows)


def all_findings(data):
    return [(claim, claim.findings(data)) for claim in CLAIMS]
