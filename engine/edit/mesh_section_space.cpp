// Stress in the section of a mesh in space, carried by the faces of its cut as plates.
#include <array>
#include <cmath>
#include <utility>

#include "edit/mesh_section.hpp"
#include "element/corotation_3d.hpp"

namespace trilith {
namespace {

/// The conjugate gradients end at this share of the forces, or after so many rounds. With its diagonal the system has
/// eigenvalues between 0.2 and 3 for all shapes of faces, so about 30 rounds are enough.
constexpr double solved_share = 1e-12;
constexpr int most_solver_rounds = 200;

/// Products of the matrix of all faces, with the entries of FaceProducts::products.
void times_products(const SpaceCut& cut, const std::vector<Vec3>& stress, std::vector<Vec3>& force) {
  force.assign(stress.size(), Vec3::Zero());
  for (const CutFace& face : cut.plates)
    for (int i = 0; i < face.nodes; ++i)
      for (int j = 0; j < face.nodes; ++j)
        force[static_cast<std::size_t>(face.node[static_cast<std::size_t>(i)])] +=
            face.integrals.products(i, j) * stress[static_cast<std::size_t>(face.node[static_cast<std::size_t>(j)])];
}

double product_of(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
  return sum;
}

void add_times(double share, const std::vector<Vec3>& what, std::vector<Vec3>& to) {
  for (std::size_t i = 0; i < what.size(); ++i) to[i] += share * what[i];
}

void divide_by(const std::vector<double>& diagonal, const std::vector<Vec3>& what, std::vector<Vec3>& out) {
  out = what;
  for (std::size_t i = 0; i < out.size(); ++i) out[i] /= diagonal[i];
}

/// `solved` becomes the stress at the nodes that has the nodal forces `rest`, by conjugate gradients with the diagonal
/// as preconditioner.
void solve_stress(const SpaceCut& cut, CutScratch<3>& s) {
  s.diagonal.assign(cut.nodes.size(), 0.0);
  for (const CutFace& face : cut.plates)
    for (int i = 0; i < face.nodes; ++i)
      s.diagonal[static_cast<std::size_t>(face.node[static_cast<std::size_t>(i)])] += face.integrals.products(i, i);
  s.unmet = s.rest;
  s.solved.assign(cut.nodes.size(), Vec3::Zero());
  divide_by(s.diagonal, s.unmet, s.step);
  double size = product_of(s.unmet, s.step);
  const double enough = solved_share * solved_share * size;
  for (int round = 0; round < most_solver_rounds && size > enough; ++round) {
    times_products(cut, s.step, s.moved);
    const double share = size / product_of(s.step, s.moved);
    add_times(share, s.step, s.solved);
    add_times(-share, s.moved, s.unmet);
    divide_by(s.diagonal, s.unmet, s.next);
    const double now = product_of(s.unmet, s.next);
    add_times(now / size, s.step, s.next);
    std::swap(s.step, s.next), size = now;
  }
}

/// Resultants of a stress at the nodes over a face: the integrals of N are mean times area, and the integrals of N s
/// the second moments times the gradient.
SpaceForces resultants(const CutFace& face, const PlacedPlate& now, const std::vector<Vec3>& stress) {
  const Vec3 x = now.turn * face.fit.x, y = now.turn * face.fit.y;
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
  for (std::size_t i = 0; i < static_cast<std::size_t>(face.nodes); ++i) {
    const Vec3& at = stress[static_cast<std::size_t>(face.node[i])];
    const Vec2 first = face.integrals.second * face.fit.gradient[i];
    force += face.fit.area * face.fit.mean[i] * at;
    moment += cross(Vec3(first.x() * x + first.y() * y), at);
  }
  moment += cross(Vec3(now.turn * (face.fit.middle - face.section.centre)), force);
  const CrackSection<3>& s = face.section;
  const Vec3 sx = now.turn * s.x, sy = now.turn * s.y, sn = now.turn * s.normal;
  return {sn.dot(force), {sx.dot(force), sy.dot(force)}, {sx.dot(moment), sy.dot(moment)}, sn.dot(moment)};
}

/// The stretch of a plate is left out: its rotation alone maps moments to nodes, as in spread_fitted for small strains.
Vec3 turned_gradient(const CutFace& face, const PlacedPlate& now, std::size_t i) {
  return now.turn * (face.fit.gradient[i].x() * face.fit.x + face.fit.gradient[i].y() * face.fit.y);
}

void place_plates(const Model<3>& model, const State<3>& state, int body, const SpaceCut& cut, CutScratch<3>& s) {
  const int first = model.bodies[static_cast<std::size_t>(body)].first_node;
  s.node.clear(), s.plate.clear();
  for (const int n : cut.nodes) s.node.push_back(state.position[static_cast<std::size_t>(first + n)]);
  for (const CutFace& face : cut.plates) s.plate.push_back(placed_plate(s.node, face));
}

}  // namespace

PlacedPlate placed_plate(const std::vector<Vec3>& nodes, const CutFace& face) {
  Vec3 along = Vec3::Zero(), across = Vec3::Zero(), middle = Vec3::Zero();
  for (std::size_t i = 0; i < static_cast<std::size_t>(face.nodes); ++i) {
    const Vec3& x = nodes[static_cast<std::size_t>(face.node[i])];
    middle += face.fit.mean[i] * x;
    along += face.fit.gradient[i].x() * x, across += face.fit.gradient[i].y() * x;
  }
  Eigen::Matrix3d start;
  start.col(0) = face.fit.x, start.col(1) = face.fit.y, start.col(2) = face.fit.normal;
  PlacedPlate now;
  now.turn = fitted_face_turn(along, across).axes * start.transpose();
  now.centre = middle + now.turn * (face.section.centre - face.fit.middle);
  return now;
}

void add_plate_forces(const CutFace& face, const PlacedPlate& now, const SpaceForces& forces,
                      std::vector<Vec3>& node_force) {
  const CrackSection<3>& s = face.section;
  const Vec3 force = now.turn * (forces.shear.x() * s.x + forces.shear.y() * s.y + forces.normal * s.normal);
  Vec3 moment = now.turn * (forces.bending.x() * s.x + forces.bending.y() * s.y + forces.torsion * s.normal);
  moment += cross(Vec3(now.turn * (s.centre - face.fit.middle)), force);
  const Vec3 n = now.turn * face.fit.normal;
  const Vec3 couple = moment - 0.5 * n.dot(moment) * n;
  for (std::size_t i = 0; i < static_cast<std::size_t>(face.nodes); ++i)
    node_force[static_cast<std::size_t>(face.node[i])] +=
        face.fit.mean[i] * force + cross(couple, turned_gradient(face, now, i));
}

const std::vector<SpaceForces>& plate_forces(const Model<3>& model, const State<3>& state, int body,
                                             const SpaceCut& cut, CrackScratch<3>& scratch, int rounds) {
  const std::vector<Vec3>& whole = cut_forces(model, state, body, cut, scratch);
  CutScratch<3>& s = scratch.cut;
  place_plates(model, state, body, cut, s);
  s.rest = whole;
  s.stress.assign(whole.size(), Vec3::Zero());
  s.plate_force.resize(cut.plates.size());
  for (int round = 0; round <= rounds; ++round) {
    solve_stress(cut, s);
    add_times(1, s.solved, s.stress);
    s.rest = whole;
    s.carried.assign(whole.size(), Vec3::Zero());
    for (std::size_t f = 0; f < s.plate_force.size(); ++f) {
      s.plate_force[f] = resultants(cut.plates[f], s.plate[f], s.stress);
      if (round < rounds) add_plate_forces(cut.plates[f], s.plate[f], s.plate_force[f], s.carried);
    }
    if (round < rounds) add_times(-1, s.carried, s.rest);
  }
  return s.plate_force;
}

std::array<Vec3, 2> packed_forces(const SpaceForces& f) {
  return {Vec3(f.shear.x(), f.shear.y(), f.normal), Vec3(f.bending.x(), f.bending.y(), f.torsion)};
}

SpaceForces unpacked_forces(const Crack<3>& crack, std::size_t face) {
  const Vec3 &force = crack.traction[2 * face], &moment = crack.traction[2 * face + 1];
  return {force.z(), force.head<2>(), moment.head<2>(), moment.z()};
}

/// The corrections are for a body that cracks alone: its strength is compared with the stress of the first solution.
WorstPlace<3> worst_place(const Model<3>& model, const State<3>& state, const CrackingBody<3>& row, const MeshCut& cut,
                          CrackScratch<3>& scratch, double limit) {
  constexpr int corrections = 4;
  const SpaceCut& faces = space_cut(cut);
  const ContactLaw& law = model.laws[static_cast<std::size_t>(row.law)];
  const std::vector<SpaceForces>& forces = plate_forces(model, state, row.body, faces, scratch, 0);
  WorstPlace<3> worst;
  std::size_t at = 0;
  for (std::size_t f = 0; f < forces.size(); ++f) {
    const SectionUse use = section_use(law, faces.plates[f].section, forces[f]);
    if (use.share > worst.use.share) worst.use = use, at = f;
  }
  if (!(worst.use.share > limit)) return worst;
  const PlacedPlate now = scratch.cut.plate[at];
  const CrackSection<3>& section = faces.plates[at].section;
  worst.place = now.centre + now.turn * (section.at(worst.use.in_space) - section.centre);
  for (const SpaceForces& f : plate_forces(model, state, row.body, faces, scratch, corrections))
    for (const Vec3& part : packed_forces(f)) worst.traction.push_back(part);
  return worst;
}

}  // namespace trilith
