"""Boundary elements for a rigid indenter on an elastic half-space with Coulomb friction as a vector: a second method for the full contact.

Square elements with constant tractions. Units: shear modulus G = 1, lengths along the surface in a = sqrt(R d0), displacements in d0, so
that tractions are in G d0/a, forces in G a d0 and energies in G a d0^2, and a parabola is r^2/2. z points into the body; p is the
pressure, t = (t_x, t_y) the traction on the body. Arrays of the surface are n x n, x along the first axis; vectors have their component
before that, (2, n, n).

Sources: A. E. H. Love, Phil. Trans. R. Soc. A 228 (1929) 377 (pressure on a rectangle); V. Cerruti (1882), in K. L. Johnson, Contact
Mechanics, Cambridge 1985, sections 3.2 and 3.6 (tangential point force); A. Beck and M. Teboulle, SIAM J. Imaging Sci. 2 (2009) 183 (the
accelerated projected gradients).
"""

import numpy as np

SETTLED = 1e-3  # of tractions in G d0/a: what exceeds it is not left over by the solvers


def _over_element(antiderivative, x, y, h):
    """The integral over the square of side h around (x, y), of what has this antiderivative in x and y."""
    return sum(i * j * antiderivative(x + i * h / 2, y + j * h / 2) for i in (1, -1) for j in (1, -1))


def _inverse(x, y):
    """Of 1/rho."""
    return x * np.log(y + np.hypot(x, y)) + y * np.log(x + np.hypot(x, y))


def _square(x, y):
    """Of x^2/rho^3."""
    return y * np.log(x + np.hypot(x, y))


def _product(x, y):
    """Of x y/rho^3."""
    return -np.hypot(x, y)


def _first(x, y):
    """Of x/rho^2."""
    return 0.5 * y * np.log(x * x + y * y) + x * np.arctan(y / x)


class HalfSpace:
    """Displacements of the centres of n x n elements of side h from their tractions, as convolutions by FFT over twice the grid.

    A unit point force at the origin displaces (rho^2 = x^2 + y^2)
        across: u_z = (1-nu)/(2 pi rho),  u_x = -(1-2nu)/(4 pi) x/rho^2,
        along x: u_x = ((1-nu)/rho + nu x^2/rho^3)/(2 pi),  u_y = nu x y/rho^3/(2 pi),  u_z = (1-2nu)/(4 pi) x/rho^2.
    """

    def __init__(self, n, h, nu):
        self.n = n
        i = np.fft.fftfreq(2 * n, 1 / (2 * n)) * h
        x, y = i[:, None], i[None, :]

        def kernel(antiderivative):
            return np.fft.rfft2(_over_element(antiderivative, x, y, h))

        def turned(antiderivative):
            return kernel(lambda a, b: antiderivative(b, a))

        inverse = kernel(_inverse) / (2 * np.pi)
        self._zz = (1 - nu) * inverse
        self._xx = (1 - nu) * inverse + nu / (2 * np.pi) * kernel(_square)
        self._yy = (1 - nu) * inverse + nu / (2 * np.pi) * turned(_square)
        self._xy = nu / (2 * np.pi) * kernel(_product)
        self._zx = (1 - 2 * nu) / (4 * np.pi) * kernel(_first)
        self._zy = (1 - 2 * nu) / (4 * np.pi) * turned(_first)

    def _forward(self, values):
        """Half of the rows are zero, and are not transformed."""
        return np.fft.fft(np.fft.rfft(values, 2 * self.n), 2 * self.n, axis=-2)

    def _back(self, values):
        return np.fft.irfft(np.fft.ifft(values, axis=-2)[..., : self.n, :], 2 * self.n)[..., : self.n]

    def sinking_by_pressure(self, p):
        """u_z of p."""
        return self._back(self._zz * self._forward(p))

    def shift_by_traction(self, t):
        """(u_x, u_y) of t."""
        x, y = self._forward(t)
        return self._back(np.stack([self._xx * x + self._xy * y, self._xy * x + self._yy * y]))

    def shift_by_pressure(self, p):
        """(u_x, u_y) of p; zero for nu = 1/2."""
        p = self._forward(p)
        return self._back(np.stack([-self._zx * p, -self._zy * p]))

    def sinking_by_traction(self, t):
        """u_z of t; zero for nu = 1/2."""
        x, y = self._forward(t)
        return self._back(self._zx * x + self._zy * y)


def _largest_eigenvalue(operator, shape):
    """By 30 power iterations, with 2 % on top."""
    x = np.random.default_rng(1).standard_normal(shape)
    for _ in range(30):
        x = operator(x)
        size = np.linalg.norm(x)
        x /= size
    return 1.02 * size


def minimise(operator, b, project, x, eigenvalue, tolerance):
    """The minimum of x.Ax/2 - b.x over a convex set, and its gradient; by accelerated projected gradients with restarts.

    project: the nearest point of the set; eigenvalue: not below the largest of A. Ends where the largest entry of the projected gradient,
    which is a displacement, is below the tolerance. Raises RuntimeError where 20,000 iterations do not get there.
    """
    x = project(x)
    gradient = operator(x) - b
    y, gradient_y, theta = x, gradient, 1.0
    for _ in range(20000):
        x_new = project(y - gradient_y / eigenvalue)
        gradient_new = operator(x_new) - b
        residual = np.abs(x_new - project(x_new - gradient_new / eigenvalue)).max() * eigenvalue
        if residual < tolerance:
            return x_new, gradient_new
        if np.vdot(y - x_new, x_new - x) > 0:
            y, gradient_y, theta = x_new, gradient_new, 1.0
        else:
            theta_new = (1 + np.sqrt(1 + 4 * theta * theta)) / 2
            ahead = (theta - 1) / theta_new
            y, gradient_y, theta = x_new + ahead * (x_new - x), gradient_new + ahead * (gradient_new - gradient), theta_new
        x, gradient = x_new, gradient_new
    raise RuntimeError(f"projected gradients end at a residual of {residual:.1e}, above {tolerance:.1e}")


def _onto_discs(limit):
    """Projection onto |t| <= limit at each point."""
    return lambda t: t * np.minimum(1, limit / np.maximum(np.hypot(*t), 1e-30))


class Contact:
    """A rigid indenter on n x n elements, moved step by step.

    width    of the square of elements; what touches lies within
    coupled  pressures displace along the surface, and tractions across it
    profile  height over r; a parabola where it is not given
    After `press` and each `step`: p, t, and slip, the displacement of the body relative to the indenter in this step, (2, n, n).
    residual: the largest change of a displacement that pressures and tractions were still asking of each other.
    The axis stands beside the centres of elements and the lines between, so that edges do not pass many elements at once.
    """

    def __init__(self, n, width, nu, mu, coupled=False, tolerance=1e-6, profile=None):
        self.h = width / n
        self.x = (np.arange(n) - (n - 1) / 2 + 0.21) * self.h
        self.y = (np.arange(n) - (n - 1) / 2 + 0.37) * self.h
        self.r = np.hypot(self.x[:, None], self.y[None, :])
        self.f = self.r**2 / 2 if profile is None else profile(self.r)
        self.mu, self.coupled, self.tolerance = mu, coupled and nu < 0.5, tolerance
        self.body = HalfSpace(n, self.h, nu)
        self._largest_normal = _largest_eigenvalue(self.body.sinking_by_pressure, (n, n))
        self._largest_tangential = _largest_eigenvalue(self.body.shift_by_traction, (2, n, n))
        self.p, self.t, self.slip = np.zeros((n, n)), np.zeros((2, n, n)), np.zeros((2, n, n))
        self.at, self.residual = np.zeros(2), 0.0

    def _pressure(self, d, sunk, guess, tolerance):
        operator, asked = self.body.sinking_by_pressure, d - self.f - sunk
        return minimise(operator, asked, lambda p: np.maximum(p, 0), guess, self._largest_normal, tolerance)[0]

    def _friction(self, limit, asked, guess, tolerance):
        return minimise(self.body.shift_by_traction, asked, _onto_discs(limit), guess, self._largest_tangential, tolerance)

    def press(self, d):
        """To the indentation d without friction."""
        self.p = self._pressure(d, 0, self.p, self.tolerance)

    def step(self, d, at, guess=None):
        """To the indentation d and the displacement at = (u_x, u_y). guess: p and t to begin with."""
        body, tolerance = self.body, self.tolerance
        at = np.asarray(at, float)
        asked = body.shift_by_traction(self.t) + (at - self.at)[:, None, None]
        p, t = guess or (self.p, self.t)
        if not self.coupled:
            p = self._pressure(d, 0, p, tolerance)
            t, slip = self._friction(self.mu * p, asked, t, tolerance)
        else:
            asked = asked + body.shift_by_pressure(self.p)
            p, t, slip = self._in_turn(d, asked, p, t)
        self.p, self.t, self.slip, self.at = p, t, slip, at

    def _in_turn(self, d, asked, p, t):
        """Pressure and friction in turn, at first to a tenth of what they still change of each other."""
        change = 1e-3
        for _ in range(60):
            tolerance = max(self.tolerance, 0.1 * change)
            p = self._pressure(d, self.body.sinking_by_traction(t), p, tolerance)
            t_new, slip = self._friction(self.mu * p, asked - self.body.shift_by_pressure(p), t, tolerance)
            change = np.abs(self.body.sinking_by_traction(t_new - t)).max()
            t = t_new
            if change < self.tolerance and tolerance == self.tolerance:
                self.residual = max(self.residual, change)
                return p, t, slip
        raise RuntimeError(f"pressure and friction still change each other by {change:.1e} d0")

    def forces(self):
        """(F_x, F_y, F_N) in G a d0."""
        return np.array([*self.t.sum((1, 2)), self.p.sum()]) * self.h**2

    def margin(self):
        """mu p - |t|: positive where a point touches and sticks."""
        return np.maximum(self.mu * self.p - np.hypot(*self.t), 0)


def counted_radius(contact, where):
    """The radius of the disc with as many elements as there are where this holds. It is too large by about h/9: `Counting`."""
    return np.sqrt(where.sum() / np.pi) * contact.h


class Counting:
    """By how much counted radii are off on a grid, in its h: (mean, two standard deviations) for sticking zones and for contacts.

    Measured on what is known in closed form: Cattaneo's stick zones, u_x = mu (1 - c^2) for nu = 0, where they hold for friction as a
    vector too, and Hertz' contacts, a = sqrt(d).
    """

    def __init__(self, n, width):
        stick, touch = [], []
        for c in np.linspace(0.5, 0.85, 15):
            contact = Contact(n, width, nu=0.0, mu=0.5, tolerance=1e-5)
            contact.press(c**2)
            touch.append((counted_radius(contact, contact.p > SETTLED) - c) / contact.h)
            contact.press(1.0)
            contact.step(1.0, (0.5 * (1 - c**2), 0.0))
            stick.append((counted_radius(contact, contact.margin() > SETTLED) - c) / contact.h)
        self.stick = np.mean(stick), 2 * np.std(stick)
        self.touch = np.mean(touch), 2 * np.std(touch)
