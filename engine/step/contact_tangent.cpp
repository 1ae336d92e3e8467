// The tangent of contacts, one by one: faces by copies of their rows in which one unknown is moved, many at once
// through the kernels of the laws; what is of general shape piece by piece.
#include <array>
#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

#include "contact/overlap_pair.hpp"
#include "step/contact_rows.hpp"
#include "step/face_rows.hpp"
#include "step/term_tangent.hpp"

namespace trilith {
namespace {

constexpr std::size_t ends = 4;  // of the two faces of a row

/// Copies of rows of one law, each with skin points of its own, and what they answer.
class FaceCopies {
 public:
  FaceCopies(const Model<2>& model, Work<2>& work, const ContactHistory& before, bool means)
      : model_(model), work_(work), history_(before), means_(means) {}

  void clear() {
    skin_.clear(), mean_.clear(), arm_.clear(), pairs_.clear(), before_.clear(), law_row_.clear(), law_before_.clear();
  }
  [[nodiscard]] std::size_t size() const { return pairs_.size(); }

  /// A copy of `row` as it stands, but for the skin points that go with the unknown that has been moved in `state`.
  void add(const State<2>& state, int row, const Freedom* moved);
  /// Asks the law of all copies.
  void respond(const LawInUse& law);
  /// False where the copy is no pair of faces.
  [[nodiscard]] bool is_faces(std::size_t copy) const {
    return !answer_[copy / lane_count].is_general[copy % lane_count];
  }
  /// Its forces at the nodes: the force as it is, its moment by the arm.
  void take(std::size_t copy, const TermNodes& nodes, TermForces& out) const;

 private:
  [[nodiscard]] std::array<int, ends> skins_of(const NearPair& p) const { return {p.a0, p.a1, p.b0, p.b1}; }

  const Model<2>& model_;
  Work<2>& work_;
  const ContactHistory& history_;
  const bool means_;
  std::vector<SkinMotion<2>> skin_;  // [ends of a copy]
  std::vector<Vec2> mean_, arm_;     // likewise; mean_ empty where velocities over the step are those of now
  std::vector<NearPair> pairs_;      // [copy]
  std::vector<std::array<int, ends>> source_;
  std::vector<ContactMemory> before_, after_;
  std::vector<LawRow> law_row_;
  std::vector<double> law_before_, law_after_;
  std::vector<int> list_;
  std::vector<FourFaces> answer_;
};

void FaceCopies::add(const State<2>& state, int row, const Freedom* moved) {
  const NearPair& p = work_.pairs[row];
  const double per_step = state.last_dt > 0 ? 1 / state.last_dt : 0;
  const std::array<int, ends> from = skins_of(p);
  const auto first = static_cast<int>(skin_.size());
  for (const int s : from) {
    const SkinMotion<2>& now = work_.skin[s];
    const int n = model_.skin_node[s];
    const bool goes = moved != nullptr && moved->node == (moved->k == 2 ? model_.skin_turn[s] : n);
    if (goes) {
      const PlacedSkin placed = placed_skin(model_, state, s);
      skin_.push_back(placed.motion), arm_.push_back(placed.arm);
    } else {
      skin_.push_back(now), arm_.push_back(Vec2(now.x, now.y) - state.position[n]);
    }
    if (means_) mean_.push_back(work_.skin_mean[s] + per_step * Vec2(skin_.back().x - now.x, skin_.back().y - now.y));
  }
  source_.resize(pairs_.size());
  source_.push_back(from);
  NearPair& copy = pairs_.emplace_back(p);
  copy.a0 = first, copy.a1 = first + 1, copy.b0 = first + 2, copy.b1 = first + 3;
  before_.push_back(history_.memory[row]);
  const LawRow of = history_.law_row[row];
  law_row_.push_back({of.place, static_cast<std::uint32_t>(law_before_.size())});
  const double* const numbers = history_.law_numbers(row);
  law_before_.insert(law_before_.end(), numbers, numbers + law_number_counts[of.place]);
}

void FaceCopies::respond(const LawInUse& law) {
  const std::size_t count = size(), fours = (count + lane_count - 1) / lane_count;
  list_.resize(fours * lane_count);
  std::iota(list_.begin(), list_.begin() + static_cast<std::ptrdiff_t>(count), 0);
  std::fill(list_.begin() + static_cast<std::ptrdiff_t>(count), list_.end(), static_cast<int>(count) - 1);
  after_.resize(count), law_after_.resize(law_before_.size());
  answer_.resize(fours);
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
                      answer_.data()};
  respond_face_rows(pass, law, std::span(list_).first(count));
}

void FaceCopies::take(std::size_t copy, const TermNodes& nodes, TermForces& out) const {
  out.assign(3 * nodes.size(), 0.0);
  const FourFaces& four = answer_[copy / lane_count];
  if (!four.touches[copy % lane_count]) return;
  for (std::size_t e = 0; e < ends; ++e) {
    const int s = source_[copy][e];
    const Vec2& f = four.force[copy % lane_count][e];
    double* const on = &out[3 * nodes.place_of(model_.skin_node[s])];
    on[0] += f.x(), on[1] += f.y();
    out[3 * nodes.place_of(model_.skin_turn[s]) + 2] += cross(arm_[ends * copy + e], f);
  }
}

/// Rows whose copies are asked at a time: what they take stays in the processor's second cache.
constexpr std::size_t rows_at_once = 16;

/// Rows of one law, each with the copies that belong to it.
class FaceTerms {
 public:
  FaceTerms(TermSum& sum, Work<2>& work, const ContactHistory& before, const LawInUse& law)
      : sum_(sum), work_(work), law_(law), copies_(sum.model, work, before, !work.skin_mean.empty()) {}

  void add(int row) {
    rows_.push_back(row);
    if (rows_.size() == rows_at_once) flush();
  }
  void flush() {
    if (rows_.empty()) return;
    copies_.clear();
    for (const int row : rows_) copy_row(row);
    copies_.respond(law_);
    std::size_t copy = 0;
    for (const int row : rows_) copy = take_row(row, copy);
    rows_.clear();
  }

 private:
  void list_nodes(int row) {
    const NearPair& p = work_.pairs[row];
    nodes_.clear();
    for (const int s : {p.a0, p.a1, p.b0, p.b1}) nodes_.add_skin(sum_.model, s);
  }
  /// f(moved, column) for the unknowns of a row.
  template <class F>
  void each_unknown(F&& f) {
    for (const int n : nodes_.list())
      for (const int k : {0, 1, 2})
        if (sum_.unknown[n][k] >= 0) f(Freedom{n, k}, sum_.unknown[n][k]);
  }
  /// One as it stands, then two for each unknown.
  void copy_row(int row) {
    list_nodes(row);
    copies_.add(sum_.state, row, nullptr);
    each_unknown([&](const Freedom& f, int /*column*/) {
      const double by = disturbance_of(sum_.model, f, sum_.options);
      for (const double side : {1.0, -1.0}) {
        const Moved moved(sum_.state, f, side * by, sum_.options.rate);
        copies_.add(sum_.state, row, &f);
      }
    });
  }
  /// Where one side of a difference is no pair of faces any more, it is that between the other and the row as it
  /// stands.
  std::size_t take_row(int row, std::size_t copy) {
    list_nodes(row);
    const std::size_t stands = copy++;
    each_unknown([&](const Freedom& f, int column) {
      const bool up = copies_.is_faces(copy), down = copies_.is_faces(copy + 1);
      copies_.take(up ? copy : stands, nodes_, more_);
      copies_.take(down ? copy + 1 : stands, nodes_, less_);
      copy += 2;
      const double by = disturbance_of(sum_.model, f, sum_.options);
      sum_.add_column(nodes_, column, more_, less_, up && down ? 2 * by : by);
    });
    return copy;
  }

  TermSum& sum_;
  Work<2>& work_;
  const LawInUse law_;
  FaceCopies copies_;
  std::vector<int> rows_;
  TermNodes nodes_;
  TermForces more_, less_;
};

bool touches_as_faces(const ContactMemory& m) {
  return (m.state & contact_touching) != 0 && (m.state & contact_general) == 0;
}

void add_faces(TermSum& sum, Work<2>& work, const ContactHistory& before) {
  for (const FaceBatch& batch : work.batches) {
    FaceTerms terms(sum, work, before, law_in_use(sum.model, batch.law, sum.options.dt));
    for (const int row : batch.choice.empty() ? batch.row : batch.now)
      if (touches_as_faces(work.contacts.memory[row])) terms.add(row);
    terms.flush();
  }
}

/// The skin points of two pieces; those that go with a node are placed anew, and all are put back.
class PairSkins {
 public:
  PairSkins(const Model<2>& model, Work<2>& work, const NearPair& pair) : model_(model), work_(work) {
    for (const int piece : {pair.piece_a, pair.piece_b})
      for (int c = model.piece_first[piece]; c < model.piece_first[piece + 1]; ++c)
        skin_.push_back(model.corner_skin[c]);
    for (const int s : skin_) {
      was_.push_back(work.skin[s]);
      if (!work.skin_mean.empty()) mean_was_.push_back(work.skin_mean[s]);
    }
  }
  PairSkins(const PairSkins&) = delete;
  PairSkins& operator=(const PairSkins&) = delete;
  ~PairSkins() { put_back(); }

  void put_back() {
    for (std::size_t i = 0; i < skin_.size(); ++i) {
      work_.skin[skin_[i]] = was_[i];
      if (!mean_was_.empty()) work_.skin_mean[skin_[i]] = mean_was_[i];
    }
  }
  void place(const State<2>& state, const Freedom& moved) {
    put_back();
    const double per_step = state.last_dt > 0 ? 1 / state.last_dt : 0;
    for (std::size_t i = 0; i < skin_.size(); ++i) {
      const int s = skin_[i];
      if (moved.node != (moved.k == 2 ? model_.skin_turn[s] : model_.skin_node[s])) continue;
      work_.skin[s] = placed_skin(model_, state, s).motion;
      if (mean_was_.empty()) continue;
      const Vec2 by(work_.skin[s].x - was_[i].x, work_.skin[s].y - was_[i].y);
      work_.skin_mean[s] = mean_was_[i] + per_step * by;
    }
  }
  void list_nodes(TermNodes& nodes) const {
    nodes.clear();
    for (const int s : skin_) nodes.add_skin(model_, s);
  }

 private:
  const Model<2>& model_;
  Work<2>& work_;
  std::vector<int> skin_;
  std::vector<SkinMotion<2>> was_;
  std::vector<Vec2> mean_was_;
};

/// Forces at the corners of a piece, at its nodes.
void take_corners(const TermSum& sum, const Work<2>& work, int piece, const Vec2* force, const TermNodes& nodes,
                  TermForces& out) {
  const Model<2>& model = sum.model;
  for (int c = model.piece_first[piece]; c < model.piece_first[piece + 1]; ++c, ++force) {
    if (force->isZero(0)) continue;
    const int s = model.corner_skin[c], n = model.skin_node[s];
    const Vec2 arm = Vec2(work.skin[s].x, work.skin[s].y) - sum.state.position[n];
    double* const on = &out[3 * nodes.place_of(n)];
    on[0] += force->x(), on[1] += force->y();
    out[3 * nodes.place_of(model.skin_turn[s]) + 2] += cross(arm, *force);
  }
}

/// The contact of two pieces by the overlap of their areas, as they are placed in `work`.
class GeneralTerm {
 public:
  GeneralTerm(const TermSum& sum, const Work<2>& work, const ContactHistory& before, int row)
      : sum_(sum),
        work_(work),
        pair_(work.pairs[row]),
        remembered_{before.memory[row], before.law_numbers(row)},
        law_(law_in_use(sum.model, pair_.law, sum.options.dt)),
        law_after_(law_number_counts[before.law_row[row].place] + 1) {}

  void respond(const TermNodes& nodes, TermForces& out) {
    PieceCorners corners_a, corners_b;
    const PlacedPiece a = placed_piece(sum_.model, sum_.state, work_, pair_.piece_a, corners_a),
                      b = placed_piece(sum_.model, sum_.state, work_, pair_.piece_b, corners_b);
    on_a_.fill(Vec2::Zero()), on_b_.fill(Vec2::Zero());
    const auto on = [](auto& force, const PlacedPiece& p) { return std::span(force).first(p.corner.size()); };
    respond_overlap(a, b, remembered_, law_, on(on_a_, a), on(on_b_, b), law_after_.data());
    take_corners(sum_, work_, pair_.piece_a, on_a_.data(), nodes, out);
    take_corners(sum_, work_, pair_.piece_b, on_b_.data(), nodes, out);
  }

 private:
  const TermSum& sum_;
  const Work<2>& work_;
  const NearPair& pair_;
  const Remembered remembered_;
  const LawInUse law_;
  std::vector<double> law_after_;  // of no use
  std::array<Vec2, max_piece_corners> on_a_, on_b_;
};

void add_general(TermSum& sum, Work<2>& work, const ContactHistory& before) {
  TermNodes nodes;
  for (const GeneralContact<2>& touching : work.general_touching) {
    PairSkins skins(sum.model, work, work.pairs[touching.row]);
    skins.list_nodes(nodes);
    GeneralTerm term(sum, work, before, touching.row);
    sum.add(nodes, [&](const Freedom& moved, TermForces& out) {
      skins.place(sum.state, moved);
      term.respond(nodes, out);
    });
  }
}

}  // namespace

void add_contact_terms(TermSum& sum, Work<2>& work) {
  const ContactHistory& before = contacts_before(sum.state, work);
  add_faces(sum, work, before);
  add_general(sum, work, before);
}

}  // namespace trilith
