// Water at rest against faces of bodies.
//
//     p = w max(0, level - z),   w = density times the present vertical gravity.
//
// The pressure acts on the faces as they lie at the instant, normal to them, so buoyancy needs no term of its own. In a
// sealed joint the closed parts of a face are dry, and water reaches every part that opens. In a wet joint water
// reaches the whole face.
#pragma once

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "load/load_kind.hpp"
#include "load/water/closed_joints.hpp"
#include "load/water/pressure.hpp"

namespace trilith {

/// A face that water may reach.
template <int D>
struct WetFace;
template <>
struct WetFace<2> {
  int body = -1;
  int skin_a = -1, skin_b = -1;  ///< counter-clockwise
  double from = 0, to = 1;       ///< the part of the face [1]
  double depth = 1;              ///< out-of-plane width [m]

  static constexpr auto members() {
    using W = WetFace;
    return std::tuple(&W::body, &W::skin_a, &W::skin_b, &W::from, &W::to, &W::depth);
  }
  [[nodiscard]] FaceKey key() const { return skin_a; }
};
/// In space a face is a rigid plate that moves with its contact frame (model/contact/contact_frame.hpp).
template <>
struct WetFace<3> {
  int body = -1;
  int piece = -1, face = -1;
  Attachment<3> at;                      ///< the contact frame, without an arm
  std::vector<Vec3> corners;             ///< in its axes [m]
  Vec3 normal = Vec3::UnitZ();           ///< in its axes, outward
  std::vector<std::vector<Vec3>> inner;  ///< polygons that other pieces of the same body cover, in its axes [m]

  static constexpr auto members() {
    using W = WetFace;
    return std::tuple(&W::body, &W::piece, &W::face, &W::at, &W::corners, &W::normal, &W::inner);
  }
  [[nodiscard]] FaceKey key() const { return face_key(piece, face); }
};

/// A face in space in its present position.
struct PlacedWetFace {
  Vec3 place, normal;
  WetPolygon polygon;

  template <class Target>
  PlacedWetFace(const Target& on, const WetFace<3>& face) : place(on.place_of(face.at)) {
    const auto turn = on.turn_of(face.at);
    normal = turn.apply(face.normal);
    for (const Vec3& x : face.corners) polygon.add(place + turn.apply(x));
  }
};

/// Adds the force of a pressure on a face in space, and its moment about the face's frame.
template <class Target>
void push_pressure(Target& on, const WetFace<3>& face, const PlacedWetFace& now, const PressureSum& sum) {
  const Vec3 force = -sum.force * now.normal;
  const Vec3 moment = cross(Vec3(sum.first - sum.force * now.place), Vec3(-now.normal));
  if constexpr (keeps_parts<Target>)
    on.push_part(face.at, force, moment);
  else
    on.push(face.at, force, moment);
}

/// Adds a pressure over the part of a polygon that the target keeps, see PressureSum::add.
template <class Target>
void add_kept(const Target& on, PressureSum& sum, std::span<const Vec3> polygon, const Vec3& normal,
              const LinearField& pressure, double sign) {
  if constexpr (keeps_parts<Target>)
    sum.add(on.keep(polygon), normal, pressure, sign);
  else
    sum.add(polygon, normal, pressure, sign);
}

/// Adds the pressure of water on a face.
template <class Target>
void press_face(Target& on, const WetFace<2>& face, double level, double weight, bool sealed) {
  const Vec2 a = on.skin(face.skin_a), b = on.skin(face.skin_b);
  if (std::min(a.y(), b.y()) >= level) return;
  const auto pressure = [&](double s) { return weight * (level - (a.y() + s * (b.y() - a.y()))); };
  EndShares ends;
  const KeptPart kept = kept_part(on, face.skin_a, face.skin_b);
  const auto add = [&](double from, double to) {
    if constexpr (keeps_parts<Target>) from = std::max(from, kept.from), to = std::min(to, kept.to);
    if (to > from) ends += pressed_ends(from, pressure(from), to, pressure(to));
  };
  double done = face.from;
  if (sealed)
    for (const ClosedPart<2>& part : on.closed().of(face.key())) {
      if (part.from > done) add(done, std::min(part.from, face.to));
      done = std::max(done, part.to);
    }
  if (done < face.to) add(done, face.to);
  if (ends.a == 0 && ends.b == 0) return;
  const Vec2 inward = face.depth * left_of(Vec2(b - a));
  on.push_skin(face.skin_a, ends.a * inward);
  on.push_skin(face.skin_b, ends.b * inward);
}
template <class Target>
void press_face(Target& on, const WetFace<3>& face, double level, double weight, bool sealed) {
  const LinearField pressure{weight * level, Vec3(0, 0, -weight)};
  const PlacedWetFace now(on, face);
  PressureSum sum;
  add_kept(on, sum, now.polygon.corners(), now.normal, pressure, 1);
  if (sum.force == 0) return;
  const auto turn = on.turn_of(face.at);
  for (const std::vector<Vec3>& inner : face.inner) {
    WetPolygon covered;
    for (const Vec3& x : inner) covered.add(now.place + turn.apply(x));
    add_kept(on, sum, covered.corners(), now.normal, pressure, -1);
  }
  if (sealed)
    for (const ClosedPart<3>& part : on.closed().of(face.key()))
      add_kept(on, sum, {on.closed().corner.data() + part.first, static_cast<std::size_t>(part.count)}, now.normal,
               pressure, -1);
  push_pressure(on, face, now, sum);
}

/// The part of a wet face on a part of a body that has split; a pair of positions or a polygon remains of the face.
inline WetFace<2> wet_part(const WetFace<2>& whole, const SplitFace& part) {
  const double width = part.to - part.from;
  const auto on_part = [&](double at) { return std::clamp((at - part.from) / width, 0.0, 1.0); };
  return {part.body, part.skin_a, part.skin_b, on_part(whole.from), on_part(whole.to), whole.depth};
}
inline const WetFace<3>& wet_part(const WetFace<3>& /*whole*/, const WetFace<3>& part) {
  return part;
}
inline SplitFace split_face(const WetFace<2>& face) {
  return {face.body, face.skin_a, face.skin_b};
}
inline const WetFace<3>& split_face(const WetFace<3>& face) {
  return face;
}
inline bool has_extent(const WetFace<2>& face) {
  return face.to > face.from;
}
inline bool has_extent(const WetFace<3>& face) {
  return face.corners.size() > 2;
}

/// Replaces the faces of a body that has split by the faces of its parts. `enters`: the faces of the crack are added
/// where it meets one of the faces. Bodies remain in the order of the faces.
template <int D, class Parts>
void split_faces(const Parts& parts, const std::vector<WetFace<D>>& faces, std::vector<WetFace<D>>& out, bool enters) {
  out.clear();
  std::vector<WetFace<D>> ahead;
  const WetFace<D>* reached = nullptr;
  for (const WetFace<D>& face : faces) {
    if (!parts.is_on(face.body)) {
      out.push_back(face);
      continue;
    }
    int count = 0;
    parts.for_face(split_face(face), [&](const auto& part) {
      WetFace<D> given = wet_part(face, part);
      if (!has_extent(given)) return;
      ++count;
      (parts.is_behind(given.body) ? out : ahead).push_back(std::move(given));
    });
    if (reached == nullptr && (count > 1 || parts.is_at_crack(face))) reached = &face;
  }
  out.insert(out.end(), std::make_move_iterator(ahead.begin()), std::make_move_iterator(ahead.end()));
  if (!enters || reached == nullptr) return;
  parts.for_new_faces([&](const auto& face) {
    if constexpr (D == 2)
      out.push_back({face.body, face.skin_a, face.skin_b, 0, 1, reached->depth});
    else
      out.push_back(face);
  });
}

/// Water with a level [m], which is its load curve.
template <int D>
struct Water {
  std::string name;
  LoadCurve curve;        ///< level over time [m]
  double density = 1000;  ///< [kg/m3]
  bool sealed = true;     ///< closed joints are dry
  std::vector<WetFace<D>> faces;

  static constexpr std::string_view kind = "water", sentence = "water at rest against faces of bodies";
  static constexpr bool in_space = true, is_water = true;
  static constexpr auto members() {
    using W = Water;
    return std::tuple(&W::name, &W::curve, &W::density, &W::sealed, &W::faces);
  }
  void scale(double factor) { density *= factor; }
  [[nodiscard]] int parts() const { return static_cast<int>(faces.size()); }
  [[nodiscard]] const WetFace<D>& face(int part) const { return faces[static_cast<std::size_t>(part)]; }
  [[nodiscard]] int body_of(int part) const { return face(part).body; }
  template <class See>
  void visit(int part, See&& see) const {
    if constexpr (D == 2)
      see(face(part).skin_a), see(face(part).skin_b);
    else
      see(face(part).at);
  }
  template <class Target>
  void apply(Target& on, int part) const {
    press_face(on, face(part), curve.at(on.time()), density * on.gravity(), sealed);
  }
  /// Water that reaches the edge of a crack reaches its two faces as well.
  template <class Parts>
  void split(const Parts& parts, std::vector<Water>& out) const {
    Water given = *this;
    split_faces(parts, faces, given.faces, true);
    out.push_back(std::move(given));
  }
};

}  // namespace trilith
