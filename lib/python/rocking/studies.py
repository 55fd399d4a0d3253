"""Studies of experiments."""

from __future__ import annotations

import os
import platform
import time
from typing import Optional, Sequence, Tuple, Union

from . import _core, documents
from .experiments import ExperimentLike, experiment
from .results import Result
from .running import Progress, now, open_run, processors, run

__all__ = ["bifurcation", "compare", "cost", "fragility", "infer", "orbits", "rare"]


def orbits(
    source: ExperimentLike,
    *,
    longest: int = 5,
    branches: bool = False,
    branch_range: Tuple[Optional[float], Optional[float]] = (None, None),
    second_parameter: Union[str, Sequence[str]] = (),
    second_range: Tuple[Optional[float], Optional[float]] = (None, None),
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> documents.Orbits:
    """Find the periodic orbits of each condition, stable and unstable, with their multipliers.

    longest: largest period that is searched, in excitation periods, at most 12. branches: also follow the orbits over the
    only swept parameter, in branch_range or the range of the sweep. second_parameter: JSON pointer of a second number over
    which, in second_range, the folds, doublings and losses of symmetry of the branches are followed too, as ``curves``; of
    several pointers, the numbers at the others keep their ratio to the first. progress: called with (finished conditions,
    all); not while branches are followed, whose number of points is not known. Raises InputError if a condition is random or its excitation is not harmonic.

    >>> import rocking
    >>> found = rocking.orbits({"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
    ...     "excitation": {"kind": "harmonic", "amplitude": 4.0, "frequency_ratio": 10.0}, "restitution": 0.9,
    ...     "horizon": {"transient_periods": 200, "sampled_periods": 60}}, longest=1)
    >>> all(orbit.residual <= 1e-13 for orbit in found.conditions[0].orbits)
    True
    """
    text = _core.orbits(
        experiment(source)._core,
        longest,
        _ends(branch_range) if branches else None,
        [second_parameter] if isinstance(second_parameter, str) else list(second_parameter),
        _ends(second_range),
        threads or processors(),
        progress,
    )
    return documents.Orbits(text)


def bifurcation(
    source: ExperimentLike,
    *,
    realisation: int = 0,
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> documents.BifurcationDiagrams:
    """Follow the responses along the first swept parameter: from the initial state, and from the end of the step before.

    A diagram for each combination of values of the other entries of the sweep. realisation: the one whose random
    numbers are used. progress: called with (finished steps, all). Raises InputError if there is no sweep, if its first
    entry takes values that are not numbers, or if the excitation is not periodic.

    >>> import rocking
    >>> found = rocking.bifurcation({"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
    ...     "excitation": {"kind": "harmonic", "amplitude": 2.0, "frequency_ratio": 10.0}, "restitution": 0.9,
    ...     "horizon": {"transient_periods": 20, "sampled_periods": 20},
    ...     "sweep": [{"parameter": "/excitation/amplitude", "values": [2.0, 4.0]}]})
    >>> [step.value for step in found.diagrams[0].steps if step.branch == "upwards"]
    [2.0, 4.0]
    """
    text = _core.bifurcation(experiment(source)._core, realisation, threads or processors(), progress)
    return documents.BifurcationDiagrams(text)


def fragility(
    source: Union[Result, ExperimentLike],
    *,
    peak_tilts: Sequence[float] = (),
    hazard: Union[str, "os.PathLike[str]", None] = None,
    years: Optional[float] = None,
    imt: Optional[str] = None,
    metadata: Union[str, "os.PathLike[str]", None] = None,
    incremental: bool = False,
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> documents.Fragility:
    """Fit the probability of overturning as a function of the swept intensity; a curve for each point of the rest.

    source: a Result, the folder of a finished run, or an experiment, which is run first. peak_tilts: also curves of the
    probability that the peak of abs(Theta) exceeds each. hazard: file of a hazard curve (CSV: intensity, annual rate or
    probability of exceedance, named by its first line), which gives each curve its ``annual_rate``. years: of its
    probabilities, where the file does not state them. imt: its intensity measure, where the file does not name it, such as
    ``PGA`` or ``SA(0.5)``. metadata: file of magnitudes and distances of records (CSV:
    file, magnitude, distance_km), which says which measures of intensity are sufficient. incremental: also the peak tilt against intensity for each
    record. progress: called with (done, all), of the run and then of the fit. Raises InputError if the experiment sweeps
    no intensity of the excitation or its number of realisations is not fixed.

    >>> import rocking
    >>> slab = {"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
    ...     "excitation": {"kind": "harmonic", "amplitude": 2.0, "frequency_ratio": 10.0,
    ...                    "phase_rad": {"uniform": [0, 6.28]}}, "restitution": 0.9,
    ...     "horizon": {"transient_periods": 5, "sampled_periods": 15}, "realisations": 10, "seed": "0x1",
    ...     "sweep": [{"parameter": "/excitation/amplitude", "values": [1.0, 4.0, 12.0]}]}
    >>> rocking.fragility(slab).curves[0].levels.column("intensity")
    array([ 1.,  4., 12.])
    """
    if isinstance(source, (str, os.PathLike)) and os.path.isdir(source):
        source = open_run(source)
    if hazard is None and (years is not None or imt is not None):
        raise ValueError("years and imt say how hazard is read: give it, too")
    result = source if isinstance(source, Result) else run(source, threads=threads, progress=progress)
    text = _core.fragility(
        result.experiment._core,
        result._core,
        [float(tilt) for tilt in peak_tilts],
        None if hazard is None else os.fspath(hazard),
        years,
        imt,
        None if metadata is None else os.fspath(metadata),
        incremental,
        threads or processors(),
        progress,
    )
    return documents.Fragility(text)


def rare(
    source: ExperimentLike,
    *,
    relative_error: float = 0.1,
    peak_tilt: Optional[float] = None,
    particles: int = 1000,
    seconds: Optional[float] = None,
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> documents.RareEvents:
    """Estimate the probability of rare overturning for each condition.

    relative_error: standard error over the probability that is aimed at. peak_tilt: ask for abs(Theta) above this
    instead of overturning. particles: trajectories of a repetition, 20 to 100000. seconds: stop after this time for all
    conditions together, with what is finished then; without it the same is estimated again. progress: called with
    (realisations simulated, expected in all) once the latter is known. Raises InputError if nothing in a condition is
    random or a number is out of range.

    >>> import rocking
    >>> slab = {"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
    ...     "excitation": {"kind": "harmonic", "amplitude": 2.0, "frequency_ratio": 10.0,
    ...                    "phase_rad": {"uniform": [0, 6.28]}}, "restitution": 0.9,
    ...     "horizon": {"transient_periods": 5, "sampled_periods": 15}, "seed": "0x1"}
    >>> estimate, = rocking.rare(slab, peak_tilt=0.05, particles=20, relative_error=1.0).conditions
    >>> estimate.interval[0] <= estimate.probability <= estimate.interval[1]
    True
    """
    asked = (relative_error, peak_tilt, particles, seconds, threads or processors(), progress)
    return documents.RareEvents(_core.rare(experiment(source)._core, *asked))


def infer(
    source: ExperimentLike,
    tests: Union[str, "os.PathLike[str]"],
    *,
    candidates: Union[str, "os.PathLike[str]", None] = None,
    next_tests: int = 5,
    seconds: Optional[float] = None,
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> documents.Inference:
    """Estimate the unknowns of an experiment from counted tests.

    source: an experiment with ``unknown``. tests: CSV file with a line for each tested condition: swept parameters,
    then a column of counts for each response mode. candidates: the same of conditions that may be tested next, without
    counts; next_tests: tests of each, 1 to 1000. seconds: add no points to the design after this time. progress: called
    with (realisations, planned so far). Raises InputError with the line of each fault, OSError if a file cannot be read.

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
    checked = experiment(source)
    further = None if candidates is None else os.fspath(candidates)
    asked = (next_tests, checked._files, seconds, threads or processors(), progress)
    return documents.Inference(_core.infer(checked._core, os.fspath(tests), further, *asked))


def cost(
    source: ExperimentLike,
    *,
    seconds: float = 60.0,
    sample: Optional[int] = None,
    tolerances: Sequence[float] = (),
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> documents.CostOfAccuracy:
    """Measure the cost of accuracy: errors, changed response modes and time by tolerance, on a sample.

    seconds: time to spend. sample: number of realisations to measure instead, at most 100000, which gives the same
    numbers again, except times; ``seconds`` then limits the measurement of speed. tolerances: from 1e-16 to 1e-2,
    instead of 1e-4, 1e-5, ..., 1e-14; the experiment's own are added, and together they are at least three. The last is
    the reference. progress: called with (measured realisations, all). Times are processor times of this machine. Raises
    InputError for a number out of range.

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
    checked = experiment(source)
    threads = threads or processors()
    start, began = now(), time.perf_counter()
    asked = [float(tolerance) for tolerance in tolerances]
    measured = _core.cost(checked._core, seconds, sample, asked, threads, progress)
    text = measured.text(checked._core, platform.platform(), start, time.perf_counter() - began, threads)
    return documents.CostOfAccuracy(text)


def compare(
    first: Union[Result, str, "os.PathLike[str]"], second: Union[Result, str, "os.PathLike[str]"]
) -> documents.Comparison:
    """Compare two runs of the same seed, pairwise: what a setting changes.

    first, second: a Result, or the folder of a run. The runs have the same seed, number of conditions and records
    of a suite; they may differ in anything else. Realisations that only one run has are left out. Intervals have the confidence of the first
    run. Raises InputError if the seeds, the numbers of conditions or the records differ, OSError or StoreError as open_run().

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
    one, other = (each if isinstance(each, Result) else open_run(each) for each in (first, second))
    return documents.Comparison(_core.compare(one.experiment._core, one._core, other.experiment._core, other._core))


def _ends(range: Tuple[Optional[float], Optional[float]]) -> Tuple[Optional[float], Optional[float]]:
    low, high = range
    return low, high
