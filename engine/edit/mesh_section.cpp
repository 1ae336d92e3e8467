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

/// Writes the edge from each node of a cut to the next, and zero where a chain ends. `at(node)`: position.
template <class At>
void set_edges(const MeshCut& cut, At&& at, std::vector<Vec2>& along) {
  along.assign(cut.nodes.size(), Vec2::Zero());
  std::size_t face = 0;
  for (std::size_t i = 0; i + 1 < cut.nodes.size(); ++i) {
    if (face == cut.faces.size() || cut.faces[face][0] != cut.nodes[i] || cut.faces[face][1] != cut.nodes[i + 1])
      continue;
    along[i] = at(cut.nodes[i + 1]) - at(cut.nodes[i]);
    ++face;
  }
}
void set_edges_now(const Model<2>& model, const State<2>& state, int body, const MeshCut& cut,
                   std::vector<Vec2>& along) {
  const std::size_t first = first_node(model, body);
  set_edges(
      cut, [&](int n) { return state.position[first + static_cast<std::size_t>(n)]; }, along);
}
std::vector<Vec2> edges_at_start(const Model<2>& model, int body, const MeshCut& cut) {
  const std::size_t first = first_node(model, body);
  std::vector<Vec2> along;
  set_edges(
      cut, [&](int n) { return model.start_position[first + static_cast<std::size_t>(n)]; }, along);
  return along;
}

/// Adds the forces of an element to the forces of `work`.
void add_forces(const Model<2>& model, const State<2>& state, Work<2>& work, std::size_t e) {
  element_forces(model, state, work, static_cast<int>(e));
}
void add_forces(const Model<3>& model, const State<3>& state, Work<3>& work, std::size_t e) {
  const SpaceElement& element = model.space_elements[e];
  SpaceElementAnswer answer;
  element_forces(model, state, work, static_cast<int>(e), answer);
  const bool damped = model.solids[static_cast<std::size_t>(element.solid)].damping() > 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(nodes_of(element)); ++i) {
    const auto n = static_cast<std::size_t>(element.node[i]);
    work.element_force[n] -= answer.force[i];
    if (damped) work.element_damping[n] -= answer.damping[i];
  }
}

/// Internal forces of the elements on one side at the nodes of a cut. The forces of `work` are 0 before and after.
template <int D>
void set_side(const Model<D>& model, const State<D>& state, int body, const MeshCut& cut, std::size_t side,
              CrackScratch<D>& scratch) {
  const std::size_t first = first_node(model, body);
  const auto from = static_cast<std::size_t>(first_element_of(model, body));
  Work<D>& work = scratch.work;
  const auto each = [&](auto&& see) {
    for (const int e : cut.elements)
      if ((cut.behind[static_cast<std::size_t>(e)] != 0) == (side == 0)) see(from + static_cast<std::size_t>(e));
  };
  each([&](std::size_t e) { add_forces(model, state, work, e); });
  scratch.side[side].clear();
  for (const int node : cut.nodes) {
    const std::size_t n = first + static_cast<std::size_t>(node);
    scratch.side[side].emplace_back(work.element_force[n] + work.element_damping[n]);
  }
  each([&](std::size_t e) {
    const auto& element = elements_of(model)[e];
    for (int i = 0; i < nodes_of(element); ++i) {
      const auto n = static_cast<std::size_t>(element.node[static_cast<std::size_t>(i)]);
      work.element_force[n].setZero(), work.element_damping[n].setZero();
    }
  });
}

/// Solves the tridiagonal system with the diagonal of the edges' lengths / 3 and length / 6 next to it: nodal forces
/// become stresses.
void stress_from_forces(double thickness, CutScratch<2>& cut, std::vector<Vec2>& force) {
  const std::size_t count = force.size();
  std::vector<double>&diagonal = cut.diagonal, &beside = cut.beside;
  diagonal.assign(count, 0), beside.assign(count, 0);
  for (std::size_t i = 0; i + 1 < count; ++i) {
    const double length = thickness * cut.along[i].norm();
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
                          CrackScratch<2>& scratch, double limit) {
  WorstPlace<2> worst;
  const std::vector<Vec2>& traction = mesh_tractions(model, state, row.body, cut, scratch);
  const std::vector<Vec2>& along = scratch.cut.along;
  std::size_t edge = 0;
  const double share = model.thickness / row.depth;  // stress of the elements over stress of the contacts
  for (std::size_t i = 0; i + 1 < along.size(); ++i) {
    if (along[i].isZero(0)) continue;
    const SectionUse use =
        edge_use(model.laws[static_cast<std::size_t>(row.law)], along[i], share * traction[i], share * traction[i + 1]);
    if (use.share > worst.use.share) worst.use = use, edge = i;
  }
  if (!(worst.use.share > limit)) return worst;
  const std::size_t from = first_node(model, row.body) + static_cast<std::size_t>(cut.nodes[edge]);
  worst.place = state.position[from] + (0.5 + worst.use.at / along[edge].norm()) * along[edge];
  const std::vector<Turn> turns = turns_of_cut(model, state, row.body, cut);
  for (std::size_t i = 0; i < turns.size(); ++i) worst.traction.push_back(turns[i].undo(traction[i]));
  return worst;
}

namespace {

/// The section of a mesh that uses most of its strength, if this is more than the share `limit`. `share`: becomes at
/// least the largest share of its sections.
template <int D>
std::optional<Crack<D>> mesh_crack(const Model<D>& model, const State<D>& state, const CrackingBody<D>& row,
                                   CrackScratch<D>& scratch, double limit, double& share) {
  std::optional<Crack<D>> found;
  double most = limit;
  for (std::size_t s = 0; s < row.sections.size(); ++s) {
    WorstPlace<D> worst = worst_place(model, state, row, *row.sections[s].cut, scratch, most);
    share = std::max(share, worst.use.share);
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
  std::vector<Vec2> now;
  set_edges_now(model, state, body, cut, now);
  const std::vector<Vec2> start = edges_at_start(model, body, cut);
  std::vector<Turn> turns;
  for (std::size_t i = 0; i < now.size(); ++i) {
    const Vec2 to = now[i] + (i > 0 ? now[i - 1] : Vec2(Vec2::Zero()));
    const Vec2 from = start[i] + (i > 0 ? start[i - 1] : Vec2(Vec2::Zero()));
    turns.emplace_back(portable::atan2(cross(from, to), from.dot(to)));
  }
  return turns;
}

template <int D>
const std::vector<Vec<D>>& cut_forces(const Model<D>& model, const State<D>& state, int body, const MeshCut& cut,
                                      CrackScratch<D>& scratch) {
  scratch.work.element_force.resize(model.mass.size(), Vec<D>::Zero());
  scratch.work.element_damping.resize(model.mass.size(), Vec<D>::Zero());
  scratch.work.plastic.resize(state.plastic.size());
  for (const std::size_t side : {0, 1}) set_side(model, state, body, cut, side, scratch);
  scratch.force.clear();
  for (std::size_t i = 0; i < cut.nodes.size(); ++i) {
    const double behind = mass_on_side<D>(cut, 0, i), ahead = mass_on_side<D>(cut, 1, i);
    scratch.force.emplace_back((behind * scratch.side[1][i] - ahead * scratch.side[0][i]) / (behind + ahead));
  }
  return scratch.force;
}
template const std::vector<Vec2>& cut_forces(const Model<2>&, const State<2>&, int, const MeshCut&, CrackScratch<2>&);
template const std::vector<Vec3>& cut_forces(const Model<3>&, const State<3>&, int, const MeshCut&, CrackScratch<3>&);

const std::vector<Vec2>& mesh_tractions(const Model<2>& model, const State<2>& state, int body, const MeshCut& cut,
                                        CrackScratch<2>& scratch) {
  cut_forces(model, state, body, cut, scratch);
  set_edges_now(model, state, body, cut, scratch.cut.along);
  stress_from_forces(model.thickness, scratch.cut, scratch.force);
  return scratch.force;
}

template <int D>
CrackSearch<D> mesh_cracks(const Model<D>& model, const State<D>& state, const Cracking<D>& cracking,
                           CrackScratch<D>& scratch, double limit) {
  CrackSearch<D> found;
  for (const CrackingBody<D>& row : cracking.bodies) {
    if (!row.sections.front().cut || state.left[static_cast<std::size_t>(row.body)] != 0) continue;
    if (auto crack = mesh_crack(model, state, row, scratch, limit, found.share))
      found.cracks.push_back(std::move(*crack));
  }
  return found;
}
template CrackSearch<2> mesh_cracks(const Model<2>&, const State<2>&, const Cracking<2>&, CrackScratch<2>&, double);
template CrackSearch<3> mesh_cracks(const Model<3>&, const State<3>&, const Cracking<3>&, CrackScratch<3>&, double);

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
