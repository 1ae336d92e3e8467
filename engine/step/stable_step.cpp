#include "step/stable_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "step/contact_rows.hpp"

namespace trilith {
namespace {

constexpr double longest_step = 0.1;

/// Symmetric 3 x 3 of one body about its node: (x, y, rotation).
struct Local {
  Eigen::Matrix3d k = Eigen::Matrix3d::Zero(), c = Eigen::Matrix3d::Zero();
};

/// A spring of stiffness k along unit direction e at `arm` from the node, spread over `length` along `spread`.
void add_spring(Local& local, const Vec2& e, const Vec2& arm, double k, double beta, double length, const Vec2& spread,
                double weight) {
  const Eigen::Vector3d b(e.x(), e.y(), cross(arm, e));
  Eigen::Matrix3d m = weight * k * b * b.transpose();
  const double lever = cross(spread, e);
  m(2, 2) += weight * k * lever * lever * length * length / 12;
  local.k += m;
  local.c += beta * m;
}

/// Normal and shear springs of a contact of given length at `at`, normal n, for both of its bodies.
void add_contact(const Model<2>& model, const State<2>& state, int body_a, int body_b, const Vec2& at, const Vec2& n,
                 double length, const FaceLaw& law, std::vector<Local>& locals) {
  const Vec2 t = left_of(n);
  const int node[2] = {model.bodies[body_a].first_node, model.bodies[body_b].first_node};
  for (const int side : {0, 1}) {
    const double weight = model.moves(node[1 - side]) ? 2 : 1;
    Local& local = locals[node[side]];
    const Vec2 arm = at - state.position[node[side]];
    add_spring(local, n, arm, law.kn * length, law.beta, length, t, weight);
    add_spring(local, t, arm, law.ks * length, law.beta, length, t, weight);
  }
}

void add_faces(const Model<2>& model, const State<2>& state, const Work<2>& work, std::vector<Local>& locals) {
  for (std::size_t row = 0; row < work.pairs.size(); ++row) {
    const ContactMemory& m = work.memory[row];
    if ((m.state & contact_touching) == 0 || (m.state & contact_general) != 0) continue;
    const NearPair& p = work.pairs[row];
    const auto ends = [&](int i, int j) {
      const SkinMotion &a = work.skin[i], &b = work.skin[j];
      return FaceEnds<double>{a.x, a.y, b.x, b.y, 0, 0, 0, 0};
    };
    const FaceOverlap<double> o(ends(p.a0, p.a1), ends(p.b0, p.b1));
    const Vec2 d(o.dx, o.dy), n(o.dy, -o.dx), origin(work.skin[p.a0].x, work.skin[p.a0].y);
    add_contact(model, state, model.piece_body[p.piece_a], model.piece_body[p.piece_b],
                origin + 0.5 * (o.lo + o.hi) * d, n, o.shared, face_law(model, p.law, 0), locals);
  }
  for (const GeneralContact& g : work.general_touching) {
    const double size = g.force.norm();
    if (!(size > 0)) continue;
    const NearPair& p = work.pairs[g.row];
    add_contact(model, state, model.piece_body[p.piece_a], model.piece_body[p.piece_b], g.centre, g.force / size,
                g.length, face_law(model, p.law, 0), locals);
  }
}

void add_bearings(const Model<2>& model, const State<2>& state, const Work<2>& work, std::vector<Local>& locals) {
  for (std::size_t i = 0; i < model.bearings.size(); ++i) {
    // One that waits counts already: it may go live between two estimates.
    if (!is_live(work.bearing[i].status) && work.bearing[i].status != BearingStatus::waiting) continue;
    const Bearing<2>& b = model.bearings[i];
    const int node[2] = {model.bodies[b.body_a].first_node, model.bodies[b.body_b].first_node};
    const Vec2 at = state.position[node[1]] + Turn(state.rotation[node[1]]).apply(b.point_b);
    const Turn axes(state.rotation[node[0]] + b.angle);
    for (int k = 0; k < 3; ++k) {
      double tangent = 0, dashpot = 0;
      std::visit(
          [&](const auto& l) {
            if constexpr (!std::is_same_v<std::decay_t<decltype(l)>, std::monostate>)
              tangent = l.tangent(), dashpot = l.dashpot();
          },
          b.law[k]);
      const Vec2 e = k == turning ? Vec2::Zero() : axes.apply(k == along ? Vec2::UnitX() : Vec2::UnitY());
      for (const int side : {0, 1}) {
        const double weight = model.moves(node[1 - side]) ? 2 : 1;
        const Vec2 arm = at - state.position[node[side]];
        const Eigen::Vector3d v(e.x(), e.y(), k == turning ? 1.0 : cross(arm, e));
        locals[node[side]].k += weight * tangent * v * v.transpose();
        locals[node[side]].c += weight * dashpot * v * v.transpose();
      }
    }
  }
}

/// Largest row sum of the free degrees of freedom, scaled by mass and inertia: at least the largest eigenvalue.
double bound(const Model<2>& model, int node, const Eigen::Matrix3d& m) {
  const double scale[3] = {1 / std::sqrt(model.mass[node]), 1 / std::sqrt(model.mass[node]),
                           1 / std::sqrt(model.inertia[node])};
  double most = 0;
  for (int r = 0; r < 3; ++r) {
    double row = 0;
    for (int c = 0; c < 3; ++c)
      if (model.support[node][c] == Support::free && model.support[node][r] == Support::free)
        row += std::abs(m(r, c)) * scale[r] * scale[c];
    most = std::max(most, row);
  }
  return most;
}

/// The stiffest face of a body under the stiffest law its surface has, as if in full contact with a body like it. In
/// the body's own axes.
Local on_stiffest_face(const Model<2>& model, int body) {
  Local stiffest;
  const Body& b = model.bodies[body];
  for (int other = 0; other < model.surfaces; ++other) {
    const int law = model.law_of[b.surface * model.surfaces + other];
    if (law < 0) continue;
    const FaceLaw numbers = face_law(model, law, 0);
    for (int piece = b.first_piece; piece < b.first_piece + b.pieces; ++piece)
      for (int c = 0, count = model.corners_of(piece), first = model.piece_first[piece]; c < count; ++c) {
        if (!model.edge_is_face[first + c]) continue;
        const Vec2 &p = model.skin_place[model.corner_skin[first + c]],
                   &q = model.skin_place[model.corner_skin[first + (c + 1) % count]];
        const double length = (q - p).norm();
        const Vec2 t = (q - p) / length, n(t.y(), -t.x()), arm = 0.5 * (p + q);
        Local local;
        add_spring(local, n, arm, numbers.kn * length, numbers.beta, length, t, 2);
        add_spring(local, t, arm, numbers.ks * length, numbers.beta, length, t, 2);
        if (local.k.trace() > stiffest.k.trace()) stiffest = local;
      }
  }
  return stiffest;
}

double step_for(double stiffness, double damping) {
  if (!(stiffness > 0)) return damping > 0 ? std::min(longest_step, 2 / damping) : longest_step;
  return std::min(longest_step, (std::sqrt(4 * stiffness + damping * damping) - damping) / stiffness);
}

}  // namespace

void bound_faces(const Model<2>& model, Work<2>& work) {
  work.face_bound.resize(model.bodies.size());
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const int node = model.bodies[b].first_node;
    if (!model.moves(node)) continue;
    const Local local = on_stiffest_face(model, static_cast<int>(b));
    work.face_bound[b] = {bound(model, node, local.k), bound(model, node, local.c)};
  }
}

StableStep stable_step(const Model<2>& model, const State<2>& state, const Work<2>& work) {
  std::vector<Local> locals(static_cast<std::size_t>(model.nodes()));
  add_faces(model, state, work, locals);
  add_bearings(model, state, work, locals);
  StableStep found;
  found.dt = longest_step;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const int node = model.bodies[b].first_node;
    if (!model.moves(node)) continue;
    const double k = std::max(bound(model, node, locals[node].k), work.face_bound[b].stiffness);
    const double c = std::max(bound(model, node, locals[node].c), work.face_bound[b].damping) + model.mass_damping;
    const double dt = step_for(k, c);
    if (dt < found.dt) found = {dt, static_cast<int>(b), k, c};
  }
  return found;
}

double settled_step(double stable, double safety) {
  return std::exp2(std::floor(8 * std::log2(stable * safety)) / 8);
}

std::string explain_step(const Model<2>& model, const State<2>& state, const Work<2>& work) {
  const StableStep s = stable_step(model, state, work);
  if (s.body < 0) return fmt::format("nothing stiff governs; the step is held to {:g} s", longest_step);
  std::string text = fmt::format("body '{}' governs: stable step {:.4g} s, {:.4g} s without damping; its contacts:",
                                 model.bodies[s.body].name, s.dt, step_for(s.stiffness, 0));
  int named = 0;
  for (std::size_t row = 0; row < work.pairs.size(); ++row) {
    const NearPair& p = work.pairs[row];
    const int a = model.piece_body[p.piece_a], b = model.piece_body[p.piece_b];
    if ((work.memory[row].state & contact_touching) == 0 || (a != s.body && b != s.body)) continue;
    text += fmt::format(" '{}' ({})", model.bodies[a == s.body ? b : a].name, model.law_names[p.law]);
    ++named;
  }
  for (const Bearing<2>& b : model.bearings)
    if (b.body_a == s.body || b.body_b == s.body) text += fmt::format(" bearing '{}'", b.name), ++named;
  if (named == 0) text += " none now; as if lying on its stiffest face";
  return text;
}

}  // namespace trilith
