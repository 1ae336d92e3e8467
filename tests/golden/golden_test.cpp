// Motion and ledger compared bit by bit: refactoring must not change them. The hashes are in hashes.txt, a row for each
// platform and run; `./dev golden 'why'` recomputes the rows of this platform.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "model/io/motion_hash.hpp"
#include "physics/collapses.hpp"
#include "source_dir.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// A block that falls on mortar too weak to carry it, and sinks in.
Model<2> crushed_mortar() {
  Cohesive law{1e10, 5e9, 0.7, 1e-5, 1e3, 1e3, 1e-2, 1e-2, 0, 0};
  law.compression = 2e5, law.crushing_depth = 0.05;
  Scene scene(law);
  scene.fixed("base", box(-1, -1, 2, 0));
  scene.block("block", box(0, 1e-3, 1, 0.5), 1000, {0.3, -2});
  return scene.builder.build();
}

std::string hash_at_end(const Collapse& c, double accuracy) {
  Simulation<2> sim(c.model());
  StageOptions options;
  options.duration = c.duration;
  options.impact_accuracy = accuracy;
  sim.run(options);
  return fmt::format("{:016x}", motion_hash(sim.state()));
}

/// Each run with its own steps, and with steps shortened at impacts: name and accuracy of impacts.
std::vector<std::pair<std::string, double>> ways_of(const Collapse& c) {
  return {{c.name, 0.0}, {std::string(c.name) + ", accuracy .001", 1e-3}};
}

/// Hashes of this platform by the name of the run.
std::map<std::string, std::string> known_hashes() {
  std::ifstream file(source_dir() + "/tests/golden/hashes.txt");
  std::map<std::string, std::string> known;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string platform, hash, name;
    if (words >> platform >> hash >> std::ws && std::getline(words, name) && platform == TRILITH_PLATFORM)
      known[name] = hash;
  }
  return known;
}

}  // namespace

TEST_CASE("golden: collapses end with the known bits") {
  std::vector<Collapse> runs = collapses();
  runs.push_back({"mortar, crushed", crushed_mortar, 0.3});
  if (std::getenv("TRILITH_GOLDEN") != nullptr) {
    for (const Collapse& c : runs)
      for (const auto& [name, accuracy] : ways_of(c))
        fmt::print("{} {} {}\n", TRILITH_PLATFORM, hash_at_end(c, accuracy), name);
    return;
  }
  const std::map<std::string, std::string> known = known_hashes();
  if (known.empty()) {
    MESSAGE("skipped: no hashes are known for " TRILITH_PLATFORM);
    return;
  }
  for (const Collapse& c : runs)
    for (const auto& way : ways_of(c)) {
      INFO(way.first);
      REQUIRE(known.contains(way.first));
      CHECK(hash_at_end(c, way.second) == known.at(way.first));
    }
}
