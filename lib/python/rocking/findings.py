"""Lists of what a study has found."""

from __future__ import annotations

from typing import Any, List, Mapping, TypeVar

__all__ = ["Findings"]

_Item = TypeVar("_Item")


class Findings(List[_Item]):
    """A list with the whole document from which it was made, in ``data``; draw() takes it.

    >>> import rocking
    >>> found = rocking.orbits({"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
    ...     "excitation": {"kind": "harmonic", "amplitude": 4.0, "frequency_ratio": 10.0}, "restitution": 0.9,
    ...     "horizon": {"transient_periods": 20, "sampled_periods": 20}}, longest=1)
    >>> found.data["format"]
    'rocking.orbits/1'
    """

    data: Mapping[str, Any]  #: with its ``format``

    def __init__(self, items: List[_Item], data: Mapping[str, Any]) -> None:
        super().__init__(items)
        self.data = data

    def __repr__(self) -> str:
        return f"<rocking.{type(self).__name__} {super().__repr__()}>"
