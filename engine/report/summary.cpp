// Head of a report: title, state, verdict; parameters, ground motions and stages.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/quantity_text.hpp"
#include "base/space.hpp"
#include "report/sections.hpp"
#include "results/file/placement.hpp"
#include "results/reading/event_tree.hpp"
#include "results/reading/verdict.hpp"

namespace trilith::report {
namespace {

constexpr std::string_view motion_note = "ground motion: ";

/// "1 bearing", "4 bearings".
std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

/// In a sentence: "a", "a and b", "a, b and c".
std::string listed(const std::vector<std::string>& parts) {
  if (parts.size() < 2) return parts.empty() ? "" : parts.front();
  return fmt::format("{} and {}", fmt::join(parts.begin(), parts.end() - 1, ", "), parts.back());
}

/// "21 November 2026, 09:08 UTC" from "2026-11-21T09:08:29Z"; other texts as they are.
std::string plain_date(const std::string& iso) {
  static constexpr const char* months[] = {"January", "February", "March",     "April",   "May",      "June",
                                           "July",    "August",   "September", "October", "November", "December"};
  int year = 0, month = 0, day = 0, hour = 0, minute = 0;
  if (std::sscanf(iso.c_str(), "%4d-%2d-%2dT%2d:%2d", &year, &month, &day, &hour, &minute) != 5) return iso;
  if (month < 1 || month > 12) return iso;
  return fmt::format("{} {} {}, {:02}:{:02} UTC", day, months[month - 1], year, hour, minute);
}

bool is_free(const results::BodyRow& body) {
  return body.support.empty() || body.support.find("free") != std::string::npos;
}

/// A row of positions; in the plane z is 0.
Vec3 place_of(const results::Header& header, const std::vector<double>& places, int row) {
  const double* at = places.data() + static_cast<std::size_t>(header.dim) * static_cast<std::size_t>(row);
  return {at[0], at[1], header.dim == 3 ? at[2] : 0};
}

/// Depth of a polyhedron [m]: its least width across one of its faces, or the diameter of its smallest sphere.
double depth_of_solid(const results::Header& header, const results::BodyRow& body) {
  double depth = std::numeric_limits<double>::infinity();
  for (int f = body.first_face; f < body.first_face + body.face_count; ++f) {
    const auto corner = [&](int k) {
      return place_of(header, header.vertices, header.face_vertex[header.face_first[f] + k]);
    };
    Vec3 normal = Vec3::Zero();
    for (int k = 1; k + 1 < header.face_first[f + 1] - header.face_first[f]; ++k)
      normal += cross(Vec3(corner(k) - corner(0)), Vec3(corner(k + 1) - corner(0)));
    double width = 0;
    for (int v = body.first_vertex; v < body.first_vertex + body.vertex_count; ++v)
      width = std::max(width, std::abs(normal.normalized().dot(place_of(header, header.vertices, v) - corner(0))));
    depth = std::min(depth, width);
  }
  const auto first = std::lower_bound(header.sphere_vertex.begin(), header.sphere_vertex.end(), body.first_vertex);
  for (auto at = first; at != header.sphere_vertex.end() && *at < body.first_vertex + body.vertex_count; ++at)
    depth = std::min(depth, 2 * header.sphere_radius[static_cast<std::size_t>(at - header.sphere_vertex.begin())]);
  return std::isfinite(depth) ? depth : 0;
}

/// Depth of a body [m]: its area over the largest distance between two of its corners.
double depth_of(const results::Header& header, const results::BodyRow& body, const results::Placement& start) {
  if (header.dim == 3) return depth_of_solid(header, body);
  std::vector<Vec3> points;
  for (int v = body.first_vertex; v < body.first_vertex + body.vertex_count; ++v) points.push_back(start.vertex(v));
  double length = 0, area = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 a = points[i] - points[0], b = points[(i + 1) % points.size()] - points[0];
    area += 0.5 * (a.x() * b.y() - a.y() * b.x());
    for (const Vec3& p : points) length = std::max(length, (points[i] - p).norm());
  }
  return length > 0 ? std::abs(area) / length : 0;
}

/// Mean displacement of the ground bodies [m].
Vec3 ground_way(const results::Header& header, const results::Frame& frame) {
  Vec3 sum = Vec3::Zero();
  int count = 0;
  for (const results::BodyRow& body : header.bodies) {
    if (is_free(body)) continue;
    sum += place_of(header, frame.position, body.first_node) - place_of(header, header.node_position, body.first_node);
    ++count;
  }
  return sum / std::max(count, 1);
}

/// Number of free bodies, and of free bodies that have moved at the end.
struct Moved {
  std::size_t free = 0, moved = 0;
};

/// Displacements of more than half of a body's depth count. Zero if it cannot be determined.
Moved moved_bodies(const ReportSource& source) {
  const results::Header& header = source.header;
  Moved out;
  if (source.reader.frame_count() == 0 || (header.dim == 3 && header.face_count() == 0 && header.sphere_vertex.empty()))
    return out;
  const results::Frame last = source.reader.frame(source.reader.frame_count() - 1);
  const results::Frame first = results::start_frame(header);
  const results::Placement start(header, first);
  const Vec3 ground = ground_way(header, last);
  for (const results::BodyRow& body : header.bodies) {
    if (!is_free(body)) continue;
    ++out.free;
    const Vec3 way = place_of(header, last.position, body.first_node) -
                     place_of(header, header.node_position, body.first_node) - ground;
    out.moved += 2 * way.norm() > depth_of(header, body, start) ? 1 : 0;
  }
  return out;
}

std::string why_text(const std::string& why) {
  if (why == "rest") return "at rest";
  if (why == "time") return "at the end of its duration";
  return why.empty() ? "without a recorded reason" : why;
}

std::string ending(const ReportSource& source) {
  const std::vector<double>& times = source.reader.frame_times();
  const double reached = times.empty() ? 0 : times.back();
  if (source.reader.running())
    return fmt::format("The run is still in progress and is reported here up to {}", source.clock(reached));
  if (!source.reader.finished())
    return fmt::format("The run was stopped before its end and is reported here up to {}", source.clock(reached));
  if (source.stages.empty() || !source.stages.back().ended)
    return fmt::format("The run ended at {}", source.clock(reached));
  const results::StageRow& last = source.stages.back();
  return fmt::format("The run ended at {}, after {} of the stage “{}”: {}", source.clock(last.end),
                     shown_time(last.end - last.begin), last.name, why_text(last.why));
}

/// Failures as shares of the total; "nothing failed" without failures and displaced bodies.
std::string losses(const ReportSource& source) {
  const auto count = [&](std::string_view type) {
    return static_cast<std::size_t>(std::count_if(source.events.begin(), source.events.end(),
                                                  [&](const results::EventRow& e) { return e.type == type; }));
  };
  std::vector<std::string> parts;
  if (const std::size_t n = count("bearing.failed"); n > 0)
    parts.push_back(fmt::format("{} of {} failed", n, counted(source.header.bearings.size(), "bearing", "bearings")));
  if (const std::size_t n = count("member.failed"); n > 0)
    parts.push_back(counted(n, "hinge of a member", "hinges of members") + " lost the moment");
  if (const std::size_t n = count("seat.lost"); n > 0) parts.push_back(counted(n, "seat was", "seats were") + " lost");
  if (const std::size_t n = count("bond.broken"); n > 0) parts.push_back(counted(n, "bond", "bonds") + " broke");
  if (const std::size_t n = count("body.left"); n > 0)
    parts.push_back(counted(n, "body", "bodies") + " left the bounds");
  const Moved bodies = moved_bodies(source);
  if (bodies.moved > 0)
    parts.push_back(fmt::format("{} of {} free bodies moved by more than half their depth relative to the ground",
                                bodies.moved, bodies.free));
  const bool unbroken = parts.empty();
  const std::vector<std::string> members = member_verdict(source);
  const bool yielded = !members.empty() && members.front().find(" members yielded (") != std::string::npos;
  parts.insert(parts.end(), members.begin(), members.end());
  if (unbroken && !yielded && results::results_verdict(source.reader, source.events).sound())
    parts.emplace_back("nothing failed");
  if (bodies.moved == 0 && bodies.free > 0)
    parts.emplace_back("no body moved by more than half its depth relative to the ground");
  return parts.empty() ? "no losses are recorded" : listed(parts);
}

/// Name of the stage and time within it at the event.
std::string within_stage(const ReportSource& source, const results::EventRow& e) {
  if (e.stage < 0 || static_cast<std::size_t>(e.stage) >= source.stages.size()) return "";
  const results::StageRow& stage = source.stages[static_cast<std::size_t>(e.stage)];
  return fmt::format(", {} into the stage “{}”", shown_time(e.time - stage.begin), stage.name);
}

std::string first_failure(const ReportSource& source) {
  const auto first = std::find_if(source.events.begin(), source.events.end(), results::is_failure);
  if (first == source.events.end()) return "No bearing, seat or bond was lost.";
  const std::string what = first->text.empty() ? first->type : first->text;
  return fmt::format("The first failure occurred at {}{}: {}.", source.clock(first->time), within_stage(source, *first),
                     what);
}

}  // namespace

std::vector<std::string> motion_texts(const ReportSource& source) {
  std::vector<std::string> out = source.header.provenance.motions;
  for (const results::Note& note : source.notes)
    if (note.text.starts_with(motion_note)) out.push_back(note.text.substr(motion_note.size()));
  return out;
}

std::string shown_mass(double kilograms, const UnitSystem& units) {
  if (!units.is_si()) return quantity_text(kilograms, "kg", 4, units);
  if (kilograms < 1e4) return fmt::format("{:.4g} kg", kilograms);
  if (kilograms < 1e7) return fmt::format("{:.4g} t", kilograms / 1000);
  const std::string tonnes = fmt::format("{:.0f}", kilograms / 1000);
  std::string out;
  for (std::size_t i = 0; i < tonnes.size(); ++i) {
    if (i > 0 && (tonnes.size() - i) % 3 == 0) out += ',';
    out += tonnes[i];
  }
  return out + " t";
}

std::string shown_time(double seconds) {
  return fmt::format("{:.3f} s", seconds);
}

std::string ReportSource::clock(double time) const {
  return shown_time(time - origin.zero);
}

std::string verdict(const ReportSource& source) {
  return fmt::format("{}: {}. {}", ending(source), losses(source), first_failure(source));
}

void write_head(const ReportSource& source, HtmlText& html) {
  const results::Provenance& from = source.header.provenance;
  html.open("header").element("p", "Report of a run", R"(class="kind")");
  html.element("h1", source.reader.title());
  html.open("p", R"(class="by")");
  if (!from.model.empty()) html.text(source.reader.path().filename().string() + " · ");
  html.text(from.script_path.empty() ? "no script" : from.script_path);
  if (!from.start_time.empty()) html.text(" · run on " + plain_date(from.start_time));
  if (!from.program_version.empty()) html.text(" · Trilith " + from.program_version);
  html.close().close();
  if (!source.reader.finished())
    html.element("p",
                 source.reader.running()
                     ? "Not finished: a run is writing this file. The report covers it up to its last flush."
                     : "Not finished: the run stopped early. The report covers it up to its last flush.",
                 R"(class="warning")");
  const Verdict found = results::results_verdict(source.reader, source.events);
  if (!found.sound())
    html.element("p", fmt::format("This run is {}.", found.text(source.origin.zero)), R"(class="warning")");
  html.element("p", verdict(source), R"(class="verdict")");
  std::vector<std::string> remarks;
  for (const results::Note& note : source.notes)
    if (!note.text.starts_with(motion_note))
      remarks.push_back(fmt::format("{}: {}", source.clock(note.time), note.text));
  if (remarks.empty()) return;
  html.element("h3", "Notes and warnings").open("ul");
  for (const std::string& remark : remarks) html.element("li", remark);
  html.close();
}

void write_parameters(const ReportSource& source, HtmlText& html) {
  const std::vector<results::ParameterRow>& rows = source.header.provenance.parameters;
  if (rows.empty()) return;
  html.element("h2", "Parameters");
  html.element("p", "As the script declares them; values that differ from their default are bold.", R"(class="note")");
  html.open("table").open("thead").open("tr");
  for (const char* heading : {"Parameter", "Value", "Unit", "Default", "Description"}) html.element("th", heading);
  html.close().close().open("tbody");
  for (const results::ParameterRow& row : rows) {
    html.open("tr").element("td", row.name).open("td");
    if (row.value != row.fallback)
      html.open("b").verbatim(row.value).close();
    else
      html.verbatim(row.value);
    html.close();
    for (const std::string& text : {row.unit, row.fallback, row.text}) html.open("td").verbatim(text).close();
    html.close();
  }
  html.close().close();
}

void write_stages(const ReportSource& source, HtmlText& html) {
  html.element("h2", "Stages");
  if (source.stages.empty()) {
    html.element("p", "No stage has begun.");
    return;
  }
  std::vector<std::vector<std::string>> rows;
  for (const results::StageRow& s : source.stages)
    rows.push_back({s.name, s.kind, s.ended ? s.why : "not ended", source.clock(s.begin),
                    s.ended ? source.clock(s.end) : "–", s.ended ? shown_time(s.end - s.begin) : "–"});
  html.table({"Stage", "Kind", "Ended by", "From", "To", "Long"}, rows, 3);
}

}  // namespace trilith::report
