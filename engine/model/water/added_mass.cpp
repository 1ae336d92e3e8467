#include "model/water/added_mass.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "base/portable.hpp"
#include "model/contact/skin_places.hpp"
#include "model/pose.hpp"
#include "model/water/water.hpp"

namespace trilith {
namespace {

constexpr int strips = 24;
/// Terms of Westergaard's series; the integrals decrease with the cube of their number.
constexpr int last_term = 801;
/// Largest deviation of the face from an upright plane, over its depth.
constexpr double most_lean = 0.05;

/// Integrals of the series from 0 to z.
StripMass series_to(double depth, double z) {
  StripMass sum;
  double sign = 1;
  for (int n = 1; n <= last_term; n += 2, sign = -sign) {
    const double k = n * std::numbers::pi / (2 * depth), factor = sign / (static_cast<double>(n) * n);
    const portable::SineCosine at = portable::sine_cosine(k * z);
    sum.mass += factor * at.sine / k;
    sum.moment += factor * (z * at.sine / k + (at.cosine - 1) / (k * k));
  }
  const double scale = 8 * depth / (std::numbers::pi * std::numbers::pi);
  return {scale * sum.mass, scale * sum.moment};
}

/// Integrals of the parabola over depths from 0 to y below the surface; the moment is about the surface.
StripMass parabola_to(double depth, double y) {
  const double scale = 0.875 * std::sqrt(depth), root = std::sqrt(y);
  return {scale * y * root / 1.5, scale * y * y * root / 2.5};
}

/// A point of the wetted face at an elevation: the middle of its faces that reach it.
Vec2 point_of_face(const Model<2>& model, int body, const Vec3& side, double z, const std::string& owner) {
  for (const FacePart& f : faces_on_side(model, body, Vec2(side.x(), 0))) {
    const Vec2 a = skin_start(model, f.skin_a), b = skin_start(model, f.skin_b);
    if (z < std::min(a.y(), b.y()) - 1e-9 || z > std::max(a.y(), b.y()) + 1e-9) continue;
    if (std::abs(a.x() - b.x()) > most_lean * std::abs(a.y() - b.y())) continue;
    return a + (z - a.y()) / (b.y() - a.y()) * (b - a);
  }
  throw InputError(
      fmt::format("{}: '{}' has no upright face on that side at the elevation {:g} m; give the level and the "
                  "bed within one",
                  owner, model.bodies[static_cast<std::size_t>(body)].name, z));
}
Vec3 point_of_face(const Model<3>& model, int body, const Vec3& side, double z, const std::string& owner) {
  double low = unbounded, high = -unbounded;
  Vec3 sum = Vec3::Zero();
  int count = 0;
  for (const WetFace<3>& face : wet_faces(model, body, faces_on_side(model, body, side))) {
    const BodyMotion frame = start_of(model, face.at.node[0]);
    const Turn3 turn = turn_of(frame.rotation);
    if (turn.apply(face.normal).dot(side) < 1 - most_lean) continue;
    for (const Vec3& corner : face.corners) {
      const Vec3 x = frame.place + turn.apply(corner);
      low = std::min(low, x.z()), high = std::max(high, x.z()), sum += x, ++count;
    }
  }
  if (count == 0 || z < low - 1e-9 || z > high + 1e-9)
    throw InputError(
        fmt::format("{}: '{}' has no upright face on that side at the elevation {:g} m; give the level and "
                    "the bed within one",
                    owner, model.bodies[static_cast<std::size_t>(body)].name, z));
  return {sum.x() / count, sum.y() / count, z};
}

/// Attaches a mass at a point of the body at the start.
void add_point(const Model<2>& model, const Vec2& at, const Vec3& along, double mass, const std::string& owner,
               AddedMass<2>& out) {
  const Attachment<2> point = tie_point(model, out.body, at, owner);
  const Vec2 way(along.x(), along.y());
  out.points.push_back({point, way, mass});
}
void add_point(const Model<3>& model, const Vec3& at, const Vec3& along, double mass, const std::string& owner,
               AddedMass<3>& out) {
  const Attachment<3> point = tie_point(model, out.body, at);
  if (point.node[0] < 0)
    throw InputError(owner +
                     ": in space added mass acts on rigid bodies and frames, and this body is made of elements");
  out.points.push_back({point, turn_of(start_of(model, point.node[0]).rotation).undo(along), mass});
}

Vec2 axis_point(const Model<2>& model, int body, double z) {
  return {body_start(model, body).x(), z};
}
Vec3 axis_point(const Model<3>& model, int body, double z) {
  const Vec3& x =
      model.start_position[static_cast<std::size_t>(model.bodies[static_cast<std::size_t>(body)].first_node)];
  return {x.x(), x.y(), z};
}

double width_of(const Model<2>& model, int body, const AddedMassSpec& /*spec*/) {
  return depth_of(model, body);
}
double width_of(const Model<3>& /*model*/, int /*body*/, const AddedMassSpec& spec) {
  return spec.width;
}

/// The part of the depth that a body has, above the bed, in strips [m].
struct Wetted {
  double low, height;

  explicit Wetted(const AddedMassSpec& spec)
      : low(spec.from.value_or(spec.bed) - spec.bed),
        height((spec.to.value_or(spec.level) - spec.bed - low) / strips) {}
};

template <int D>
void add_cylinder(const Model<D>& model, const AddedMassSpec& spec, const std::string& owner, AddedMass<D>& out) {
  require_positive(spec.radius, owner + ": radius", "m");
  const Wetted part(spec);
  const double mass = spec.density * std::numbers::pi * spec.radius * spec.radius * part.height;
  for (int i = 0; i < strips; ++i) {
    const auto at = axis_point(model, out.body, spec.bed + part.low + (i + 0.5) * part.height);
    for (int k = 0; k < D - 1; ++k) add_point(model, at, Vec3(Vec3::Unit(k)), mass, owner, out);
  }
}

}  // namespace

StripMass strip_mass(AddedMassForm form, double depth, double z0, double z1) {
  if (form == AddedMassForm::cylinder) return {z1 - z0, 0.5 * (z1 * z1 - z0 * z0)};
  if (form == AddedMassForm::exact) {
    const StripMass a = series_to(depth, z0), b = series_to(depth, z1);
    return {b.mass - a.mass, b.moment - a.moment};
  }
  const StripMass a = parabola_to(depth, depth - z1), b = parabola_to(depth, depth - z0);
  const double mass = b.mass - a.mass;
  return {mass, depth * mass - (b.moment - a.moment)};
}

template <int D>
AddedMass<D> make_added_mass(const Model<D>& model, int body, const AddedMassSpec& spec) {
  const std::string owner =
      fmt::format("added mass '{}' on '{}'", spec.name, model.bodies[static_cast<std::size_t>(body)].name);
  require_positive(spec.density, owner + ": density", "kg/m3");
  const double depth = spec.level - spec.bed;
  if (!(depth > 0 && std::isfinite(depth)))
    throw InputError(fmt::format("{}: the level is {:g} m and the bed {:g} m; the level must be above the bed", owner,
                                 spec.level, spec.bed));
  const Wetted part(spec);
  if (!(part.low >= 0 && part.height > 0 && part.low + strips * part.height <= depth * (1 + 1e-9)))
    throw InputError(
        fmt::format("{}: the part from {:g} m to {:g} m must be within the bed and the level, from bottom to "
                    "top",
                    owner, spec.from.value_or(spec.bed), spec.to.value_or(spec.level)));
  AddedMass<D> out;
  out.name = spec.name, out.body = body;
  if (spec.form == AddedMassForm::cylinder) {
    add_cylinder(model, spec, owner, out);
    return out;
  }
  const double width = width_of(model, body, spec);
  require_positive(width, owner + ": width", "m");
  for (int i = 0; i < strips; ++i) {
    const StripMass strip = strip_mass(spec.form, depth, part.low + i * part.height, part.low + (i + 1) * part.height);
    const auto at = point_of_face(model, body, spec.side, spec.bed + strip.moment / strip.mass, owner);
    add_point(model, at, spec.side, spec.density * width * strip.mass, owner, out);
  }
  return out;
}

template AddedMass<2> make_added_mass(const Model<2>&, int, const AddedMassSpec&);
template AddedMass<3> make_added_mass(const Model<3>&, int, const AddedMassSpec&);

}  // namespace trilith
