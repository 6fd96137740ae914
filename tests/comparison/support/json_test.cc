#include "comparison/support/json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace fretval {
namespace {

TEST(OrNull, IsNullForWhatIsAbsentOrNotFiniteAndNeverForZero) {
  const double none = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  for (const auto& absent : {or_null(none), or_null(-infinite), or_null(std::optional<double>()),
                             or_null(std::optional(none)), or_null(std::optional<int>()), or_null(std::string())})
    EXPECT_TRUE(absent.is_null());
  EXPECT_EQ(or_null(0.0), 0.0);
  EXPECT_EQ(or_null(std::optional(0.0)), 0.0);
  EXPECT_EQ(or_null(std::optional(0)), 0);
  EXPECT_EQ(or_null(std::string("text")), "text");
}

TEST(NumberIn, IsThatOfAKeyOrNone) {
  const nlohmann::ordered_json object{{"zero", 0}, {"null", nullptr}, {"text", "1"}};
  EXPECT_EQ(number_in(object, "zero"), 0);
  for (const char* none : {"null", "text", "absent"}) {
    EXPECT_EQ(number_in(object, none), std::nullopt) << none;
    EXPECT_TRUE(std::isnan(number_or_nan(object, none))) << none;
  }
}

}  // namespace
}  // namespace fretval
