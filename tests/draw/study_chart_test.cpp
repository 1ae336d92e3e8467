#include "draw/chart/study_chart.hpp"

#include <doctest/doctest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "base/error.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::draw;
using results::StudyColumn;
using testing::near;

namespace {

/// Two strengths, two copies each; the last case has failed and has no value.
std::vector<StudyColumn> small_study() {
  using Reals = std::vector<double>;
  return {{"case", "1", "number of the case, from 1", std::vector<std::int32_t>{1, 2, 3, 4}},
          {"copy", "1", "parameter", Reals{1, 2, 1, 2}},
          {"tension", "Pa", "parameter", Reals{100, 100, 400, 400}},
          {"steady", "1", "parameter", Reals{7, 7, 7, 7}},
          {"drift", "m", "figure that the case gave", Reals{0.1, 0.3, 0.05, std::nan("")}},
          {"share", "1", "figure that the case gave", Reals{1, 0, 0, std::nan("")}},
          {"status", "", "finished, failed or not run",
           std::vector<std::string>{"finished", "finished", "finished", "failed"}}};
}

struct TableFile {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("trilith_study_chart_" + std::to_string(::getpid()) + ".h5");
  TableFile() { results::write_study_table(path, small_study(), {}, true); }
  TableFile(const TableFile&) = delete;
  TableFile& operator=(const TableFile&) = delete;
  ~TableFile() { std::filesystem::remove(path); }
};

}  // namespace

TEST_CASE("the numbers of a study's table are read back as written, with units") {
  const TableFile file;
  CHECK(results::is_study_table(file.path));
  const std::vector<StudyColumn> read = results::read_study_table(file.path);
  REQUIRE(read.size() == 7);
  CHECK(std::get<std::vector<std::string>>(read[6].values)[3] == "failed");
  CHECK(read[4].name == "drift");
  CHECK(read[4].unit == "m");
  CHECK(std::get<std::vector<double>>(read[4].values)[1] == 0.3);
  CHECK(std::isnan(std::get<std::vector<double>>(read[4].values)[3]));
  CHECK(std::get<std::vector<double>>(read[0].values)[2] == 3);
}

TEST_CASE("a study's chart has a panel for each unit, the median, the band and the range of the cases of one value") {
  const TableFile file;
  const Chart chart = study_chart(results::read_study_table(file.path), "tension", {});
  REQUIRE(chart.panels.size() == 2);
  REQUIRE(chart.panels[0].series.size() == 4);
  const ChartSeries &median = chart.panels[0].series[0], &low = chart.panels[0].series[1],
                    &high = chart.panels[0].series[2], &band = chart.panels[0].series[3];
  CHECK(median.x == std::vector<double>{100, 400});
  CHECK(near(median.y[0], 0.2, 1e-12));
  CHECK(median.y[1] == 0.05);  // of the single finished copy
  CHECK(low.y[0] == 0.1);
  CHECK(high.y[0] == 0.3);
  CHECK(near(band.y[0], 0.132, 1e-12));
  CHECK(near(band.to[0], 0.268, 1e-12));
}

namespace {

/// Three records at four accelerations; the last collapses from 0.3 on, the others from 0.4 on and not at all.
std::vector<StudyColumn> incremental_study() {
  const double none = std::nan("");
  return {
      {"pga", "g", "parameter", std::vector<double>{.1, .1, .1, .2, .2, .2, .3, .3, .3, .4, .4, .4}},
      {"record", "", "parameter", std::vector<std::string>{"a", "b", "c", "a", "b", "c", "a", "b", "c", "a", "b", "c"}},
      {"stiff", "flag", "parameter", std::vector<double>{1, 0, 1, 1, 0, 1, 1, 0, 1, 1, 0, 1}},
      {"drift", "m", "figure that the case gave",
       std::vector<double>{.01, .02, .03, .02, .04, .06, .03, .06, .2, .04, .3, none}},
      {"collapsed", "flag", "figure that the case gave", std::vector<double>{0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, none}},
      {"status", "", "finished, failed, not run, or passed over",
       std::vector<std::string>{"finished", "finished", "finished", "finished", "finished", "finished", "finished",
                                "finished", "finished", "finished", "finished", "passed over"}}};
}

}  // namespace

TEST_CASE("a study with skipped cases gives the capacities of its records, and no case counts twice") {
  const results::StudyFragility f = results::study_fragility(incremental_study(), "collapsed", "pga");
  CHECK(f.incremental);
  CHECK(f.unit == "g");
  CHECK(f.curve.count == 3);
  REQUIRE(f.stripes.size() == 4);
  const int down[] = {0, 0, 1, 2};
  for (int i = 0; i < 4; ++i) {
    CHECK(f.stripes[static_cast<std::size_t>(i)].seen.hits == down[i]);
    CHECK(f.stripes[static_cast<std::size_t>(i)].seen.count == 3);
  }
  const results::Fragility same = results::fit_fragility({{0.4, INFINITY}, {0.3, 0.4}, {0.2, 0.3}});
  CHECK(f.curve.median == same.median);
  CHECK(f.curve.dispersion == same.dispersion);
}

TEST_CASE("a fragility chart passes through the observed probabilities, an incremental one flattens at its capacity") {
  const std::vector<StudyColumn> columns = incremental_study();
  const Chart chart = fragility_chart(results::study_fragility(columns, "collapsed", "pga"), "collapsed");
  REQUIRE(chart.panels.size() == 1);
  for (const ChartSeries& s : chart.panels[0].series)
    for (const double y : s.y) CHECK((y >= 0 && y <= 1));
  const Chart ida = ida_chart(columns, "drift", "pga", "collapsed");
  const ChartSeries& b = ida.panels[0].series[1];
  CHECK(near(b.y[b.y.size() - 1], 0.35, 1e-12));
  CHECK(near(b.y[b.y.size() - 2], 0.35, 1e-12));
  CHECK(near(b.x[b.x.size() - 2], 0.06, 1e-12));
  CHECK_FALSE(chart_canvas({chart}, Arrangement::below).bytes(PictureFormat::svg).empty());
  CHECK_FALSE(chart_canvas({ida}, Arrangement::below).bytes(PictureFormat::svg).empty());
}

TEST_CASE("a study over texts or flags has an axis of words, and shares of a flag stay between 0 and 1") {
  const Chart chart = study_chart(incremental_study(), "record", {"collapsed", "drift"});
  CHECK(chart.x.words == std::vector<std::string>{"a", "b", "c"});
  CHECK(chart.panels.size() == 2);
  CHECK(study_chart(incremental_study(), "stiff", {"drift"}).x.words == std::vector<std::string>{"true", "false"});
  CHECK_FALSE(chart_canvas({chart}, Arrangement::below).bytes(PictureFormat::svg).empty());
}

TEST_CASE("conditions on the cases of a study: flags, numbers and texts") {
  using results::Holds;
  const std::vector<StudyColumn> columns = incremental_study();
  const auto hits = [&](const char* condition) {
    results::Tally tally;
    for (const Holds h : results::condition_of_cases(columns, condition)) tally.add(h);
    return std::pair{tally.hits, tally.count};
  };
  CHECK(hits("collapsed") == std::pair{2, 11});
  CHECK(hits("not collapsed") == std::pair{9, 11});
  CHECK(hits("collapsed = false") == std::pair{9, 11});
  CHECK(hits("drift > 0.04") == std::pair{4, 11});
  CHECK(hits("drift>=0.04") == std::pair{6, 11});
  CHECK(hits("record = b") == std::pair{4, 12});
  CHECK(hits("record != b") == std::pair{8, 12});
  CHECK_THROWS_WITH_AS(hits("drift"), doctest::Contains("is not a flag"), InputError);
  CHECK_THROWS_WITH_AS(hits("colapsed"), doctest::Contains("did you mean 'collapsed'"), InputError);
  CHECK_THROWS_WITH_AS(hits("drift > much"), doctest::Contains("is not a number"), InputError);
  CHECK_THROWS_WITH_AS(hits("record > b"), doctest::Contains("give = or !="), InputError);
}

TEST_CASE("a study is drawn over the first varying parameter, and an unknown name is rejected with the nearest one") {
  const TableFile file;
  const std::vector<StudyColumn> columns = results::read_study_table(file.path);
  CHECK(study_chart(columns, "", {"drift"}).x.label == "copy");
  CHECK_THROWS_WITH_AS(study_chart(columns, "tensoin", {}),
                       doctest::Contains("no parameter 'tensoin'; did you mean 'tension'"), InputError);
  CHECK_THROWS_WITH_AS(study_chart(columns, "tension", {"drfit"}), doctest::Contains("did you mean 'drift'"),
                       InputError);
  CHECK_THROWS_AS(results::read_study_table("no/such/file.h5"), results::ResultsError);
  CHECK_FALSE(results::is_study_table("no/such/file.h5"));
}
