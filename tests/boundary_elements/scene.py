"""Scenes of case files, stepped by boundary elements, and what is read off them."""

import csv
import pathlib

import numpy as np

from boundary_elements import SETTLED, Contact, counted_radius

# How much wider a square of elements is than the largest contact of the overlap: coupled contacts are wider by a few percent.
MARGIN = 1.05
STICKS = 1e-4  # of slip to and fro in d0: what is below it is left over by the solvers, or still dies out


def read_case(file):
    """Entries of a .prm file by (section, name), with those that it includes."""
    file, section, entries = pathlib.Path(file), None, {}
    for line in file.read_text(encoding="utf-8").splitlines():
        words = line.split("#")[0].split()
        if words[:1] == ["include"]:
            entries |= read_case(file.parent / words[1])
        elif words[:1] == ["subsection"]:
            section = words[1]
        elif words[:1] == ["set"]:
            name, value = " ".join(words[1:]).split("=", 1)
            entries[section, name.strip()] = value.strip()
    return entries


# What else a case may say of itself, by section: what is not known here would be passed over in silence.
KNOWN = {
    "Indenter": {"Shape", "Radius"},
    "Elastomer": {"Rheology", "Relaxed shear modulus", "Poisson ratio"},
    "Friction": {"Coefficient"},
    "Contact": {"Friction", "Coupling"},
    "Motion": {"Path", "Path repeats", "Indentation", "Normal amplitude", "Normal frequency", "Tangential amplitude",
               "Tangential frequency", "Phase", "Transverse amplitude", "Transverse frequency", "Transverse phase"},
    "Accuracy": {"Tolerance", "Cycle tolerance"},
}
WANTED = {("Indenter", "Shape"): "parabola", ("Elastomer", "Rheology"): "elastic", ("Contact", "Friction"): "vector"}


class Scene:
    """A parabola on an elastic half-space, moved by prescribed displacements: at(tau) = d, (u_x, u_y) in d0.

    cycles: number of cycles to be stepped, the first of which is the ramp, and tau counts them; None: one pass, tau from 0 to 1.
    force, work: units G a d0 in N, and G a d0^2 in J; length: a = sqrt(R d0) in m. Raises ValueError where the case is something else.
    """

    def __init__(self, file, cycles=4):
        self._file, self._entries = file, read_case(file)
        for section, name in self._entries:
            if name not in KNOWN.get(section, ()):
                raise ValueError(f"{file}: {section} / {name} is not known to the boundary elements")
        for (section, name), value in WANTED.items():
            if self._entries.get((section, name)) != value:
                raise ValueError(f"{file}: {section} / {name} is {self._entries.get((section, name))}, expected {value}")
        self.nu, self.mu = self._number("Elastomer", "Poisson ratio", 0.5), self._number("Friction", "Coefficient")
        self.coupled = self._entries.get(("Contact", "Coupling")) == "on"
        d0 = self._pass() if ("Motion", "Path") in self._entries else self._oscillation(cycles)
        modulus = self._number("Elastomer", "Relaxed shear modulus")
        self.length = np.sqrt(self._number("Indenter", "Radius") * d0)
        self.force, self.work = modulus * self.length * d0, modulus * self.length * d0**2

    def _number(self, section, name, default=None):
        value = self._entries.get((section, name), default)
        try:
            return float(value)
        except (TypeError, ValueError):
            raise ValueError(f"{self._file}: {section} / {name} is {value}, expected a number in SI units") from None

    def _pass(self):
        """Sets the motion of a path that does not repeat; d0 is where it begins."""
        if self._entries.get(("Motion", "Path repeats")) != "once":
            raise ValueError(f"{self._file}: expected a path that repeats once")
        with open(pathlib.Path(self._file).parent / self._entries["Motion", "Path"], encoding="utf-8", newline="") as stream:
            head, unit, *rows = list(csv.reader(stream))
        if head != ["t", "d", "u_x"] or unit != ["s", "um", "um"]:
            raise ValueError(f"{self._file}: expected a path of t, d, u_x in s, um, um")
        time, depth, along = np.array(rows, float).T * [[1], [1e-6], [1e-6]]
        self.cycles, d0, tau = None, depth[0], time / time[-1]
        self.deepest = depth.max() / d0
        self.at = lambda at: (np.interp(at, tau, depth / d0), (np.interp(at, tau, along / d0), 0.0))
        return d0

    def _oscillation(self, cycles):
        """Sets a harmonic motion, which grows from nothing in its first cycle; d0 is its mean indentation."""
        frequencies = {value for (_, name), value in self._entries.items() if name.endswith("frequency")}
        if len(frequencies) != 1:
            raise ValueError(f"{self._file}: expected one frequency, not {' and '.join(sorted(frequencies))}")
        d0 = self._number("Motion", "Indentation")
        names = (f"{which} amplitude" for which in ("Normal", "Tangential", "Transverse"))
        normal, along, across = (self._number("Motion", name, 0) / d0 for name in names)
        phase, phase_across = (np.radians(self._number("Motion", name, 0)) for name in ("Phase", "Transverse phase"))
        self.cycles, self.deepest = cycles, 1 + normal

        def at(tau):
            angle, s = 2 * np.pi * tau, min(tau, 1)
            grown = s**3 * (10 - 15 * s + 6 * s * s)
            shift = along * np.cos(angle + phase), across * np.cos(angle + phase_across)
            return 1 + grown * normal * np.cos(angle), grown * np.array(shift)

        self.at = at
        return d0

    @property
    def width(self):
        """Of the square of elements, in a."""
        return 2 * MARGIN * np.sqrt(self.deepest)


class Course:
    """All steps of a scene on n x n elements. last: p, t and slip of each step of the last cycle, the state before it among them."""

    def __init__(self, scene, n, steps):
        self.contact = contact = Contact(n, scene.width, scene.nu, scene.mu, scene.coupled)
        contact.press(scene.at(0)[0])
        self.least_margin, self.touched = contact.margin(), contact.p
        cycle = None
        for number in range(scene.cycles or 1):
            before, cycle = cycle, [(contact.p, contact.t, contact.slip)]
            for k in range(1, steps + 1):
                contact.step(*scene.at(number + k / steps), self._guess(before, k))
                cycle.append((contact.p, contact.t, contact.slip))
                self.least_margin = np.minimum(self.least_margin, contact.margin())
                self.touched = np.maximum(self.touched, contact.p)
        self.last = cycle

    def _guess(self, before, k):
        """As this step changed things a cycle ago."""
        if before is None:
            return None
        (p_old, t_old, _), (p, t, _) = before[k - 1 : k + 1]
        return np.maximum(self.contact.p + p - p_old, 0), self.contact.t + t - t_old

    def slip_to_and_fro(self):
        """The way of slip in the last cycle less what it comes to in the end, which dies out from cycle to cycle (shakedown), in d0.

        Infinite where a point did not touch all the time.
        """
        slips = np.stack([slip for _, _, slip in self.last[1:]])
        always = np.min([p for p, _, _ in self.last], 0) > 0
        return np.where(always, np.hypot(slips[:, 0], slips[:, 1]).sum(0) - np.hypot(*slips.sum(0)), np.inf)

    def friction_work(self):
        """What friction loses in the last cycle, in G a d0^2: tractions at the end of a step on its slip, where there is contact."""
        return -sum((t * np.where(p > 0, slip, 0)).sum() for p, t, slip in self.last[1:]) * self.contact.h ** 2


def readings(scene, n, steps, counting):
    """{quantity of fretval: (value in SI units, error of its reading)}."""
    course = Course(scene, n, steps)
    contact, area = course.contact, course.contact.h ** 2

    def radius(where, bias):
        return (counted_radius(contact, where) - bias[0] * contact.h) * scene.length, bias[1] * contact.h * scene.length

    forces = np.array([[p.sum(), t[0].sum()] for p, t, _ in course.last]) * area * scene.force
    found = {"stick_radius_first_slip": radius(course.least_margin > SETTLED, counting.stick)}
    if scene.cycles:
        # Slip grows with the distance from the edge to the power 3/2: eight times the slip are four times as far.
        slip = course.slip_to_and_fro()
        (near, reading), (far, _) = (radius(slip < bound, counting.stick) for bound in (STICKS, 8 * STICKS))
        found["stick_radius_shakedown"] = near - (far - near) / 3, reading + (far - near) / 3
    found["contact_radius_max"] = radius(course.touched > SETTLED, counting.touch)
    found["normal_force_max"] = forces[:, 0].max(), 0
    found["tangential_force_max"] = abs(forces[:, 1]).max(), 0
    found["friction_work"] = course.friction_work() * scene.work, 0
    return found


def limit(fine, coarse_grid, fewer_steps):
    """(value, error) without elements and steps, from a (value, error of the reading) each on the fine grid with all steps, and with half
    as many steps on the fine grid and on one of half as many elements across.

    The correction of a grid is that of second order, with an error as large: it holds for any order above 1.3; that of steps is two thirds
    of the difference, with an error as large: any order above 0.8. Counted radii are corrected for their grid by `Counting` instead.
    """
    value, reading = fine
    steps = 2 / 3 * (value - fewer_steps[0])
    grid = 0 if reading else (fewer_steps[0] - coarse_grid[0]) / 3
    return value + steps + grid, abs(steps) + abs(grid) + reading
