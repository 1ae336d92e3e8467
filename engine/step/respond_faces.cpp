// Contacts of two faces, by law, several rows at once.
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <span>

#include "contact/face_pair.hpp"
#include "detect/pairs.hpp"
#include "step/contact_rows.hpp"
#include "step/evaluate.hpp"
#include "step/face_columns.hpp"
#include "step/near_faces.hpp"

namespace trilith {
namespace {

static_assert(offsetof(ContactMemory, bonds) == offsetof(ContactMemory, slip) + sizeof(double) &&
                  offsetof(ContactMemory, state) == offsetof(ContactMemory, bonds) + sizeof(std::uint32_t),
              "slip, bonds and state are moved as one pair");
static_assert(std::endian::native == std::endian::little, "bonds and state are read as one number");

using Four = std::array<Lanes, lane_count>;

/// Two columns as a pair for each of four rows.
struct RowPairs {
  Lanes row02, row13;
  TRILITH_INLINE RowPairs(const Lanes& c0, const Lanes& c1) {
    const Lanes low = even(c0, c1), high = odd(c0, c1);
    row02 = low, row13 = high;
  }
  TRILITH_INLINE LanePair of(int row) const {
    const Lanes& v = row % 2 == 0 ? row02 : row13;
    return row < 2 ? LanePair{v[0], v[1]} : LanePair{v[2], v[3]};
  }
};

TRILITH_INLINE LaneMask bits_of(const Lanes& v) {
  LaneMask m;
  __builtin_memcpy(&m, &v, sizeof m);
  return m;
}
TRILITH_INLINE Lanes as_lanes(const LaneMask& m) {
  Lanes v;
  __builtin_memcpy(&v, &m, sizeof v);
  return v;
}
TRILITH_INLINE LaneMask has_bit(const LaneMask& word, std::int64_t bit) {
  const LaneMask none{};
  return (word & (none + bit)) != none;
}

constexpr std::int64_t touching_bit = std::int64_t{contact_touching} << 32,
                       general_bit = std::int64_t{contact_general} << 32, worn_bit = std::int64_t{contact_worn} << 32,
                       crushed_bit = std::int64_t{contact_crushed} << 32;

/// Arrays of State and Work that the rows of a batch are read from and written to.
struct Pass {
  const SkinMotion* skin;
  const NearPair* pairs;
  const ContactMemory* before;
  ContactMemory* after;
  Vec2* skin_force;
  FaceLaw law;
  Work<2>& work;
};

/// Four rows of a list at once. Beyond its end the list holds its last row again, which is not `valid` there.
struct Rows {
  const int* row;
  LaneMask valid{-1, -1, -1, -1};
  TRILITH_INLINE Rows(const int* list, std::size_t left) : row(list) {
    if (left >= lane_count) return;
    for (std::size_t i = left; i < lane_count; ++i) valid[i] = 0;
  }
};

TRILITH_INLINE FaceMotion<Lanes> load_motion(const Pass& pass, const Rows& rows) {
  const NearPair* p[lane_count];
  for (int i = 0; i < lane_count; ++i) p[i] = &pass.pairs[rows.row[i]];
  const auto ends = [&](int NearPair::*end, Lanes& x, Lanes& y, Lanes& u, Lanes& v) {
    load_ends(pass.skin, p, end, &SkinMotion::x, x, y);
    load_ends(pass.skin, p, end, &SkinMotion::u, u, v);
  };
  FaceEnds<Lanes> a, b;
  ends(&NearPair::a0, a.x0, a.y0, a.u0, a.v0);
  ends(&NearPair::a1, a.x1, a.y1, a.u1, a.v1);
  ends(&NearPair::b0, b.x0, b.y0, b.u0, b.v0);
  ends(&NearPair::b1, b.x1, b.y1, b.u1, b.v1);
  return {a, b, Lanes{p[0]->corner, p[1]->corner, p[2]->corner, p[3]->corner}};
}

struct LaneMemory {
  FaceMemory<Lanes> face;
  LaneMask touching;
};

template <Bond B>
TRILITH_INLINE LaneMemory load_memory(const Pass& pass, const Rows& rows) {
  const auto load = [&](auto member, Lanes& c0, Lanes& c1) {
    const double* row[lane_count];
    for (int i = 0; i < lane_count; ++i) {
      if constexpr (std::is_same_v<decltype(member), double ContactMemory::*>)
        row[i] = &(pass.before[rows.row[i]].*member);
      else
        row[i] = pass.before[rows.row[i]].*member;
    }
    load_columns(row, c0, c1);
  };
  LaneMemory m;
  Lanes bits;
  load(&ContactMemory::shear_elastic, m.face.shear_elastic[0], m.face.shear_elastic[1]);
  load(&ContactMemory::shear_total, m.face.shear_total[0], m.face.shear_total[1]);
  load(&ContactMemory::damping_force, m.face.damping_force[0], m.face.damping_force[1]);
  load(&ContactMemory::active, m.face.active[0], m.face.active[1]);
  load(&ContactMemory::slip, m.face.slip, bits);
  const LaneMask word = bits_of(bits);
  m.face.bonds[0] = has_bit(word, 1);
  m.face.bonds[1] = has_bit(word, 2);
  m.face.general = has_bit(word, general_bit);
  m.touching = has_bit(word, touching_bit);
  if constexpr (B != Bond::none) load(&ContactMemory::set, m.face.set[0], m.face.set[1]);
  if constexpr (B == Bond::softening) {
    load(&ContactMemory::own, m.face.damage[0], m.face.damage[1]);
    load(&ContactMemory::crushed, m.face.crushed[0], m.face.crushed[1]);
    m.face.worn = has_bit(word, worn_bit);
  }
  return m;
}

/// A response as rows again, to be written where they belong.
struct RowResponse {
  RowPairs elastic, total, damping, active, slip_bits, damage, set, crushed, a0, a1, b0, b1;
  TRILITH_INLINE static Lanes word_of(const FaceMemory<Lanes>& m) {
    const LaneMask none{};
    const LaneMask crushed = larger(m.crushed[0], m.crushed[1]) > Lanes{};
    return as_lanes((m.bonds[0] & (none + 1)) | (m.bonds[1] & (none + 2)) | (m.worn & (none + worn_bit)) |
                    (crushed & (none + crushed_bit)) | (none + touching_bit));
  }
  TRILITH_INLINE explicit RowResponse(const FaceResponse<Lanes>& r)
      : elastic(r.memory.shear_elastic[0], r.memory.shear_elastic[1]),
        total(r.memory.shear_total[0], r.memory.shear_total[1]),
        damping(r.memory.damping_force[0], r.memory.damping_force[1]),
        active(r.memory.active[0], r.memory.active[1]),
        slip_bits(r.memory.slip, word_of(r.memory)),
        damage(r.memory.damage[0], r.memory.damage[1]),
        set(r.memory.set[0], r.memory.set[1]),
        crushed(r.memory.crushed[0], r.memory.crushed[1]),
        a0(r.ax0, r.ay0),
        a1(r.ax1, r.ay1),
        b0(r.bx0, r.by0),
        b1(r.bx1, r.by1) {}
};

TRILITH_INLINE void write_row(const Pass& pass, int row, const RowResponse& r, int i) {
  ContactMemory& after = pass.after[row];
  store_pair(after.shear_elastic, r.elastic.of(i));
  store_pair(after.shear_total, r.total.of(i));
  store_pair(after.damping_force, r.damping.of(i));
  store_pair(after.active, r.active.of(i));
  store_pair(&after.slip, r.slip_bits.of(i));
  store_pair(after.own, r.damage.of(i));
  store_pair(after.set, r.set.of(i));
  store_pair(after.crushed, r.crushed.of(i));
  const NearPair& p = pass.pairs[row];
  const auto add = [&](int skin, const LanePair& force) {
    double* on = pass.skin_force[skin].data();
    store_pair(on, load_pair(on) + force);
  };
  add(p.a0, r.a0.of(i));
  add(p.a1, r.a1.of(i));
  add(p.b0, r.b0.of(i));
  add(p.b1, r.b1.of(i));
}

/// Energy given off by rows [J], added one after the other: a row that gives nothing changes no bit of a sum, so which
/// pairs are near and do not touch, and with it when they were found, does not either.
struct GivenOff {
  double damping = 0, friction = 0, fracture = 0;
};

TRILITH_INLINE void add_lanes(double& sum, const LaneMask& counts, const Lanes& lost) {
  const Lanes v = select(counts, lost, Lanes{});
  for (int i = 0; i < lane_count; ++i) sum += v[i];
}

template <Bond B>
TRILITH_INLINE void respond_rows(const Pass& pass, const FaceLaw& law, const Rows& rows,
                                 const FaceMotion<Lanes>& motion, GivenOff& given) {
  const LaneMemory memory = load_memory<B>(pass, rows);
  const FaceResponse<Lanes> r = respond_face_motion<B>(motion, memory.face, law);
  const LaneMask found = rows.valid & r.is_face_pair, counts = found & (r.touching | memory.touching);
  add_lanes(given.damping, counts, r.lost_damping);
  add_lanes(given.friction, counts, r.lost_friction);
  LaneMask turns = r.touching ^ memory.touching;
  if constexpr (B != Bond::none) {
    add_lanes(given.fracture, counts, r.lost_fracture);
    turns |= (memory.face.bonds[0] ^ r.memory.bonds[0]) | (memory.face.bonds[1] ^ r.memory.bonds[1]);
    if constexpr (B == Bond::softening) {
      const FaceMemory<Lanes>&m = memory.face, &n = r.memory;
      const Lanes none{};
      turns |= (larger(m.damage[0], m.damage[1]) <= none) & (larger(n.damage[0], n.damage[1]) > none);
      turns |= (larger(m.crushed[0], m.crushed[1]) <= none) & (larger(n.crushed[0], n.crushed[1]) > none);
    }
  }
  const RowResponse out(r);
  if (!any(flip(found & r.touching) | turns)) {  // as nearly always
    for (int i = 0; i < lane_count; ++i) write_row(pass, rows.row[i], out, i);
    return;
  }
  for (int i = 0; i < lane_count; ++i) {
    if (rows.valid[i] == 0) continue;
    const int row = rows.row[i];
    if (r.is_face_pair[i] == 0) {
      pass.work.general_now.push_back(row);
      continue;
    }
    if (r.touching[i] != 0)
      write_row(pass, row, out, i);
    else
      pass.after[row] = pass.before[row].parted();
    if (turns[i] != 0) pass.work.turned.push_back(row);
  }
}

template <Bond B>
TRILITH_INLINE void respond_batch(const Pass& pass, std::span<const int> rows) {
  const FaceLaw law = pass.law;
  GivenOff given;
  // In blocks, motions first: two short loops leave the processor more to do at once than one long one.
  constexpr std::size_t block = 16;
  std::array<FaceMotion<Lanes>, block> motion;
  for (std::size_t from = 0; from < rows.size(); from += block * lane_count) {
    const std::size_t to = std::min(rows.size(), from + block * lane_count);
    const auto rows_at = [&](std::size_t i) { return Rows(rows.data() + i, rows.size() - i); };
    for (std::size_t i = from, k = 0; i < to; i += lane_count, ++k) motion[k] = load_motion(pass, rows_at(i));
    for (std::size_t i = from, k = 0; i < to; i += lane_count, ++k)
      respond_rows<B>(pass, law, rows_at(i), motion[k], given);
  }
  pass.work.given[EnergyTerm::contact_damping] += given.damping;
  pass.work.given[EnergyTerm::contact_friction] += given.friction;
  pass.work.given[EnergyTerm::contact_fracture] += given.fracture;
}

// One copy for wide registers and one for any machine: the same operations, so the same bits.
[[gnu::target_clones("arch=x86-64-v4", "avx2", "default")]] void respond_plain(const Pass& pass,
                                                                               std::span<const int> rows) {
  respond_batch<Bond::none>(pass, rows);
}
[[gnu::target_clones("arch=x86-64-v4", "avx2", "default")]] void respond_brittle(const Pass& pass,
                                                                                 std::span<const int> rows) {
  respond_batch<Bond::brittle>(pass, rows);
}
[[gnu::target_clones("arch=x86-64-v4", "avx2", "default")]] void respond_softening(const Pass& pass,
                                                                                   std::span<const int> rows) {
  respond_batch<Bond::softening>(pass, rows);
}

}  // namespace

FaceLaw face_law(const Model<2>& model, int law, double dt) {
  return std::visit(
      [&](const auto& l) {
        using L = std::decay_t<decltype(l)>;
        const double t = model.thickness;
        FaceLaw out{l.kn * t, l.ks * t, l.mu, l.beta, 0, 0, dt, false};
        if constexpr (L::bond != Bond::none) out.cohesion = l.cohesion * t, out.tension = l.tension * t;
        if constexpr (L::bond == Bond::brittle) out.loss_by_point = l.loss_by_point != 0;
        if constexpr (L::bond == Bond::softening) {
          out.last_opening = 2 * l.energy_tension / l.tension;
          out.last_slip = 2 * l.energy_shear / l.cohesion;
          out.dilation = l.dilation, out.dilation_slip = l.dilation_slip;
          out.crushing = l.compression / l.kn, out.crushing_depth = l.crushing_depth;
        }
        return out;
      },
      model.laws[law]);
}

namespace {

/// Rows of a batch: those with one pair of facing faces, and those of several of which one is chosen now. In the order
/// of rows either way, so that sums do not depend on when the pairs were found.
const std::vector<int>& facing_now(const Model<2>& model, const State<2>& state, Work<2>& work, FaceBatch& batch) {
  if (batch.choice.empty()) return batch.row;
  batch.chosen.clear();
  for (const int row : batch.choice) {
    const bool bonded = state.memory[row].bonds != 0;
    (choose_face_pair(model, work, bonded, work.pairs[row]) ? batch.chosen : work.general_now).push_back(row);
  }
  batch.now.resize(batch.row.size() + batch.chosen.size());
  std::merge(batch.row.begin(), batch.row.end(), batch.chosen.begin(), batch.chosen.end(), batch.now.begin());
  return batch.now;
}

}  // namespace

void respond_faces(const Model<2>& model, const State<2>& state, Work<2>& work, double dt, StepTimes* times) {
  StepClock clock(times);
  work.general_now.clear();
  for (FaceBatch& batch : work.batches) {
    const std::size_t count =
        sort_out(state, work, facing_now(model, state, work, batch), work.face_rows, work.fresh_rows);
    if (count == 0) continue;
    const std::span<const int> rows(work.face_rows.data(), count);
    const Pass pass{work.skin.data(),
                    work.pairs.data(),
                    state.memory.data(),
                    work.memory.data(),
                    work.skin_force.data(),
                    face_law(model, batch.law, dt),
                    work};
    switch (bond_of(model.laws[batch.law])) {
      case Bond::none:
        respond_plain(pass, rows);
        break;
      case Bond::brittle:
        respond_brittle(pass, rows);
        break;
      case Bond::softening:
        respond_softening(pass, rows);
        break;
    }
    clock.mark_law(batch.law);
  }
}

}  // namespace trilith
