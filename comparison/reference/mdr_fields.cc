#include <algorithm>

#include "comparison/reference/mdr_case.h"
#include "comparison/reference/mdr_document.h"
#include "mdr/springs/spring_fields.h"
#include "mdr/stick/surface_fields.h"

namespace fretval {
namespace {

constexpr Eigen::Index n_field_points = 400;

template <class Function>
Column column(const std::string& name, const Eigen::VectorXd& r, const Function& f) {
  return {name, r.unaryExpr(f)};
}

/// displacement: see MdrCase.
void add_spring_columns(const mdr::SpringFields& fields, double displacement, const std::string& position,
                        const Eigen::VectorXd& r, std::vector<Column>& columns) {
  columns.push_back(column("p " + position + " [Pa]", r, [&](double x) { return mdr::pressure(fields, x); }));
  columns.push_back(column("tau " + position + " [Pa]", r, [&](double x) { return mdr::traction(fields, x); }));
  columns.push_back(
      column("u_z " + position + " [m]", r, [&](double x) { return mdr::normal_displacement(fields, x); }));
  columns.push_back(column("u_x " + position + " [m]", r,
                           [&](double x) { return mdr::tangential_displacement(fields, x) / displacement; }));
}

/// Adds the columns of the worn contact at the largest indentation: the pressure with and without its singular part,
/// and the traction, which is all singular.
void add_worn_columns(const mdr::LimitingProfile& worn, const mdr::PronyBody& body, const mdr::Motion& motion,
                      const Eigen::VectorXd& r, std::vector<Column>& columns) {
  const auto stresses = [&](double x) { return mdr::limiting_stresses(worn, body, motion, x, 0); };
  columns.push_back(column("f worn [m]", r, [&](double x) { return mdr::shape(worn, x); }));
  columns.push_back(column("p worn regular [Pa]", r, [&](double x) { return stresses(x).pressure.regular; }));
  columns.push_back(column("p worn [Pa]", r, [&](double x) { return mdr::total(stresses(x).pressure, x); }));
  columns.push_back(column("tau worn [Pa]", r, [&](double x) { return mdr::total(stresses(x).traction, x); }));
}

}  // namespace

std::vector<Column> surface_columns(const Case& input, const std::optional<mdr::LimitingProfile>& worn) {
  const auto springs = spring_answer(input);
  const auto mdr = mdr_case(input);
  const double a = mdr::inverse_transform(mdr.profile, deepest_indentation(mdr));
  const double width = std::min(1.6 * a, mdr::end_radius(mdr.profile)) / n_field_points;
  // Points begin off the axis, where the pressure under a cone is infinite.
  const Eigen::VectorXd r = Eigen::VectorXd::LinSpaced(n_field_points, 0.5 * width, (n_field_points - 0.5) * width);
  std::vector<Column> columns{{"r [m]", r}};
  columns.push_back(column("f [m]", r, [&](double x) { return mdr::shape(mdr.profile, x); }));
  add_spring_columns(mdr::spring_fields(springs.bed, mdr.body, springs.history.deepest), mdr.displacement, "deepest", r,
                     columns);
  add_spring_columns(mdr::spring_fields(springs.bed, mdr.body, springs.history.highest), mdr.displacement, "highest", r,
                     columns);
  const auto motion = mdr::one_harmonic_each(mdr.motion);
  if (worn && !mdr.has_forces() && motion && motion->phase) add_worn_columns(*worn, mdr.body, *motion, r, columns);
  return columns;
}

}  // namespace fretval
