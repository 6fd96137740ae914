#include "comparison/run/explanation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "comparison/accuracy/prepared_case.h"
#include "comparison/accuracy/wear_proof.h"
#include "comparison/case/table_noise.h"
#include "comparison/case_file/case_sections.h"
#include "comparison/data/master_curve.h"
#include "comparison/reference/half_space.h"
#include "comparison/reference/mdr_document.h"
#include "comparison/results/answer_text.h"
#include "comparison/results/data_text.h"
#include "comparison/results/verdict_text.h"
#include "comparison/run/estimate.h"
#include "comparison/support/constants.h"
#include "comparison/support/parallel.h"
#include "mdr/layer/layer.h"
#include "meshes/mesh.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

const double two_pi = 2 * pi;

/// A value with at most six digits, and no more than needed.
std::string short_text(double value, const std::string& unit) {
  if (value == 0) return "0 " + unit;
  auto text = with_unit(value, 0, unit);
  const auto blank = text.find(' ');
  auto number = text.substr(0, blank);
  if (number.find('.') != std::string::npos) {
    number.erase(number.find_last_not_of('0') + 1);
    if (number.back() == '.') number.pop_back();
  }
  return number + text.substr(blank);
}

std::string row(const std::string& title, const std::string& text) {
  return fmt::format("  {:<13}{}\n", title, text);
}

std::string indenter_text(const Case::Indenter& indenter) {
  std::string text = Case::shape_names[static_cast<std::size_t>(indenter.shape)];
  if (indenter.radius > 0) text += ", R = " + short_text(indenter.radius, "m");
  if (indenter.slope_angle > 0) text += fmt::format(", slope {:g} deg", indenter.slope_angle);
  if (indenter.exponent > 0) text += fmt::format(", f = {:g} r^{:g} in m", indenter.coefficient, indenter.exponent);
  if (indenter.flat_radius > 0) text += ", flat up to " + short_text(indenter.flat_radius, "m");
  if (indenter.edge_radius > 0) text += ", edge radius " + short_text(indenter.edge_radius, "m");
  return indenter.table.empty() ? text : text + " " + indenter.table;
}

std::string two_digits(double value) {
  const double digit = value > 0 ? std::pow(10, std::floor(std::log10(value)) - 1) : 1;
  return fmt::format("{:.6g}", digit * std::round(value / digit));
}

/// What is extrapolated has two digits and a range.
std::string relaxed_text(const Case::Elastomer& body) {
  const auto range = body.master_curve && !body.test_duration
                         ? extrapolated_range(*body.master_curve, body.relaxed_modulus)
                         : std::nullopt;
  if (!range) return short_text(body.relaxed_modulus, "Pa");
  const auto [prefix, factor] = prefix_for(range->most);
  return fmt::format("{} {}Pa, extrapolated: {} to {}", two_digits(body.relaxed_modulus / factor), prefix,
                     two_digits(range->least / factor), two_digits(range->most / factor));
}

std::string body_text(const Case::Elastomer& body) {
  auto text = fmt::format("{}, G'(0) = {}", body.rheology_name(), relaxed_text(body));
  constexpr std::size_t most = 4;
  for (std::size_t k = 0; k < std::min(most, body.branch_moduli.size()); ++k)
    text += fmt::format(", {} with {}", short_text(body.branch_moduli[k], "Pa"), short_text(body.branch_times[k], "s"));
  if (const auto n = body.branch_moduli.size(); n > most)
    text += fmt::format(" and {} more {}", n - most, n - most == 1 ? "branch" : "branches");
  if (body.viscosity > 0) text += ", dashpot " + short_text(body.viscosity, "Pa s");
  if (body.fractional_order > 0) text += fmt::format(", order {:g}", body.fractional_order);
  if (const auto& fit = body.master_curve)
    text += fmt::format("; misses {} by {:.2g} % (root mean square)", fit->table, 100 * fit->residual);
  return text + (body.poisson_ratio == 0.5 ? "; incompressible" : fmt::format("; nu = {:g}", body.poisson_ratio));
}

std::string oscillation(double amplitude, const char* unit, double frequency, const std::string& phase) {
  return fmt::format("{} at {}{}", short_text(amplitude, unit), short_text(frequency, "Hz"), phase);
}

std::string path_text(const Case::Path& path) {
  const auto range = [](const std::vector<double>& values, bool force) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    const char* unit = force ? "N" : "m";
    return short_text(*least, unit) + " to " + short_text(*most, unit);
  };
  return row("path", fmt::format("{}: {} rows in {}, {}", path.file, path.time.size(), short_text(path.duration(), "s"),
                                 path.repeats ? "repeated for ever" : "passed once, from rest at the first row")) +
         row("normal", range(path.normal, path.normal_force)) +
         row("tangential", range(path.tangential, path.tangential_force)) +
         (path.transverse.empty() ? "" : row("transverse", range(path.transverse, path.tangential_force)));
}

/// "of one modulus" or "of pad 1, skin 8 times the modulus".
std::string counted_materials(const Case::Body& body) {
  const auto moduli = moduli_of_materials(body);
  if (std::all_of(moduli.begin(), moduli.end(), [](double modulus) { return modulus == 1; })) return "of one modulus";
  std::string text;
  for (std::size_t i = 0; i < moduli.size(); ++i)
    text += fmt::format("{}{} {:g}", i == 0 ? "of " : ", ",
                        body.grid->materials[i].empty() ? "(unnamed)" : body.grid->materials[i], moduli[i]);
  return text + " times the modulus";
}

std::string mesh_text(const Case::Body& body) {
  const auto radii = meshes::contact_radii(*body.grid);
  auto text =
      row("", fmt::format("a mesh of {} cells, {}, {} ({}), {} thick under the contact, {}", body.grid->cells.size(),
                          counted_materials(body), body.mesh, body.mesh_hash, short_text(body.thickness, "m"),
                          body.is_bonded ? "bonded to its base" : "on a frictionless base"));
  return text + row("", fmt::format("{} rings: its edges on a contact line of {}", radii.size() - 1,
                                    short_text(radii.back() * body.mesh_unit, "m")));
}

/// Nothing of a half-space, which is MDR's own body.
std::string shape_text(const Case::Body& body) {
  if (body.is_half_space()) return "";
  if (body.grid) return mesh_text(body);
  const bool cylinder = body.shape == Case::Body::Shape::cylinder;
  return row("", fmt::format("{} {} thick{}, {}", cylinder ? "a cylinder" : "a layer", short_text(body.thickness, "m"),
                             cylinder ? " of radius " + short_text(body.radius, "m") : "",
                             body.is_bonded ? "bonded to its base" : "on a frictionless base"));
}

std::string scene_text(const Case& input) {
  const auto& motion = input.motion;
  const auto phase = motion.phase ? fmt::format(", phase {:g} deg", *motion.phase) : std::string(", phase free");
  const auto more = [](const std::vector<Case::Harmonic>& harmonics) {
    return harmonics.empty() ? std::string() : fmt::format(" and {} more", harmonics.size());
  };
  const auto& force = motion.normal_force;
  std::string text = row("indenter", indenter_text(input.indenter)) + row("body", body_text(input.elastomer)) +
                     shape_text(input.body) + row("friction", fmt::format("mu = {:g}", input.friction_coefficient));
  if (motion.path) return text + path_text(*motion.path);
  text += row("normal", force ? short_text(force->mean, "N") + " ± " +
                                    oscillation(force->amplitude, "N", motion.normal_frequency, "")
                              : short_text(motion.indentation, "m") + " ± " +
                                    oscillation(motion.normal_amplitude, "m", motion.normal_frequency, "") +
                                    more(motion.normal_harmonics));
  const char* unit = motion.tangential_force ? "N" : "m";
  const auto harmonic = [&](const Case::Harmonic& h) {
    return oscillation(h.amplitude, unit, h.frequency, fmt::format(", phase {:g} deg", h.phase));
  };
  if (motion.tangential_force)
    text += row("tangential", oscillation(*motion.tangential_force, "N", motion.tangential_frequency, phase));
  else if (std::isnan(motion.tangential_amplitude))
    text += row("tangential", "what shakes down at the stick radius");
  else
    text += row("tangential", oscillation(motion.tangential_amplitude, "m", motion.tangential_frequency, phase) +
                                  more(motion.tangential_harmonics));
  if (!motion.transverse.empty())
    text += row("transverse",
                harmonic(motion.transverse.front()) + more({motion.transverse.begin() + 1, motion.transverse.end()}));
  return text;
}

/// What the thickness of the body is against the contact, and what would do for a half-space.
std::string thickness_text(const Case& input, double contact_radius) {
  if (!is_comparable(input)) return "";
  auto over_half_space = input;
  over_half_space.body = {};
  constexpr double share = 0.01;
  const auto least = thickness_of_half_space(mdr_case(over_half_space), input.elastomer.poisson_ratio, share);
  if (input.body.is_half_space())
    return row("half-space",
               fmt::format("holds within 1 % of a for a body that is thicker than {}", with_prefix(least, "m")));
  auto text = row("a/H", fmt::format("{:.3g}; a half-space would do within 1 % of a from {} on",
                                     contact_radius / input.body.thickness, with_prefix(least, "m")));
  if (input.body.radius > 0)
    text += row("a/B", fmt::format("{:.3g}, over the radius", contact_radius / input.body.radius));
  return text;
}

/// worn: radii are those of the contact that wear ends in.
std::string groups_text(const Case& input, const ordered_json& mdr, bool worn) {
  std::string text;
  const auto& path = input.motion.path;
  const double ratio = mdr::spring_modulus_ratio(input.elastomer.poisson_ratio);
  if (!path)
    text = row("|G|/G'(0)",
               fmt::format("{:.4g} (rho, at the tangential frequency)", mdr.at("modulus_ratio").get<double>()));
  const bool has_amplitudes =
      !path && !input.motion.normal_force && !input.motion.tangential_force && input.motion.tangential_amplitude > 0;
  if (has_amplitudes)
    text += row("k", fmt::format("{:.4g} ({} mu times the normal over the tangential amplitude)",
                                 ratio * input.friction_coefficient * input.motion.normal_amplitude /
                                     input.motion.tangential_amplitude,
                                 ratio == 1.5 ? "3/2" : fmt::format("{:.4g}", ratio)));
  const auto& times = input.elastomer.branch_times;
  if (!times.empty() && !path)
    text += row(
        "omega tau",
        fmt::format(
            "{:.3g}{}", two_pi * input.motion.normal_frequency * times.front(),
            times.size() > 1 ? fmt::format(" to {:.3g}", two_pi * input.motion.normal_frequency * times.back()) : ""));
  if (!input.motion.normal_force && !path) {
    text += row("amplitude", fmt::format("{:.3g} of the indentation, normal",
                                         input.motion.normal_amplitude / input.motion.indentation));
    if (!input.motion.tangential_force && !std::isnan(input.motion.tangential_amplitude))
      text += row(
          "", fmt::format("{:.3g} of mu times the indentation, tangential",
                          input.motion.tangential_amplitude / (input.friction_coefficient * input.motion.indentation)));
  }
  const auto& radius = mdr.at("contact_radius_max");
  if (radius.is_null()) return text;
  const double a = radius.get<double>();
  text += row("a", short_text(a, "m") + (worn ? ", contact radius where wear ends" : ", largest contact radius"));
  if (input.indenter.radius > 0) text += row("a/R", fmt::format("{:.3g}", a / input.indenter.radius));
  return text + thickness_text(input, a);
}

/// of_worn: the radii are those of the contact that wear ends in.
std::string regime_text(const ordered_json& mdr, MotionKind kind, bool of_worn) {
  const auto radius = [&](const char* key) {
    return mdr.at(key).is_null() ? std::string() : short_text(mdr.at(key).get<double>(), "m");
  };
  if (slides(mdr))
    return row("regime", mdr.contains("gross_slip_time")
                             ? fmt::format("gross slip: the whole contact slides from t = {} on",
                                           short_text(mdr.at("gross_slip_time").get<double>(), "s"))
                             : "gross slip: the whole contact slides");
  const auto first = radius("stick_radius_first_slip"), last = radius("stick_radius_shakedown"),
             worn = radius("worn_radius");
  std::string text;
  if (is_pass(kind)) {
    if (kind == MotionKind::pass_from_touch)
      return row("regime", "the contact grows from a touch") +
             row("first slip", fmt::format("none: {}", nothing_at_rest)) +
             row("shakedown", fmt::format("none: {}", no_shakedown_in_a_pass));
    text = row("regime", first.empty() ? "all of the contact slips in the pass" : "partial slip: a zone never slips");
    text += row("first slip", first.empty() ? "none" : "c = " + first + ", never slips since rest");
    return text + row("shakedown", fmt::format("none: {}", no_shakedown_in_a_pass));
  }
  if (!first.empty())
    text = row("regime", "partial slip: a zone sticks from the first cycle on");
  else if (!last.empty())
    text = row("regime", "all rings slip at first, then a zone shakes down to stick");
  else
    text = row("regime", "no zone sticks for good; wear goes on for ever");
  text += row("first slip", first.empty() ? "none" : "c = " + first + ", never slips since rest");
  text += row("shakedown", last.empty() ? "none" : "c = " + last + ", sticks in the periodic state");
  if (!worn.empty()) text += row("wear ends", "at r = " + worn);
  if (of_worn) text += row("", "radii under forces are those of the contact where wear ends");
  return text;
}

/// An estimated time: "40 s", "3 min", "2 h".
std::string duration_text(double seconds) {
  constexpr double minute = 60, hour = 3600, many = 2;
  if (seconds < many * minute) {
    const double digit = std::pow(10, std::floor(std::log10(seconds)));
    return fmt::format("{:g} s", digit * std::round(seconds / digit));
  }
  return seconds < many * hour ? fmt::format("{:.0f} min", seconds / minute) : fmt::format("{:.0f} h", seconds / hour);
}

/// Whether a stick zone is below a tenth of the contact radius by MDR, or there is none.
bool has_small_zone(const ordered_json& mdr) {
  constexpr double small = 0.1;
  if (mdr.at("contact_radius_max").is_null() || slides(mdr)) return false;
  const auto& first = mdr.at("stick_radius_first_slip");
  return first.is_null() || first.get<double>() < small * mdr.at("contact_radius_max").get<double>();
}

/// Seconds that all cases of a sweep take on all cores, estimated from some of them.
double seconds_of_sweep(const std::vector<Case>& sweep) {
  constexpr std::size_t most = 40;
  const std::size_t stride = 1 + sweep.size() / most;
  std::vector<PreparedCase> some;
  for (std::size_t i = 0; i < sweep.size(); i += stride) some.push_back(prepare({sweep[i]}).front());
  std::map<BodyDescription, std::size_t> n_with;
  for (const auto& one : some) ++n_with[one.fem.body];
  double seconds = 0;
  for (const auto& one : some) seconds += estimated_seconds(one, Proof::tolerance, stride * n_with.at(one.fem.body));
  return seconds * static_cast<double>(sweep.size()) / static_cast<double>(some.size() * n_cores());
}

/// Why nobody can tell how long a case takes; empty: it can be told. has_small_zone: MDR has a small zone, or none,
/// which finite elements look for.
std::string why_open_ended(const PreparedCase& prepared, bool has_small_zone) {
  if (prepared.fem.kind == ContactKind::plane) return "rings, steps and angles, as friction is a vector";
  return has_small_zone ? "rings where a stick zone is small, or may be" : "";
}

/// sweep: the sweep of which the case is a point.
std::string cost_text(const PreparedCase& prepared, const std::vector<Case>& sweep, bool has_small_zone) {
  const auto& fem = prepared.fem;
  const auto n = computations_for_bars(fem);
  std::string text =
      row("elements", fmt::format("{} rings under the contact{}, {} steps a cycle to begin with, refined as the "
                                  "error bars ask for",
                                  fem.resolution.elements_per_radius, fem.given ? " as the mesh has them" : "",
                                  fem.resolution.steps_per_cycle));
  for (const auto& words : left_out(fem)) text += row("", words);
  const double seconds = estimated_seconds(prepared, Proof::tolerance);
  if (slides(prepared))
    return text +
           row("cost", fmt::format("the whole contact slides, which one computation finds: of the order of {} on "
                                   "a core",
                                   duration_text(seconds)));
  if (const auto why = why_open_ended(prepared, has_small_zone); !why.empty())
    return text +
           row("cost", fmt::format("{} computations or more to prove a tolerance of {:g}, and many more on finer {}: "
                                   "minutes, which nobody can tell beforehand",
                                   n, prepared.input.tolerance, why));
  text += row("cost", fmt::format("{} computations or more to prove a tolerance of {:g}, of the order of {} on a core",
                                  n, prepared.input.tolerance, duration_text(seconds)));
  if (wears(prepared)) text += row("", "most of it for the wear");
  if (sweep.size() > 1)
    text += row("", fmt::format("all {} cases of the sweep, on {}: of the order of {}", sweep.size(),
                                n_cores() == 1 ? "one core" : fmt::format("{} cores", n_cores()),
                                duration_text(seconds_of_sweep(sweep))));
  return text;
}

std::string noise_row(const Case::Indenter& indenter) {
  const auto noise = noise_behind_falls(indenter);
  return noise ? row("", noise_text(*noise)) : "";
}

/// Text on a case whose profile MDR does not hold for.
std::string explanation_beyond_mdr(const Case& input, const mdr::Profile& profile, const std::vector<Case>& sweep) {
  auto text = input.name + "\n" + scene_text(input) + "\n" +
              row("MDR", "does not hold for this profile: " + falls_text(profile) + ",") +
              row("", "so that the contact is not one full circle at every indentation; nothing is compared") +
              noise_row(input.indenter) + row("", "finite elements take the rings in whatever order they touch");
  if (input.tolerance == 0) return text + row("elements", "none: finite elements need an Accuracy / Tolerance");
  return text + "\n" + cost_text(prepare({input}).front(), sweep, false);
}

}  // namespace

std::string explanation(const Case& input, const std::vector<Case>& sweep) {
  if (const auto profile = any_profile_of(input.indenter); !mdr::falls_of_image(profile).empty())
    return explanation_beyond_mdr(input, profile, sweep);
  auto for_mdr = input;  // which knows no cylinders, and no meshes
  if (input.body.shape == Case::Body::Shape::cylinder || input.body.grid) for_mdr.body = {};
  const auto document = mdr_document(for_mdr, false);
  const auto& mdr = document.json.at("mdr");
  const bool of_worn = document.json.contains("limiting_state");
  const auto kind = motion_kind_of(input.motion);
  auto text = input.name + "\n" + scene_text(input) + "\n" + groups_text(input, mdr, of_worn) + data_text(input) +
              "\n" + regime_text(mdr, kind, of_worn) + "\n";
  if (input.tolerance == 0) return text + row("elements", "none: finite elements need an Accuracy / Tolerance");
  try {
    return text +
           cost_text(prepare({input}).front(), sweep, kind != MotionKind::pass_from_touch && has_small_zone(mdr));
  } catch (const InputError& error) {
    return text + row("elements", fmt::format("none: {}", error.what()));
  }
}

}  // namespace fretval
