"""The stick radius of a flat punch that is pressed with friction, by rings of constant traction whose kernels are integrated exactly.

In frictional pressing the state is the same at every depth, and a flat punch has the stick radius c/a of every power law. Units: a = 1,
shear modulus 1. Sources: D. A. Spence, Proc. R. Soc. A 305 (1968) 55 and J. Elasticity 5 (1975) 297; K. L. Johnson, Contact
Mechanics, Cambridge 1985, sections 3.8 and 5.4.
"""

import numpy as np


def elliptic(m1):
    """The complete elliptic integrals (K, E) of the parameter m = 1 - m1, by the arithmetic-geometric mean."""
    a, b = np.ones_like(m1), np.sqrt(np.maximum(m1, 1e-300))
    total, power = (1 - m1) / 2, 1.0
    for _ in range(12):
        c = (a - b) / 2
        a, b = (a + b) / 2, np.sqrt(a * b)
        total, power = total + power * c * c, 2 * power
    k = np.pi / (2 * a)
    return k, k * (1 - total)


def _potential(r, radius):
    """The integral of 1/rho over a disc, at the distance r from its centre."""
    ratio = (np.minimum(r, radius) / np.maximum(r, radius)) ** 2
    k, e = elliptic(1 - ratio)
    return np.where(r < radius, 4 * radius * e, 4 * r * (e - (1 - ratio) * k))


def _radial_kernel(r, s):
    """The integral of J1(k r) J1(k s) over k: u_r at r of a radial traction 1 on the line r = s, over 1 - nu and s."""
    m1 = ((r - s) / (r + s)) ** 2
    k, e = elliptic(m1)
    return 2 / (np.pi * (r + s)) * ((1 + m1) * k - 2 * e) / (1 - m1)


def _radial(r, edges):
    """u_r at r of unit radial tractions on rings, over 1 - nu: by Gauss' rule, on pieces that shrink towards the singularity at s = r."""
    nodes, weights = np.polynomial.legendre.leggauss(12)
    shrink = np.append(0.15 ** np.arange(9), 0)

    def integral(low, high, at):
        s = (low + high)[..., None] / 2 + (high - low)[..., None] / 2 * nodes
        return ((high - low)[..., None] / 2 * weights * s * _radial_kernel(at[..., None], s)).sum(-1)

    n = len(r)
    low, high = np.broadcast_to(edges[:-1], (n, n)).copy(), np.broadcast_to(edges[1:], (n, n)).copy()
    result = np.zeros((n, n))
    for piece in np.linspace(0, 1, 5)[:-1]:  # four pieces are plenty beside the singularity
        result += integral(low + piece * (high - low), low + (piece + 0.25) * (high - low), np.broadcast_to(r[:, None], (n, n)))
    own = np.zeros(n)
    for outer, inner in zip(shrink[:-1], shrink[1:]):
        own += integral(r - outer * (r - edges[:-1]), r - inner * (r - edges[:-1]), r)
        own += integral(r + inner * (edges[1:] - r), r + outer * (edges[1:] - r), r)
    result[np.diag_indices(n)] = own
    return result


def stick_radius(nu, mu, n, sinks=True):
    """c/a by n rings, finer towards the rim. sinks: tractions act on pressures too; without, Spence's approximation (`one_way`).

    c is where the traction of the outermost ring that sticks reaches the limit: beyond the true one it exceeds it.
    """
    edges = np.sin(np.linspace(0, np.pi / 2, n + 1))
    r = (edges[1:] + edges[:-1]) / 2
    inner = np.where(edges[:-1] > 0, _potential(r[:, None], np.maximum(edges[:-1], 1e-9)), 0)
    sinking = (1 - nu) / (2 * np.pi) * (_potential(r[:, None], edges[1:]) - inner)
    shift = (1 - nu) * _radial(r, edges)
    # Across: u_r = -k/r times the integral of p s up to r, u_z = -k times the integral of the traction beyond r; k = (1 - 2 nu)/2.
    k = (1 - 2 * nu) / 2
    areas = np.clip(r[:, None] ** 2 - edges[:-1] ** 2, 0, edges[1:] ** 2 - edges[:-1] ** 2) / 2
    shift_by_pressure = -k * areas / r[:, None]
    sinking_by_traction = -k * np.clip(edges[1:] - r[:, None], 0, edges[1:] - edges[:-1]) * sinks
    room_before = None
    for c in range(max(n // 10, 2), n):
        slips = np.zeros((n, n))
        slips[:, c:] = mu
        matrix = np.block([[sinking + sinking_by_traction * slips, sinking_by_traction[:, :c]],
                           [(shift_by_pressure + shift * slips)[:c], shift[:c, :c]]])
        solution = np.linalg.solve(matrix, np.append(np.ones(n), np.zeros(c)))
        room = mu - solution[n + c - 1] / solution[c - 1]
        if room < 0 and room_before is not None:
            return edges[c - 1] + (edges[c] - edges[c - 1]) * room_before / (room_before - room)
        room_before = room
    raise ValueError(f"{n} rings do not resolve a stick radius for nu = {nu}, mu = {mu}")


def one_way(nu, mu):
    """Spence's c/a where tractions do not act on pressures: ln((1+c)/(1-c))/(2 c) = mu/beta K(1 - c^2), beta = (1-2nu)/(2(1-nu))."""
    beta = (1 - 2 * nu) / (2 * (1 - nu))
    low, high = 1e-6, 1 - 1e-12
    for _ in range(60):
        c = (low + high) / 2
        is_below = np.log((1 + c) / (1 - c)) / (2 * c) < mu / beta * elliptic(np.asarray(c * c))[0]
        low, high = (c, high) if is_below else (low, c)
    return c
