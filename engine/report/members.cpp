// Members of frames in a report: their table, envelopes of section forces, and their part of the verdict.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "base/quantity_text.hpp"
#include "draw/results/results_picture.hpp"
#include "report/sections.hpp"
#include "results/reading/member_summary.hpp"

namespace trilith::report {
namespace {

using results::MemberSummary;

constexpr std::size_t most_members = 60, most_named = 4;

std::string shown_name(const results::Header& header, const results::MemberRow& member) {
  const std::string& body = header.bodies[static_cast<std::size_t>(member.body)].name;
  return member.name == body ? body : fmt::format("{}, {}", body, member.name);
}

/// "-12 to 34 kN m".
std::string range_text(const MemberSummary& summary, std::size_t quantity, const std::string& unit,
                       const UnitSystem& units) {
  const double low = summary.low[quantity].value, high = summary.high[quantity].value;
  const double most = std::max(std::abs(low), std::abs(high));
  const ShownUnit shown = engineering_unit(most, unit, units);
  const auto text = [&](double v) { return fmt::format("{:.3g}", std::abs(v) < 1e-6 * most ? 0 : v / shown.size); };
  return with_minus(fmt::format("{} to {} {}", text(low), text(high), shown.text));
}

std::string state_text(const results::MemberRow& member, const MemberSummary& summary) {
  if (member.yields == "elastic") return "elastic material";
  const char* const part = member.yields == "fibres" ? "beams of fibres" : "hinges";
  std::string text = summary.yielded == 0
                         ? fmt::format("elastic ({} {})", summary.can_yield, part)
                         : fmt::format("{} of {} {} yielded", summary.yielded, summary.can_yield, part);
  if (summary.state == results::MemberState::lost) text += ", one without moment";
  if (summary.state == results::MemberState::removed) text += ", removed";
  return text;
}

std::string deformation_text(const results::MemberRow& member, const MemberSummary& summary, const UnitSystem& units) {
  if (member.yields == "elastic" || summary.deformation.value == 0) return "–";
  return quantity_text(std::abs(summary.deformation.value), member.yields == "fibres" ? "1/m" : "rad", units);
}

/// "Bending moment" from "bending moment, on the side in tension".
std::string quantity_heading(const results::MemberQuantity& quantity) {
  std::string text = quantity.label.substr(0, quantity.label.find(','));
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

void write_forces(const ReportSource& source, const std::vector<MemberSummary>& summaries, HtmlText& html) {
  const results::Header& header = source.header;
  const std::vector<results::MemberQuantity>& quantities = results::member_quantities(header.dim);
  std::vector<std::string> heading{"Member"};
  for (const results::MemberQuantity& q : quantities) heading.push_back(quantity_heading(q));
  std::vector<std::vector<std::string>> rows;
  for (std::size_t m = 0; m < std::min(most_members, summaries.size()); ++m) {
    rows.push_back({shown_name(header, header.members[m])});
    for (std::size_t q = 0; q < quantities.size(); ++q)
      rows.back().push_back(range_text(summaries[m], q, quantities[q].unit, source.units));
  }
  html.table(heading, rows, 1);
  std::string note = "Smallest and largest values of the recorded frames.";
  if (summaries.size() > most_members)
    note +=
        fmt::format(" {} further members are in the table members of trilith export.", summaries.size() - most_members);
  html.element("p", note, R"(class="note")");
}

void write_yielding(const ReportSource& source, const std::vector<MemberSummary>& summaries, HtmlText& html) {
  const results::Header& header = source.header;
  std::vector<std::vector<std::string>> rows;
  for (std::size_t m = 0; m < std::min(most_members, summaries.size()); ++m) {
    const results::MemberRow& member = header.members[m];
    const MemberSummary& own = summaries[m];
    rows.push_back({shown_name(header, member), state_text(member, own), deformation_text(member, own, source.units),
                    own.ductility ? fmt::format("{:.2f}", *own.ductility) : "–",
                    own.drift ? percent_text(own.drift->value) : "–"});
  }
  html.table({"Member", "Yielding", "Plastic rotation or curvature", "Ductility demand", "Drift"}, rows, 2);
  html.element(
      "p",
      "Ductility demand of fibres: the largest curvature over the curvature at the first yield; of hinges: 1 + "
      "plastic rotation over M L / 6EI. Drift: horizontal displacement between the ends of an upright member "
      "over its height.",
      R"(class="note")");
}

/// Laws of hinges, of fibres and of bars of the sections.
void write_sections(const results::Header& header, HtmlText& html) {
  std::vector<std::vector<std::string>> rows;
  for (const results::LawRow& law : header.laws)
    if (law.role == "section") rows.push_back({law.first, law.text});
  if (!rows.empty()) html.element("h3", "Sections").table({"Members", "Section and laws"}, rows, 2);
}

}  // namespace

std::vector<std::string> member_verdict(const ReportSource& source) {
  const results::Header& header = source.header;
  const std::vector<MemberSummary> summaries = results::member_summaries(source.reader, source.events);
  std::vector<std::string> names, parts;
  std::size_t yielding = 0, most = 0, swayed = summaries.size();
  bool can_yield = false;
  for (std::size_t m = 0; m < summaries.size(); ++m) {
    const MemberSummary& own = summaries[m];
    can_yield = can_yield || own.can_yield > 0;
    if (own.drift && (swayed == summaries.size() || own.drift->value > summaries[swayed].drift->value)) swayed = m;
    if (own.yielded == 0) continue;
    if (yielding++ < most_named) names.push_back(header.members[m].name);
    if (own.ductility.value_or(0) > summaries[most].ductility.value_or(0)) most = m;
  }
  if (yielding > most_named) names.push_back(fmt::format("{} more", yielding - most_named));
  if (yielding > 0)
    parts.push_back(fmt::format("{} of {} members yielded ({})", yielding, summaries.size(), fmt::join(names, ", ")));
  else if (can_yield)
    parts.emplace_back("no member yielded");
  if (yielding > 0 && summaries[most].ductility)
    parts.push_back(fmt::format("the largest ductility demand is {:.2g} in the member {}", *summaries[most].ductility,
                                header.members[most].name));
  if (swayed < summaries.size())
    parts.push_back(fmt::format("the largest drift is {} in the member {} at {}",
                                percent_text(summaries[swayed].drift->value), header.members[swayed].name,
                                source.clock(summaries[swayed].drift->time)));
  return parts;
}

void write_members(const ReportSource& source, HtmlText& html) {
  const std::vector<MemberSummary> summaries = results::member_summaries(source.reader, source.events);
  if (summaries.empty()) return;
  html.element("h2", "Members");
  write_forces(source, summaries, html);
  write_yielding(source, summaries, html);
  write_sections(source.header, html);
  for (const results::MemberQuantity& q : results::member_quantities(source.header.dim)) {
    if (q.name.starts_with("torque")) continue;
    write_figure(html, "members-" + q.name, fmt::format("Envelope of all recorded frames: {}.", q.label), [&] {
      draw::SceneChoice choice;
      choice.diagram = q.name, choice.envelope = true, choice.origin = source.origin;
      draw::Scene scene = draw::results_scene(source.reader, source.reader.frame_times().back(), choice);
      scene.title.clear(), scene.time.reset(), scene.event.clear();
      draw::PictureStyle style;
      style.height = 300, style.units = source.units;
      return draw::scene_canvas({scene}, 1, style);
    });
  }
}

}  // namespace trilith::report
