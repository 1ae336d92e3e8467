// Contacts of two faces, by law, several rows at once.
#include <algorithm>

#include "contact/face_pair.hpp"
#include "detect/pairs.hpp"
#include "step/contact_rows.hpp"
#include "step/evaluate.hpp"

namespace trilith {
namespace {

static_assert(lane_count == 4, "transpose_in and the loaders are written for four lanes");

/// Four rows of four numbers to four columns: one row of each lane becomes one number of all lanes.
TRILITH_INLINE void transpose(const Lanes& r0, const Lanes& r1, const Lanes& r2, const Lanes& r3, Lanes& c0, Lanes& c1,
                              Lanes& c2, Lanes& c3) {
  const Lanes t0 = __builtin_shufflevector(r0, r1, 0, 4, 2, 6), t1 = __builtin_shufflevector(r0, r1, 1, 5, 3, 7);
  const Lanes t2 = __builtin_shufflevector(r2, r3, 0, 4, 2, 6), t3 = __builtin_shufflevector(r2, r3, 1, 5, 3, 7);
  c0 = __builtin_shufflevector(t0, t2, 0, 1, 4, 5);
  c1 = __builtin_shufflevector(t1, t3, 0, 1, 4, 5);
  c2 = __builtin_shufflevector(t0, t2, 2, 3, 6, 7);
  c3 = __builtin_shufflevector(t1, t3, 2, 3, 6, 7);
}

TRILITH_INLINE Lanes load(const double* four) {
  Lanes v;
  __builtin_memcpy(&v, __builtin_assume_aligned(four, 32), sizeof v);
  return v;
}

/// How a T is filled from rows of Work and State: one row for double, four for Lanes.
template <class T>
struct Loader;

template <>
struct Loader<double> {
  static constexpr int width = 1;
  TRILITH_INLINE static void skin(const SkinMotion* const* p, double& x, double& y, double& u, double& v) {
    x = p[0]->x, y = p[0]->y, u = p[0]->u, v = p[0]->v;
  }
  TRILITH_INLINE static void memory(const ContactMemory* const* p, FaceMemory<double>& m) {
    const ContactMemory& c = *p[0];
    m = {{c.shear_elastic[0], c.shear_elastic[1]},
         {c.shear_total[0], c.shear_total[1]},
         {c.damping_force[0], c.damping_force[1]},
         {c.active[0], c.active[1]},
         c.slip,
         {(c.bonds & 1U) != 0, (c.bonds & 2U) != 0},
         (c.state & contact_general) != 0};
  }
  TRILITH_INLINE static double number(const double* v) { return v[0]; }
  TRILITH_INLINE static double lane(double v, int) { return v; }
  TRILITH_INLINE static bool lane(bool m, int) { return m; }
};

template <>
struct Loader<Lanes> {
  static constexpr int width = lane_count;
  TRILITH_INLINE static void skin(const SkinMotion* const* p, Lanes& x, Lanes& y, Lanes& u, Lanes& v) {
    transpose(load(&p[0]->x), load(&p[1]->x), load(&p[2]->x), load(&p[3]->x), x, y, u, v);
  }
  TRILITH_INLINE static void memory(const ContactMemory* const* p, FaceMemory<Lanes>& m) {
    Lanes bits, unused;
    transpose(load(p[0]->shear_elastic), load(p[1]->shear_elastic), load(p[2]->shear_elastic),
              load(p[3]->shear_elastic), m.shear_elastic[0], m.shear_elastic[1], m.shear_total[0], m.shear_total[1]);
    transpose(load(p[0]->damping_force), load(p[1]->damping_force), load(p[2]->damping_force),
              load(p[3]->damping_force), m.damping_force[0], m.damping_force[1], m.active[0], m.active[1]);
    transpose(load(&p[0]->slip), load(&p[1]->slip), load(&p[2]->slip), load(&p[3]->slip), m.slip, bits, unused, unused);
    LaneMask word;
    __builtin_memcpy(&word, &bits, sizeof word);
    const LaneMask none{};
    m.bonds[0] = (word & (none + 1)) != none;
    m.bonds[1] = (word & (none + 2)) != none;
    m.general = (word & (none + (std::int64_t{contact_general} << 32))) != none;
  }
  TRILITH_INLINE static Lanes number(const double* v) { return Lanes{v[0], v[1], v[2], v[3]}; }
  TRILITH_INLINE static double lane(const Lanes& v, int i) { return v[i]; }
  TRILITH_INLINE static bool lane(const LaneMask& m, int i) { return m[i] != 0; }
};

struct Pass {
  const Model<2>& model;
  const State<2>& state;
  Work<2>& work;
  FaceLaw law;
};

template <class T>
TRILITH_INLINE void give_off(Work<2>& work, const FaceResponse<T>& r, int i) {
  using L = Loader<T>;
  work.given[EnergyTerm::contact_damping] += L::lane(r.lost_damping, i);
  work.given[EnergyTerm::contact_friction] += L::lane(r.lost_friction, i);
  work.given[EnergyTerm::contact_fracture] += L::lane(r.lost_fracture, i);
}

/// Writes lane `i` of a response to its row: forces, memory, losses.
template <class T>
TRILITH_INLINE void store(const Pass& pass, int row, const FaceResponse<T>& r, int i) {
  using L = Loader<T>;
  Work<2>& work = pass.work;
  const ContactMemory& before = pass.state.memory[row];
  ContactMemory& after = work.memory[row];
  const bool was = (before.state & contact_touching) != 0;
  if (!L::lane(r.touching, i)) {
    after = {};
    if (!was) return;
    work.turned.push_back(row);
    give_off(work, r, i);
    return;
  }
  const FaceMemory<T>& m = r.memory;
  for (const int h : {0, 1}) {
    after.shear_elastic[h] = L::lane(m.shear_elastic[h], i);
    after.shear_total[h] = L::lane(m.shear_total[h], i);
    after.damping_force[h] = L::lane(m.damping_force[h], i);
    after.active[h] = L::lane(m.active[h], i);
  }
  after.damping_moment = 0;
  after.slip = L::lane(m.slip, i);
  after.bonds = (L::lane(m.bonds[0], i) ? 1U : 0U) | (L::lane(m.bonds[1], i) ? 2U : 0U);
  after.state = contact_touching;
  if (!was || after.bonds != before.bonds) work.turned.push_back(row);
  const NearPair& p = work.pairs[row];
  std::vector<Vec2>& on = work.skin_force;
  on[p.a0] += Vec2(L::lane(r.ax0, i), L::lane(r.ay0, i));
  on[p.a1] += Vec2(L::lane(r.ax1, i), L::lane(r.ay1, i));
  on[p.b0] += Vec2(L::lane(r.bx0, i), L::lane(r.by0, i));
  on[p.b1] += Vec2(L::lane(r.bx1, i), L::lane(r.by1, i));
  give_off(work, r, i);
}

template <bool CanBond, class T>
TRILITH_INLINE void respond_rows(const Pass& pass, const int* rows) {
  using L = Loader<T>;
  const SkinMotion *a0[L::width], *a1[L::width], *b0[L::width], *b1[L::width];
  const ContactMemory* before[L::width];
  double corner[L::width];
  for (int i = 0; i < L::width; ++i) {
    const NearPair& p = pass.work.pairs[rows[i]];
    a0[i] = &pass.work.skin[p.a0], a1[i] = &pass.work.skin[p.a1];
    b0[i] = &pass.work.skin[p.b0], b1[i] = &pass.work.skin[p.b1];
    before[i] = &pass.state.memory[rows[i]];
    corner[i] = p.corner;
  }
  FaceEnds<T> a, b;
  L::skin(a0, a.x0, a.y0, a.u0, a.v0);
  L::skin(a1, a.x1, a.y1, a.u1, a.v1);
  L::skin(b0, b.x0, b.y0, b.u0, b.v0);
  L::skin(b1, b.x1, b.y1, b.u1, b.v1);
  FaceMemory<T> memory;
  L::memory(before, memory);
  const FaceResponse<T> r = respond_face_pair<CanBond>(a, b, L::number(corner), memory, pass.law);
  for (int i = 0; i < L::width; ++i) {
    if (L::lane(r.is_face_pair, i))
      store(pass, rows[i], r, i);
    else
      pass.work.general_now.push_back(rows[i]);
  }
}

template <bool CanBond>
TRILITH_INLINE void respond_batch(const Pass& pass, const std::vector<int>& rows) {
  std::size_t i = 0;
  for (; i + lane_count <= rows.size(); i += lane_count) respond_rows<CanBond, Lanes>(pass, rows.data() + i);
  for (; i < rows.size(); ++i) respond_rows<CanBond, double>(pass, rows.data() + i);
}

// One copy for wide registers and one for any machine: the same operations, so the same bits.
[[gnu::target_clones("avx2", "default")]] void respond_plain(const Pass& pass, const std::vector<int>& rows) {
  respond_batch<false>(pass, rows);
}
[[gnu::target_clones("avx2", "default")]] void respond_bonding(const Pass& pass, const std::vector<int>& rows) {
  respond_batch<true>(pass, rows);
}

}  // namespace

FaceLaw face_law(const Model<2>& model, int law, double dt) {
  return std::visit(
      [&](const auto& l) {
        const double t = model.thickness;
        FaceLaw out{l.kn * t, l.ks * t, l.mu, l.beta, 0, 0, dt, false};
        if constexpr (std::decay_t<decltype(l)>::can_bond) {
          out.cohesion = l.cohesion * t;
          out.tension = l.tension * t;
          out.loss_by_point = l.loss_by_point != 0;
        }
        return out;
      },
      model.laws[law]);
}

namespace {

/// Rows of a batch at this step: those with one pair of facing faces, and those of several of which one is chosen now.
/// In the order of rows either way, so that sums do not depend on when the pairs were found.
const std::vector<int>& rows_now(const Model<2>& model, const State<2>& state, Work<2>& work, FaceBatch& batch) {
  if (batch.choice.empty()) return batch.row;
  batch.now = batch.row;
  for (const int row : batch.choice) {
    const bool bonded = state.memory[row].bonds != 0;
    (choose_face_pair(model, work, bonded, work.pairs[row]) ? batch.now : work.general_now).push_back(row);
  }
  std::sort(batch.now.begin(), batch.now.end());
  return batch.now;
}

}  // namespace

void respond_faces(const Model<2>& model, const State<2>& state, Work<2>& work, double dt) {
  work.general_now.clear();
  for (FaceBatch& batch : work.batches) {
    const std::vector<int>& rows = rows_now(model, state, work, batch);
    if (rows.empty()) continue;
    const Pass pass{model, state, work, face_law(model, batch.law, dt)};
    const bool bonding =
        std::visit([](const auto& l) { return std::decay_t<decltype(l)>::can_bond; }, model.laws[batch.law]);
    bonding ? respond_bonding(pass, rows) : respond_plain(pass, rows);
  }
}

}  // namespace trilith
