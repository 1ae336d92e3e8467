#include "edit/crack_search.hpp"

#include <algorithm>
#include <cmath>

#include "law/contact/list.hpp"
#include "readings/section_forces.hpp"

namespace trilith {
namespace {

/// Steps until a body is computed again, by the largest share of its strength that a section uses.
std::int64_t steps_until_next(double share) {
  if (share >= 0.5) return 1;
  if (share >= 0.25) return 4;
  return share >= 0.1 ? 16 : 64;
}

/// Growth of the forces on its surface after which a body is computed again: to half of its strength in proportion, and
/// at least by a quarter.
double allowed_growth(double share) {
  return std::clamp(0.5 / std::max(share, 1e-3), 1.25, 4.0);
}

void keep_larger(SectionUse& most, double share, JointMode mode, double stress, double at) {
  if (share > most.share) most = {share, mode, stress, at};
}

/// Mean over a section of the part of a stress above 0 that is linear from p to q.
double mean_positive(double p, double q) {
  if (p <= 0 && q <= 0) return 0;
  if (p >= 0 && q >= 0) return 0.5 * (p + q);
  const double most = std::max(p, q);
  return 0.5 * most * most / std::abs(p - q);
}

}  // namespace

SectionUse section_use(const ContactLaw& law, double normal, double shear, double moment, double length, double depth) {
  const double area = length * depth, bend = 6 * moment / (area * length);
  const double left = normal / area - bend, right = normal / area + bend;
  SectionUse most;
  with_kernel({law}, [&]<class K>(const K& kernel) {
    if constexpr (K::bonds) {
      const double pulled = std::max(left, right), at = left >= right ? 0.5 * length : -0.5 * length;
      keep_larger(most, pulled / kernel.tension, JointMode::tension, pulled, at);
      const double slip = std::abs(shear) / area;
      const double strength =
          kernel.shear_strength(mean_positive(-left, -right) / kernel.kn, mean_positive(left, right) / kernel.kn);
      keep_larger(most, slip / std::max(strength, 1e-9 * kernel.cohesion), JointMode::shear, slip, 0);
      if constexpr (K::crushes)
        if (kernel.crushing > 0) {
          const double pressed = -std::min(left, right);
          keep_larger(most, pressed / (kernel.crushing * kernel.kn), JointMode::compression, pressed,
                      left <= right ? 0.5 * length : -0.5 * length);
        }
    }
  });
  return most;
}

namespace {

/// Present and free in all directions: the place at which a support acts on a rigid body is not known.
template <int D>
bool can_crack(const Model<D>& model, const State<D>& state, int body) {
  if (state.left[static_cast<std::size_t>(body)] != 0) return false;
  for (const Support s : model.support[static_cast<std::size_t>(model.bodies[body].first_node)])
    if (s != Support::free) return false;
  return true;
}

/// [cracking body] sums of the forces on their surfaces, without regard to directions [N].
std::vector<double> surface_loads(const Model<2>& model, const Work<2>& work, const Cracking<2>& cracking) {
  std::vector<double> load;
  load.reserve(cracking.bodies.size());
  for (const CrackingBody<2>& c : cracking.bodies) {
    const Body& body = model.bodies[static_cast<std::size_t>(c.body)];
    double sum = 0;
    for (int s = body.first_skin; s < body.first_skin + body.skins; ++s)
      sum += std::abs(work.skin_force[static_cast<std::size_t>(s)].x()) +
             std::abs(work.skin_force[static_cast<std::size_t>(s)].y());
    load.push_back(sum);
  }
  const auto add = [&](int body, double force) {
    const auto at = std::lower_bound(cracking.bodies.begin(), cracking.bodies.end(), body,
                                     [](const CrackingBody<2>& c, int b) { return c.body < b; });
    if (at != cracking.bodies.end() && at->body == body)
      load[static_cast<std::size_t>(at - cracking.bodies.begin())] += force;
  };
  for (std::size_t i = 0; i < model.bearings.size() && i < work.bearing_force.size(); ++i) {
    const double force = work.bearing_force[i].norm();
    add(model.bearings[i].body_a, force), add(model.bearings[i].body_b, force);
  }
  return load;
}

/// The section of a body that uses most of its strength, and how much.
struct WorstSection {
  SectionUse use;
  int section = -1;
  PlaneForces forces;
};
WorstSection worst_section(const Model<2>& model, const CrackingBody<2>& body, const SurfaceForces& forces,
                           std::size_t i) {
  WorstSection worst;
  for (std::size_t s = 0; s < body.sections.size(); ++s) {
    const PlaneForces f = forces.in_section(i, body.sections[s]);
    const SectionUse use = section_use(model.laws[static_cast<std::size_t>(body.law)], f.normal, f.shear, f.moment,
                                       body.sections[s].length(), body.depth);
    if (worst.section < 0 || use.share > worst.use.share) worst = {use, static_cast<int>(s), f};
  }
  return worst;
}

/// The crack of a body at the place of its largest stress.
Crack<2> crack_of(const Model<2>& model, const State<2>& state, const CrackingBody<2>& body,
                  const WorstSection& worst) {
  const CrackSection<2>& section = body.sections[static_cast<std::size_t>(worst.section)];
  const auto n = static_cast<std::size_t>(model.bodies[static_cast<std::size_t>(body.body)].first_node);
  const Vec2 at = section.middle() + worst.use.at * left_of(section.normal);
  return {body.body,
          worst.section,
          worst.use.mode,
          worst.use.stress,
          state.position[n] + Turn(state.rotation[n]).apply(at),
          worst.forces.normal,
          worst.forces.shear,
          worst.forces.moment};
}

}  // namespace

CrackSearch<2> search_cracks(const Model<2>& model, const State<2>& state, const Work<2>& work,
                             const Cracking<2>& cracking) {
  CrackSearch<2> found{{}, cracking.watch};
  found.watch.resize(cracking.bodies.size());
  const std::vector<double> load = surface_loads(model, work, cracking);
  std::vector<int> bodies, rows;
  for (std::size_t i = 0; i < cracking.bodies.size(); ++i) {
    const CrackWatch& watch = found.watch[i];
    const bool due = state.implicit() || state.step >= watch.next || load[i] > watch.load;
    if (!due || !can_crack(model, state, cracking.bodies[i].body)) continue;
    bodies.push_back(cracking.bodies[i].body), rows.push_back(static_cast<int>(i));
  }
  if (bodies.empty()) return found;
  SurfaceForces forces(model, state, work);
  forces.collect(bodies);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const auto row = static_cast<std::size_t>(rows[k]);
    const WorstSection worst = worst_section(model, cracking.bodies[row], forces, k);
    found.watch[row] = {state.step + steps_until_next(worst.use.share), load[row] * allowed_growth(worst.use.share)};
    if (worst.use.share > 1) found.cracks.push_back(crack_of(model, state, cracking.bodies[row], worst));
  }
  return found;
}

/// No body in space has planes yet.
CrackSearch<3> search_cracks(const Model<3>& /*model*/, const State<3>& /*state*/, const Work<3>& /*work*/,
                             const Cracking<3>& /*cracking*/) {
  return {};
}

}  // namespace trilith
