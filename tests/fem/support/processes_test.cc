#include "fem/support/processes.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <string>
#include <vector>

namespace fretval::fem::processes_test {
namespace {

/// The environment of one launcher and no other, for as long as the object lives.
class Launched {
 public:
  explicit Launched(const std::map<std::string, std::string>& variables) {
    for (const char* name : {"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", "PMI_RANK", "PMI_SIZE", "PMIX_RANK",
                             "SLURM_STEP_NUM_TASKS"}) {
      if (const char* before = std::getenv(name)) before_[name] = before;
      unsetenv(name);
      names_.emplace_back(name);
    }
    for (const auto& [name, value] : variables) setenv(name.c_str(), value.c_str(), 1);
  }
  ~Launched() {
    for (const auto& name : names_) unsetenv(name.c_str());
    for (const auto& [name, value] : before_) setenv(name.c_str(), value.c_str(), 1);
  }
  Launched(const Launched&) = delete;
  Launched& operator=(const Launched&) = delete;

 private:
  std::vector<std::string> names_;
  std::map<std::string, std::string> before_;
};

TEST(Processes, AreCountedByTheLauncher) {
  for (const auto& [number, count] :
       std::map<std::string, std::string>{{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},
                                          {"PMI_RANK", "PMI_SIZE"},
                                          {"PMIX_RANK", "SLURM_STEP_NUM_TASKS"}}) {
    const Launched launched({{number, "2"}, {count, "5"}});
    EXPECT_EQ(this_process().number, 2) << number;
    EXPECT_EQ(this_process().count, 5) << count;
  }
}

TEST(Processes, AreOneWithoutALauncher) {
  const Launched alone({});
  EXPECT_EQ(this_process().number, 0);
  EXPECT_EQ(this_process().count, 1);
  EXPECT_FALSE(is_started_by_mpirun());
}

// The tasks of an srun of programs without MPI are not started for one run.
TEST(Processes, OfAnSrunWithoutMpiAreAlone) {
  const Launched tasks({{"SLURM_STEP_NUM_TASKS", "8"}, {"SLURM_PROCID", "3"}});
  EXPECT_EQ(this_process().count, 1);
}

}  // namespace
}  // namespace fretval::fem::processes_test
