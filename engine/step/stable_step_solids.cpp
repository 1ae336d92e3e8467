// The longest stable step of rigid solids in space, from the areas in contact.
//
// Comes in: for each contact its area A, middle, normal n, arms and radius (see SolidPressure) and the tangent of its
// law. Each body then has springs along n and two lines across, b = (e, arm x e), and turns against kn A (a x n)(a x
// n)' for the two arms a of its second moments, and ks A radius^2 about n. Goes out: the bound of lambda over all
// bodies. Bearings are springs and dashpots along their axes and about them.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/solid_pressure.hpp"
#include "shape/polyhedron.hpp"
#include "step/bearing_motion.hpp"
#include "step/stable_step.hpp"

namespace trilith {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
/// Depth of the contacts that a sphere in none is ready for, as a share of its radius: deeper than any should be. A
/// blow begins without stiffness, and it takes several steps for its energy to come out right.
constexpr double usual_cap = 0.3;

using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Stiffness and damping of one body over its mass and principal moments: columns of sqrt(k) b and sqrt(c) b.
struct LocalSolid {
  Matrix6 k = Matrix6::Zero(), c = Matrix6::Zero();

  void add(const Vector6& b, double stiffness, double beta) {
    const Matrix6 m = stiffness * b * b.transpose();
    k += m, c += beta * m;
  }
  /// The same of a turn alone.
  void add_turn(const Vec3& b, double stiffness, double beta) {
    const Eigen::Matrix3d m = stiffness * b * b.transpose();
    k.bottomRightCorner<3, 3>() += m, c.bottomRightCorner<3, 3>() += beta * m;
  }
};

/// A body as springs see it: how a motion of 1 along each of its own axes moves what hangs on it.
struct ScaledNode {
  Turn3 turn;
  double mass;   ///< root of it
  Vec3 inertia;  ///< roots of the principal moments

  /// A translation e at `arm` from the node, both in the axes of the world.
  [[nodiscard]] Vector6 along(const Vec3& e, const Vec3& arm) const {
    Vector6 b;
    b.head<3>() = turn.undo(e) / mass;
    b.tail<3>() = turn.undo(cross(arm, e)).cwiseQuotient(inertia);
    return b;
  }
  /// A turn about e.
  [[nodiscard]] Vec3 about(const Vec3& e) const { return turn.undo(e).cwiseQuotient(inertia); }
};

ScaledNode scaled_node(const Model<3>& model, int node, const UnitQuaternion& rotation) {
  return {turn_of(rotation), std::sqrt(model.mass[node]), model.inertia[node].cwiseSqrt()};
}

/// An area under pressure, at `arm` from the node; where its force points nowhere, as stiff along every line.
struct AreaSprings {
  Vec3 arm, normal;
  double area, radius;
  std::array<Vec3, 2> spread;
  ContactTangent law;
};

/// Springs on the nodes of a fit: sums of rows of the stiffness, scaled by the masses, of the largest of all
/// directions. A motion of the nodes moves the middle of the area by sum w_i u_i, and its second moments by the arms; a
/// dyad of weights v v' has the row |v_i| sum |v_j|, and is added for each.
struct NodeRows {
  std::vector<double> k, c;  ///< [node] 1/s2, 1/s

  /// `weight`: [node of the fit] what a unit force gives each.
  void add(const Model<3>& model, const Fit& fit, const std::array<double, most_fit_nodes>& weight, double stiffness,
           double dashpot) {
    double sum = 0;
    for (int i = 0; i < fit.nodes; ++i)
      sum +=
          std::abs(weight[static_cast<std::size_t>(i)]) / std::sqrt(model.mass[fit.node[static_cast<std::size_t>(i)]]);
    for (int i = 0; i < fit.nodes; ++i) {
      const auto n = static_cast<std::size_t>(fit.node[static_cast<std::size_t>(i)]);
      const double row = std::abs(weight[static_cast<std::size_t>(i)]) * sum / std::sqrt(model.mass[n]);
      k[n] += stiffness * row, c[n] += dashpot * row;
    }
  }
};

NodeRows rows_of(const Model<3>& model) {
  const std::size_t nodes = model.fits.empty() ? 0 : model.mass.size();
  return {std::vector<double>(nodes), std::vector<double>(nodes)};
}

/// What a unit force at a point [m] gives each node of a fit, and a unit force along `arm` less one at its foot.
std::array<double, most_fit_nodes> weights_at(const Model<3>& model, const Fit& fit, const Fitted& now, const Vec3& at,
                                              bool is_arm) {
  const Vec3 s = now.axes.transpose() * (is_arm ? at : Vec3(at - now.place));
  std::array<double, most_fit_nodes> out{};
  for (int i = 0; i < fit.nodes; ++i) {
    const double* const w = &model.fit_number[static_cast<std::size_t>(fit.first_number + 4 * i)];
    out[static_cast<std::size_t>(i)] = (is_arm ? 0 : w[0]) + w[1] * s.x() + w[2] * s.y() + w[3] * s.z();
  }
  return out;
}

/// An area under pressure on a fit: it stands as stiff along every line as along its stiffest.
void add_area_to_fit(const Model<3>& model, const Fit& fit, const Fitted& now, const AreaSprings& s, double weight,
                     NodeRows& rows) {
  const double stiffness = weight * s.area * std::max(s.law.normal, s.law.shear), dashpot = s.law.beta * stiffness;
  rows.add(model, fit, weights_at(model, fit, now, s.arm, false), stiffness, dashpot);
  for (const Vec3& a : s.spread) rows.add(model, fit, weights_at(model, fit, now, a, true), stiffness, dashpot);
}

void add_area(const AreaSprings& s, const ScaledNode& node, double weight, LocalSolid& local) {
  const bool known = s.normal.squaredNorm() > 0;
  const Vec3 n = known ? s.normal : Vec3(Vec3::UnitZ()), across = line_across(n), other = cross(n, across);
  const double normal = weight * s.area * (known ? s.law.normal : std::max(s.law.normal, s.law.shear)),
               shear = weight * s.area * (known ? s.law.shear : std::max(s.law.normal, s.law.shear));
  local.add(node.along(n, s.arm), normal, s.law.beta);
  for (const Vec3& e : {across, other}) local.add(node.along(e, s.arm), shear, s.law.beta);
  for (const Vec3& a : s.spread) local.add_turn(node.about(cross(a, n)), normal, s.law.beta);
  local.add_turn(node.about(n), shear * s.radius * s.radius, s.law.beta);
}

/// At least the largest eigenvalue of a matrix that has none below 0: the fourth root of the norm of its fourth power.
double largest_bound(const Matrix6& m) {
  const Matrix6 square = m * m, fourth = square * square;
  return std::sqrt(std::sqrt(fourth.norm()));
}

ContactTangent solid_tangent(const Model<3>& model, int law, double depth) {
  return with_kernel({model.laws[law], model.thickness, 0}, [&](const auto& kernel) { return kernel.tangent(depth); });
}

/// Area, middle and second moments of a face of a piece, in the axes of its body.
AreaSprings face_springs(const ConvexSolid& solid, int face, const ContactTangent& law) {
  const std::vector<Vec3>& corner = solid.shape.corners;
  const std::span<const int> loop = solid.shape.faces[face];
  const Vec3 origin = corner[static_cast<std::size_t>(loop[0])], n = solid.normals[static_cast<std::size_t>(face)];
  double area = 0;
  Vec3 first = Vec3::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    const Vec3 p = corner[static_cast<std::size_t>(loop[i])] - origin,
               q = corner[static_cast<std::size_t>(loop[i + 1])] - origin, sum = p + q;
    const double part = 0.5 * n.dot(cross(p, q));
    area += part, first += part / 3 * sum;
    second += part / 12 * (p * p.transpose() + q * q.transpose() + sum * sum.transpose());
  }
  const Vec3 middle = first / area;
  const Eigen::Matrix3d about = second / area - middle * middle.transpose();
  const Vec3 x = line_across(n), y = cross(n, x);
  return {origin + middle,
          n,
          area,
          std::sqrt(about.trace()),
          spread_arms(x.dot(about * x), x.dot(about * y), y.dot(about * y), x, y),
          law};
}

/// The disc in which a plane cuts a sphere as deep as usual_cap of its radius, lowest of it.
AreaSprings cap_springs(const ConvexSolid& solid, const ContactTangent& law) {
  const double r = solid.radius, area = std::numbers::pi * usual_cap * (2 - usual_cap) * r * r;
  const Vec3 n = Vec3::UnitZ(), lowest = solid.shape.corners[0] - (1 - usual_cap) * r * n;
  return {lowest, n, area, 8.0 / 15 * std::sqrt(area / std::numbers::pi), {Vec3::Zero(), Vec3::Zero()}, law};
}

/// What displacement and velocity of one direction can do to its force.
struct DirectionStiffness {
  double tangent = 0, dashpot = 0;
};
DirectionStiffness stiffness_of(const DirectionLaw& law) {
  return std::visit(
      [](const auto& l) -> DirectionStiffness {
        if constexpr (std::is_same_v<std::decay_t<decltype(l)>, std::monostate>)
          return {};
        else
          return {l.tangent(), l.dashpot()};
      },
      law);
}

/// A spring through a point, or one about an axis, which has forces across as far apart as the nodes are.
void add_spring_to_fit(const Model<3>& model, const State<3>& state, int carrier, const Vec3& at, bool along,
                       double weight, const DirectionStiffness& s, NodeRows& rows) {
  const Fit& fit = model.fits[static_cast<std::size_t>(-1 - carrier)];
  const Fitted now = fitted(model, fit, state.position, state.velocity);
  if (along)
    return rows.add(model, fit, weights_at(model, fit, now, at, false), weight * s.tangent, weight * s.dashpot);
  for (const Vec3& e : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitZ())})
    rows.add(model, fit, weights_at(model, fit, now, e, true), weight * s.tangent, weight * s.dashpot);
}

/// A spring and a dashpot along each axis of every bearing through b's point, and about it. One that waits counts
/// already: it may go live between two estimates.
void add_bearings(const Model<3>& model, const State<3>& state, const Work<3>& work, std::vector<LocalSolid>& locals,
                  NodeRows& rows) {
  for (std::size_t i = 0; i < model.bearings.size(); ++i) {
    if (!is_live(work.bearing[i].status) && work.bearing[i].status != BearingStatus::waiting) continue;
    const Bearing<3>& b = model.bearings[i];
    const Vec3 at = point_of(model, state, b.end_b);
    const Turn3 turn = turn_of(motion_of(model, state, b.end_a.node[0]).rotation * b.angle);
    const std::array axes{turn.x(), turn.y(), turn.z()};
    const DirectionStiffness both = stiffness_of(b.horizontal);
    for (std::size_t k = 0; k < 6; ++k) {
      DirectionStiffness s = stiffness_of(b.law[k]);
      if (k < 2) s.tangent += both.tangent, s.dashpot += both.dashpot;
      for (const auto& [body, other] : {std::pair(b.body_a, b.body_b), std::pair(b.body_b, b.body_a)}) {
        if (!model.body_moves(body)) continue;
        const double weight = model.body_moves(other) ? 2 : 1;
        const int n = body == b.body_a ? b.end_a.node[0] : b.end_b.node[0];
        if (n < 0) {
          add_spring_to_fit(model, state, n, at, k < 3, weight, s, rows);
          continue;
        }
        const ScaledNode node = scaled_node(model, n, state.rotation[n]);
        Vector6 v = Vector6::Zero();
        if (k < 3)
          v = node.along(axes[k], at - state.position[n]);
        else
          v.tail<3>() = node.about(axes[k - 3]);
        locals[n].k += weight * s.tangent * v * v.transpose();
        locals[n].c += weight * s.dashpot * v * v.transpose();
      }
    }
  }
}

/// The stiffest law that a body's surface has with any other.
ContactTangent stiffest_law(const Model<3>& model, const Body& body) {
  ContactTangent most{0, 0, 0};
  for (int other = 0; other < model.surfaces; ++other) {
    const int law = model.law_of[body.surface * model.surfaces + other];
    if (law < 0) continue;
    const ContactTangent t = solid_tangent(model, law, 0);
    most = {std::max(most.normal, t.normal), std::max(most.shear, t.shear), std::max(most.beta, t.beta)};
  }
  return most;
}

/// The same of the faces of a piece that deforms.
void add_stiffest_fit(const Model<3>& model, int piece, const ContactTangent& law, NodeRows& rows, RateBound& most) {
  const ConvexSolid& solid = model.piece_solid[static_cast<std::size_t>(piece)];
  const Vec3& origin = model.start_position[static_cast<std::size_t>(model.node_of_piece(piece))];
  for (int f = 0; f < solid.shape.faces.count(); ++f) {
    if (!solid.is_surface(f)) continue;
    const Fit& fit = model.fits[static_cast<std::size_t>(-1 - model.carrier_of(piece, f))];
    for (int i = 0; i < fit.nodes; ++i) rows.k[fit.node[i]] = rows.c[fit.node[i]] = 0;
    AreaSprings springs = face_springs(solid, f, law);
    springs.arm += origin;
    add_area_to_fit(model, fit, fitted(model, fit, model.start_position, model.start_velocity), springs, 2, rows);
    for (int i = 0; i < fit.nodes; ++i) {
      most.stiffness = std::max(most.stiffness, rows.k[fit.node[i]]);
      most.damping = std::max(most.damping, rows.c[fit.node[i]]);
    }
  }
}

/// On its stiffest face, against a body that moves as well.
RateBound on_stiffest_face(const Model<3>& model, const Body& body, NodeRows& rows) {
  const ContactTangent law = stiffest_law(model, body);
  RateBound most;
  if (!(law.normal > 0)) return most;
  for (int p = body.first_piece; p < body.first_piece + body.pieces; ++p) {
    const ConvexSolid& solid = model.piece_solid[p];
    if (model.is_fitted(p)) {
      add_stiffest_fit(model, p, law, rows, most);
      continue;
    }
    const ScaledNode node = scaled_node(model, model.node_of_piece(p), UnitQuaternion{});
    if (solid.is_sphere()) {
      LocalSolid local;
      add_area(cap_springs(solid, law), node, 2, local);
      most.stiffness = std::max(most.stiffness, largest_bound(local.k));
      most.damping = std::max(most.damping, largest_bound(local.c));
    }
    for (int f = 0; f < solid.shape.faces.count(); ++f) {
      if (!solid.is_surface(f)) continue;
      LocalSolid local;
      add_area(face_springs(solid, f, law), node, 2, local);
      most.stiffness = std::max(most.stiffness, largest_bound(local.k));
      most.damping = std::max(most.damping, largest_bound(local.c));
    }
  }
  return most;
}

}  // namespace

void bound_faces(const Model<3>& model, Work<3>& work) {
  work.face_bound.assign(model.bodies.size(), {});
  NodeRows rows = rows_of(model);
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    if (model.body_moves(static_cast<int>(b))) work.face_bound[b] = on_stiffest_face(model, model.bodies[b], rows);
}

/// What holds a body about some axes alone makes no eigenvalue larger, so it is not asked for.
StableStep stable_step(const Model<3>& model, const State<3>& state, const Work<3>& work) {
  std::vector<LocalSolid> locals(model.mass.size());
  std::vector<ScaledNode> nodes;
  nodes.reserve(locals.size());
  for (int n = 0; n < model.nodes(); ++n) nodes.push_back(scaled_node(model, n, state.rotation[n]));
  NodeRows rows = rows_of(model);
  for (const GeneralContact<3>& contact : work.general_touching) {
    const ContactArea& area = work.solids.areas[static_cast<std::size_t>(contact.row)];
    const NearPair& pair = work.pairs[contact.row];
    const int body[2] = {model.piece_body[pair.piece_a], model.piece_body[pair.piece_b]};
    const int node[2] = {model.node_of_piece(pair.piece_a), model.node_of_piece(pair.piece_b)};
    const ContactTangent law = solid_tangent(model, pair.law, contact.depth);
    for (const int side : {0, 1}) {
      if (!model.body_moves(body[side])) continue;
      const double weight = model.body_moves(body[1 - side]) ? 2 : 1;
      if (model.is_fitted(side == 0 ? pair.piece_a : pair.piece_b)) {
        const int carrier =
            side == 0 ? model.carrier_of(pair.piece_a, area.face_a) : model.carrier_of(pair.piece_b, area.face_b);
        const auto i = static_cast<std::size_t>(-1 - carrier);
        add_area_to_fit(model, model.fits[i], work.solids.fitted[i],
                        {area.middle, area.normal, area.area, area.radius, area.arm, law}, weight, rows);
        continue;
      }
      const int n = node[side];
      add_area({area.middle - state.position[n], area.normal, area.area, area.radius, area.arm, law},
               nodes[static_cast<std::size_t>(n)], weight, locals[n]);
    }
  }
  add_bearings(model, state, work, locals, rows);
  StableStep found;
  found.dt = longest_step;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    if (!model.body_moves(static_cast<int>(b))) continue;
    // What contacts and bearings add to the frequencies of beams or elements is at most what they make of the nodes
    // alone.
    const bool turn = model.bodies[b].nodes_turn();
    const RateBound beams = model.element_bound.empty() ? RateBound{} : model.element_bound[b];
    for (int n = model.bodies[b].first_node; n < model.bodies[b].first_node + model.bodies[b].nodes; ++n) {
      const double k = beams.stiffness +
                       std::max(work.face_bound[b].stiffness, turn ? largest_bound(locals[n].k) : rows.k[n]),
                   c = beams.damping +
                       std::max(work.face_bound[b].damping, turn ? largest_bound(locals[n].c) : rows.c[n]) +
                       model.mass_damping;
      const double dt = step_for(k, c);
      if (dt < found.dt) found = {dt, static_cast<int>(b), k, c};
    }
  }
  return found;
}

}  // namespace trilith
