"""The public data of the shake-table tests: what was recorded, and what fell.

The folder is a clone of github.com/ZhiangChen/virtual_shake_robot_pybullet at commit 9f239e7 with a file `tests.csv` in it:

    test,date,motion,pgv_over_pga_s,outcome_1

a line for each test: its number, the day (20210621), the name of the motion, its published PGV/PGA, and 1 where rock 1
overturned, else 0. It is exported from Results_Granite.xlsx of the clone, and so is the file of rock 2, `test,outcome_2`,
which may have more columns: the answers of other models, 0 or 1, each under its name. Recordings are data/Shake_Table_Response/TestNNN.txt: a header, then time
[s] and acceleration of the table [g] in the first two of eight columns, 800 a second. Recordings that are absent are left
out."""

import csv
import dataclasses
import hashlib
import pathlib

import numpy

RECORDINGS = pathlib.Path("data/Shake_Table_Response")
DIGESTS = pathlib.Path(__file__).with_name("recordings.sha256")
STEP = 0.00125  # [s] of a recording
KEPT = 4  # every fourth value is kept: 0.005 s
CUT_OFF = 50.0  # [Hz] of the low-pass filter
ORDER = 4  # of the Butterworth filter that goes forth and back


@dataclasses.dataclass
class Test:
    number: int
    day: str
    motion: str
    outcome: int | None  # 1: rock 1 overturned
    pgv_over_pga: float  # as published [s]
    pga: float = 0.0  # [g]
    pgv: float = 0.0  # [m/s]
    duration: float = 0.0  # [s]

    @property
    def file(self):
        return f"Test{self.number:03d}.txt"


class Unusable(Exception):
    """A file of the data that cannot be used, with the reason."""


def check_columns(rows, path, needed):
    missing = needed - set(rows.fieldnames or ())
    if missing:
        raise Unusable(f"{path}, line 1: has no column {', '.join(sorted(missing))}")


def answer_in(row, column, rows, path):
    """0 or 1."""
    if row[column] not in ("0", "1"):
        raise Unusable(f"{path}, line {rows.line_num}: {column} = {row[column]!r} is neither 0 nor 1")
    return int(row[column])


def answers_of_rock_2(path, tests):
    """By the name of its column, `outcome_2` and those of other models: 0 or 1 for each test."""
    with open(path, encoding="utf-8", newline="") as file:
        rows = csv.DictReader(file)
        check_columns(rows, path, {"test", "outcome_2"})
        columns = [name for name in rows.fieldnames if name != "test"]
        known = {int(row["test"]): [answer_in(row, column, rows, path) for column in columns] for row in rows}
    absent = [test.number for test in tests if test.number not in known]
    if absent:
        raise Unusable(f"{path}: has no test {absent[0]}")
    return {column: [known[test.number][k] for test in tests] for k, column in enumerate(columns)}


def tests_in(folder):
    """The tests of `tests.csv` in the order of their numbers."""
    path = pathlib.Path(folder) / "tests.csv"
    with open(path, encoding="utf-8", newline="") as file:
        rows = csv.DictReader(file)
        check_columns(rows, path, {"test", "date", "motion", "pgv_over_pga_s", "outcome_1"})
        tests = [Test(int(row["test"]), row["date"], row["motion"], answer_in(row, "outcome_1", rows, path),
                      float(row["pgv_over_pga_s"])) for row in rows]
    numbers = [test.number for test in tests]
    if len(set(numbers)) < len(numbers):
        raise Unusable(f"{path}: has a test twice")
    return sorted(tests, key=lambda test: test.number)


def check_digests(folder):
    """Whether the recordings are those of the commit. Gives the names of files that differ."""
    expected = dict(reversed(line.split()) for line in DIGESTS.read_text(encoding="ascii").splitlines())
    found = {name: pathlib.Path(folder) / RECORDINGS / name for name in expected}
    return [name for name, path in found.items()
            if path.exists() and hashlib.sha256(path.read_bytes()).hexdigest() != expected[name]]


def recorded(path):
    """Acceleration of the table [g], at steps of STEP."""
    with open(path, encoding="latin-1") as file:
        lines = file.read().splitlines()[1:]
    values = []
    for number, line in enumerate(lines, 2):
        columns = line.split("\t")
        try:
            time, acceleration = float(columns[0]), float(columns[1])
        except (ValueError, IndexError) as error:
            raise Unusable(f"{path}, line {number}: has no time and acceleration in its first columns") from error
        if abs(time - STEP * len(values)) > 0.5 * STEP:
            raise Unusable(f"{path}, line {number}: its time is not {STEP * len(values):g} s")
        values.append(acceleration)
    if len(values) < 2:
        raise Unusable(f"{path}: has fewer than two values")
    return numpy.array(values)


def filtered(values, kept=KEPT):
    """Without its mean, and without what is above CUT_OFF: every `kept`-th value. The filter has no phase."""
    mirrored = numpy.concatenate([values, values[::-1]]) - values.mean()
    spectrum = numpy.fft.rfft(mirrored)
    frequency = numpy.fft.rfftfreq(len(mirrored), STEP)
    smooth = numpy.fft.irfft(spectrum / (1.0 + (frequency / CUT_OFF) ** (2 * ORDER)), len(mirrored))
    return smooth[: len(values) : kept]


def peak_velocity(acceleration, gravity=9.81, lowest=0.25):
    """Largest velocity [m/s] of an acceleration [g] above `lowest` [Hz]."""
    spectrum = numpy.fft.rfft(acceleration) * gravity
    frequency = numpy.fft.rfftfreq(len(acceleration), KEPT * STEP)
    with numpy.errstate(divide="ignore", invalid="ignore"):
        velocity = numpy.where(frequency >= lowest, spectrum / (2j * numpy.pi * frequency), 0.0)
    return float(numpy.abs(numpy.fft.irfft(velocity, len(acceleration))).max())


def write_motions(folder, results):
    """Writes motions/TestNNN.txt below `results`, accelerations in g at 0.005 s. Gives the tests with a recording."""
    motions = pathlib.Path(results) / "motions"
    motions.mkdir(parents=True, exist_ok=True)
    tests = []
    for test in tests_in(folder):
        path = pathlib.Path(folder) / RECORDINGS / test.file
        if not path.exists():
            continue
        acceleration = filtered(recorded(path))
        test.pga, test.pgv = float(numpy.abs(acceleration).max()), peak_velocity(acceleration)
        test.duration = KEPT * STEP * len(acceleration)
        (motions / test.file).write_text("".join(f"{value:.6f}\n" for value in acceleration), encoding="ascii")
        tests.append(test)
    if not tests:
        raise Unusable(f"{folder}: has no recordings in {RECORDINGS}")
    return tests
