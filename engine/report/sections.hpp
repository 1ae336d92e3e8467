// Private to report/: the parts of a report (report.hpp), each of which writes complete elements.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "draw/canvas.hpp"
#include "report/html_text.hpp"
#include "report/report.hpp"

namespace trilith::report {

/// Data for all parts, read once.
struct ReportSource {
  const results::ResultsReader& reader;
  const results::Header& header;
  std::vector<results::EventRow> events;   ///< all
  std::vector<results::EventRow> of_note;  ///< see events_of_note
  std::vector<results::StageRow> stages;
  std::vector<results::Note> notes;
  std::vector<std::filesystem::path> record_folders;
  results::TimeOrigin origin;  ///< origin of times
  UnitSystem units;            ///< in which numbers are shown
  /// Time of the run as shown_time relative to the origin.
  [[nodiscard]] std::string clock(double time) const;
};

/// A mass as text in tables; in SI from 10,000 kg in t.
std::string shown_mass(double kilograms, const UnitSystem& units);
/// Seconds with three decimals.
std::string shown_time(double seconds);

/// Two sentences: end of the run and state of the structure, and the first failure.
std::string verdict(const ReportSource& source);

/// Descriptions of the ground motions in the file.
std::vector<std::string> motion_texts(const ReportSource& source);

/// Writes an SVG; `name` must be unique. An error of the drawing is printed in its place, so that the rest of the
/// report remains.
void write_figure(HtmlText& html, std::string_view name, const std::string& caption,
                  const std::function<draw::Canvas()>& draw);

void write_head(const ReportSource& source, HtmlText& html);
void write_model(const ReportSource& source, HtmlText& html);
void write_parameters(const ReportSource& source, HtmlText& html);
void write_motions(const ReportSource& source, HtmlText& html);
void write_stages(const ReportSource& source, HtmlText& html);
void write_pictures(const ReportSource& source, HtmlText& html);
/// Writes nothing if the file has no temperatures and no water in joints.
void write_fields(const ReportSource& source, HtmlText& html);
void write_events(const ReportSource& source, HtmlText& html);
void write_histories(const ReportSource& source, HtmlText& html);
void write_energy(const ReportSource& source, HtmlText& html);
/// Writes nothing if the file has no joints.
void write_damage(const ReportSource& source, HtmlText& html);
/// Table and envelopes of the members of frames; nothing if there are none.
void write_members(const ReportSource& source, HtmlText& html);
/// Parts of the verdict: members that yielded, ductility demand, drift; empty without members.
std::vector<std::string> member_verdict(const ReportSource& source);
void write_seal(const ReportSource& source, const ReportProgress& progress, HtmlText& html);
void write_reproduction(const ReportSource& source, HtmlText& html);

/// The page's own style.
const char* report_style();

}  // namespace trilith::report
