#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace fretval {

/// A folder of the test's own, gone with the object.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "fretval-test-XXXXXX").string();
    if (!mkdtemp(pattern.data())) throw std::runtime_error("cannot make a temporary folder");
    path_ = pattern;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name) << text;
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

/// A valid case; replace() makes it an invalid one.
inline const std::string valid_case = R"(subsection Indenter
  set Shape = parabola
  set Radius = 1e-2
end
subsection Elastomer
  set Rheology = standard solid
  set Relaxed shear modulus = 1e6
  set Branch moduli = 1e6
  set Branch times = 0.1
end
subsection Friction
  set Coefficient = 0.5
  set Law = unidirectional
end
subsection Motion
  set Indentation = 1e-4
  set Normal amplitude = 2e-5
  set Normal frequency = 1
  set Tangential amplitude = 1.5e-5
  set Tangential frequency = 1
  set Phase = 60
end
subsection Accuracy
  set Tolerance = 0.01
end
)";

inline std::string replace(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

/// The valid case with the moduli of the table dma.csv; moduli: shear or Young.
inline std::string case_with_modulus_table(const std::string& moduli = "shear") {
  return replace(
      valid_case,
      "standard solid\n  set Relaxed shear modulus = 1e6\n  set Branch moduli = 1e6\n  set Branch times = 0.1",
      "table\n  set Table = dma.csv\n  set Table modulus = " + moduli);
}

}  // namespace fretval
