#include "comparison/reference/mdr_document.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "comparison/case_file/case_file.h"
#include "comparison/reference/mdr_case.h"
#include "comparison/support/constants.h"
#include "mdr/stick/stick_radius.h"
#include "tests/comparison/modulus_table.h"
#include "tests/comparison/read_case.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

ordered_json document_of(const std::string& text, bool with_springs = false) {
  const ScratchFolder folder;
  return mdr_document(read_case_file(folder.write("one.prm", text)).at(0), with_springs).json;
}

double number(const ordered_json& json, const char* section, const char* key) {
  return json.at(section).at(key).get<double>();
}

const std::string displacements = "set Indentation = 1e-4\n  set Normal amplitude = 2e-5";

// The worn state found from its displacements carries forces; prescribing these gives the state back.
TEST(MdrDocument, PrescribedForcesGiveBackTheStateOfTheirDisplacements) {
  const std::string first =
      replace(replace(valid_case, displacements, "set Normal force = 0.5\n  set Normal force amplitude = 0.1"),
              "set Tangential amplitude = 1.5e-5", "set Tangential force amplitude = 0.05");
  const auto under_forces = document_of(first);
  const auto& state = under_forces.at("limiting_state").at("shakedown");
  EXPECT_NEAR(state.at("normal_force_mean").get<double>(), 0.5, 1e-12);
  const auto text = [&](const char* key) { return std::to_string(1e6 * state.at(key).get<double>()) + "e-6"; };
  const auto back = document_of(replace(
      replace(valid_case, displacements,
              "set Indentation = " + text("indentation") + "\n  set Normal amplitude = " + text("normal_amplitude")),
      "1.5e-5", text("tangential_amplitude")));
  // Six decimals of a micrometre are printed.
  EXPECT_NEAR(number(back, "mdr", "stick_radius_shakedown") / state.at("stick_radius").get<double>(), 1, 1e-6);
}

// In two directions forces have no limiting state in closed form: springs say what the unworn contact does.
TEST(MdrDocument, OfForcesInTwoDirectionsIsThatOfTheUnwornContact) {
  const auto around = document_of(replace(valid_case, "set Tangential amplitude = 1.5e-5",
                                          "set Tangential force amplitude = 0.05\n  set Transverse force amplitude = "
                                          "0.05\n  set Transverse phase = 0") +
                                  "subsection Contact\n  set Friction = vector\nend\n");
  EXPECT_FALSE(around.contains("limiting_state"));
  EXPECT_NEAR(number(around, "mdr", "contact_radius_max"), std::sqrt(1e-2 * 1.2e-4), 1e-9);
  EXPECT_GT(number(around, "mdr", "tangential_amplitude"), 1e-6);
}

TEST(MdrDocument, SaysThatNothingSticksUnderTooMuchTangentialForce) {
  const auto json = document_of(
      replace(replace(valid_case, displacements, "set Normal force = 0.5\n  set Normal force amplitude = 0.1"),
              "set Tangential amplitude = 1.5e-5", "set Tangential force amplitude = 5"));
  EXPECT_TRUE(json.at("mdr").at("stick_radius_shakedown").is_null());
  EXPECT_TRUE(json.at("limiting_profile").is_null());
}

// Two ways that share neither formula nor code: the maxima over the common period, and springs stepped in time.
TEST(MdrDocument, SpringsConfirmTheStickRadiiOfTwoFrequencies) {
  const auto json = document_of(replace(replace(valid_case, "Tangential frequency = 1", "Tangential frequency = 2"),
                                        "Phase = 60", "Phase = 60\n  set Normal harmonics = 5e-6, 2, 30"),
                                true);
  for (const char* key : {"stick_radius_first_slip", "stick_radius_shakedown"})
    EXPECT_NEAR(number(json, "springs", key) / number(json, "mdr", key), 1, 1e-5) << key;  // ramp and time step
  EXPECT_LT(number(json, "mdr", "stick_radius_first_slip"), number(json, "mdr", "stick_radius_shakedown"));
  double deepest = 0;
  for (double turn = 0; turn < 2 * pi; turn += 1e-4)
    deepest = std::max(deepest, 1e-4 + 2e-5 * std::cos(turn) + 5e-6 * std::cos(2 * turn + pi / 6));
  EXPECT_NEAR(number(json, "mdr", "contact_radius_max") / std::sqrt(1e-2 * deepest), 1, 1e-8);
  EXPECT_NEAR(number(json, "springs", "normal_force_max") / number(json, "mdr", "normal_force_max"), 1, 1e-5);
}

TEST(MdrDocumentSlow, SpringsConfirmTheStickRadiiOfAnyFrequencyRatio) {
  for (const char* frequency : {"1e-3", "1e-2", "0.5", "1e2", "1e3"}) {
    const auto input = read_case(
        replace(elastic_case(), "Tangential frequency = 1", std::string("Tangential frequency = ") + frequency));
    const auto profile = profile_of(input.indenter);
    const auto exact =
        mdr::stick_depths(rheology_of(input.elastomer), input.friction_coefficient, harmonic_motion_of(input.motion));
    const auto springs = spring_answer(input, {100, 48, 4, 1e-7}).history.depths;
    for (const auto depth : {&mdr::StickDepths::first_slip, &mdr::StickDepths::shakedown}) {
      const auto radius = [&](const mdr::StickDepths& depths) {
        return mdr::inverse_transform(profile, depths.*depth);
      };
      EXPECT_NEAR(radius(springs) / radius(exact), 1, 1e-2) << frequency;
    }
  }
}

// An elastic body does not know how fast it is moved: springs have the same ramp in cycles at any frequency.
TEST(MdrDocument, SpringsOfAnElasticBodyAreTheSameAtAnyFrequency) {
  const auto at = [](double frequency) {
    auto input = read_case(elastic_case());
    input.motion.normal_frequency = input.motion.tangential_frequency = frequency;
    return spring_answer(input, {100, 48, 4, 1e-7}).history;
  };
  const auto slow = at(1), fast = at(128);
  EXPECT_NEAR(fast.depths.first_slip / slow.depths.first_slip, 1, 1e-9);
  EXPECT_NEAR(fast.friction_work / slow.friction_work, 1, 1e-9);
  EXPECT_EQ(fast.n_periods, slow.n_periods);
}

// Springs under the forces themselves, whose indenter goes where it has to, against the two tangents.
TEST(MdrDocument, SpringsConfirmTheStickRadiusUnderForces) {
  const auto json = document_of(
      replace(replace(valid_case, displacements, "set Normal force = 0.5\n  set Normal force amplitude = 0.1"),
              "set Tangential amplitude = 1.5e-5", "set Tangential force amplitude = 0.05"),
      true);
  EXPECT_NEAR(number(json, "springs", "stick_radius_shakedown") / number(json, "mdr", "stick_radius_shakedown"), 1,
              1e-3);
  EXPECT_NEAR(number(json, "springs", "normal_force_max"), 0.6, 1e-6);
  EXPECT_TRUE(json.at("springs").at("difference_first_slip").is_null());
  EXPECT_TRUE(json.at("springs").at("warnings").empty());
}

std::string with_poisson_ratio(const std::string& text, const char* nu) {
  return replace(text, "set Rheology", std::string("set Poisson ratio = ") + nu + "\n  set Rheology");
}

// The worn contact is a punch of radius c: F_N = 4 G c d/(1 - nu), F_x = 8 G c u_x/(2 - nu).
TEST(MdrDocument, OfForcesOnACompressibleBodyHasItsDisplacements) {
  const auto text =
      replace(replace(elastic_case(), displacements, "set Normal force = 0.5\n  set Normal force amplitude = 0.1"),
              "set Tangential amplitude = 1.5e-5", "set Tangential force amplitude = 0.05");
  for (const auto& [nu, ratio] : {std::pair{"0", 0.0}, {"0.3", 0.3}, {"0.5", 0.5}}) {
    const auto state = document_of(with_poisson_ratio(text, nu)).at("limiting_state").at("shakedown");
    const double c = state.at("stick_radius"), G = 1e6;
    EXPECT_NEAR(state.at("tangential_amplitude").get<double>() / (0.05 * (2 - ratio) / (8 * G * c)), 1, 1e-9) << nu;
    EXPECT_NEAR(state.at("normal_amplitude").get<double>() / (0.1 * (1 - ratio) / (4 * G * c)), 1, 1e-9) << nu;
  }
}

// Forces and works by springs against those of the answer, which are held to closed forms in incompressible_case_test.
TEST(MdrDocument, SpringsOfACompressibleBodyHaveItsWorks) {
  const auto json = document_of(with_poisson_ratio(valid_case, "0.3"), true);
  for (const char* key : {"friction_work", "bulk_work", "normal_force_max", "stick_radius_shakedown"})
    EXPECT_NEAR(number(json, "springs", key) / number(json, "mdr", key), 1, 1e-2) << key;
  EXPECT_NEAR(number(json, "springs", "indenter_work") /
                  (number(json, "mdr", "friction_work") + number(json, "mdr", "bulk_work")),
              1, 1e-2);
}

// Tables of `fretval trade` had those of a half-space, half of the force off.
TEST(MdrDocument, HasNoSpringsForALayer) {
  auto input = read_case(elastic_case());
  EXPECT_EQ(why_no_springs(input), "");
  input.body.shape = Case::Body::Shape::layer;
  input.body.thickness = 3e-3;
  EXPECT_NE(why_no_springs(input), "");
  EXPECT_NO_THROW(mdr_document(input, false));
  EXPECT_THROW(mdr_document(input, true), InputError);
  EXPECT_THROW(spring_answer(input), InputError);
}

TEST(MdrDocument, HasNoSpringsOfOneDirectionForAMotionInTwo) {
  const auto around =
      replace(valid_case, "set Tangential amplitude = 1.5e-5",
              "set Tangential amplitude = 1.5e-5\n  set Transverse amplitude = 1.5e-5\n  set Transverse "
              "phase = 0") +
      "subsection Contact\n  set Friction = vector\nend\n";
  EXPECT_NO_THROW(document_of(around));
  EXPECT_THROW(document_of(around, true), InputError);
}

const std::string forces = "set Normal force = 0.5\n  set Normal force amplitude = 0.1";

// Under two forces of any frequencies c bears F0 - (M+ + M-)/2 (tests/mdr/stick/limiting_motion_test.cc); elastic, with
// 2 Hz against 1 Hz in phase: M+- = max(+-Q cos 2t - dF cos t).
TEST(MdrDocument, OfForcesOfTwoFrequenciesHasTheStateOfShakedown) {
  auto text = replace(replace(elastic_case(), displacements, forces), "Tangential amplitude = 1.5e-5",
                      "Tangential force amplitude = 0.05");
  text = replace(replace(text, "Phase = 60", "Phase = 0"), "Tangential frequency = 1", "Tangential frequency = 2");
  const auto json = document_of(text);
  double forward = 0, backward = 0;
  for (int i = 0; i < 100000; ++i) {
    const double t = 2 * std::acos(-1.0) * i / 100000, q = 0.05 / 0.5 * std::cos(2 * t), f = 0.1 * std::cos(t);
    forward = std::max(forward, q - f);
    backward = std::max(backward, -q - f);
  }
  const double G = 1e6, R = 1e-2, c = std::cbrt(3 * (0.5 - (forward + backward) / 2) * R / (16 * G));
  EXPECT_NEAR(json.at("limiting_state").at("shakedown").at("stick_radius").get<double>() / c, 1, 1e-8);
  const double first = json.at("limiting_state").at("first_slip").at("stick_radius"),
               most = 0.5 - std::max(forward, backward);
  EXPECT_NEAR(first / std::cbrt(3 * most * R / (16 * G)), 1, 1e-8);
  EXPECT_NEAR(json.at("mdr").at("normal_force_max"), 0.6, 1e-12);
  EXPECT_NEAR(json.at("mdr").at("stick_radius_shakedown").get<double>() / c, 1, 1e-8);
}

// The worn contact is a flat one of radius c: F = 8 G (c d - c^3/(3 R)), dF = 8 G c dd, T = (16/3) G c u. The phase
// between the displacements is that of the forces.
TEST(MdrDocument, LimitingStateHasTheForcesOfAFlatContact) {
  const auto json = document_of(replace(replace(elastic_case(), displacements, forces), "Tangential amplitude = 1.5e-5",
                                        "Tangential force amplitude = 0.05"));
  for (const char* criterion : {"first_slip", "shakedown"}) {
    const auto& state = json.at("limiting_state").at(criterion);
    const double c = state.at("stick_radius"), G = 1e6, R = 1e-2;
    EXPECT_NEAR(state.at("indentation"), 0.5 / (8 * G * c) + c * c / (3 * R), 1e-12);
    EXPECT_NEAR(state.at("normal_amplitude"), 0.1 / (8 * G * c), 1e-12);
    EXPECT_NEAR(state.at("tangential_amplitude"), 0.05 * 3 / (16 * G * c), 1e-12);
    EXPECT_NEAR(state.at("phase"), 60, 1e-9);
    EXPECT_NEAR(state.at("normal_force_mean"), 0.5, 1e-12);
    EXPECT_NEAR(state.at("normal_force_amplitude"), 0.1, 1e-12);
    EXPECT_NEAR(state.at("tangential_force_amplitude"), 0.05, 1e-12);
  }
  EXPECT_NEAR(number(json, "mdr", "normal_force_max"), 0.6, 1e-12);
}

// Mindlin and Deresiewicz at constant d: T = mu F [1 - (1 - u/u_s)^(3/2)] with u_s = 3/2 mu d, and over a cycle of
// amplitude U the loop of Masing, 8 int_0^U T du - 4 U T(U). An elastic bulk keeps nothing.
TEST(MdrDocument, SpringsKnowWhereTheWorkGoes) {
  const auto elastic = document_of(replace(elastic_case(), "amplitude = 2e-5", "amplitude = 0"), true);
  const double G = 1e6, R = 1e-2, d = 1e-4, mu = 0.5, U = 1.5e-5, limit = 1.5 * mu * d, left = 1 - U / limit,
               force = mu * 16. / 3 * G * std::sqrt(R) * std::pow(d, 1.5), end = force * (1 - std::pow(left, 1.5)),
               area = force * (U - 0.4 * limit * (1 - std::pow(left, 2.5))), loop = 8 * area - 4 * U * end;
  EXPECT_NEAR(number(elastic, "springs", "friction_work"), loop, 1e-2 * loop);
  EXPECT_NEAR(number(elastic, "springs", "bulk_work"), 0, 1e-9 * loop);
  EXPECT_NEAR(number(elastic, "springs", "indenter_work"), loop, 1e-2 * loop);
}

TEST(MdrDocument, HasTheFitOfMeasuredModuli) {
  auto input = read_case();
  input.elastomer.master_curve =
      Case::MasterCurve{"dma.csv", {1, 2}, {3, 4}, {1, 1}, 0.01, 0.02, 0.03, 4, {{{}, {}, {}, 0.05, 6, 0, true}}};
  EXPECT_EQ(mdr_document(input, false).json.at("elastomer"), ordered_json::parse(R"({
    "table": "dma.csv", "frequencies": 2, "relaxed_modulus": 1e6, "branch_moduli": [1e6], "branch_times": [0.1],
    "residual": 0.01, "held_out": 0.02, "worst": 0.03, "worst_frequency": 4.0,
    "kramers_kronig": {"consistent": true, "worst": 0.05, "worst_frequency": 6.0}})"));
}

// Every relation of the phases comes by, in the springs as in the closed form.
TEST(MdrDocument, SpringsDoWithoutAPeriod) {
  for (const auto& text : {replace(valid_case, "Tangential frequency = 1", "Tangential frequency = 1.4142135623"),
                           replace(valid_case, "Phase = 60", "Phase = free")}) {
    const auto json = document_of(text, true);
    for (const char* key : {"stick_radius_first_slip", "stick_radius_shakedown"})
      EXPECT_NEAR(number(json, "springs", key) / number(json, "mdr", key), 1, 5e-3) << key;
  }
}

TEST(MdrDocument, SpringsNeedAnUnwornIndenter) {
  const auto limiting = replace(valid_case, "1.5e-5", "shakedown") +
                        "subsection Wear\n  set State = limiting\n  set Stick radius ratio = 0.5\nend\n";
  EXPECT_GT(number(document_of(limiting), "mdr", "stick_radius_shakedown"), 0);
  EXPECT_THROW(document_of(limiting, true), InputError);
}

TEST(MdrDocument, FractionalBodyOfOrderOneIsTheStandardSolid) {
  const auto solid = document_of(valid_case);
  const auto fractional =
      document_of(replace(valid_case, "standard solid", "fractional zener\n  set Fractional order = 1"));
  EXPECT_NEAR(number(fractional, "mdr", "stick_radius_shakedown") / number(solid, "mdr", "stick_radius_shakedown"), 1,
              1e-13);
  EXPECT_NEAR(number(fractional, "mdr", "contact_radius_max"), std::sqrt(1e-2 * 1.2e-4), 1e-12);
}

// The springs step a Prony body that stands for the fractional one; the radii next to them need none.
TEST(MdrDocumentSlow, SpringsStandForAFractionalBody) {
  const auto json =
      document_of(replace(valid_case, "standard solid", "fractional zener\n  set Fractional order = 0.5"), true);
  for (const char* key : {"stick_radius_first_slip", "stick_radius_shakedown"})
    EXPECT_NEAR(number(json, "springs", key) / number(json, "mdr", key), 1, 1e-4) << key;
}

// A table of the standard solid itself: the answer must be that of the standard solid, up to the misfit reported.
TEST(MdrDocument, MeasuredModuliAreFitted) {
  const ScratchFolder folder;
  folder.write("dma.csv", standard_solid_table());
  const auto file = folder.write("one.prm", case_with_modulus_table());
  const auto json = mdr_document(read_case_file(file).at(0), false).json;
  EXPECT_LT(number(json, "elastomer", "residual"), 0.05);
  EXPECT_NEAR(number(json, "mdr", "modulus_ratio") / number(document_of(valid_case), "mdr", "modulus_ratio"), 1, 0.01);
  EXPECT_EQ(json.at("elastomer").at("kramers_kronig").at("consistent"), true);

  // Young's moduli of the same body are three times as large.
  const auto young = folder.write("young.prm", case_with_modulus_table("Young"));
  const auto third = mdr_document(read_case_file(young).at(0), false).json;
  EXPECT_NEAR(3 * number(third, "mdr", "normal_force_max") / number(json, "mdr", "normal_force_max"), 1, 1e-9);
}

TEST(MdrDocument, MeasuredProfileIsReadWithItsUnits) {
  const ScratchFolder folder;
  std::string table = "r,f\nmm,nm\n";
  for (int k = 0; k <= 60; ++k) table += std::to_string(0.05 * k) + "," + std::to_string(125 * k * k) + "\n";
  folder.write("pin.csv", table);  // r^2/(2 R), R = 10 mm
  const auto file =
      folder.write("one.prm", replace(valid_case, "parabola\n  set Radius = 1e-2", "table\n  set Table = pin.csv"));
  const auto json = mdr_document(read_case_file(file).at(0), false).json;
  const auto sphere = document_of(valid_case);
  for (const char* key :
       {"contact_radius_max", "stick_radius_first_slip", "stick_radius_shakedown", "worn_radius", "normal_force_max"})
    EXPECT_NEAR(number(json, "mdr", key) / number(sphere, "mdr", key), 1, 1e-6) << key;  // six decimals are written
}

TEST(MdrDocument, HigherTemperatureSpeedsUpTheRelaxation) {
  const auto cold = document_of(valid_case);
  const std::string wlf =
      "times = 0.1\n  set Reference temperature = 20\n  set WLF C1 = 8.86\n  set WLF C2 = 101.6\n  set Temperature = ";
  const auto same = document_of(replace(valid_case, "times = 0.1", wlf + "20"));
  const auto hot = document_of(replace(valid_case, "times = 0.1", wlf + "60"));
  EXPECT_EQ(number(same, "mdr", "modulus_ratio"), number(cold, "mdr", "modulus_ratio"));
  EXPECT_LT(number(hot, "mdr", "modulus_ratio"), number(cold, "mdr", "modulus_ratio"));
}

TEST(MdrDocument, RefusesACourseOfWearThatSpringsDoNotHave) {
  const auto wearing = [](const std::string& law) {
    return valid_case + "subsection Wear\n  set Cycles = 1e6\n  set Coefficient = 1e-9\n" + law + "end\n";
  };
  for (const auto& text :
       {wearing("  set Law = power\n  set Exponent = 2\n"), replace(wearing(""), "Phase = 60", "Phase = free"),
        replace(wearing(""), "Tangential frequency = 1", "Tangential frequency = 2")})
    try {
      document_of(text);
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      expect_parts(error.what(), {"Wear / Cycles = 1e+06", "fretval run"});
    }
}

TEST(MdrDocument, WearKineticsTendToTheLimitingProfile) {
  const auto json = document_of(valid_case + "subsection Wear\n  set Coefficient = 1e-9\n  set Cycles = 1e6\nend\n");
  const auto& wear = json.at("wear");
  EXPECT_EQ(wear.at("cycles").size(), wear.at("volume").size());
  EXPECT_GT(wear.at("volume").back().get<double>(), 0);
  const auto r = wear.at("r").get<std::vector<double>>(), depth = wear.at("worn_depth").get<std::vector<double>>();
  double volume = 0;
  for (std::size_t k = 1; k < r.size(); ++k) volume += 2 * std::acos(-1.0) * r[k] * depth[k] * (r[k] - r[k - 1]);
  EXPECT_NEAR(wear.at("volume").back(), volume, 1e-2 * volume);
  EXPECT_EQ(wear.at("deepest").back(), *std::max_element(depth.begin(), depth.end()));
  EXPECT_EQ(wear.at("deepest").front(), 0);
  EXPECT_NEAR(wear.at("cycles").back(), 1e6, 1e-6);
  EXPECT_LT(wear.at("friction_work").back().get<double>(), 1e-2 * wear.at("friction_work").front().get<double>());
}

}  // namespace
}  // namespace fretval
