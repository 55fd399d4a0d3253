"""Hazard curves."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, List, Optional, Sequence, Tuple

import numpy as np

from . import _core
from .fields import dataset, interface
from .tables import Given, file, told_by_row

if TYPE_CHECKING:
    import numpy.typing as npt
    import pandas
    import xarray

__all__ = ["Hazard", "hazard"]


class Hazard:
    """A hazard curve: how often in a year an intensity is exceeded; between points ln(rate) is linear in ln(intensity)."""

    def __init__(
        self,
        file: str,
        measure: str,
        intensity: npt.NDArray[np.float64],
        annual_rate: npt.NDArray[np.float64],
        years: Optional[float],
        statistic: str,
        site: Optional[Tuple[float, float]],
        certain: int,
    ) -> None:
        self.file = file  #: as it was given; ``hazard`` of one that was given as numbers
        self.measure = measure  #: of the intensities, as a sweep names it: ``pga_g``, ``sa_g[0.5]``
        self.intensity = intensity  #: in the unit of the measure, rising
        self.annual_rate = annual_rate  #: at which it is exceeded [1/year], not rising
        self.years = years  #: of the probabilities in the file, from which the rates follow; None: it has rates
        self.statistic = statistic  #: ``mean``, ``quantile-0.84``; empty: the file does not say
        self.site = site  #: (longitude, latitude) [degrees]; None: the file does not say
        self.certain = certain  #: weaker points of probability 1, which are left out: no rate gives it

    __dir__ = interface

    @property
    def text(self) -> str:
        """The points as a file that ``rocking fragility --hazard`` reads."""
        points = zip(self.intensity.tolist(), self.annual_rate.tolist())
        return f"{self.measure},annual_rate\n" + "".join(f"{intensity!r},{rate!r}\n" for intensity, rate in points)

    def to_pandas(self) -> "pandas.DataFrame":
        """A row for each point."""
        import pandas

        return pandas.DataFrame({self.measure: self.intensity, "annual_rate": self.annual_rate})

    def to_xarray(self) -> "xarray.Dataset":
        """``annual_rate`` over the intensity, which has the name of its measure."""
        facts: Dict[str, Any] = {"file": self.file, "years": self.years, "statistic": self.statistic, "site": self.site}
        return dataset({"annual_rate": ((self.measure,), self.annual_rate)}, {self.measure: self.intensity}, facts)

    def __repr__(self) -> str:
        ends = f"{self.intensity[0]:.6g} to {self.intensity[-1]:.6g}"
        return f"<rocking.Hazard of {self.measure}: {len(self.intensity)} points from {ends}>"


#: As the core takes it: name, text, years, measure, site, statistic.
Asked = Tuple[str, Optional[str], Optional[float], Optional[str], List[float], Optional[str]]


def asked_hazard(
    given: Given, years: Optional[float], imt: Optional[str], site: Optional[Sequence[float]], statistic: Optional[str]
) -> Asked:
    """What is asked of a file, or of what stands in place of one."""
    found = file("hazard", given)
    if found is None:
        raise TypeError("hazard = None: give a path, or columns by name")
    name, text = (found, None) if isinstance(found, str) else found
    return name, text, years, imt, [float(each) for each in site or ()], statistic


def hazard(
    source: Given,
    *,
    years: Optional[float] = None,
    imt: Optional[str] = None,
    site: Optional[Sequence[float]] = None,
    statistic: Optional[str] = None,
) -> Hazard:
    """Read a hazard curve, as ``rocking fragility --hazard`` does: two columns, or a file of OpenQuake or the USGS.

    source: a path; or columns by their names in such a file, as ``{"pga_g": [...], "annual_rate": [...]}``, a structured
    array or a table of pandas; or a pair of arrays, intensities and annual rates, whose measure ``imt`` names. years: of probabilities of exceedance, where the file does not state them. imt, site, statistic: which curve is meant,
    where a file has several: an intensity measure such as ``PGA`` or ``SA(0.5)``, longitude and latitude, ``mean`` or
    ``quantile-0.84``. Raises InputError with file, line (or row) and value of each fault, and OSError where it cannot be
    read.

    >>> import rocking
    >>> rocking.hazard({"pga_g": [0.1, 0.4], "annual_rate": [1e-2, 5e-4]}).annual_rate
    array([0.01  , 0.0005])
    >>> rocking.hazard(([0.1, 0.4], [1e-2, 5e-4]), imt="SA(0.5)").measure
    'sa_g[0.5]'
    """
    asked = asked_hazard(source, years, imt, site, statistic)
    with told_by_row([asked[0]] if asked[1] is not None else []):
        return Hazard(asked[0], *_core.hazard(asked))
