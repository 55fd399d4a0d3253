"""Hazard curves."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Dict, Optional, Tuple

import numpy as np

from . import _core
from .asking import Path
from .fields import dataset

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
        self.file = file  #: as it was given
        self.measure = measure  #: of the intensities, as a sweep names it: ``pga_g``, ``sa_g[0.5]``
        self.intensity = intensity  #: in the unit of the measure, rising
        self.annual_rate = annual_rate  #: at which it is exceeded [1/year], not rising
        self.years = years  #: of the probabilities in the file, from which the rates follow; None: it has rates
        self.statistic = statistic  #: ``mean``, ``quantile-0.84``; empty: the file does not say
        self.site = site  #: (longitude, latitude) [degrees]; None: the file does not say
        self.certain = certain  #: weaker points of probability 1, which are left out: no rate gives it

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


def hazard(
    file: Path,
    *,
    years: Optional[float] = None,
    imt: Optional[str] = None,
    site: Optional[Tuple[float, float]] = None,
    statistic: Optional[str] = None,
) -> Hazard:
    """Read a hazard curve, as ``rocking fragility --hazard`` does: two columns, or a file of OpenQuake or the USGS.

    years: of probabilities of exceedance, where the file does not state them. imt, site, statistic: which curve is meant,
    where a file has several: an intensity measure such as ``PGA`` or ``SA(0.5)``, longitude and latitude, ``mean`` or
    ``quantile-0.84``. Raises InputError with file, line and value of each fault, and OSError where it cannot be read.

    >>> import os, rocking, tempfile
    >>> path = os.path.join(tempfile.mkdtemp(), "hazard.csv")
    >>> with open(path, "w") as file:
    ...     _ = file.write("pga_g, annual_rate\\n0.1, 1e-2\\n0.4, 5e-4\\n")
    >>> rocking.hazard(path).annual_rate
    array([0.01  , 0.0005])
    """
    name = os.fspath(file)
    where = [] if site is None else [float(each) for each in site]
    return Hazard(name, *_core.hazard(name, years, imt, where, statistic))
