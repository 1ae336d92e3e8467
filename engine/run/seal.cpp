#include "run/seal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "assembly/contact/contact_rows.hpp"
#include "base/quantity_text.hpp"
#include "run/stage.hpp"
#include "statics/travel.hpp"

namespace trilith {
namespace {

template <int D>
double thinner_of_pair(const Model<D>& model, const NearPair& pair) {
  return std::min(model.piece_thickness[pair.piece_a], model.piece_thickness[pair.piece_b]);
}

/// Largest overlap of the touching contacts that are not faces of the plane.
template <int D>
double deepest_of_general(const Model<D>& model, const Work<D>& work) {
  double most = 0;
  for (const GeneralContact<D>& contact : work.general_touching)
    most = std::max(most, contact.depth / thinner_of_pair(model, work.pairs[static_cast<std::size_t>(contact.row)]));
  return most;
}

/// Distance of a node that a motion drives from its place by the record [m], and the displacement of the record.
struct DrivenPlace {
  double off = 0, displacement = 0;
};

template <int D>
DrivenPlace farthest_driven(const Model<D>& model, const State<D>& state) {
  DrivenPlace out;
  for (std::size_t i = 0; i < model.drives.size(); ++i) {
    const Drive& drive = model.drives[i];
    if (drive.dof >= D || model.drive_of[drive.node][static_cast<std::size_t>(drive.dof)] != static_cast<int>(i))
      continue;
    const double moved = drive.motion->displacement(state.time - drive.start);
    out.displacement = std::max(out.displacement, std::abs(moved));
    out.off = std::max(out.off, std::abs(state.position[drive.node][drive.dof] - drive.origin - moved));
  }
  return out;
}

/// Energy of the whole model at 1 mm/s [J]: smaller residuals are not errors of a run.
template <int D>
double trifling_energy(const Model<D>& model) {
  constexpr double speed = 1e-3;  // [m/s]
  return 0.5 * speed * speed * std::accumulate(model.mass.begin(), model.mass.end(), 0.0);
}

SealRow share_row(const char* check, double value, double limit, const char* of, bool made) {
  if (!made) return {check, "not made", 0, limit, "1", "nothing to check", 0};
  return {check, value <= limit ? "passed" : "failed", value, limit, "1", of, 0};
}

}  // namespace

double deepest_share(const Model<2>& model, const Work<2>& work) {
  double most = deepest_of_general(model, work);
  for (std::size_t row = 0; row < work.pairs.size(); ++row) {
    const std::uint32_t state = work.contacts.memory[row].state;
    if ((state & contact_touching) == 0 || (state & contact_general) != 0) continue;
    const FaceOverlap<double> overlap = face_overlap(work, work.pairs[row]);
    most = std::max(most, -std::min(overlap.gap_lo, overlap.gap_hi) / thinner_of_pair(model, work.pairs[row]));
  }
  return most;
}

double deepest_share(const Model<3>& model, const Work<3>& work) {
  return deepest_of_general(model, work);
}

template <int D>
double unbalanced_share(const Model<D>& model, const State<D>& state, const Work<D>& work) {
  // Held nodes of a deformable body receive no forces of its elements, so its forces have no sum of 0.
  if (std::any_of(model.bodies.begin(), model.bodies.end(), [](const Body& b) { return !b.is_rigid(); })) return -1;
  // Forces include the inertia of the water that moves with a body, which does not act between bodies.
  bool moves_water = false;
  model.loads.for_each_kind([&]<class L>(const std::vector<L>& loads) {
    if constexpr (is_inertia<L>) moves_water = moves_water || !loads.empty();
  });
  if (moves_water) return -1;
  const Vec<D> field = model.gravity.at(state.time);
  const std::vector<Vec<D>>& load = work.load.empty() ? model.load : work.load;
  Vec<D> sum = Vec<D>::Zero();
  double all = 0, outer = 0;
  for (std::size_t n = 0; n < work.force.size(); ++n) {
    const Vec<D> outside = model.mass[n] * field + load[n], inner = work.force[n] - outside;
    sum += inner, all += inner.norm(), outer += outside.norm();
  }
  // Where next to nothing touches, the inner forces are the rounding errors of the weights.
  constexpr double rounding = 1e-9;
  return all > rounding * outer ? sum.norm() / all : -1;
}

template <int D>
void Seal::sample(const Instant<D>& now, const Energy& ledger, bool ends) {
  if (!has_balance_) has_balance_ = true, first_balance_ = ledger.balance();
  const double residual = ends ? ledger.balance() - first_balance_ : 0;
  energy_.add(ledger, std::abs(residual) > trifling_energy(now.model) ? residual : 0);
  if (const double share = unbalanced_share(now.model, now.state, now.work); share >= 0)
    base_shear_ = std::max(base_shear_, share), carries_ = true;
  const DrivenPlace driven = farthest_driven(now.model, now.state);
  motion_peak_ = std::max(motion_peak_, driven.displacement), motion_off_ = std::max(motion_off_, driven.off);
  sample_depth(now.model, now.work);
}

void Seal::end_stage(const StageReport& report, bool sought_rest, const Travel& farthest, const std::string& body,
                     Verdict& verdict) {
  if (report.steps > 0 && report.longest_dt > 0) {
    shortest_ = step_count_ == 0 ? report.shortest_dt : std::min(shortest_, report.shortest_dt);
    longest_ = std::max(longest_, report.longest_dt), step_count_ += report.steps;
  }
  if (sought_rest && report.end == StageEnd::rest) {
    ++rests_, rest_ratio_ = std::max(rest_ratio_, report.ratio);
    if (farthest.share > travel_) travel_ = farthest.share, travelled_ = body;
  }
  const std::array<SealRow, checks> rows = judged();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i].failed() || failed_[i]) continue;
    failed_[i] = true, valid_until_[i] = report.begun;
    verdict.fail(report.begun, seal_text(rows[i]));
  }
}

void Seal::add(const SealRow& row, double begun, Verdict& verdict) {
  added_.push_back(row);
  added_.back().valid_until = begun;
  if (row.failed()) verdict.fail(begun, seal_text(row));
}

std::array<SealRow, Seal::checks> Seal::judged() const {
  const double off = motion_peak_ > 0 ? motion_off_ / motion_peak_ : 0;
  std::array<SealRow, checks> out{
      share_row("energy balance", energy_.share(), SealLimit::energy, "of the input", energy_.input() > 0),
      share_row("base shear against inertia", base_shear_, SealLimit::base_shear, "of the forces", carries_),
      share_row("applied motion against record", off, SealLimit::motion, "of the displacement", motion_peak_ > 0),
      share_row(penetration_check, deepest_, SealLimit::penetration, "of the thinner piece", deepest_ > 0),
      SealRow{"bonds skipped by a step", "passed", 0, 0, "", "joints", 0},
      SealRow{"steps", step_count_ > 0 ? "passed" : "not made", shortest_, 0, "s",
              step_count_ > 0 ? "to " + quantity_text(longest_, "s") : "no step was taken", 0},
      share_row("rest as static equilibrium", rest_ratio_, SealLimit::rest, "unbalanced", rests_ > 0),
      share_row("motion in a search for rest", travel_, SealLimit::travel, "of the body's size", rests_ > 0)};
  if (out[penetration].failed()) out[penetration].state = "passed";  // thin elements; the event decides
  if (!travelled_.empty()) out[travel].text += fmt::format(" ({})", travelled_);
  return out;
}

std::vector<SealRow> Seal::rows(const Verdict& verdict, std::size_t notes) const {
  const std::array<SealRow, checks> now = judged();
  std::vector<SealRow> out(now.begin(), now.end());
  for (std::size_t i = 0; i < out.size(); ++i)
    if (failed_[i]) out[i].state = "failed", out[i].valid_until = valid_until_[i];
  const std::int64_t deep = verdict.fault(EventType::body_passed).count,
                     skipped = verdict.fault(EventType::bond_skipped).count;
  if (deep > 0) out[penetration].state = "failed", out[penetration].valid_until = verdict.sound_until();
  SealRow& bonds = out[softening];
  bonds.value = static_cast<double>(skipped);
  if (skipped > 0) bonds.state = "failed", bonds.valid_until = verdict.sound_until();
  out.insert(out.end(), added_.begin(), added_.end());
  out.push_back({"notes", "passed", static_cast<double>(notes), 0, "", "given during the run", 0});
  return out;
}

template void Seal::sample(const Instant<2>&, const Energy&, bool);
template void Seal::sample(const Instant<3>&, const Energy&, bool);
template double unbalanced_share(const Model<2>&, const State<2>&, const Work<2>&);
template double unbalanced_share(const Model<3>&, const State<3>&, const Work<3>&);

}  // namespace trilith
