#include "draw/study_chart.hpp"

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

/// Two strengths, two copies each; the last case has failed and gave no figure.
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

TEST_CASE("the numbers of a study's table come back as they were written, with units") {
  const TableFile file;
  CHECK(results::is_study_table(file.path));
  const std::vector<StudyColumn> read = results::read_study_table(file.path);
  REQUIRE(read.size() == 6);  // the column of texts is left out
  CHECK(read[4].name == "drift");
  CHECK(read[4].unit == "m");
  CHECK(std::get<std::vector<double>>(read[4].values)[1] == 0.3);
  CHECK(std::isnan(std::get<std::vector<double>>(read[4].values)[3]));
  CHECK(std::get<std::vector<double>>(read[0].values)[2] == 3);
}

TEST_CASE("a study's chart has a panel for each unit, the mean and the range of the cases of one value") {
  const TableFile file;
  const Chart chart = study_chart(results::read_study_table(file.path), "tension", {});
  REQUIRE(chart.panels.size() == 2);
  REQUIRE(chart.panels[0].series.size() == 3);
  const ChartSeries &mean = chart.panels[0].series[0], &low = chart.panels[0].series[1],
                    &high = chart.panels[0].series[2];
  CHECK(mean.x == std::vector<double>{100, 400});
  CHECK(near(mean.y[0], 0.2, 1e-12));
  CHECK(mean.y[1] == 0.05);  // of the one copy that has finished
  CHECK(low.y[0] == 0.1);
  CHECK(high.y[0] == 0.3);
}

TEST_CASE(
    "a study is drawn over the first parameter that varies, and a name that is not there is refused with the nearest") {
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
