// Writes and reads a simulation in restart files. A run that continues from them computes the same bits.
#include "assembly/tangent/tangent.hpp"
#include "base/bytes.hpp"
#include "model/io/fingerprint.hpp"
#include "model/io/state_words.hpp"
#include "run/restart/stage_fields.hpp"
#include "run/simulation.hpp"
#include "run/watch.hpp"

namespace trilith {
namespace {

/// Throws InputError if the script has built a different model.
void require_fingerprint(const std::string& owner, const Fingerprint& built, const Fingerprint& saved) {
  if (built.structure != saved.structure)
    throw InputError(owner + " belongs to another model: its bodies, laws or bearings differ");
  if (built.conditions != saved.conditions)
    throw InputError(owner +
                     " belongs to this model under other conditions: supports, motions, gravity, damping or "
                     "loads differ");
}

}  // namespace

template <class File>
void each_field(File& file, FaultCount& f) {
  file.item(f.count), file.item(f.time), file.item(f.first);
}

template <class File>
void each_field(File& file, FailedCheck& f) {
  file.item(f.time), file.item(f.text);
}

template <class File>
void each_field(File& file, CrackWatch& w) {
  file.item(w.next), file.item(w.load), file.item(w.change);
}

template <int D>
void Simulation<D>::write(ByteWriter& out) const {
  const Fingerprint print = model_fingerprint(model_, state_);
  out.item(print.structure), out.item(print.conditions);
  out.item(state_words(state_));
  const_cast<Causes&>(causes_).each_number([&](auto& v) { out.item(v); });
  const_cast<Verdict&>(verdict_).each_number([&](auto& v) { out.item(v); });
  const_cast<Seal&>(seal_).each_number([&](auto& v) { out.item(v); });
  out.item(leaving_), out.item(changed_), out.item(rest_.share);
  watch_->each_number([&](auto& v) { out.item(v); });
  out.item(cracking_.watch);
  out.item(stage_.has_value());
  if (stage_) out.item(*stage_);
}

template <int D>
void Simulation<D>::read(ByteReader& in, const StageOptions* options) {
  Fingerprint saved;
  in.item(saved.structure), in.item(saved.conditions);
  require_fingerprint(in.owner(), {model_fingerprint(model_).structure, saved.conditions}, saved);
  put_state(state_from_words(model_, in.get<std::vector<std::uint64_t>>(), in.owner()));
  require_fingerprint(in.owner(), model_fingerprint(model_, state_), saved);
  causes_.each_number([&](auto& v) { in.item(v); });
  verdict_.each_number([&](auto& v) { in.item(v); });
  seal_.each_number([&](auto& v) { in.item(v); });
  in.item(leaving_), in.item(changed_), in.item(rest_.share);
  watch_->each_number([&](auto& v) { in.item(v); });
  in.item(cracking_.watch);
  stage_.reset();
  if (in.get<bool>() != (options != nullptr)) in.fail("is of another moment of its stage");
  if (options == nullptr) return;
  stage_.emplace(*options, state_.time);
  in.item(*stage_);
}

template <int D>
void Simulation<D>::put_state(State<D> state) {
  state_ = std::move(state);
  all_left_ = hold_left(model_, state_);
  watch_->reset();
  tangent_->forget();
  drop_work();
}

template <int D>
void Simulation<D>::keep_places(const StageOptions& options) {
  if (options.until_rest && (options.within > 0 || seeks_rest(options))) watch_->keep_places(state_);
}

template <int D>
void Simulation<D>::apply(const std::function<bool(Model<D>&)>& change) {
  if (change(model_)) unscale_masses(), edited();
}

template void Simulation<2>::write(ByteWriter&) const;
template void Simulation<3>::write(ByteWriter&) const;
template void Simulation<2>::read(ByteReader&, const StageOptions*);
template void Simulation<3>::read(ByteReader&, const StageOptions*);
template void Simulation<2>::put_state(State<2>);
template void Simulation<3>::put_state(State<3>);
template void Simulation<2>::keep_places(const StageOptions&);
template void Simulation<3>::keep_places(const StageOptions&);
template void Simulation<2>::apply(const std::function<bool(Model<2>&)>&);
template void Simulation<3>::apply(const std::function<bool(Model<3>&)>&);

}  // namespace trilith
