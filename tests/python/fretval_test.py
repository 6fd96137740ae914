"""The module as a notebook uses it: python3 tests/python/fretval_test.py. FRETVAL_PROGRAM: the program."""

import json
import math
import os
import pathlib
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python"))
import fretval  # noqa: E402

CASE = {
    "Indenter": {"Shape": "parabola", "Radius": "10 mm"},
    "Elastomer": {"Rheology": "elastic", "Relaxed shear modulus": "1 MPa"},
    "Friction": {"Coefficient": 0.5},
    "Motion": {
        "Indentation": "100 um",
        "Normal amplitude": 0,
        "Normal frequency": 1,
        "Tangential amplitude": "15 um",
        "Tangential frequency": 1,
        "Phase": 0,
    },
    "Accuracy": {"Tolerance": 0.05},
}


class Module(unittest.TestCase):
    def test_mdr_is_the_closed_form(self):
        # c = sqrt(R (d0 - 2 u_x0/(3 mu))), a = sqrt(R d0)
        answer = fretval.mdr(CASE)["mdr"]
        self.assertAlmostEqual(answer["stick_radius_shakedown"] / math.sqrt(1e-2 * (1e-4 - 2e-5)), 1, 9)
        self.assertAlmostEqual(answer["contact_radius_max"] / math.sqrt(1e-2 * 1e-4), 1, 9)

    def test_a_run_is_read_as_arrays(self):
        with tempfile.TemporaryDirectory() as folder:
            result = fretval.run(CASE, output=folder, proof="bars")
            self.assertEqual(result.name, "case")
            self.assertIn(result.verdict, ("agree", "not resolved"))
            radius, bar = result.fe["stick_radius_shakedown"], result.bar("stick_radius_shakedown")
            self.assertLess(abs(radius - math.sqrt(1e-2 * 8e-5)), bar + 1e-3 * 1e-3)
            self.assertIn("history.csv", result.tables)
            history = result.table("history.csv")
            depth = history["d [m]"]
            self.assertGreater(len(depth), 10)
            self.assertEqual(len(history["F_N [N]"]), len(depth))
            self.assertAlmostEqual(max(depth), 1e-4, 9)
            if fretval.numpy is not None:
                self.assertEqual(depth.shape, history["t [s]"].shape)
            self.assertEqual([one.name for one in fretval.read(folder)], ["case"])

    def test_bars_have_the_unit_of_their_quantity(self):
        # Lengths over the contact radius of 2 m, means and friction over what sliding would take, others over their value.
        fe = {"stick_radius_shakedown": 1, "contact_along": 3, "shakedown_across": 0.5, "normal_force_max": 40,
              "tangential_force_mean": 1, "sliding_force": 8, "friction_work": 3, "sliding_work": 16, "cycle_work": None}
        result = {"name": "case", "scene": {"contact_radius_unworn": 2}, "mdr": {}, "fe": fe,
                  "comparison": {name: {"error_bar": 0.25} for name in fe} | {"contact_radius_max": {"error_bar": None}}}
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "result.json").write_text(json.dumps(result), encoding="utf-8")
            read = fretval.read(folder)[0]
        for name, bar in {"stick_radius_shakedown": 0.5, "contact_along": 0.5, "shakedown_across": 0.5,
                          "normal_force_max": 10, "tangential_force_mean": 2, "friction_work": 4, "cycle_work": None,
                          "contact_radius_max": None, "indentation_max": None}.items():
            self.assertEqual(read.bar(name), bar, name)

    def test_a_refusal_is_an_error_with_its_message(self):
        with self.assertRaises(fretval.Error) as caught:
            fretval.mdr({**CASE, "Friction": {"Coefficient": -1}})
        self.assertEqual(caught.exception.exit_code, 2)
        self.assertIn("Friction / Coefficient", str(caught.exception))
        with self.assertRaises(FileNotFoundError):
            with tempfile.TemporaryDirectory() as folder:
                fretval.read(folder)

    def test_a_sweep_is_a_list(self):
        sweep = {**CASE, "Sweep": {"Entry": "Friction / Coefficient", "Values": [0.4, 0.5]}}
        radii = [one["mdr"]["stick_radius_shakedown"] for one in fretval.mdr(sweep)]
        self.assertLess(radii[0], radii[1])


if __name__ == "__main__":
    os.environ.setdefault("FRETVAL_PROGRAM", str(ROOT / "build/release/fretval"))
    unittest.main()
