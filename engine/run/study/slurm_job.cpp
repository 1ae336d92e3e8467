#include "run/study/slurm_job.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string_view>
#include <thread>

#include "base/error.hpp"
#include "base/shell_word.hpp"
#include "base/whole_file.hpp"

namespace trilith {
namespace {

constexpr double task_seconds = 300;
constexpr std::size_t most_tasks = 1000;
/// Cancelled, completed, time limit, out of memory, deadline, failed, boot failure, node failure. A requeued task waits
/// again.
constexpr std::array<std::string_view, 8> ended_states{"CA", "CD", "TO", "OOM", "DL", "F", "BF", "NF"};

struct Answer {
  int exit = 0;
  std::string text;  ///< output of the command, including errors
};

Answer ask_shell(const std::string& command) {
  Answer answer;
  std::FILE* pipe = ::popen((command + " 2>&1").c_str(), "re");
  if (pipe == nullptr) throw InputError("study: the shell could not be started");
  std::array<char, 4096> block{};
  for (std::size_t n; (n = std::fread(block.data(), 1, block.size(), pipe)) > 0;) answer.text.append(block.data(), n);
  const int status = ::pclose(pipe);
  answer.exit = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  while (!answer.text.empty() && answer.text.back() == '\n') answer.text.pop_back();
  return answer;
}

void require_slurm(const Answer& answer, const char* program) {
  if (answer.exit == 127)
    throw InputError(
        fmt::format("study: --on slurm needs Slurm's {}, which is not installed on this machine", program));
}

/// Advice if Slurm rejects a job, by the words of its message. A job is submitted without partition, account and time
/// limit; SBATCH_ variables of the environment set them.
std::string remedy_of(const std::string& refusal) {
  const auto says = [&](std::string_view words) { return refusal.find(words) != std::string::npos; };
  if (says("ccount")) return "set SBATCH_ACCOUNT to an account of yours (sacctmgr show user $USER withassoc)";
  if (says("artition")) return "set SBATCH_PARTITION to a partition of this machine (sinfo)";
  if (says("ime limit")) return "set SBATCH_TIMELIMIT, as in 2:00:00";
  if (says("array"))
    return "the array has more tasks than this machine allows (scontrol show config, MaxArraySize); set cases of a "
           "task "
           "higher";
  if (says("emory")) return "set SBATCH_MEM_PER_CPU, as in 2G";
  if (says("node configuration") || says("CPU"))
    return "no node has as many processors as a case takes threads; lower threads";
  if (says("QOS") || says("qos")) return "set SBATCH_QOS, or submit fewer cases";
  if (says("ontact") || says("connect")) return "its controller does not answer; is this a node of the cluster?";
  return "SBATCH_ variables (SBATCH_PARTITION, SBATCH_ACCOUNT, SBATCH_TIMELIMIT) set options of the job";
}

/// True if a task of the job waits or runs. All jobs are listed, because squeue does not find requeued tasks by their
/// job number for a while after a node failure. If the state is unknown, the task counts as running.
bool is_in_queue(const std::string& number) {
  const Answer answer = ask_shell("squeue --noheader --states=all --format='%F %t'");
  require_slurm(answer, "squeue");
  if (answer.exit != 0) return true;
  std::istringstream rows(answer.text);
  for (std::string job, state; rows >> job >> state;) {
    const bool ended = std::find(ended_states.begin(), ended_states.end(), state) != ended_states.end();
    if (job == number && !ended) return true;
  }
  return false;
}

}  // namespace

std::vector<std::vector<std::size_t>> slurm_tasks(const std::vector<std::vector<std::size_t>>& chains, double seconds,
                                                  int per_task) {
  std::size_t cases = 0;
  for (const auto& chain : chains) cases += chain.size();
  double size = per_task > 0 ? per_task : seconds > 0 ? std::round(task_seconds / seconds) : 1;
  size =
      std::clamp(size, std::ceil(static_cast<double>(cases) / most_tasks), std::max(1.0, static_cast<double>(cases)));
  std::vector<std::vector<std::size_t>> tasks;
  for (const std::vector<std::size_t>& chain : chains) {
    if (tasks.empty() || static_cast<double>(tasks.back().size()) >= size) tasks.emplace_back();
    tasks.back().insert(tasks.back().end(), chain.begin(), chain.end());
  }
  return tasks;
}

SlurmJob::SlurmJob(const std::filesystem::path& folder, std::vector<std::string> command, int processors)
    : folder_(std::filesystem::absolute(folder) / "slurm"), command_(std::move(command)), processors_(processors) {
  std::ifstream in(folder_ / "job.txt");
  in >> number_;
}

bool SlurmJob::goes_on() const {
  return !number_.empty() && is_in_queue(number_);
}

std::string SlurmJob::submit(const std::vector<std::vector<std::size_t>>& tasks) {
  std::filesystem::create_directories(folder_);
  std::string lists, words;
  std::size_t cases = 0;
  for (const std::vector<std::size_t>& task : tasks) {
    std::vector<std::size_t> numbers = task;
    for (std::size_t& n : numbers) ++n;
    lists += fmt::format("{}\n", fmt::join(numbers, ","));
    cases += task.size();
  }
  for (const std::string& word : command_) words += shell_word(word) + " ";
  // Each task appends to its own log, so that its output before a node failure is kept.
  const std::string script = fmt::format(
      "#!/bin/sh\n#SBATCH --job-name={}\n#SBATCH --array=1-{}\n#SBATCH --cpus-per-task={}\n#SBATCH --requeue\n"
      "#SBATCH --open-mode=append\n#SBATCH --output={}\n"
      "# Each task runs the cases of its line of tasks.txt; finished cases are skipped.\n"
      "cd {} || exit 1\nexec {}--jobs {} --quiet --cases \"$(sed -n \"${{SLURM_ARRAY_TASK_ID}}p\" {})\"\n",
      shell_word(folder_.parent_path().stem().string()), tasks.size(), processors_,
      shell_word((folder_ / "task_%a.txt").string()), shell_word(std::filesystem::current_path().string()), words,
      processors_, shell_word((folder_ / "tasks.txt").string()));
  write_whole_file(folder_ / "tasks.txt", lists);
  write_whole_file(folder_ / "job.sh", script);
  const Answer answer = ask_shell("sbatch --parsable " + shell_word((folder_ / "job.sh").string()));
  require_slurm(answer, "sbatch");
  if (answer.exit != 0)
    throw InputError(fmt::format("study: Slurm rejects the job: {}; {}. Its script is {}", answer.text,
                                 remedy_of(answer.text), (folder_ / "job.sh").string()));
  // "17", or "17;cluster", after any warnings.
  number_ = answer.text.substr(answer.text.rfind('\n') + 1);
  number_ = number_.substr(0, number_.find(';'));
  write_whole_file(folder_ / "job.txt", number_ + "\n");
  return fmt::format("job {} of Slurm: {} cases in {} task{}; its script is {}", number_, cases, tasks.size(),
                     tasks.size() == 1 ? "" : "s", (folder_ / "job.sh").string());
}

bool SlurmJob::wait(const std::function<bool()>& look) const {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::seconds shortest{2}, longest{15};
  auto pause = shortest;
  bool was_gone = false;  // between two states a task may be in none: it has ended if it is absent twice
  for (auto asked = Clock::now(); true; std::this_thread::sleep_for(std::chrono::milliseconds(250))) {
    if (!look()) return false;
    if (Clock::now() - asked < pause) continue;
    const bool gone = !is_in_queue(number_);
    if (gone && was_gone) return true;
    was_gone = gone;
    asked = Clock::now();
    pause = gone ? shortest : std::min(longest, pause + std::chrono::seconds(1));
  }
}

}  // namespace trilith
