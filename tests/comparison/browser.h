#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/comparison/run_fretval.h"

namespace fretval {

inline bool has_browser() {
  return std::system("command -v chromium >/dev/null") == 0;
}

/// What the browser says to a page; it complains of nothing.
inline std::string browsed(const std::filesystem::path& page, const std::string& options, const ScratchFolder& folder) {
  const auto run = shell_run(
      "chromium --headless=new --no-sandbox --disable-gpu --user-data-dir=" + quoted(folder.path() / "profile") +
          " --virtual-time-budget=20000 --enable-logging=stderr " + options + " file://" + quoted(page),
      folder);
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.err.find("CONSOLE"), std::string::npos) << run.err;
  return run.out;
}

/// The JSON that a script has left in an attribute data-NAME of a document; null if it is not there.
inline nlohmann::json found_in(std::string document, const std::string& name) {
  const std::string start = "data-" + name + "=\"";
  const auto at = document.find(start);
  EXPECT_NE(at, std::string::npos) << document.substr(0, 1000);
  if (at == std::string::npos) return {};
  auto text = document.substr(at + start.size());
  text = text.substr(0, text.find('"'));
  for (const auto& [code, sign] : {std::pair{"&quot;", "\""}, {"&lt;", "<"}, {"&gt;", ">"}, {"&amp;", "&"}})
    for (auto found = text.find(code); found != std::string::npos; found = text.find(code, found + 1))
      text.replace(found, std::string(code).size(), sign);
  return nlohmann::json::parse(text);
}

}  // namespace fretval
