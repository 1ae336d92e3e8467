// The end of a recording: the results file, and a line on the energy balance.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "base/quantity_text.hpp"
#include "bindings/model/simulated_model.hpp"

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
  const std::vector<SealRow> seal = simulation_->seal().rows(*verdict_, notes().size());
  if (!modes_alone) recording->seal(seal);
  recording->finish();
  static_cast<void>(close_restart(true));
  if (modes_alone) return fmt::format("modes are in {}", recording->path().string());
  const EnergyCheck& check = recording->energy_check();
  return fmt::format("results are in {}; the error of the energy balance is {} of the input of {}{}\n{}",
                     recording->path().string(), percent_text(check.share()), quantity_text(check.input(), "J"),
                     dissipated_text(check), fmt::join(seal_lines(seal), "\n"));
}

template std::string SimulatedModel<2>::finish(const std::string&);
template std::string SimulatedModel<3>::finish(const std::string&);

}  // namespace trilith::script
