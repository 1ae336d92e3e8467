// The frame of a stage, and the end of a recording: the results file, and a line on the energy balance.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "base/quantity_text.hpp"
#include "bindings/core/guard.hpp"
#include "bindings/model/simulated_model.hpp"
#include "model/caution.hpp"

namespace trilith::script {
namespace {

/// "sliding friction" of "dissipated by sliding friction, and by faces that separate while sliding".
std::string_view means_of(std::string_view sentence) {
  constexpr std::string_view head = "dissipated by ";
  if (sentence.starts_with(head)) sentence.remove_prefix(head.size());
  return sentence.substr(0, sentence.find(','));
}

/// Text: energy that was dissipated, as shares of the supplied energy, the largest first.
std::string dissipated_text(const EnergyCheck& check) {
  std::vector<std::pair<double, std::string_view>> shares;
  for (int i = 0; i < energy_terms; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double share = check.input() > 0 ? check.last().value[k] / check.input() : 0;
    if (energy_term_info[k].dissipated && share >= 5e-4)
      shares.emplace_back(share, means_of(energy_term_info[k].sentence));
  }
  std::sort(shares.rbegin(), shares.rend());
  std::string text;
  for (const auto& [share, name] : shares)
    text += fmt::format("{}{:.1f} %{} by {}", text.empty() ? "; " : ", ", 100 * share,
                        text.empty() ? " of it was dissipated" : "", name);
  return text;
}

}  // namespace

template <int D>
StageReport SimulatedModel<D>::guarded_run(const std::function<StageReport()>& go, Host& host) {
  struct Scope {
    SimulatedModel& model;
    explicit Scope(SimulatedModel& m) : model(m) {
      model.running_ = true;
      count_crossing();
    }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;
    ~Scope() {
      count_crossing();
      if (model.restart) model.restart->at_work = model.restart->replaying = false;
      model.resumed_steps = 0;
      *model.verdict_ = model.simulation_->verdict();
      model.running_ = false;
      model.pause_reason.clear();  // of a step border that this stage did not reach
      model.changes_.clear();
    }
  } scope(*this);
  const auto known = [&](const auto& entry) { return entry.second == verdict_; };
  if (std::none_of(host.verdicts.begin(), host.verdicts.end(), known)) host.verdicts.emplace_back(title(), verdict_);
  StageReport report;
  const auto begun = std::chrono::steady_clock::now();
  stop_reason_.clear();
  try {
    report = go();
    if (report.end == StageEnd::stopped && report.reason.empty()) report.reason = stop_reason_;
    broken_.clear();
  } catch (const std::exception& e) {
    broken_ = e.what();
    if (restart && !(host.interrupted != nullptr && host.interrupted())) restart->off = "a stage failed";
    throw;
  }
  host.profile.times.all += std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  if (report.end == StageEnd::diverged) note(report.reason);
  if (host.observer != nullptr) host.observer->stage_ended(report);
  return report;
}

template <int D>
std::string SimulatedModel<D>::finish(const std::string& error) {
  const bool modes_alone = !recording_ && !waiting_modes_.empty() && error.empty();
  if (modes_alone) begin_recording(*modes_host_);
  if (!recording_) return "";
  const std::unique_ptr<Recording<D>> recording = std::move(recording_);
  std::string why = error.empty() ? broken_ : error;
  if (why.empty() && verdict_->has(EventType::stage_diverged)) why = verdict_->fault(EventType::stage_diverged).first;
  if (why.empty() && simulation_->stage() != nullptr) why = "a stage that was rewound was not run to its end";
  if (!why.empty()) {
    recording->abandon(why);
    return fmt::format("results so far, unfinished, are in {}{}", recording->part().string(), close_restart(false));
  }
  if (checked_step_) {
    simulation_->add_check(checked_step_->first, checked_step_->second);
    *verdict_ = simulation_->verdict();
  }
  std::vector<SealRow> seal = simulation_->seal().rows(*verdict_, notes().size());
  seal.back().text += caution_text(notes());
  if (!modes_alone) recording->seal(seal);
  recording->finish();
  static_cast<void>(close_restart(true));
  if (modes_alone) return fmt::format("modes are in {}", recording->path().string());
  const EnergyCheck& check = recording->energy_check();
  return fmt::format("results are in {}; the error of the energy balance is {} of the input of {}{}\n{}",
                     recording->path().string(), percent_text(check.share()), quantity_text(check.input(), "J"),
                     dissipated_text(check), fmt::join(seal_lines(seal), "\n"));
}

template StageReport SimulatedModel<2>::guarded_run(const std::function<StageReport()>&, Host&);
template StageReport SimulatedModel<3>::guarded_run(const std::function<StageReport()>&, Host&);
template std::string SimulatedModel<2>::finish(const std::string&);
template std::string SimulatedModel<3>::finish(const std::string&);

}  // namespace trilith::script
