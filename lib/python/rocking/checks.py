"""Checks of runs, of the random numbers and of the machine."""

from __future__ import annotations

import os
from typing import Any, Dict, List, Optional, Union

from . import _core
from .fields import interface
from .results import Result
from .running import Progress, processors

__all__ = ["RunCheck", "doctor", "verify"]


class RunCheck:
    """What a check of a run has found."""

    def __init__(self, checked: int, different: int, findings: List[str]) -> None:
        self.checked = checked  #: realisations that were run again
        self.different = different  #: of them, with another result
        self.findings = findings  #: what differs, in words: the first few

    __dir__ = interface

    @property
    def is_verified(self) -> bool:
        """Whether nothing differs."""
        return not self.findings

    def __repr__(self) -> str:
        state = "verified" if self.is_verified else f"{len(self.findings)} finding(s)"
        return f"<rocking.RunCheck of {self.checked} realisations: {state}>"


def verify(
    source: Union[Result, str, "os.PathLike[str]"],
    *,
    sample: Optional[int] = None,
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> RunCheck:
    """Run realisations of a run again and compare them with the stored ones to the bit.

    source: a Result, or the folder of a run; if the folder has a ``report.json``, it must follow from the realisations.
    If it has a report and no store, its experiment is run again, without ``sample``. sample: about this many
    realisations, evenly spaced; default: all. Raises OSError and StoreError as open_run().

    >>> import rocking
    >>> slab = {"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
    ...     "excitation": {"kind": "harmonic", "amplitude": 2.0, "frequency_ratio": 10.0,
    ...                    "phase_rad": {"uniform": [0, 6.28]}}, "restitution": 0.9,
    ...     "horizon": {"transient_periods": 20, "sampled_periods": 20}, "realisations": 10, "seed": "0x1"}
    >>> rocking.verify(rocking.run(slab))
    <rocking.RunCheck of 10 realisations: verified>
    """
    if isinstance(source, Result):
        found = _core.verify(source.experiment._core, source._core, sample, threads or processors(), progress)
    else:
        found = _core.verify_folder(os.fspath(source), sample, threads or processors(), progress)
    return RunCheck(*found)


def doctor() -> Dict[str, Any]:
    """The build, and whether the arithmetic of this machine gives the same bits as others.

    Keys: ``version``, ``revision``, ``compiler``, ``flags``, ``build_type``, a bool for each check, and ``sound``, which
    is whether all passed.

    >>> import rocking
    >>> rocking.doctor()["sound"]
    True
    """
    facts: Dict[str, Any] = _core.build_info()
    checks = dict(_core.check_arithmetic())
    return {**facts, **checks, "sound": all(checks.values())}
