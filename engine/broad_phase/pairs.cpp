#include "broad_phase/pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "base/portable.hpp"
#include "base/team.hpp"
#include "broad_phase/bearing_rules.hpp"
#include "broad_phase/broad_phase_update.hpp"
#include "broad_phase/face_line.hpp"
#include "broad_phase/incremental_pairs.hpp"
#include "law/contact/face_overlap.hpp"

namespace trilith {
namespace {

/// One edge of a piece: its two skin points in counter-clockwise order.
struct Edge {
  int s0, s1;
  double corner;
};

Edge edge_of(const Model<2>& model, int piece, int e) {
  const int first = model.piece_first[piece], count = model.corners_of(piece);
  return {model.corner_skin[first + e], model.corner_skin[first + (e + 1) % count], model.edge_corner[first + e]};
}

/// Ends of a face and their velocities, as Work is placed, counter-clockwise around its body.
FaceEnds<double> ends(const Work<2>& work, int s0, int s1) {
  const SkinMotion<2>&p = work.skin[s0], &q = work.skin[s1];
  return {p.x, p.y, q.x, q.y, p.u, p.v, q.u, q.v};
}

void set_faces(NearPair& pair, const Edge& a, const Edge& b) {
  pair.a0 = a.s0, pair.a1 = a.s1, pair.b0 = b.s0, pair.b1 = b.s1;
  pair.corner = std::max(a.corner, b.corner);
}

/// An edge with its vector [m].
struct EdgeWay {
  Edge edge;
  double x, y;
};
using EdgeWays = std::array<EdgeWay, max_piece_corners>;

/// The surface edges of a piece, as Work is placed; returns their number.
int list_ways(const Model<2>& model, const Work<2>& work, int piece, EdgeWays& ways) {
  const int first = model.piece_first[piece], edges = model.corners_of(piece);
  std::size_t count = 0;
  for (int e = 0; e < edges; ++e) {
    if (!model.edge_is_face[first + e]) continue;
    const int s0 = model.corner_skin[first + e], s1 = model.corner_skin[first + (e + 1 < edges ? e + 1 : 0)];
    const SkinMotion<2>&from = work.skin[s0], &to = work.skin[s1];
    ways[count++] = {{s0, s1, model.edge_corner[first + e]}, to.x - from.x, to.y - from.y};
  }
  return static_cast<int>(count);
}

/// Calls visit(edge a, edge b) for each pair of surface edges whose directions oppose within an angle, until visit
/// returns false. With counter-clockwise e_a and e_b along the faces the test is e_a . e_b < 0 and |e_a x e_b| <=
/// tan(angle) |e_a . e_b|, which needs neither a root nor an angle. `angle` is the tangent.
template <class Visit>
void for_facing_edges(const Model<2>& model, const Work<2>& work, int piece_a, int piece_b, double angle,
                      Visit&& visit) {
  EdgeWays of_a, of_b;
  const int na = list_ways(model, work, piece_a, of_a), nb = list_ways(model, work, piece_b, of_b);
  for (int i = 0; i < na; ++i)
    for (int j = 0; j < nb; ++j) {
      const EdgeWay &a = of_a[static_cast<std::size_t>(i)], &b = of_b[static_cast<std::size_t>(j)];
      const double cosine = a.x * b.x + a.y * b.y, sine = a.x * b.y - a.y * b.x;
      if (cosine < 0 && std::abs(sine) <= -cosine * angle && !visit(a.edge, b.edge)) return;
    }
}

/// Whether the faces may touch flatly before their next check, until which no two points approach by more than the
/// margin. `in_line`: length that collinear neighbours may add [m].
bool may_touch(const FaceOverlap<double>& o, double margin, double in_line) {
  const double depth = -std::min(o.gap_lo, o.gap_hi), shared = o.shared + margin + in_line;
  return shared > 0 && depth > -margin && depth <= face_pair_max_depth * shared + margin;
}

/// The faces of a deformable body rotate with their nodes. If both ends of a face move by d, it rotates by up to 2 d
/// divided by its length, so half of the shortest face is the arm.
double half_shortest_face(const Model<2>& model, const Work<2>& work, int piece) {
  double least = unbounded;
  for (int e = 0; e < model.corners_of(piece); ++e) {
    const Edge edge = edge_of(model, piece, e);
    const SkinMotion<2>&p = work.skin[edge.s0], &q = work.skin[edge.s1];
    if (model.edge_is_face[model.piece_first[piece] + e])
      least = std::min(least, portable::hypot(q.x - p.x, q.y - p.y));
  }
  return 0.5 * least;
}

/// Upper bound of an edge's rotation while its corners move by `reach` [rad]: asin(reach / arm), which is below pi/3
/// times its argument up to one half; beyond that `any_turn`.
double turn_within(const Model<2>& model, const Work<2>& work, int piece, double reach) {
  constexpr double any_turn = 1, pi_third = 1.0471975511965979;
  const double rigid = work.search.arm[piece], arm = rigid > 0 ? rigid : half_shortest_face(model, work, piece);
  return 2 * reach <= arm ? pi_third * reach / arm : any_turn;
}

/// Upper bound of the tangent of an angle from 0 to 1: (1 - x / tan x) / x^2 rises from 1/3 to 0.358 there.
double tangent_or_more(double angle) {
  return angle / (1 - 0.36 * angle * angle);
}

/// Counts, up to two, the face pairs that may touch flatly while the corners of the pieces move by these distances [m].
/// If the pieces may rotate by any angle, all opposed faces count. Stores the first pair.
int count_facing(const Model<2>& model, const Work<2>& work, double reach_a, double reach_b, NearPair& pair) {
  const double margin = reach_a + reach_b, angle = face_pair_max_tilt +
                                                   turn_within(model, work, pair.piece_a, reach_a) +
                                                   turn_within(model, work, pair.piece_b, reach_b);
  const bool any = angle >= 1;
  const FaceLine line = face_line(model);
  int count = 0;
  for_facing_edges(model, work, pair.piece_a, pair.piece_b, any ? unbounded : tangent_or_more(angle),
                   [&](const Edge& a, const Edge& b) {
                     if (!any && !may_touch({ends(work, a.s0, a.s1), ends(work, b.s0, b.s1)}, margin,
                                            length_in_line(line, work.skin.data(), a.s0, a.s1, b.s0, b.s1)))
                       return true;
                     if (count == 0) set_faces(pair, a, b);
                     count = any ? 2 : count + 1;
                     return count < 2;
                   });
  return count;
}

bool is_bonded(const ContactHistory& before, const NearPair& pair) {
  const ContactKey key = key_of(pair);
  const auto at = std::lower_bound(before.key.begin(), before.key.end(), key);
  return at != before.key.end() && *at == key &&
         before.memory[static_cast<std::size_t>(at - before.key.begin())].bonds != 0;
}

/// 0: general contact until one of the pieces is updated; 1: contact of these two faces; 2: chosen in each step. Faces
/// within the distance `beside` count as pairs that may touch, see choose_face_pair. Bonded faces remain a pair when
/// they tilt.
void find_facing(const Model<2>& model, const ContactHistory& before, const Work<2>& work, NearPair& pair) {
  const BroadPhaseState<2>& search = work.search;
  pair.facing = count_facing(model, work, reach_of(search, pair.piece_a) + search.beside,
                             reach_of(search, pair.piece_b) + search.beside, pair);
  if (pair.facing == 0 && is_bonded(before, pair)) pair.facing = 2;
}

/// Groups face pairs by law, for SIMD kernels; all other pairs are single. Rows keep their order.
void sort_into_batches(const Model<2>& model, Work<2>& work) {
  work.batches.resize(model.laws.size());
  work.general.clear();
  for (std::size_t l = 0; l < model.laws.size(); ++l) {
    work.batches[l].law = static_cast<int>(l);
    work.batches[l].row.clear(), work.batches[l].choice.clear();
  }
  for (int row = 0; row < static_cast<int>(work.pairs.size()); ++row) {
    const NearPair& pair = work.pairs[row];
    if (pair.facing == 0 || pair.replaced)
      work.general.push_back(row);
    else
      (pair.facing == 1 ? work.batches[pair.law].row : work.batches[pair.law].choice).push_back(row);
  }
}

}  // namespace

int contact_law(const Model<2>& model, int body_a, int body_b) {
  if (model.surfaces == 1) return model.law_of[0];  // called for many pairs whose bodies are scattered in memory
  return model.law_of[model.bodies[body_a].surface * model.surfaces + model.bodies[body_b].surface];
}

namespace {

/// The pieces belong to two bodies that are present, one of which may move, with a contact law between them.
bool may_ever_touch(const Model<2>& model, const State<2>& state, const BroadPhaseState<2>& search, int p, int q) {
  const int a = model.piece_body[p], b = model.piece_body[q];
  return a != b && (search.may_move[p] != 0 || search.may_move[q] != 0) && state.left[a] == 0 && state.left[b] == 0 &&
         contact_law(model, a, b) >= 0;
}

/// Pieces and rows in a chunk of one thread: about ten microseconds.
constexpr int due_stretch = 16, faced_stretch = 64;

/// Calls f(list) with a thread's list of pairs moved out of the shared array, whose headers share cache lines.
template <class F>
void add_found(BroadPhaseState<2>& search, int thread, F&& f) {
  std::vector<ContactKey> found = std::move(search.found_by[static_cast<std::size_t>(thread)]);
  f(found);
  search.found_by[static_cast<std::size_t>(thread)] = std::move(found);
}

/// Keys of the pairs found by the boxes of the due pieces, from `first` to before `last`.
void find_by_boxes(const Model<2>& model, const State<2>& state, const BroadPhaseState<2>& search, int first, int last,
                   std::vector<ContactKey>& found) {
  for (int i = first; i < last; ++i) {
    const int p = search.due[i];
    if (!search.boxes.holds(p)) continue;
    search.boxes.for_meeting(search.boxes.box(p), [&](int q) {
      if (q == p || (search.is_due[q] != 0 && q < p)) return;  // two due pieces are found from the lower one
      if (may_ever_touch(model, state, search, p, q)) found.push_back(contact_key(std::min(p, q), std::max(p, q)));
    });
  }
}

/// Keys of the pairs with a memory, at any distance, that contain a due piece.
void find_remembered(const Model<2>& model, const State<2>& state, Work<2>& work) {
  BroadPhaseState<2>& search = work.search;
  if (!work.valid) {
    const ContactHistory& before = state.contacts;
    for (std::size_t row = 0; row < before.size(); ++row)
      if (const ContactKey key = before.key[row];
          !before.memory[row].empty() && may_ever_touch(model, state, search, first_piece(key), second_piece(key)))
        search.found.push_back(key);
    return;
  }
  const ContactHistory& before = contacts_before(state, work);
  list_due_rows(before.key, search);
  for (const int row : search.due_rows)
    if (!before.memory[row].empty()) search.found.push_back(before.key[row]);
}

/// Keys of the pairs that contain due pieces: found by their boxes, or with a memory. Each thread fills its own list;
/// after sorting the result is independent of the threads.
void find_keys(const Model<2>& model, const State<2>& state, Work<2>& work) {
  BroadPhaseState<2>& search = work.search;
  search.found.clear();
  search.found_by.resize(static_cast<std::size_t>(std::clamp(work.threads, 1, most_threads)));
  for (std::vector<ContactKey>& of_thread : search.found_by) of_thread.clear();
  share(work.threads, static_cast<int>(search.due.size()), due_stretch, [&](int first, int last, int thread) {
    add_found(search, thread,
              [&](std::vector<ContactKey>& found) { find_by_boxes(model, state, search, first, last, found); });
  });
  find_remembered(model, state, work);
  for (const std::vector<ContactKey>& of_thread : search.found_by)
    search.found.insert(search.found.end(), of_thread.begin(), of_thread.end());
  std::sort(search.found.begin(), search.found.end());
  search.found.erase(std::unique(search.found.begin(), search.found.end()), search.found.end());
}

/// Updates the opposed faces of some rows. Each row reads its own pieces and writes only itself.
void face_rows(const Model<2>& model, const State<2>& state, Work<2>& work, const std::vector<int>& rows) {
  const ContactHistory& before = work.valid ? contacts_before(state, work) : state.contacts;
  share(work.threads, static_cast<int>(rows.size()), faced_stretch, [&](int first, int last, int /*thread*/) {
    for (int i = first; i < last; ++i) find_facing(model, before, work, work.pairs[rows[i]]);
  });
}

/// Updates the opposed faces of all rows that contain an updated piece.
void face_again(const Model<2>& model, const State<2>& state, Work<2>& work) {
  for (const int row : work.search.due_rows) work.clear_until[row] = 0;
  face_rows(model, state, work, work.search.due_rows);
}

/// Merges the pairs found into the list: rows without due pieces stay, rows with due pieces are replaced.
void merge_found(const Model<2>& model, const State<2>& state, Work<2>& work) {
  const std::vector<ContactKey>& found = work.search.found;
  std::vector<int>& to_face = work.search.to_face;
  work.spare_pairs.clear(), work.spare_asleep.clear(), work.spare_clear.clear(), to_face.clear();
  const auto add = [&](const NearPair& pair, double asleep, double clear) {
    work.spare_pairs.push_back(pair), work.spare_asleep.push_back(asleep), work.spare_clear.push_back(clear);
  };
  const auto add_new = [&](ContactKey key) {
    const int p = first_piece(key), q = second_piece(key);
    NearPair pair{p, q, contact_law(model, model.piece_body[p], model.piece_body[q]), 0, 0, 0, 0, 0, 1.0, false};
    apply_bearings<2>(model, work.search, state.bearing, pair);
    to_face.push_back(static_cast<int>(work.spare_pairs.size()));
    add(pair, -1.0, 0.0);
  };
  std::size_t next = 0;
  for (std::size_t row = 0; row < work.pairs.size(); ++row) {
    const NearPair& pair = work.pairs[row];
    const ContactKey key = key_of(pair);
    while (next < found.size() && found[next] < key) add_new(found[next++]);
    const bool due = is_due(work.search, pair);
    if (!due) {
      add(pair, work.asleep_until[row], work.clear_until[row]);
    } else if (next < found.size() && found[next] == key) {
      to_face.push_back(static_cast<int>(work.spare_pairs.size()));
      add(pair, work.asleep_until[row], 0.0);
      ++next;
    }
  }
  while (next < found.size()) add_new(found[next++]);
  work.pairs.swap(work.spare_pairs);
  work.asleep_until.swap(work.spare_asleep);
  work.clear_until.swap(work.spare_clear);
  face_rows(model, state, work, to_face);
}

/// Resets path lengths to begin at 0, so that they keep their digits; rounded to the safe side.
void begin_paths(Work<2>& work) {
  const auto less = [&](double& path) { path -= (1 + 1e-12) * work.travel; };
  for (double& path : work.asleep_until) less(path);
  for (double& path : work.clear_until) less(path);
  less(work.clear_path);
  work.travel = 0;
}

}  // namespace

bool pairs_outdated(const Model<2>& model, const State<2>& state, Work<2>& work) {
  if (!work.valid) update_broad_phase(model, state, work);
  return !work.valid || some_are_due(model, state, work);
}

bool find_pairs(const Model<2>& model, const State<2>& state, Work<2>& work) {
  BroadPhaseState<2>& search = work.search;
  if (!work.valid) {
    work.travel = 0;
    work.pairs.clear(), work.asleep_until.clear(), work.clear_until.clear();
    list_bearings(model, search);
  }
  if (work.travel > 1) begin_paths(work);
  place_boxes(model, state, work);
  find_keys(model, state, work);
  const bool same = work.valid && are_same(work);
  same ? face_again(model, state, work) : merge_found(model, state, work);
  sort_into_batches(model, work);
  for (const int p : search.due) search.is_due[p] = 0;
  search.due.clear();
  work.clear_path = 0;
  work.valid = true;
  return !same;
}

namespace {

/// Mean of the corners of a piece, as Work is placed [m].
Vec2 middle_of(const Model<2>& model, const Work<2>& work, int piece) {
  Vec2 sum = Vec2::Zero();
  const int first = model.piece_first[piece], count = model.corners_of(piece);
  for (int c = first; c < first + count; ++c) {
    const SkinMotion<2>& at = work.skin[model.corner_skin[c]];
    sum += Vec2(at.x, at.y);
  }
  return sum / count;
}

/// False for opposed faces on the far sides of two pieces: then each piece lies behind the face of the other. Such
/// faces share length where two pieces meet at a corner, and overlap by the whole of both.
bool face_each_other(const Model<2>& model, const Work<2>& work, const FaceOverlap<double>& o, const NearPair& pair) {
  if (-std::min(o.gap_lo, o.gap_hi) <= face_pair_max_depth * o.shared) return true;
  const SkinMotion<2>&on_a = work.skin[pair.a0], &on_b = work.skin[pair.b0];
  const Vec2 normal(o.dy, -o.dx);  // out of a
  return normal.dot(middle_of(model, work, pair.piece_b) - Vec2(on_a.x, on_a.y)) > 0 ||
         normal.dot(middle_of(model, work, pair.piece_a) - Vec2(on_b.x, on_b.y)) < 0;
}

/// As choose_face_pair, among faces that oppose each other within the angle of this tangent.
bool choose_within(const Model<2>& model, const Work<2>& work, bool bonded, double angle, NearPair& pair) {
  int found = 0, touching = 0;
  double nearest = unbounded;
  const FaceLine line = face_line(model);
  for_facing_edges(model, work, pair.piece_a, pair.piece_b, angle, [&](const Edge& a, const Edge& b) {
    const FaceOverlap<double> overlap(ends(work, a.s0, a.s1), ends(work, b.s0, b.s1));
    if (!overlap.sane || !(bonded || overlap.is_flat(std::max(a.corner, b.corner)))) {
      if (bonded || !line.is_there()) return true;
      NearPair faces{};
      set_faces(faces, a, b);
      if (!is_flat_in_line(line, work.skin.data(), faces)) return true;
    }
    const double gap = 0.5 * std::abs(overlap.gap_lo + overlap.gap_hi);
    const bool touches = overlap.shared > 0 && std::min(overlap.gap_lo, overlap.gap_hi) < 0;
    if (!bonded && touches && touching++ == 0) nearest = unbounded;  // prefer touching pairs
    if (gap >= nearest || (!bonded && !touches && touching > 0)) return true;
    NearPair nearer = pair;
    set_faces(nearer, a, b);
    if (bonded && !face_each_other(model, work, overlap, nearer)) return true;
    nearest = gap;
    ++found;
    pair = nearer;
    return true;
  });
  // Two flat pairs that touch at once, such as a wedge in a notch, are one general contact.
  if (bonded || found == 0 || touching > 0) return found > 0 && touching < 2;
  NearPair beside = pair;
  return count_facing(model, work, work.search.beside, work.search.beside, beside) < 2;
}

}  // namespace

/// Bonded faces are a pair at any gap, so the pair with the smallest mean gap is returned without a test of contact and
/// flatness, if its faces face each other. Otherwise the only pair that touches flatly is returned.
///
/// If no pair touches, the last contact ends as a face contact where exactly one flat pair is within
/// `BroadPhaseState::beside`, and as a general one where there are several. So the result does not depend on whether
/// one or several face pairs were near at the last check.
bool choose_face_pair(const Model<2>& model, const Work<2>& work, bool bonded, NearPair& pair) {
  static const double angle = portable::tan(face_pair_max_tilt);
  return choose_within(model, work, bonded, angle, pair);
}

bool choose_bonded_faces(const Model<2>& model, const Work<2>& work, NearPair& pair) {
  constexpr double most_tilt = 0.2;  // tangent; other edges of two pieces in one joint differ by more
  return choose_face_pair(model, work, true, pair) || choose_within(model, work, true, most_tilt, pair);
}

}  // namespace trilith
