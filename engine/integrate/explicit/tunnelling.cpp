#include "integrate/explicit/tunnelling.hpp"

#include <algorithm>
#include <cmath>

#include "integrate/implicit/step_path.hpp"

namespace trilith {
namespace {

/// Smallest interval between checks along a path, as a share of the allowed depth, and the largest number of checks.
/// Only a motion that no step can follow needs more.
constexpr double least_advance = 0.1;
constexpr int most_places = 10000;

/// Search along one step: the displacement of all pieces, and the pairs that may get too deep.
template <int D>
class Search {
 public:
  /// `share`: allowed depth over the thickness of the thinner piece. `more`: the depth is measured relative to the
  /// start of the step.
  Search(const Model<D>& model, const State<D>& state, const Work<D>& work, const StepBegin<D>& begin, double share,
         bool more)
      : model_(model),
        state_(state),
        work_(work),
        begin_(begin),
        path_(model, state, begin),
        share_(share),
        more_(more) {}

  /// False if no piece moves far enough relative to another one.
  bool goes_far();
  /// Calls visit(tunnelling) for pairs of pieces until it returns true.
  template <class Visit>
  void for_each(Visit&& visit);

 private:
  [[nodiscard]] bool counts(int p, int q) const;
  [[nodiscard]] bool is_known(int p, int q) const;
  [[nodiscard]] double far_against(int p, int q) const {
    return (way_[p].middle - way_[q].middle).norm() + way_[p].spread + way_[q].spread;
  }
  [[nodiscard]] FatBox<D> swept_box(int piece) const;
  [[nodiscard]] double beside_common(int piece) const {
    return (way_[piece].middle - common_).norm() + way_[piece].spread;
  }
  void find_common();
  [[nodiscard]] Tunnelling<D> look(int p, int q);
  [[nodiscard]] Tunnelling<D> found(int p, int q, double depth) const;

  const Model<D>& model_;
  const State<D>& state_;
  const Work<D>& work_;
  const StepBegin<D>& begin_;
  const StepPath<D> path_;
  const double share_;
  const bool more_;
  std::vector<PieceWay<D>> way_;    // [piece]
  std::vector<double> allowed_;     // [piece] [m]
  double least_ = unbounded;        // least of `allowed_`
  Vec<D> common_ = Vec<D>::Zero();  // displacement of most pieces, which is not relative motion [m]
  PieceOnPath<D> a_, b_;
};

/// The box of all displacements bounds the relative displacement of any two pieces. Values that are not finite are left
/// to the speed watch.
template <int D>
bool Search<D>::goes_far() {
  ValueRange<D> all;
  way_.clear(), allowed_.clear();
  for (int p = 0; p < model_.pieces(); ++p) {
    way_.push_back(path_.way_of(p));
    allowed_.push_back(share_ * thickness_of(model_, p));
    all.add(way_.back().middle, way_.back().spread);
    least_ = std::min(least_, allowed_.back());
  }
  const double farthest = 2 * all.half();
  return farthest > least_ && std::isfinite(farthest);
}

template <int D>
void Search<D>::find_common() {
  std::vector<double> values;
  for (int k = 0; k < D; ++k) {
    values.clear();
    for (const PieceWay<D>& way : way_) values.push_back(way.middle[k]);
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    common_[k] = *middle;
  }
}

/// True for two bodies that may touch and of which at least one moves.
template <int D>
bool Search<D>::counts(int p, int q) const {
  const int a = model_.piece_body[p], b = model_.piece_body[q];
  if (a == b || state_.left[a] != 0 || state_.left[b] != 0) return false;
  if (!model_.body_moves(a) && !model_.body_moves(b)) return false;
  if (model_.law_of[model_.bodies[a].surface * model_.surfaces + model_.bodies[b].surface] < 0) return false;
  return far_against(p, q) > std::min(allowed_[p], allowed_[q]);
}

template <int D>
bool Search<D>::is_known(int p, int q) const {
  const int a = model_.piece_body[p], b = model_.piece_body[q];
  return std::binary_search(state_.passed.begin(), state_.passed.end(), contact_key(std::min(a, b), std::max(a, b)));
}

/// AABB of a piece from the end of the step back to its start, relative to `common_`.
template <int D>
FatBox<D> Search<D>::swept_box(int piece) const {
  FatBox<D> box = box_of(model_, work_, piece);
  const Vec<D> back = common_ - way_[piece].middle;
  for (int k = 0; k < D; ++k) {
    const auto i = static_cast<std::size_t>(k);
    box.low[i] += std::min(back[k], 0.0) - way_[piece].spread;
    box.high[i] += std::max(back[k], 0.0) + way_[piece].spread;
  }
  return box;
}

template <int D>
Tunnelling<D> Search<D>::found(int p, int q, double depth) const {
  Tunnelling<D> out{p, q, depth, std::min(allowed_[p], allowed_[q]) / share_};
  out.speed = begin_.dt > 0 ? (way_[p].middle - way_[q].middle).norm() / begin_.dt : 0;
  out.place = 0.5 * (a_.middle() + b_.middle());
  return out;
}

/// The depth of two pieces changes by at most their relative displacement. A point of the path with remaining depth
/// thus excludes tunnelling up to that distance ahead.
template <int D>
Tunnelling<D> Search<D>::look(int p, int q) {
  const auto depth_at = [&](double s) {
    a_.place(model_, path_, p, s), b_.place(model_, path_, q, s);
    return depth_between(a_, b_);
  };
  const double allowed = std::min(allowed_[p], allowed_[q]);
  const double rate = far_against(p, q) + way_[p].bend + way_[q].bend;
  double depth = depth_at(0);
  const double most = allowed + (more_ ? std::max(depth, 0.0) : 0);
  double s = 0;
  for (int places = 0; places < most_places; ++places) {
    if (!(depth <= most)) return found(p, q, depth);
    if (s >= 1) break;
    s = std::min(1.0, s + std::max(most - depth, least_advance * allowed) / rate);
    depth = depth_at(s);
  }
  return {};
}

/// Only pieces that move farther than the least allowed depth search for others. If both move, the one with the lower
/// number searches.
template <int D>
template <class Visit>
void Search<D>::for_each(Visit&& visit) {
  find_common();
  const auto looks = [&](int p) { return 2 * beside_common(p) > least_; };
  bool any = false;
  for (int p = 0; p < model_.pieces() && !any; ++p) any = looks(p);
  if (!any) return;  // all move alike, as in free fall
  HierarchicalHashGrid<D> boxes;
  boxes.reset(model_.pieces());
  for (int p = 0; p < model_.pieces(); ++p) boxes.put(p, swept_box(p));
  for (int p = 0; p < model_.pieces(); ++p) {
    if (!looks(p)) continue;
    bool ends = false;
    boxes.for_meeting(boxes.box(p), [&](int q) {
      if (ends || q == p || (q < p && looks(q)) || !counts(p, q) || is_known(p, q)) return;
      const Tunnelling<D> t = look(std::min(p, q), std::max(p, q));
      ends = t.piece_a >= 0 && visit(t);
    });
    if (ends) return;
  }
}

}  // namespace

template <int D>
Tunnelling<D> find_tunnelling(const Model<D>& model, const State<D>& state, const Work<D>& work,
                              const StepBegin<D>& begin) {
  Search<D> search(model, state, work, begin, depth_per_implicit_step, true);
  Tunnelling<D> first;
  if (search.goes_far()) search.for_each([&](const Tunnelling<D>& t) { return first = t, true; });
  return first;
}

template <int D>
std::vector<Tunnelling<D>> list_tunnelling(const Model<D>& model, const State<D>& state, const Work<D>& work,
                                           const StepBegin<D>& begin, double share) {
  Search<D> search(model, state, work, begin, share, false);
  std::vector<Tunnelling<D>> all;
  if (search.goes_far()) search.for_each([&](const Tunnelling<D>& t) { return all.push_back(t), false; });
  const auto key = [&](const Tunnelling<D>& t) {
    const int a = model.piece_body[t.piece_a], b = model.piece_body[t.piece_b];
    return contact_key(std::min(a, b), std::max(a, b));
  };
  std::stable_sort(all.begin(), all.end(), [&](const auto& l, const auto& r) { return key(l) < key(r); });
  const auto same = [&](const auto& l, const auto& r) { return key(l) == key(r); };
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
  return all;
}

template Tunnelling<2> find_tunnelling(const Model<2>&, const State<2>&, const Work<2>&, const StepBegin<2>&);
template Tunnelling<3> find_tunnelling(const Model<3>&, const State<3>&, const Work<3>&, const StepBegin<3>&);
template std::vector<Tunnelling<2>> list_tunnelling(const Model<2>&, const State<2>&, const Work<2>&,
                                                    const StepBegin<2>&, double);
template std::vector<Tunnelling<3>> list_tunnelling(const Model<3>&, const State<3>&, const Work<3>&,
                                                    const StepBegin<3>&, double);

}  // namespace trilith
