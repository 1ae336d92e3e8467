// A study as an array job of Slurm: its tasks, its script, and how it goes. Slurm is asked through its own commands,
// sbatch and squeue.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace trilith {

/// Cases by task. Those of one of `chains` stay together, in their order. `seconds`: what a case takes, 0: not known;
/// `per_task`: so many cases or more, 0: so many that a task takes some minutes. At most 1000 tasks, as many as Slurm
/// takes where its MaxArraySize was not raised.
std::vector<std::vector<std::size_t>> slurm_tasks(const std::vector<std::vector<std::size_t>>& chains, double seconds,
                                                  int per_task);

class SlurmJob {
 public:
  /// `folder`: of the cases; what belongs to the job is in its folder slurm. `command` runs the cases whose numbers
  /// (from 1, separated by commas) are added to it; `processors` for each task.
  SlurmJob(const std::filesystem::path& folder, std::vector<std::string> command, int processors);

  /// Whether the job of an earlier call still waits or runs. Throws InputError where Slurm is not there.
  [[nodiscard]] bool goes_on() const;
  /// Writes script and tasks, and hands them in. Gives a line that says so. Throws InputError with Slurm's words where
  /// it refuses them.
  std::string submit(const std::vector<std::vector<std::size_t>>& tasks);
  /// Until the job has ended, or `look`, called some times a second, gives false. Gives whether it has ended.
  bool wait(const std::function<bool()>& look) const;
  [[nodiscard]] const std::string& number() const { return number_; }

 private:
  std::filesystem::path folder_;
  std::vector<std::string> command_;
  int processors_;
  std::string number_;  // "" before there is one
};

}  // namespace trilith
