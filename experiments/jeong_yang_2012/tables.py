"""The tables of the published pages, from the published results."""

import itertools

from attractors import SIGMAS as OF_ATTRACTORS
from cells import ATTRACTORS, FRICTIONS, READINGS, SIGMAS, STARTS, cell_name
from claims import CLAIMS, FAILS, HOLDS, NO_REGIME, UNDECIDABLE, is_mode, occurrence, pairs_that_differ, transposed
from intervals import Share, above

OPTIONS = ("inertia `edge`", "restitution `jy25`", "slip rule `signed`")
PLAIN = READINGS["consistent"]
PAGE = ("consistent", "as-printed", "as-plotted")  # readings of the short form
VERDICTS = (HOLDS, FAILS, NO_REGIME, UNDECIDABLE)


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + " --- |" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows])


def all_findings(data):
    return [(claim, claim.findings(data)) for claim in CLAIMS]


def flips():
    """(option, reading without it, reading with it), for every reading without it."""
    for option, (without, options) in itertools.product(range(3), READINGS.items()):
        if options[option] == PLAIN[option]:
            flipped = tuple(READINGS["as-printed"][i] if i == option else options[i] for i in range(3))
            yield option, without, next(name for name, other in READINGS.items() if other == flipped)


def by_start(findings, reading):
    """The verdicts of one reading: one word, or with the starts in brackets; a dagger where it is another over all claims."""
    found = {}
    for start in STARTS:
        finding = findings[reading, start]
        found.setdefault(finding.verdict, []).append(start + ("" if finding.over_all == finding.verdict else "†"))
    if len(found) == 1 and "†" not in "".join(*found.values()):
        return next(iter(found))
    return "; ".join(f"{verdict} ({' and '.join(starts)})" for verdict, starts in
                     sorted(found.items(), key=lambda item: VERDICTS.index(item[0])))


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
    used = of_fixed_friction(findings)
    rows = [(i, claim.words, *(by_start(found, reading) + (" ‡" if reading == "as-plotted" and i in used else "")
                               for reading in PAGE), deciding(found)) for i, (claim, found) in enumerate(findings, 1)]
    return table(("", "claim", "right mechanics (`consistent`)", "equations as printed (`as-printed`)",
                  "nearest to the figures (`as-plotted`)", "what decides"), rows)


def level_changes(findings):
    """Verdicts that are others with the level over all claims: (claim, reading, start, verdict, over all claims)."""
    return [(i, *cell, finding.verdict, finding.over_all) for i, (_, found) in enumerate(findings, 1)
            for cell, finding in found.items() if finding.over_all != finding.verdict]


def level_words(findings):
    changed = level_changes(findings)
    kinds = sorted({row[3:] for row in changed})
    told = "; ".join(f"{before} to {after}: {sum(row[3:] == (before, after) for row in changed)}" for before, after in kinds)
    return (f"With intervals that hold together over all {len(findings)} claims, {len(changed)} of the "
            f"{len(findings) * len(READINGS) * len(STARTS)} verdicts change" + (f" ({told})" if told else ""))


def claim_sections(findings):
    parts = []
    for i, (claim, found) in enumerate(findings, 1):
        rows = {}  # readings with equal cells share a row
        for reading in READINGS:
            cells = tuple(f"**{cell.verdict}**" + (f" (over all claims {cell.over_all})" if cell.over_all != cell.verdict else "")
                          + (f": {cell.measured}" if cell.measured else "")
                          + (f" ({cell.reason})" if cell.reason and cell.verdict in (UNDECIDABLE, NO_REGIME) else "")
                          for cell in (found[reading, start] for start in STARTS))
            rows.setdefault(cells, []).append(reading)
        words = f"**{i}. {claim.words}** Criterion: {claim.criterion}."
        parts.append(f"{words}\n\n{table(('reading', *STARTS), [('; '.join(names), *cells) for cells, names in rows.items()])}")
    return "\n\n".join(parts)


def tallies(findings):
    """For each cell: how many claims hold, fail, have no regime, are undecidable."""
    return {cell: tuple([found[cell].verdict for _, found in findings].count(verdict) for verdict in VERDICTS)
            for cell in itertools.product(READINGS, STARTS)}


def tally_table(findings):
    counts = tallies(findings)
    return table(("reading", *STARTS),
                 [(reading, *(" / ".join(map(str, counts[reading, start])) for start in STARTS)) for reading in READINGS])


def of_fixed_friction(findings):
    """Numbers of the claims about responses with fixed friction, which may have been used to choose `as-plotted`."""
    return [i for i, (claim, _) in enumerate(findings, 1) if set(claim.figures.split(", ")) <= set("3456")]


def independent_table(findings):
    """Of the claims that were not used to choose a reading: how many hold, fail, have no regime, are undecidable; and which."""
    used, rows = of_fixed_friction(findings), []
    for reading, start in itertools.product(PAGE, STARTS):
        by = {verdict: [str(i) for i, (_, found) in enumerate(findings, 1)
                        if i not in used and found[reading, start].verdict == verdict] for verdict in VERDICTS}
        rows.append((reading, start, *(f"{len(numbers)} ({', '.join(numbers)})" if numbers else "0" for numbers in by.values())))
    return table(("reading", "start", *VERDICTS), rows)


def independent_words(findings):
    used = of_fixed_friction(findings)
    rest = [found for i, (_, found) in enumerate(findings, 1) if i not in used]
    def count(reading, verdict):
        held = [sum(found[reading, start].verdict == verdict for found in rest) for start in STARTS]
        return f"{min(held)} to {max(held)}" if min(held) < max(held) else str(held[0])
    told = "; ".join(f"`{reading}`: {count(reading, HOLDS)} hold, {count(reading, FAILS)} fail" for reading in PAGE)
    against = [str(i) for i, (_, found) in enumerate(findings, 1)
               if all(found["as-plotted", start].verdict == FAILS for start in STARTS)]
    return (f"`as-plotted` was chosen because its results are nearest to the paper's figures. Claims {used[0]} to {used[-1]}, "
            f"about figures with fixed friction, are therefore not counted as confirmed under it. Of the other "
            f"{len(rest)}, by start: {told}. Failures count in any case: claims {', '.join(against)} fail under "
            "`as-plotted` from every start, although it was chosen to fit")


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


def quasi_periodic_words(data):
    """Where fixed friction gives a quasi-periodic response, by reading, friction and amplitude."""
    parts = []
    for reading, pair in itertools.product(READINGS, FRICTIONS):
        found = {}
        for start in STARTS:
            for amplitude, modes in data.series(reading, start, pair).items():
                if "quasi-periodic" in modes:
                    count = f"{modes.count('quasi-periodic')} of {len(modes)} " if start == "any" else ""
                    found.setdefault(amplitude, []).append(f"{count}from {start}" + (" start" if start == "any" else ""))
        parts += [f"`{reading}`, {pair}, A_h = {amplitude:g} ({'; '.join(told)})" for amplitude, told in sorted(found.items())]
    return f"Quasi-periodic, and not chaotic, with fixed friction: {'; '.join(parts) or 'nowhere'}"


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
    for reading, start in itertools.product(PAGE, STARTS):
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


def ranges(series, least=2):
    """Along the amplitude, the response where two neighbouring amplitudes or more show one, with its range."""
    runs = [(mode, [a for a, _ in each]) for mode, each in itertools.groupby(
        ((a, modes[0]) for a, modes in series.items()), key=lambda each: each[1])]
    return ", ".join(f"{mode} {found[0]:g} to {found[-1]:g}" for mode, found in runs if len(found) >= least and mode != "rest")


def counted(series):
    modes = [found[0] for found in series.values()]
    return ", ".join(f"{mode} {modes.count(mode)}" for mode in sorted(sorted(set(modes)), key=modes.count, reverse=True)) + f", of {len(modes)}"


def figures_table(data):
    """What the paper states of its figures, as far as known, and the same of ours, from rest with Phi = pi/2."""
    start, (more, less) = "rest, pi/2", FRICTIONS

    def at_attractors(reading):
        return "; ".join(f"{pair}: " + ", ".join(data.series(reading, start, pair)[a][0] for a in ATTRACTORS) for pair in FRICTIONS)

    def regions(reading):
        parts = []
        for pair, mode in itertools.product(FRICTIONS, ("(1,3)", "chaotic")):
            shares = " to ".join(f"{100 * data.region(reading, start, pair, s).count(mode) / len(data.region(reading, start, pair, s)):.1f}"
                                 for s in SIGMAS)
            parts.append(f"{mode}, {pair}: {shares} %")
        return "; ".join(parts)

    def measures(reading):
        found = [f"{row['friction']}, {row['amplitude']:g}: distance {row['shift']['value']:.2f}, area times {row['growth']['value']:.2f}"
                 for row in data.measures["attractors"] if (row["reading"], row["start"]) == (reading, start)
                 and "shift" in row and "growth" in row]
        return "; ".join(found) or "no chaos to compare"

    def recurrence(reading):
        differ, places = pairs_that_differ(data, reading, start)
        return f"{differ.percent()} % of {differ.n} pairs differ, at {places:.1f} of {len(data.diagrams(reading, start))} amplitudes on the average"

    def between(reading):
        series = {a: modes for a, modes in data.diagrams(reading, start).items() if 3.2 <= a <= 4.6}
        third = [a for a, modes in series.items() if "(1,3)" in modes]
        where = f", at A_h {third[0]:g} to {third[-1]:g}" if third else ""
        return f"(1,3) in {occurrence(series, is_mode('(1,3)'))[1]}{where}"

    rows = [("3", "steps of 0.05; only (1,1) and (1,3)", lambda r: counted(data.series(r, start, None)),
             "friction or none, phase, restitution, the amplitudes where responses change"),
            ("4", f"{more}: (1,1), (1,3), (1,1), chaos; overturning, up to A_h = 10", lambda r: ranges(data.series(r, start, more)),
             "initial state and phase, the limits of the regions and gaps, the periods simulated"),
            ("5", f"{less}: (1,1) and chaos, no (1,3)", lambda r: ranges(data.series(r, start, less)), "as for 4"),
            ("6", "chaos at A_h = 6.6, 8.0, 9.0", at_attractors, "strobe points or an exponent; how chaos was recognised"),
            ("7", "sigma 0.003, 0.016, 0.03: the region of (1,3) grows, that of chaos shrinks", regions,
             "sizes of the regions, the number of runs"),
            ("8", "sigma 0.003 keeps the shape of the attractor, 0.03 makes it larger", measures,
             "a measure of shape or size, the number of points"),
            ("9", "bifurcation diagrams, repeated: no two are alike", recurrence,
             "the coefficients, the number of diagrams and of amplitudes, what counts as alike"),
            ("10", f"{less}, sigma 0.03, A_h from 3.2 to 4.6 (caption: 9.0): both (1,1) and (1,3)", between,
             "which amplitude, how many runs, how many of them showed each")]
    return table(("figure", "the paper, as far as known", *PAGE, "not stated; needed to compare more"),
                 [(number, paper, *map(ours, PAGE), lacks) for number, paper, ours, lacks in rows])
