// A model of a script in D dimensions: runs, records and rewinds. No Lua here.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bindings/model/script_model.hpp"
#include "run/findings.hpp"
#include "run/record/recording.hpp"
#include "run/step_check.hpp"

namespace trilith::script {

/// Builds without the check for unsupported parts, which the first stage makes. If it cannot be built, the check is
/// made too.
template <class Builder>
auto built_unjudged(Builder& builder) {
  builder.judge_standing = false;
  try {
    return builder.build();
  } catch (const InputError&) {
    builder.judge_standing = true;
    throw;
  }
}

/// A push whose force a load path has scaled; the load of that name contains it.
template <int D>
struct LoadPush {
  Push<D> push;            ///< its name, points and direction
  double first_place = 0;  ///< coordinate of its points along it at the start of the path [m]
};

template <int D>
class SimulatedModel : public ScriptModel {
 public:
  using ScriptModel::ScriptModel;

  std::vector<LoadPush<D>> load_pushes;          ///< in the order of their stages
  std::function<void(const Instant<D>&)> watch;  ///< internal callback after each step; empty: none

  [[nodiscard]] int dim() const override { return D; }
  [[nodiscard]] bool built() const override { return simulation_ != nullptr; }
  [[nodiscard]] bool recording() const override { return recording_ != nullptr; }
  void build() override { simulation(); }
  /// Builds the model if necessary. Throws InputError as the builder does.
  Simulation<D>& simulation();
  /// The simulation with its forces up to date, for reading.
  const Simulation<D>& evaluated();
  /// Its joints, storeys and base; builds the model.
  const Findings<D>& findings();
  [[nodiscard]] const Simulation<D>* if_built() const { return simulation_.get(); }
  /// True if the model is built and contains the body: additions by a handler enter it at the next step border.
  [[nodiscard]] bool has_body(int body) const {
    return simulation_ && static_cast<std::size_t>(body) < simulation_->model().bodies.size();
  }
  /// Makes `change` now, or at the next step border while a stage runs.
  void change(std::function<void(Model<D>&)> what);

  /// Changes laws, now or at the next step border; the ledger receives the added energy. Bearings in `begun` restart.
  void modify(std::function<void(Model<D>&)> what, std::vector<int> begun);
  /// Changes supports and drives, as `change` does; the ledger receives the energy difference.
  void change_supports(std::function<void(Model<D>&)> what);
  void catch_up() override;
  void follow_more() override;
  void remove(const std::vector<int>& which, const std::vector<int>& links, const std::string& place) override;
  void reactivate(const std::vector<int>& which, const std::vector<int>& links, bool from_start,
                  const std::string& place) override;
  [[nodiscard]] bool is_out(int body) const override;
  [[nodiscard]] bool is_bearing_out(int bearing) const override;
  [[nodiscard]] bool is_seat_out(int seat) const override;
  [[nodiscard]] bool is_storey_out(int number) override;
  [[nodiscard]] std::string why_absent(int body) const override;
  [[nodiscard]] std::optional<double> removed_at(int body) const override;

  [[nodiscard]] double time() const override { return simulation_ ? simulation_->state().time : 0; }
  [[nodiscard]] StepNumbers step_numbers() override;
  [[nodiscard]] Energy energy() override { return evaluated().energy(); }
  [[nodiscard]] double residual() override;
  [[nodiscard]] std::uint64_t hash() override;
  [[nodiscard]] std::string step_text() override;
  [[nodiscard]] std::string text_of(const Event& event) const override;
  [[nodiscard]] double mass_of(int body) override;
  [[nodiscard]] std::vector<double> heights() const override;
  [[nodiscard]] bool is_resting(int body) const override {
    return has_body(body) && simulation_->state().resting[static_cast<std::size_t>(body)] != 0;
  }
  void grow_weight(double end) override;
  void lift_bonds() override { simulation().lift_bonds(); }
  void set_bonds() override { simulation().set_bonds(); }
  void drop_step() override { simulation().drop_step(); }
  void stop(const std::string& why) override {
    stop_reason_ = why;
    if (simulation_) simulation_->stop();
  }

  StageReport run(const StageOptions& options, const ScriptListener& listener, Host& host,
                  const EquilibriumOptions* statics, AnyLoadWay way) override;
  void run_on(const RunLimit& limit, const ScriptListener& listener, Host& host) override;
  StageReport resume(const ScriptListener& listener, Host& host) override;
  double rewind(double time, Host& host) override;
  void note(const std::string& text) override;
  /// Writes modes found together to the results file, if there is or will be one. Modes found before its first stage
  /// wait for it, and create a file themselves if no stage follows.
  void record_modes(std::vector<results::ModeRow> found, Host& host);
  std::string finish(const std::string& error) override;
  void keep_change(const HandlerCall* call) override;
  void end_by_signal() override;
  void save_instant(const std::filesystem::path& file, const ScriptListener& listener) override;

 protected:
  /// The model of the builder. Unsupported parts are checked at the start of the first stage, because a bearing may
  /// still be added.
  [[nodiscard]] virtual Model<D> built_model() = 0;
  /// Unsupported parts of a built model, one line each; none after that check.
  [[nodiscard]] virtual std::vector<std::string> standing_faults() const = 0;
  /// From now on additions are checked at once.
  virtual void judge_standing() = 0;
  /// `model` with the latest additions of the builder, relative to the positions in `state`.
  [[nodiscard]] virtual Model<D> extended_model(const Model<D>& model, const State<D>& state) = 0;
  /// Largest overlap of two bodies in their initial position, as a share of the smaller one's size.
  [[nodiscard]] virtual double overlap_allowed() const = 0;
  /// The bodies of `model` that may crack.
  [[nodiscard]] virtual std::vector<CrackingBody<D>> cracking_bodies(const Model<D>& model) const = 0;
  /// `model` with the two parts of each body that cracks.
  [[nodiscard]] virtual Model<D> cracked_model(const Model<D>& model, std::span<const Crack<D>> cracks) = 0;
  /// Removes additions that are not in `model`.
  virtual void forget_beyond(const Model<D>& model) = 0;
  /// A model of this body alone.
  [[nodiscard]] virtual Model<D> lone_body(int body) const = 0;

 private:
  void begin_recording(Host& host);
  void keep_until_finish(Host& host);
  void open_recording(Host& host);
  void continue_recording(Host& host, double left, const Recording<D>& before);
  void replay(Recording<D>& recording);
  StageReport guarded_run(const std::function<StageReport()>& go, Host& host);
  [[nodiscard]] Checkpoint checkpoint();
  // Checkpoints on the disk (bindings/restart/simulated_restart.cpp).
  void open_restart(Host& host);
  void begin_kept_stage(const StageOptions& options, bool by_steps, bool typed);
  void end_kept_stage(const StageReport& report, const ScriptListener& listener, Host& host);
  void keep_checkpoint(const ScriptListener& listener, Host& host);
  [[nodiscard]] std::optional<StageReport> restored_stage(const StageOptions& options, const ScriptListener& listener,
                                                          const LoadWay<D>* way, const RunListener<D>& all, Host& host);
  [[nodiscard]] std::optional<StageReport> go_to_moment(const std::string& name, const StageOptions& options,
                                                        const LoadWay<D>* way, const ScriptListener& listener,
                                                        bool is_last);
  void replay_changes(int last, const std::vector<Event>& all, const ScriptListener& listener);
  [[nodiscard]] std::string moment(const StageReport* ended, const ScriptListener& listener);
  void store_restart(Host& host);
  void tell_restart(Host& host, const std::string& text);
  [[nodiscard]] std::string close_restart(bool whole);
  [[nodiscard]] bool restoring() const { return restart && restart->restoring; }
  RunListener<D> listen_with(const ScriptListener& script, Host& host);
  void take_histories(double time);
  bool apply_changes(Model<D>& model);
  bool make_changes(Model<D>& model);
  void find_cracks();
  void extend();
  void split(const std::vector<Crack<D>>& cracks);
  void forget_added();
  void extend_recording();
  void require_unpushed(const std::vector<int>& which) const;
  [[nodiscard]] std::vector<RecordedHistory<D>> recorded_histories() const;

  std::unique_ptr<Simulation<D>> simulation_;
  std::optional<Findings<D>> findings_;
  std::optional<double> balance_at_start_;  // of the ledger, from its first stage on [J]
  std::unique_ptr<Recording<D>> recording_;
  std::vector<std::vector<results::ModeRow>> waiting_modes_;
  Host* modes_host_ = nullptr;                              // of those
  std::optional<State<D>> recorded_from_;                   // begin of all branches of the results
  std::vector<std::function<void(Model<D>&)>> changes_;     // to be made at the step border
  std::vector<Crack<D>> kept_cracks_;                       // of the change that is being stored or repeated
  std::size_t caught_up_ = 0;                               // number of additions already in the model
  std::optional<StepCheck<D>> step_check_;                  // of the stage that runs
  std::optional<std::pair<SealRow, double>> checked_step_;  // of the last stage that had one, and its start [s]
};

}  // namespace trilith::script
