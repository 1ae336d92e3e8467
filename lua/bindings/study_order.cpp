#include "study_order.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/whole_file.hpp"
#include "host.hpp"
#include "results/provenance.hpp"

namespace trilith::script {
namespace {

std::string in_quotes(const std::string& word) {
  if (word.find_first_of(" '\"$&|;<>()*?") == std::string::npos) return word;
  std::string out(1, '\'');
  for (const char c : word) {
    if (c == '\'') out += "'\\'";
    out += c;
  }
  out += '\'';
  return out;
}

}  // namespace

StudyOrder study_order(StudyPlan plan, const CasesOfScript& cases) {
  StudyOrder order;
  order.plan = std::move(plan);
  order.provenance = results::provenance_here();
  order.provenance.script = text_of_file(cases.script, "script", largest_script);
  order.provenance.script_path = cases.script.string();
  order.provenance.program_version = TRILITH_VERSION;
  order.source = order.provenance.script + '\n' + TRILITH_VERSION + '\n' + order.provenance.git_commit;
  for (const std::string& f : cases.fixed) order.source += '\n' + f;
  order.command = [cases, known = order.plan](std::size_t index, const std::filesystem::path& folder) {
    std::vector<std::string> command{cases.program, "run", cases.script.string()};
    command.insert(command.end(), cases.fixed.begin(), cases.fixed.end());
    for (std::size_t k = 0; !cases.by_number && k < known.names.size(); ++k)
      command.push_back(known.argument(index, k));
    if (cases.by_number) command.push_back(fmt::format("--case={}", index + 1));
    command.push_back("--folder=" + folder.string());
    // As many cases run at a time as the machine has processors: each on one of them.
    command.emplace_back("--threads=1");
    command.emplace_back("--quiet");
    return command;
  };
  return order;
}

void list_cases(const StudyOrder& order) {
  for (std::size_t i = 0; i < order.plan.cases.size(); ++i) {
    std::string line = "trilith";
    const std::vector<std::string> command = order.command(i, case_folder(order, i));
    for (std::size_t w = 1; w < command.size(); ++w) line.append(" ").append(in_quotes(command[w]));
    fmt::print("{}\n", line);
  }
}

}  // namespace trilith::script
