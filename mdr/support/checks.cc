#include "mdr/support/checks.h"

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace fretval::mdr {

void reject(std::string_view quantity, double value, std::string_view valid) {
  std::ostringstream message;
  message.precision(15);
  message << quantity << " = " << value << ": " << valid;
  throw std::invalid_argument(message.str());
}

void require_positive(std::string_view quantity, double value) {
  if (!(std::isfinite(value) && value > 0)) reject(quantity, value, "must be finite and positive");
}

void require_non_negative(std::string_view quantity, double value) {
  if (!(std::isfinite(value) && value >= 0)) reject(quantity, value, "must be finite and not negative");
}

void require_within(std::string_view quantity, double value, double lower, double upper) {
  if (std::isfinite(value) && lower <= value && value <= upper) return;
  std::ostringstream valid;
  valid.precision(15);
  valid << "must lie between " << lower << " and " << upper;
  reject(quantity, value, valid.str());
}

void require_finite(std::string_view quantity, double value) {
  if (!std::isfinite(value)) reject(quantity, value, "must be finite");
}

}  // namespace fretval::mdr
