#include "run/study/study_figures.hpp"

#include <doctest/doctest.h>

#include "base/error.hpp"
#include "results/sample_run.hpp"
#include "run/study/study_columns.hpp"

using namespace trilith;

TEST_CASE("figures written to text are read back unchanged") {
  const std::vector<StudyFigure> figures{{"drift", "m", 0.1},        {"mode", "", std::string("rocking, then sliding")},
                                         {"tiny", "1", 1.0 / 3e200}, {"empty", "", std::string()},
                                         {"collapsed", "", true},    {"stands", "", false}};
  const std::vector<StudyFigure> read = figures_from(figures_text(figures));
  REQUIRE(read.size() == figures.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    CHECK(read[i].name == figures[i].name);
    CHECK(read[i].unit == figures[i].unit);
    CHECK(read[i].value == figures[i].value);
  }
  CHECK_THROWS_AS(figures_from("drift\tm\tnumber\t0.1x\n"), InputError);
  CHECK_THROWS_AS(figures_from("drift\n"), InputError);
  CHECK(figures_from("").empty());
}

TEST_CASE("a tab or a line's end within a figure's text becomes a blank") {
  const auto read = figures_from(figures_text({{"a\tb", "", std::string("one\ntwo")}}));
  REQUIRE(read.size() == 1);
  CHECK(read[0].name == "a b");
  CHECK(std::get<std::string>(read[0].value) == "one two");
}

TEST_CASE("a figure cannot have the name of a parameter, of a column, or of another figure") {
  const StudyPlan plan = product_plan({{"mu", "", {0.2}}});
  CHECK_NOTHROW(check_figure_names(plan, {{"drift", "m", 1.0}}));
  CHECK_THROWS_AS(check_figure_names(plan, {{"mu", "", 1.0}}), InputError);
  CHECK_THROWS_AS(check_figure_names(plan, {{"status", "", 1.0}}), InputError);
  CHECK_THROWS_AS(check_figure_names(plan, {{"drift", "m", 1.0}, {"drift", "m", 2.0}}), InputError);
}

TEST_CASE("a history gives its last, largest, smallest value, and the one farthest from zero") {
  const testing::Folder folder;
  const results::Header header = testing::sample_header();
  results::ResultsWriter writer(folder / "run.h5", header);
  for (int i = 1; i < 5; ++i) testing::SampleRow(header, i).append_to(writer);  // top.x 0.5 i, base shear -3 i
  writer.finish();
  const auto figure = [&](const char* history, StudyTake take) {
    return std::get<double>(figure_from_results(folder.path, {history, take}).value);
  };
  CHECK(figure("top.x", StudyTake::last) == 2);
  CHECK(figure("top.x", StudyTake::max) == 2);
  CHECK(figure("top.x", StudyTake::min) == 0.5);
  CHECK(figure("base shear", StudyTake::last) == -12);
  CHECK(figure("base shear", StudyTake::max) == -3);
  CHECK(figure("base shear", StudyTake::min) == -12);
  CHECK(figure("base shear", StudyTake::largest) == -12);
}
