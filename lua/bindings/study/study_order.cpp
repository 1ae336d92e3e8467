#include "bindings/study/study_order.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/shell_word.hpp"
#include "base/whole_file.hpp"
#include "bindings/core/host.hpp"
#include "results/file/provenance.hpp"

namespace trilith::script {
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
    if (cases.trust) command.emplace_back("--trust");
    if (cases.memory > 0) command.push_back(fmt::format("--script-memory={:.17g}", cases.memory));
    if (cases.seconds > 0) command.push_back(fmt::format("--script-seconds={:.17g}", cases.seconds));
    if (cases.checkpoint >= 0) command.push_back(fmt::format("--checkpoint={:.17g}", cases.checkpoint));
    if (!cases.trust)
      for (const std::filesystem::path& room : cases.folders) command.push_back("--room=" + room.string());
    command.insert(command.end(), cases.fixed.begin(), cases.fixed.end());
    for (std::size_t k = 0; !cases.by_number && k < known.names.size(); ++k)
      command.push_back(known.argument(index, k));
    if (cases.by_number) command.push_back(fmt::format("--case={}", index + 1));
    command.push_back("--folder=" + folder.string());
    // The number of cases at a time equals the number of processors: each uses one.
    command.emplace_back("--threads=1");
    command.emplace_back("--quiet");
    command.emplace_back("--go-on");
    return command;
  };
  return order;
}

void take_choice(const StudyChoice& choice, StudyOrder& order) {
  if (choice.jobs > 0) order.jobs = choice.jobs;
  order.fresh = choice.fresh;
  if (choice.rise) order.rise = choice.rise;
  order.on_slurm = choice.on_slurm;
  order.per_task = choice.per_task;
  for (const int number : choice.some) {
    if (number < 1 || static_cast<std::size_t>(number) > order.plan.cases.size())
      throw InputError(fmt::format("study: there is no case {}; there are {}", number, order.plan.cases.size()));
    order.only.push_back(static_cast<std::size_t>(number) - 1);
  }
}

void list_cases(const StudyOrder& order) {
  for (std::size_t i = 0; i < order.plan.cases.size(); ++i) {
    std::string line = "trilith";
    const std::vector<std::string> command = order.command(i, case_folder(order, i));
    for (std::size_t w = 1; w < command.size(); ++w)
      if (!command[w].starts_with("--room=") && command[w] != "--go-on")
        line.append(" ").append(shell_word(command[w]));
    fmt::print("{}\n", line);
  }
}

}  // namespace trilith::script
