"""Periodic orbits and fragility functions."""

from __future__ import annotations

import json
import os
from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from . import _core
from .experiments import ExperimentLike, experiment
from .findings import Findings
from .results import Result
from .running import Progress, open_run, processors, run

__all__ = [
    "Bifurcation",
    "BifurcationCurve",
    "Branch",
    "FragilityCurve",
    "Orbit",
    "Orbits",
    "OrbitsOfCondition",
    "fragility",
    "orbits",
]

_POINT = np.dtype([("tilt", float), ("tilt_rate", float), ("slip_rate", float)])


class Orbit:
    """A periodic orbit, stable or not."""

    def __init__(self, data: Mapping[str, Any]) -> None:
        self.period: int = data["period"]  #: n: excitation periods until it repeats
        self.cycles: int = data["cycles"]  #: m: pairs of impacts in them
        self.contact: str = data["contact"]  #: contact state at the section
        self.residual: float = data["residual"]  #: of the map over n periods
        self.kind: str = data["kind"]  #: ``node``, ``focus``, ``saddle``, ...
        self.is_stable: Optional[bool] = data["stable"]  #: None where there are no multipliers
        self.is_symmetric: bool = data["symmetric"]  #: equals its mirror image
        self.mirror: int = data["mirror"]  #: place of its mirror image in the list
        self.found_by: str = data["found_by"]  #: ``run``, ``grid`` or ``mirror``
        #: at the n instants of the section: tilt (Theta), tilt_rate (Theta'), slip_rate (V)
        self.points: np.ndarray = np.array([tuple(point) for point in data["points"]], dtype=_POINT)
        #: eigenvalues of the derivative of the map, by falling modulus
        self.multipliers: np.ndarray = np.array([complex(*pair) for pair in data["multipliers"]], dtype=complex)

    def __repr__(self) -> str:
        return f"<rocking.Orbit ({self.cycles},{self.period}), {self.kind}>"


class OrbitsOfCondition:
    """The orbits that were found in one condition."""

    def __init__(self, data: Mapping[str, Any]) -> None:
        self.parameters: Dict[str, Any] = dict(data["parameters"])  #: swept values by JSON pointer
        self.mode: str = data["run"]["mode"]  #: response of the run from the initial state
        self.run_on: Optional[int] = data["run"]["orbit"]  #: the stable orbit on which it ended
        self.orbits: List[Orbit] = [Orbit(orbit) for orbit in data["orbits"]]
        self.searches: int = data["searches"]  #: Newton iterations started
        self.converged: int = data["converged"]  #: of these, to an orbit

    def __repr__(self) -> str:
        where = "".join(f" at {pointer} = {value}" for pointer, value in self.parameters.items())
        return f"<rocking.OrbitsOfCondition{where}: {len(self.orbits)} orbits, the run is {self.mode}>"


_BRANCH_POINT = np.dtype(
    [("value", float), ("tilt", float), ("tilt_rate", float), ("slip_rate", float), ("multiplier", complex), ("stable", bool)]
)
_CURVE_POINT = np.dtype(
    [("value", float), ("second_value", float), ("tilt", float), ("tilt_rate", float), ("slip_rate", float), ("test", float)]
)


def _state(point: Mapping[str, Any]) -> Tuple[float, float, float]:
    return point["state"]["tilt"], point["state"]["tilt_rate"], point["state"]["slip_rate"]


def _largest(point: Mapping[str, Any]) -> complex:
    return complex(*point["multipliers"][0]) if point["multipliers"] else complex(np.nan)


class Branch:
    """Periodic orbits that are connected over the swept parameter."""

    def __init__(self, data: Mapping[str, Any]) -> None:
        self.period: int = data["period"]  #: excitation periods until an orbit repeats
        self.is_symmetric: bool = data["symmetric"]  #: else the mirror image is a branch too, which is not listed
        self.origin: Optional[int] = data["from"]  #: place of the bifurcation at which it branches off, if followed
        self.ends: Tuple[str, str] = tuple(data["ends"])  #: ``range``, ``grazing``, ``joins``, ...
        #: by arclength: value of the parameter, state at the section, largest multiplier (NaN: none), stable
        self.points: np.ndarray = np.array(
            [(p["value"], *_state(p), _largest(p), bool(p["stable"])) for p in data["points"]], dtype=_BRANCH_POINT
        )

    def __repr__(self) -> str:
        return f"<rocking.Branch of period {self.period}, {len(self.points)} points>"


class Bifurcation:
    """A bifurcation on a branch."""

    def __init__(self, data: Mapping[str, Any]) -> None:
        self.kind: str = data["kind"]  #: ``fold``, ``period_doubling``, ``symmetry_breaking``, ``grazing``, ...
        self.value: float = data["value"]  #: of the parameter
        self.error: float = data["error"]  #: half the width of the bracket of the value, at least
        self.branch: int = data["branch"]  #: place of the branch

    def __repr__(self) -> str:
        return f"<rocking.Bifurcation {self.kind} at {self.value}>"


class BifurcationCurve:
    """Bifurcations of one kind that are connected over two parameters."""

    def __init__(self, data: Mapping[str, Any]) -> None:
        self.kind: str = data["kind"]
        self.bifurcation: int = data["bifurcation"]  #: place of the one from which it was followed
        self.period: int = data["period"]
        self.is_symmetric: bool = data["symmetric"]
        self.ends: Tuple[str, str] = tuple(data["ends"])
        #: by arclength: values of both parameters, state at the section, smallest singular value of the condition
        self.points: np.ndarray = np.array(
            [(p["value"], p["second_value"], *_state(p), p["test"]) for p in data["points"]], dtype=_CURVE_POINT
        )

    def __repr__(self) -> str:
        return f"<rocking.BifurcationCurve of {self.kind}, {len(self.points)} points>"


class Orbits(Findings[OrbitsOfCondition]):
    """The orbits of each condition, a list, with the branches and what was found on them."""

    def __init__(self, data: Mapping[str, Any]) -> None:
        super().__init__([OrbitsOfCondition(condition) for condition in data["conditions"]], data)
        self.parameter: Optional[str] = data.get("parameter")  #: JSON pointer, of the branches
        self.branches: List[Branch] = [Branch(branch) for branch in data.get("branches", [])]
        self.bifurcations: List[Bifurcation] = [Bifurcation(one) for one in data.get("bifurcations", [])]
        self.curves: List[BifurcationCurve] = [BifurcationCurve(curve) for curve in data.get("curves", [])]

    def __repr__(self) -> str:
        followed = f"{len(self.branches)} branches, {len(self.bifurcations)} bifurcations, {len(self.curves)} curves"
        return f"<rocking.Orbits {list(self)}, {followed}>"


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
) -> Orbits:
    """Find the periodic orbits of each condition, stable and unstable, with their multipliers.

    longest: largest period that is searched, in excitation periods, at most 12. branches: also follow the orbits over the
    only swept parameter, in branch_range or the range of the sweep: ``branches`` and ``bifurcations`` of the list, which
    draw() draws. second_parameter: JSON pointer of a second number over which, in second_range, the folds, doublings and
    losses of symmetry of the branches are followed too: ``curves``; of several pointers, the numbers at the others keep
    their ratio to the first. progress: called with (finished conditions, all). Raises InputError if a condition is random or its excitation is not harmonic.

    >>> import rocking
    >>> found = rocking.orbits({"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
    ...     "excitation": {"kind": "harmonic", "amplitude": 4.0, "frequency_ratio": 10.0}, "restitution": 0.9,
    ...     "horizon": {"transient_periods": 200, "sampled_periods": 60}}, longest=1)
    >>> all(orbit.residual <= 1e-13 for orbit in found[0].orbits)
    True
    """
    checked = experiment(source)
    text, interrupted = _core.orbits(
        checked._core,
        longest,
        tuple(branch_range) if branches else None,
        [second_parameter] if isinstance(second_parameter, str) else list(second_parameter),
        tuple(second_range),
        threads or processors(),
        progress,
    )
    if interrupted or text is None:
        raise KeyboardInterrupt
    return Orbits(json.loads(text))


class FragilityCurve:
    """Probability of overturning as a function of intensity. Arrays are by growing intensity."""

    def __init__(self, data: Mapping[str, Any]) -> None:
        levels = data["levels"]
        self.data: Mapping[str, Any] = data  #: the curve as in ``rocking.fragility/1``
        self.parameter: str = data["parameter"]  #: JSON pointer to the intensity
        self.event: Mapping[str, Any] = data["event"]  #: overturning, or the peak tilt that is exceeded
        self.annual_rate: Optional[Mapping[str, Any]] = data.get("annual_rate")  #: with a hazard curve
        self.intensity = np.array([level["intensity"] for level in levels], dtype=float)
        self.overturned = np.array([level["overturned"] for level in levels], dtype=np.int64)
        self.realisations = np.array([level["realisations"] for level in levels], dtype=np.int64)
        self.estimate = np.array([level["estimate"] for level in levels], dtype=float)
        #: Clopper-Pearson, of each level alone, shape (levels, 2); NaN for a suite, whose levels join records
        self.exact = np.array([level.get("exact", [np.nan, np.nan]) for level in levels], dtype=float).reshape(-1, 2)
        #: the fitted function; NaN where none is fitted
        self.fitted = np.array([np.nan if level["fitted"] is None else level["fitted"] for level in levels])

    def __repr__(self) -> str:
        return f"<rocking.FragilityCurve of {self.parameter}, {len(self.intensity)} levels>"


def fragility(
    source: Union[Result, ExperimentLike],
    *,
    peak_tilts: Sequence[float] = (),
    hazard: Union[str, "os.PathLike[str]", None] = None,
    incremental: bool = False,
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> Findings[FragilityCurve]:
    """Fit the probability of overturning as a function of the swept intensity; a curve for each point of the rest.

    source: a Result, the folder of a finished run, or an experiment, which is run first. peak_tilts: also curves of the
    probability that the peak of abs(Theta) exceeds each. hazard: file of a hazard curve (CSV: intensity, annual rate of
    exceedance), which gives each curve its ``annual_rate``. incremental: also the peak tilt against intensity for each
    record, in ``data`` of the list. progress: called with (done, all), of the run and then of the fit. Raises InputError if the
    experiment sweeps no intensity of the excitation or its number of realisations is not fixed.

    >>> import rocking
    >>> slab = {"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
    ...     "excitation": {"kind": "harmonic", "amplitude": 2.0, "frequency_ratio": 10.0,
    ...                    "phase_rad": {"uniform": [0, 6.28]}}, "restitution": 0.9,
    ...     "horizon": {"transient_periods": 5, "sampled_periods": 15}, "realisations": 10, "seed": "0x1",
    ...     "sweep": [{"parameter": "/excitation/amplitude", "values": [1.0, 4.0, 12.0]}]}
    >>> curve, = rocking.fragility(slab)
    >>> curve.intensity
    array([ 1.,  4., 12.])
    """
    if isinstance(source, (str, os.PathLike)) and os.path.isdir(source):
        source = open_run(source)
    result = source if isinstance(source, Result) else run(source, threads=threads, progress=progress)
    text, interrupted = _core.fragility(
        result.experiment._core,
        result._core,
        [float(tilt) for tilt in peak_tilts],
        None if hazard is None else os.fspath(hazard),
        incremental,
        threads or processors(),
        progress,
    )
    if interrupted or text is None:
        raise KeyboardInterrupt
    data = json.loads(text)
    return Findings([FragilityCurve(curve) for curve in data["curves"]], data)
