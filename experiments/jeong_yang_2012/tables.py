"""The tables of the published pages, from the published results."""

import itertools

from attractors import SIGMAS as OF_ATTRACTORS
from cells import ATTRACTORS, FRICTIONS, READINGS, SIGMAS, STARTS, cell_name
from claims import CLAIMS, FAILS, HOLDS, NO_REGIME, UNDECIDABLE, occurrence, is_mode, pairs_that_differ, transposed
from intervals import Share, above

OPTIONS = ("inertia `edge`", "restitution `jy25`", "slip rule `signed`")
PLAIN = READINGS["consistent"]
VERDICTS = (HOLDS, FAILS, NO_REGIME, UNDECIDABLE)
FORMER = {"h": HOLDS, "f": FAILS, "o": "open"}


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + " --- |" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows])


def all_findings(data):
    return [(claim, claim.findings(data)) for claim in CLAIMS]


def former(claim):
    """Verdict of the first version of the report, by cell."""
    letters = claim.former.replace(" ", "")
    return {cell: FORMER[letter] for cell, letter in zip(itertools.product(READINGS, STARTS), letters, strict=True)}


def flips():
    """(option, reading without it, reading with it), for every reading without it."""
    for option, (without, options) in itertools.product(range(3), READINGS.items()):
        if options[option] == PLAIN[option]:
            flipped = tuple(READINGS["as-printed"][i] if i == option else options[i] for i in range(3))
            yield option, without, next(name for name, other in READINGS.items() if other == flipped)


def by_start(verdicts, reading):
    """The verdicts of one reading: one word, or with the starts in brackets."""
    found = {}
    for start in STARTS:
        found.setdefault(verdicts[reading, start], []).append(start)
    if len(found) == 1:
        return next(iter(found))
    return "; ".join(f"{verdict} ({' and '.join(starts)})" for verdict, starts in
                     sorted(found.items(), key=lambda item: [*VERDICTS, "open"].index(item[0])))


def verdicts_of(findings):
    return {cell: finding.verdict for cell, finding in findings.items()}


def deciding(findings):
    """What the verdict depends on: pairs of cells that differ in one option, or in the start, and have different verdicts."""
    verdicts = verdicts_of(findings)
    parts = []
    for option in range(3):
        pairs = [(verdicts[a, start], verdicts[b, start]) for number, a, b in flips() if number == option for start in STARTS]
        parts.append((sum(a != b for a, b in pairs) / len(pairs), OPTIONS[option], f"{sum(a != b for a, b in pairs)} of 12"))
    sets = [{verdicts[reading, start] for start in STARTS} for reading in READINGS]
    parts.append((sum(len(each) > 1 for each in sets) / len(sets), "start", f"{sum(len(each) > 1 for each in sets)} of 8"))
    told = [f"{name} ({count})" for share, name, count in sorted(parts, key=lambda part: -part[0]) if share > 0.0]
    return ", ".join(told) or "nothing: all cells agree"


def claims_table(findings):
    rows = [(i, claim.words, *(by_start(verdicts_of(found), reading) for reading in ("consistent", "as-printed", "as-plotted")),
             deciding(found)) for i, (claim, found) in enumerate(findings, 1)]
    return table(("", "claim", "right mechanics (`consistent`)", "equations as printed (`as-printed`)",
                  "nearest to the figures (`as-plotted`)", "what decides"), rows)


def changes_table(findings):
    """Claims with a changed verdict under one of the three readings of the page: before and after."""
    rows = []
    for i, (claim, found) in enumerate(findings, 1):
        before, after = former(claim), verdicts_of(found)
        for reading in ("consistent", "as-printed", "as-plotted"):
            if any(before[reading, start] != after[reading, start] for start in STARTS):
                rows.append((i, reading, by_start(before, reading), by_start(after, reading)))
    return table(("claim", "reading", "before", "now"), rows)


def changes_words(findings):
    pairs = [(former(claim)[cell], finding.verdict) for claim, found in findings for cell, finding in found.items()]
    counts = {pair: pairs.count(pair) for pair in sorted(set(pairs))}
    told = "; ".join(f"{before} to {after}: {counts[before, after]}" for before, after in counts if before != after)
    turned = sum(count for (before, after), count in counts.items() if {before, after} == {HOLDS, FAILS})
    return (f"Of {len(pairs)} verdicts (claims times cells) {sum(before == 'open' for before, _ in pairs)} were open; "
            f"{sum(after == UNDECIDABLE for _, after in pairs)} are undecidable now. {turned} turned from holds to fails or "
            f"back. All changes: {told}.")


def claim_sections(findings):
    parts = []
    for i, (claim, found) in enumerate(findings, 1):
        rows = []
        for reading in READINGS:
            cells = [found[reading, start] for start in STARTS]
            rows.append([reading, *(f"**{cell.verdict}**" + (f": {cell.measured}" if cell.measured else "") +
                                    (f" ({cell.reason})" if cell.reason and cell.verdict in (UNDECIDABLE, NO_REGIME) else "")
                                    for cell in cells)])
        before = former(claim)
        words = f"**{i}. {claim.words}** Criterion: {claim.criterion}."
        words += f" Changed: {claim.changed}." if claim.changed else " The criterion is that of the first version."
        was = "; ".join(f"{reading}: {by_start(before, reading)}" for reading in READINGS)
        parts.append(f"{words}\n\n{table(('reading', *STARTS), rows)}\n\nFormer verdicts: {was}.")
    return "\n\n".join(parts)


def tallies(findings):
    """For each cell: how many claims hold, fail, have no regime, are undecidable."""
    return {cell: tuple([found[cell].verdict for _, found in findings].count(verdict) for verdict in VERDICTS)
            for cell in itertools.product(READINGS, STARTS)}


def tally_table(findings):
    counts = tallies(findings)
    return table(("reading", *STARTS),
                 [(reading, *(" / ".join(map(str, counts[reading, start])) for start in STARTS)) for reading in READINGS])


def nearest(findings):
    """Under which reading and start most claims hold, and which fail there."""
    counts = tallies(findings)
    best = max(held for held, *_ in counts.values())
    lines = []
    for cell, (held, *_) in counts.items():
        if held == best:
            fails = [str(i) for i, (_, found) in enumerate(findings, 1) if found[cell].verdict == FAILS]
            lines.append(f"`{cell[0]}`, start {cell[1]}: {held} of {len(findings)}"
                         + (f" (claims that fail: {', '.join(fails)})" if fails else " (none fails)"))
    return "Most claims hold under " + "; ".join(lines) + "."


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


def chaos_table(data):
    """The amount of chaos, by reading: amplitudes from rest; starts; the share of the range at random amplitudes."""
    rows = []
    for reading in READINGS:
        cells = []
        for pair in FRICTIONS:
            found = [modes[0] for start in ("rest, 0", "rest, pi/2") for modes in data.series(reading, start, pair).values()]
            cells.append(f"{found.count('chaotic')} of {len(found)}")
        cells += [occurrence(data.series(reading, "any", pair), is_mode("chaotic"))[1] for pair in FRICTIONS]
        for pair, sigma in itertools.product(FRICTIONS, SIGMAS):
            modes = data.region(reading, "any", pair, sigma)
            cells.append(Share(modes.count("chaotic"), len(modes)))
        rows.append((reading, *cells))
    head = ["reading"] + [f"{kind}, {pair}" for kind in ("amplitudes from rest", "any start") for pair in FRICTIONS]
    head += [f"share of the range, {pair}, sigma {sigma:g}" for pair in FRICTIONS for sigma in SIGMAS]
    return table(head, rows)


def attractor_chaos(data, inertia):
    """For each start: the number of the paper's amplitudes with chaos, summed over the readings with this inertia."""
    counts = 0
    for reading, pair in itertools.product(READINGS, FRICTIONS):
        if READINGS[reading][0] == inertia:
            series = {a: modes for a, modes in data.series(reading, "any", pair).items() if a in ATTRACTORS}
            row = [run.count("chaotic") for run in transposed(series)]
            counts = [a + b for a, b in zip(counts, row, strict=True)] if counts else row
    return counts


def chaos_by_option(data):
    """Sign tests over starts: does an option alone cause chaos at more amplitudes?"""
    rows = []
    for option, without, with_it in flips():
        for pair in FRICTIONS:
            counts = [[row.count("chaotic") for row in transposed(data.series(reading, "any", pair))]
                      for reading in (without, with_it)]
            n = min(map(len, counts))
            changed = [b - a for a, b in zip(*(each[:n] for each in counts)) if a != b]
            more = Share(sum(change > 0 for change in changed), len(changed))
            answer = {True: "more", False: "less", None: "not decided"}[above(more.interval, 0.5)]
            means = " to ".join(f"{sum(each[:n]) / n:.1f}" for each in counts)
            rows.append((OPTIONS[option], without, pair, means, more, answer))
    return table(("option added", "to", "friction", "chaotic amplitudes per start, mean",
                  "starts with more, of those that change", "chaos"), rows)


def attractors_table(data):
    """How many of the realisations were chaotic where shapes and sizes are compared."""
    rows = [(row["reading"], row["start"], row["friction"], f"{row['amplitude']:g}",
             *("{} of {}".format(*row["chaotic"][f"{sigma:g}"]) for sigma in OF_ATTRACTORS))
            for row in data.measures["attractors"] if row["regime"]]
    return table(("reading", "start", "friction", "A_h", *(f"chaotic, sigma {sigma:g}" for sigma in OF_ATTRACTORS)), rows)


def recurrence_table(data):
    """How often two runs differ, by amplitude: the mean over the amplitudes, and the largest."""
    rows = []
    for reading, start in itertools.product(READINGS, STARTS):
        series = data.diagrams(reading, start)
        by_amplitude = {a: [x != y for x, y in zip(modes[::2], modes[1::2])] for a, modes in series.items()}
        worst = max(by_amplitude, key=lambda a: sum(by_amplitude[a]))
        differ, places = pairs_that_differ(data, reading, start)
        rows.append((reading, start, differ, f"{100 * places / len(series):.1f} %", f"{worst:g}",
                     Share(sum(by_amplitude[worst]), len(by_amplitude[worst]))))
    return table(("reading", "start", "pairs of diagrams that differ", "two runs differ, mean over A_h", "most often at A_h",
                  "there"), rows)


def between_table(data):
    """Figure 10: responses between 3.2 and 4.6, with 0.35/0.30 and sigma 0.03."""
    rows = []
    for reading, start in itertools.product(("consistent", "as-printed", "as-plotted"), STARTS):
        series = {a: modes for a, modes in data.diagrams(reading, start).items() if 3.2 <= a <= 4.6}
        third = [f"{a:g}" for a, modes in series.items() if "(1,3)" in modes]
        rows.append((reading, start, occurrence(series, is_mode("(1,3)"))[1], ", ".join(third) or "none"))
    return table(("reading", "start", "with (1,3) at one A_h or more", "A_h with (1,3)"), rows)


def settling_table(data):
    """How many responses were unresolved at the fixed horizon, and in the end, with fluctuating friction."""
    rows = []
    for reading in READINGS:
        row = [reading]
        for place in itertools.product(FRICTIONS, SIGMAS, (None,)):
            early, late = [], []
            for start in STARTS:
                name = cell_name("regions", reading, start)
                late += data.modes(name)[place]
                early += data.at_horizon(name)[place]
            changed = sum(a != b for a, b in zip(early, late, strict=True))
            row.append(" / ".join(f"{100 * count / len(late):.2f}"
                                  for count in (early.count("unresolved"), late.count("unresolved"), changed)))
        rows.append(row)
    return table(("reading", *(f"{pair}, {sigma:g}" for pair in FRICTIONS for sigma in SIGMAS)), rows)
