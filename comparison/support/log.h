#pragma once

#include <string>

/// Messages on the standard error, in colours on a terminal. This header does not include the library that writes them,
/// whose headers take six seconds to compile.
namespace fretval::log {

/// Call once, before the first message.
void start();

/// Writes only warnings and errors from now on.
void keep_quiet();

/// Writes details, too, from now on.
void say_details();

/// Whether messages that are no warnings are written: after start(), and not after keep_quiet().
bool tells();

/// Whether details are written.
bool tells_details();

/// Writes a message for people who know how the program works.
void detail(const std::string& message);
void info(const std::string& message);
void warn(const std::string& message);
/// Write a message the first time only, such as one about a table that all cases of a sweep share.
void info_once(const std::string& message);
void warn_once(const std::string& message);
void error(const std::string& message);

}  // namespace fretval::log
