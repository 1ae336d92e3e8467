// A force and a moment at a point of a body.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "base/rotation_3d.hpp"
#include "load/load_kind.hpp"

namespace trilith {

/// Area and centroid of a plane convex polygon in space.
struct PolygonMiddle {
  double area = 0;             ///< [m2]
  Vec3 middle = Vec3::Zero();  ///< [m]

  explicit PolygonMiddle(std::span<const Vec3> corners) {
    for (std::size_t i = 2; i < corners.size(); ++i) {
      const Vec3 &x = corners[0], &y = corners[i - 1], &z = corners[i];
      const double part = 0.5 * cross(Vec3(y - x), Vec3(z - x)).norm();
      area += part, middle += part / 3 * (x + y + z);
    }
    if (area > 0) middle /= area;
  }
};

/// A force and a moment at a point of a body, times their load curve.
template <int D>
struct PointLoad {
  std::string name;
  int body = -1;
  Attachment<D> at;                         ///< point of action
  Vec<D> force = Vec<D>::Zero();            ///< [N]
  Moment<D> moment = nothing<Moment<D>>();  ///< [N m]
  bool follows = false;                     ///< rotates with the point; given for its initial orientation
  int face = -1;  ///< in space, of a pressure on a face of a rigid body of one piece: this face, over which the force
                  ///< is uniform. Only sections of the body, and its parts, read it. -1: a force at a point
  LoadCurve curve;

  static constexpr std::string_view kind = "load";
  static constexpr std::string_view sentence = "a force and a moment at a point of a body";
  static constexpr bool in_space = true;
  static constexpr auto members() {
    using L = PointLoad;
    return std::tuple(&L::name, &L::body, &L::at, &L::force, &L::moment, &L::follows, &L::curve);
  }
  void scale(double factor) { force *= factor, moment *= factor; }
  [[nodiscard]] static constexpr int parts() { return 1; }
  [[nodiscard]] int body_of(int /*part*/) const { return body; }
  template <class See>
  void visit(int /*part*/, See&& see) const {
    see(at);
  }
  /// A following load rotates with its attachment, in space its moment too.
  template <class Target>
  void apply(Target& on, int /*part*/) const {
    const double share = curve.at(on.time());
    if (share == 0) return;
    if constexpr (D == 3 && keeps_parts<Target>)
      if (face >= 0) return apply_kept(on, share);
    if (!follows) {
      on.push(at, share * force, share * moment);
      return;
    }
    const auto turn = on.turn_of(at);
    if constexpr (D == 2)
      on.push(at, share * turn.apply(force), share * moment);
    else
      on.push(at, share * turn.apply(force), share * turn.apply(moment));
  }
  /// A load that follows is given in the axes of its body, and a plate is divided.
  template <class Parts>
  void split(const Parts& parts, std::vector<PointLoad>& out) const {
    if (!parts.is_on(body)) {
      out.push_back(*this);
      return;
    }
    if constexpr (D == 3)
      if (face >= 0) return split_face(parts, out);
    PointLoad given = *this;
    parts.give(given.at, given.body);
    if constexpr (D == 3) turn_into(parts, given);
    out.push_back(std::move(given));
  }

 private:
  template <class Target>
  void apply_kept(Target& on, double share) const {
    const auto turn = on.turn_of(at);
    const std::vector<Vec3> corners = on.corners_of(body, face);
    const PolygonMiddle whole(corners), kept(on.keep(corners));
    if (!(kept.area > 0)) return;
    const Vec3 acting = share * (kept.area / whole.area) * (follows ? Vec3(turn.apply(force)) : force);
    on.push_part(at, acting, cross(Vec3(kept.middle - on.place_of(at)), acting));
  }
  template <class Parts>
  void split_face(const Parts& parts, std::vector<PointLoad>& out) const {
    const double area = PolygonMiddle(parts.corners_of(face)).area;
    parts.for_polygon(parts.corners_of(face), [&](int part, int node, const std::vector<Vec3>& corners) {
      const PolygonMiddle own(corners);
      if (!(own.area > 0)) return;
      PointLoad given = *this;
      given.body = part, given.at = Attachment<D>::to_node(node, own.middle);
      given.face = parts.face_with(part, face, corners);
      turn_into(parts, given);
      given.force *= own.area / area, given.moment *= own.area / area;
      out.push_back(std::move(given));
    });
  }
  template <class Parts>
  static void turn_into(const Parts& parts, PointLoad& given) {
    if (!given.follows) return;
    const auto turn = parts.axes_of(given.body);
    given.force = turn.apply(given.force), given.moment = turn.apply(given.moment);
  }
};

}  // namespace trilith
