// Runs the program as a user would, and keeps its output.
#pragma once

#include <doctest/doctest.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "results/sample_run.hpp"

namespace trilith::testing {

/// The program next to the tests in the build tree; empty if it was not built.
inline std::filesystem::path program_path() {
  const auto build = std::filesystem::read_symlink("/proc/self/exe").parent_path().parent_path();
  const auto path = build / "lua" / "trilith";
  return std::filesystem::exists(path) ? path : std::filesystem::path();
}

/// True, with a message that lists the case as skipped, if the program was not built.
inline bool program_is_missing() {
  if (!program_path().empty()) return false;
  MESSAGE("skipped: the program was not built");
  return true;
}

struct Output {
  int code = -1;         ///< exit code; -1 if it was ended by a signal
  std::string out, err;  ///< output
  [[nodiscard]] bool prints(const std::string& part) const { return out.find(part) != std::string::npos; }
};

/// `trilith ARGUMENTS` as read by a shell in `folder`; output to pipes and files, so that nothing is a terminal.
inline Output run_program(const std::filesystem::path& folder, const std::string& arguments) {
  const std::filesystem::path err = folder / "stderr.txt";
  const std::string command =
      "cd '" + folder.string() + "' && '" + program_path().string() + "' " + arguments + " 2> '" + err.string() + "'";
  Output output;
  std::FILE* const pipe = ::popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::array<char, 4096> buffer{};
  for (std::size_t n; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) output.out.append(buffer.data(), n);
  const int status = ::pclose(pipe);
  output.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  output.err = testing::bytes_of(err);
  CHECK(output.out.find('\033') == std::string::npos);  // no control codes without a terminal
  CHECK(output.err.find('\033') == std::string::npos);
  return output;
}

/// Checks for a one-line message with the program's name and the error, and for exit code 1.
inline void check_refused(const Output& output, const std::string& part) {
  CHECK(output.code == 1);
  CHECK_MESSAGE(output.err.starts_with("trilith: "), output.err);
  CHECK_MESSAGE(output.err.find(part) != std::string::npos, output.err);
  CHECK(std::count(output.err.begin(), output.err.end(), '\n') == 1);
  CHECK(output.out.empty());
}

}  // namespace trilith::testing
