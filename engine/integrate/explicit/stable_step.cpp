#include "integrate/explicit/stable_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "assembly/bearing_motion.hpp"
#include "assembly/bounds/local_springs.hpp"
#include "assembly/contact/contact_rows.hpp"
#include "assembly/element/rotary_inertia.hpp"
#include "assembly/whole_body.hpp"
#include "base/team.hpp"
#include "integrate/explicit/mass_scaling.hpp"
#include "law/bearing/dish.hpp"
#include "model/pose.hpp"

namespace trilith {
namespace {

/// Local stiffness and damping of the nodes and, if requested, of meshed bodies with a rigid motion as if they were
/// rigid.
struct Locals {
  std::vector<Local> node;
  std::vector<Local> whole;        ///< [body] about its centre of mass; empty: not requested
  std::vector<WholeBody<2>> body;  ///< [body] the rigid motion of each

  Local* whole_of(int b) { return whole.empty() || !body[b].moves() ? nullptr : &whole[b]; }
};

/// Adds a contact to the two end nodes of a face of a deformable body. The rows of w w' + (l/L)^2/12 [1 -1; -1 1], with
/// the shares w of the middle of the contact, are bounded by their sums of absolute values and the smaller of both
/// masses.
void add_to_face(const Model<2>& model, const std::array<int, 2>& node, const Vec2& from, const Vec2& to, double weight,
                 const ContactSprings& c, std::vector<Local>& locals) {
  const Vec2 along = to - from;
  const double size = along.squaredNorm(), share = std::clamp(along.dot(c.at - from) / size, 0.0, 1.0);
  const double spread = c.length * c.length / (6 * size), least = std::min(model.mass[node[0]], model.mass[node[1]]);
  for (const int i : {0, 1}) {
    const double k = (i == 0 ? 1 - share : share) + spread, scaled = weight * k * model.mass[node[i]] / least;
    add_spring(locals[node[i]], c.normal, c.law.normal * c.length, c.law.beta, scaled);
    add_spring(locals[node[i]], left_of(c.normal), c.law.shear * c.length, c.law.beta, scaled);
  }
}

/// Adds a spring along e through the skin point at `at`. At a pin the point turns with a second node. The two parts
/// then count twice, because (a + b)^2 <= 2 a^2 + 2 b^2.
void add_to_skin(const Model<2>& model, const State<2>& state, int skin, const Vec2& at, const Vec2& e, double k,
                 double beta, std::vector<Local>& locals) {
  const int n = model.skin_node[skin], t = model.skin_turn[skin];
  const Vec2 arm = at - state.position[n];
  if (n == t) return add_spring(locals[n], e, arm, k, beta, 0, Vec2::Zero(), 1);
  add_spring(locals[n], e, k, beta, 2);
  const double turning = 2 * k * cross(arm, e) * cross(arm, e);
  locals[t].k(2, 2) += turning, locals[t].c(2, 2) += beta * turning;
}

/// Adds a contact on the face of a frame between two sections. The weights at both sections are the share of the
/// contact's middle plus the contribution of its length. The shares are positive with sum 1, so (sum w v)^2 <= sum w
/// v^2.
void add_to_sections(const Model<2>& model, const State<2>& state, const Work<2>& work, const std::array<int, 2>& skin,
                     double weight, const ContactSprings& c, std::vector<Local>& locals) {
  const Vec2 from(work.skin[skin[0]].x, work.skin[skin[0]].y), to(work.skin[skin[1]].x, work.skin[skin[1]].y);
  const Vec2 along = to - from;
  const double size = along.squaredNorm(), share = std::clamp(along.dot(c.at - from) / size, 0.0, 1.0);
  const double spread = c.length * c.length / (6 * size);
  for (const int i : {0, 1}) {
    const double k = weight * c.length * ((i == 0 ? 1 - share : share) + spread);
    const Vec2& at = i == 0 ? from : to;
    add_to_skin(model, state, skin[i], at, c.normal, c.law.normal * k, c.law.beta, locals);
    add_to_skin(model, state, skin[i], at, left_of(c.normal), c.law.shear * k, c.law.beta, locals);
  }
}

/// The face of a piece whose middle is nearest to a contact of general shape.
std::array<int, 2> nearest_face(const Model<2>& model, const Work<2>& work, int piece, const Vec2& at) {
  std::array<int, 2> best{};
  double least = unbounded;
  for (int c = 0, count = model.corners_of(piece), first = model.piece_first[piece]; c < count; ++c) {
    const int p = model.corner_skin[first + c], q = model.corner_skin[first + (c + 1) % count];
    const Vec2 middle(0.5 * (work.skin[p].x + work.skin[q].x), 0.5 * (work.skin[p].y + work.skin[q].y));
    const double distance = (middle - at).squaredNorm();
    if (distance < least) least = distance, best = {p, q};
  }
  return best;
}

/// Bodies from `first` to before `last`.
struct BodyRange {
  int first, last;
  [[nodiscard]] bool has(int body) const { return first <= body && body < last; }
  /// False if no side of a pair can be in the range: its second body comes after its first.
  [[nodiscard]] bool may_have(const Model<2>& model, const NearPair& pair) const {
    return model.piece_body[pair.piece_b] >= first && model.piece_body[pair.piece_a] < last;
  }
};

/// Adds the normal and shear springs of a contact to its bodies in `range`. `face`: skin points of the face on either
/// side, or {-1, -1} for a contact of general shape.
void add_contact(const Model<2>& model, const State<2>& state, const Work<2>& work, const BodyRange& range,
                 const NearPair& pair, const ContactSprings& c, const std::array<std::array<int, 2>, 2>& face,
                 Locals& locals) {
  const Vec2 &at = c.at, &n = c.normal, t = left_of(n);
  const double length = c.length;
  const ContactTangent& law = c.law;
  const int piece[2] = {pair.piece_a, pair.piece_b},
            body[2] = {model.piece_body[pair.piece_a], model.piece_body[pair.piece_b]};
  const int node[2] = {model.bodies[body[0]].first_node, model.bodies[body[1]].first_node};
  for (const int side : {0, 1}) {
    if (!range.has(body[side])) continue;
    const double weight = model.body_moves(body[1 - side]) ? 2 : 1;
    if (Local* whole = locals.whole_of(body[side])) {
      const Vec2 arm = at - locals.body[body[side]].centre;
      add_spring(*whole, n, arm, law.normal * length, law.beta, length, t, weight);
      add_spring(*whole, t, arm, law.shear * length, law.beta, length, t, weight);
    }
    if (!model.bodies[body[side]].is_rigid()) {
      const std::array<int, 2> ends = face[side][0] >= 0 ? face[side] : nearest_face(model, work, piece[side], at);
      if (model.bodies[body[side]].skin_is_sections()) {
        add_to_sections(model, state, work, ends, weight, c, locals.node);
        continue;
      }
      const auto place = [&](int s) { return Vec2(work.skin[s].x, work.skin[s].y); };
      add_to_face(model, {model.skin_node[ends[0]], model.skin_node[ends[1]]}, place(ends[0]), place(ends[1]), weight,
                  c, locals.node);
      continue;
    }
    // A rigid body: springs along n and t at the middle of the contact, both distributed over its length.
    Local& local = locals.node[node[side]];
    const Vec2 arm = at - state.position[node[side]];
    add_spring(local, n, arm, law.normal * length, law.beta, length, t, weight);
    add_spring(local, t, arm, law.shear * length, law.beta, length, t, weight);
  }
}

/// Adds the springs of all touching contacts of bodies in `range`, in the order of rows. Opposed faces act over their
/// shared length, general shapes over their length in contact. The stiffness is the largest of the law at the present
/// depth.
void add_faces(const Model<2>& model, const State<2>& state, const Work<2>& work, const BodyRange& range,
               Locals& locals) {
  for (std::size_t row = 0; row < work.pairs.size(); ++row) {
    const NearPair& p = work.pairs[row];
    if (!range.may_have(model, p)) continue;
    const ContactMemory& m = work.contacts.memory[row];
    if ((m.state & contact_touching) == 0 || (m.state & contact_general) != 0) continue;
    const FaceOverlap<double> o = face_overlap(work, p);
    const Vec2 d(o.dx, o.dy), n(o.dy, -o.dx), origin(work.skin[p.a0].x, work.skin[p.a0].y);
    const ContactTangent law = spring_tangent(model, p.law, -std::min(o.gap_lo, o.gap_hi));
    add_contact(model, state, work, range, p, {origin + 0.5 * (o.lo + o.hi) * d, n, o.shared, law},
                {{{p.a0, p.a1}, {p.b0, p.b1}}}, locals);
  }
  // Springs along the resultant, at the centre of pressure.
  for (const GeneralContact<2>& g : work.general_touching) {
    const NearPair& p = work.pairs[g.row];
    if (!range.may_have(model, p)) continue;
    const double size = g.force.norm();
    if (!(size > 0)) continue;
    const ContactTangent law = spring_tangent(model, p.law, g.depth);
    add_contact(model, state, work, range, p, {g.centre, g.force / size, g.size, law}, {{{-1, -1}, {-1, -1}}}, locals);
  }
}

/// Adds a spring along e through `at` (e = 0: about it) that is attached to several nodes: row sums of v v' for the
/// nodal forces v of a unit force, scaled by the masses.
void add_to_nodes(const Model<2>& model, const State<2>& state, const Attachment<2>& attachment, const Vec2& at,
                  const Vec2& e, double tangent, double dashpot, std::vector<Local>& locals) {
  std::vector<Vec2> force(static_cast<std::size_t>(model.nodes()), Vec2::Zero());
  std::vector<double> couple(attachment.turns ? force.size() : 0, 0.0);
  const double moment = e.isZero() ? 1 : cross(Vec2(at - pose_at(model, state, attachment).place), e);
  apply_force(model, state, attachment, e, moment, force, couple);
  std::set<int> nodes(attachment.node.begin(), attachment.node.begin() + attachment.nodes);
  if (attachment.turns) nodes.insert(attachment.turn.begin(), attachment.turn.begin() + attachment.nodes);
  double sum = 0;
  for (const int n : nodes) {
    sum += force[n].cwiseAbs().sum() / std::sqrt(model.mass[n]);
    if (attachment.turns) sum += std::abs(couple[n]) / std::sqrt(model.inertia[n]);
  }
  for (const int n : nodes)
    for (const int k : {0, 1, 2}) {
      if (k == 2 && !attachment.turns) continue;
      const double part = k == 2 ? couple[n] : force[n][k], mass = k == 2 ? model.inertia[n] : model.mass[n];
      // Row i of v v' scaled by 1/sqrt(m_i m_j) sums to sum |v_i|/sqrt(m_i); `bound` divides by m_i later.
      const double row = std::abs(part) * sum * std::sqrt(mass);
      locals[n].k(k, k) += tangent * row, locals[n].c(k, k) += dashpot * row;
    }
}

void add_bearings(const Model<2>& model, const State<2>& state, const Work<2>& work, Locals& locals) {
  for (std::size_t i = 0; i < model.bearings.size(); ++i) {
    // A waiting bearing counts already, because it may become live between two estimates.
    if (!is_live(work.bearing[i].status) && work.bearing[i].status != BearingStatus::waiting) continue;
    const Bearing<2>& b = model.bearings[i];
    const std::array<const Attachment<2>*, 2> attachment{&b.end_a, &b.end_b};
    const std::array<int, 2> body{b.body_a, b.body_b};
    const Vec2 at = pose_at(model, state, b.end_b).place;
    const Turn axes(pose_at(model, state, b.end_a).rotation + b.angle);
    // On a dish the axial law acts along the normal of the dish.
    const double slope =
        has_dish(b) ? Dish<2>(b, bearing_motion(model, state, i).counted(work.bearing[i])).slope[0] : 0;
    for (int k = 0; k < 3; ++k) {
      double tangent = 0, dashpot = 0;
      std::visit(
          [&](const auto& l) {
            if constexpr (!std::is_same_v<std::decay_t<decltype(l)>, std::monostate>)
              tangent = l.tangent(), dashpot = l.dashpot();
          },
          b.law[k]);
      const Vec2 e = k == turning ? Vec2::Zero() : axes.apply(k == along ? Vec2(1, 0) : Vec2(-slope, 1));
      for (const int side : {0, 1}) {
        const double weight = model.body_moves(body[1 - side]) ? 2 : 1;
        const auto add = [&](Local& local, const Vec2& arm) {
          const Eigen::Vector3d v(e.x(), e.y(), k == turning ? 1.0 : cross(arm, e));
          local.k += weight * tangent * v * v.transpose();
          local.c += weight * dashpot * v * v.transpose();
        };
        if (Local* whole = locals.whole_of(body[side])) add(*whole, at - locals.body[body[side]].centre);
        if (!attachment[side]->is_rigid()) {
          add_to_nodes(model, state, *attachment[side], at, e, weight * tangent, weight * dashpot, locals.node);
          continue;
        }
        add(locals.node[attachment[side]->node[0]], at - state.position[attachment[side]->node[0]]);
      }
    }
  }
}

/// Rates of contacts and bearings on a meshed body that moves as if it were rigid. A constraint along some axis does
/// not increase any eigenvalue.
RateBound rigid_rates(const Work<2>& work, int body, const Locals& locals) {
  const WholeBody<2>& whole = locals.body[body];
  if (!whole.moves()) return {};
  constexpr std::array all{true, true, true};
  const RateBound own = rate_bound(locals.whole[body], whole.mass, whole.inertia, all);
  const RateBound& around = work.around_bound[body];
  return {std::max(own.stiffness, around.stiffness), std::max(own.damping, around.damping)};
}

/// The rotary inertia of a body of one element is smaller than the inertia of its lumped masses by the factor `ratio`.
/// The element does not resist rotation. See assembly/element/rotary_inertia.hpp.
void bound_rotation(double ratio, const Model<2>& model, BodyRates& out) {
  if (ratio == 1) return;
  const RateBound turning{ratio * out.contacts.stiffness, ratio * (out.contacts.damping + model.mass_damping)};
  out.plain = std::min(out.plain, step_for(turning.stiffness, turning.damping));
  out.rigid.stiffness *= ratio, out.rigid.damping *= ratio;
}

/// Rates of a body that moves.
BodyRates rates_of(const Model<2>& model, const State<2>& state, const Work<2>& work, const Locals& locals, int b,
                   bool as_rigid) {
  const Body& body = model.bodies[b];
  // The stiffer of the stiffest face of the body and the present contacts. The elements are added to either.
  RateBound contacts{work.face_bound[b].stiffness, work.face_bound[b].damping};
  // The largest bound of any node bounds the whole body.
  for (int node = body.first_node; node < body.first_node + body.nodes; ++node)
    if (model.moves(node)) contacts = larger_rates(model, node, locals.node[node], contacts);
  const RateBound& own = model.element_bound[b];
  BodyRates out{own,
                contacts,
                {},
                step_for(contacts.stiffness + own.stiffness, contacts.damping + (own.damping + model.mass_damping))};
  if (as_rigid && is_of_elements(body)) out.rigid = rigid_rates(work, b, locals);
  if (info_of(body.kind).resistance == Resistance::elements)
    bound_rotation(lumped_over_own(model, state, b), model, out);
  return out;
}

/// Fewest bodies per thread that justify a second thread, and bodies per chunk of a thread (about 10 microseconds).
constexpr int least_added = 256, rated_stretch = 64;

}  // namespace

double step_for(double stiffness, double damping) {
  if (!(stiffness > 0)) return damping > 0 ? std::min(longest_step, 2 / damping) : longest_step;
  return std::min(longest_step, (std::sqrt(4 * stiffness + damping * damping) - damping) / stiffness);
}

std::vector<BodyRates> body_rates(const Model<2>& model, const State<2>& state, const Work<2>& work, bool as_rigid) {
  Locals locals;
  locals.node.resize(static_cast<std::size_t>(model.nodes()));
  if (as_rigid) {
    locals.whole.resize(model.bodies.size()), locals.body.resize(model.bodies.size());
    for (std::size_t b = 0; b < model.bodies.size(); ++b)
      if (is_of_elements(model.bodies[b])) locals.body[b] = whole_body(model, state, static_cast<int>(b));
  }
  // Each thread sums the contacts of its range of bodies.
  const int bodies = static_cast<int>(model.bodies.size());
  const int added = std::max(least_added, (bodies + work.threads - 1) / std::max(1, work.threads));
  share(work.threads, bodies, added, [&](int first, int last, int /*thread*/) {
    add_faces(model, state, work, {first, last}, locals);
  });
  add_bearings(model, state, work, locals);
  std::vector<BodyRates> out(model.bodies.size());
  share(work.threads, bodies, rated_stretch, [&](int first, int last, int /*thread*/) {
    for (int b = first; b < last; ++b)
      if (model.body_moves(b)) out[b] = rates_of(model, state, work, locals, b, as_rigid);
  });
  return out;
}

StableStep stable_step(const Model<2>& model, const State<2>& state, const Work<2>& work) {
  const bool is_scaled = !state.added_share.empty();
  const std::vector<BodyRates> rates = body_rates(model, state, work, is_scaled);
  StableStep found;
  found.dt = longest_step;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    if (!model.body_moves(static_cast<int>(b))) continue;
    if (is_scaled && state.added_share[b] > 0) {
      shorten_to_scaled(rates[b], state.added_share[b], model.mass_damping, static_cast<int>(b), found);
      continue;
    }
    const double k = rates[b].contacts.stiffness + rates[b].elements.stiffness;
    const double c = rates[b].contacts.damping + (rates[b].elements.damping + model.mass_damping);
    if (rates[b].plain < found.dt) found = {rates[b].plain, static_cast<int>(b), k, c};
  }
  return found;
}

double turning_step(const Model<2>& /*model*/, const State<2>& /*state*/) {
  return longest_step;
}

template <int D>
StableStep unbanded_step(Model<D> model, const State<D>& state, const Work<D>& work) {
  for (RateBound& own : model.element_bound)
    if (own.unbanded > 0) own.stiffness = own.unbanded;
  return stable_step(model, state, work);
}

template StableStep unbanded_step(Model<2>, const State<2>&, const Work<2>&);
template StableStep unbanded_step(Model<3>, const State<3>&, const Work<3>&);

double settled_step(double stable, double safety) {
  // The rungs 2^(k/8) from 0.5 to below 1.
  constexpr std::array<double, 8> rungs{0x1.0000000000000p-1, 0x1.172b83c7d517bp-1, 0x1.306fe0a31b715p-1,
                                        0x1.4bfdad5362a27p-1, 0x1.6a09e667f3bcdp-1, 0x1.8ace5422aa0dbp-1,
                                        0x1.ae89f995ad3adp-1, 0x1.d5818dcfba487p-1};
  int exponent = 0;
  const double wanted = stable * safety, share = std::frexp(wanted, &exponent);
  if (!(wanted > 0 && std::isfinite(wanted))) return wanted;
  return std::ldexp(*(std::upper_bound(rungs.begin(), rungs.end(), share) - 1), exponent);
}

}  // namespace trilith
