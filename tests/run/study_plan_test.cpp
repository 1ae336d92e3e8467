#include "run/study/study_plan.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/error.hpp"
#include "run/study/slurm_job.hpp"

using namespace trilith;

namespace {

std::vector<double> column(const StudyPlan& plan, std::size_t k) {
  std::vector<double> values;
  for (const auto& row : plan.cases) values.push_back(std::get<double>(row[k]));
  return values;
}

}  // namespace

TEST_CASE("a product has all combinations, the last parameter varying fastest") {
  const StudyPlan plan = product_plan(
      {{"mu", "", {0.2, 0.4}}, {"base", "", {std::string("a"), std::string("b")}}, {"pga", "g", {0.1, 0.2, 1e-7}}});
  REQUIRE(plan.cases.size() == 12);
  CHECK(plan.label(0) == "mu=0.2, base=a, pga=0.1 g");
  CHECK(plan.label(1) == "mu=0.2, base=a, pga=0.2 g");
  CHECK(plan.label(5) == "mu=0.2, base=b, pga=1e-07 g");
  CHECK(plan.label(6) == "mu=0.4, base=a, pga=0.1 g");
  std::set<std::string> labels;
  for (std::size_t i = 0; i < 12; ++i) labels.insert(plan.label(i));
  CHECK(labels.size() == 12);
}

TEST_CASE("a number on a case's command line reads back as the same bits") {
  for (const double value : {0.1, 1.0 / 3, 1e300, -2.5e-12, 4.0}) CHECK(std::stod(text_of(StudyValue(value))) == value);
  CHECK(text_of(StudyValue(true)) == "true");
}

TEST_CASE("impossible plans are rejected by name") {
  CHECK_THROWS_WITH_AS(product_plan({}), doctest::Contains("no parameter"), InputError);
  CHECK_THROWS_WITH_AS(product_plan({{"mu", "", {}}}), doctest::Contains("'mu' has no values"), InputError);
  CHECK_THROWS_WITH_AS(product_plan({{"seconds", "", {1.0}}}), doctest::Contains("'seconds'"), InputError);
  CHECK_THROWS_WITH_AS(product_plan({{"a b", "", {1.0}}}), doctest::Contains("'a b' cannot name"), InputError);
  CHECK_THROWS_WITH_AS(product_plan({{"a", "", {1.0}}, {"a", "", {2.0}}}), doctest::Contains("twice"), InputError);
  CHECK_THROWS_AS(product_plan({{"a", "", {std::nan("")}}}), InputError);
  const std::vector<StudyValue> many(1001, 1.0);
  CHECK_THROWS_WITH_AS(product_plan({{"a", "", many}, {"b", "", many}}), doctest::Contains("1000000"), InputError);
  CHECK_THROWS_WITH_AS(list_plan({{"a", "", {1.0, 2.0}}, {"b", "", {1.0}}}), doctest::Contains("'b' has 1"),
                       InputError);
}

TEST_CASE("Latin hypercube samples have one value in each part of equal probability") {
  using K = StudySpread::Kind;
  const int n = 40;
  const StudyPlan plan = sampled_plan({{"u", "", K::uniform, 2, 6},
                                       {"l", "", K::log_uniform, 1e-3, 10},
                                       {"g", "", K::normal, 5, 2},
                                       {"m", "", K::log_normal, 3, 0.5}},
                                      n, 7);
  REQUIRE(plan.cases.size() == n);
  const auto below = [](double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); };
  const auto probability = [&](std::size_t k, double v) {
    return k == 0   ? (v - 2) / 4
           : k == 1 ? std::log(v / 1e-3) / std::log(1e4)
                    : below(k == 2 ? (v - 5) / 2 : std::log(v / 3) / 0.5);
  };
  for (std::size_t k = 0; k < 4; ++k) {
    std::set<int> parts;
    for (const double v : column(plan, k)) parts.insert(static_cast<int>(std::floor(probability(k, v) * n)));
    CHECK(parts.size() == n);
    CHECK(*parts.begin() == 0);
    CHECK(*parts.rbegin() == n - 1);
  }
  std::vector<double> u = column(plan, 0);
  CHECK_FALSE(std::is_sorted(u.begin(), u.end()));
}

TEST_CASE("the same seed gives the same samples, another seed gives others") {
  const std::vector<StudySpread> spreads{{"u", "", StudySpread::Kind::uniform, 0, 1}};
  CHECK(column(sampled_plan(spreads, 9, 3), 0) == column(sampled_plan(spreads, 9, 3), 0));
  CHECK(column(sampled_plan(spreads, 9, 3), 0) != column(sampled_plan(spreads, 9, 4), 0));
  CHECK_THROWS_AS(sampled_plan(spreads, 0, 1), InputError);
  CHECK_THROWS_AS(sampled_plan({{"u", "", StudySpread::Kind::uniform, 1, 1}}, 2, 1), InputError);
  CHECK_THROWS_AS(sampled_plan({{"u", "", StudySpread::Kind::log_uniform, 0, 1}}, 2, 1), InputError);
}

TEST_CASE("cases that differ in the rising parameter alone are a chain with its lowest first") {
  const StudyPlan plan = product_plan({{"pga", "g", {0.3, 0.1, 0.2}}, {"record", "", {1.0, 2.0}}});
  using Chains = std::vector<std::vector<std::size_t>>;
  CHECK(rising_chains(plan, "pga") == Chains{{2, 4, 0}, {3, 5, 1}});
  CHECK(rising_chains(plan, "") == Chains{{0}, {1}, {2}, {3}, {4}, {5}});
}

TEST_CASE("tasks of a cluster take some minutes, keep chains together and are a thousand at most") {
  using Tasks = std::vector<std::vector<std::size_t>>;
  const Tasks chains{{0, 3}, {1, 4}, {2, 5}, {6}};
  CHECK(slurm_tasks(chains, 0, 1) == chains);
  CHECK(slurm_tasks(chains, 0, 3) == Tasks{{0, 3, 1, 4}, {2, 5, 6}});
  CHECK(slurm_tasks(chains, 100, 0) == Tasks{{0, 3, 1, 4}, {2, 5, 6}});
  CHECK(slurm_tasks(chains, 1, 0).size() == 1);
  CHECK(slurm_tasks(chains, 1e4, 0) == chains);
  Tasks many;
  for (std::size_t i = 0; i < 5001; ++i) many.push_back({i});
  const Tasks tasks = slurm_tasks(many, 1e4, 0);
  CHECK(tasks.size() <= 1000);
  std::size_t cases = 0;
  for (const auto& task : tasks) cases += task.size();
  CHECK(cases == 5001);
}
