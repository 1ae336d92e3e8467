#include "edit/crack_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "assembly/contact/solid_resultants.hpp"
#include "assembly/field/joint_water.hpp"
#include "base/rotation_3d.hpp"
#include "edit/mesh_section.hpp"
#include "geometry/space/face_overlap_3d.hpp"
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

/// Mean over a section of the part of a stress above 0.
double mean_positive(const CrackSection<3>& section, const SectionStress& stress, double sign) {
  return integrals_in_contact(section.corners, sign * stress.mean, sign * stress.slope).first / section.area;
}

/// The corner of a section where `size` is largest, and this value.
template <class Size>
std::pair<Vec2, double> largest_at_corner(const CrackSection<3>& section, Size&& size) {
  std::pair<Vec2, double> most{Vec2::Zero(), -unbounded};
  for (const Vec2& p : section.corners)
    if (const double at_p = size(p); at_p > most.second) most = {p, at_p};
  return most;
}

}  // namespace

SectionUse section_use(const ContactLaw& law, const CrackSection<3>& section, const SpaceForces& forces) {
  const SectionStress stress = section_stress(section, forces);
  SectionUse most;
  const auto keep = [&](double share, JointMode mode, double size, const Vec2& at) {
    if (share > most.share) most = {share, mode, size, 0, at};
  };
  with_kernel({law}, [&]<class K>(const K& kernel) {
    if constexpr (K::bonds) {
      const auto [pulled_at, pulled] = largest_at_corner(section, stress);
      keep(pulled / kernel.tension, JointMode::tension, pulled, pulled_at);
      const double twist = forces.torsion / section.polar();
      const auto [slip_at, slip] = largest_at_corner(
          section, [&](const Vec2& p) { return (forces.shear / section.area + twist * left_of(p)).norm(); });
      const double strength = kernel.shear_strength(mean_positive(section, stress, -1) / kernel.kn,
                                                    mean_positive(section, stress, 1) / kernel.kn);
      keep(slip / std::max(strength, 1e-9 * kernel.cohesion), JointMode::shear, slip,
           twist == 0 ? Vec2(Vec2::Zero()) : slip_at);
      if constexpr (K::crushes)
        if (kernel.crushing > 0) {
          const auto [pressed_at, pressed] = largest_at_corner(section, [&](const Vec2& p) { return -stress(p); });
          keep(pressed / (kernel.crushing * kernel.kn), JointMode::compression, pressed, pressed_at);
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

template <int D>
bool is_mesh(const CrackingBody<D>& body) {
  return body.sections.front().cut != nullptr;
}

/// Calls add(body, size) for the forces of contacts on cracking bodies [N].
template <class Add>
void contact_sizes(const Model<2>& model, const Work<2>& work, const Cracking<2>& cracking, Add&& add) {
  for (const CrackingBody<2>& c : cracking.bodies) {
    if (is_mesh(c)) continue;
    const Body& body = model.bodies[static_cast<std::size_t>(c.body)];
    double sum = 0;
    for (int s = body.first_skin; s < body.first_skin + body.skins; ++s)
      sum += std::abs(work.skin_force[static_cast<std::size_t>(s)].x()) +
             std::abs(work.skin_force[static_cast<std::size_t>(s)].y());
    add(c.body, sum);
  }
}
template <class Add>
void contact_sizes(const Model<3>& model, const Work<3>& work, const Cracking<3>& /*cracking*/, Add&& add) {
  for (std::size_t i = 0; i < work.general_touching.size(); ++i) {
    const NearPair& pair = work.pairs[static_cast<std::size_t>(work.general_touching[i].row)];
    const double size = solid_force(work, i).lpNorm<1>();
    add(model.piece_body[pair.piece_a], size), add(model.piece_body[pair.piece_b], size);
  }
}

/// [cracking body] sums of the forces on their surfaces, without regard to directions [N].
template <int D>
void find_surface_loads(const Model<D>& model, const State<D>& state, const Work<D>& work, const Cracking<D>& cracking,
                        std::vector<double>& load) {
  load.assign(cracking.bodies.size(), 0.0);
  const auto row_of = [&](int body) {
    const auto at = std::lower_bound(cracking.bodies.begin(), cracking.bodies.end(), body,
                                     [](const CrackingBody<D>& c, int b) { return c.body < b; });
    return at != cracking.bodies.end() && at->body == body ? at - cracking.bodies.begin() : -1;
  };
  const auto add = [&](int body, double force) {
    if (const auto row = row_of(body); row >= 0) load[static_cast<std::size_t>(row)] += force;
  };
  contact_sizes(model, work, cracking, add);
  for (std::size_t i = 0; i < model.bearings.size() && i < work.bearing_force.size(); ++i) {
    const double force = work.bearing_force[i].norm();
    add(model.bearings[i].body_a, force), add(model.bearings[i].body_b, force);
  }
  for_load_parts(model, [&](const auto& one, int part, const LoadPart& /*row*/) {
    const auto row = row_of(one.body_of(part));
    if (row < 0) return;
    LoadSizes<D> on{{model, state, &work, &work.closed_joints}, load[static_cast<std::size_t>(row)]};
    one.apply(on, part);
  });
  if constexpr (D == 2)
    if (has_joint_water(model))
      for (std::size_t i = 0; i < load.size(); ++i)
        load[i] += thrust_on_body(model, state, cracking.bodies[i].body, Vec2::Zero()).force.norm();
}

SectionUse use_of(const ContactLaw& law, const CrackingBody<2>& body, const CrackSection<2>& section,
                  const PlaneForces& f) {
  return section_use(law, f.normal, f.shear, f.moment, section.length(), body.depth);
}
SectionUse use_of(const ContactLaw& law, const CrackingBody<3>& /*body*/, const CrackSection<3>& section,
                  const SpaceForces& f) {
  return section_use(law, section, f);
}

/// Area of a section [m2] and its length along the axis of least bending strength [m].
struct SectionSize {
  double area, length;
};
SectionSize size_of(const CrackingBody<2>& body, const CrackSection<2>& s) {
  return {s.length() * body.depth, s.length()};
}
/// As of a rectangle with the same area and the least second moment.
SectionSize size_of(const CrackingBody<3>& /*body*/, const CrackSection<3>& s) {
  const double half = 0.5 * (s.xx - s.yy), least = 0.5 * (s.xx + s.yy) - std::sqrt(half * half + s.xy * s.xy);
  return {s.area, std::sqrt(12 * std::max(0.0, least) / s.area)};
}

/// Smallest force on the surface of a body that can use all of the strength of one of its sections [N]: a pull with the
/// largest lever that the body offers, or a shear force.
template <int D>
double least_force(const ContactLaw& law, const Model<D>& model, const CrackingBody<D>& body) {
  const double lever = model.body_radius[static_cast<std::size_t>(body.body)];
  double least = std::numeric_limits<double>::infinity();
  with_kernel({law}, [&]<class K>(const K& kernel) {
    if constexpr (K::bonds)
      for (const CrackSection<D>& section : body.sections) {
        const SectionSize size = size_of(body, section);
        const double pull = kernel.tension * size.area / (1 + 6 * lever / size.length);
        least = std::min({least, pull, kernel.cohesion * size.area});
      }
  });
  return least;
}

template <int D>
using FoundForces = std::conditional_t<D == 2, SurfaceForces, SurfaceForces3>;

/// The section of a body that uses most of its strength, and how much.
template <int D>
struct WorstSection {
  SectionUse use;
  int section = -1;
  std::conditional_t<D == 2, PlaneForces, SpaceForces> forces;
};
template <int D>
WorstSection<D> worst_section(const Model<D>& model, const CrackingBody<D>& body, const FoundForces<D>& forces,
                              std::size_t i) {
  WorstSection<D> worst;
  for (std::size_t s = 0; s < body.sections.size(); ++s) {
    const auto f = forces.in_section(i, body.sections[s]);
    const SectionUse use = use_of(model.laws[static_cast<std::size_t>(body.law)], body, body.sections[s], f);
    if (worst.section < 0 || use.share > worst.use.share) worst = {use, static_cast<int>(s), f};
  }
  return worst;
}

/// The crack of a body at the place of its largest stress.
template <int D>
Crack<D> crack_of(const Model<D>& model, const State<D>& state, const CrackingBody<D>& body,
                  const WorstSection<D>& worst) {
  const CrackSection<D>& section = body.sections[static_cast<std::size_t>(worst.section)];
  const auto n = static_cast<std::size_t>(model.bodies[static_cast<std::size_t>(body.body)].first_node);
  Crack<D> crack;
  crack.body = body.body, crack.section = worst.section;
  crack.mode = worst.use.mode, crack.stress = worst.use.stress;
  const auto turn = turn_of(state.rotation[n]);
  if constexpr (D == 2) {
    crack.normal = worst.forces.normal, crack.shear = worst.forces.shear, crack.moment = worst.forces.moment;
    crack.place = state.position[n] + turn.apply(Vec2(section.middle() + worst.use.at * left_of(section.normal)));
  } else {
    crack.forces = worst.forces;
    crack.place = state.position[n] + turn.apply(section.at(worst.use.in_space));
  }
  return crack;
}

/// Meshes have no watch, so that nothing is allocated where all bodies are meshes and none cracks.
template <int D>
CrackSearch<D> search(const Model<D>& model, const State<D>& state, const Work<D>& work, const Cracking<D>& cracking,
                      CrackScratch<D>& scratch, double limit) {
  CrackSearch<D> found;
  if (std::any_of(cracking.bodies.begin(), cracking.bodies.end(), is_mesh<D>)) {
    found = mesh_cracks(model, state, cracking, scratch, limit);
    if (std::all_of(cracking.bodies.begin(), cracking.bodies.end(), is_mesh<D>)) return found;
  }
  found.watch = cracking.watch;
  found.watch.resize(cracking.bodies.size());
  std::vector<double>& load = scratch.load;
  find_surface_loads(model, state, work, cracking, load);
  std::vector<int> bodies, rows;
  for (std::size_t i = 0; i < cracking.bodies.size(); ++i) {
    const CrackWatch& watch = found.watch[i];
    const bool due = state.implicit() || state.step >= watch.next || std::abs(load[i] - watch.load) > watch.change;
    if (is_mesh(cracking.bodies[i]) || !due || !can_crack(model, state, cracking.bodies[i].body)) continue;
    bodies.push_back(cracking.bodies[i].body), rows.push_back(static_cast<int>(i));
  }
  if (bodies.empty()) return found;
  FoundForces<D> forces(model, state, work);
  forces.collect(bodies);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const auto row = static_cast<std::size_t>(rows[k]);
    const WorstSection<D> worst = worst_section(model, cracking.bodies[row], forces, k);
    const CrackingBody<D>& body = cracking.bodies[row];
    const double force = least_force(model.laws[static_cast<std::size_t>(body.law)], model, body);
    found.watch[row] = {state.step + steps_until_next(worst.use.share), load[row],
                        0.5 * std::max(0.0, 1 - worst.use.share) * force};
    found.share = std::max(found.share, worst.use.share);
    if (worst.use.share > limit) found.cracks.push_back(crack_of(model, state, cracking.bodies[row], worst));
  }
  std::sort(found.cracks.begin(), found.cracks.end(),
            [](const Crack<D>& a, const Crack<D>& b) { return a.body < b.body; });
  return found;
}

}  // namespace

CrackSearch<2> search_cracks(const Model<2>& model, const State<2>& state, const Work<2>& work,
                             const Cracking<2>& cracking, CrackScratch<2>& scratch, double limit) {
  return search(model, state, work, cracking, scratch, limit);
}

CrackSearch<3> search_cracks(const Model<3>& model, const State<3>& state, const Work<3>& work,
                             const Cracking<3>& cracking, CrackScratch<3>& scratch, double limit) {
  return search(model, state, work, cracking, scratch, limit);
}

}  // namespace trilith
