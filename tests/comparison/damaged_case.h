#pragma once

#include <cmath>
#include <functional>
#include <string>

#include "comparison/accuracy/prepared_case.h"
#include "comparison/case_file/case_file.h"
#include "tests/comparison/read_case.h"

namespace fretval {

/// Height above the parabola of radius 10 mm at r, both in mm.
using Damage = std::function<double(double r)>;

/// A groove between two radii.
inline Damage groove(double inner, double outer, double depth) {
  return [=](double r) {
    return r > inner && r < outer ? depth * std::pow(std::sin(std::acos(-1.0) * (r - inner) / (outer - inner)), 2) : 0;
  };
}

/// Writes the table and the case of a damaged parabola in an elastic body, which touches up to 1.118 mm while it is
/// whole; returns the path of the case.
inline std::filesystem::path write_damaged_case(const ScratchFolder& folder, const Damage& damage, double end = 2) {
  std::string table = "r [mm],f [mm]\n";
  for (int i = 0; i <= 200; ++i) {
    const double r = end * i / 200;
    table += std::to_string(r) + "," + std::to_string(r * r / 20 + damage(r)) + "\n";
  }
  folder.write("damaged.csv", table);
  auto text = replace(elastic_case(), "set Shape = parabola", "set Shape = table\n  set Table = damaged.csv");
  text = replace(text, "  set Radius = 1e-2\n", "");
  text = replace(text, "Indentation = 1e-4", "Indentation = 1.05e-4");
  return folder.write("damaged.prm", replace(text, "Tolerance = 0.05", "Tolerance = 0.01"));
}

inline PreparedCase prepared_damaged(const Damage& damage, double end = 2) {
  const ScratchFolder folder;
  return prepare({read_case_file(write_damaged_case(folder, damage, end)).at(0)}).front();
}

}  // namespace fretval
