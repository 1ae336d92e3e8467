// A study as a Slurm array job: its tasks, script and progress. It uses the commands sbatch and squeue.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace trilith {

/// Distributes cases to tasks. The cases of each chain in `chains` stay together, in their order. `seconds`: run time
/// of a case, 0: unknown. `per_task`: least number of cases per task, 0: enough for a task of some minutes. At most
/// 1000 tasks, within the default MaxArraySize of Slurm.
std::vector<std::vector<std::size_t>> slurm_tasks(const std::vector<std::vector<std::size_t>>& chains, double seconds,
                                                  int per_task);

class SlurmJob {
 public:
  /// `folder`: folder of the cases; the files of the job are in its folder slurm. `command` runs the cases whose
  /// numbers (from 1, separated by commas) are appended to it. `processors`: for each task.
  SlurmJob(const std::filesystem::path& folder, std::vector<std::string> command, int processors);

  /// True if the job of an earlier call still waits or runs. Throws InputError if Slurm is not available.
  [[nodiscard]] bool goes_on() const;
  /// Writes script and tasks, and submits them. Returns a line of text for the user. Throws InputError with the message
  /// of Slurm if it rejects them.
  std::string submit(const std::vector<std::vector<std::size_t>>& tasks);
  /// Waits until the job has ended, or until `look`, called some times a second, returns false. Returns true if it has
  /// ended.
  bool wait(const std::function<bool()>& look) const;
  [[nodiscard]] const std::string& number() const { return number_; }

 private:
  std::filesystem::path folder_;
  std::vector<std::string> command_;
  int processors_;
  std::string number_;  // "" before the job exists
};

}  // namespace trilith
