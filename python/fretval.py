"""Runs cases of fretval and reads their results, for scripts and notebooks.

    import fretval

    case = fretval.read_case("fretting.json")          # or a dictionary of sections
    case["Motion"]["Phase"] = "30 deg"
    result = fretval.run(case)                         # MDR and finite elements, compared
    result.verdict                                     # "agree"
    result.fe["stick_radius_shakedown"]                # m; result.mdr[...] of the analytic reference
    result.bar("stick_radius_shakedown")               # error bar of the finite elements, in m
    history = result.table("history.csv")              # columns by name: history["F_x [N]"]

    fretval.mdr(case)                                  # the analytic answer alone, at once
    for result in fretval.read("results"): ...         # whatever `fretval run` has written

It starts the program, which is looked for in FRETVAL_PROGRAM, beside this file as it is installed, and in PATH. Needs
the standard library alone; columns are numpy arrays where numpy is installed, and lists otherwise. Values are in SI
units, in the keys of docs/results.md.
"""

import csv
import json
import os
import pathlib
import shutil
import subprocess
import tempfile

try:
    import numpy
except ImportError:
    numpy = None

__all__ = ["Error", "Result", "mdr", "program", "read", "read_case", "run"]

AGREE, DISAGREE, NOT_RESOLVED = 0, 1, 5


class Error(RuntimeError):
    """The program has refused a case (exit_code 2), or failed (3, 4): what it says."""

    def __init__(self, message, exit_code):
        super().__init__(message)
        self.exit_code = exit_code


def program():
    """The path of the program. Raises FileNotFoundError where there is none."""
    here = pathlib.Path(__file__).resolve().parent
    beside = [here.parents[2] / "bin/fretval"] if len(here.parents) > 2 else []  # share/fretval/python
    for candidate in [os.environ.get("FRETVAL_PROGRAM"), *beside, here.parent / "build/release/fretval", shutil.which("fretval")]:
        if candidate and os.access(candidate, os.X_OK) and not os.path.isdir(candidate):
            return str(candidate)
    raise FileNotFoundError("no program fretval beside this module, in FRETVAL_PROGRAM or in PATH")


def _array(values):
    return numpy.array(values) if numpy is not None else values


def _number(text):
    try:
        return float(text)
    except ValueError:
        return float("nan")


class Result:
    """What `fretval run` has written about a case: result.json, and the tables beside it.

    json       all of result.json
    folder     where it lies
    name       of the case
    verdict    "agree", "not resolved", "disagree", "not proved", "not compared" or "other model"
    mdr, fe    what either method says, by quantity; None where there is none
    comparison difference, error_bar, tolerance and verdict, by quantity
    """

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        with open(self.folder / "result.json", encoding="utf-8") as file:
            self.json = json.load(file)
        self.name = self.json["name"]
        self.verdict = self.json.get("verdict")
        self.mdr, self.fe = self.json["mdr"], self.json["fe"]
        self.comparison = self.json["comparison"]

    def __repr__(self):
        return f"<fretval.Result {self.name}: {self.verdict}>"

    def bar(self, quantity):
        """Error bar of the finite elements in the unit of the quantity; None where none was measured."""
        compared = self.comparison.get(quantity, {})
        if compared.get("error_bar") is None:
            return None
        scene = self.json["scene"]
        is_length = "radius" in quantity or quantity.endswith(("_along", "_across"))
        if is_length and scene.get("contact_radius_unworn"):
            return compared["error_bar"] * scene["contact_radius_unworn"]
        over = {"tangential_force_mean": "sliding_force", "friction_work": "sliding_work"}.get(quantity, quantity)
        return compared["error_bar"] * abs(self.fe[over]) if self.fe.get(over) is not None else None

    def table(self, name):
        """Columns of a CSV file of the case by their names: history.csv, contact.csv, profile.csv, wear.csv, ..."""
        with open(self.folder / name, encoding="utf-8", newline="") as file:
            rows = list(csv.reader(file))
        columns = zip(*rows[1:]) if len(rows) > 1 else [[] for _ in rows[0]]
        return {title: _array([_number(text) for text in column]) for title, column in zip(rows[0], columns)}

    @property
    def tables(self):
        """Names of the CSV files that there are."""
        return sorted(file.name for file in self.folder.glob("*.csv"))


def read(folder):
    """All results below a folder, in the order of their names. Raises FileNotFoundError where there is none."""
    folders = sorted(file.parent for file in pathlib.Path(folder).rglob("result.json"))
    if not folders:
        raise FileNotFoundError(f"{folder}: no result.json below it")
    return [Result(one) for one in folders]


def read_case(file):
    """A case file in JSON as a dictionary of sections, each a dictionary of entries."""
    with open(file, encoding="utf-8") as stream:
        return json.load(stream)


def _call(arguments, good=(AGREE,)):
    done = subprocess.run([program(), *arguments], capture_output=True, encoding="utf-8", errors="replace")
    if done.returncode not in good:
        raise Error(done.stderr.strip() or done.stdout.strip(), done.returncode)
    return done.stdout


def _written(case, folder):
    """The file of a case: as it is, or of a dictionary; files that this names, as tables, need their whole paths."""
    if not isinstance(case, dict):
        return os.fspath(case)
    file = pathlib.Path(folder) / "case.json"
    file.write_text(json.dumps(case), encoding="utf-8")
    return str(file)


def run(case, output=None, proof="tolerance"):
    """Runs a case file, or a case as a dictionary, with finite elements and MDR; returns its Result, of a sweep the list.

    output: folder of the results, which are kept there; otherwise they are in a folder that is gone with the process.
    proof: "none", "bars" or "tolerance". A verdict of disagreement is a result, not an Error.
    """
    kept = pathlib.Path(output) if output else pathlib.Path(_scratch().name) / str(len(os.listdir(_scratch().name)))
    with tempfile.TemporaryDirectory() as folder:
        file = _written(case, folder)
        lines = _call(["-q", "run", file, "-o", str(kept), "--proof", proof, "--json"], (AGREE, DISAGREE, NOT_RESOLVED))
    results = [Result(kept / json.loads(line)["name"]) for line in lines.splitlines()]
    return results[0] if len(results) == 1 else results


def mdr(case):
    """MDR's answer to a case file, or to a case as a dictionary: the document of `fretval mdr --json`, of a sweep a list."""
    with tempfile.TemporaryDirectory() as folder:
        return json.loads(_call(["-q", "mdr", _written(case, folder), "--json"]))


def _scratch():
    if not hasattr(_scratch, "folder"):
        _scratch.folder = tempfile.TemporaryDirectory(prefix="fretval-")
    return _scratch.folder
