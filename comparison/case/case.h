#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "mdr/motion/sampled_path.h"
#include "mdr/profiles/trace_alignment.h"
#include "mdr/rheology/kramers_kronig.h"

namespace fretval::meshes {
struct Mesh;
}

namespace fretval {

/// One case, as a case file describes it. SI units; angles in degrees and frequencies in Hz, as in the file.
struct Case {
  enum class Shape { parabola, sphere, cone, power, rounded_flat, truncated_sphere, table };
  /// In the order of the enumeration, as in the file.
  static constexpr std::array shape_names{"parabola",     "sphere",           "cone", "power",
                                          "rounded flat", "truncated sphere", "table"};
  enum class Wear { unworn, limiting };
  enum class Fields { none, extremes, cycle };

  /// A raw trace of a profilometer, and how it was aligned. Lengths in m.
  struct AlignedTrace : mdr::TraceAlignment {
    std::vector<double> x, z;  ///< as in the file
    std::vector<double> r, f;  ///< aligned profile
    double row_noise;          ///< standard deviation of f, whose rows are means
  };

  struct Indenter {
    Shape shape = Shape::parabola;
    double radius = 0;                       ///< m; parabola, sphere, truncated sphere
    double slope_angle = 0;                  ///< deg; cone, between generatrix and surface
    double coefficient = 0;                  ///< m^(1-n); power, f = b r^n
    double exponent = 0;                     ///< n; power
    double flat_radius = 0;                  ///< m; rounded flat, truncated sphere
    double edge_radius = 0;                  ///< m; rounded flat
    std::string table;                       ///< file with columns r, f; table
    double table_noise = 0;                  ///< m, standard deviation of the heights; table
    std::optional<AlignedTrace> trace = {};  ///< of a table that is aligned by itself, instead of its rows
  };

  /// How well a Prony body stands for measured moduli; see mdr/rheology/prony_fit.h and mdr/rheology/kramers_kronig.h.
  struct MasterCurve {
    std::string table;
    /// What was measured: shear moduli in Pa over the frequency in Hz, at the temperature of the case.
    std::vector<double> frequency, storage, loss;
    double residual = 0, held_out = 0, worst = 0, worst_frequency = 0;
    std::optional<mdr::KramersKronig> kramers_kronig;  ///< empty: too few frequencies
    bool youngs = false;                               ///< the table has Young's moduli
  };

  /// Shift of the relaxation times from the temperature of the data to that of the case (Williams, Landel, Ferry).
  struct TemperatureShift {
    double temperature, reference;  ///< degC
    double c1, c2;                  ///< c2 in K
  };

  /// What a test of limited duration sees of a body; see comparison/case/test_duration.h. Pa and s.
  struct TestDuration {
    double seconds;
    double relaxed_modulus;                           ///< of the data, before the limitation
    std::vector<double> branch_moduli, branch_times;  ///< of the data
    double viscosity;                                 ///< of the data
    std::size_t n_slow = 0, n_fast = 0;               ///< branches that are springs now, and branches merged
    std::vector<double> near_times = {};              ///< of branches within a factor of three of the duration
    double merging_error = 0;                         ///< largest relative change of the complex modulus by merging
  };

  enum class Rheology { elastic, kelvin_voigt, standard_solid, prony, fractional_zener, table };
  /// In the order of the enumeration, as in the file.
  static constexpr std::array rheology_names{"elastic", "kelvin voigt",     "standard solid",
                                             "prony",   "fractional zener", "table"};

  struct Elastomer {
    Rheology rheology = Rheology::elastic;
    double relaxed_modulus = 0;         ///< Pa, G'(0)
    std::vector<double> branch_moduli;  ///< Pa; of the fit for measured moduli
    std::vector<double> branch_times;   ///< s, at the temperature of the case
    double viscosity = 0;               ///< Pa s
    double fractional_order = 0;        ///< fractional zener
    double poisson_ratio = 0.5;         ///< 0 to 0.5, at all times
    std::optional<MasterCurve> master_curve;
    std::optional<TemperatureShift> shift;           ///< already applied to the times and frequencies above
    std::optional<TestDuration> test_duration = {};  ///< already applied to the moduli and times above
    std::string branches_file = {};                  ///< file from which the branches were read
    std::optional<double> shore_a = {};              ///< hardness from which the relaxed modulus follows
    double modulus_scatter = 0;                      ///< relative standard deviation of the moduli, where it is known

    [[nodiscard]] const char* rheology_name() const { return rheology_names[static_cast<std::size_t>(rheology)]; }
    [[nodiscard]] bool has_memory() const { return viscosity > 0 || !branch_moduli.empty(); }
  };

  /// What the indenter is pressed into.
  struct Body {
    enum class Shape { half_space, layer, cylinder, mesh };
    /// In the order of the enumeration, as in the file.
    static constexpr std::array shape_names{"half space", "layer", "cylinder", "mesh"};

    /// The modulus of all that belongs to a physical surface of a mesh, over that of the elastomer.
    struct RelativeModulus {
      std::string material;
      double value;
    };

    Shape shape = Shape::half_space;
    double thickness = 0;   ///< m; layer, cylinder; of a mesh what is below the centre of the contact
    double radius = 0;      ///< m; cylinder
    bool is_bonded = true;  ///< to its base; false: it slides there without friction; all but half space
    std::string mesh = {}, mesh_hash = {};              ///< file, and what tells its content; mesh
    std::shared_ptr<const meshes::Mesh> grid = {};      ///< see meshes::read_user_mesh; mesh
    double mesh_unit = 1;                               ///< m, of its coordinates; mesh
    std::vector<RelativeModulus> relative_moduli = {};  ///< 1 of materials that it does not name; mesh

    [[nodiscard]] bool is_half_space() const { return shape == Shape::half_space; }
  };

  /// One cosine of a motion beyond its first: phase in degrees, amplitude in m, frequency in Hz.
  struct Harmonic {
    double amplitude = 0, frequency = 0, phase = 0;
  };

  struct NormalForce {
    double mean = 0, amplitude = 0;  ///< N
  };

  /// How a record was reduced to a path. Errors and scatters in m or N, as the columns.
  struct PathReduction {
    std::size_t n_rows;                                 ///< rows of the record
    std::size_t n_cut = 0;                              ///< rows before contact, cut off
    double normal_error = 0, tangential_error = 0;      ///< of what was left out
    std::size_t n_cycles = 0;                           ///< cycles whose mean the path is; 0: none
    double normal_scatter = 0, tangential_scatter = 0;  ///< from cycle to cycle, standard deviation
  };

  /// A path of the indenter, with its rows as in the file.
  struct Path : mdr::SampledPath {
    std::string file = {};
    std::optional<PathReduction> reduction = {};  ///< empty: the rows are those of the file
    /// Whether the indenter comes to touch in the first row of a single pass, so that at rest nothing is in contact.
    bool from_touch = false;
  };

  /// The motion of the indenter. Along a path the numbers tell its size: the mean indentation or normal force, half of
  /// the ranges of its columns as amplitudes, and one over its duration as frequency.
  struct Motion {
    double indentation = 0;           ///< m, mean
    double normal_amplitude = 0;      ///< m
    double tangential_amplitude = 0;  ///< m
    double normal_frequency = 0;      ///< Hz
    double tangential_frequency = 0;  ///< Hz
    std::optional<double> phase;      ///< deg; empty: unlocked
    std::vector<Harmonic> normal_harmonics, tangential_harmonics;
    std::vector<Harmonic> transverse;         ///< of u_y, of F_y beside a tangential force; empty: along x alone
    std::optional<NormalForce> normal_force;  ///< prescribed instead of the indentation
    std::optional<double> tangential_force;   ///< N, amplitude; instead of the tangential amplitude
    std::optional<Path> path;                 ///< instead of all oscillations

    [[nodiscard]] bool moves_across() const { return !transverse.empty() || (path && !path->transverse.empty()); }
    /// Whether the indenter moves in any direction along the surface.
    [[nodiscard]] bool moves_tangentially() const {
      const auto moves = [](const Harmonic& harmonic) { return harmonic.amplitude > 0; };
      return moves_across() || tangential_amplitude != 0 || tangential_force.value_or(0) > 0 ||
             std::any_of(tangential_harmonics.begin(), tangential_harmonics.end(), moves);
    }
  };

  /// Which of MDR's assumptions on friction and pressure the contact drops.
  struct Contact {
    bool vector_friction = false;  ///< the traction has any direction; false: that of the motion, as MDR assumes
    bool coupled = false;          ///< pressures also displace the surface tangentially, and tractions normally
    /// Each step is solved once more, by an algorithm of another kind.
    bool second_algorithm = false;
    /// Whether the contact is computed on rings and angles; otherwise on rings.
    [[nodiscard]] bool is_full() const { return vector_friction; }
  };

  enum class WearLaw { archard, energy, power };
  /// In the order of the enumeration, as in the file.
  static constexpr std::array wear_law_names{"archard", "energy", "power"};

  /// How the indenter wears, and for how long.
  struct WearKinetics {
    WearLaw law = WearLaw::archard;
    /// Worn depth per path of slip and pressure, 1/Pa (archard), or pressure^exponent, Pa^-exponent (power); per energy
    /// of friction and area, 1/Pa (energy).
    double coefficient = 0;
    double exponent = 1;             ///< of the pressure; power
    std::optional<double> n_cycles;  ///< of the motion; empty: until nothing is left that would wear
    double until = 0;                ///< ends before, when the volume worn off in a cycle has fallen to this share
    std::string profile = {};        ///< table of the heights that the indenter has worn to before; empty: unworn
    std::string rings = {};          ///< or of the depths that rings have lost, as a run has written them

    [[nodiscard]] bool has_worn_before() const { return !profile.empty() || !rings.empty(); }
  };

  /// Values that a rig has measured, shown beside both methods. SI units.
  struct Measured {
    struct Value {
      double value, uncertainty;
    };
    std::optional<Value> stick_radius = {}, contact_radius = {};
    std::string loop = {};  ///< file of the columns below; a column that it does not have is empty
    std::vector<double> time, indentation, tangential_displacement, normal_force, tangential_force;
  };

  /// A sweep's place in its family of cases, for the report's plots.
  struct Sweep {
    std::string family;  ///< name of the case file
    std::string entry;   ///< as in the file, for example "Motion / Phase"
    double value = 0;
    std::string second_entry = {};  ///< of a map over two entries; empty: it is a line
    double second_value = 0;
  };

  std::string name;  ///< stem of the file, with "/ENTRY-VALUE" for a point of a sweep
  std::string file;
  Indenter indenter;
  Elastomer elastomer;
  Body body;
  double friction_coefficient = 0;
  Motion motion;
  Contact contact;
  Wear wear = Wear::unworn;
  double worn_stick_ratio =
      0;  ///< limiting wear: stick radius over the unworn contact radius at the largest indentation
  std::optional<WearKinetics> wear_kinetics;
  double tolerance = 0;                      ///< relative, on the stick radius
  std::optional<double> cycle_tolerance;     ///< on forces and energies of a cycle; empty: without tolerance
  std::optional<unsigned> rings_per_radius;  ///< instead of what the tolerance asks for
  std::optional<int> steps_per_cycle;        ///< instead of what the tolerance asks for
  std::optional<Fields> fields;              ///< empty: the file does not say
  std::optional<Sweep> sweep;
  std::vector<std::string> warnings;  ///< about the input, to be told to the user
  std::vector<std::string> notes;     ///< how the input was processed, to be told to the user
  std::optional<Measured> measured = {};
};

/// Whether a case has to say how accurately finite elements are to compute it; MDR's answer needs no Tolerance.
enum class Accuracy { needed, optional };

/// Bad input: a file, entry or value the user has to change. Ends in exit code 2.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace fretval
