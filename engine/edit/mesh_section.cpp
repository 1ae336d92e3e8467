#include "edit/mesh_section.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "assembly/single_terms.hpp"
#include "base/portable.hpp"
#include "edit/mesh_parts.hpp"
#include "element/solid/plane_element.hpp"
#include "law/contact/list.hpp"

namespace trilith {
namespace {

/// Edges whose directions differ by less than this sine are in one line.
constexpr double same_direction = 1e-6;

template <int D>
std::size_t first_node(const Model<D>& model, int body) {
  return static_cast<std::size_t>(model.bodies[static_cast<std::size_t>(body)].first_node);
}

/// The edge from each node of a cut to the next, and zero where a chain ends. `at(node)`: position.
template <class At>
std::vector<Vec2> edges_along(const MeshCut& cut, At&& at) {
  std::vector<Vec2> along(cut.nodes.size(), Vec2::Zero());
  std::size_t face = 0;
  for (std::size_t i = 0; i + 1 < cut.nodes.size(); ++i) {
    if (face == cut.faces.size() || cut.faces[face][0] != cut.nodes[i] || cut.faces[face][1] != cut.nodes[i + 1])
      continue;
    along[i] = at(cut.nodes[i + 1]) - at(cut.nodes[i]);
    ++face;
  }
  return along;
}
std::vector<Vec2> edges_now(const Model<2>& model, const State<2>& state, int body, const MeshCut& cut) {
  const std::size_t first = first_node(model, body);
  return edges_along(cut, [&](int n) { return state.position[first + static_cast<std::size_t>(n)]; });
}
std::vector<Vec2> edges_at_start(const Model<2>& model, int body, const MeshCut& cut) {
  const std::size_t first = first_node(model, body);
  return edges_along(cut, [&](int n) { return model.start_position[first + static_cast<std::size_t>(n)]; });
}

/// Internal forces and masses of the elements on both sides at the nodes of a cut.
template <int D>
struct SideSums {
  std::vector<Vec<D>> force[2];  // [behind, ahead][node of the cut] [N]
  std::vector<double> mass[2];   // relative
};

/// Adds the areas of the nodes of an element, to which their masses are proportional.
void add_areas(const Model<2>& model, const Element& element, std::size_t first, std::vector<double>& area) {
  std::vector<Vec2> corners;
  for (std::size_t i = 0; i < static_cast<std::size_t>(element.nodes); ++i)
    corners.push_back(model.start_position[static_cast<std::size_t>(element.node[i])]);
  const auto own = node_areas(corners);
  for (std::size_t i = 0; i < corners.size(); ++i) area[static_cast<std::size_t>(element.node[i]) - first] += own[i];
}

/// Adds the forces of an element to the forces of `scratch`.
void add_forces(const Model<2>& model, const State<2>& state, Work<2>& scratch, std::size_t e) {
  element_forces(model, state, scratch, static_cast<int>(e));
}
void add_forces(const Model<3>& model, const State<3>& state, Work<3>& scratch, std::size_t e) {
  const SpaceElement& element = model.space_elements[e];
  SpaceElementAnswer answer;
  element_forces(model, state, scratch, static_cast<int>(e), answer);
  const bool damped = model.solids[static_cast<std::size_t>(element.solid)].damping() > 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(nodes_of(element)); ++i) {
    const auto n = static_cast<std::size_t>(element.node[i]);
    scratch.element_force[n] -= answer.force[i];
    if (damped) scratch.element_damping[n] -= answer.damping[i];
  }
}

/// The forces of `scratch` are 0 before and after.
template <int D>
void add_side(const Model<D>& model, const State<D>& state, int body, const MeshCut& cut, int side, Work<D>& scratch,
              SideSums<D>& sums) {
  const std::size_t first = first_node(model, body);
  const auto from = static_cast<std::size_t>(first_element_of(model, body));
  std::vector<double> area;
  if constexpr (D == 2) area.resize(static_cast<std::size_t>(model.bodies[static_cast<std::size_t>(body)].nodes));
  const auto each = [&](auto&& see) {
    for (const int e : cut.elements)
      if ((cut.behind[static_cast<std::size_t>(e)] != 0) == (side == 0)) see(from + static_cast<std::size_t>(e));
  };
  each([&](std::size_t e) {
    add_forces(model, state, scratch, e);
    if constexpr (D == 2) add_areas(model, model.elements[e], first, area);
  });
  for (std::size_t i = 0; i < cut.nodes.size(); ++i) {
    const auto n = static_cast<std::size_t>(cut.nodes[i]);
    sums.force[side].emplace_back(scratch.element_force[first + n] + scratch.element_damping[first + n]);
    if constexpr (D == 2)
      sums.mass[side].push_back(area[n]);
    else
      sums.mass[side].push_back(side == 0 ? space_cut(cut).behind_share[i] : 1 - space_cut(cut).behind_share[i]);
  }
  each([&](std::size_t e) {
    const auto& element = elements_of(model)[e];
    for (int i = 0; i < nodes_of(element); ++i) {
      const auto n = static_cast<std::size_t>(element.node[static_cast<std::size_t>(i)]);
      scratch.element_force[n].setZero(), scratch.element_damping[n].setZero();
    }
  });
}

template <int D>
SideSums<D> side_sums(const Model<D>& model, const State<D>& state, int body, const MeshCut& cut, Work<D>& scratch) {
  scratch.element_force.resize(model.mass.size(), Vec<D>::Zero());
  scratch.element_damping.resize(model.mass.size(), Vec<D>::Zero());
  scratch.plastic.resize(state.plastic.size());
  SideSums<D> sums;
  for (const int side : {0, 1}) add_side(model, state, body, cut, side, scratch, sums);
  return sums;
}

/// Solves the tridiagonal system with the diagonal of the edges' lengths / 3 and length / 6 next to it.
std::vector<Vec2> stress_from_forces(std::vector<Vec2> force, const std::vector<Vec2>& along, double thickness) {
  const std::size_t count = force.size();
  std::vector<double> diagonal(count, 0), beside(count, 0);
  for (std::size_t i = 0; i + 1 < count; ++i) {
    const double length = thickness * along[i].norm();
    diagonal[i] += length / 3, diagonal[i + 1] += length / 3, beside[i] = length / 6;
  }
  for (std::size_t i = 1; i < count; ++i) {
    const double share = beside[i - 1] / diagonal[i - 1];
    diagonal[i] -= share * beside[i - 1];
    force[i] -= share * force[i - 1];
  }
  for (std::size_t i = count; i-- > 0;) {
    if (i + 1 < count) force[i] -= beside[i] * force[i + 1];
    force[i] /= diagonal[i];
  }
  return force;
}

/// An edge of a cut as a section of its own: the stress is linear over it.
SectionUse edge_use(const ContactLaw& law, const Vec2& along, const Vec2& from, const Vec2& to) {
  const double length = along.norm();
  const Vec2 d = along / length, normal(d.y(), -d.x());
  const double first = normal.dot(from), last = normal.dot(to);
  return section_use(law, 0.5 * length * (first + last), 0.5 * length * d.dot(Vec2(from + to)),
                     length * length / 12 * (first - last), length, 1);
}

}  // namespace

WorstPlace<2> worst_place(const Model<2>& model, const State<2>& state, const CrackingBody<2>& row, const MeshCut& cut,
                          Work<2>& scratch) {
  WorstPlace<2> worst;
  worst.traction = mesh_tractions(model, state, row.body, cut, scratch);
  const std::vector<Vec2> along = edges_now(model, state, row.body, cut);
  std::size_t edge = 0;
  const double share = model.thickness / row.depth;  // stress of the elements over stress of the contacts
  for (std::size_t i = 0; i + 1 < along.size(); ++i) {
    if (along[i].isZero(0)) continue;
    const SectionUse use = edge_use(model.laws[static_cast<std::size_t>(row.law)], along[i], share * worst.traction[i],
                                    share * worst.traction[i + 1]);
    if (use.share > worst.use.share) worst.use = use, edge = i;
  }
  if (!(worst.use.share > 1)) return worst;
  const std::size_t from = first_node(model, row.body) + static_cast<std::size_t>(cut.nodes[edge]);
  worst.place = state.position[from] + (0.5 + worst.use.at / along[edge].norm()) * along[edge];
  const std::vector<Turn> turns = turns_of_cut(model, state, row.body, cut);
  for (std::size_t i = 0; i < turns.size(); ++i) worst.traction[i] = turns[i].undo(worst.traction[i]);
  return worst;
}

namespace {

/// The section of a mesh that uses most of its strength, if this is more than all.
template <int D>
std::optional<Crack<D>> mesh_crack(const Model<D>& model, const State<D>& state, const CrackingBody<D>& row,
                                   Work<D>& scratch) {
  std::optional<Crack<D>> found;
  double most = 1;
  for (std::size_t s = 0; s < row.sections.size(); ++s) {
    WorstPlace<D> worst = worst_place(model, state, row, *row.sections[s].cut, scratch);
    if (!(worst.use.share > most)) continue;
    most = worst.use.share;
    Crack<D>& crack = found.emplace();
    crack.body = row.body, crack.section = static_cast<int>(s);
    crack.mode = worst.use.mode, crack.stress = worst.use.stress;
    crack.place = worst.place, crack.traction = std::move(worst.traction);
  }
  return found;
}

}  // namespace

std::vector<Turn> turns_of_cut(const Model<2>& model, const State<2>& state, int body, const MeshCut& cut) {
  const std::vector<Vec2> now = edges_now(model, state, body, cut), start = edges_at_start(model, body, cut);
  std::vector<Turn> turns;
  for (std::size_t i = 0; i < now.size(); ++i) {
    const Vec2 to = now[i] + (i > 0 ? now[i - 1] : Vec2(Vec2::Zero()));
    const Vec2 from = start[i] + (i > 0 ? start[i - 1] : Vec2(Vec2::Zero()));
    turns.emplace_back(portable::atan2(cross(from, to), from.dot(to)));
  }
  return turns;
}

template <int D>
std::vector<Vec<D>> cut_forces(const Model<D>& model, const State<D>& state, int body, const MeshCut& cut,
                               Work<D>& scratch) {
  const SideSums<D> sums = side_sums(model, state, body, cut, scratch);
  std::vector<Vec<D>> force;
  for (std::size_t i = 0; i < cut.nodes.size(); ++i) {
    const double behind = sums.mass[0][i], ahead = sums.mass[1][i];
    force.emplace_back((behind * sums.force[1][i] - ahead * sums.force[0][i]) / (behind + ahead));
  }
  return force;
}
template std::vector<Vec2> cut_forces(const Model<2>&, const State<2>&, int, const MeshCut&, Work<2>&);
template std::vector<Vec3> cut_forces(const Model<3>&, const State<3>&, int, const MeshCut&, Work<3>&);

std::vector<Vec2> mesh_tractions(const Model<2>& model, const State<2>& state, int body, const MeshCut& cut,
                                 Work<2>& scratch) {
  return stress_from_forces(cut_forces(model, state, body, cut, scratch), edges_now(model, state, body, cut),
                            model.thickness);
}

template <int D>
std::vector<Crack<D>> mesh_cracks(const Model<D>& model, const State<D>& state, const Cracking<D>& cracking) {
  std::vector<Crack<D>> cracks;
  Work<D> scratch;
  for (const CrackingBody<D>& row : cracking.bodies) {
    if (!row.sections.front().cut || state.left[static_cast<std::size_t>(row.body)] != 0) continue;
    if (auto crack = mesh_crack(model, state, row, scratch)) cracks.push_back(std::move(*crack));
  }
  return cracks;
}
template std::vector<Crack<2>> mesh_cracks(const Model<2>&, const State<2>&, const Cracking<2>&);
template std::vector<Crack<3>> mesh_cracks(const Model<3>&, const State<3>&, const Cracking<3>&);

std::vector<Vec2> cut_openings(const Model<2>& model, int body, const MeshCut& cut, const std::vector<Vec2>& traction,
                               const ContactLaw& law) {
  const double kn = with_kernel({law}, [](const auto& kernel) { return kernel.kn; });
  const std::vector<Vec2> along = edges_at_start(model, body, cut);
  std::vector<Vec2> opening;
  for (std::size_t i = 0; i < along.size(); ++i) {
    Vec2 open = traction[i] / kn;
    const Vec2 before = i > 0 && !along[i - 1].isZero(0) ? along[i - 1] : along[i];
    const Vec2 after = along[i].isZero(0) ? before : along[i];
    if (std::abs(cross(before, after)) < same_direction * before.norm() * after.norm()) {
      const Vec2 normal = left_of(Vec2(before + after)).normalized();
      open = normal.dot(open) * normal;
    }
    opening.push_back(open);
  }
  return opening;
}

}  // namespace trilith
