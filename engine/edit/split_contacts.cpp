#include "edit/split_contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "assembly/bonded_length.hpp"
#include "assembly/contact/contact_rows.hpp"
#include "law/contact/list.hpp"
#include "model/contact/skin_places.hpp"

namespace trilith {
namespace {

/// A contact ends where it is shorter than this share of its length before.
constexpr double least_part = 1e-9;
/// Faces are on one line if their ends are nearer to it than this share of its length.
constexpr double same_line = 1e-6;

/// Memory of a law for the two faces in the other order. Laws name their numbers for both ends or halves alike.
template <class M>
M turned_memory(M m) {
  if constexpr (requires { m.set[1]; }) std::swap(m.set[0], m.set[1]);
  if constexpr (requires { m.damage[1]; }) std::reverse(std::begin(m.damage), std::end(m.damage));
  if constexpr (requires { m.crushed[1]; }) std::swap(m.crushed[0], m.crushed[1]);
  return m;
}

/// Values of equal cells for the cells of the part [from, to]: means over the old cells that they cover.
template <std::size_t N>
void take_means(double (&cells)[N], double from, double to) {
  constexpr double size = 1.0 / N;
  const double width = (to - from) * size;
  std::array<double, N> old{};
  std::copy(std::begin(cells), std::end(cells), old.begin());
  for (std::size_t i = 0; i < N; ++i) {
    const double low = from + static_cast<double>(i) * width, high = low + width;
    cells[i] = 0;
    for (std::size_t k = 0; k < N; ++k) {
      const double start = static_cast<double>(k) * size;
      cells[i] += std::max(0.0, std::min(high, start + size) - std::max(low, start)) / width * old[k];
    }
  }
}

/// Memory of a law for the part [from, to] of the shared length, in units of it. Mortar is linear over the length.
template <class M>
M part_of_memory(M m, double from, double to) {
  if constexpr (requires { m.set[1]; }) {
    const double first = m.set[0], rise = m.set[1] - m.set[0];
    m.set[0] = first + from * rise, m.set[1] = first + to * rise;
  }
  if constexpr (requires { m.damage[1]; }) take_means(m.damage, from, to);
  if constexpr (requires { m.crushed[1]; }) take_means(m.crushed, from, to);
  return m;
}

/// The record with the faces in the other order. The coordinate along the faces then runs backwards.
ContactRecord turned(const ContactRecord& record) {
  ContactRecord out = record;
  std::swap(out.piece_a, out.piece_b);
  std::swap(out.a0, out.b0), std::swap(out.a1, out.b1);
  ContactMemory& m = out.memory;
  if (record.general) {
    m.damping_force[0] = -m.damping_force[0], m.damping_force[1] = -m.damping_force[1];
    m.damping_moment = -m.damping_moment;
    return out;
  }
  for (auto* two : {&m.shear_elastic, &m.shear_total, &m.active}) std::swap((*two)[0], (*two)[1]);
  m.damping_force[1] = -m.damping_force[1];
  m.bonds = (m.bonds & 1U) << 1 | (m.bonds >> 1 & 1U);
  with_kernel_type(record.law, [&]<class K>() {
    keep_law_memory<K>(turned_memory(law_memory<K>(record.numbers.data())), out.numbers.data());
  });
  return out;
}

/// Length of [from, to] within [low, high].
double shared(double from, double to, double low, double high) {
  return std::max(0.0, std::min(to, high) - std::max(from, low));
}

/// Memory of the part [from, to] of a face contact, in units of its length. Shear is uniform over each half.
ContactMemory part_of(const ContactMemory& whole, double from, double to) {
  ContactMemory part = whole;
  part.bonds = 0;
  const double width = 0.5 * (to - from);
  for (const int h : {0, 1}) {
    part.shear_elastic[h] = part.shear_total[h] = part.active[h] = 0;
    const double low = from + h * width, high = low + width;
    for (const int k : {0, 1}) {
      const double share = 2 * shared(low, high, 0.5 * k, 0.5 * (k + 1));
      part.shear_elastic[h] += share * whole.shear_elastic[k];
      part.shear_total[h] += share * whole.shear_total[k];
      part.active[h] += share * whole.active[k];
    }
    if (whole.bonded(0.5 * (low + high) < 0.5 ? 0 : 1)) part.bonds |= 1U << h;
  }
  return part;
}

/// The damping force of a part: its stress is linear over the length. `length`: of the whole contact [m].
void share_damping(const ContactMemory& whole, double from, double to, double length, ContactMemory& part) {
  const double mean = whole.damping_force[0] / length;
  const double slope = 12 * whole.damping_force[1] / (length * length * length);
  const double size = (to - from) * length, middle = (0.5 * (from + to) - 0.5) * length;
  part.damping_force[0] = (mean + slope * middle) * size;
  part.damping_force[1] = slope * size * size * size / 12;
}

/// Positions of the skin points, without velocities.
class SkinPlaces {
 public:
  SkinPlaces(const Model<2>& model, const State<2>& state) : model_(model), state_(state) {}
  [[nodiscard]] Vec2 at(int skin) const { return skin_now(model_, state_, skin); }
  [[nodiscard]] FaceEnds<double> face(int from, int to) const {
    const Vec2 p = at(from), q = at(to);
    return {p.x(), p.y(), q.x(), q.y(), 0, 0, 0, 0};
  }

 private:
  const Model<2>& model_;
  const State<2>& state_;
};

/// A face of a piece, by its skin points.
struct PieceFace {
  int piece = -1, from = -1, to = -1;
};

double distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 d = b - a;
  const double share = std::clamp(d.dot(p - a) / d.squaredNorm(), 0.0, 1.0);
  return (p - a - share * d).norm();
}

/// The surface face of a body that is nearest to a point and runs along `along`.
PieceFace face_near(const Model<2>& model, const SkinPlaces& places, int body, const Vec2& at, const Vec2& along) {
  PieceFace best;
  double least = unbounded;
  const Body& b = model.bodies[static_cast<std::size_t>(body)];
  for (int piece = b.first_piece; piece < b.first_piece + b.pieces; ++piece)
    for (int k = 0; k < model.corners_of(piece); ++k) {
      const auto corner = static_cast<std::size_t>(model.piece_first[static_cast<std::size_t>(piece)] + k);
      if (model.edge_is_face[corner] == 0) continue;
      const int next = model.piece_first[static_cast<std::size_t>(piece)] + (k + 1) % model.corners_of(piece);
      const int from = model.corner_skin[corner], to = model.corner_skin[static_cast<std::size_t>(next)];
      const Vec2 a = places.at(from), c = places.at(to);
      if (along.dot((c - a).normalized()) < 0.5) continue;
      const double apart = distance_to_segment(at, a, c);
      if (apart < least) least = apart, best = {piece, from, to};
    }
  return best;
}

/// The piece of a body whose edges are nearest to a point, and their distance [m].
struct NearPiece {
  int piece = -1;
  double apart = unbounded;
};
NearPiece piece_near(const Model<2>& model, const SkinPlaces& places, int body, const Vec2& at) {
  NearPiece best;
  const Body& b = model.bodies[static_cast<std::size_t>(body)];
  for (int piece = b.first_piece; piece < b.first_piece + b.pieces; ++piece)
    for (int k = 0; k < model.corners_of(piece); ++k) {
      const int first = model.piece_first[static_cast<std::size_t>(piece)];
      const Vec2 p = places.at(model.corner_skin[static_cast<std::size_t>(first + k)]);
      const Vec2 q = places.at(model.corner_skin[static_cast<std::size_t>(first + (k + 1) % model.corners_of(piece))]);
      const double apart = distance_to_segment(at, p, q);
      if (apart < best.apart) best = {piece, apart};
    }
  return best;
}

}  // namespace

ContactRecord ordered(ContactRecord record) {
  return record.piece_a < record.piece_b ? record : turned(record);
}

namespace {

/// Divides the contacts of one body among its parts.
class Divider {
 public:
  Divider(const Model<2>& model, const State<2>& state, const SplitBody& split)
      : model_(model), places_(model, state), split_(split) {}

  void divide(const ContactRecord& record, std::vector<ContactRecord>& out) const {
    const bool first = body_of(record.piece_a) == split_.body;
    if (!first && body_of(record.piece_b) != split_.body)
      out.push_back(record);
    else if (record.general)
      give_general(record, first, out);
    else
      for (const int part : {split_.behind, split_.ahead}) give_faces(record, first, part, out);
  }

 private:
  [[nodiscard]] int body_of(int piece) const { return model_.piece_body[static_cast<std::size_t>(piece)]; }

  /// A general contact acts at one point: it goes to the part with the nearest edge there.
  void give_general(ContactRecord record, bool first, std::vector<ContactRecord>& out) const {
    if (!record.place) return;  // apart: a memory of the law alone, which new pieces do not have
    const NearPiece behind = piece_near(model_, places_, split_.behind, *record.place);
    const NearPiece ahead = piece_near(model_, places_, split_.ahead, *record.place);
    (first ? record.piece_a : record.piece_b) = behind.apart <= ahead.apart ? behind.piece : ahead.piece;
    out.push_back(ordered(std::move(record)));
  }

  /// True if a face of a part lies on a face of the body, and not only runs in its direction.
  [[nodiscard]] bool is_on(const PieceFace& face, int from, int to) const {
    const Vec2 start = places_.at(from), along = places_.at(to) - start;
    const double far = std::max(std::abs(cross(along, Vec2(places_.at(face.from) - start))),
                                std::abs(cross(along, Vec2(places_.at(face.to) - start))));
    return far < same_line * along.squaredNorm();
  }

  /// The part of a face contact on one part of the body, if there is any.
  void give_faces(const ContactRecord& record, bool first, int part, std::vector<ContactRecord>& out) const {
    const FaceEnds<double> a = places_.face(record.a0, record.a1), b = places_.face(record.b0, record.b1);
    const FaceOverlap<double> whole(a, b);
    if (!whole.sane) return;  // they have come apart
    const Vec2 along = first ? Vec2(whole.dx, whole.dy) : Vec2(-whole.dx, -whole.dy);
    const Vec2 start(a.x0, a.y0), middle = start + (whole.lo + 0.5 * whole.shared) * Vec2(whole.dx, whole.dy);
    const PieceFace face = face_near(model_, places_, part, middle, along);
    if (face.piece < 0 || !is_on(face, first ? record.a0 : record.b0, first ? record.a1 : record.b1)) return;
    ContactRecord given = record;
    (first ? given.piece_a : given.piece_b) = face.piece;
    (first ? given.a0 : given.b0) = face.from, (first ? given.a1 : given.b1) = face.to;
    // Coordinates along the whole faces; the part's own faces have nearly the same direction.
    const Vec2 d(whole.dx, whole.dy);
    const double p = d.dot(places_.at(face.from) - start), q = d.dot(places_.at(face.to) - start);
    const double from = (std::max(whole.lo, std::min(p, q)) - whole.lo) / whole.shared;
    const double to = (std::min(whole.hi, std::max(p, q)) - whole.lo) / whole.shared;
    if (!(to - from > least_part)) return;
    if (from > least_part || to < 1 - least_part) {
      take_part(record, from, to, whole.shared, given);
      if ((to - from) * whole.shared < least_bonded_share * smaller_size(model_, given.piece_a, given.piece_b))
        lift_bond(given);
    }
    out.push_back(ordered(std::move(given)));
  }

  /// A part met the other body only by the settlement of its neighbour: it lies across a corner from it.
  static void lift_bond(ContactRecord& record) {
    record.memory.bonds = 0;
    with_kernel_type(record.law, [&]<class K>() {
      if constexpr (K::bonds) {
        LawMemory<K> own = law_memory<K>(record.numbers.data());
        K::lift_bond(own);
        keep_law_memory<K>(own, record.numbers.data());
      }
    });
  }

  static void take_part(const ContactRecord& whole, double from, double to, double length, ContactRecord& part) {
    part.memory = part_of(whole.memory, from, to);
    share_damping(whole.memory, from, to, length, part.memory);
    with_kernel_type(whole.law, [&]<class K>() {
      keep_law_memory<K>(part_of_memory(law_memory<K>(whole.numbers.data()), from, to), part.numbers.data());
    });
  }

  const Model<2>& model_;
  SkinPlaces places_;
  SplitBody split_;
};

}  // namespace

namespace {

/// True for a law whose bonds lose their strength gradually.
bool softens(const ContactLaw& law) {
  return with_kernel({law}, []<class K>(const K& /*kernel*/) {
    if constexpr (K::bonds) return K::softens;
    return false;
  });
}

}  // namespace

std::vector<ContactRecord> contact_records(const Model<2>& /*model*/, const State<2>& state, const Work<2>& work) {
  const ContactHistory& contacts = contacts_before(state, work);
  std::vector<ContactRecord> records;
  for (std::size_t row = 0; row < work.pairs.size(); ++row) {
    if (contacts.memory[row].empty()) continue;
    const NearPair& p = work.pairs[row];
    ContactRecord r{p.piece_a, p.piece_b, p.a0, p.a1, p.b0, p.b1};
    r.memory = contacts.memory[row];
    r.general = (r.memory.state & contact_general) != 0 || p.facing == 0;
    if (const GeneralContact<2>* g = work.general_touching.find(static_cast<int>(row)); g != nullptr)
      r.place = g->centre;
    r.law = contacts.law_row[row].place;
    r.numbers.assign(contacts.law_numbers(row), contacts.law_numbers(row) + law_number_counts[r.law]);
    records.push_back(std::move(r));
  }
  return records;
}

std::vector<ContactRecord> handed_over(const Model<2>& model, const State<2>& state,
                                       const std::vector<ContactRecord>& records, const SplitBody& split) {
  const Divider divider(model, state, split);
  std::vector<ContactRecord> out;
  for (const ContactRecord& record : records) divider.divide(record, out);
  return out;
}

/// The coordinate along the faces runs to the left of the section's normal, so its shear has the sign of the section's.
std::optional<ContactRecord> crack_contact(const Model<2>& model, const State<2>& state, const SplitBody& split,
                                           const CrackingBody<2>& row, const Crack<2>& crack) {
  const CrackSection<2>& section = row.sections[static_cast<std::size_t>(crack.section)];
  const auto n = static_cast<std::size_t>(model.bodies[static_cast<std::size_t>(split.body)].first_node);
  const Turn turn(state.rotation[n]);
  const Vec2 middle = state.position[n] + turn.apply(section.middle()), along = left_of(turn.apply(section.normal));
  const SkinPlaces places(model, state);
  const PieceFace behind = face_near(model, places, split.behind, middle, along);
  const PieceFace ahead = face_near(model, places, split.ahead, middle, -along);
  if (behind.piece < 0 || ahead.piece < 0) return std::nullopt;
  const ContactLaw& law = model.laws[static_cast<std::size_t>(row.law)];
  if (!softens(law)) return std::nullopt;
  ContactRecord r{behind.piece, ahead.piece, behind.from, behind.to, ahead.from, ahead.to};
  r.law = static_cast<std::uint32_t>(law.index());
  r.numbers.assign(law_number_counts[r.law], 0.0);
  r.memory.bonds = 3, r.memory.state = contact_touching;
  for (const int h : {0, 1}) {
    r.memory.shear_elastic[h] = r.memory.shear_total[h] = 0.5 * crack.shear;
    r.memory.active[h] = 0.5 * section.length();
  }
  return r;
}

void put_contacts(State<2>& state, std::vector<ContactRecord> records) {
  std::stable_sort(records.begin(), records.end(), [](const ContactRecord& a, const ContactRecord& b) {
    return contact_key(a.piece_a, a.piece_b) < contact_key(b.piece_a, b.piece_b);
  });
  ContactHistory rows;
  for (const ContactRecord& r : records) {
    rows.key.push_back(contact_key(r.piece_a, r.piece_b));
    rows.memory.push_back(r.memory);
    rows.law_row.push_back({r.law, static_cast<std::uint32_t>(rows.law_memory.size())});
    rows.law_memory.insert(rows.law_memory.end(), r.numbers.begin(), r.numbers.end());
  }
  state.contacts = std::move(rows);
}

}  // namespace trilith
