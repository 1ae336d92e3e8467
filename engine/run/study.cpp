#include "run/study.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

#include "base/error.hpp"
#include "base/hash.hpp"
#include "base/whole_file.hpp"
#include "results/study_table.hpp"
#include "run/processes.hpp"
#include "run/progress.hpp"
#include "run/study_columns.hpp"

namespace trilith {
namespace {

constexpr const char* record_file = "case.txt";  // of a finished case: its digest, wall clock and figures

std::string digest_of(const StudyOrder& order, std::size_t index) {
  Hash hash;
  hash.add(order.source);
  for (std::size_t k = 0; k < order.plan.names.size(); ++k) hash.add(order.plan.argument(index, k));
  for (const StudyHistory& h : order.histories) hash.add(h.column());
  return fmt::format("{:016x}", hash.value());
}

std::string text_in(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  if (in) text << in.rdbuf();
  return text.str();
}

/// What an earlier call has left of a case, where it still holds.
bool take_earlier(const std::string& digest, StudyOutcome& outcome) {
  std::istringstream in(text_in(outcome.folder / record_file));
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

void require_distinct(const StudyOrder& order) {
  std::map<std::string, std::size_t> seen;
  for (std::size_t i = 0; i < order.plan.cases.size(); ++i) {
    const auto [it, added] = seen.emplace(order.plan.label(i), i);
    if (!added)
      throw InputError(fmt::format("study: cases {} and {} are the same: {}; give copies a parameter of their own",
                                   it->second + 1, i + 1, it->first));
  }
}

/// Held as long as a study is at work.
class Lock {
 public:
  explicit Lock(const std::filesystem::path& folder)
      : file_(::open((folder / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
    if (file_ >= 0 && ::flock(file_, LOCK_EX | LOCK_NB) == 0) return;
    if (file_ >= 0) ::close(file_);
    throw InputError(fmt::format("study: {} cannot be locked; another study is at work there", folder.string()));
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

class StudyRun {
 public:
  StudyRun(const StudyOrder& order, const StudyWatch& watch)
      : order_(order), watch_(watch), outcomes_(order.plan.cases.size()) {}

  std::vector<StudyOutcome> go() {
    require_distinct(order_);
    if (order_.rise) require_rising(order_.plan, order_.rise->over);
    make_folders(folder_of_cases(order_));
    const Lock lock(folder_of_cases(order_));
    results::require_study_path(order_.file);
    results::Provenance provenance = order_.provenance;  // before the first case: its time is the study's begin
    sort_out();
    const bool whole = run_due();
    results::write_study_table(order_.file, study_table_columns(order_.plan, outcomes_), provenance, whole);
    watch_.line(summary(whole), false);
    return std::move(outcomes_);
  }

 private:
  void sort_out() {
    for (std::size_t i = 0; i < outcomes_.size(); ++i) {
      outcomes_[i].folder = case_folder(order_, i);
      if (order_.fresh || !take_earlier(digest_of(order_, i), outcomes_[i])) due_.push_back(i);
    }
    const std::size_t kept = outcomes_.size() - due_.size();
    watch_.line(fmt::format("study of {} case{}, {} at a time{}", outcomes_.size(), outcomes_.size() == 1 ? "" : "s",
                            jobs(), kept == 0 ? "" : fmt::format("; {} finished before", kept)),
                false);
  }

  [[nodiscard]] int jobs() const { return order_.jobs > 0 ? order_.jobs : processors(); }

  /// All at once or, where the study rises, level by level: what is passed over depends on the level before.
  bool run_due() {
    if (order_.prepare && !due_.empty()) order_.prepare();
    if (!order_.rise) return run_these(due_);
    const std::vector<std::vector<std::size_t>> levels = rising_levels(order_.plan, order_.rise->over);
    for (const std::vector<std::size_t>& level : levels) {
      std::vector<std::size_t> wanted;
      for (const std::size_t i : level) {
        if (outcomes_[i].status == StudyStatus::finished) continue;
        if (is_passed_over(i))
          outcomes_[i].status = StudyStatus::passed_over, ++passed_;
        else
          wanted.push_back(i);
      }
      if (!run_these(wanted)) return false;
    }
    return true;
  }

  /// Whether a case that differs in the rising parameter alone, and lies lower, has come to where the study stops.
  [[nodiscard]] bool is_passed_over(std::size_t i) const {
    for (std::size_t k = 0; k < outcomes_.size(); ++k)
      if (outcomes_[k].status == StudyStatus::finished && is_below(order_.plan, order_.rise->over, k, i))
        for (const StudyFigure& f : outcomes_[k].figures)
          if (f.name == order_.rise->stop && f.value == decltype(f.value)(true)) return true;
    return false;
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
    const ProcessWatch watch{[&](std::size_t n) { begin(wanted[n]); },
                             [&](std::size_t n, const ProcessEnd& end) { finish(wanted[n], end); },
                             [this] { return look(); }};
    return run_processes(orders, jobs(), watch);
  }

  /// An empty folder: nothing of an earlier run can be taken for this one's.
  void begin(std::size_t i) {
    std::filesystem::remove_all(outcomes_[i].folder);
    make_folders(outcomes_[i].folder);
    ++running_;
  }

  void finish(std::size_t i, const ProcessEnd& end) {
    StudyOutcome& o = outcomes_[i];
    o.exit = end.exit;
    o.seconds = end.seconds;
    o.message = why_failed(o, end);
    if (o.message.empty()) keep(i);
    o.status = o.message.empty() ? StudyStatus::finished : StudyStatus::failed;
    --running_;
    ++(o.status == StudyStatus::failed ? failed_ : finished_);
    spent_ += end.seconds;
    last_ = order_.plan.label(i);
    if (!o.message.empty())
      watch_.line(
          fmt::format("case {} of {}  {}: failed: {}", i + 1, outcomes_.size(), order_.plan.label(i), o.message), true);
  }

  /// Reads the figures; "" where all is well.
  std::string why_failed(StudyOutcome& o, const ProcessEnd& end) const {
    if (!end.trouble().empty()) {
      const std::string said = text_in(o.folder / "errors.txt");
      const std::string line = said.substr(0, said.find('\n'));
      return line.empty() ? end.trouble() : line;
    }
    try {
      o.figures = figures_from(text_in(o.folder / figures_file));
      for (const StudyHistory& h : order_.histories) o.figures.push_back(figure_from_results(o.folder, h));
      check_figure_names(order_.plan, o.figures);
    } catch (const std::exception& e) {
      o.figures.clear();
      return e.what();
    }
    return "";
  }

  void keep(std::size_t i) const {
    const StudyOutcome& o = outcomes_[i];
    write_whole_file(o.folder / record_file,
                     fmt::format("{}\n{}\n{}", digest_of(order_, i), o.seconds, figures_text(o.figures)));
  }

  bool look() {
    const std::size_t done = finished_ + failed_, gone = std::min(done + passed_, due_.size()),
                      left = due_.size() - gone;
    std::string text = fmt::format("study: {} of {} done", outcomes_.size() - left, outcomes_.size());
    if (failed_ > 0) text += fmt::format(", {} failed", failed_);
    if (passed_ > 0) text += fmt::format(", {} passed over", passed_);
    text += fmt::format(", {} running", running_);
    if (done > 0) {
      // Half of what runs is taken as done.
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
  std::vector<StudyOutcome> outcomes_;  // [case]
  std::vector<std::size_t> due_;        // cases to run
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

}  // namespace trilith
