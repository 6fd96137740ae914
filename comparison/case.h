#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace fretval {

/// One scene, as a case file describes it. SI units; angles in degrees and frequencies in Hz, as in the file.
struct Case {
  enum class Shape { parabola, cone, power };
  enum class Wear { unworn, limiting };
  enum class Fields { none, extremes };

  struct Indenter {
    Shape shape = Shape::parabola;
    double radius = 0;       ///< m; parabola
    double slope_angle = 0;  ///< deg; cone, between generatrix and surface
    double coefficient = 0;  ///< m^(1-n); power, f = b r^n
    double exponent = 0;     ///< n; power
  };

  struct Elastomer {
    std::string rheology;               ///< as named in the file
    double relaxed_modulus = 0;         ///< Pa, G'(0)
    std::vector<double> branch_moduli;  ///< Pa
    std::vector<double> branch_times;   ///< s
    double viscosity = 0;               ///< Pa s
  };

  struct Motion {
    double indentation = 0;           ///< m, mean
    double normal_amplitude = 0;      ///< m
    double tangential_amplitude = 0;  ///< m
    double frequency = 0;             ///< Hz, of both motions
    std::optional<double> phase;      ///< deg; empty: unlocked
  };

  /// A sweep's place in its family of cases, for the report's plots.
  struct Sweep {
    std::string family;  ///< name of the case file
    std::string entry;   ///< as in the file, for example "Motion / Phase"
    double value = 0;
  };

  std::string name;  ///< stem of the file, with "/ENTRY-VALUE" for a point of a sweep
  std::string file;
  Indenter indenter;
  Elastomer elastomer;
  double friction_coefficient = 0;
  Motion motion;
  Wear wear = Wear::unworn;
  double worn_stick_ratio =
      0;                 ///< limiting wear: stick radius over the unworn contact radius at the largest indentation
  double tolerance = 0;  ///< relative, on the stick radius
  std::optional<unsigned> rings_per_radius;  ///< instead of what the tolerance asks for
  std::optional<int> steps_per_cycle;        ///< instead of what the tolerance asks for
  Fields fields = Fields::none;
  std::optional<Sweep> sweep;
};

/// Bad input: a file, entry or value the user has to change. Ends in exit code 2.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace fretval
