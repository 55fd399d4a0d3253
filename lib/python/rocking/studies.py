"""Studies. Made of the fields of their questions, by lib/python/write_studies.py."""

from __future__ import annotations

import os
from typing import Optional, Sequence, Tuple, Union

from . import documents
from .asking import Path, Progress, Source, answer, ends, paths, words
from .experiments import ExperimentLike
from .results import Result

__all__ = [
    "bifurcation",
    "check_normal",
    "compare",
    "cost",
    "fragility",
    "infer",
    "motion",
    "orbits",
    "rare",
]


def compare(
    first: Source, second: Source,
) -> documents.Comparison:
    """Compare two runs, pairwise with common random numbers.

    first, second: a Result, or the folder of a run. The runs have the same seed, number of conditions and records
    of a suite; they may differ in anything else. Realisations that only one run has are left out. Intervals have
    the confidence of the first run. Raises InputError if the seeds, the numbers of conditions or the records
    differ, OSError or StoreError as open_run().

    >>> import rocking
    >>> slab = {"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
    ...     "excitation": {"kind": "harmonic", "amplitude": 2.0, "frequency_ratio": 10.0,
    ...                    "phase_rad": {"uniform": [0, 6.28]}}, "restitution": 0.9,
    ...     "horizon": {"transient_periods": 20, "sampled_periods": 20}, "realisations": 10, "seed": "0x1"}
    >>> found = rocking.compare(rocking.run(slab), rocking.run({**slab, "restitution": 0.5}))
    >>> found.settings
    ['/restitution is 0.9, not 0.5']
    >>> found.conditions[0].realisations
    10
    """
    return documents.Comparison(
        answer(
            'compare',
            {},
            runs=(first, second),
        )
    )


def bifurcation(
    source: ExperimentLike,
    *,
    realisation: int = 0,
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> documents.BifurcationDiagrams:
    """Follow the responses along a swept parameter; shows which coexist.

    source: an experiment. realisation: realisation whose random numbers are used, if something is random. threads:
    one for each processor, unless given; they change the time, never the result. progress: called with what is done
    and all, once that is known. A diagram for each combination of values of the other entries of the sweep. Raises
    InputError if there is no sweep, if its first entry takes values that are not numbers, or if the excitation is
    not periodic.

    >>> import rocking
    >>> found = rocking.bifurcation({"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
    ...     "excitation": {"kind": "harmonic", "amplitude": 2.0, "frequency_ratio": 10.0}, "restitution": 0.9,
    ...     "horizon": {"transient_periods": 20, "sampled_periods": 20},
    ...     "sweep": [{"parameter": "/excitation/amplitude", "values": [2.0, 4.0]}]})
    >>> [step.value for step in found.diagrams[0].steps if step.branch == "upwards"]
    [2.0, 4.0]
    """
    return documents.BifurcationDiagrams(
        answer(
            'bifurcation',
            {'realisation': realisation},
            source=source,
            threads=threads,
            progress=progress,
        )
    )


def orbits(
    source: ExperimentLike,
    *,
    longest: int = 5,
    branches: bool = False,
    branch_range: Tuple[Optional[float], Optional[float]] = (None, None),
    most_points: int = 1000,
    most_branches: int = 50,
    second_parameter: Union[str, Sequence[str]] = (),
    second_range: Tuple[Optional[float], Optional[float]] = (None, None),
    most_curve_points: int = 400,
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> documents.Orbits:
    """Find the periodic orbits, stable and unstable, and their multipliers.

    source: an experiment. longest: longest period that is searched from the grid, in excitation periods. branches:
    do not follow the orbits over the swept parameter. branch_range: smallest value of the swept parameter for
    branches; else of the sweep; largest value of it; else of the sweep. most_points: largest number of points of a
    branch. most_branches: largest number of branches. second_parameter: jSON pointer of a second number, over which
    folds, doublings and losses of symmetry are followed; of several pointers, the numbers at the others keep their
    ratio to the first. second_range: smallest value of the second number; largest value of it. most_curve_points:
    largest number of points of such a curve in each direction. threads: one for each processor, unless given; they
    change the time, never the result. progress: called with what is done and all, once that is known. Raises
    InputError if a condition is random or its excitation is not harmonic.

    >>> import rocking
    >>> found = rocking.orbits({"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
    ...     "excitation": {"kind": "harmonic", "amplitude": 4.0, "frequency_ratio": 10.0}, "restitution": 0.9,
    ...     "horizon": {"transient_periods": 200, "sampled_periods": 60}}, longest=1)
    >>> all(orbit.residual <= 1e-13 for orbit in found.conditions[0].orbits)
    True
    """
    return documents.Orbits(
        answer(
            'orbits',
            {'longest': longest, 'branches': branches, **ends('branch_range', branch_range), 'most_points': most_points, 'most_branches': most_branches, 'second_parameter': words(second_parameter), **ends('second_range', second_range), 'most_curve_points': most_curve_points},
            source=source,
            threads=threads,
            progress=progress,
        )
    )


def rare(
    source: ExperimentLike,
    *,
    relative_error: float = 0.1,
    peak_tilt: Optional[float] = None,
    seconds: Optional[float] = None,
    particles: int = 1000,
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> documents.RareEvents:
    """Estimate the probability of rare overturning.

    source: an experiment. relative_error: standard error over the probability that is aimed at. peak_tilt: ask for
    abs(Theta) > A instead of overturning; 1 is the unstable equilibrium. seconds: stop after this time for all
    conditions together, e.g. 10min; what is finished then counts. particles: trajectories of a repetition. threads:
    one for each processor, unless given; they change the time, never the result. progress: called with what is done
    and all, once that is known. Without ``seconds`` the same is estimated again. Raises InputError if nothing in a
    condition is random or a number is out of range.

    >>> import rocking
    >>> slab = {"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
    ...     "excitation": {"kind": "harmonic", "amplitude": 2.0, "frequency_ratio": 10.0,
    ...                    "phase_rad": {"uniform": [0, 6.28]}}, "restitution": 0.9,
    ...     "horizon": {"transient_periods": 5, "sampled_periods": 15}, "seed": "0x1"}
    >>> estimate, = rocking.rare(slab, peak_tilt=0.05, particles=20, relative_error=1.0).conditions
    >>> estimate.interval[0] <= estimate.probability <= estimate.interval[1]
    True
    """
    return documents.RareEvents(
        answer(
            'rare',
            {'relative_error': relative_error, 'peak_tilt': peak_tilt, 'seconds': seconds, 'particles': particles},
            source=source,
            threads=threads,
            progress=progress,
        )
    )


def infer(
    source: ExperimentLike,
    tests: Path,
    *,
    candidates: Optional[Path] = None,
    next_tests: int = 5,
    seconds: Optional[float] = None,
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> documents.Inference:
    """Infer unknown numbers from counted tests.

    source: an experiment. tests: counted tests, CSV: a line for each condition. candidates: conditions that may be
    tested next, CSV without counts: how much each would tell. next_tests: tests of a candidate condition. seconds:
    add no points to the design after this time, e.g. 10min, and answer from those that are finished. threads: one
    for each processor, unless given; they change the time, never the result. progress: called with what is done and
    all, once that is known. ``source`` is an experiment with ``unknown``. Raises InputError with the line of each
    fault, OSError if a file cannot be read.

    >>> import os, rocking, tempfile
    >>> slab = {"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
    ...     "excitation": {"kind": "harmonic", "amplitude": 4.0, "frequency_ratio": 10.0,
    ...                    "phase_rad": {"uniform": [0, 6.28]}}, "restitution": 0.9,
    ...     "horizon": {"transient_periods": 10, "sampled_periods": 10}, "realisations": 20, "seed": "0x1",
    ...     "unknown": [{"parameter": "/restitution", "from": 0.8, "to": 0.95}]}
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     tests = os.path.join(folder, "tests.csv")
    ...     with open(tests, "w") as file:
    ...         written = file.write("amplitude,overturned,other\\n4.0,1,4\\n")
    ...     unknown, = rocking.infer(slab, tests).unknowns
    >>> unknown.interval[0] <= unknown.estimate <= unknown.interval[1]
    True
    """
    return documents.Inference(
        answer(
            'infer',
            {'tests': None if tests is None else os.fspath(tests), 'candidates': None if candidates is None else os.fspath(candidates), 'next_tests': next_tests, 'seconds': seconds},
            source=source,
            threads=threads,
            progress=progress,
        )
    )


def cost(
    source: ExperimentLike,
    *,
    seconds: float = 60.0,
    sample: Optional[int] = None,
    tolerances: Sequence[float] = (),
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> documents.CostOfAccuracy:
    """Measure the cost of accuracy in time, on a sample of an experiment.

    source: an experiment. seconds: measure as many realisations as possible in this time, e.g. 5min. sample:
    measure N realisations; gives the same numbers again, except times. tolerances: instead of 1e-4, 1e-5, ...
    1e-14; the experiment's own is added. threads: one for each processor, unless given; they change the time, never
    the result. progress: called with what is done and all, once that is known. With ``sample``, ``seconds`` limits
    the measurement of speed. The last of the tolerances is the reference; together with those of the experiment
    they are at least three. Times are processor times of this machine. Raises InputError for a number out of range.

    >>> import rocking
    >>> found = rocking.cost({"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
    ...     "excitation": {"kind": "harmonic", "amplitude": 4.0, "frequency_ratio": 10.0}, "restitution": 0.9,
    ...     "horizon": {"transient_periods": 20, "sampled_periods": 20}, "accuracy": {"tolerance": 1e-10}},
    ...     sample=1, seconds=0.1, tolerances=[1e-6, 1e-14])
    >>> found.result.tolerances.column("tolerance")
    array([1.e-06, 1.e-10, 1.e-14])
    >>> coarse, fine, reference = found.result.tolerances.column("departure.error.median")
    >>> bool(coarse > fine)
    True
    """
    return documents.CostOfAccuracy(
        answer(
            'cost',
            {'seconds': seconds, 'sample': sample, 'tolerances': [float(each) for each in tolerances]},
            source=source,
            threads=threads,
            progress=progress,
        )
    )


def fragility(
    source: Source,
    *,
    peak_tilts: Sequence[float] = (),
    incremental: bool = False,
    hazard: Optional[Path] = None,
    years: Optional[float] = None,
    imt: Optional[str] = None,
    metadata: Optional[Path] = None,
    rare: Optional[Path] = None,
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> documents.Fragility:
    """Fit the probability of overturning as a function of intensity.

    source: a Result, the folder of a complete run, or an experiment, which is run first. peak_tilts: also the
    probability that the peak of abs(theta)/psi exceeds A; several: 0.3,0.5,1. incremental: also the peak tilt
    against intensity for each record. hazard: hazard curve (CSV: intensity, annual_rate or poe; its header names
    measure and kind): gives the mean annual rate. years: with --hazard: the years of its probabilities of
    exceedance, where the file does not state them. imt: with --hazard: the intensity measure of the file, where it
    does not name it, such as PGA or SA(0.5). metadata: magnitudes and distances of the records (CSV: file,
    magnitude, distance_km): says which measures of intensity are sufficient. rare: folder with the rare.json of
    ``rocking rare`` for lower intensities of the same block and motion, or suite of motions: the annual rate takes
    its probabilities below the levels with ten events. threads: one for each processor, unless given; they change
    the time, never the result. progress: called with what is done and all, once that is known. Raises InputError if
    the experiment sweeps no intensity of the excitation or its number of realisations is not fixed.

    >>> import rocking
    >>> slab = {"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
    ...     "excitation": {"kind": "harmonic", "amplitude": 2.0, "frequency_ratio": 10.0,
    ...                    "phase_rad": {"uniform": [0, 6.28]}}, "restitution": 0.9,
    ...     "horizon": {"transient_periods": 5, "sampled_periods": 15}, "realisations": 10, "seed": "0x1",
    ...     "sweep": [{"parameter": "/excitation/amplitude", "values": [1.0, 4.0, 12.0]}]}
    >>> rocking.fragility(slab).curves[0].levels.column("intensity")
    array([ 1.,  4., 12.])
    """
    return documents.Fragility(
        answer(
            'fragility',
            {'peak_tilts': [float(each) for each in peak_tilts], 'incremental': incremental, 'hazard': None if hazard is None else os.fspath(hazard), 'years': years, 'imt': imt, 'metadata': None if metadata is None else os.fspath(metadata), 'rare': None if rare is None else os.fspath(rare)},
            runs=(source,),
            threads=threads,
            progress=progress,
        )
    )


def motion(
    files: Union[Path, Sequence[Path]],
    *,
    format: str = 'auto',
    units: Optional[str] = None,
    time_step: Optional[float] = None,
    columns: Union[str, Sequence[str]] = (),
    vertical: Optional[Path] = None,
    gravity: float = 9.81,
    periods: Sequence[float] = (0.1, 0.2, 0.3, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 5.0),
    damping: float = 0.05,
    series: bool = False,
    block: Sequence[float] = (),
) -> documents.GroundMotions:
    """Read ground motions, and print their intensity measures.

    files: ground motions. format: format of the files; auto: recognised by their first lines. units: unit of the
    accelerations; default: that of the file, or m/s2. time_step: of columns without times [s]. columns: what the
    columns of a file of numbers are: time, horizontal, vertical, other. vertical: file with the vertical component.
    gravity: what 1 g is [m/s^2]. periods: periods of the response spectrum [s]. damping: damping ratio of the
    response spectrum. series: add to --json the motions sample by sample, for ``rocking figure``. block: width and
    height of a block [m], whose least scale of uplift is wanted. Columns are needed where there are more than a
    time and an acceleration, or a header. Raises InputError with file, line and value of each fault.

    >>> import os, rocking, tempfile
    >>> path = os.path.join(tempfile.mkdtemp(), "pulse.txt")
    >>> with open(path, "w") as file:
    ...     _ = file.write("0 0\\n0.5 4.905\\n1 0\\n")
    >>> record = rocking.motion(path, units="m/s2", block=(1.0, 4.0)).motions[0]
    >>> record.pga_g, record.uplift_scale
    (0.5, 0.5)
    """
    return documents.GroundMotions(
        answer(
            'motion',
            {'files': paths(files), 'format': format, 'units': units, 'time_step': time_step, 'columns': words(columns), 'vertical': None if vertical is None else os.fspath(vertical), 'gravity': gravity, 'periods': [float(each) for each in periods], 'damping': damping, 'series': series, 'block': [float(each) for each in block]},
        )
    )


def check_normal(
    n: int = 20000,
    *,
    mean: float = 0.4,
    sigma: float = 0.03,
    law: str = 'normal',
    seed: Union[int, str] = 0x2012,
    sampler: str = 'box-muller',
) -> documents.SamplerCheck:
    """Test the random numbers: moments, tests of fit, histogram.

    n: how many numbers. mean: mean of the distribution. sigma: standard deviation of the distribution. law:
    distribution of the numbers. seed: seed, for example 0x2012 or 8210. sampler: method for normal numbers;
    simulations use box-muller. Raises InputError for a number out of range or an unknown name.

    >>> import rocking
    >>> found = rocking.check_normal(1000)
    >>> abs(found.mean.value - 0.4) < 0.01
    True
    """
    return documents.SamplerCheck(
        answer(
            'check_normal',
            {'n': n, 'mean': mean, 'sigma': sigma, 'law': law, 'seed': str(seed), 'sampler': sampler},
        )
    )
