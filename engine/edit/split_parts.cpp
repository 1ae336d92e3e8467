#include "edit/split_parts.hpp"

#include <algorithm>
#include <array>

#include "model/contact/skin_places.hpp"

namespace trilith {
namespace {

std::size_t node_of(const Model<2>& model, int body) {
  return static_cast<std::size_t>(model.bodies[static_cast<std::size_t>(body)].first_node);
}

/// Position of a part's node relative to the body's, in the axes of the body.
Vec2 arm_of(const Model<2>& model, const SplitBody& split, int part) {
  return model.start_position[node_of(model, part)] - model.start_position[node_of(model, split.body)];
}

/// Gives points of the body to its parts.
class Givers {
 public:
  Givers(Model<2>& model, const SplitBody& split, const CrackSection<2>& section)
      : model_(model), split_(split), section_(section) {}

  /// The part that holds a point given relative to the body's node, in its axes.
  [[nodiscard]] int part_at(const Vec2& arm) const {
    return section_.normal.dot(arm - section_.middle()) <= 0 ? split_.behind : split_.ahead;
  }
  [[nodiscard]] bool is_on(const Attachment<2>& at) const {
    return at.is_rigid() && static_cast<std::size_t>(at.node[0]) == node_of(model_, split_.body);
  }
  /// Attaches a point to its part, if it is on the body.
  void give(Attachment<2>& at, int& body) const {
    if (!is_on(at)) return;
    body = part_at(at.arm[0]);
    at = Attachment<2>::to_node(static_cast<int>(node_of(model_, body)), at.arm[0] - arm_of(model_, split_, body));
  }
  void give(PushRow<2>& row) const {
    if (static_cast<std::size_t>(row.node) != node_of(model_, split_.body)) return;
    const int part = part_at(row.place);
    row.place -= arm_of(model_, split_, part);
    row.node = row.turn = static_cast<int>(node_of(model_, part));
  }
  /// The skin point of a part that was at `place` at the start.
  [[nodiscard]] int skin_at(int part, const Vec2& place) const {
    const Body& b = model_.bodies[static_cast<std::size_t>(part)];
    int best = b.first_skin;
    for (int s = b.first_skin; s < b.first_skin + b.outline; ++s)
      if ((skin_start(model_, s) - place).norm() < (skin_start(model_, best) - place).norm()) best = s;
    return best;
  }
  void give(const FaceLoad<2>& load, std::vector<FaceLoad<2>>& out) const;

 private:
  void give_part(const FaceLoad<2>& load, double low, double high, std::vector<FaceLoad<2>>& out) const;

  Model<2>& model_;
  SplitBody split_;
  CrackSection<2> section_;
};

/// The part of a pressure between the relative positions `low` and `high` of its face.
void Givers::give_part(const FaceLoad<2>& load, double low, double high, std::vector<FaceLoad<2>>& out) const {
  const double covered = load.share[0] + load.share[1];
  if (!(covered > 0)) return;
  const double middle = load.share[1] / covered;
  const double from = std::max(low, middle - 0.5 * covered), to = std::min(high, middle + 0.5 * covered);
  if (!(to > from)) return;
  const Vec2 a = skin_start(model_, load.skin_a), b = skin_start(model_, load.skin_b);
  const Vec2 first = a + low * (b - a), last = a + high * (b - a);
  const double width = high - low, part = (to - from) / width, at = (0.5 * (from + to) - low) / width;
  FaceLoad<2> given = load;
  given.body = part_at(0.5 * (first + last) - model_.start_position[node_of(model_, split_.body)]);
  given.skin_a = skin_at(given.body, first), given.skin_b = skin_at(given.body, last);
  given.share = {part * (1 - at), part * at};
  given.dead = width * load.dead;
  out.push_back(given);
}

void Givers::give(const FaceLoad<2>& load, std::vector<FaceLoad<2>>& out) const {
  if (load.body != split_.body) {
    out.push_back(load);
    return;
  }
  const Vec2 centre = model_.start_position[node_of(model_, split_.body)] + section_.middle();
  const double p = section_.normal.dot(skin_start(model_, load.skin_a) - centre);
  const double q = section_.normal.dot(skin_start(model_, load.skin_b) - centre);
  const double cut = p * q < 0 ? p / (p - q) : 1;
  give_part(load, 0, cut, out);
  if (cut < 1) give_part(load, cut, 1, out);
}

/// The piece of a part for a bearing that was attached to a piece of the body.
int piece_of(const Model<2>& model, int part) {
  return model.bodies[static_cast<std::size_t>(part)].first_piece;
}

}  // namespace

/// The parts have no axes of their own: they rotate with the body from its initial position.
void place_parts(const Model<2>& model, State<2>& state, const SplitBody& split) {
  const std::size_t n = node_of(model, split.body);
  const Turn turn(state.rotation[n]);
  for (const int part : {split.behind, split.ahead}) {
    const std::size_t p = node_of(model, part);
    const Vec2 arm = turn.apply(arm_of(model, split, part));
    state.position[p] = state.position[n] + arm;
    state.rotation[p] = state.rotation[n];
    state.velocity[p] = state.velocity[n] + cross(state.spin[n], arm);
    state.spin[p] = state.spin[n];
    state.resting[static_cast<std::size_t>(part)] = state.resting[static_cast<std::size_t>(split.body)];
    state.moved_at[static_cast<std::size_t>(part)] = state.moved_at[static_cast<std::size_t>(split.body)];
  }
  state.velocity[n] = Vec2::Zero(), state.spin[n] = 0;
  state.removed_at.resize(state.left.size(), never_removed);
  state.left[static_cast<std::size_t>(split.body)] = 1;
  state.removed_at[static_cast<std::size_t>(split.body)] = state.time;
}

void hand_over_links(Model<2>& model, const SplitBody& split, const CrackSection<2>& section) {
  const Givers givers(model, split, section);
  for (Bearing<2>& b : model.bearings) {
    if (givers.is_on(b.end_a)) givers.give(b.end_a, b.body_a), b.piece_a = piece_of(model, b.body_a);
    if (givers.is_on(b.end_b)) givers.give(b.end_b, b.body_b), b.piece_b = piece_of(model, b.body_b);
  }
  for (Seat<2>& s : model.seats) givers.give(s.end, s.body), givers.give(s.edge, s.support);
  for (PointLoad<2>& p : model.loads.of<PointLoad<2>>()) givers.give(p.at, p.body);
  for (Push<2>& push : model.pushes)
    for (PushRow<2>& row : push.rows) givers.give(row);
  std::vector<FaceLoad<2>> loads;
  for (const FaceLoad<2>& load : model.loads.of<FaceLoad<2>>()) givers.give(load, loads);
  model.loads.of<FaceLoad<2>>() = std::move(loads);
  const std::size_t n = node_of(model, split.body);
  for (const int part : {split.behind, split.ahead})
    model.load[node_of(model, part)] = model.mass[node_of(model, part)] / model.mass[n] * model.load[n];
}

}  // namespace trilith
