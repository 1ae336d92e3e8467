#include "assembly/element/rotary_inertia.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "assembly/node_motions.hpp"
#include "assembly/whole_body.hpp"
#include "base/team.hpp"

namespace trilith {
namespace {

/// Bodies per chunk of a thread, about 10 microseconds.
constexpr int bodies_at_a_time = 128;

/// The element of a body with a single one, otherwise null. Elements are stored body by body.
template <class E>
const E* only_element(const std::vector<E>& elements, int body) {
  const auto at = std::lower_bound(elements.begin(), elements.end(), body,
                                   [](const E& element, int b) { return element.body < b; });
  if (at == elements.end() || at->body != body) return nullptr;
  const auto next = at + 1;
  return next != elements.end() && next->body == body ? nullptr : &*at;
}

template <int D>
struct Lumped {
  Vec<D> centre = Vec<D>::Zero();
  double mass = 0;
  TurnMatrix<D> inertia = TurnMatrix<D>::Zero();
};

template <int D>
Lumped<D> lumped_inertia(const Model<D>& model, const State<D>& state, const Body& body) {
  Lumped<D> out;
  const int end = body.first_node + body.nodes;
  for (int n = body.first_node; n < end; ++n)
    out.mass += model.mass[n], out.centre += model.mass[n] * state.position[n];
  out.centre /= out.mass;
  for (int n = body.first_node; n < end; ++n) {
    const Vec<D> arm = state.position[n] - out.centre;
    if constexpr (D == 2)
      out.inertia(0, 0) += model.mass[n] * arm.squaredNorm();
    else
      out.inertia += turn_inertia(model.mass[n], arm);
  }
  return out;
}

/// Signs of the natural coordinates of a brick's nodes.
constexpr std::array<std::array<double, 3>, 8> corner{
    {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};

/// Position in a brick as a polynomial of its natural coordinates.
struct BrickShape {
  Vec3 x = Vec3::Zero(), y = x, z = x, yz = x, zx = x, xy = x, xyz = x;

  explicit BrickShape(const std::array<Vec3, 8>& arm) {
    for (std::size_t i = 0; i < 8; ++i) {
      const auto [a, b, c] = corner[i];
      const Vec3 part = 0.125 * arm[i];
      x += a * part, y += b * part, z += c * part;
      yz += b * c * part, zx += c * a * part, xy += a * b * part, xyz += a * b * c * part;
    }
  }
  /// True if the faces are parallelograms within 0.1 %.
  [[nodiscard]] bool is_parallelepiped() const {
    constexpr double share = 1e-6;  // of squares
    const double size = std::min({x.squaredNorm(), y.squaredNorm(), z.squaredNorm()});
    return yz.squaredNorm() + zx.squaredNorm() + xy.squaredNorm() + xyz.squaredNorm() <= share * size;
  }
};

/// Inertia of a brick of mass 1 about its centroid, by 2 x 2 x 2 Gauss points, relative to the mean of its nodes.
Eigen::Matrix3d brick_inertia(const BrickShape& s, const Vec3& from_mean) {
  const double at = 1 / std::sqrt(3.0);
  double volume = 0;
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (const auto& sign : corner) {
    const double a = at * sign[0], b = at * sign[1], c = at * sign[2];
    const Vec3 da = s.x + c * s.zx + b * s.xy + b * c * s.xyz, db = s.y + c * s.yz + a * s.xy + a * c * s.xyz,
               dc = s.z + b * s.yz + a * s.zx + a * b * s.xyz;
    const double share = cross(da, db).dot(dc);
    const Vec3 r =
        a * s.x + b * s.y + c * s.z + b * c * s.yz + c * a * s.zx + a * b * s.xy + a * b * c * s.xyz - from_mean;
    volume += share, second += share * (r * r.transpose());
  }
  second /= volume;
  return second.trace() * Eigen::Matrix3d::Identity() - second;
}

template <int D>
bool is_unheld(const Model<D>& model, const Body& body) {
  for (int n = body.first_node; n < body.first_node + body.nodes; ++n)
    for (int k = 0; k < D; ++k)
      if (model.support[n][k] != Support::free) return false;
  return true;
}

/// T' D v of the nodes of a body.
template <int D, class Velocity>
TurnVector<D> angular_momentum(const Model<D>& model, const State<D>& state, const Body& body, const Vec<D>& centre,
                               Velocity&& velocity) {
  TurnVector<D> sum = TurnVector<D>::Zero();
  for (int n = body.first_node; n < body.first_node + body.nodes; ++n) {
    const auto v = velocity(n);
    for (int k = 0; k < D; ++k) sum += model.mass[n] * v[k] * turn_row(k, Vec<D>(state.position[n] - centre));
  }
  return sum;
}

/// Gyroscopic term of y: with the lumped angular momentum H and s = Jl^-1 H, it is Jl^-1 (J Jl^-1 (s x H) - s x J s).
/// It is zero if J is a multiple of Jl, and so in the plane.
template <int D>
TurnVector<D> gyroscopic_part(const RotaryInertia<D>& of, const TurnVector<D>& momentum) {
  if constexpr (D == 2) {
    return TurnVector<2>::Zero();
  } else {
    if (of.multiple > 0) return Vec3::Zero();
    const Eigen::Matrix3d back = of.lumped.inverse();
    const Vec3 spin = back * momentum;
    return back * (of.own * (back * cross(spin, momentum)) - cross(spin, Vec3(of.own * spin)));
  }
}

/// Computes y, with `free` = Jf and `sum` the moment of forces and of driven masses. Velocities refer to half a step
/// before; the present angular momentum follows from its rate.
template <int D>
TurnVector<D> turning_answer(const Model<D>& model, const State<D>& state, const RotaryInertia<D>& of, const Body& body,
                             const TurnMatrix<D>& free, const TurnVector<D>& sum) {
  const TurnMatrix<D> off = of.taken_off(), left = (TurnMatrix<D>::Identity() - off * free).inverse();
  TurnVector<D> y = left * (off * sum);
  if (D == 2 || of.multiple > 0) return y;
  TurnVector<D> momentum = angular_momentum<D>(model, state, body, of.centre, [&](int n) { return state.velocity[n]; });
  const TurnVector<D> guess = y + left * gyroscopic_part(of, momentum);
  momentum += 0.5 * state.last_dt * (sum + free * guess);
  return y + left * gyroscopic_part(of, momentum);
}

/// Adds y of a free body. force(n): on a node [N].
template <int D, class Force>
void add_to_free(const Model<D>& model, const State<D>& state, const RotaryInertia<D>& of, const Body& body,
                 Force&& force, std::vector<Vec<D>>& added) {
  TurnVector<D> moment = TurnVector<D>::Zero();
  const int end = body.first_node + body.nodes;
  for (int n = body.first_node; n < end; ++n) {
    const Vec<D> f = force(n);
    for (int k = 0; k < D; ++k) moment += f[k] * turn_row(k, Vec<D>(state.position[n] - of.centre));
  }
  if constexpr (D == 2) {
    const double y = (1 / of.own(0, 0) - 1 / of.lumped(0, 0)) * moment[0];
    for (int n = body.first_node; n < end; ++n)
      added[n] += model.mass[n] * cross(y, Vec2(state.position[n] - of.centre));
  } else {
    const Vec3 y = of.multiple > 0 ? Vec3((of.multiple - 1) * (of.lumped.inverse() * moment))
                                   : turning_answer<3>(model, state, of, body, of.lumped, moment);
    for (int n = body.first_node; n < end; ++n)
      added[n] += model.mass[n] * cross(y, Vec3(state.position[n] - of.centre));
  }
}

/// Fast form of add_to_free for a free quad with known forces. Most quads are parallelograms, whose inertia is a third
/// of the inertia of their lumped masses. False if the quad is constrained or of another shape.
bool add_to_plain_quad(const Model<2>& model, const State<2>& state, const Work<2>& work, const Body& body,
                       std::vector<Vec2>& added) {
  const auto first = static_cast<std::size_t>(body.first_node);
  const Vec2 *const place = &state.position[first], *const force = &work.force[first];
  const double* const mass = &model.mass[first];
  for (std::size_t i = 0; i < 4; ++i)
    if (const auto& s = model.support[first + i]; s[0] != Support::free || s[1] != Support::free) return false;
  const double total = mass[0] + mass[1] + mass[2] + mass[3];
  double cx = 0, cy = 0;
  for (std::size_t i = 0; i < 4; ++i) cx += mass[i] * place[i].x(), cy += mass[i] * place[i].y();
  cx /= total, cy /= total;
  const double skew_x = place[0].x() + place[2].x() - 2 * cx, skew_y = place[0].y() + place[2].y() - 2 * cy;
  double lumped = 0, moment = 0;
  std::array<double, 4> x, y;
  for (std::size_t i = 0; i < 4; ++i) {
    x[i] = place[i].x() - cx, y[i] = place[i].y() - cy;
    lumped += mass[i] * (x[i] * x[i] + y[i] * y[i]);
    moment += x[i] * force[i].y() - y[i] * force[i].x();
  }
  constexpr double share = 1e-6;  // of squares
  if ((skew_x * skew_x + skew_y * skew_y) * total > share * lumped) return false;
  const double turn = 2 * moment / lumped;  // 3 / Jl - 1 / Jl
  for (std::size_t i = 0; i < 4; ++i) {
    const double size = mass[i] * turn;
    Vec2& to = added[first + i];
    to = {to.x() - size * y[i], to.y() + size * x[i]};
  }
  return true;
}

template <int D>
void add_to_held(const Model<D>& model, const State<D>& state, const RotaryInertia<D>& of, const Body& body,
                 const NodeMotions<D>& motions, std::vector<Vec<D>>& added) {
  TurnMatrix<D> free = TurnMatrix<D>::Zero();
  TurnVector<D> sum = TurnVector<D>::Zero();
  const int end = body.first_node + body.nodes;
  for (int n = body.first_node; n < end; ++n) {
    const NodeForces<D> f = motions.forces(n);
    for (int k = 0; k < D; ++k) {
      const TurnVector<D> row = turn_row(k, Vec<D>(state.position[n] - of.centre));
      if (model.support[n][k] == Support::free)
        free += model.mass[n] * row * row.transpose(), sum += f.force[k] * row;
      else
        sum += model.mass[n] * motions.driven(n, k) * row;
    }
  }
  const TurnVector<D> y = turning_answer(model, state, of, body, free, sum);
  for (int n = body.first_node; n < end; ++n)
    for (int k = 0; k < D; ++k)
      added[n][k] += model.mass[n] * turn_row(k, Vec<D>(state.position[n] - of.centre)).dot(y);
}

}  // namespace

bool is_one_element(const Model<2>& model, int body) {
  const Body& b = model.bodies[body];
  if (b.kind == BodyKind::quad) return true;
  return b.kind == BodyKind::mesh && b.nodes <= 4 && only_element(model.elements, body) != nullptr;
}
bool is_one_element(const Model<3>& model, int body) {
  const Body& b = model.bodies[body];
  return b.kind == BodyKind::brick || (b.kind == BodyKind::mesh && b.nodes == 4);
}

template <int D>
bool has_one_element_bodies(const Model<D>& model) {
  if (model.elements.empty() && model.space_elements.empty()) return false;
  for (int b = 0; b < static_cast<int>(model.bodies.size()); ++b)
    if (is_one_element(model, b)) return true;
  return false;
}

/// Inertia of a polygon whose nodes follow its outline.
RotaryInertia<2> rotary_inertia(const Model<2>& model, const State<2>& state, int body) {
  const Body& b = model.bodies[body];
  const Lumped<2> lumped = lumped_inertia(model, state, b);
  double twice = 0, second = 0;
  for (int i = 0; i < b.nodes; ++i) {
    const Vec2 p = state.position[b.first_node + i] - lumped.centre,
               q = state.position[b.first_node + (i + 1) % b.nodes] - lumped.centre;
    const double area = cross(p, q);
    twice += area, second += area * (p.squaredNorm() + p.dot(q) + q.squaredNorm());
  }
  RotaryInertia<2> out{lumped.centre, lumped.inertia, {}};
  out.own(0, 0) = lumped.mass * second / (6 * twice);
  return out;
}

RotaryInertia<3> rotary_inertia(const Model<3>& model, const State<3>& state, int body) {
  const Body& b = model.bodies[body];
  const Lumped<3> lumped = lumped_inertia(model, state, b);
  RotaryInertia<3> out{lumped.centre, lumped.inertia, {}};
  if (b.nodes == 4) return {lumped.centre, lumped.inertia, lumped.inertia / 5, 5};
  const SpaceElement* element = only_element(model.space_elements, body);
  std::array<Vec3, 8> arm;
  Vec3 mean = Vec3::Zero();
  for (std::size_t i = 0; i < 8; ++i) arm[i] = state.position[element->node[i]], mean += 0.125 * arm[i];
  for (Vec3& a : arm) a -= mean;
  const BrickShape shape(arm);
  if (shape.is_parallelepiped()) return {lumped.centre, lumped.inertia, lumped.inertia / 3, 3};
  out.own = lumped.mass * brick_inertia(shape, lumped.centre - mean);
  return out;
}

template <int D>
double lumped_over_own(const Model<D>& model, const State<D>& state, int body) {
  if (!is_one_element(model, body)) return 1;
  const RotaryInertia<D> of = rotary_inertia(model, state, body);
  if constexpr (D == 2)
    return of.lumped(0, 0) / of.own(0, 0);
  else if (of.multiple > 0)
    return of.multiple;
  else
    return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix3d>(of.lumped, of.own, Eigen::EigenvaluesOnly)
        .eigenvalues()
        .maxCoeff();
}

template <int D>
void add_rotary_inertia(const Model<D>& model, const State<D>& state, const Work<D>& work, const StepOptions& options,
                        bool all_count, std::vector<Vec<D>>& added) {
  const NodeMotions<D> motions(model, state, work, options);
  const auto add = [&](int b) {
    const Body& body = model.bodies[b];
    if constexpr (D == 2)
      if (all_count && body.kind == BodyKind::quad && add_to_plain_quad(model, state, work, body, added)) return;
    if (!model.body_moves(b)) return;
    const RotaryInertia<D> of = rotary_inertia(model, state, b);
    if (!is_unheld(model, body))
      add_to_held(model, state, of, body, motions, added);
    else if (all_count)
      add_to_free(
          model, state, of, body, [&](int n) -> const Vec<D>& { return work.force[n]; }, added);
    else
      add_to_free(
          model, state, of, body, [&](int n) { return along_of(motions.forces(n).force); }, added);
  };
  share(work.threads, static_cast<int>(model.bodies.size()), bodies_at_a_time,
        [&](int first, int last, int /*thread*/) {
          for (int b = first; b < last; ++b)
            if (is_one_element(model, b)) add(b);
        });
}

template <int D>
double rotary_kinetic(const Model<D>& model, const State<D>& state, const Work<D>& work, const StepOptions& options) {
  if (work.added_inertia.empty()) return 0;
  const NodeMotions<D> motions(model, state, work, options);
  double sum = 0;
  for (int b = 0; b < static_cast<int>(model.bodies.size()); ++b) {
    if (!is_one_element(model, b) || !model.body_moves(b)) continue;
    const Body& body = model.bodies[b];
    const RotaryInertia<D> of = rotary_inertia(model, state, b);
    const TurnVector<D> before =
        angular_momentum<D>(model, state, body, of.centre, [&](int n) { return state.velocity[n]; });
    const TurnVector<D> ahead =
        state.last_dt > 0 ? angular_momentum<D>(model, state, body, of.centre, [&](int n) { return motions.ahead(n); })
                          : before;
    sum -= 0.5 * before.dot(of.taken_off() * ahead);
  }
  return sum;
}

template <int D>
double rotary_energy(const Model<D>& model, const State<D>& state) {
  double sum = 0;
  for (int b = 0; b < static_cast<int>(model.bodies.size()); ++b) {
    if (!is_one_element(model, b) || !model.body_moves(b)) continue;
    const RotaryInertia<D> of = rotary_inertia(model, state, b);
    const TurnVector<D> h =
        angular_momentum<D>(model, state, model.bodies[b], of.centre, [&](int n) { return state.velocity[n]; });
    sum -= 0.5 * h.dot(of.taken_off() * h);
  }
  return sum;
}

template <int D>
void add_rotary_momentum(const Model<D>& model, const State<D>& state, const std::vector<Dofs<D>>& v,
                         std::vector<Dofs<D>>& out) {
  each_rotary_entry(model, state, [&](int i, int k, int j, int l, double m) { out[i][k] += m * v[j][l]; });
}

template <int D>
void add_rotary_diagonal(const Model<D>& model, const State<D>& state, std::vector<Dofs<D>>& out) {
  each_rotary_entry(model, state, [&](int i, int k, int j, int l, double m) {
    if (i == j && k == l) out[i][k] += m;
  });
}

/// -D T B T' D a, and in space the gyroscopic term.
template <int D>
void add_rotary_forces(const Model<D>& model, const State<D>& state, bool rising, std::vector<Dofs<D>>& out) {
  for (int b = 0; b < static_cast<int>(model.bodies.size()); ++b) {
    if (!is_one_element(model, b) || !model.body_moves(b)) continue;
    const Body& body = model.bodies[b];
    const RotaryInertia<D> of = rotary_inertia(model, state, b);
    const auto moment = [&](const std::vector<Vec<D>>& rate) {
      return angular_momentum<D>(model, state, body, of.centre, [&](int n) { return rate[n]; });
    };
    TurnVector<D> y = TurnVector<D>::Zero();
    if (rising) y = of.taken_off() * moment(state.acceleration);
    if (D == 3 && !(of.multiple > 0)) y += gyroscopic_part(of, moment(state.velocity));
    for (int n = body.first_node; n < body.first_node + body.nodes; ++n) {
      const Vec<D> arm = state.position[n] - of.centre;
      for (int k = 0; k < D; ++k) out[n][k] -= model.mass[n] * turn_row(k, arm).dot(y);
    }
  }
}

template bool has_one_element_bodies(const Model<2>&);
template bool has_one_element_bodies(const Model<3>&);
template double lumped_over_own(const Model<2>&, const State<2>&, int);
template double lumped_over_own(const Model<3>&, const State<3>&, int);
template void add_rotary_inertia(const Model<2>&, const State<2>&, const Work<2>&, const StepOptions&, bool,
                                 std::vector<Vec2>&);
template void add_rotary_inertia(const Model<3>&, const State<3>&, const Work<3>&, const StepOptions&, bool,
                                 std::vector<Vec3>&);
template double rotary_kinetic(const Model<2>&, const State<2>&, const Work<2>&, const StepOptions&);
template double rotary_kinetic(const Model<3>&, const State<3>&, const Work<3>&, const StepOptions&);
template double rotary_energy(const Model<2>&, const State<2>&);
template double rotary_energy(const Model<3>&, const State<3>&);
template void add_rotary_momentum(const Model<2>&, const State<2>&, const std::vector<Dofs<2>>&, std::vector<Dofs<2>>&);
template void add_rotary_momentum(const Model<3>&, const State<3>&, const std::vector<Dofs<3>>&, std::vector<Dofs<3>>&);
template void add_rotary_diagonal(const Model<2>&, const State<2>&, std::vector<Dofs<2>>&);
template void add_rotary_diagonal(const Model<3>&, const State<3>&, std::vector<Dofs<3>>&);
template void add_rotary_forces(const Model<2>&, const State<2>&, bool, std::vector<Dofs<2>>&);
template void add_rotary_forces(const Model<3>&, const State<3>&, bool, std::vector<Dofs<3>>&);

}  // namespace trilith
