#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "comparison/simulation/bodies/operator_store.h"

namespace CLI {
class App;
}

namespace fretval {

/// The store of operators that a command line asks for.
struct StoreOptions {
  std::string folder;  ///< empty: none
  std::uint64_t limit = OperatorStore::usual_limit;
  bool none = false;
};

/// Adds --store (or $FRETVAL_STORE; otherwise the cache folder of the user) and --store-limit (or
/// $FRETVAL_STORE_LIMIT) to a verb; parsing fills them. The options have to outlive that.
void add_store_options(CLI::App& verb, StoreOptions& options);

/// The store of operators; null: none is asked for, or there is no folder for it.
std::shared_ptr<OperatorStore> store_of(const StoreOptions& options);

/// `fretval store`: prints what is in a store (list), reads it and prints what is damaged (verify: exit_disagree if
/// anything is), or removes everything (clear). Returns the exit code. Throws std::filesystem::filesystem_error, and
/// InputError where there is no store.
int run_store(const std::string& action, const StoreOptions& options);

}  // namespace fretval
