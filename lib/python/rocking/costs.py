"""The cost of accuracy."""

from __future__ import annotations

import datetime
import json
import platform
import time
from typing import Any, Mapping, Optional, Sequence

import numpy as np

from . import _core
from .experiments import ExperimentLike, experiment
from .running import Progress, processors

__all__ = ["Cost", "cost"]


class Cost:
    """Cost of accuracy in an experiment. Arrays are by falling tolerance; the last tolerance is the reference."""

    def __init__(self, data: Mapping[str, Any]) -> None:
        result, times = data["result"], data["system"]
        curve = result["tolerances"]
        departures = [entry["departure"] for entry in curve]
        self.data: Mapping[str, Any] = data  #: as in ``rocking.cost/1``
        self.sample: int = result["sample"]["realisations"]  #: realisations measured
        self.tolerance: np.ndarray = np.array([entry["tolerance"] for entry in curve], dtype=float)
        #: Taylor steps of a period of the excitation, on average
        self.steps_per_period: np.ndarray = np.array([entry["steps_per_period"] for entry in curve], dtype=float)
        #: median error in Theta, Theta' and V, over the first periods; NaN at the reference, and where nothing moved
        self.median_error: np.ndarray = _numbers(departures, lambda each: each["error"]["median"])
        #: realisations whose response mode is not that of the reference
        self.flips: np.ndarray = np.array([each["flips"]["count"] if each else 0 for each in departures], dtype=np.int64)
        #: of their share: Clopper-Pearson, shape (tolerances, 2); NaN at the reference
        self.flips_interval: np.ndarray = np.array(
            [each["flips"]["interval"] if each else (np.nan, np.nan) for each in departures], dtype=float
        )
        #: processor time of a period of the excitation [s]
        self.seconds_per_period: np.ndarray = np.array(times["processor_s_per_period"], dtype=float)
        self.recommended: Optional[float] = result["recommendation"]["tolerance"]  #: tolerance; None where none suffices
        self.recommendation: str = times["recommendation"]  #: the same with its reason, in words

    def __repr__(self) -> str:
        return f"<rocking.Cost at {len(self.tolerance)} tolerances, {self.sample} realisation(s)>"


def cost(
    source: ExperimentLike,
    *,
    seconds: float = 60.0,
    sample: Optional[int] = None,
    tolerances: Sequence[float] = (),
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> Cost:
    """Measure the cost of accuracy: errors, changed response modes and time by tolerance, on a sample.

    seconds: time to spend. sample: number of realisations to measure instead, at most 100000, which gives the same
    numbers again, except times; ``seconds`` then limits the measurement of speed. tolerances: from 1e-16 to 1e-2,
    instead of 1e-4, 1e-5, ..., 1e-14; the experiment's own are added, and together they are at least three. progress:
    called with (measured realisations, all). Times are processor times of this machine. Raises InputError for a number
    out of range.

    >>> import rocking
    >>> found = rocking.cost({"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
    ...     "excitation": {"kind": "harmonic", "amplitude": 4.0, "frequency_ratio": 10.0}, "restitution": 0.9,
    ...     "horizon": {"transient_periods": 20, "sampled_periods": 20}, "accuracy": {"tolerance": 1e-10}},
    ...     sample=1, seconds=0.1, tolerances=[1e-6, 1e-14])
    >>> found.tolerance
    array([1.e-06, 1.e-10, 1.e-14])
    >>> bool(found.median_error[0] > found.median_error[1])
    True
    """
    checked = experiment(source)
    threads = threads or processors()
    start = datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ")
    began = time.perf_counter()
    asked = [float(tolerance) for tolerance in tolerances]
    measured, interrupted = _core.cost(checked._core, seconds, sample, asked, threads, progress)
    if interrupted or measured is None:
        raise KeyboardInterrupt
    text = measured.text(checked._core, platform.platform(), start, time.perf_counter() - began, threads)
    return Cost(json.loads(text))


def _numbers(departures: Sequence[Any], number: Any) -> np.ndarray:
    found = [None if each is None else number(each) for each in departures]
    return np.array([np.nan if each is None else each for each in found], dtype=float)
