"""How likely is each response of a rocking block?

>>> import rocking
>>> slab = {
...     "format": "rocking.experiment/1",
...     "block": {"width_m": 1.0, "height_m": 4.0},
...     "excitation": {"kind": "harmonic", "amplitude": 4.0, "frequency_ratio": 10.0},
...     "friction": {"static": 0.40, "kinetic": 0.35},
...     "fluctuation": {"friction": {"sigma": 0.0016}},
...     "horizon": {"transient_periods": 100, "sampled_periods": 40},
...     "realisations": 20,
...     "seed": "0x1",
... }
>>> result = rocking.run(slab)
>>> result.probabilities.shape == (1, len(result.modes))
True
"""

from . import _core
from .bifurcations import BifurcationDiagram, DiagramStep, bifurcation
from .checks import RunCheck, check_normal, doctor, replay, verify
from .comparisons import Comparison, ConditionComparison, ModeComparison, compare
from .costs import Cost, cost
from .errors import DifferentBits, InputError, Interrupted, Problem, StoreError
from .experiments import Experiment, ExperimentLike, experiment, validate
from .findings import Findings
from .intervals import clopper_pearson, colour, wilson
from .motions import GroundMotion, motion
from .pages import Written, draw, write_figures, write_page, write_tables, write_trajectory_page
from .rare_events import RareEstimate, rare
from .results import Result
from .running import Plan, merge, open_run, plan, run
from .studies import (
    Bifurcation,
    BifurcationCurve,
    Branch,
    FragilityCurve,
    Orbit,
    Orbits,
    OrbitsOfCondition,
    fragility,
    orbits,
)
from .trajectories import CONTACTS, EVENTS, TERMINATIONS, Trajectory, trajectory

__version__ = _core.version()

__all__ = [
    "Bifurcation",
    "BifurcationCurve",
    "BifurcationDiagram",
    "Branch",
    "CONTACTS",
    "Comparison",
    "ConditionComparison",
    "Cost",
    "DiagramStep",
    "DifferentBits",
    "EVENTS",
    "Experiment",
    "ExperimentLike",
    "Findings",
    "FragilityCurve",
    "GroundMotion",
    "InputError",
    "Interrupted",
    "ModeComparison",
    "Orbit",
    "Orbits",
    "OrbitsOfCondition",
    "Plan",
    "Problem",
    "RareEstimate",
    "Result",
    "RunCheck",
    "StoreError",
    "TERMINATIONS",
    "Trajectory",
    "Written",
    "bifurcation",
    "check_normal",
    "clopper_pearson",
    "colour",
    "compare",
    "cost",
    "doctor",
    "draw",
    "experiment",
    "fragility",
    "merge",
    "motion",
    "open_run",
    "orbits",
    "plan",
    "rare",
    "replay",
    "run",
    "schema",
    "trajectory",
    "validate",
    "verify",
    "wilson",
    "write_figures",
    "write_page",
    "write_tables",
    "write_trajectory_page",
]


def schema(name: str) -> dict:
    """The JSON Schema (draft 07) of a format: ``experiment``, ``report``, ``trajectory``, ...

    >>> import rocking
    >>> rocking.schema("experiment")["type"]
    'object'
    """
    import json

    text = _core.schema(name)
    if not text:
        raise KeyError(f"{name}: no format of this name")
    return json.loads(text)
