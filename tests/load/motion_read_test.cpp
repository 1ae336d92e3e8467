#include "load/motion_read.hpp"

#include <doctest/doctest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <random>
#include <sstream>

#include "base/error.hpp"
#include "load/contains.hpp"
#include "load/motion_check.hpp"
#include "load/motion_measures.hpp"
#include "load/record_folder.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

const std::string csv = "# title: made\n# units: g\n# dt: 0.02 s\n# npts: 3\n0.00,0\n0.02,.1\n0.04,-.2\n";
const std::string at2 =
    "PEER\nSomewhere, 1/1/2000, A Station, 090\nACCELERATION TIME SERIES IN UNITS OF G\n"
    "NPTS=      7, DT=   .0200 SEC,     \n"
    "  -.1000000E+00   .2000000E-01   .3000000E+00  -.4000000E-01   .5000000E-01\n   .6000000E-01   .7000000E-01   \n";

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const auto at = text.find(what);
  REQUIRE(at != std::string::npos);
  return text.replace(at, what.size(), with);
}

std::string refusal(const std::string& text, const std::string& name = "made.csv") {
  try {
    parse_motion(text, name);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// The text is read or rejected: anything else (a crash, another exception, a NaN) is a failure.
void survives(const std::string& text, int& read, int& refused) {
  try {
    const GroundMotion motion = parse_motion(text, "damaged");
    ++read;
    CHECK(std::isfinite(motion.at(0.37).displacement));
    CHECK(std::isfinite(arias_intensity(motion)));
    (void)why_not_usable(motion);
  } catch (const InputError& error) {
    ++refused;
    CHECK(std::string(error.what()).find('\n') == std::string::npos);
  }
}

void fuzz(const std::string& whole, unsigned seed, int rounds) {
  std::mt19937 random(seed);
  int read = 0;
  int refused = 0;
  for (int round = 0; round < rounds; ++round) {
    std::string text = whole;
    if (round % 3 == 0) text.resize(random() % (text.size() + 1));
    const int hits = round % 3 == 0 ? 0 : 1 + static_cast<int>(random() % 4);
    for (int hit = 0; hit < hits; ++hit) {
      char& c = text[random() % std::min<std::size_t>(text.size(), round % 2 == 0 ? 700 : text.size())];
      c = round % 3 == 1 ? static_cast<char>(c ^ (1 << (random() % 8))) : static_cast<char>(random() % 256);
    }
    survives(text, read, refused);
  }
  CHECK(read + refused == rounds);
  CHECK(refused > rounds / 4);
}

}  // namespace

TEST_CASE("a CSV record is read with its header") {
  const std::string header = "# v0: -4.664 cm/s\n# u0: 2.159 cm\n# source agency: USGS\n# component: NS\n# note: one\n";
  const GroundMotion motion = parse_motion(header + csv, "folder/made.csv");
  CHECK(motion.samples().size() == 3);
  CHECK(motion.step() == 0.02);
  CHECK(near(motion.start().velocity, -0.04664, 1e-12));
  CHECK(near(motion.start().displacement, 0.02159, 1e-12));
  CHECK(near(motion.acceleration(0.02), 0.1 * standard_gravity, 1e-12));
  CHECK(motion.source().agency == "USGS");
  CHECK(motion.source().title == "made");
  CHECK(motion.source().component == "NS");
  CHECK(motion.source().notes.size() == 1);
  CHECK(motion.description() == "made.csv");
}

TEST_CASE("line ends of any kind and a byte order mark do not matter") {
  std::string dos;
  for (const char c : csv) dos += c == '\n' ? std::string("\r\n") : std::string(1, c);
  CHECK(near(parse_motion("\xEF\xBB\xBF" + dos, "made.csv").acceleration(0.04), -0.2 * standard_gravity, 1e-12));
  CHECK(parse_motion(csv.substr(0, csv.size() - 1), "made.csv").samples().size() == 3);
}

TEST_CASE("an AT2 record is read in all spellings of its fourth line") {
  for (const std::string line : {"NPTS=      7, DT=   .0200 SEC,", "NPTS=  7, DT= .02000 SEC", "7 0.0200 NPTS, DT"}) {
    const GroundMotion motion = parse_motion(replaced(at2, "NPTS=      7, DT=   .0200 SEC,", line), "made.at2");
    CHECK(motion.samples().size() == 7);
    CHECK(motion.step() == 0.02);
    CHECK(near(motion.acceleration(0.0), -0.1 * standard_gravity, 1e-12));
    CHECK(near(motion.acceleration(0.12), 0.07 * standard_gravity, 1e-12));
    CHECK(motion.source().component == "090");
  }
}

TEST_CASE("the format of a file is recognised by its content, for any name") {
  CHECK(parse_motion(at2, "record.txt").samples().size() == 7);
  CHECK(parse_motion(csv, "record.at2").samples().size() == 3);
  CHECK(contains(refusal("hello\nworld\n", "record.txt"), "neither"));
}

TEST_CASE("damaged CSV is rejected with file, line, error and allowed values") {
  CHECK(contains(refusal(""), "motion file 'made.csv': is empty"));
  CHECK(contains(refusal(" \n\n"), "is empty"));
  CHECK(contains(refusal(replaced(csv, "0.04,-.2\n", "")), "is cut short: 2 samples, the header announces 3"));
  CHECK(contains(refusal(csv + "0.06,0\n"), "line 8: more samples than the 3"));
  CHECK(
      contains(refusal(replaced(csv, "0.02,.1", "0.02,x1")), "line 6: acceleration is 'x1', must be a finite number"));
  CHECK(contains(refusal(replaced(csv, "0.02,.1", "0.02,nan")), "line 6: acceleration is 'nan'"));
  CHECK(contains(refusal(replaced(csv, "0.02,.1", "0.02,inf")), "line 6: acceleration is 'inf'"));
  CHECK(contains(refusal(replaced(csv, "0.02,.1", "0.02")), "line 6: must be 'time,acceleration'"));
  CHECK(contains(refusal(replaced(csv, "0.02,.1", "0.03,.1")), "line 6: time is 0.03 s, must be 0.02 s"));
  CHECK(contains(refusal(replaced(csv, "dt: 0.02 s", "dt: 0 s")), "line 3: dt is 0 s, must be above 0"));
  CHECK(contains(refusal(replaced(csv, "dt: 0.02 s", "dt: -1 s")), "must be above 0"));
  CHECK(contains(refusal(replaced(csv, "dt: 0.02 s", "dt: 20 ms")), "must be one number and its unit (s)"));
  CHECK(contains(refusal(replaced(csv, "npts: 3", "npts: 3.5")), "must be a whole number above 0"));
  CHECK(contains(refusal(replaced(csv, "units: g", "units: cm/s2")), "line 2: unit is 'cm/s2', must be g"));
  CHECK(contains(refusal(replaced(csv, "units: g", "unit: g")), "did you mean 'units'?"));
  CHECK(contains(refusal(replaced(csv, "# units: g\n", "")), "header lacks the line '# units: g'"));
  CHECK(contains(refusal(replaced(csv, "# npts: 3\n", "# npts: 3\n# npts: 3\n")), "given twice"));
  CHECK(contains(refusal(replaced(replaced(csv, ".1", "0"), "-.2", "0")), "is zero everywhere"));
  CHECK(contains(refusal(replaced(csv, "-.2", "-341.9")), "peak is 341.9 g, above 5 g"));
  CHECK(contains(refusal("# pga: 0.3 g at 0.04 s\n" + csv), "header says pga 0.3 g, the samples have -0.2 g"));
  CHECK(refusal("# pga: -0.2 g at 0.04 s\n" + csv).empty());
  CHECK(contains(refusal("# v0: 3\n" + csv), "must be one number and its unit"));
  CHECK(contains(refusal("# v0: 3 cm\n" + csv), "(cm/s, m/s"));
}

TEST_CASE("damaged AT2 is rejected with file, line, error and allowed values") {
  const auto refused = [](const std::string& text) { return refusal(text, "made.at2"); };
  CHECK(contains(refused("PEER\n"), "an AT2 file has 4 header lines"));
  CHECK(contains(refused(replaced(at2, "UNITS OF G", "UNITS OF CM/S/S")), "line 3: unit is 'cm/s/s', must be G"));
  CHECK(contains(refused(replaced(at2, "IN UNITS OF G", "")), "line 3: must say 'UNITS OF G'"));
  CHECK(contains(refused(replaced(at2, "NPTS=      7", "NPTS=      8")), "is cut short: 7 samples"));
  CHECK(contains(refused(replaced(at2, "NPTS=      7", "NPTS=      6")), "line 6: more samples than the 6"));
  CHECK(contains(refused(replaced(at2, "NPTS=      7", "NPTS=     -7")), "line 4: NPTS is '-7'"));
  CHECK(contains(refused(replaced(at2, "DT=   .0200", "DT=   .0000")), "line 4: DT is 0 s, must be above 0"));
  CHECK(contains(refused(replaced(at2, "NPTS=", "N=")), "line 4: must be like 'NPTS= 5372"));
  CHECK(contains(refused(replaced(at2, ".3000000E+00", "********")), "line 5: acceleration is '********'"));
}

TEST_CASE("a missing file, a folder and an empty file are rejected") {
  const auto refused = [](const std::filesystem::path& path) -> std::string {
    try {
      read_motion(path);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  CHECK(contains(refused("no/such/file.csv"), "motion file 'no/such/file.csv' does not exist"));
  CHECK(contains(refused(own_record("")), "is not a regular file"));
  const auto empty =
      std::filesystem::temp_directory_path() / ("trilith_motion_read_" + std::to_string(::getpid()) + ".csv");
  std::ofstream(empty).close();
  CHECK(contains(refused(empty), "is empty"));
  std::filesystem::remove(empty);
}

TEST_CASE("the project's own records are read, are usable, and end where they began") {
  for (const std::string name : {"elcentro_1940_rest_ns.csv", "elcentro_1940_rest_up.csv"}) {
    const GroundMotion motion = read_motion(own_record(name));
    CHECK(motion.samples().size() == 2792);
    CHECK(motion.description() == name);
    CHECK_NOTHROW(check_usable(motion));
    CHECK(std::abs(motion.samples().back().velocity) < 1e-5);
    CHECK(std::abs(motion.samples().back().displacement) < 1e-5);
  }
}

TEST_CASE("PEER files and the CSV made from them agree") {
  const auto folder = record_folder();
  if (!folder) return;
  const std::pair<std::string, std::string> pairs[] = {{"RSN6_IMPVALL.I_I-ELC180.AT2", "elcentro_1940_nga_ns.csv"},
                                                       {"RSN6_IMPVALL.I_I-ELC270.AT2", "elcentro_1940_nga_ew.csv"},
                                                       {"RSN6_IMPVALL.I_I-ELC-UP.AT2", "elcentro_1940_nga_up.csv"},
                                                       {"I-ELC180.AT2", "elcentro_1940_peer1999_ns.csv"},
                                                       {"RSN1106_KOBE_KJM-UP.AT2", "kobe_1995_kjma_up.csv"}};
  for (const auto& pair : pairs) {
    CAPTURE(pair.first);
    const GroundMotion peer = read_motion(*folder / "peer_at2" / pair.first);
    const GroundMotion other = read_motion(*folder / pair.second);
    CHECK(peer.step() == other.step());
    REQUIRE(peer.samples().size() >= other.samples().size());  // Kobe: the CSV is cut at 60 s
    double worst = 0;
    for (std::size_t i = 0; i < other.samples().size(); ++i)
      worst = std::max(worst, std::abs(peer.samples()[i].acceleration - other.samples()[i].acceleration));
    CHECK(worst < 1e-6 * standard_gravity);
  }
}

TEST_CASE("truncated and damaged records are read or rejected, never a crash") {
  fuzz(csv, 1, 3000);
  fuzz(at2, 2, 3000);
  const std::string real = text_of(own_record("elcentro_1940_rest_ns.csv"));
  REQUIRE(real.size() > 1000);
  fuzz(real, 3, 200);
}

TEST_CASE("truncated and damaged PEER records are read or rejected, never a crash") {
  const auto folder = record_folder();
  if (!folder) return;
  fuzz(text_of(*folder / "peer_at2" / "RSN6_IMPVALL.I_I-ELC180.AT2"), 4, 200);
}
