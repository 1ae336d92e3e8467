// The tangent of face contacts, from copies of their rows with one unknown moved, many at a time through the kernels of
// the laws.
#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

#include "assembly/contact/contact_rows.hpp"
#include "assembly/contact/face_pair_culling.hpp"
#include "assembly/contact/face_rows.hpp"
#include "assembly/tangent/fd_perturbation.hpp"
#include "assembly/tangent/fd_tangent.hpp"

namespace trilith {
namespace {

constexpr std::size_t ends = 4;  // of the two faces of a row

/// Copies of rows of one law, each with its own skin points, and their responses.
class FaceCopies {
 public:
  FaceCopies(const Model<2>& model, Work<2>& work, const ContactHistory& before, bool means)
      : model_(model), work_(work), history_(before), means_(means) {}

  void clear() {
    skin_.clear(), mean_.clear(), arm_.clear(), pairs_.clear(), before_.clear(), law_row_.clear(), law_before_.clear();
    line_.clear();
  }
  [[nodiscard]] std::size_t size() const { return pairs_.size(); }

  /// A copy of `row` with one unknown moved by `by` and its rate changed by `rate` times that.
  struct Move {
    Freedom unknown;
    double by, rate;
  };
  void add(const State<2>& state, int row, const Move* move);
  /// Moves the second face of the copies from `first` on towards the first one by `depth` [m].
  void press(std::size_t first, double depth);
  /// Evaluates the law for all copies.
  void respond(const LawInUse& law);
  /// False if the copy is not a pair of faces.
  [[nodiscard]] bool is_faces(std::size_t copy) const {
    return !answer_[copy / lane_count].is_general[copy % lane_count];
  }
  [[nodiscard]] bool touches(std::size_t c) const { return answer_[c / lane_count].later[c % lane_count] != 0; }
  /// Its forces at the nodes: the force directly, its moment by the arm.
  void take(std::size_t copy, const TermNodes& nodes, TermForces& out) const;

 private:
  const Model<2>& model_;
  Work<2>& work_;
  const ContactHistory& history_;
  const bool means_;
  std::vector<SkinMotion<2>> skin_;  // [ends of a copy]
  std::vector<Vec2> mean_, arm_;     // likewise; mean_ is empty if the velocities over the step equal the present ones
  std::vector<NearPair> pairs_;      // [copy]
  std::vector<std::array<int, ends>> source_;
  std::vector<ContactMemory> before_, after_;
  std::vector<LawRow> law_row_;
  std::vector<double> law_before_, law_after_;
  std::vector<std::uint8_t> line_;  // [copy] 1: its row is flat with its neighbours in line in the present position
  std::vector<int> list_;
  std::vector<FourFaces> answer_;
  std::vector<FourForces> force_;
};

/// Displacement of a skin point when an unknown is moved: along an axis, or around the node by the rotation of its arm.
/// Both terms of the rotation are written out, because the difference of two rotations loses all digits.
void FaceCopies::add(const State<2>& state, int row, const Move* move) {
  const NearPair& p = work_.pairs[row];
  const double per_step = state.last_dt > 0 ? 1 / state.last_dt : 0;
  const std::array<int, ends> from = {p.a0, p.a1, p.b0, p.b1};
  const auto first = static_cast<int>(skin_.size());
  const Vec2 origin(work_.skin[p.a0].x, work_.skin[p.a0].y);
  for (const int s : from) {
    SkinMotion<2> now = work_.skin[s];
    const int n = model_.skin_node[s], t = model_.skin_turn[s];
    Vec2 arm = Vec2(now.x, now.y) - state.position[n], mean = means_ ? work_.skin_mean[s] : Vec2::Zero();
    now.x -= origin.x(), now.y -= origin.y();
    if (move != nullptr && move->unknown.node == (move->unknown.k == 2 ? t : n)) {
      const double by = move->by;
      Vec2 way = Vec2::Zero(), faster = Vec2::Zero();
      if (move->unknown.k < 2) {
        way[move->unknown.k] = by, faster[move->unknown.k] = move->rate * by;
      } else {
        way = by * left_of(arm) - 0.5 * by * by * arm;
        arm += way;
        faster = state.spin[t] * left_of(way) + move->rate * by * left_of(arm);
      }
      now.x += way.x(), now.y += way.y(), now.u += faster.x(), now.v += faster.y();
      mean += per_step * way;
    }
    skin_.push_back(now), arm_.push_back(arm);
    if (means_) mean_.push_back(mean);
  }
  source_.resize(pairs_.size());
  source_.push_back(from);
  NearPair& copy = pairs_.emplace_back(p);
  copy.a0 = first, copy.a1 = first + 1, copy.b0 = first + 2, copy.b1 = first + 3;
  before_.push_back(history_.memory[row]);
  const FaceLine line = face_line(model_);
  line_.push_back(line.is_there() && is_flat_in_line(line, work_.skin.data(), p) ? 1 : 0);
  const LawRow of = history_.law_row[row];
  law_row_.push_back({of.place, static_cast<std::uint32_t>(law_before_.size())});
  const double* const numbers = history_.law_numbers(row);
  law_before_.insert(law_before_.end(), numbers, numbers + law_number_counts[of.place]);
}

/// Along the normal of the first face, as in the first of these copies.
void FaceCopies::press(std::size_t first, double depth) {
  const SkinMotion<2>&a0 = skin_[ends * first], &a1 = skin_[ends * first + 1];
  const Vec2 inwards = depth * left_of(Vec2(a1.x - a0.x, a1.y - a0.y).normalized());
  for (std::size_t copy = first; copy < size(); ++copy)
    for (const std::size_t e : {2, 3}) {
      SkinMotion<2>& b = skin_[ends * copy + e];
      b.x += inwards.x(), b.y += inwards.y();
    }
}

void FaceCopies::respond(const LawInUse& law) {
  const std::size_t count = size(), fours = (count + lane_count - 1) / lane_count;
  list_.resize(fours * lane_count);
  std::iota(list_.begin(), list_.begin() + static_cast<std::ptrdiff_t>(count), 0);
  std::fill(list_.begin() + static_cast<std::ptrdiff_t>(count), list_.end(), static_cast<int>(count) - 1);
  after_.resize(count), law_after_.resize(law_before_.size());
  answer_.resize(fours), force_.resize(answer_.size());
  const FacePass pass{skin_.data(),
                      means_ ? mean_.data() : nullptr,
                      pairs_.data(),
                      before_.data(),
                      after_.data(),
                      law_row_.data(),
                      law_before_.data(),
                      law_after_.data(),
                      nullptr,
                      work_,
                      {},
                      line_.data(),
                      {answer_.data(), force_.data()}};
  respond_face_rows(pass, law, std::span(list_).first(count));
}

void FaceCopies::take(std::size_t copy, const TermNodes& nodes, TermForces& out) const {
  out.assign(3 * nodes.size(), 0.0);
  if (!touches(copy)) return;
  const FourForces& four = force_[copy / lane_count];
  for (std::size_t e = 0; e < ends; ++e) {
    const int s = source_[copy][e];
    const Vec2& f = four[copy % lane_count][e];
    double* const on = &out[3 * nodes.place_of(model_.skin_node[s])];
    on[0] += f.x(), on[1] += f.y();
    out[3 * nodes.place_of(model_.skin_turn[s]) + 2] += cross(arm_[ends * copy + e], f);
  }
}

/// Rows whose copies are evaluated together; their data fit in the second-level cache.
constexpr std::size_t rows_at_once = 16;
/// Perturbation as a share of the perturbation of other terms. Relative positions have more digits than positions, and
/// barely touching contacts are disturbed less.
constexpr double share_of_disturbance = 1.0 / 8;
/// Faces that just meet are differentiated as if they were pressed in by this number of perturbations.
constexpr double pressed_in = 32;

/// Rows of one law, each with its copies.
class FaceTerms {
 public:
  FaceTerms(TermSum<2>& sum, Work<2>& work, const ContactHistory& before, const LawInUse& law)
      : sum_(sum), work_(work), law_(law), copies_(sum.model, work, before, !work.skin_mean.empty()) {}

  void add(int row) {
    rows_.push_back(row);
    if (rows_.size() == rows_at_once) flush();
  }
  /// Evaluates all added rows, and then the rows that have just met.
  void flush() {
    respond(rows_, false);
    respond(met_, true);
    rows_.clear(), met_.clear();
  }

 private:
  void respond(const std::vector<int>& rows, bool pressed) {
    if (rows.empty()) return;
    copies_.clear();
    for (const int row : rows) copy_row(row, pressed);
    copies_.respond(law_);
    std::size_t copy = 0;
    for (const int row : rows) copy = take_row(row, copy, pressed);
  }
  void list_nodes(int row) {
    const NearPair& p = work_.pairs[row];
    nodes_.clear();
    for (const int s : {p.a0, p.a1, p.b0, p.b1}) nodes_.add_skin(sum_.model, s);
    const double depth = depth_of(p);
    most_ = depth > 0 ? std::max(share_of_depth * depth, least_move) / share_of_disturbance : unbounded;
  }
  /// Greatest depth of the second face below the first one over their shared extent; negative if apart [m].
  [[nodiscard]] double depth_of(const NearPair& p) const {
    const auto at = [&](int s) { return Vec2(work_.skin[s].x, work_.skin[s].y); };
    const Vec2 from = at(p.a0), along = Vec2(at(p.a1) - from).normalized();
    const Vec2 b0 = at(p.b0) - from, b1 = at(p.b1) - from;
    const double length = along.dot(Vec2(at(p.a1) - from)), s0 = along.dot(b0), s1 = along.dot(b1);
    const double d0 = left_of(along).dot(b0), d1 = left_of(along).dot(b1);
    const double low = std::max(0.0, std::min(s0, s1)), high = std::min(length, std::max(s0, s1));
    if (!(low < high) || s0 == s1) return -1;
    const auto depth = [&](double s) { return d0 + (s - s0) / (s1 - s0) * (d1 - d0); };
    return std::max(depth(low), depth(high));
  }
  /// f(moved, column) for the unknowns of a row.
  template <class F>
  void each_unknown(F&& f) {
    for (const int n : nodes_.list())
      for (const int k : {0, 1, 2})
        if (sum_.unknown[n][k] >= 0) f(Freedom{n, k}, sum_.unknown[n][k]);
  }
  [[nodiscard]] double step_of(const Freedom& f) const {
    return share_of_disturbance * perturbation_of(sum_.model, f, sum_.options, most_);
  }
  /// One unmoved copy, then two for each unknown.
  void copy_row(int row, bool pressed) {
    const std::size_t first = copies_.size();
    list_nodes(row);
    copies_.add(sum_.state, row, nullptr);
    double most = 0;
    each_unknown([&](const Freedom& f, int /*column*/) {
      const double by = step_of(f);
      if (f.k < 2) most = std::max(most, by);
      for (const double side : {1.0, -1.0}) {
        const FaceCopies::Move move{f, side * by, sum_.options.rate};
        copies_.add(sum_.state, row, &move);
      }
    });
    if (pressed) copies_.press(first, pressed_in * most);
  }
  /// If one side of a difference is not a pair of faces, a one-sided difference with the unmoved row is used. A row
  /// whose copies touch only in part has just met: it counts as closed or open.
  std::size_t take_row(int row, std::size_t copy, bool pressed) {
    list_nodes(row);
    const std::size_t stands = copy++;
    std::size_t end = copy;
    const bool now = copies_.touches(stands);
    bool some = now, all = now;
    each_unknown([&](const Freedom& /*f*/, int /*column*/) {
      for (const std::size_t c : {end, end + 1}) some = some || copies_.touches(c), all = all && copies_.touches(c);
      end += 2;
    });
    if (!some) return end;
    if (!all && !pressed) {
      if (now || sum_.options.closes) met_.push_back(row);
      return end;
    }
    each_unknown([&](const Freedom& f, int column) {
      const bool up = copies_.is_faces(copy), down = copies_.is_faces(copy + 1);
      copies_.take(up ? copy : stands, nodes_, more_);
      copies_.take(down ? copy + 1 : stands, nodes_, less_);
      copy += 2;
      sum_.add_column(nodes_, column, more_, less_, (up && down ? 2 : 1) * step_of(f));
    });
    return end;
  }

  TermSum<2>& sum_;
  Work<2>& work_;
  const LawInUse law_;
  FaceCopies copies_;
  std::vector<int> rows_, met_;
  TermNodes nodes_;
  TermForces more_, less_;
  double most_ = unbounded;  // see step_of, for the row whose nodes are listed
};

/// Adds the rows that the evaluation processes: touching rows, and rows that may touch. Faces that just meet, as of
/// stacked blocks, may count as closed and sticking. With the mean of both sides, half of their stiffness and no
/// friction, statics would move the supported bodies far away.
void add_faces(TermSum<2>& sum, Work<2>& work, const ContactHistory& before) {
  for (const FaceBatch& batch : work.batches) {
    FaceTerms terms(sum, work, before, law_in_use(sum.model, batch.law, sum.options.dt));
    const std::vector<int>& facing = batch.choice.empty() ? batch.row : batch.now;
    const std::size_t count =
        sort_out(face_line(sum.model), before, work, facing, work.face_rows, work.fresh_rows).count;
    for (std::size_t i = 0; i < count; ++i)
      if (const int row = work.face_rows[i]; !is_general(work, row)) terms.add(row);
    terms.flush();
  }
}

}  // namespace

void add_face_terms(TermSum<2>& sum, Work<2>& work) {
  add_faces(sum, work, contacts_before(sum.state, work));
}

}  // namespace trilith
