#include "run/study/study.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <map>

#include "base/error.hpp"
#include "base/hash.hpp"
#include "base/whole_file.hpp"
#include "results/study/study_table.hpp"
#include "run/progress.hpp"
#include "run/study/processes.hpp"
#include "run/study/slurm_job.hpp"
#include "run/study/study_columns.hpp"
#include "run/study/study_records.hpp"

namespace trilith {
namespace {

void require_distinct(const StudyOrder& order) {
  std::map<std::string, std::size_t> seen;
  for (std::size_t i = 0; i < order.plan.cases.size(); ++i) {
    const auto [it, added] = seen.emplace(order.plan.label(i), i);
    if (!added)
      throw InputError(fmt::format("study: cases {} and {} are the same: {}; give copies a parameter of their own",
                                   it->second + 1, i + 1, it->first));
  }
}

/// Lock of a study's folder while a study runs.
class Lock {
 public:
  explicit Lock(const std::filesystem::path& folder)
      : file_(::open((folder / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
    if (file_ >= 0 && ::flock(file_, LOCK_EX | LOCK_NB) == 0) return;
    if (file_ >= 0) ::close(file_);
    throw InputError(fmt::format("study: {} cannot be locked; another study is running there", folder.string()));
  }
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;
  ~Lock() { ::close(file_); }

 private:
  int file_;
};

std::filesystem::path folder_of_cases(const StudyOrder& order) {
  std::filesystem::path folder = order.file;
  return folder.replace_extension(".cases");
}

void make_folders(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw InputError(fmt::format("study: folder {} cannot be made: {}", folder.string(), error.message()));
}

bool has_checkpoints(const std::filesystem::path& folder) {
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (entry.path().extension() == ".restart") return true;
  return false;
}

class StudyRun {
 public:
  StudyRun(const StudyOrder& order, const StudyWatch& watch)
      : order_(order), watch_(watch), outcomes_(order.plan.cases.size()), below_(outcomes_.size()) {}

  std::vector<StudyOutcome> go() {
    require_distinct(order_);
    if (order_.rise) require_rising(order_.plan, order_.rise->over);
    find_chains();
    make_folders(folder_of_cases(order_));
    if (!order_.only.empty()) return run_some();
    const Lock lock(folder_of_cases(order_));
    results::require_study_path(order_.file);
    results::Provenance provenance = order_.provenance;  // before the first case: its time is the start of the study
    sort_out();
    const bool whole = order_.on_slurm.empty() ? run_due() : run_on_slurm();
    results::write_study_table(order_.file, study_table_columns(order_.plan, outcomes_), provenance, whole);
    watch_.line(summary(whole), false);
    return std::move(outcomes_);
  }

 private:
  /// For an incremental study, finds the lower cases of each case.
  void find_chains() {
    if (!order_.rise) return;
    chains_ = rising_chains(order_.plan, order_.rise->over);
    for (const std::vector<std::size_t>& chain : chains_)
      for (std::size_t k = 0; k < chain.size(); ++k)
        below_[chain[k]].assign(chain.begin(), chain.begin() + static_cast<std::ptrdiff_t>(k));
  }

  void sort_out() {
    for (std::size_t i = 0; i < outcomes_.size(); ++i) {
      outcomes_[i].folder = case_folder(order_, i);
      if (order_.fresh || !take_finished_case(case_digest(order_, i), outcomes_[i])) due_.push_back(i);
    }
    // In an incremental study, the lowest cases of each chain come first.
    std::stable_sort(due_.begin(), due_.end(),
                     [this](std::size_t a, std::size_t b) { return below_[a].size() < below_[b].size(); });
    const std::size_t kept = outcomes_.size() - due_.size();
    watch_.line(fmt::format("study of {} case{}, {}{}", outcomes_.size(), outcomes_.size() == 1 ? "" : "s",
                            order_.on_slurm.empty() ? fmt::format("{} at a time", jobs()) : "by Slurm",
                            kept == 0 ? "" : fmt::format("; {} finished before", kept)),
                false);
  }

  [[nodiscard]] int jobs() const { return order_.jobs > 0 ? order_.jobs : processors(); }

  bool run_due() {
    if (order_.prepare && !due_.empty()) order_.prepare();
    return run_these(due_);
  }

  /// A task of a cluster: runs some cases and leaves each finished or failed in its folder.
  std::vector<StudyOutcome> run_some() {
    sort_out();
    const auto is_other = [this](std::size_t i) {
      return std::find(order_.only.begin(), order_.only.end(), i) == order_.only.end();
    };
    std::erase_if(due_, is_other);
    run_due();
    return std::move(outcomes_);
  }

  /// Runs the cases in a Slurm job, or waits for the job of an earlier call; then reads their results.
  bool run_on_slurm() {
    SlurmJob job(folder_of_cases(order_), order_.on_slurm, std::max(1, order_.jobs));
    if (!job.goes_on()) {
      if (due_.empty()) return true;
      if (order_.per_task == 0 && mean_seconds() == 0 && !time_one()) return false;
      for (const std::size_t i : due_) std::filesystem::remove_all(outcomes_[i].folder);
      watch_.line(job.submit(slurm_tasks(chains_of_due(), mean_seconds(), order_.per_task)), false);
    } else {
      watch_.line(fmt::format("job {} of an earlier call is still running", job.number()), false);
    }
    const bool ended = job.wait([this] {
      gather();
      return look();
    });
    gather();
    for (const std::size_t i : due_)
      if (outcomes_[i].status == StudyStatus::not_run) take_failed_case(case_digest(order_, i), outcomes_[i]);
    failed_ = count_of(StudyStatus::failed);
    for (const std::size_t i : due_)
      if (outcomes_[i].status == StudyStatus::failed)
        watch_.line(fmt::format("case {} of {}  {}: failed: {}", i + 1, outcomes_.size(), order_.plan.label(i),
                                outcomes_[i].message),
                    true);
    if (!ended)
      watch_.line(fmt::format("job {} is still running; the same command follows it (scancel {} cancels it)",
                              job.number(), job.number()),
                  true);
    if (count_of(StudyStatus::not_run) > 0 && ended)
      watch_.line("some cases were not run: the same command runs the missing ones", true);
    return count_of(StudyStatus::not_run) == 0;
  }

  /// Runs one case here, to know the run time for the size of tasks.
  bool time_one() {
    if (order_.prepare) order_.prepare();
    const std::size_t first = due_.front();
    if (!run_these({first})) return false;
    due_.erase(due_.begin());
    return true;
  }

  [[nodiscard]] double mean_seconds() const {
    double sum = 0, count = 0;
    for (const StudyOutcome& o : outcomes_)
      if (o.status == StudyStatus::finished) sum += o.seconds, ++count;
    return count == 0 ? 0 : sum / count;
  }

  [[nodiscard]] std::size_t count_of(StudyStatus status) const {
    return static_cast<std::size_t>(
        std::count_if(outcomes_.begin(), outcomes_.end(), [&](const auto& o) { return o.status == status; }));
  }

  /// Dependent cases belong to one task.
  [[nodiscard]] std::vector<std::vector<std::size_t>> chains_of_due() const {
    std::vector<std::vector<std::size_t>> out = rising_chains(order_.plan, order_.rise ? order_.rise->over : "");
    for (std::vector<std::size_t>& chain : out)
      std::erase_if(chain, [this](std::size_t i) { return std::find(due_.begin(), due_.end(), i) == due_.end(); });
    std::erase_if(out, [](const auto& chain) { return chain.empty(); });
    return out;
  }

  /// Reads the results that the tasks have finished so far.
  void gather() {
    for (const std::size_t i : due_) {
      StudyOutcome& o = outcomes_[i];
      if (o.status != StudyStatus::not_run) continue;
      if (take_finished_case(case_digest(order_, i), o)) {
        o.earlier = false;
        ++finished_;
        spent_ += o.seconds;
        last_ = order_.plan.label(i);
      } else if (order_.rise && is_passed_over(i)) {
        o.status = StudyStatus::passed_over, ++passed_;
      }
    }
  }

  /// True if a lower case, which differs in the rising parameter alone, has reached the stop criterion.
  [[nodiscard]] bool is_passed_over(std::size_t i) const {
    for (const std::size_t k : below_[i])
      if (outcomes_[k].status == StudyStatus::finished)
        for (const StudyFigure& f : outcomes_[k].figures)
          if (f.name == order_.rise->stop && f.value == decltype(f.value)(true)) return true;
    return false;
  }

  /// In an incremental study, a case runs after the lower ones have ended without the stop criterion.
  OrderTurn turn_of(std::size_t i) {
    if (is_passed_over(i)) {
      outcomes_[i].status = StudyStatus::passed_over, ++passed_;
      return OrderTurn::never;
    }
    const auto waits = [this](std::size_t k) {
      return outcomes_[k].status == StudyStatus::not_run &&
             (order_.only.empty() || std::find(due_.begin(), due_.end(), k) != due_.end());
    };
    return std::any_of(below_[i].begin(), below_[i].end(), waits) ? OrderTurn::later : OrderTurn::now;
  }

  bool run_these(const std::vector<std::size_t>& wanted) {
    std::vector<ProcessOrder> orders;
    for (const std::size_t i : wanted) {
      const std::filesystem::path& folder = outcomes_[i].folder;
      orders.push_back({{}, folder / "log.txt", folder / "errors.txt"});
      if (order_.run_here)
        orders.back().here = [this, i] { return order_.run_here(i, outcomes_[i].folder); };
      else
        orders.back().command = order_.command(i, folder);
    }
    const ProcessWatch watch{
        [&](std::size_t n) { begin(wanted[n]); }, [&](std::size_t n, const ProcessEnd& end) { finish(wanted[n], end); },
        [this] { return look(); }, [&](std::size_t n) { return order_.rise ? turn_of(wanted[n]) : OrderTurn::now; }};
    return run_processes(orders, jobs(), watch);
  }

  /// Clears the folder, so that nothing of an earlier run is mistaken for results of this one. A folder with
  /// checkpoints stays: the case decides whether it can continue from them.
  void begin(std::size_t i) {
    if (order_.fresh || !has_checkpoints(outcomes_[i].folder)) std::filesystem::remove_all(outcomes_[i].folder);
    make_folders(outcomes_[i].folder);
    ++running_;
  }

  void finish(std::size_t i, const ProcessEnd& end) {
    StudyOutcome& o = outcomes_[i];
    o.exit = end.exit;
    o.seconds = end.seconds;
    o.message = why_failed(o, end);
    if (o.message.empty())
      keep_finished_case(case_digest(order_, i), o);
    else if (!order_.only.empty())
      keep_failed_case(case_digest(order_, i), o);
    o.status = o.message.empty() ? StudyStatus::finished : StudyStatus::failed;
    --running_;
    ++(o.status == StudyStatus::failed ? failed_ : finished_);
    spent_ += end.seconds;
    last_ = order_.plan.label(i);
    if (!o.message.empty())
      watch_.line(
          fmt::format("case {} of {}  {}: failed: {}", i + 1, outcomes_.size(), order_.plan.label(i), o.message), true);
  }

  /// Reads the figures; returns "" on success.
  std::string why_failed(StudyOutcome& o, const ProcessEnd& end) const {
    if (!end.trouble().empty()) {
      const std::string said = case_text(o.folder / "errors.txt");
      const std::string line = said.substr(0, said.find('\n'));
      return line.empty() ? end.trouble() : line;
    }
    try {
      o.figures = figures_from(case_text(o.folder / figures_file));
      for (const StudyHistory& h : order_.histories) o.figures.push_back(figure_from_results(o.folder, h));
      check_figure_names(order_.plan, o.figures);
    } catch (const std::exception& e) {
      o.figures.clear();
      return e.what();
    }
    return "";
  }

  bool look() {
    const std::size_t done = finished_ + failed_, gone = std::min(done + passed_, due_.size()),
                      left = due_.size() - gone;
    std::string text = fmt::format("study: {} of {} done", outcomes_.size() - left, outcomes_.size());
    if (failed_ > 0) text += fmt::format(", {} failed", failed_);
    if (passed_ > 0) text += fmt::format(", {} passed over", passed_);
    if (order_.on_slurm.empty()) text += fmt::format(", {} running", running_);
    if (done > 0 && order_.on_slurm.empty()) {
      // Running cases count as half done.
      const double cases = static_cast<double>(left) - 0.5 * static_cast<double>(running_);
      text += fmt::format(", {} left", duration_text(spent_ / static_cast<double>(done) * cases / jobs()));
      text += "; last: " + last_;
    }
    watch_.status(text);
    return watch_.goes_on();
  }

  [[nodiscard]] std::string summary(bool whole) const {
    const std::size_t good = static_cast<std::size_t>(std::count_if(
        outcomes_.begin(), outcomes_.end(), [](const auto& o) { return o.status == StudyStatus::finished; }));
    return fmt::format("{} of {} cases finished{}{}{}; the table is {}", good, outcomes_.size(),
                       failed_ > 0 ? fmt::format(", {} failed", failed_) : "",
                       passed_ > 0 ? fmt::format(", {} passed over", passed_) : "",
                       whole ? "" : ", stopped before its end", order_.file.string());
  }

  const StudyOrder& order_;
  const StudyWatch& watch_;
  std::vector<StudyOutcome> outcomes_;                    // [case]
  std::vector<std::size_t> due_;                          // cases to run
  std::vector<std::vector<std::size_t>> chains_, below_;  // for an incremental study; [case] the lower cases
  std::size_t finished_ = 0, failed_ = 0, running_ = 0, passed_ = 0;
  std::string last_;  // the case that ended last
  double spent_ = 0;  // wall clock of all that ended [s]
};

}  // namespace

std::filesystem::path case_folder(const StudyOrder& order, std::size_t index) {
  constexpr std::size_t longest = 80;
  std::string name;
  bool exact = true;
  for (std::size_t k = 0; k < order.plan.names.size(); ++k) {
    if (k > 0) name += ',';
    name += order.plan.argument(index, k);
  }
  Hash hash;
  hash.add(name);
  for (char& c : name) {
    const bool plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                       std::string_view("=,.+-_").find(c) != std::string_view::npos;
    exact = exact && plain;
    if (!plain) c = '_';
  }
  if (!exact || name.size() > longest)
    name = fmt::format("{}-{:08x}", name.substr(0, longest), static_cast<std::uint32_t>(hash.value()));
  return folder_of_cases(order) / name;
}

std::vector<StudyOutcome> run_study(const StudyOrder& order, const StudyWatch& watch) {
  return StudyRun(order, watch).go();
}

bool any_failed(const std::vector<StudyOutcome>& outcomes) {
  return std::any_of(outcomes.begin(), outcomes.end(), [](const auto& o) { return o.status == StudyStatus::failed; });
}

}  // namespace trilith
