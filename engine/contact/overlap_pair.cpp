#include "contact/overlap_pair.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include "contact/overlap_energy.hpp"
#include "contact/placed_edges.hpp"

namespace trilith {
namespace {

// Stages of one call: depths of all corners of each piece below all edges of the other (a face with all corners
// outside ends it here); then a walk along every surface edge of either inside the other; then friction and memory.
//
//       v     from           crossing      to      w       phi along the edge (v, w) of the walker is the least of
//       |------|===== f1 =======|=== f2 ===|-------|       its depths below the owner's faces: straight in pieces,
//      outside     phi = depth       phi = depth           slopes falling, so integrals are exact piece by piece
//                  below f1          below f2

/// depth(f, v): how far corner v of the other piece lies inside face f [m].
struct Depths {
  int corners = 0;
  std::array<double, max_piece_corners * max_piece_corners> value;

  /// Largest gap of a face that has all corners outside; 0 where there is none.
  double fill(const PlacedPiece& owner, const PlacedEdges& edges, const PlacedPiece& other) {
    corners = static_cast<int>(other.corner.size());
    double separation = 0;
    for (int f = 0; f < edges.count; ++f) {
      double deepest = -std::numeric_limits<double>::infinity();
      for (int v = 0; v < corners; ++v) {
        const double depth = edges.normal[f].dot(owner.corner[f] - other.corner[v]);
        value[static_cast<std::size_t>(f * corners + v)] = depth;
        deepest = std::max(deepest, depth);
      }
      if (deepest <= 0) separation = std::max(separation, std::max(-deepest, std::numeric_limits<double>::min()));
    }
    return separation;
  }
  [[nodiscard]] double at(int f, int v) const { return value[static_cast<std::size_t>(f * corners + v)]; }
};

struct Span {
  double from, to;
};

/// The part of edge (v, w) of the other piece that lies inside all edges of the owner, in shares of the edge.
Span inside(const Depths& depths, int edges, int v, int w) {
  Span span{0, 1};
  for (int f = 0; f < edges; ++f) {
    const double d0 = depths.at(f, v), d1 = depths.at(f, w);
    if (d0 <= 0 && d1 <= 0) return {0, 0};
    if (d0 < 0) span.from = std::max(span.from, d0 / (d0 - d1));
    if (d1 < 0) span.to = std::min(span.to, d0 / (d0 - d1));
  }
  return span;
}

/// The surface face that is nearest from some share of the edge on, and the share up to which it stays so.
struct Nearest {
  int face;
  double slope, until;
};

/// Next face of the lower envelope of depths at share `at`. Going up, the slopes of an envelope of lines only fall:
/// only faces that fall faster than `steeper_than` count, so that rounding at a crossing cannot choose the last face
/// again.
Nearest nearest_from(const Depths& depths, const PlacedEdges& edges, int v, int w, double at, double to,
                     double steeper_than) {
  const auto slope_of = [&](int f) { return depths.at(f, w) - depths.at(f, v); };
  const auto depth_of = [&](int f) { return depths.at(f, v) + slope_of(f) * at; };
  Nearest best{-1, 0, to};
  double best_depth = 0;
  for (int f = 0; f < edges.count; ++f) {
    const double slope = slope_of(f);
    if (!edges.surface[f] || slope >= steeper_than) continue;
    const double depth = depth_of(f);
    if (best.face >= 0 && (depth > best_depth || (depth == best_depth && slope >= best.slope))) continue;
    best.face = f, best.slope = slope;
    best_depth = depth;
  }
  for (int f = 0; f < edges.count && best.face >= 0; ++f) {
    const double slope = slope_of(f);
    if (!edges.surface[f] || slope >= best.slope) continue;
    best.until = std::min(best.until, std::max(at, at + (depth_of(f) - best_depth) / (best.slope - slope)));
  }
  return best;
}

/// The part of `span` where a depth that is linear from d0 to d1 over all of the edge is above `crushed`.
Span above(double crushed, double d0, double d1, const Span& span) {
  const auto depth = [&](double share) { return d0 + (d1 - d0) * share - crushed; };
  const double width = span.to - span.from;
  const PositivePart<double> part(depth(span.from), depth(span.to));
  return {span.from + width * part.from, span.from + width * part.to};
}

/// Adds `force` at point `x` to the two corners of edge e: same resultant, and same moment through a couple.
void add_at(std::span<Vec2> on, const PlacedPiece& piece, int e, const Vec2& x, const Vec2& force) {
  const int e1 = (e + 1) % static_cast<int>(piece.corner.size());
  const Vec2 along = piece.corner[e1] - piece.corner[e];
  const double length2 = along.squaredNorm();
  const double share = along.dot(x - piece.corner[e]) / length2;
  const Vec2 foot = piece.corner[e] + share * along;
  const Vec2 couple = left_of(along) * (cross(Vec2(x - foot), force) / length2);
  on[e] += (1 - share) * force - couple;
  on[e1] += share * force + couple;
}

}  // namespace

Vec2 PlacedPiece::velocity_at(int e, const Vec2& x) const {
  if (corner_velocity.empty()) return velocity_at(x);
  const int e1 = (e + 1) % static_cast<int>(corner.size());
  const Vec2 along = corner[e1] - corner[e], turning = corner_velocity[e1] - corner_velocity[e];
  const double length2 = along.squaredNorm(), share = along.dot(x - corner[e]) / length2;
  const Vec2 off = x - corner[e] - share * along;
  return corner_velocity[e] + share * turning + cross(cross(along, turning) / length2, off);
}

namespace {

/// Sums over the pressed faces of both sides.
struct Sums {
  Vec2 force = Vec2::Zero(), moment_arm = Vec2::Zero();
  Vec2 damping = Vec2::Zero();  // damping part of the force on b ...
  double damping_moment = 0;    // ... and its moment about a's origin ...
  double damped = 0;            // ... and the power it takes [W]
  double pressure = 0, length = 0, deepest = 0;
  double most_a = 0, most_b = 0;  // largest share of the pressure on one edge, and which edge
  int edge_a = 0, edge_b = 0;
};

/// One side's faces inside the other piece: the walker presses its edges against the owner's nearest faces.
template <class K>
struct Walk {
  const PlacedPiece& owner;
  const PlacedEdges& owner_edges;
  const PlacedPiece& walker;
  const PlacedEdges& walker_edges;
  const Depths& depths;  // of the walker's corners in the owner
  const K& law;
  double crushed;  // [m]
  bool walker_is_b;
  std::span<Vec2> on_owner, on_walker;

  /// Mean over the step of the speed at which they close at `x` [m/s].
  [[nodiscard]] double closing(int edge, int face, const Vec2& n, const Vec2& x) const {
    return n.dot(walker.mean().velocity_at(edge, x) - owner.mean().velocity_at(face, x));
  }
  void press(int edge, int face, const Vec2& x0, const Vec2& x1, double phi0, double phi1, Sums& sums) const;
  void run(Sums& sums) const;
};

template <class K>
void Walk<K>::press(int edge, int face, const Vec2& x0, const Vec2& x1, double phi0, double phi1, Sums& sums) const {
  const Vec2& n = walker_edges.normal[edge];  // out of the walker, into the owner
  // c > 0: they close. k is half of kn, and half the length counts, as the other piece's walk brings the other halves.
  const double c0 = n.dot(walker.velocity_at(edge, x0) - owner.velocity_at(face, x0));
  const double c1 = n.dot(walker.velocity_at(edge, x1) - owner.velocity_at(face, x1));
  const double length = (x1 - x0).norm(), k = 0.5 * law.kn;
  const auto [stress, spring] = law.stretch(phi0, phi1, c0, c1);
  sums.length += 0.5 * length;
  sums.deepest = std::max({sums.deepest, phi0, phi1});
  const double total = k * length * stress.sum;
  const double sign = walker_is_b ? 1.0 : -1.0;
  // On b acts -n where b walks, as n then points from b into a, and +n where a does: hence `sign`.
  const double damping = k * length * (stress.sum - spring.sum),
               first_moment = k * length * (stress.moment - spring.moment);
  sums.damping += -sign * damping * n;
  const Vec2& about = walker_is_b ? owner.origin : walker.origin;
  sums.damping_moment += -sign * (damping * cross(Vec2(x0 - about), n) + first_moment * cross(Vec2(x1 - x0), n));
  const bool alike = walker.over_step == nullptr && owner.over_step == nullptr;
  const double m0 = alike ? c0 : closing(edge, face, n, x0), m1 = alike ? c1 : closing(edge, face, n, x1);
  sums.damped += damping * m0 + first_moment * (m1 - m0);
  // No pressure where the two part fast; what the damping took of the spring then is booked above.
  if (total <= 0) return;
  const Vec2 x = x0 + (stress.moment / stress.sum) * (x1 - x0);
  add_at(on_walker, walker, edge, x, -total * n);
  add_at(on_owner, owner, face, x, total * n);
  sums.force += -sign * total * n;
  sums.pressure += total;
  sums.moment_arm += total * x;
  // The edges that carry most stand for their pieces where friction is added, which acts at one point.
  double& most_walker = walker_is_b ? sums.most_b : sums.most_a;
  double& most_owner = walker_is_b ? sums.most_a : sums.most_b;
  if (total > most_walker) most_walker = total, (walker_is_b ? sums.edge_b : sums.edge_a) = edge;
  if (total > most_owner) most_owner = total, (walker_is_b ? sums.edge_a : sums.edge_b) = face;
}

template <class K>
void Walk<K>::run(Sums& sums) const {
  for (int e = 0; e < walker_edges.count; ++e) {
    if (!walker_edges.surface[e]) continue;
    const int w = (e + 1) % walker_edges.count;
    const Span span = inside(depths, owner_edges.count, e, w);
    if (span.from >= span.to) continue;
    const Vec2 start = walker.corner[e], along = walker.corner[w] - start;
    double at = span.from, slope = std::numeric_limits<double>::infinity();
    // Each turn presses the edge against one face, up to where the next one is nearer.
    while (at < span.to) {
      const Nearest nearest = nearest_from(depths, owner_edges, e, w, at, span.to, slope);
      if (nearest.face < 0) break;  // the last face of the envelope has been passed, up to rounding
      const double d0 = depths.at(nearest.face, e), d1 = depths.at(nearest.face, w);
      const Span pressed = crushed > 0 ? above(crushed, d0, d1, {at, nearest.until}) : Span{at, nearest.until};
      const auto phi = [&](double share) { return std::max(0.0, d0 + (d1 - d0) * share - crushed); };
      if (crushed <= 0 || pressed.from < pressed.to)
        press(e, nearest.face, start + pressed.from * along, start + pressed.to * along, phi(pressed.from),
              phi(pressed.to), sums);
      at = nearest.until;
      slope = nearest.slope;
    }
  }
}

ShearBefore<double> both_halves(const ContactMemory& m) {
  return {m.shear_elastic[0] + m.shear_elastic[1], m.shear_total[0] + m.shear_total[1], m.active[0] + m.active[1]};
}

/// Elastic shear energy let go where a contact parts [J].
double released_energy(const ContactMemory& m, double ks) {
  const ShearBefore<double> both = both_halves(m);
  double kept = 0;
  return released_energy(both, 0.0, ShearCompliance<double>(both.active, 0.0, ks), kept);
}

/// Elastic shear energy let go where two halves of unlike stress become one contact; never negative.
/// T_0^2 / 2 ks l_0 + T_1^2 / 2 ks l_1 is at least (T_0 + T_1)^2 / 2 ks (l_0 + l_1).
double merging_loss(const ContactMemory& m, double ks) {
  double sum = 0;
  for (const int h : {0, 1}) sum += 0.5 * m.shear_elastic[h] * m.shear_elastic[h] * inverse_or_zero(ks * m.active[h]);
  const ShearBefore<double> both = both_halves(m);
  return std::max(0.0, sum - 0.5 * both.elastic * both.elastic * inverse_or_zero(ks * both.active));
}

/// Velocity of b against a where they press each other.
Vec2 rate_at_centre(const PlacedPiece& a, const PlacedPiece& b, const Sums& sums, const Vec2& centre) {
  return b.velocity_at(sums.edge_b, centre) - a.velocity_at(sums.edge_a, centre);
}

/// Power of a remembered damping force in the motion of b against a, as rigid pieces [W]. That of two faces acted along
/// the normal, which is taken to be that of the force on b now, at `rate`.
double damping_power(const PlacedPiece& a, const PlacedPiece& b, const ContactMemory& m, const Vec2& force,
                     const Vec2& rate_now) {
  if ((m.state & contact_general) == 0) {
    const double size = force.norm();
    return size > 0 ? m.damping_force[0] * force.dot(rate_now) / size : 0;
  }
  const Vec2 rate = b.mean().velocity_at(a.origin) - a.mean().velocity_at(a.origin);
  return Vec2(m.damping_force[0], m.damping_force[1]).dot(rate) + m.damping_moment * (b.mean().spin - a.mean().spin);
}

/// Share of what the damping force of now does that the one remembered does, where both act alike.
double similarity(const ContactMemory& before, const ContactMemory& now) {
  const Vec2 was(before.damping_force[0], before.damping_force[1]), is(now.damping_force[0], now.damping_force[1]);
  const double size2 = is.squaredNorm();
  return (before.state & contact_general) != 0 && size2 > 0 ? std::clamp(was.dot(is) / size2, 0.0, 1.0) : 0.0;
}

/// Energy the damping takes in a step: with the mean of its force before and now. Pieces that deform move otherwise
/// than as rigid ones; for the force remembered that is made up for as it is for the one of now.
double damping_loss(const PlacedPiece& a, const PlacedPiece& b, const ContactMemory& before, const Sums& sums,
                    double dt, const OverlapResponse& out) {
  const Vec2 rate = rate_at_centre(a.mean(), b.mean(), sums, out.centre);
  double taken = sums.damped - damping_power(a, b, before, out.force, rate);
  if (!a.corner_velocity.empty() || !b.corner_velocity.empty())
    taken += similarity(before, out.memory) * (sums.damped + damping_power(a, b, out.memory, out.force, rate));
  return 0.5 * dt * taken;
}

/// Friction on the resultant, along t = left_of(n), at the centre of pressure.
void add_friction(const PlacedPiece& a, const PlacedPiece& b, const ContactMemory& before, const Coulomb& law,
                  const Sums& sums, std::span<Vec2> on_a, std::span<Vec2> on_b, OverlapResponse& out) {
  const double normal = sums.force.norm();
  if (!(normal > 0)) {
    out.lost_friction += released_energy(before, law.ks);
    return;
  }
  const Vec2 t = left_of(Vec2(sums.force / normal));
  // The law is asked as about one half of a face; either half then remembers half of it, good for two faces at any
  // step.
  HalfState<double> state{};
  state.length = sums.length;
  state.slip_rate = t.dot(rate_at_centre(a, b, sums, out.centre));
  state.slip_mean = t.dot(rate_at_centre(a.mean(), b.mean(), sums, out.centre));
  state.bonded = false;
  HalfResponse<double> half{};
  half.normal = normal;
  law.slide(state, sums.length, both_halves(before), half);
  add_at(on_a, a, sums.edge_a, out.centre, half.shear_total * t);
  add_at(on_b, b, sums.edge_b, out.centre, -half.shear_total * t);
  for (const int h : {0, 1}) {
    out.memory.shear_elastic[h] = 0.5 * half.shear_elastic;
    out.memory.shear_total[h] = 0.5 * half.shear_total;
    out.memory.active[h] = 0.5 * sums.length;
  }
  out.memory.slip += half.slip;
  out.lost_damping += half.lost_damping;
  out.lost_friction += half.lost_friction;
}

/// Two pieces that overlap, and how deep the corners of each lie in the other.
template <class K>
struct Overlapping {
  const PlacedPiece &a, &b;
  const PlacedEdges &edges_a, &edges_b;
  const Depths &b_in_a, &a_in_b;

  [[nodiscard]] Sums press(const K& law, double crushed, std::span<Vec2> on_a, std::span<Vec2> on_b) const {
    Sums sums;
    Walk<K>{a, edges_a, b, edges_b, b_in_a, law, crushed, true, on_a, on_b}.run(sums);
    Walk<K>{b, edges_b, a, edges_a, a_in_b, law, crushed, false, on_b, on_a}.run(sums);
    return sums;
  }
  /// Mean overlap above that at which the mortar crushes [m]. `springs`: without damping.
  /// force / (kn length) is the overlap of parallel faces with this mean pressure; law.crushing is fc / kn.
  [[nodiscard]] double excess(const K& springs, double crushed) const {
    std::array<Vec2, max_piece_corners> on_a, on_b;  // asked for by the walk, and left
    on_a.fill(Vec2::Zero()), on_b.fill(Vec2::Zero());
    const Sums sums = press(springs, crushed, on_a, on_b);
    return sums.length > 0 ? sums.force.norm() / (springs.kn * sums.length) - springs.crushing : -springs.crushing;
  }
  /// The depth by which the mortar is crushed now: such that the mean pressure of the springs is its strength at most.
  [[nodiscard]] double crushed_now(const K& law, const LawMemory<K>& own) const {
    if constexpr (!K::crushes)
      return 0;
    else {
      K springs = law;
      springs.beta = 0;
      return springs.crush(own, [&](double depth) { return excess(springs, depth); });
    }
  }
};

/// A lower bound of the distance of two pieces that are apart, 0 where neither shows it; fills their depths [m].
double separation(const PlacedPiece& a, const PlacedEdges& edges_a, const PlacedPiece& b, const PlacedEdges& edges_b,
                  Depths& b_in_a, Depths& a_in_b) {
  const double apart = b_in_a.fill(a, edges_a, b);
  return apart > 0 ? apart : a_in_b.fill(b, edges_b, a);
}

/// Keeps how far the mortar is crushed, and gives off what that takes.
template <class K>
void keep_crushed(const Overlapping<K>& pair, const ContactMemory& before, const LawMemory<K>& own, double depth,
                  const K& law, LawMemory<K>& after, OverlapResponse& out) {
  if constexpr (K::crushes) {
    if (!(depth > 0)) return;
    const bool touched = (before.state & contact_touching) != 0, general = (before.state & contact_general) != 0;
    out.lost_fracture = law.crushed_by(own, depth, crushing_force(pair.a, pair.b, law, depth), touched, general, after);
    out.memory.state |= contact_kept;
  }
}

template <class K>
OverlapResponse respond(const PlacedPiece& a, const PlacedPiece& b, const ContactMemory& before,
                        const LawMemory<K>& own, const K& law, std::span<Vec2> on_a, std::span<Vec2> on_b,
                        LawMemory<K>& after) {
  OverlapResponse out;
  const PlacedEdges edges_a(a), edges_b(b);
  static thread_local Depths b_in_a, a_in_b;  // large; filled anew at every call
  out.memory = before.parted();
  after = K::parted(own);
  // Where the two part, their elastic shear is let go, and the last damping force works for half a step more.
  const double merged = merging_loss(before, law.ks);
  out.lost_friction = merged + released_energy(before, law.ks);
  out.lost_damping = -0.5 * law.dt * damping_power(a, b, before, out.force, Vec2::Zero());
  out.separation = separation(a, edges_a, b, edges_b, b_in_a, a_in_b);
  if (out.separation > 0) return out;

  const Overlapping<K> pair{a, b, edges_a, edges_b, b_in_a, a_in_b};
  const double crushed = pair.crushed_now(law, own);
  const Sums sums = pair.press(law, crushed, on_a, on_b);
  if (!(sums.length > 0)) return out;
  out.touching = true;
  out.force = sums.force;
  out.length = sums.length;
  out.depth = sums.deepest;
  out.memory.slip = before.slip;
  out.memory.state |= contact_touching | contact_general;
  out.memory.damping_force[0] = sums.damping.x();
  out.memory.damping_force[1] = sums.damping.y();
  out.memory.damping_moment = sums.damping_moment;
  if (sums.pressure > 0) out.centre = sums.moment_arm / sums.pressure;
  out.lost_damping = damping_loss(a, b, before, sums, law.dt, out);
  if (sums.pressure > 0) {
    out.lost_friction = merged;
    add_friction(a, b, before, law, sums, on_a, on_b, out);
  }
  keep_crushed(pair, before, own, crushed, law, after, out);
  if constexpr (K::crushes) law.wear(after);
  return out;
}

}  // namespace

OverlapResponse respond_overlap(const PlacedPiece& a, const PlacedPiece& b, const Remembered& before,
                                const LawInUse& law, std::span<Vec2> on_a, std::span<Vec2> on_b, double* law_after) {
  assert(a.corner.size() <= max_piece_corners && b.corner.size() <= max_piece_corners);
  return with_kernel(law, [&]<class K>(const K& kernel) {
    LawMemory<K> after;
    const OverlapResponse out = respond<K>(a, b, before.contact, law_memory<K>(before.law), kernel, on_a, on_b, after);
    keep_law_memory<K>(after, law_after);
    return out;
  });
}

}  // namespace trilith
