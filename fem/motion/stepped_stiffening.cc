#include "fem/motion/stepped_stiffening.h"

namespace fretval::fem {

std::complex<double> stepped_stiffening_at(const RelaxationModel& relaxation, double omega, double dt) {
  const double fraction = RelaxationStep(relaxation, dt).fraction();
  const PronyInterval whole(relaxation, dt), to_balance(relaxation, fraction * dt);
  const auto turned = [&](double share) { return std::polar(1.0, share * omega * dt); };
  const std::complex<double> move = turned(1) - 1.0;
  std::complex<double> response = relaxation.relaxed * (1.0 + fraction * move) + relaxation.viscosity / dt * move;
  for (std::size_t i = 0; i < whole.n_branches(); ++i) {
    const std::complex<double> memory = whole.gain(i) * move / (turned(1) - whole.decay(i));
    response += to_balance.decay(i) * memory + to_balance.gain(i) * fraction * move;
  }
  return response / turned(fraction) / relaxation.relaxed;
}

}  // namespace fretval::fem
