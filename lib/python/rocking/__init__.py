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

import json
from typing import Any, Dict, List

from . import _core, documents, studies
from .checks import RunCheck, doctor, verify
from .errors import DifferentBits, InputError, Interrupted, Problem, StoreError
from .experiments import Experiment, ExperimentLike, experiment, validate
from .fields import Document, Fields, Rows
from .hazards import Hazard, hazard
from .intervals import clopper_pearson, colour, wilson
from .pages import Written, draw, write_figures, write_page, write_sheet, write_tables, write_trajectory_page
from .results import Result
from .running import Plan, open_run, plan, resume, run, show_progress
from .studies import *  # noqa: F403
from .trajectories import CONTACTS, EVENTS, TERMINATIONS, Trajectory, trajectory

__version__ = _core.version()

__all__ = [
    "CONTACTS",
    "DifferentBits",
    "Document",
    "EVENTS",
    "Experiment",
    "ExperimentLike",
    "Fields",
    "Hazard",
    "InputError",
    "Interrupted",
    "Plan",
    "Problem",
    "Result",
    "Rows",
    "RunCheck",
    "StoreError",
    "TERMINATIONS",
    "Trajectory",
    "Written",
    "clopper_pearson",
    "colour",
    "doctor",
    "documents",
    "draw",
    "experiment",
    "hazard",
    "open_run",
    "plan",
    "resume",
    "run",
    "schema",
    "show_progress",
    "trajectory",
    "validate",
    "verify",
    "wilson",
    "write_figures",
    "write_page",
    "write_sheet",
    "write_tables",
    "write_trajectory_page",
]
__all__ += studies.__all__


def __dir__() -> List[str]:
    return [*__all__, "__version__"]


def schema(name: str) -> Dict[str, Any]:
    """The JSON Schema (draft 07) of a format: ``experiment``, ``report``, ``trajectory``, ...

    >>> import rocking
    >>> rocking.schema("experiment")["type"]
    'object'
    """
    text = _core.schema(name)
    if not text:
        raise KeyError(f"{name}: no format of this name")
    found: Dict[str, Any] = json.loads(text)
    return found
