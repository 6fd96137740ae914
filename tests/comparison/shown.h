#pragma once

#include <sys/stat.h>

#include <cstdio>

#include "comparison/report/text/page.h"
#include "tests/comparison/run_fretval.h"

namespace fretval {

/// The HTML that the script of a page makes of its document. One process serves all tests, as it takes long to start.
inline std::string shown(const std::string& page) {
  static std::FILE* const node =
      popen(("node " + quoted(std::string(FRETVAL_SOURCE_DIR) + "/tests/comparison/report/shown.js")).c_str(), "w");
  const ScratchFolder folder;
  const auto answer = (folder.path() / "answer").string();
  if (mkfifo(answer.c_str(), S_IRUSR | S_IWUSR) != 0) throw std::runtime_error("there is no pipe");
  const auto question = folder.write("page.html", page).string() + "\t" + answer + "\n";
  std::fputs(question.c_str(), node);
  std::fflush(node);
  return text_of(answer);
}

/// A page of one section alone.
inline std::string page_with(const Filling& section) {
  return page_of("", "", {{"heading", nullptr}, {"sections", Filling::array({section})}});
}

inline std::string rendered(const Filling& section) {
  return shown(page_with(section));
}

}  // namespace fretval
