#include "load/motion_formats.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>

#include "load/motion_csv.hpp"
#include "load/motion_peer.hpp"
#include "load/motion_samples.hpp"
#include "load/text_lines.hpp"

namespace trilith {
namespace {

constexpr double gal_in_g = 0.01 / standard_gravity;

/// A line "key value" of a head: the value, if the line begins with the key.
std::optional<std::string_view> value_of(std::string_view line, std::string_view key) {
  if (!lower_case(line.substr(0, key.size())).starts_with(key)) return std::nullopt;
  return trimmed(line.substr(key.size()));
}

/// The number at the start of a text, before its unit: "100Hz", "3920(gal)".
double leading_number(std::string_view text, std::string_view what, const TextLines& lines) {
  return lines.require_number(text.substr(0, std::min(text.find_first_not_of("0123456789.+-"), text.size())), what);
}

// ESM (Engineering Strong Motion database): lines "KEY: value", then one sample per line.

struct EsmHeader {
  MotionSource source;
  std::optional<double> step;        // [s]
  std::optional<std::size_t> count;  // samples
  bool unit_is_cm = false;
};

void read_esm_line(std::string_view line, EsmHeader& header, const TextLines& lines) {
  const auto take = [&](std::string_view key) { return value_of(line, key); };
  if (const auto v = take("sampling_interval_s:")) header.step = lines.require_number(*v, "SAMPLING_INTERVAL_S");
  if (const auto v = take("ndata:")) header.count = lines.require_count(*v, "NDATA");
  if (const auto v = take("event_name:")) header.source.title = *v;
  if (const auto v = take("station_name:")) header.source.agency = *v;
  if (const auto v = take("stream:")) header.source.component = *v;
  if (const auto v = take("units:")) {
    if (lower_case(*v) != "cm/s^2" && lower_case(*v) != "cm/s2")
      lines.fail(fmt::format("UNITS is '{}', must be cm/s^2; give a file of accelerations", shown(*v)));
    header.unit_is_cm = true;
  }
}

GroundMotion parse_esm_motion(std::string_view text, const std::string& name) {
  TextLines lines(text, name);
  EsmHeader header;
  header.source.file = name;
  std::vector<double> acceleration;  // [g]
  while (const auto given = lines.next()) {
    const std::string_view line = trimmed(*given);
    if (line.empty()) continue;
    if (acceleration.empty() && line.find(':') != std::string_view::npos) {
      read_esm_line(line, header, lines);
      continue;
    }
    if (!header.step || !header.count || !header.unit_is_cm)
      lines.fail_whole("is an ESM file whose header lacks SAMPLING_INTERVAL_S, NDATA or UNITS");
    if (acceleration.size() == *header.count)
      lines.fail(fmt::format("more samples than the {} of NDATA", *header.count));
    acceleration.push_back(lines.require_number(line, "acceleration") * gal_in_g);
  }
  if (!header.step || !header.count) lines.fail_whole("is an ESM file without samples");
  return motion_from_g(std::move(acceleration), *header.count, *header.step, {}, std::move(header.source), lines);
}

// K-NET and KiK-net (NIED): a head from "Origin Time" to "Memo.", then integers, eight per line.

struct KnetHeader {
  MotionSource source;
  double rate = 0, factor = 0, duration = 0;  // [Hz], [g], [s]
};

/// "3920(gal)/6182761": gal per integer unit.
double scale_factor(std::string_view text, const TextLines& lines) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos || lower_case(text).find("gal") == std::string::npos)
    lines.fail(fmt::format("Scale Factor is '{}', must be like 3920(gal)/6182761", shown(text)));
  const double below = lines.require_number(trimmed(text.substr(slash + 1)), "Scale Factor");
  if (!(below > 0)) lines.fail("Scale Factor is divided by a number that is not above 0");
  return leading_number(text, "Scale Factor", lines) / below;
}

void read_knet_line(std::string_view line, KnetHeader& header, const TextLines& lines) {
  if (const auto v = value_of(line, "sampling freq(hz)")) header.rate = leading_number(*v, "Sampling Freq", lines);
  if (const auto v = value_of(line, "duration time(s)")) header.duration = leading_number(*v, "Duration Time", lines);
  if (const auto v = value_of(line, "scale factor")) header.factor = scale_factor(*v, lines) * gal_in_g;
  if (const auto v = value_of(line, "origin time")) header.source.title = "earthquake of " + std::string(*v);
  if (const auto v = value_of(line, "station code")) header.source.agency = "K-NET or KiK-net, " + std::string(*v);
  if (const auto v = value_of(line, "dir.")) header.source.component = *v;
}

GroundMotion parse_knet_motion(std::string_view text, const std::string& name) {
  TextLines lines(text, name);
  KnetHeader header;
  header.source.file = name;
  std::vector<double> acceleration;  // [g]
  bool in_head = true;
  while (const auto given = lines.next()) {
    const std::string_view line = trimmed(*given);
    if (in_head) {
      in_head = !lower_case(line).starts_with("memo");
      read_knet_line(line, header, lines);
      if (!in_head && (!(header.rate > 0) || !(header.factor > 0)))
        lines.fail_whole("is a K-NET file whose header lacks Sampling Freq(Hz) or Scale Factor");
      continue;
    }
    for (const std::string_view word : words_of(line))
      acceleration.push_back(lines.require_number(word, "sample") * header.factor);
  }
  if (in_head) lines.fail_whole("is a K-NET file whose header does not end with 'Memo.'");
  const auto announced = static_cast<std::size_t>(std::clamp(std::floor(header.duration * header.rate), 0.0, 1e9));
  return motion_from_g(std::move(acceleration), announced, 1 / header.rate, {}, std::move(header.source), lines);
}

// Formats that are recognised but not read.

[[noreturn]] GroundMotion refuse_volume(std::string_view text, const std::string& name) {
  TextLines(text, name)
      .fail_whole(
          "is a volume of processed strong motion (COSMOS, CSMIP, USGS or GeoNet), which is not supported: its header "
          "and its blocks of velocity and displacement are bare numbers. Export its acceleration as a PEER AT2 file, "
          "or copy that block to a file and give unit, dt and skip (header lines, 0 if none)");
}

[[noreturn]] GroundMotion refuse_binary(std::string_view text, const std::string& name) {
  TextLines(text, name)
      .fail_whole(
          "is a binary file (SAC, miniSEED, MATLAB or another), which is not supported; export the acceleration as "
          "text");
}

bool has_any(std::string_view text, std::initializer_list<std::string_view> marks) {
  return std::any_of(marks.begin(), marks.end(), [text](std::string_view m) { return text.find(m) != text.npos; });
}

}  // namespace

MotionFormat named_format(std::string_view text, const std::string& file) {
  const std::string begin = lower_case(text.substr(0, 4000));
  const std::string end = lower_case(std::filesystem::path(file).extension().string());
  const std::size_t first = std::min(begin.find_first_not_of(" \t\r\n"), begin.size());
  if (begin.find('\0') != std::string::npos) return {"a binary file", "", refuse_binary};
  if (begin.substr(first).starts_with('#'))
    return has_any(begin, {"# units:", "#units:"}) && has_any(begin, {"# npts:", "#npts:"})
               ? MotionFormat{"a CSV record of the project", "g", parse_csv_motion}
               : MotionFormat{};
  if (begin.find("sampling_interval_s:") != std::string::npos) return {"an ESM file", "cm/s2", parse_esm_motion};
  if (begin.substr(first).starts_with("origin time")) return {"a K-NET file", "gal", parse_knet_motion};
  if (end == ".at2" || names_samples_in_fourth_line(text, false) || names_samples_in_fourth_line(text, true))
    return {"a PEER AT2 file", "g", parse_peer_motion};
  const bool volume = has_any(begin, {"corrected accelerogram", "uncorrected accelero", "integer-header", "real-header",
                                      "accel data equally spaced", "acceleration pts"});
  if (volume || end == ".v1" || end == ".v2" || end == ".v1a" || end == ".v2a" || end == ".v3" || end == ".smc")
    return {"a volume of processed strong motion", "", refuse_volume};
  return {};
}

}  // namespace trilith
