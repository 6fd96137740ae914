#pragma once

#include <string>

/// Messages on the standard error, in colours on a terminal. Apart from the library that writes them, whose headers
/// take six seconds to compile.
namespace fretval::log {

/// Call once, before the first message.
void start();

/// From now on warnings and errors alone.
void keep_quiet();

/// From now on details as well.
void say_details();

/// Whether what is not asked for may be told: started, and not quiet.
bool tells();

/// Whether details are told.
bool tells_details();

/// What only those want to know who know how the program works.
void detail(const std::string& message);
void info(const std::string& message);
void warn(const std::string& message);
/// The first time alone: of a table that all cases of a sweep have.
void info_once(const std::string& message);
void warn_once(const std::string& message);
void error(const std::string& message);

}  // namespace fretval::log
