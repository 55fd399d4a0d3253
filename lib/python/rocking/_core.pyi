from typing import Any, Callable, Dict, List, Optional, Tuple

import numpy as np
import numpy.typing as npt

contacts: Tuple[str, ...]
events: Tuple[str, ...]
terminations: Tuple[str, ...]

_Progress = Optional[Callable[[int, int], object]]

class Experiment:
    @property
    def title(self) -> str: ...
    @property
    def seed(self) -> int: ...
    @property
    def text(self) -> str: ...
    @property
    def shape(self) -> List[int]: ...
    @property
    def conditions(self) -> int: ...
    def parameters(self, condition: int) -> List[Tuple[str, str]]: ...

class Run:
    @property
    def done(self) -> int: ...
    @property
    def all(self) -> int: ...
    @property
    def damaged_file(self) -> Optional[str]: ...
    @property
    def is_complete(self) -> bool: ...
    def modes(self) -> List[str]: ...
    def counts(self) -> npt.NDArray[np.int64]: ...
    def intervals(self) -> npt.NDArray[np.float64]: ...
    def rows(self) -> npt.NDArray[Any]: ...
    def digest(self) -> str: ...
    def table(self, experiment: Experiment, width: int) -> str: ...
    def report(
        self, experiment: Experiment, machine: str, start: str, duration: float, threads: int
    ) -> str: ...

class Trajectory:
    @property
    def strobe(self) -> npt.NDArray[Any]: ...
    @property
    def events(self) -> npt.NDArray[Any]: ...
    @property
    def history(self) -> npt.NDArray[Any]: ...
    @property
    def period_length(self) -> float: ...
    def facts(self, condition: int, realisation: int) -> str: ...

def parse(
    text: str,
    name: str,
    folder: str,
    seed: Optional[str],
    realisations: Optional[str],
    skips_unreadable: bool,
) -> Experiment: ...
def read(
    path: str, seed: Optional[str], realisations: Optional[str], skips_unreadable: bool
) -> Experiment: ...
def run(
    experiment: Experiment,
    threads: int,
    folder: str,
    files: str,
    shard: Optional[Tuple[int, int]],
    repair: bool,
    on_progress: _Progress,
) -> Tuple[Run, bool]: ...
def plan(
    experiment: Experiment, threads: int, shard: Optional[Tuple[int, int]], timed: bool
) -> Tuple[str, str]: ...
def open_run(folder: str) -> Tuple[Experiment, Run]: ...
def orbits(
    experiment: Experiment,
    longest: int,
    branches: Optional[Tuple[Optional[float], Optional[float]]],
    second: List[str],
    second_range: Tuple[Optional[float], Optional[float]],
    threads: int,
    on_progress: _Progress,
) -> str: ...
class Cost:
    def text(
        self, experiment: Experiment, machine: str, start: str, duration: float, threads: int
    ) -> str: ...

def cost(
    experiment: Experiment,
    seconds: float,
    sample: Optional[int],
    tolerances: List[float],
    threads: int,
    on_progress: _Progress,
) -> Cost: ...
def merge(folder: str, parts: List[str]) -> Tuple[Experiment, Run]: ...
def bifurcation(
    experiment: Experiment, realisation: int, threads: int, on_progress: _Progress
) -> str: ...
def compare(first: Experiment, first_run: Run, second: Experiment, second_run: Run) -> str: ...
def fragility(
    experiment: Experiment,
    run: Run,
    peak_tilts: List[float],
    hazard: Optional[str],
    years: Optional[float],
    imt: Optional[str],
    metadata: Optional[str],
    incremental: bool,
    threads: int,
    on_progress: _Progress,
) -> str: ...
def motion(
    files: List[str],
    vertical: Optional[str],
    format: str,
    units: Optional[str],
    time_step: Optional[float],
    columns: List[str],
    gravity: float,
    damping: float,
    periods: List[float],
    series: bool,
    block: Optional[Tuple[float, float]],
) -> str: ...
def trajectory(
    experiment: Experiment, condition: int, realisation: int, periods: Optional[int], samples: int
) -> Trajectory: ...
def trajectory_text(
    trajectory: Trajectory, condition: int, realisation: int, si: bool, as_table: bool
) -> str: ...
def write_page(
    experiment: Experiment, run: Run, file: str, machine: str, start: str, duration: float, threads: int
) -> Tuple[List[str], List[str]]: ...
def write_trajectory_page(
    experiment: Experiment, condition: int, realisation: int, periods: Optional[int], samples: int, file: str
) -> Tuple[List[str], List[str]]: ...
def write_figures(
    experiment: Experiment, run: Run, folder: str, column: int
) -> Tuple[List[str], List[str]]: ...
def write_sheet(
    experiment: Experiment,
    run: Run,
    hazard: str,
    years: Optional[float],
    imt: Optional[str],
    file: str,
    threads: int,
) -> Tuple[List[str], List[str]]: ...
def write_tables(experiment: Experiment, run: Run, folder: str) -> Tuple[List[str], List[str]]: ...
def draw(
    sources: List[Tuple[str, str]], folder: str, column: int
) -> Tuple[List[str], List[str]]: ...
def verify(
    experiment: Experiment, run: Run, sample: Optional[int], threads: int, on_progress: _Progress
) -> Tuple[int, int, List[str]]: ...
def verify_folder(
    folder: str, sample: Optional[int], threads: int, on_progress: _Progress
) -> Tuple[int, int, List[str]]: ...
def replay(
    experiment: Experiment, run: Run, condition: int, realisation: int, periods: Optional[int], samples: int
) -> Trajectory: ...
def rare(
    experiment: Experiment,
    relative_error: float,
    peak_tilt: Optional[float],
    particles: int,
    seconds: Optional[float],
    threads: int,
    on_progress: _Progress,
) -> str: ...
def infer(
    experiment: Experiment,
    tests: str,
    candidates: Optional[str],
    next_tests: int,
    folder: str,
    seconds: Optional[float],
    threads: int,
    on_progress: _Progress,
) -> str: ...
def check_normal(n: int, mean: float, sigma: float, law: str, seed: int, sampler: str) -> str: ...
def build_info() -> Dict[str, str]: ...
def check_arithmetic() -> List[Tuple[str, bool]]: ...
def clopper_pearson(successes: int, trials: int, confidence: float) -> Tuple[float, float]: ...
def wilson(successes: int, trials: int, confidence: float) -> Tuple[float, float]: ...
def colour(name: str) -> Optional[str]: ...
def version() -> str: ...
def schema(name: str) -> str: ...
