// Private to report/: the parts of a report (report.hpp), each of which writes whole elements.
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

/// What every part needs, read once.
struct ReportSource {
  const results::ResultsReader& reader;
  const results::Header& header;
  std::vector<results::EventRow> events;   ///< all
  std::vector<results::EventRow> of_note;  ///< see events_of_note
  std::vector<results::StageRow> stages;
  std::vector<results::Note> notes;
  std::vector<std::filesystem::path> record_folders;
  results::TimeOrigin origin;  ///< what instants count from
  /// An instant of the run, as shown_time of it since the origin.
  [[nodiscard]] std::string clock(double time) const;
};

/// A figure in words as tables show it; masses from 10,000 kg in t.
std::string shown_mass(double kilograms);
/// Seconds to the millisecond.
std::string shown_time(double seconds);

/// Two sentences: how the run ended and what became of the structure; what failed first.
std::string verdict(const ReportSource& source);

/// What the file says of each ground motion, in its words.
std::vector<std::string> motion_texts(const ReportSource& source);

/// An SVG in its place; `name` is this figure's alone. What the drawing refuses is told there: the rest of the report
/// is worth having.
void write_figure(HtmlText& html, std::string_view name, const std::string& caption,
                  const std::function<draw::Canvas()>& draw);

void write_head(const ReportSource& source, HtmlText& html);
void write_model(const ReportSource& source, HtmlText& html);
void write_parameters(const ReportSource& source, HtmlText& html);
void write_motions(const ReportSource& source, HtmlText& html);
void write_stages(const ReportSource& source, HtmlText& html);
void write_pictures(const ReportSource& source, HtmlText& html);
void write_events(const ReportSource& source, HtmlText& html);
void write_histories(const ReportSource& source, HtmlText& html);
void write_energy(const ReportSource& source, HtmlText& html);
/// Nothing where the file has no joints.
void write_damage(const ReportSource& source, HtmlText& html);
void write_seal(const ReportSource& source, const ReportProgress& progress, HtmlText& html);
void write_reproduction(const ReportSource& source, HtmlText& html);

/// The page's own style.
const char* report_style();

}  // namespace trilith::report
