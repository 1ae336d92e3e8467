#include "load/motion_read.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "base/error.hpp"
#include "base/whole_file.hpp"
#include "load/motion_csv.hpp"
#include "load/motion_formats.hpp"
#include "load/text_lines.hpp"

namespace trilith {

namespace {

constexpr std::uintmax_t largest_file = 512u << 20;  // [bytes]

std::string text_of(const std::filesystem::path& path) {
  const std::string name = path.string();
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
    throw InputError(fmt::format("motion file '{}' does not exist; check the path", name));
  if (!std::filesystem::is_regular_file(status))
    throw InputError(fmt::format("motion file '{}' is not a regular file", name));
  const auto size = std::filesystem::file_size(path, error);
  if (error || size > largest_file)
    throw InputError(fmt::format("motion file '{}' is too large for a record (above {} MB)", name, largest_file >> 20));
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (size > 0) text << file.rdbuf();
  if (!file || !text) throw InputError(fmt::format("motion file '{}' cannot be read; check its permissions", name));
  return std::move(text).str();
}

}  // namespace

GroundMotion read_motion(const std::filesystem::path& path) {
  return parse_motion(text_of(path), path.string());
}

/// Only formats that the content identifies are read.
GroundMotion parse_motion(std::string_view text, const std::string& name) {
  text = without_padding(without_byte_order_mark(text));
  TextLines lines(text, name);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) lines.fail_whole("is empty");
  if (const MotionFormat format = named_format(text, name)) return format.parse(text, name);
  if (text[first] == '#') return parse_csv_motion(text, name);
  lines.fail_whole(
      "is neither a CSV record (first line '# title: ...') nor a PEER AT2 file (fourth line 'NPTS= ..., DT= ...') nor "
      "an ESM or K-NET file; for plain columns, give unit, as in { file = \"...\", unit = \"cm/s2\" }");
}

}  // namespace trilith
