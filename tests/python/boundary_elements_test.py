"""The boundary elements of tests/boundary_elements against closed forms: /usr/bin/python3 tests/python/boundary_elements_test.py."""

import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "tests/boundary_elements"))
from boundary_elements import SETTLED, Contact, Counting, HalfSpace, counted_radius  # noqa: E402
from frictional_pressing import elliptic, one_way, stick_radius  # noqa: E402
from scene import STICKS, Course, Scene, limit, readings  # noqa: E402

CASES = ROOT / "cases/vector/boundary-elements"


def flat(r):
    return np.where(r < 1, 0.0, 10.0)


def punch_force(n, nu, mu, coupled):
    contact = Contact(n, 2.1, nu, mu, coupled, profile=flat)
    contact.step(1.0, (0, 0))
    return contact.forces()[2]


class Kernels(unittest.TestCase):
    def test_far_from_an_element_are_those_of_a_point_force(self):
        n, h, nu = 24, 0.1, 0.2
        body, force = HalfSpace(n, h, nu), np.zeros((n, n))
        force[2, 3] = 1 / h**2
        x, y = 15 * h, 12 * h
        rho = math.hypot(x, y)
        at = (..., 17, 15)
        along = body.shift_by_traction(np.stack([force, 0 * force]))[at]
        self.assertAlmostEqual(body.sinking_by_pressure(force)[at] * 2 * math.pi * rho / (1 - nu), 1, 3)
        self.assertAlmostEqual(along[0] * 2 * math.pi * rho / (1 - nu + nu * (x / rho) ** 2), 1, 3)
        self.assertAlmostEqual(along[1] * 2 * math.pi * rho / (nu * x * y / rho**2), 1, 2)
        self.assertAlmostEqual(body.shift_by_pressure(force)[at][0] * -4 * math.pi * rho**2 / x / (1 - 2 * nu), 1, 2)
        self.assertAlmostEqual(body.sinking_by_traction(np.stack([0 * force, force]))[at] * 4 * math.pi * rho**2 / y / (1 - 2 * nu), 1, 2)

    def test_keep_the_reciprocity_of_pressure_and_traction(self):
        n = 12
        body, random = HalfSpace(n, 0.1, 0.1), np.random.default_rng(3)
        p, t = random.standard_normal((n, n)), random.standard_normal((2, n, n))
        self.assertAlmostEqual(np.vdot(body.shift_by_pressure(p), t), np.vdot(body.sinking_by_traction(t), p), 10)


class ContactTest(unittest.TestCase):
    def test_hertz(self):
        # F_N = 8/(3 (1 - nu)), second order in h
        errors = []
        for n in (24, 48):
            contact = Contact(n, 2.1, 0.3, 0.5)
            contact.press(1.0)
            errors.append(abs(contact.forces()[2] * 3 * 0.7 / 8 - 1))
            self.assertAlmostEqual(contact.p.max() * 0.7 * math.pi / 4, 1, 2)  # p_0 = 4/(pi (1 - nu))
        self.assertLess(errors[1], 3e-4)
        self.assertLess(errors[1], errors[0] / 2.5)

    def test_cattaneo(self):
        # For nu = 0, F_x = mu F_N (1 - c^3) at u_x = mu (1 - c^2), whichever way the push points
        c, mu = 0.6, 0.5
        counting = Counting(36, 2.1)
        for direction in (0.0, 0.7):
            contact = Contact(36, 2.1, 0.0, mu)
            contact.press(1.0)
            contact.step(1.0, mu * (1 - c**2) * np.array([math.cos(direction), math.sin(direction)]))
            force = contact.forces()
            self.assertAlmostEqual(math.hypot(*force[:2]) / (mu * 8 / 3 * (1 - c**3)), 1, 3)
            self.assertAlmostEqual(math.atan2(force[1], force[0]), direction, 6)
            mean, spread = counting.stick
            self.assertLess(abs(counted_radius(contact, contact.margin() > SETTLED) - mean * contact.h - c), 1.5 * spread * contact.h)
        self.assertLess(spread, 0.06)

    def test_a_flat_punch_that_does_not_slip(self):
        # F/F(without friction) = (1 - nu) ln(3 - 4 nu)/(1 - 2 nu)
        for nu in (0.0, 0.3):
            exact = (1 - nu) * math.log(3 - 4 * nu) / (1 - 2 * nu)
            self.assertAlmostEqual(punch_force(36, nu, 20.0, True) / punch_force(36, nu, 0.5, False) / exact, 1, 2)

    def test_pressing_with_friction_sticks_as_by_rings(self):
        contact = Contact(36, 2.1, 0.0, 0.5, True, profile=flat)
        contact.step(1.0, (0, 0))
        mean, spread = Counting(36, 2.1).stick
        by_rings = 2 * stick_radius(0.0, 0.5, 80) - stick_radius(0.0, 0.5, 40)
        self.assertLess(abs(counted_radius(contact, contact.margin() > SETTLED) - mean * contact.h - by_rings), spread * contact.h)
        self.assertLess(contact.residual, contact.tolerance)

    def test_what_does_not_converge_is_an_error(self):
        contact = Contact(12, 2.1, 0.3, 0.5, tolerance=1e-30)
        with self.assertRaises(RuntimeError):
            contact.press(1.0)


class FrictionalPressing(unittest.TestCase):
    def test_elliptic_integrals(self):
        # Legendre's relation, and the lemniscate's K(1/2)
        k, e = elliptic(np.array([0.3, 0.7, 0.5]))
        self.assertAlmostEqual(e[0] * k[1] + e[1] * k[0] - k[0] * k[1], math.pi / 2, 12)
        self.assertAlmostEqual(k[2], math.gamma(0.25) ** 2 / (4 * math.sqrt(math.pi)), 12)

    def test_without_the_action_on_pressures_is_the_closed_form(self):
        for nu, mu in ((0.3, 0.2), (0.0, 0.5)):
            coarse, fine = (stick_radius(nu, mu, n, sinks=False) for n in (40, 80))
            self.assertAlmostEqual(2 * fine - coarse, one_way(nu, mu), 2)

    def test_rings_converge(self):
        radii = [stick_radius(0.0, 0.5, n) for n in (20, 40, 80)]
        first, second = (2 * fine - coarse for coarse, fine in zip(radii, radii[1:]))
        self.assertLess(abs(second - first), abs(radii[2] - radii[1]) / 5)

    def test_too_few_rings_are_an_error(self):
        with self.assertRaises(ValueError):
            stick_radius(0.3, 5.0, 20)


class Scenes(unittest.TestCase):
    def test_are_those_of_the_case_files(self):
        scene = Scene(CASES / "in-phase-coupled.prm")
        self.assertEqual((scene.nu, scene.mu, scene.coupled, scene.cycles), (0.3, 0.5, True, 4))
        self.assertAlmostEqual(scene.force, 0.1)
        depth, shift = scene.at(2.0)
        self.assertAlmostEqual(depth, 1.2)
        np.testing.assert_allclose(shift, (0.25, 0))
        circle = Scene(CASES / "circle.prm")
        self.assertFalse(circle.coupled)
        np.testing.assert_allclose(circle.at(3.25)[1], (0, -0.3), atol=1e-12)
        push = Scene(CASES / "push-coupled.prm")
        self.assertIsNone(push.cycles)
        np.testing.assert_allclose(push.at(0.5)[1], (0.2, 0))

    def test_that_it_does_not_know_are_errors(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "case.prm"
            for section, entry, told in (("Friction", "Coefficient = much # too much", "Friction / Coefficient is much"),
                                         ("Indenter", "Shape = cone", "Indenter / Shape is cone, expected parabola"),
                                         ("Motion", "Normal frequency = 2", "one frequency, not 1 and 2"),
                                         ("Wear", "Coefficient = 1e-13", "Wear / Coefficient is not known")):
                file.write_text(f"include {CASES / 'in-phase.prm'}\nsubsection {section}\n  set {entry}\nend\n", encoding="utf-8")
                with self.assertRaisesRegex(ValueError, told):
                    Scene(file)

    def test_a_push_is_cattaneos(self):
        # Without coupling and for nu = 0: c^2 = 1 - u_x/mu, all of it in SI units
        scene = Scene(CASES / "push-coupled.prm")
        scene.nu, scene.coupled = 0.0, False
        found = readings(scene, 36, 6, Counting(36, scene.width))
        self.assertAlmostEqual(found["normal_force_max"][0] / (8 / 3 * 0.1), 1, 3)
        value, error = found["stick_radius_first_slip"]
        self.assertLess(abs(value - 1e-3 * math.sqrt(1 - 0.4 / 0.5)), 2 * error)
        self.assertLess(error, 5e-6)
        self.assertNotIn("stick_radius_shakedown", found)

    def test_friction_loses_what_the_force_works_in_a_cycle(self):
        # Of first order in the steps
        scene, errors = Scene(CASES / "circle.prm", cycles=3), []
        for steps in (24, 48):
            course = Course(scene, 24, steps)
            force = np.array([t.sum((1, 2)) for _, t, _ in course.last]) * course.contact.h ** 2 * scene.force
            shift = np.array([scene.at(2 + k / steps)[1] for k in range(steps + 1)]) * scene.work / scene.force
            work = ((force[1:] + force[:-1]) / 2 * np.diff(shift, axis=0)).sum()
            errors.append(abs(course.friction_work() * scene.work / work - 1))
        self.assertLess(errors[1], 5e-3)
        self.assertLess(errors[1], errors[0] / 2)
        self.assertGreater((course.slip_to_and_fro() < STICKS).sum(), 100)

    def test_what_does_not_come_back_is_no_slip_to_and_fro(self):
        course, away, one = Course.__new__(Course), np.zeros((2, 1, 3)), np.ones((1, 3))
        away[0] = [[1.0, 1.0, 1.0]]
        back, gone = away * [[[1, -1, -1]]], one * [[1, 1, 0]]
        course.last = [(one, 0 * away, 0 * away), (one, 0 * away, away), (gone, 0 * away, back)]
        np.testing.assert_allclose(course.slip_to_and_fro(), [[0, 2, np.inf]])

    def test_limits_are_within_their_errors(self):
        exact = 3.0
        value, error = limit((exact + 0.04 + 0.01, 0), (exact + 0.16 + 0.02, 0), (exact + 0.04 + 0.02, 0))
        self.assertLess(abs(value - exact), error)
        self.assertLess(error, 0.06)
        self.assertEqual(limit((2.0, 0.1), (5.0, 0.3), (2.0, 0.1)), (2.0, 0.1))


class Compare(unittest.TestCase):
    """tests/boundary_elements/compare, with what fretval once said of the push, and on coarse grids."""

    def compared(self, **tampered):
        fe = {"stick_radius_first_slip": 569.66e-6, "contact_radius_max": 1012.4e-6, "normal_force_max": 380.93e-3,
              "tangential_force_max": 154.82e-3, "friction_work": 526.4e-9, "sliding_work": 7.618e-6} | tampered
        result = {"name": "push-coupled", "scene": {"contact_radius_unworn": 1e-3}, "mdr": {}, "fe": fe,
                  "comparison": {name: {"error_bar": 1e-3} for name in fe}}
        with tempfile.TemporaryDirectory() as folder:
            case = pathlib.Path(folder) / "push-coupled/push-coupled"
            case.mkdir(parents=True)
            (case / "result.json").write_text(json.dumps(result), encoding="utf-8")
            return self.called(CASES / "push-coupled.prm", "--elements", "32", "--steps", "8", "--results", folder)

    def called(self, *arguments):
        return subprocess.run([ROOT / "tests/boundary_elements/compare", *arguments], capture_output=True, encoding="utf-8")

    def test_ends_well_where_all_is_within_the_errors(self):
        done = self.compared()
        self.assertEqual((done.returncode, done.stdout.count("| push-coupled |")), (0, 5), done.stdout + done.stderr)

    def test_sees_a_force_that_is_off(self):
        done = self.compared(tangential_force_max=157e-3)
        self.assertEqual((done.returncode, done.stdout.count("above both")), (1, 1), done.stdout + done.stderr)

    def test_refuses_what_is_not_there(self):
        self.assertEqual(self.called("nowhere.prm").returncode, 2)
        self.assertEqual(self.called("--elements", "30").returncode, 2)


if __name__ == "__main__":
    unittest.main()
