// Records in their usual file formats: each is read correctly, or rejected with the remedy.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "base/error.hpp"
#include "load/contains.hpp"
#include "load/motion_check.hpp"
#include "load/motion_measures.hpp"
#include "load/motion_plain.hpp"
#include "load/motion_read.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

constexpr int count = 400;
constexpr double dt = 0.02, peak = 0.3;  // [s], [g]

/// A wave packet that ends at rest [g].
double wave(int i) {
  const double s = static_cast<double>(i) / (count - 1);
  return peak * std::sin(40 * std::numbers::pi * s) * std::pow(std::sin(std::numbers::pi * s), 2);
}

using Row = std::function<std::string(int)>;
std::string written(const std::string& head, const Row& row) {
  std::string text = head;
  for (int i = 0; i < count; ++i) text += row(i) + "\n";
  return text;
}
/// Samples, `each` per line.
std::string rows_of(int each, const std::string& between = " ", double size = 1) {
  std::string text;
  for (int i = 0; i < count; ++i)
    text += fmt::format("{:.6f}{}", size * wave(i), i % each == each - 1 || i == count - 1 ? "\n" : between);
  return text;
}
std::string with_commas(std::string text) {
  for (char& c : text)
    if (c == '.') c = ',';
  return text;
}
std::string two(int i) {
  return fmt::format("{:.2f} {:.6f}", i * dt, wave(i));
}
std::string three(int i) {
  return fmt::format("{:.2f},{:.6f},{:.6f}", i * dt, wave(i), -0.5 * wave(i));
}

struct Form {
  const char* about;
  std::string text;
  PlainForm form;
  double factor = 1;  // of the wave
};

void check_is_wave(const GroundMotion& motion, double factor, double step = dt) {
  REQUIRE(motion.samples().size() == count);
  CHECK(near(motion.step(), step, 1e-12));
  double worst = 0;
  for (int i = 0; i < count; ++i)
    worst = std::max(worst, std::abs(motion.samples()[static_cast<std::size_t>(i)].acceleration / standard_gravity -
                                     factor * wave(i)));
  CHECK(worst < 2e-6);
  CHECK(why_not_usable(motion) == "");
}

std::string refusal(const std::string& text, const PlainForm& form, const std::string& name = "a.txt") {
  try {
    if (form.unit.empty())
      parse_motion(text, name);
    else
      parse_plain_motion(text, name, form);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

PlainForm column(const std::string& name, std::optional<double> step = {}) {
  return {"g", step, name};
}
PlainForm commas(std::optional<double> step = {}) {
  return {"g", step, "", {}, ','};
}

std::string esm() {
  return "EVENT_NAME: MADE UP\nSTATION_NAME: SOMEWHERE\nSAMPLING_INTERVAL_S: 0.020000\nNDATA: 400\n"
         "UNITS: cm/s^2\nSTREAM: HNE\nDATE_TIME_FIRST_SAMPLE_YYYYMMDD_HHMMSS: 20200101_101010.000\nUSER5: \n" +
         written("", [](int i) { return fmt::format("{:.6f}", 980.665 * wave(i)); });
}
std::string knet() {
  std::string text =
      "Origin Time       2011/03/11 14:46:00\nLat.              38.103\nStation Code      MYG004\n"
      "Sampling Freq(Hz) 50Hz\nDuration Time(s)  8\nDir.              N-S\nScale Factor      3920(gal)/6182761\n"
      "Max. Acc. (gal)   294\nLast Correction   2011/03/11 14:46:00\nMemo.\n";
  const double size = 980.665 * 6182761 / 3920;
  for (int i = 0; i < count; ++i) text += fmt::format("{:9.0f}{}", size * wave(i), i % 8 == 7 ? "\n" : "");
  return text;
}
std::string at2_file(const std::string& fourth, const std::string& first = "PEER\n") {
  return first + "Somewhere, 1/1/2000, A Station, 090\nACCELERATION TIME SERIES IN UNITS OF G\n" + fourth + "\n" +
         rows_of(5);
}

}  // namespace

TEST_CASE("records of plain columns are read correctly") {
  const std::vector<Form> forms{
      {"time and acceleration", written("", two), {"g", {}}},
      {"with names", written("t,a\n", [](int i) { return fmt::format("{:.2f},{:.6f}", i * dt, wave(i)); }), {"g", {}}},
      {"a head of numbers that is skipped", written("400\n0.02\n", two), {"g", {}, "", 2}},
      {"accelerations, one to a line", rows_of(1), {"g", dt}},
      {"accelerations, eight to a line", rows_of(8), {"g", dt}},
      {"accelerations, seven to a line, the last of one", rows_of(7), {"g", dt}},
      {"three to a line, said", rows_of(3), {"g", dt, "rows"}},
      {"two to a line, said", rows_of(2), {"g", dt, "rows"}},
      {"three columns, by number", written("", three), column("2")},
      {"three columns, the third", written("", three), column("3"), -0.5},
      {"three columns, by name", written("t,ns,ew\n", three), column("NS")},
      {"three columns, by name, with the step", written("t,ns,ew\n", three), column("ew", dt), -0.5},
      {"names with units", written("Time (s)\tNS [g]\tEW [g]\n", three), column("ew"), -0.5},
      {"names behind a mark of comments", written("# t ns ew\n", three), column("ew"), -0.5},
      {"three components without a time",
       written("ns ew ud\n", [](int i) { return fmt::format("{0:.6f} {1:.6f} {1:.6f}", wave(i), -0.5 * wave(i)); }),
       column("ew", dt), -0.5},
      {"acceleration before time", written("", [](int i) { return fmt::format("{:.6f} {:.2f}", wave(i), i * dt); }),
       column("1")},
      {"numbers of samples as time",
       written("n,a\n", [](int i) { return fmt::format("{},{:.6f}", i, wave(i)); }),
       {"g", dt}},
      {"numbers of samples from 1",
       written("", [](int i) { return fmt::format("{} {:.6f}", i + 1, wave(i)); }),
       {"g", dt}},
      {"milliseconds",
       written("time ms,acc\n", [](int i) { return fmt::format("{},{:.6f}", 20 * i, wave(i)); }),
       {"g", dt}},
      {"times in hundredths, step of 5 ms",
       written("", [](int i) { return fmt::format("{:.2f} {:.6f}", i * 0.005, wave(i)); }),
       {"g", 0.005}},
      {"times cut to thousandths, 256 a second",
       written("", [](int i) { return fmt::format("{:.3f} {:.6f}", std::floor(i * 1000 / 256.0) / 1000, wave(i)); }),
       {"g", 1 / 256.0}},
      {"times in whole seconds",
       written("", [](int i) { return fmt::format("{:.0f} {:.6f}", i * dt, wave(i)); }),
       {"g", dt}},
      {"decimal commas, semicolons",
       with_commas(written("", [](int i) { return fmt::format("{:.2f};{:.6f}", i * dt, wave(i)); })), commas()},
      {"decimal commas, blanks", with_commas(written("", two)), commas()},
      {"decimal commas, one column", with_commas(rows_of(1)), commas(dt)},
      {"decimal commas, eight to a line", with_commas(rows_of(8)), commas(dt)},
      {"commas between whole numbers, said",
       written("", [](int i) { return fmt::format("{},{}", 20 * i, std::lround(1e6 * std::abs(wave(i)))); }),
       {"g", dt, "2", {}, '.'},
       0},
      {"a mark of the end of a file", written("", two) + "\x1a", {"g", {}}},
      {"a format with a name and its own unit and step", at2_file("NPTS= 400, DT= .0200 SEC"), {"g", dt}},
      {"ESM with its unit", esm(), {"cm/s2", {}}},
      {"the samples of a format, as plain columns", at2_file("NPTS= 400, DT= .0200 SEC"), {"g", dt, "", 4}},
  };
  for (const Form& form : forms) {
    CAPTURE(form.about);
    if (form.factor == 0) continue;
    GroundMotion motion(std::vector<double>{0, 0}, 1);
    CHECK_NOTHROW(motion = parse_plain_motion(form.text, "a.txt", form.form));
    check_is_wave(motion, form.factor, form.form.step.value_or(dt));
  }
}

TEST_CASE("records whose format has a name are read by it") {
  const std::pair<const char*, std::string> files[] = {
      {"a.at2", at2_file("NPTS=   400, DT=   .0200 SEC,")},
      {"a.txt", at2_file("NPTS=   400, DT=   20.0 MSEC,")},
      {"a.at2", at2_file("400 0.0200 NPTS, DT")},
      {"a.at2", at2_file("400 0.0200 NPTS DT")},
      {"a.at2", at2_file("NPTS, DT\n 400 .0200")},
      {"a.at2", at2_file("NPTS DT\n 400 .0200 SEC")},
      {"a.at2", at2_file("NPTS, DT = 400, .0200 SEC")},
      {"a.at2", at2_file("NPTS= 400, DT= .0200 SEC") + "\x1a\x1a"},
      {"a.at2", at2_file("NPTS= 400, DT= .0200 SEC") + std::string(3, '\0')},
      {"a.at2", at2_file("NPTS= 400, DT= .0200 SEC", "\nPEER\n")},
      {"a.at2", at2_file("NPTS= 400, DT= .0200 SEC", "\n")},
      {"a.asc", esm()},
      {"a.ns", knet()},
  };
  for (const auto& file : files) {
    const std::string& text = file.second;
    CAPTURE(text.substr(0, 200));
    GroundMotion motion(std::vector<double>{0, 0}, 1);
    CHECK_NOTHROW(motion = parse_motion(text, file.first));
    check_is_wave(motion, 1);
  }
  CHECK(parse_motion(esm(), "a.asc").source().component == "HNE");
  CHECK(parse_motion(knet(), "a.ns").source().component == "N-S");
}

TEST_CASE("ambiguous records are rejected with the remedy") {
  struct Refused {
    std::string text;
    PlainForm form;
    const char* why;
    const char* name = "a.txt";
  };
  const std::string unnamed = written("", three), named = written("t,ns,ew\n", three);
  const auto index = [](const char* head) {
    return written(head, [](int i) { return fmt::format("{},{:.6f}", i, wave(i)); });
  };
  const auto ms = [](const char* head, double size) {
    return written(head, [size](int i) { return fmt::format("{:g},{:.6f}", size * i, wave(i)); });
  };
  const Refused files[] = {
      {named, {"g", {}}, "1 't' (increases from 0 to 7.98, like a time), 2 'ns' (up to 0.29"},
      {named, {"g", {}}, "name the column of the acceleration, as in column = 2 or column = \"ns\""},
      {named, {"g", dt}, "column = 2 or column = \"ns\""},
      {unnamed, {"g", dt}, "as in column = 2"},
      {unnamed, {"g", {}}, "has 3 columns"},
      {named, column("nz"), "has no column 'nz'; did you mean 'ns'?"},
      {named, column("4"), "column = 4, must be 1 to 3"},
      {unnamed, column("ns"), "its columns have no names; give a number"},
      {"ns ew\n" + rows_of(2), {"g", dt}, "has 2 columns"},
      {rows_of(3), column("2"), "no column of times; give the time step of the samples (dt)"},
      {rows_of(8), {"g", {}}, "give the time step of the samples (dt)"},
      {index("n,a\n"), {"g", {}}, "like sample numbers; give the step in seconds"},
      {ms("t,a\n", 20), {"g", {}}, "they look like ms; give the step in seconds, as in dt = 0.02"},
      {ms("time ms,a\n", 20), {"g", {}}, "they look like ms"},
      {ms("t [ms],a\n", 0.1), {"g", {}}, "give the step in seconds"},
      {ms("t,a\n", 20), {"g", 0.01}, "has steps of 20 s, dt is given as 0.01 s"},
      {rows_of(8), {"g", 20}, "step is 20 s, records have 0.0001 to 0.25 s; is it in ms?"},
      {rows_of(8), {"g", 1e-5}, "step is 1e-05 s, records have"},
      {rows_of(8), {"g", -1}, "dt is -1 s, must be above 0"},
      {at2_file("NPTS= 400, DT= 20.0 SEC"), {}, "step is 20 s, records have", "a.at2"},
      {"0.02\n" + rows_of(1),
       {"g", dt},
       "begins with 0.02, which is the step of the samples; give the number of header lines"},
      {"400\n" + rows_of(1, " ", 0.001), {"mm/s2", dt}, "which is the number of samples that follow"},
      {"50\n" + rows_of(1, " ", 0.001), {"mm/s2", dt}, "which is the samples in a second"},
      {"0.02\n" + rows_of(8), {"g", dt}, "row of line 2 has 8 columns, the first row of numbers (line 1) has 1"},
      {"400 0.02\n" + rows_of(1), {"g", dt}, "give their number (skip = 1)"},
      {"0.02\n" + written("", two), {"g", {}}, "row of line 2 has 2 columns"},
      {"400 samples\n" + rows_of(1),
       {"g", dt},
       "value is 'samples', must be a finite number; if it is part of the header"},
      {written("", [](int i) { return fmt::format("{:.2f} {:.6f}", i * 0.005, wave(i)); }),
       {"g", {}},
       "times are rounded to 0.01 s, so give dt"},
      {with_commas(written("", two)), {"g", {}}, "has numbers like '0,00': set decimal = \",\" for decimal commas"},
      {with_commas(rows_of(8)), {"g", dt}, "for decimal commas"},
      {with_commas(rows_of(1)), {"g", dt}, "for decimal commas"},
      {with_commas(written("", [](int i) { return fmt::format("{:.2f};{:.5e}", i * dt, wave(i)); })),
       {"g", {}},
       "for decimal commas"},
      {with_commas(at2_file("NPTS= 400 DT= .0200 SEC")), {}, "must have a decimal point, as 0.000000", "a.at2"},
      {at2_file("NPTS= 400, DT= .0200 SEC"),
       {"cm/s2", dt},
       "is a PEER AT2 file, whose samples are in g; unit is given as cm/s2"},
      {at2_file("NPTS= 400, DT= .0200 SEC"), {"g", 0.01}, "whose step is 0.02 s; dt is given as 0.01 s"},
      {rows_of(8), {"g", dt}, "is a volume of processed strong motion", "a.V2A"},
      {"Corrected accelerogram\n 1 2 3\n" + rows_of(8), {"g", dt}, "Export its acceleration as a PEER AT2 file"},
      {std::string("abc\0\0\1", 6) + rows_of(8), {"g", dt}, "is a binary file"},
      {esm().substr(0, 2000), {}, "is cut short", "a.asc"},
      {knet().substr(0, knet().find('\n', 2000)), {}, "is cut short", "a.ns"},
      {rows_of(8, " ", 200), {"m/s2", 0.25}, "peak is 6.0"},
      {rows_of(8, " ", 40), {"m/s2", 0.25}, "peak velocity of"},
      {written("", two), {}, "for plain columns, give unit"},
  };
  for (const Refused& file : files) {
    CAPTURE(file.text.substr(0, 120));
    CAPTURE(file.why);
    const std::string message = refusal(file.text, file.form, file.name);
    CAPTURE(message);
    CHECK(contains(message, file.why));
    CHECK(message.find('\n') == std::string::npos);
  }
}

TEST_CASE("a raw record with an offset is read and rejected for its drift") {
  const std::string text = written("", [](int i) { return fmt::format("{:.2f} {:.6f}", i * dt, wave(i) + 0.2); });
  const GroundMotion motion = parse_plain_motion(text, "a.txt", {"g", {}});
  CHECK(motion.samples().back().velocity > 10);
  CHECK(contains(why_not_usable(motion), "drifts"));
}
