#include "load/motion_peer.hpp"

#include <fmt/format.h>

#include "load/motion_samples.hpp"
#include "load/text_lines.hpp"

namespace trilith {

namespace {

// The PEER centre's AT2 form: four lines of header (agency, title, unit, count and step), then samples in g, five or so
// in a line.

struct PeerHeader {
  MotionSource source;
  std::size_t count = 0;
  double step = 0;  // [s]
};

/// The next line without the blanks around it.
std::string_view header_line(TextLines& lines) {
  const auto line = lines.next();
  if (!line) lines.fail_whole("is cut short: an AT2 file has 4 header lines");
  return trimmed(*line);
}

/// Third line, e.g. "ACCELERATION TIME SERIES IN UNITS OF G. FILTER POINTS: ...".
void require_units_of_g(std::string_view line, const TextLines& lines) {
  const std::string lower = lower_case(line);
  const std::string mark = "units of ";
  const auto at = lower.find(mark);
  if (at == std::string::npos)
    lines.fail(fmt::format("must say 'UNITS OF G', says '{}'; is this an AT2 file?", shown(line)));
  const auto words = words_of(std::string_view(lower).substr(at + mark.size()), ",;");
  if (words.empty() || (words[0] != "g" && words[0] != "g."))
    lines.fail(fmt::format("unit is '{}', must be G; convert the values to g and say so here",
                           words.empty() ? "" : shown(words[0])));
}

/// Fourth line: "NPTS=   5372, DT=   .0100 SEC," or "NPTS=  4000, DT= .01000 SEC" or "4000 0.0100 NPTS, DT".
void read_counts(std::string_view line, PeerHeader& header, const TextLines& lines) {
  const std::string lower = lower_case(line);
  const auto words = words_of(lower, "=,");
  const bool names_first = words.size() >= 4 && words[0] == "npts" && words[2] == "dt";
  const bool names_last = words.size() >= 4 && words[2] == "npts" && words[3] == "dt";
  if (!names_first && !names_last)
    lines.fail(fmt::format("must be like 'NPTS= 5372, DT= .0100 SEC', is '{}'", shown(line)));
  header.count = lines.require_count(words[names_first ? 1 : 0], "NPTS");
  header.step = lines.require_number(words[names_first ? 3 : 1], "DT");
  if (!(header.step > 0)) lines.fail(fmt::format("DT is {:g} s, must be above 0", header.step));
}

/// The component is what stands behind the last comma of the title, as in "EL CENTRO, 5/19/1940, ARRAY #9, 180".
PeerHeader read_header(TextLines& lines) {
  PeerHeader header;
  header.source.agency = header_line(lines);
  header.source.title = header_line(lines);
  const auto comma = header.source.title.rfind(',');
  if (comma != std::string::npos) header.source.component = trimmed(header.source.title.substr(comma + 1));
  const std::string_view third = header_line(lines);
  require_units_of_g(third, lines);
  header.source.notes.emplace_back(third);
  read_counts(header_line(lines), header, lines);
  return header;
}

}  // namespace

/// Four lines of header, then samples, several in a line.
GroundMotion parse_peer_motion(std::string_view text, const std::string& name) {
  TextLines lines(text, name);
  PeerHeader header = read_header(lines);
  header.source.file = name;
  std::vector<double> acceleration;  // [g]
  while (const auto line = lines.next()) {
    for (const std::string_view word : words_of(*line)) {
      if (acceleration.size() == header.count)
        lines.fail(fmt::format("more samples than the {} the header announces", header.count));
      acceleration.push_back(lines.require_number(word, "acceleration"));
    }
  }
  return motion_from_g(std::move(acceleration), header.count, header.step, {}, std::move(header.source), lines);
}

}  // namespace trilith
