// The model in a report: bodies, materials, laws and bearings.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "base/quantity_text.hpp"
#include "report/sections.hpp"
#include "results/file/body_mass.hpp"

namespace trilith::report {
namespace {

constexpr std::size_t most_rows = 24;

/// Bodies of equal kind, material, first group and support.
struct Sort {
  std::size_t count = 0;
  double mass = 0, least = 0, most = 0;
};

std::string mass_range(const Sort& sort, const UnitSystem& units) {
  if (sort.count < 2 || sort.most - sort.least < 1e-9 * sort.most) return shown_mass(sort.least, units);
  return shown_mass(sort.least, units) + " to " + shown_mass(sort.most, units);
}

void write_bodies(const results::Header& header, const UnitSystem& units, HtmlText& html) {
  std::map<std::tuple<std::string, std::string, std::string, std::string>, Sort> sorts;
  double total = 0;
  for (const results::BodyRow& body : header.bodies) {
    const double mass = results::mass_of(header, body);
    Sort& sort = sorts[{body.groups.substr(0, body.groups.find(' ')), body.kind, body.material, body.support}];
    sort.least = sort.count == 0 ? mass : std::min(sort.least, mass);
    sort.most = std::max(sort.most, mass);
    sort.mass += mass;
    total += mass;
    ++sort.count;
  }
  std::vector<std::vector<std::string>> rows;
  Sort rest;
  for (const auto& [key, sort] : sorts) {
    if (rows.size() + 1 >= most_rows) {
      rest.count += sort.count, rest.mass += sort.mass;
      continue;
    }
    const auto& [group, kind, material, support] = key;
    rows.push_back({group.empty() ? "–" : group, kind, material.empty() ? "–" : material, support,
                    fmt::format("{}", sort.count), mass_range(sort, units), shown_mass(sort.mass, units)});
  }
  if (rest.count > 0)
    rows.push_back({"others", "", "", "", fmt::format("{}", rest.count), "", shown_mass(rest.mass, units)});
  rows.push_back({"all", "", "", "", fmt::format("{}", header.bodies.size()), "", shown_mass(total, units)});
  html.table({"Group", "Kind", "Material", "Support", "Bodies", "Mass of one", "Mass"}, rows, 4);
}

/// "bonded{kn=5e9 Pa/m, mu=0.6 1}" as "bonded: kn = 5e9 Pa/m, mu = 0.6".
std::string plain_law(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char next = i + 1 < text.size() ? text[i + 1] : ',';
    if (text[i] == '{')
      out += next == '}' ? "" : ": ";
    else if (text[i] == '=')
      out += " = ";
    else if (text.compare(i, 2, " 1") == 0 && (i + 2 == text.size() || text[i + 2] == ',' || text[i + 2] == '}'))
      ++i;  // the unit of a dimensionless number
    else if (text[i] != '}')
      out += text[i];
  }
  return out;
}

/// At most `most` of the names and how many more there are.
std::string some_of(const std::vector<std::string>& names, std::size_t most) {
  if (names.size() <= most + 1) return fmt::format("{}", fmt::join(names, "; "));
  return fmt::format("{}; and {} more",
                     fmt::join(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(most), "; "),
                     names.size() - most);
}

/// "brick (units)" from "brick (units storey_1 course_1)".
std::string short_label(const std::string& surface) {
  const std::size_t bracket = surface.find('('), blank = surface.find(' ', bracket);
  return bracket == std::string::npos || blank == std::string::npos ? surface : surface.substr(0, blank) + ")";
}

/// Each pair once.
void add_pair(const std::string& first, const std::string& second, std::vector<std::string>& pairs) {
  const auto& [a, b] = std::minmax(first, second);
  std::string pair = a == b ? "among " + a : a + " – " + b;
  if (std::find(pairs.begin(), pairs.end(), pair) == pairs.end()) pairs.push_back(std::move(pair));
}

/// Names that share a law, by role, name and text of the law, in the order of appearance.
struct LawUse {
  std::string name, role, text;
  std::vector<std::string> users;
};

void write_laws(const results::Header& header, HtmlText& html) {
  std::vector<LawUse> uses;
  std::map<std::tuple<std::string, std::string, std::string>, std::size_t> known;
  for (const results::LawRow& law : header.laws) {
    if (law.role == "section") continue;  // with the members
    const auto [at, fresh] = known.try_emplace({law.role, law.name, law.text}, uses.size());
    if (fresh) uses.push_back({law.name, law.role, law.text, {}});
    if (!law.first.empty() || !law.second.empty())
      add_pair(short_label(law.first), short_label(law.second), uses[at->second].users);
  }
  std::vector<std::vector<std::string>> rows;
  for (const LawUse& use : uses)
    rows.push_back({use.name, use.role, plain_law(use.text), use.users.empty() ? "–" : some_of(use.users, 4)});
  if (!rows.empty())
    html.element("h3", "Materials and contact laws").table({"Name", "Role", "Law and parameters", "Between"}, rows, 4);
}

void write_bearings(const results::Header& header, HtmlText& html) {
  if (header.bearings.empty()) return;
  std::vector<LawUse> uses;
  std::map<std::string, std::size_t> known;
  for (const results::BearingRow& b : header.bearings) {
    const auto [at, fresh] = known.try_emplace(b.law, uses.size());
    if (fresh) uses.push_back({"", "", b.law, {}});
    uses[at->second].users.push_back(
        fmt::format("{} ({} – {})", b.name, header.bodies[b.body_a].name, header.bodies[b.body_b].name));
  }
  std::vector<std::vector<std::string>> rows;
  for (const LawUse& use : uses) {
    if (rows.size() == most_rows) {
      rows.push_back({fmt::format("{} other laws", uses.size() - rows.size()), "see the results file"});
      break;
    }
    rows.push_back({some_of(use.users, 12), plain_law(use.text)});
  }
  html.element("h3", fmt::format("Bearings: {}", header.bearings.size()))
      .table({"Bearing", "Law and parameters"}, rows, 2);
}

std::string units_text(const UnitSystem& units) {
  if (units.is_si())
    return "SI units throughout, with the usual prefixes: m, kg (1 t = 1,000 kg), s, N, Pa, J. Contact stiffness is "
           "per "
           "area and length, Pa/m.";
  return fmt::format(
      "Units of the model throughout: {}, {} and s, so stresses are in {}, masses in {}. Contact stiffness is per area "
      "and length, {}. The results file is in SI.",
      units.force(), units.length(), printed_unit(units.name("Pa")), printed_unit(units.name("kg")),
      printed_unit(units.name("Pa/m")));
}

}  // namespace

void write_model(const ReportSource& source, HtmlText& html) {
  const results::Header& header = source.header;
  html.element("h2", "Model");
  write_bodies(header, source.units, html);
  html.element("p",
               fmt::format("A model in {} dimensions; {} points upwards, angles are anticlockwise, times count{}. "
                           "{}",
                           header.dim, header.dim == 2 ? "y" : "z",
                           source.origin.since.empty() ? " from the start of the run" : source.origin.text(),
                           units_text(source.units)),
               R"(class="note")");
  write_laws(header, html);
  write_bearings(header, html);
}

}  // namespace trilith::report
