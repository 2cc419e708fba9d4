#pragma once

#include <stdexcept>
#include <string>

namespace capcon {

/// A place in a user's file; line and column count from 1, 0 means unknown.
struct SourcePlace {
  std::string file;
  int line = 0;
  int column = 0;

  /// "file:line:column", without the parts that are unknown; empty when the file is.
  std::string str() const;
};

/// A message as one line for people: control characters as "\\n" or "\\x1b" (they come from files, and would
/// reach a terminal), and of a very long text the beginning and the end.
std::string one_line(const std::string& text);

/// The user's input or command line is wrong: one sentence that says what and what to do. Exit code 2.
class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& message) : std::runtime_error(one_line(message)) {}
  /// Puts "file:line:column: " before the message.
  InputError(const SourcePlace& place, const std::string& message);
};

/// The input was fine, yet the work could not be done (no device, full disk, device lost). Exit code 1.
class Failure : public std::runtime_error {
 public:
  explicit Failure(const std::string& message) : std::runtime_error(one_line(message)) {}
};

}  // namespace capcon
