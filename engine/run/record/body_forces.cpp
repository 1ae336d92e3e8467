#include "run/record/body_forces.hpp"

#include <algorithm>
#include <cmath>

#include "assembly/evaluate.hpp"
#include "assembly/load_target.hpp"
#include "base/portable.hpp"
#include "model/pose.hpp"

namespace trilith {
namespace {

/// Sum of x f^T over the forces on a body, with x from its centroid.
struct Virial {
  double xx = 0, xy = 0, yx = 0, yy = 0;
  void add(const Vec2& x, const Vec2& f) {
    xx += x.x() * f.x(), xy += x.x() * f.y();
    yx += x.y() * f.x(), yy += x.y() * f.y();
  }
};

/// Centroid: mass-weighted mean of the nodes.
Vec2 centre_of(const Model<2>& model, const State<2>& state, const Body& body) {
  Vec2 sum = Vec2::Zero();
  double mass = 0;
  for (int n = body.first_node; n < body.first_node + body.nodes; ++n) {
    sum += model.mass[n] * state.position[n];
    mass += model.mass[n];
  }
  return mass > 0 ? Vec2(sum / mass) : state.position[body.first_node];
}

/// Adds loads to the virial of a body, at their present points of action.
struct VirialTarget : LoadPlaces<2> {
  Vec2 centre;  ///< of the body [m]
  Virial& sum;

  void push(const Attachment<2>& at, const Vec2& force, double /*moment*/) {
    sum.add(pose_at(model, state, at).place - centre, force);
  }
  void push_skin(int i, const Vec2& force) { sum.add(skin(i) - centre, force); }
};

void add_loads(const Model<2>& model, const State<2>& state, const Work<2>& work, const std::vector<Vec2>& centre,
               std::vector<Virial>& virial) {
  model.loads.for_each([&](const auto& load) {
    for (int part = 0; part < load.parts(); ++part) {
      const auto body = static_cast<std::size_t>(load.body_of(part));
      VirialTarget to{{model, state, &work, &work.closed_joints}, centre[body], virial[body]};
      load.apply(to, part);
    }
  });
}

bool is_free(const Model<2>& model, const Body& body) {
  for (int n = body.first_node; n < body.first_node + body.nodes; ++n)
    for (const int k : {0, 1})
      if (model.support[n][k] != Support::free) return false;
  return true;
}

bool is_one_of(std::span<const int> bodies, int body) {
  return std::find(bodies.begin(), bodies.end(), body) != bodies.end();
}

template <int D>
void add_bearings(const Model<D>& model, const Work<D>& work, std::span<const int> bodies, Vec<D>& force) {
  for (std::size_t i = 0; i < model.bearings.size() && i < work.bearing_force.size(); ++i) {
    if (is_one_of(bodies, model.bearings[i].body_b)) force += work.bearing_force[i];
    if (is_one_of(bodies, model.bearings[i].body_a)) force -= work.bearing_force[i];
  }
}

}  // namespace

/// Sum of contact and bearing forces on bodies, at the skin points that they act on; weight and loads are not included.
Vec2 force_on(const Model<2>& model, const Work<2>& work, std::span<const int> bodies) {
  Vec2 force = Vec2::Zero();
  for (const int i : bodies) {
    const Body& body = model.bodies[static_cast<std::size_t>(i)];
    for (int s = body.first_skin; s < body.first_skin + body.skins; ++s) force += work.skin_force[s];
  }
  add_bearings(model, work, bodies, force);
  return force;
}

Vec3 force_on(const Model<3>& model, const Work<3>& work, std::span<const int> bodies) {
  Vec3 force = Vec3::Zero();
  for (std::size_t i = 0; i < work.general_touching.size(); ++i) {
    const NearPair& pair = work.pairs[work.general_touching[i].row];
    if (is_one_of(bodies, model.piece_body[pair.piece_b])) force += solid_force(work, i);
    if (is_one_of(bodies, model.piece_body[pair.piece_a])) force -= solid_force(work, i);
  }
  add_bearings(model, work, bodies, force);
  return force;
}

double MeanStress::major() const {
  return 0.5 * (xx + yy) + portable::hypot(0.5 * (xx - yy), xy);
}
double MeanStress::minor() const {
  return 0.5 * (xx + yy) - portable::hypot(0.5 * (xx - yy), xy);
}

/// Mean stress = sum over the forces on the body of x f' / volume, with x from its centroid (virial theorem). It is
/// symmetric for a body at rest; for a rotating body the symmetric part is taken. Constrained bodies have no result,
/// because the support forces are not known.
std::vector<MeanStress> mean_stress(const Model<2>& model, const State<2>& state, const Work<2>& work,
                                    std::span<const TouchingContact> touching) {
  std::vector<Virial> virial(model.bodies.size());
  std::vector<Vec2> centre;
  for (const Body& body : model.bodies) centre.push_back(centre_of(model, state, body));
  for (const TouchingContact& c : touching) {
    virial[c.body_b].add(c.resultant.point - centre[c.body_b], c.resultant.force);
    virial[c.body_a].add(c.resultant.point - centre[c.body_a], -c.resultant.force);
  }
  for (std::size_t i = 0; i < model.bearings.size() && i < work.bearing_force.size(); ++i) {
    const Bearing<2>& b = model.bearings[i];
    // Each body is loaded at the end of the bearing that belongs to it; the part between the ends belongs to neither.
    // The remaining couple is skew-symmetric and contributes no stress.
    const Vec2 end_a = pose_at(model, state, b.end_a).place, end_b = pose_at(model, state, b.end_b).place;
    virial[b.body_a].add(end_a - centre[b.body_a], -work.bearing_force[i]);
    virial[b.body_b].add(end_b - centre[b.body_b], work.bearing_force[i]);
  }
  add_loads(model, state, work, centre, virial);
  std::vector<MeanStress> stress(model.bodies.size());
  for (std::size_t i = 0; i < stress.size(); ++i) {
    const Body& body = model.bodies[i];
    const double volume = body.area * model.thickness;
    if (!(volume > 0) || !is_free(model, body)) continue;
    stress[i] = {virial[i].xx / volume, virial[i].yy / volume, 0.5 * (virial[i].xy + virial[i].yx) / volume};
  }
  return stress;
}

namespace {

/// Speed of the fastest point of a body.
double speed_of(const Body& body, const Work<2>& work) {
  double most = 0;
  for (int s = body.first_skin; s < body.first_skin + body.skins; ++s)
    most = std::max(most, portable::hypot(work.skin[s].u, work.skin[s].v));
  return most;
}
double speed_of(const Body& body, const Work<3>& work) {
  double most = 0;
  for (int p = body.first_piece; p < body.first_piece + body.pieces; ++p)
    most = std::max(most, work.solids.speed2[static_cast<std::size_t>(p)]);
  return std::sqrt(most);
}

}  // namespace

/// The body with the largest residual force along its free degrees of freedom, and the body with the fastest point.
template <int D>
WorstBodies worst_bodies(const Model<D>& model, const Work<D>& work) {
  WorstBodies worst;
  for (int b = 0; b < static_cast<int>(model.bodies.size()); ++b) {
    if (!model.body_moves(b)) continue;
    const Body& body = model.bodies[b];
    for (int n = body.first_node; n < body.first_node + body.nodes; ++n) {
      if (!model.moves(n)) continue;
      Vec<D> left = work.force[n];
      for (int k = 0; k < D; ++k)
        if (model.support[n][k] != Support::free) left[k] = 0;
      if (worst.unbalanced < 0 || left.norm() > worst.force) worst.unbalanced = b, worst.force = left.norm();
    }
    const double speed = speed_of(body, work);
    if (worst.fastest < 0 || speed > worst.speed) worst.fastest = b, worst.speed = speed;
  }
  return worst;
}

template WorstBodies worst_bodies(const Model<2>&, const Work<2>&);
template WorstBodies worst_bodies(const Model<3>&, const Work<3>&);

namespace {

double pressing(const TouchingContact& c) {
  return std::abs(c.resultant.normal);
}
const ContactResultant& resultant_of(const TouchingContact& c) {
  return c.resultant;
}
double pressing(const SolidResultant& c) {
  return std::abs(c.normal.dot(c.force));
}
const SolidResultant& resultant_of(const SolidResultant& c) {
  return c;
}

/// Points at which the force from one body of the chain to the next acts. Several contacts between two bodies are
/// merged at the mean of their points, weighted by normal force.
template <int D, class Contact>
std::vector<ThrustPoint<D>> line_through(std::span<const int> chain, std::span<const Contact> touching) {
  std::vector<ThrustPoint<D>> line;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    ThrustPoint<D> p{chain[i], chain[i + 1], Vec<D>::Zero(), Vec<D>::Zero()};
    double weight = 0;
    for (const Contact& c : touching) {
      const bool forward = c.body_a == p.body_a && c.body_b == p.body_b;
      if (!forward && !(c.body_a == p.body_b && c.body_b == p.body_a)) continue;
      const double size = pressing(c);
      p.point += size * resultant_of(c).point;
      p.force += (forward ? 1.0 : -1.0) * resultant_of(c).force;
      weight += size;
    }
    if (!(weight > 0)) continue;
    p.point /= weight;
    line.push_back(p);
  }
  return line;
}

}  // namespace

std::vector<ThrustPoint<2>> thrust_line(std::span<const int> chain, std::span<const TouchingContact> touching) {
  return line_through<2>(chain, touching);
}
std::vector<ThrustPoint<3>> thrust_line(std::span<const int> chain, std::span<const SolidResultant> touching) {
  return line_through<3>(chain, touching);
}

}  // namespace trilith
