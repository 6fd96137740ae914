#include "mdr/rheology/time_temperature.h"

#include <cmath>
#include <sstream>

#include "mdr/support/checks.h"

namespace fretval::mdr {

double wlf_shift(double c1, double c2, double reference_temperature, double temperature) {
  require_positive("WLF constant c1", c1);
  require_positive("WLF constant c2", c2);
  require_finite("reference temperature", reference_temperature);
  require_finite("temperature", temperature);
  const double above_pole = c2 + (temperature - reference_temperature);
  const double shift_factor = std::pow(10, -c1 * (temperature - reference_temperature) / above_pole);
  if (above_pole > 0 && std::isnormal(shift_factor)) return shift_factor;
  std::ostringstream valid;
  valid << "must be well above the pole of the WLF equation, " << reference_temperature - c2;
  reject("temperature", temperature, valid.str());
}

PronyBody shifted(const PronyBody& body, double shift_factor) {
  validate(body);
  require_positive("shift factor", shift_factor);
  PronyBody result = body;
  for (double& time : result.branch_times) time *= shift_factor;
  result.viscosity *= shift_factor;
  validate(result);
  return result;
}

FractionalZener shifted(const FractionalZener& body, double shift_factor) {
  validate(body);
  require_positive("shift factor", shift_factor);
  FractionalZener result = body;
  result.branch_time *= shift_factor;
  validate(result);
  return result;
}

Rheology shifted(const Rheology& body, double shift_factor) {
  return std::visit([shift_factor](const auto& b) -> Rheology { return shifted(b, shift_factor); }, body);
}

}  // namespace fretval::mdr
