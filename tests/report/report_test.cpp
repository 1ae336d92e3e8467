#include "report/report.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <set>

#include "report/html_text.hpp"
#include "results/reading/event_tree.hpp"
#include "results/sample_run.hpp"
#include "results/tumbling_boxes.hpp"
#include "source_dir.hpp"

using namespace trilith;
using namespace trilith::results;
using namespace trilith::report;
using namespace trilith::testing;

namespace {

bool has(const std::string& page, const std::string& part) {
  return page.find(part) != std::string::npos;
}

std::size_t count_of(const std::string& page, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = page.find(part); at != std::string::npos; at = page.find(part, at + 1)) ++count;
  return count;
}

/// Empty if every element is closed, innermost first, no bare '<' or '&' remains and no id occurs twice; otherwise the
/// error.
std::string wrong_with(const std::string& page) {
  std::vector<std::string> open;
  std::set<std::string> ids;
  static const std::regex id("\\bid=\"([^\"]*)\"");
  for (std::size_t at = 0; (at = page.find_first_of("<&", at)) != std::string::npos;) {
    if (page[at] == '&') {
      const std::size_t end = page.find(';', at);
      if (open.back() != "style" && (end == std::string::npos || end - at > 7)) return "bare &";
      ++at;
      continue;
    }
    const std::size_t end = page.find('>', at);
    if (end == std::string::npos) return "tag without end";
    const std::string tag = page.substr(at + 1, end - at - 1);
    const std::string name = tag.substr(0, tag.find_first_of(" \n\t"));
    at = end;
    std::smatch match;
    if (std::regex_search(tag, match, id) && !ids.insert(match[1]).second)
      return fmt::format("two of id {}", match[1].str());
    if (tag.front() == '!' || tag.back() == '/') continue;
    if (tag.front() != '/') {
      open.push_back(name);
      continue;
    }
    if (open.empty() || open.back() != name.substr(1)) return fmt::format("closes {}", name);
    open.pop_back();
  }
  return open.empty() ? "" : fmt::format("never closed: {}", open.back());
}

Folder& scratch() {
  static Folder folder;
  return folder;
}

/// Header and rows written, finished or left as by a killed run.
std::string page_of(const Header& header, int rows, bool finished = true) {
  const std::filesystem::path path = scratch() / "sample.h5";
  std::filesystem::remove(path);
  ResultsWriter writer(path, header);
  writer.begin_stage("shake", "dynamic", 0);
  for (int i = 0; i < rows; ++i) SampleRow(header, i).append_to(writer);
  writer.append_note(0.01, "ground motion: somewhere.csv on 'ground' (x)");
  writer.append_note(0.02, "a remark");
  if (finished) writer.end_stage(0.01 * rows, "rest");
  if (finished)
    writer.finish();
  else
    writer.flush();
  return report_page(ResultsReader(path));
}

EventRow event(std::int64_t id, std::int64_t cause, const std::string& type, double speed = 0) {
  EventRow e;
  e.id = id;
  e.cause = cause;
  e.time = static_cast<double>(id);
  e.type = type;
  e.first = {"figure", "m/s", speed};
  e.text = fmt::format("event {};", id);
  return e;
}

}  // namespace

TEST_CASE("a report has verdict, model, parameters, stages, energy, seal and command") {
  const std::string page = page_of(sample_header(), 4);
  CHECK(wrong_with(page) == "");
  CHECK(has(page, "at rest"));
  CHECK(has(page, "4 of 2 bearings failed"));  // the sample's events show this
  CHECK(has(page, "The first failure occurred at 0.000 s"));
  CHECK(has(page, "<td class=\"n\">303 kg</td>"));
  CHECK(has(page, "density 2400 kg/m^3"));
  CHECK(has(page, "fixed, limit 0.05 m"));
  CHECK(has(page, "<b>0.6</b>"));
  CHECK(has(page, "El Centro 1940 NS, 0.35 g"));
  CHECK(has(page, "somewhere.csv on &#39;ground&#39; (x)"));
  CHECK(has(page, "a remark"));
  CHECK(has(page, "top.x"));
  CHECK(has(page, "kinetic energy"));
  CHECK(has(page, "residual"));
  CHECK(has(page, "abc123"));
  CHECK(has(page, "Linux x86_64"));
  CHECK(has(page, "<code>trilith run scripts/bridge.lua pga=0.6</code>"));
  CHECK(has(page, "local θ = 3"));
  CHECK(has(page, "21 November 2025, 09:30 UTC"));
  CHECK(count_of(page, "<figure>") == 3);
  CHECK_FALSE(has(page, "could not be drawn"));
  CHECK_FALSE(has(page, "Not finished"));
}

TEST_CASE("a report needs no network and no script") {
  const std::string page = page_of(sample_header(), 4);
  CHECK_FALSE(has(page, "<script"));
  CHECK_FALSE(has(page, "<link"));
  CHECK_FALSE(has(page, "src="));
  CHECK_FALSE(has(page, "@import"));
  CHECK(count_of(page, "http") == count_of(page, "http://www.w3.org/"));  // names, not addresses
}

TEST_CASE("the same results give the same report, byte by byte, and another motion another digest") {
  const std::string page = page_of(sample_header(), 4);
  CHECK(page == page_of(sample_header(), 4));
  const auto digest = [](const std::string& text) {
    std::smatch match;
    CHECK(std::regex_search(text, match, std::regex("[0-9a-f]{16} \\(")));
    return match.str();
  };
  CHECK(digest(page) != digest(page_of(sample_header(), 5)));
}

TEST_CASE("a motion whose record is found is evaluated again, others are reported as missing") {
  Header header = sample_header();
  header.provenance.motions = {
      "elcentro_1940_rest_ns.csv, scaled to PGA 0.8 g, x 1, time x 0.8, delayed 0.204 s on 'left <ground>' (x), from t "
      "= "
      "1.49667 s",
      "elcentro_1940_rest_ns.csv, turned inside out on 'right ground' (x), from t = 0 s",
      "nowhere.csv on 'right ground' (y), from t = 0 s"};
  const std::filesystem::path path = scratch() / "motions.h5";
  ResultsWriter(path, header).finish();
  const std::string page = report_page(ResultsReader(path), {trilith::testing::source_dir() + "/scripts/records"});
  CHECK(wrong_with(page) == "");
  CHECK(has(page, "&#39;left &lt;ground&gt;&#39; (x): elcentro_1940_rest_ns.csv, scaled to PGA 0.8 g"));
  CHECK(has(page, "<td class=\"n\">0.800 g</td>"));
  CHECK(has(page, "turned inside out on"));
  CHECK(has(page, "nowhere.csv on"));
  CHECK(has(page, "the records were not found"));
  CHECK(count_of(page, "<figure>") == 1);
}

TEST_CASE("texts of a file are escaped in its report") {
  Header header = sample_header();
  const std::string nasty = "<img src=x onerror=\"alert('&')\"></style></script>\x01\xff";
  header.bodies[1].groups = nasty;
  header.bodies[1].material = header.bodies[1].kind = header.bodies[2].support = nasty;
  header.laws[0].text = header.laws[1].first = header.laws[1].name = nasty;
  header.bearings[0].law = header.bearings[0].name = nasty;
  header.histories[0].name = "a<b>&c";
  header.histories[0].description = header.energy_terms[0].description = nasty;
  Provenance& from = header.provenance;
  from.script = from.script_path = from.git_commit = from.compiler = from.platform = nasty;
  from.start_time = from.command_line = from.program_version = nasty;
  from.parameters = {{nasty, nasty, nasty, "", nasty}};
  from.motions = {nasty};
  const std::string page = page_of(header, 3);
  CHECK(wrong_with(page) == "");
  CHECK_FALSE(has(page, "<img"));
  CHECK(count_of(page, "</style>") == 1);
  CHECK_FALSE(has(page, "</script>"));
  CHECK_FALSE(has(page, "\x01"));
  CHECK(has(page, "&lt;img src=x onerror=&quot;alert(&#39;&amp;&#39;)&quot;&gt;"));
}

TEST_CASE("the report of a stopped or barely started run covers its rows, with a notice") {
  const std::string stopped = page_of(sample_header(), 3, false);
  CHECK(wrong_with(stopped) == "");
  CHECK(has(stopped, "Not finished"));
  CHECK(has(stopped, "NOT finished"));
  CHECK(has(stopped, "reported here up to 0.020 s"));
  const std::string empty = page_of(sample_header(), 0, false);
  CHECK(wrong_with(empty) == "");
  CHECK(has(empty, "There is no frame yet"));
  CHECK(has(empty, "no samples of the energy"));
}

TEST_CASE("the report of a model in space has pictures if its file has faces") {
  const std::string page = page_of(sample_header(3, 3), 3);
  CHECK(wrong_with(page) == "");
  CHECK(has(page, "no faces of solids"));

  const std::filesystem::path path = scratch() / "solids.h5";
  record_boxes(path, tumbling_boxes(), 9, 0.1);
  const std::string solids = report_page(ResultsReader(path));
  CHECK(wrong_with(solids) == "");
  CHECK(has(solids, "The structure (a) at 0"));
  CHECK(has(solids, "A model in 3 dimensions; z points upwards"));
  // Two of three free stones have moved by more than half of their 0.1 m.
  CHECK(has(solids, "2 of 3 free bodies moved by more than half their depth"));
}

TEST_CASE("of many histories the eight largest are reported") {
  Header header = sample_header();
  header.histories.clear();
  for (int i = 0; i < 20; ++i) header.histories.push_back({fmt::format("h{}", i), "m", "history"});
  const std::filesystem::path path = scratch() / "many.h5";
  ResultsWriter writer(path, header);
  std::vector<double> values(20);
  for (int k = 0; k < 20; ++k) values[k] = (k * 7) % 20;
  writer.append_history(0, values);
  writer.append_history(1, values);
  writer.finish();
  const std::string page = report_page(ResultsReader(path));
  int shown = 0;
  for (int k = 0; k < 20; ++k) {
    const bool here = has(page, fmt::format("<td>h{}</td>", k));
    CHECK(here == (values[k] >= 12));
    shown += here ? 1 : 0;
  }
  CHECK(shown == 8);
  CHECK(has(page, "12 further histories"));
}

TEST_CASE("an event is listed below its nearest listed cause, in any order of causes") {
  const std::vector<EventRow> all{event(0, -1, "bearing.failed"), event(1, 0, "contact.lost"),
                                  event(2, 1, "contact.made"),    event(3, 2, "seat.lost"),
                                  event(4, 99, "seat.lost"),      event(5, 5, "impact", 3)};
  const EventTree tree = event_tree(all, {all[0], all[3], all[4], all[5]}, 10);
  CHECK(tree.roots == std::vector<std::size_t>{0, 2, 3});
  CHECK(tree.effects[0] == std::vector<std::size_t>{1});
  CHECK(tree.offspring == std::vector<std::size_t>{1, 0, 0, 0});
  CHECK(event_tree({}, {}, 10).rows.empty());
}

TEST_CASE("the initial view of an event tree has the first failure, every lost seat, and their causes") {
  std::vector<EventRow> all{event(0, -1, "bond.broken")};
  for (int i = 1; i < 400; ++i) all.push_back(event(i, i > 2 ? i / 2 : -1, i % 90 == 5 ? "seat.lost" : "bond.broken"));
  const EventTree tree = event_tree(all, all, 60);
  CHECK(tree.shown[0]);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].type == "seat.lost") CHECK(tree.shown[i]);
    if (tree.shown[i] && all[i].cause >= 0) CHECK(tree.shown[static_cast<std::size_t>(all[i].cause)]);
  }
  const auto shown = std::count(tree.shown.begin(), tree.shown.end(), true);
  CHECK(shown >= 60);
  CHECK(shown < 70);
}

TEST_CASE("the tree of a report has every failure once, in long chains and wide branches") {
  const Header header = sample_header();
  const std::filesystem::path path = scratch() / "tree.h5";
  for (const int spread : {1, 2, 7, 1000}) {
    std::filesystem::remove(path);
    ResultsWriter writer(path, header);
    writer.begin_stage("shake", "dynamic", 0);
    for (int i = 0; i < 700; ++i)
      writer.append_event(event(i, i == 0 ? -1 : (i - 1) / spread, i % 3 == 0 ? "bond.broken" : "bearing.failed"));
    writer.finish();
    const std::string page = report_page(ResultsReader(path));
    CHECK(wrong_with(page) == "");
    for (int i = 0; i < 700; ++i) {
      const std::string text = fmt::format("event {};</li>", i), inner = fmt::format("event {};<ul>", i);
      CHECK(count_of(page, text) + count_of(page, inner) == 1);
    }
  }
}

TEST_CASE("HTML is escaped, and lines stay lines") {
  CHECK(html_escaped("a<b> & \"c\" 'd'\n\te\x02") == "a&lt;b&gt; &amp; &quot;c&quot; &#39;d&#39;\n\te ");
  CHECK(html_escaped("") == "");
  CHECK(html_escaped("\n\n") == "\n\n");
  CHECK(html_escaped("θ \xff") == "θ ?");
}
