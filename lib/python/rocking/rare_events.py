"""Rare overturning."""

from __future__ import annotations

import json
from typing import Any, Dict, List, Mapping, Optional, Tuple

import numpy as np

from . import _core
from .experiments import ExperimentLike, experiment
from .findings import Findings
from .running import Progress, processors

__all__ = ["RareEstimate", "rare"]


class RareEstimate:
    """Probability of the event for one condition, by multilevel splitting."""

    def __init__(self, data: Mapping[str, Any]) -> None:
        self.data: Mapping[str, Any] = data  #: the condition as in ``rocking.rare/1``
        self.parameters: Dict[str, Any] = dict(data["parameters"])  #: swept values by JSON pointer
        #: mean of the repetitions; None if none was finished when the time was up
        self.probability: Optional[float] = data["probability"]
        self.interval: Tuple[float, float] = tuple(data["interval"])  #: with the confidence of the condition
        #: standard error over the probability; None if no repetition has seen the event, or fewer than 8 were finished
        self.relative_error: Optional[float] = data["relative_error"]
        self.work: float = data["work"]  #: simulated time, in realisations to the horizon
        self.crude_work: Optional[float] = data["crude_work"]  #: realisations for the same error by plain sampling
        self.ended: str = data["ended"]  #: ``precise``, ``out_of_time``, ``never_seen``, ``most_repetitions``
        self.diagnosis: str = data["diagnosis"]  #: ``none``, or what stands in the way of trusting the interval
        self.levels: np.ndarray = np.array(data["levels"], dtype=float)  #: of the score, rising
        #: mean shares of the trajectories at each level, and the event last
        self.reached: np.ndarray = np.array(data["reached"], dtype=float)

    def __repr__(self) -> str:
        low, high = self.interval
        probability = "without a repetition" if self.probability is None else f"{self.probability:.3g}"
        return f"<rocking.RareEstimate {probability} [{low:.3g}, {high:.3g}]>"


def rare(
    source: ExperimentLike,
    *,
    relative_error: float = 0.1,
    peak_tilt: Optional[float] = None,
    particles: int = 500,
    score: str = "tilt",
    seconds: Optional[float] = None,
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> Findings[RareEstimate]:
    """Estimate the probability of rare overturning by multilevel splitting: an entry for each condition.

    relative_error: standard error over the probability that is aimed at. peak_tilt: ask for abs(Theta) above this
    instead of overturning. particles: trajectories of a repetition at each level, 20 to 100000. score: what measures how
    near a motion is to the event, ``tilt`` or ``energy``. seconds: stop after this time for all conditions together, with
    what is finished then; without it the same is estimated again. progress: called with (finished repetitions, planned
    so far). Raises InputError if nothing in a condition is random or a number is out of range.

    >>> import rocking
    >>> slab = {"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
    ...     "excitation": {"kind": "harmonic", "amplitude": 2.0, "frequency_ratio": 10.0,
    ...                    "phase_rad": {"uniform": [0, 6.28]}}, "restitution": 0.9,
    ...     "horizon": {"transient_periods": 5, "sampled_periods": 15}, "seed": "0x1"}
    >>> estimate, = rocking.rare(slab, peak_tilt=0.05, particles=20, relative_error=1.0)
    >>> estimate.interval[0] <= estimate.probability <= estimate.interval[1]
    True
    """
    if score not in ("tilt", "energy"):
        raise ValueError(f"score = {score!r}: must be 'tilt' or 'energy'")
    checked = experiment(source)
    text, interrupted = _core.rare(
        checked._core, relative_error, peak_tilt, particles, score == "energy", seconds, threads or processors(), progress
    )
    if interrupted or text is None:
        raise KeyboardInterrupt
    data = json.loads(text)
    return Findings([RareEstimate(condition) for condition in data["conditions"]], data)
