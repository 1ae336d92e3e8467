#include "broad_phase/solid_pairs.hpp"

#include <algorithm>

#include "broad_phase/bearing_rules.hpp"
#include "broad_phase/incremental_pairs.hpp"
#include "model/contact/contact_frame.hpp"

namespace trilith {

FatBox<3> box_around(const PlacedSolid& solid) {
  FatBox<3> box;
  box.low.fill(unbounded), box.high.fill(-unbounded);
  for (const Vec3& x : solid.corners)
    for (std::size_t k = 0; k < 3; ++k) {
      const double at = x[static_cast<Eigen::Index>(k)];
      box.low[k] = std::min(box.low[k], at), box.high[k] = std::max(box.high[k], at);
    }
  return solid.solid->is_sphere() ? widened(box, solid.solid->radius) : box;
}

FatBox<3> widened(FatBox<3> box, double by) {
  for (std::size_t k = 0; k < 3; ++k) box.low[k] -= by, box.high[k] += by;
  return box;
}

namespace {

/// Margin of a piece on every side, relative to the smallest side of its box in body axes.
constexpr double side_share = 0.05;
/// A box extends ahead by the piece's motion in this many steps, but by at most this many margins. For 5,000 flowing
/// grains, 24 steps make the search half as expensive again and contacts an eighth cheaper.
constexpr double reach_steps = 96, most_margins = 10;
/// Pieces that will leave their boxes within this many steps, or have less than this share of their margin left, are
/// updated early in the same pass. Rebuilding a long list costs as much for one piece as for many.
constexpr double due_steps = 24, share_due = 0.1;

/// Remaining distance by which a box may grow within another along each axis [m]; negative where it protrudes.
Vec3 room_left(const FatBox<3>& inner, const FatBox<3>& outer) {
  Vec3 left;
  for (int k = 0; k < 3; ++k) {
    const auto i = static_cast<std::size_t>(k);
    left[k] = std::min(inner.low[i] - outer.low[i], outer.high[i] - inner.high[i]);
  }
  return left;
}

FatBox<3> moved(FatBox<3> box, const Vec3& by) {
  for (std::size_t k = 0; k < 3; ++k) {
    const double d = by[static_cast<Eigen::Index>(k)];
    box.low[k] += d, box.high[k] += d;
  }
  return box;
}

/// Free along some axis, or driven: a moving base can reach pieces above it.
bool can_move(const Model<3>& model, int piece) {
  const auto goes = [&](int node) {
    const auto& support = model.support[node];
    return std::any_of(support.begin(), support.end(), [](Support s) { return s != Support::fixed; });
  };
  if (!model.is_fitted(piece)) return goes(model.node_of_piece(piece));
  const Fit& whole = model.fits[static_cast<std::size_t>(model.piece_fit[static_cast<std::size_t>(piece)])];
  return std::any_of(whole.node.begin(), whole.node.begin() + whole.nodes, goes);
}

/// Margin of each piece at rest, and whether its body moves or is driven.
void find_solid_margins(const Model<3>& model, BroadPhaseState<3>& search) {
  const auto pieces = static_cast<std::size_t>(model.pieces());
  search.margin.assign(pieces, 0), search.may_move.assign(pieces, 0), search.is_due.assign(pieces, 0);
  for (std::size_t p = 0; p < pieces; ++p) {
    Vec3 low = Vec3::Constant(unbounded), high = -low;
    for (const Vec3& x : model.piece_solid[p].shape.corners) low = low.cwiseMin(x), high = high.cwiseMax(x);
    search.margin[p] = side_share * ((high - low).minCoeff() + 2 * model.piece_solid[p].radius);
    search.may_move[p] = can_move(model, static_cast<int>(p)) ? 1 : 0;
  }
}

void look_up_all_solids(const Model<3>& model, Work<3>& work) {
  BroadPhaseState<3>& search = work.search;
  find_solid_margins(model, search);
  WayLeft<3> all;
  set_all(all.left, unbounded);
  search.left.assign(search.margin.size(), all);
  search.may_have_left = false;
  search.boxes.reset(model.pieces());
  search.due.clear();
  for (int p = 0; p < model.pieces(); ++p) search.due.push_back(p), search.is_due[static_cast<std::size_t>(p)] = 1;
  work.travel = work.clear_path = 0;
  work.pairs.clear(), work.asleep_until.clear(), work.solids.separation.clear();
  work.solids.faces.clear(), work.solids.way.assign(search.margin.size(), 0.0);
  list_bearings(model, search);
}

/// The contact law between two pieces, -1 where they are not a candidate pair.
int law_between(const Model<3>& model, const State<3>& state, const BroadPhaseState<3>& search, int p, int q) {
  const int a = model.piece_body[p], b = model.piece_body[q];
  if (a == b || state.left[a] != 0 || state.left[b] != 0) return -1;
  if (search.may_move[p] == 0 && search.may_move[q] == 0) return -1;
  if (!model.body_moves(a) && !model.body_moves(b)) return -1;
  return model.law_of[model.bodies[a].surface * model.surfaces + model.bodies[b].surface];
}

/// A piece with this budget [m] stays in its box until its corners have moved as far; reduced by the rounding of sums
/// over many steps.
void put_off(Work<3>& work, int piece, const Vec3& left) {
  work.search.left[piece].left = left * (1 - 1e-6);
}

/// Displacement of the centre of a piece's box in `ahead` [s] at its present velocity; zero for a deforming piece.
Vec3 way_ahead(const Model<3>& model, const State<3>& state, int piece, const FatBox<3>& box, double ahead) {
  if (model.is_fitted(piece)) return Vec3::Zero();
  const Vec3 middle = 0.5 * (Eigen::Map<const Vec3>(box.low.data()) + Eigen::Map<const Vec3>(box.high.data()));
  return ahead * motion_of(model, state, model.node_of_piece(piece)).velocity_at(middle);
}

/// The new box of a piece: enlarged by its margin, and along its path.
FatBox<3> box_ahead(const Model<3>& model, const State<3>& state, const Work<3>& work, int piece) {
  const double margin = work.search.margin[piece], farthest = most_margins * margin;
  FatBox<3> box = widened(box_around(work.solids.placed[piece]), margin);
  const Vec3 way = way_ahead(model, state, piece, box, reach_steps * state.last_dt);
  for (int k = 0; k < 3; ++k) {
    box.low[static_cast<std::size_t>(k)] -= std::min(farthest, std::max(0.0, -way[k]));
    box.high[static_cast<std::size_t>(k)] += std::min(farthest, std::max(0.0, way[k]));
  }
  return box;
}

/// Pairs that contain a due piece, sorted: pairs with overlapping boxes, and pairs with a memory.
void look_up(const Model<3>& model, const State<3>& state, Work<3>& work) {
  BroadPhaseState<3>& search = work.search;
  for (const int p : search.due) {
    search.boxes.put(p, box_ahead(model, state, work, p));
    if (search.may_move[p] != 0) put_off(work, p, Vec3::Constant(search.margin[p]));
  }
  search.found.clear();
  for (const int p : search.due) {
    if (!search.boxes.holds(p)) continue;  // a box out of range meets nothing
    search.boxes.for_meeting(search.boxes.box(p), [&](int q) {
      if (q == p || (search.is_due[q] != 0 && q < p)) return;
      if (law_between(model, state, search, p, q) >= 0)
        search.found.push_back(contact_key(std::min(p, q), std::max(p, q)));
    });
  }
  const SolidHistory& before = work.valid ? contacts_before(state, work) : state.contacts;
  list_due_rows(before.key, search);
  for (const int row : search.due_rows) {
    const ContactKey key = before.key[row];
    if (!before.memory[row].empty() && law_between(model, state, search, first_piece(key), second_piece(key)) >= 0)
      search.found.push_back(key);  // none if one piece is inactive, or both are held
  }
  std::sort(search.found.begin(), search.found.end());
  search.found.erase(std::unique(search.found.begin(), search.found.end()), search.found.end());
}

NearPair new_pair(const Model<3>& model, const State<3>& state, const BroadPhaseState<3>& search, int p, int q) {
  NearPair pair{p, q, law_between(model, state, search, p, q), 0, 0, 0, 0, 0, 1.0, false};
  apply_bearings<3>(model, search, state.bearing, pair);
  return pair;
}

/// Moves a row of the old list to the new one, or makes a new row.
struct SolidList {
  Work<3>& work;

  void keep(std::size_t row) {
    work.spare_pairs.push_back(work.pairs[row]);
    work.spare_asleep.push_back(work.asleep_until[row]);
    work.solids.spare.push_back(work.solids.separation[row]);
    work.solids.spare_faces.push_back(work.solids.faces[row]);
  }
  void add(const NearPair& pair) {
    work.spare_pairs.push_back(pair);
    work.spare_asleep.push_back(-1);
    work.solids.spare.push_back({0, Vec3::UnitX(), SeparatingFeature::face_of_a, 0, 0});  // no separating axis yet
    work.solids.spare_faces.push_back({});
  }
  void begin() {
    work.spare_pairs.clear(), work.spare_asleep.clear();
    work.solids.spare.clear(), work.solids.spare_faces.clear();
  }
  void end() {
    work.pairs.swap(work.spare_pairs), work.asleep_until.swap(work.spare_asleep);
    work.solids.separation.swap(work.solids.spare), work.solids.faces.swap(work.solids.spare_faces);
  }
};

/// Inserts the pairs found, and removes the pairs of updated pieces that were not found.
void patch_pairs(const Model<3>& model, const State<3>& state, Work<3>& work) {
  const BroadPhaseState<3>& search = work.search;
  SolidList list{work};
  list.begin();
  std::size_t row = 0;
  const auto keep_before = [&](ContactKey end) {
    for (; row < work.pairs.size() && key_of(work.pairs[row]) < end; ++row)
      if (!is_due(search, work.pairs[row])) list.keep(row);
  };
  for (const ContactKey key : search.found) {
    keep_before(key);
    if (row < work.pairs.size() && key_of(work.pairs[row]) == key)
      list.keep(row++);
    else
      list.add(new_pair(model, state, search, first_piece(key), second_piece(key)));
  }
  keep_before(~ContactKey{0});
  list.end();
}

/// Lists all pieces that have left their boxes or will shortly.
void list_due(const Model<3>& model, const State<3>& state, Work<3>& work) {
  BroadPhaseState<3>& search = work.search;
  search.due.clear();
  for (int p = 0; p < model.pieces(); ++p) {
    const Vec3 least = Vec3::Constant(share_due * search.margin[p]);
    if (search.may_move[p] == 0 || search.left[p].lasts(due_steps, least)) continue;
    const FatBox<3> now = box_around(work.solids.placed[p]);
    const Vec3 left = room_left(now, search.boxes.box(p));
    const Vec3 way = way_ahead(model, state, p, now, due_steps * state.last_dt);
    if (!none_below(left, least) || !none_below(room_left(moved(now, way), search.boxes.box(p)), Vec3::Zero()))
      search.due.push_back(p), search.is_due[p] = 1;
    else
      put_off(work, p, left);
  }
}

}  // namespace

/// A piece is checked once its corners have moved by the budget that remained at the last check.
bool solids_are_due(const Model<3>& model, const State<3>& state, Work<3>& work) {
  if (!work.valid) {
    look_up_all_solids(model, work);
    return true;
  }
  BroadPhaseState<3>& search = work.search;
  if (!search.may_have_left) return false;
  search.may_have_left = false;
  for (int p = 0; p < model.pieces(); ++p) {
    if (search.left[p].lasts(0, search.shifted)) continue;
    const Vec3 left = room_left(box_around(work.solids.placed[p]), search.boxes.box(p));
    if (!none_below(left, Vec3::Zero())) {
      list_due(model, state, work);
      return true;
    }
    put_off(work, p, left);
  }
  return false;
}

/// Both lists are sorted by key, so one pass over both suffices. The state's memories are ordered like the rows.
bool find_solid_pairs(const Model<3>& model, const State<3>& state, Work<3>& work) {
  look_up(model, state, work);
  const bool changes = !work.valid || !are_same(work);
  if (changes) patch_pairs(model, state, work);
  for (const int p : work.search.due) work.search.is_due[p] = 0;
  work.valid = true;
  return changes;
}

}  // namespace trilith
