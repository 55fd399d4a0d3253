"""Confidence intervals, and colours of response modes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Callable, Tuple

import numpy as np

from . import _core

if TYPE_CHECKING:
    import numpy.typing as npt

__all__ = ["clopper_pearson", "colour", "wilson"]


def clopper_pearson(successes: npt.ArrayLike, trials: npt.ArrayLike, confidence: float = 0.95) -> npt.NDArray[Any]:
    """Exact two-sided intervals of probabilities, as in reports (Clopper & Pearson 1934).

    successes, trials: whole numbers, or arrays that are broadcast against each other. Returns (low, high) in the last
    dimension: shape (..., 2); [0, 1] without trials. Raises InputError if there are more successes than trials, or if
    the confidence is not between 0 and 1.

    >>> import rocking
    >>> low, high = rocking.clopper_pearson(0, 20)
    >>> float(low), round(float(high), 12) == round(1 - 0.025 ** (1 / 20), 12)
    (0.0, True)
    """
    return _intervals(_core.clopper_pearson, successes, trials, confidence)


def wilson(successes: npt.ArrayLike, trials: npt.ArrayLike, confidence: float = 0.95) -> npt.NDArray[Any]:
    """Score intervals of probabilities (Wilson 1927): narrower, right on average. Arguments as clopper_pearson().

    >>> import rocking
    >>> rocking.wilson([0, 10], 20).shape
    (2, 2)
    """
    return _intervals(_core.wilson, successes, trials, confidence)


def colour(mode: str) -> str:
    """The colour of a response mode in all figures of the program, as ``#rrggbb``.

    Raises ValueError if there is no mode of this name.

    >>> import rocking
    >>> rocking.colour("(1,3)")
    '#d55e00'
    """
    found = _core.colour(mode)
    if found is None:
        raise ValueError(f"{mode}: no response mode, such as (1,3) or overturned")
    return found


def _intervals(
    interval: Callable[[int, int, float], Tuple[float, float]],
    successes: npt.ArrayLike,
    trials: npt.ArrayLike,
    confidence: float,
) -> npt.NDArray[Any]:
    counts = np.broadcast_arrays(successes, trials)
    for each in counts:
        if each.size and (not np.issubdtype(each.dtype, np.integer) or (each < 0).any()):
            raise ValueError("successes and trials must be whole numbers, not negative")
    pairs = zip(*(each.ravel().tolist() for each in counts))
    found = [interval(k, n, confidence) for k, n in pairs]
    return np.array(found, dtype=float).reshape(counts[0].shape + (2,))
