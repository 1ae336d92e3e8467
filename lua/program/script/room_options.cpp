#include "program/script/room_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <filesystem>

#include "base/error.hpp"
#include "program/positive.hpp"

namespace trilith::program {
namespace {

/// "512MB", "4 GB", "1e9": bytes.
double bytes_of(const std::string& text) {
  double value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  std::string unit(stop, text.data() + text.size());
  unit.erase(0, unit.find_first_not_of(' '));
  const double factor = unit.empty() || unit == "B"    ? 1
                        : unit == "kB"                 ? 1e3
                        : unit == "MB"                 ? 1e6
                        : unit == "GB"                 ? 1e9
                        : unit == "MiB" || unit == "M" ? 1048576.0
                        : unit == "GiB" || unit == "G" ? 1073741824.0
                                                       : 0;
  if (error != std::errc() || factor == 0 || !(value >= 0) || value * factor > 1e18)
    throw CLI::ValidationError("--script-memory",
                               fmt::format("'{}' is not a size; write 512MB or 8GB, or 0 for no limit", text));
  return value * factor;
}

/// True for a parameter value that can only be a path: with a slash, and not a number with a unit such as "3 m/s2".
bool names_path(const std::string& value) {
  if (value.find('/') == std::string::npos) return false;
  const std::size_t first = value.find_first_not_of("+-.");
  return first == std::string::npos || std::isdigit(static_cast<unsigned char>(value[first])) == 0;
}

/// True if `folder` contains or is the home folder: a script run from there would have access to all of the user's
/// files.
bool holds_home(const std::filesystem::path& folder) {
  const char* const home = std::getenv("HOME");
  std::error_code error;
  const std::filesystem::path real = home != nullptr ? std::filesystem::canonical(home, error) : "";
  if (home == nullptr || error || real.empty()) return folder == folder.root_path();
  return std::mismatch(folder.begin(), folder.end(), real.begin(), real.end()).first == folder.end();
}

void add_named(script::Host& host) {
  if (!host.results_file.empty()) host.room.add(host.results_file);
  for (const std::string& given : host.arguments) {
    const std::string value = given.substr(std::min(given.find('=') + 1, given.size()));
    if (names_path(value)) host.room.add(value);
  }
}

}  // namespace

std::vector<std::string> RoomOptions::words() const {
  std::vector<std::string> words;
  if (trust) words.emplace_back("--trust");
  if (memory >= 0) words.push_back(fmt::format("--script-memory={:.17g}", memory));
  if (seconds >= 0) words.push_back(fmt::format("--script-seconds={:.17g}", seconds));
  return words;
}

void add_room_options(CLI::App& verb, RoomOptions& options) {
  verb.add_flag("--trust", options.trust,
                "run the script without its sandbox: it may start programs and use all your files");
  verb.add_option_function<std::string>(
          "--script-memory", [&options](const std::string& text) { options.memory = bytes_of(text); },
          "memory that the script's Lua code may hold; default 4 GiB, 0 for no limit")
      ->type_name("SIZE");
  verb.add_option(
          "--script-seconds", options.seconds,
          "time that the script, or one of its handlers, may run without a stage or another long computation of "
          "the engine [s]; default 600, 0 for no limit")
      ->type_name("SECONDS")
      ->check(CLI::Validator(is_not_negative, "", ""));
  verb.add_option("--room", options.folders)
      ->allow_extra_args(false)  // one at a time: the next word is a parameter
      ->group("");
}

void set_room(script::Host& host, const RoomOptions& options) {
  host.script_memory = options.memory >= 0 ? options.memory : options.trust ? 0 : script::default_script_memory;
  host.script_seconds = options.seconds >= 0 ? options.seconds : options.trust ? 0 : script::default_script_seconds;
  if (options.trust) return;
  host.room.close(host.folder());
  if (!host.case_folder.empty()) host.room.add(host.case_folder);
  if (!options.folders.empty()) {
    for (const std::string& folder : options.folders) host.room.add(folder);
    return;
  }
  std::error_code error;
  const std::filesystem::path here = std::filesystem::current_path(error);
  if (!error && !holds_home(here)) host.room.add(here);
  add_named(host);
}

}  // namespace trilith::program
