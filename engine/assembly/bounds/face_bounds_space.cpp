// Bounds of bodies in space in contact along their stiffest faces, for which the stable step must be short enough.
#include "assembly/bounds/face_bounds.hpp"

#include <cmath>
#include <numbers>

#include "assembly/bounds/local_solids.hpp"
#include "geometry/space/polyhedron.hpp"

namespace trilith {
namespace {

/// Penetration assumed for a sphere without contact, as a share of its radius: deeper than in any valid run. An impact
/// begins without stiffness, and several steps are needed to resolve its energy.
constexpr double usual_cap = 0.3;

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

/// The disc in which a plane cuts a sphere at the depth usual_cap times its radius, at its lowest point.
AreaSprings cap_springs(const ConvexSolid& solid, const ContactTangent& law) {
  const double r = solid.radius, area = std::numbers::pi * usual_cap * (2 - usual_cap) * r * r;
  const Vec3 n = Vec3::UnitZ(), lowest = solid.shape.corners[0] - (1 - usual_cap) * r * n;
  return {lowest, n, area, 8.0 / 15 * std::sqrt(area / std::numbers::pi), {Vec3::Zero(), Vec3::Zero()}, law};
}

/// The stiffest law between the surface of a body and any other.
ContactTangent stiffest_law(const Model<3>& model, const Body& body) {
  ContactTangent most{0, 0, 0};
  int last = -1;
  for (int other = 0; other < model.surfaces; ++other) {
    const int law = model.law_of[body.surface * model.surfaces + other];
    if (law < 0 || law == last) continue;
    last = law;
    const ContactTangent t = solid_tangent(model, law, 0);
    most = {std::max(most.normal, t.normal), std::max(most.shear, t.shear), std::max(most.beta, t.beta)};
  }
  return most;
}

/// Adds the stiffest face of a piece that deforms.
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

/// The stiffest face of a body, against a body that moves too.
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

/// A meshed body as if it were rigid, in contact all around, half as stiff as in full contact with moving bodies. This
/// is at least the stiffness of its largest side, because no flat side is larger than half of the surface.
RateBound around_surface(const Model<3>& model, int body) {
  const Body& b = model.bodies[static_cast<std::size_t>(body)];
  const ContactTangent law = stiffest_law(model, b);
  if (!(law.normal > 0)) return {};
  const ScaledWhole whole(whole_body(model, model.start_position, body));
  LocalSolid local;
  for (int p = b.first_piece; p < b.first_piece + b.pieces; ++p) {
    const ConvexSolid& solid = model.piece_solid[static_cast<std::size_t>(p)];
    const Vec3& origin = model.start_position[static_cast<std::size_t>(model.node_of_piece(p))];
    for (int f = 0; f < solid.shape.faces.count(); ++f) {
      if (!solid.is_surface(f)) continue;
      AreaSprings springs = face_springs(solid, f, law);
      springs.arm += origin - whole.centre;
      add_area(springs, whole, 1, local);
    }
  }
  return {largest_bound(local.k), largest_bound(local.c)};
}

}  // namespace

void bound_faces(const Model<3>& model, Work<3>& work) {
  work.face_bound.assign(model.bodies.size(), {});
  NodeRows rows = rows_of(model);
  work.around_bound.assign(model.bodies.size(), {});
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    if (!model.body_moves(static_cast<int>(b))) continue;
    work.face_bound[b] = on_stiffest_face(model, model.bodies[b], rows);
    if (is_of_elements(model.bodies[b])) work.around_bound[b] = around_surface(model, static_cast<int>(b));
  }
}

}  // namespace trilith
