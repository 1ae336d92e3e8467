#include "run/study/study_records.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "base/hash.hpp"
#include "base/whole_file.hpp"

namespace trilith {
namespace {

constexpr const char* record_file = "case.txt";     // finished case: its digest, wall clock and figures
constexpr const char* failure_file = "failed.txt";  // failed case: digest, wall clock, exit and message

}  // namespace

std::string case_digest(const StudyOrder& order, std::size_t index) {
  Hash hash;
  hash.add(order.source);
  for (std::size_t k = 0; k < order.plan.names.size(); ++k) hash.add(order.plan.argument(index, k));
  for (const StudyHistory& h : order.histories) hash.add(h.column());
  return fmt::format("{:016x}", hash.value());
}

std::string case_text(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  if (in) text << in.rdbuf();
  return text.str();
}

bool take_finished_case(const std::string& digest, StudyOutcome& outcome) {
  std::istringstream in(case_text(outcome.folder / record_file));
  std::string first, number;
  if (!std::getline(in, first) || first != digest || !std::getline(in, number)) return false;
  try {
    outcome.figures = figures_from(in.str().substr(static_cast<std::size_t>(in.tellg())));
    outcome.seconds = std::stod(number);
  } catch (const std::exception&) {
    return false;  // damaged: run again
  }
  outcome.status = StudyStatus::finished;
  outcome.earlier = true;
  return true;
}

void take_failed_case(const std::string& digest, StudyOutcome& outcome) {
  std::istringstream in(case_text(outcome.folder / failure_file));
  std::string first;
  if (!std::getline(in, first) || first != digest || !(in >> outcome.seconds >> outcome.exit)) return;
  in.ignore();
  std::getline(in, outcome.message);
  outcome.status = StudyStatus::failed;
}

void keep_finished_case(const std::string& digest, const StudyOutcome& outcome) {
  write_whole_file(outcome.folder / record_file,
                   fmt::format("{}\n{}\n{}", digest, outcome.seconds, figures_text(outcome.figures)));
}

void keep_failed_case(const std::string& digest, const StudyOutcome& outcome) {
  write_whole_file(outcome.folder / failure_file,
                   fmt::format("{}\n{} {}\n{}\n", digest, outcome.seconds, outcome.exit, outcome.message));
}

}  // namespace trilith
