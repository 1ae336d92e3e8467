// Uniform pressure on faces of bodies in the plane. In space a face is a rigid plate, on which it is a point load.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "load/load_kind.hpp"

namespace trilith {

/// Uniform pressure on a part of the face between two skin points of a body, counter-clockwise, times its load curve.
/// The forces at the two ends do the work of the pressure on the straight face.
template <int D>
struct FaceLoad {
  std::string name;
  int body = -1;
  int skin_a = -1, skin_b = -1;
  std::array<double, 2> share{0.5, 0.5};  ///< of a full face's force at each end
  double pressure = 0;                    ///< positive towards the face [Pa]
  double depth = 1;                       ///< out-of-plane width of the face [m]
  bool follows = true;                    ///< acts along the present normal of the face and on its present length
  Vec<D> dead = Vec<D>::Zero();           ///< force on a full face if it does not follow [N]
  LoadCurve curve;

  static constexpr std::string_view kind = "pressure";
  static constexpr std::string_view sentence = "a uniform pressure on a part of a face";
  static constexpr bool in_space = false;
  static constexpr auto members() {
    using L = FaceLoad;
    return std::tuple(&L::name, &L::body, &L::skin_a, &L::skin_b, &L::share, &L::pressure, &L::depth, &L::follows,
                      &L::dead, &L::curve);
  }
  void scale(double factor) { pressure *= factor, dead *= factor; }
  [[nodiscard]] static constexpr int parts() { return 1; }
  [[nodiscard]] int body_of(int /*part*/) const { return body; }
  template <class See>
  void visit(int /*part*/, See&& see) const {
    see(skin_a), see(skin_b);
  }
  /// Force on the whole face between two points, at the full value of the load curve [N].
  [[nodiscard]] Vec2 whole_force(const Vec2& a, const Vec2& b) const {
    return follows ? Vec2(pressure * depth * left_of(Vec2(b.x() - a.x(), b.y() - a.y()))) : dead;
  }
  /// The force is distributed to both skin points by the shares of the face that the pressure covers.
  template <class Target>
  void apply(Target& on, int /*part*/) const {
    const double now = curve.at(on.time());
    if (now == 0) return;
    const Vec2 full = now * whole_force(on.skin(skin_a), on.skin(skin_b));
    std::array<double, 2> acting = share;
    if constexpr (keeps_parts<Target>) acting = shares_of(on.kept(skin_a, skin_b));
    on.push_skin(skin_a, acting[0] * full);
    on.push_skin(skin_b, acting[1] * full);
  }
  /// A pressure that spans the plane of a crack becomes two.
  template <class Parts>
  void split(const Parts& parts, std::vector<FaceLoad>& out) const {
    if (!parts.is_on(body)) {
      out.push_back(*this);
      return;
    }
    parts.for_face(SplitFace{body, skin_a, skin_b}, [&](const SplitFace& face) {
      FaceLoad given = *this;
      const double width = face.to - face.from;
      const auto [at_a, at_b] = shares_of({face.from, face.to});
      if (!(at_a + at_b > 0)) return;
      // The same force, in terms of the new face.
      const double sum = (at_a + at_b) / width, middle = (at_b / (at_a + at_b) - face.from) / width;
      given.body = face.body, given.skin_a = face.skin_a, given.skin_b = face.skin_b;
      given.share = {sum * (1 - middle), sum * middle};
      given.dead = width * dead;
      out.push_back(std::move(given));
    });
  }

 private:
  /// The shares of the force on the covered part of the face within `part`.
  [[nodiscard]] std::array<double, 2> shares_of(const KeptPart& part) const {
    const double covered = share[0] + share[1];
    if (!(covered > 0)) return {0, 0};
    const double centre = share[1] / covered;
    const double from = std::max(part.from, centre - 0.5 * covered), to = std::min(part.to, centre + 0.5 * covered);
    if (!(to > from)) return {0, 0};
    const double middle = 0.5 * (from + to);
    return {(to - from) * (1 - middle), (to - from) * middle};
  }
};

}  // namespace trilith
