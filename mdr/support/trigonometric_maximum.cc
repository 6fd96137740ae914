#include "mdr/support/trigonometric_maximum.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>

#include "mdr/support/checks.h"
#include "mdr/support/constants.h"

namespace fretval::mdr {

namespace {

// Bounds are compared to this part of sum |a_k|; roundoff of an evaluation is well below it.
const double value_tolerance = 2e-14;

struct Component {
  double order;
  std::complex<double> amplitude;
};

// Real part of sum z_k e^(i n_k theta), one component for every order.
struct Polynomial {
  std::vector<Component> components;
  double size = 0;              // sum |a_k|
  double third_derivative = 0;  // bound of |P'''|
};

// P and its derivatives with respect to theta.
struct Jet {
  double value = 0;
  double slope = 0;
  double curvature = 0;
};

struct Candidate {
  double turn;  // theta/(2 pi)
  Jet jet;
};

struct Cell {
  double middle;  // in turns, like the half width
  double half_width;
  double bound;
};

Polynomial collect(const std::vector<TrigonometricTerm>& terms) {
  std::map<int, std::complex<double>> by_order;
  Polynomial polynomial;
  for (const TrigonometricTerm& term : terms) {
    require_finite("amplitude of a trigonometric term", term.amplitude);
    require_finite("phase of a trigonometric term", term.phase);
    require_non_negative("order of a trigonometric term", term.order);
    polynomial.size += std::abs(term.amplitude);
    by_order[term.order] += term.amplitude * std::complex<double>(std::cos(term.phase), std::sin(term.phase));
  }
  for (const auto& [order, amplitude] : by_order) {
    if (amplitude == 0.0) continue;
    const double n = order;
    polynomial.components.push_back({n, amplitude});
    polynomial.third_derivative += std::abs(amplitude) * n * n * n;
  }
  return polynomial;
}

Jet evaluate(const Polynomial& polynomial, double turn) {
  Jet jet;
  for (const auto& [n, z] : polynomial.components) {
    // The fraction of n turns to full accuracy: the rounding of n theta would cost n eps.
    const double turns = n * turn;
    const double fraction = (turns - std::round(turns)) + std::fma(n, turn, -turns);
    const double cosine = std::cos(2 * pi * fraction), sine = std::sin(2 * pi * fraction);
    const double real = z.real() * cosine - z.imag() * sine;
    jet.value += real;
    jet.slope -= n * (z.real() * sine + z.imag() * cosine);
    jet.curvature -= n * n * real;
  }
  return jet;
}

double upper_bound(const Polynomial& polynomial, const Jet& jet, double half_width) {
  const double h = 2 * pi * half_width;
  const double slope = std::abs(jet.slope);
  const double remainder = polynomial.third_derivative * h * h * h / 6;
  const bool vertex_inside = slope < -jet.curvature * h;
  const double quadratic = vertex_inside ? -slope * slope / (2 * jet.curvature) : h * (slope + jet.curvature * h / 2);
  return jet.value + quadratic + remainder;
}

Candidate polish(const Polynomial& polynomial, Candidate best) {
  while (best.jet.curvature < 0) {
    const double turn = best.turn - best.jet.slope / best.jet.curvature / (2 * pi);
    const Jet jet = evaluate(polynomial, turn);
    if (!(jet.value > best.jet.value)) break;
    best = {turn, jet};
  }
  return best;
}

// All cells of a uniform division, the best middle among them polished.
std::vector<Cell> divide(const Polynomial& polynomial, Candidate& best) {
  const int n_cells = 8 + 4 * static_cast<int>(polynomial.components.back().order);
  const double half_width = 0.5 / n_cells;
  std::vector<Cell> cells;
  cells.reserve(n_cells);
  for (int i = 0; i < n_cells; ++i) {
    const double middle = (2 * i + 1) * half_width;
    const Jet jet = evaluate(polynomial, middle);
    cells.push_back({middle, half_width, upper_bound(polynomial, jet, half_width)});
    if (i == 0 || jet.value > best.jet.value) best = {middle, jet};
  }
  best = polish(polynomial, best);
  return cells;
}

Candidate branch_and_bound(const Polynomial& polynomial) {
  const double tolerance = value_tolerance * polynomial.size;
  Candidate best{};
  std::vector<Cell> cells = divide(polynomial, best);
  while (!cells.empty()) {
    const Cell cell = cells.back();
    cells.pop_back();
    if (cell.bound <= best.jet.value + tolerance) continue;
    const double half_width = cell.half_width / 2;
    for (const double middle : {cell.middle - half_width, cell.middle + half_width}) {
      const Jet jet = evaluate(polynomial, middle);
      if (jet.value > best.jet.value) best = polish(polynomial, {middle, jet});
      const double bound = upper_bound(polynomial, jet, half_width);
      if (bound > best.jet.value + tolerance) cells.push_back({middle, half_width, bound});
    }
  }
  return best;
}

}  // namespace

TrigonometricMaximum trigonometric_maximum(const std::vector<TrigonometricTerm>& terms) {
  const Polynomial polynomial = collect(terms);
  const auto& components = polynomial.components;
  if (components.empty()) return {0, 0};
  const double constant = components.front().order == 0 ? components.front().amplitude.real() : 0;
  if (components.back().order == 0) return {constant, 0};
  double turn = -std::arg(components.back().amplitude) / (2 * pi * components.back().order);
  double value = constant + std::abs(components.back().amplitude);
  const bool oscillates_at_one_order = components.size() == (components.front().order == 0 ? 2 : 1);
  if (!oscillates_at_one_order) {
    const Candidate best = branch_and_bound(polynomial);
    turn = best.turn;
    value = best.jet.value;
  }
  return {value, 2 * pi * (turn - std::floor(turn))};
}

}  // namespace fretval::mdr
