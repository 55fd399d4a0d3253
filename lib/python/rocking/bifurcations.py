"""Bifurcation diagrams."""

from __future__ import annotations

import json
from typing import Any, Dict, List, Mapping, Optional

import numpy as np

from . import _core
from .experiments import ExperimentLike, experiment
from .findings import Findings
from .running import Progress, processors

__all__ = ["BifurcationDiagram", "DiagramStep", "bifurcation"]

_POINT = np.dtype([("tilt", float), ("tilt_rate", float)])


class DiagramStep:
    """One value of the parameter on one branch."""

    def __init__(self, data: Mapping[str, Any]) -> None:
        self.value: float = data["value"]  #: of the parameter
        self.branch: str = data["branch"]  #: ``initial``, ``upwards`` or ``downwards``
        self.is_continued: bool = data["start"] == "continued"  #: started at the end of the step before
        self.condition: int = data["condition"]  #: of the experiment, from 0
        self.termination: str = data["termination"]  #: why the motion ended, one of ``rocking.TERMINATIONS``
        self.mode: str = data["mode"]  #: response mode
        self.reason: Optional[str] = data["reason"]  #: of the classification; None where no rule was needed
        #: strobe points of the sampled periods: tilt (Theta), tilt_rate (Theta'); none if the motion ended before
        self.points: np.ndarray = np.array([tuple(point) for point in data["points"]], dtype=_POINT)

    def __repr__(self) -> str:
        return f"<rocking.DiagramStep {self.value}, {self.branch}: {self.mode}>"


class BifurcationDiagram:
    """Responses along one parameter, at fixed values of the others."""

    def __init__(self, data: Mapping[str, Any], parameter: str) -> None:
        self.parameter: str = parameter  #: JSON pointer to the parameter: the first entry of the sweep
        self.others: Dict[str, Any] = dict(data["others"])  #: values of the other entries by JSON pointer
        #: by branch (``initial``, ``upwards``, ``downwards``), then by increasing value
        self.steps: List[DiagramStep] = [DiagramStep(step) for step in data["steps"]]

    def branch(self, name: str) -> List[DiagramStep]:
        """The steps of one branch, by increasing value of the parameter."""
        return [step for step in self.steps if step.branch == name]

    def __repr__(self) -> str:
        return f"<rocking.BifurcationDiagram along {self.parameter}, {len(self.branch('initial'))} values>"


def bifurcation(
    source: ExperimentLike,
    *,
    realisation: int = 0,
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> Findings[BifurcationDiagram]:
    """Follow the responses along the first swept parameter: from the initial state, and from the end of the step before.

    A diagram for each combination of values of the other entries of the sweep. realisation: the one whose random
    numbers are used. progress: called with (finished steps, all). Raises InputError if there is no sweep, if its first
    entry takes values that are not numbers, or if the excitation is not periodic.

    >>> import rocking
    >>> diagram, = rocking.bifurcation({"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
    ...     "excitation": {"kind": "harmonic", "amplitude": 2.0, "frequency_ratio": 10.0}, "restitution": 0.9,
    ...     "horizon": {"transient_periods": 20, "sampled_periods": 20},
    ...     "sweep": [{"parameter": "/excitation/amplitude", "values": [2.0, 4.0]}]})
    >>> [step.value for step in diagram.branch("upwards")]
    [2.0, 4.0]
    """
    checked = experiment(source)
    text, interrupted = _core.bifurcation(checked._core, realisation, threads or processors(), progress)
    if interrupted or text is None:
        raise KeyboardInterrupt
    data = json.loads(text)
    return Findings([BifurcationDiagram(diagram, data["parameter"]) for diagram in data["diagrams"]], data)
