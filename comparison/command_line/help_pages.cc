#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <sstream>
#include <vector>

#include "comparison/command_line/commands.h"
#include "comparison/command_line/ending.h"

namespace fretval {
namespace {

/// Hyphens as they are typed, and no line that troff would take for a request.
std::string troff(const std::string& text) {
  auto escaped = boost::replace_all_copy(text, "\\", "\\e");
  boost::replace_all(escaped, "-", "\\-");
  return !escaped.empty() && (escaped[0] == '.' || escaped[0] == '\'') ? "\\&" + escaped : escaped;
}

bool is_help(const CLI::Option* option) {
  return option->check_lname("help") || option->check_lname("version");
}

std::string options_text(const CLI::App& app) {
  std::string text;
  for (const auto* option : app.get_options()) {
    if (is_help(option)) continue;
    const bool takes_value = option->get_items_expected_max() > 0 && !option->get_positional();
    text += fmt::format(".TP\n.B {}{}\n{}{}\n", troff(option->get_name(false, true)),
                        takes_value ? " \\fR\\fIVALUE\\fR" : "", troff(option->get_description()),
                        option->get_default_str().empty() ? "" : troff(" [" + option->get_default_str() + "]"));
  }
  return text;
}

std::vector<const CLI::App*> verbs_of(const CLI::App& app) {
  std::vector<const CLI::App*> verbs;
  for (const auto* verb : app.get_subcommands([](const CLI::App* verb) { return !verb->get_group().empty(); }))
    verbs.push_back(verb);
  return verbs;
}

std::string long_options(const CLI::App& app) {
  std::string words;
  for (const auto* option : app.get_options())
    for (const auto& name : option->get_lnames()) words += (words.empty() ? "--" : " --") + name;
  return words;
}

}  // namespace

std::string man_page(const CLI::App& app) {
  std::string text = fmt::format(
      ".TH FRETVAL 1\n.SH NAME\nfretval \\- {}\n.SH SYNOPSIS\n.B fretval\n[\\fIOPTION\\fR] \\fIVERB\\fR "
      "[\\fIARGUMENT\\fR]...\n.SH DESCRIPTION\n{}\n.SH OPTIONS\n",
      "finite elements and the method of dimensionality reduction compared for fretting", troff(app.get_description()));
  text += options_text(app) + ".SH VERBS\n";
  for (const auto* verb : verbs_of(app))
    text += fmt::format(".SS {}\n{}\n{}", troff(verb->get_name()), troff(verb->get_description()), options_text(*verb));
  text += ".SH EXIT STATUS\n";
  std::istringstream codes(exit_codes_text);
  for (std::string line; std::getline(codes, line);)
    text += fmt::format(".TP\n{}\n{}\n", line.substr(0, 1), troff(line.substr(3)));
  return text;
}

std::string bash_completion(const CLI::App& app) {
  std::string verbs, branches;
  for (const auto* verb : verbs_of(app)) {
    verbs += (verbs.empty() ? "" : " ") + verb->get_name();
    branches += fmt::format("    {}) words=\"{}\" ;;\n", verb->get_name(), long_options(*verb));
  }
  return fmt::format(R"(# Completion of fretval for bash.
_fretval() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} verb= words=
  local i
  for ((i = 1; i < COMP_CWORD; i++)); do
    case ${{COMP_WORDS[i]}} in -*) ;; *) verb=${{COMP_WORDS[i]}}; break ;; esac
  done
  case $verb in
    "") words="{} {}" ;;
{}  esac
  COMPREPLY=($(compgen -W "$words" -- "$word"))
  if [[ -n $verb && $word != -* ]]; then COMPREPLY+=($(compgen -f -- "$word")); fi
}}
complete -o filenames -F _fretval fretval
)",
                     verbs, long_options(app), branches);
}

}  // namespace fretval
