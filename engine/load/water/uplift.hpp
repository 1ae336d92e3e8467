// Water in a joint between two bodies: uplift.
//
// A coordinate s runs from the heel (s = 0), where the water enters, to the toe. The joint is open from the heel to the
// tip, where the first part in contact begins. The head is
//
//     h(s) = h_up                     in the open part, s <= tip
//     linear                          from the tip over the drain to the end of the closed part
//     h(s) = h_down                   from there to the toe
//
// and the pressure w (h(s) - z) acts on both faces. The contact stress is the remaining, effective one, so the tip is
// where it becomes 0. A drain at s_d leaves the share 1 - efficiency of the difference between the straight line and
// h_down; a crack that reaches it makes it ineffective. See U.S. Army Corps of Engineers, "Gravity dam design", EM
// 1110-2-2200, 1995, ch. 3. Without tail water h_down is the elevation of the toe. If nothing is closed, h_up acts
// everywhere.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "law/contact/face_overlap.hpp"
#include "load/water/water.hpp"

namespace trilith {

/// A stretch of the joint with a linear head [m].
struct HeadPart {
  double from, to;  ///< s [m]
  double h0, h1;    ///< heads at both ends [m]
  [[nodiscard]] double at(double s) const { return h0 == h1 ? h0 : h0 + (s - from) / (to - from) * (h1 - h0); }
};

/// The head along the joint.
struct HeadLine {
  static constexpr double far = 1e9;  ///< [m]
  int count = 0;
  std::array<HeadPart, 4> part{};

  void add(double from, double to, double h0, double h1) {
    if (to > from) part[static_cast<std::size_t>(count++)] = {from, to, h0, h1};
  }
};

/// The state of a joint at an instant.
template <int D>
struct UpliftNow {
  double length = 0;        ///< from heel to toe [m]
  double tip = 0, end = 0;  ///< s of the first and the last closed point [m]
  bool closed = false;      ///< some part is closed
  Vec<D> heel = Vec<D>::Zero(), along = Vec<D>::UnitX();
  HeadLine head;

  [[nodiscard]] double s_of(const Vec<D>& x) const { return along.dot(x - heel); }
  void close(double s) {
    tip = closed ? std::min(tip, s) : s, end = closed ? std::max(end, s) : s;
    closed = true;
  }
};

/// Two opposed faces in the plane over their shared length.
struct JointStretch {
  Vec2 a0, a1, b0, b1;
  FaceOverlap<double> overlap;

  template <class Target>
  JointStretch(const Target& on, const WetFace<2>& a, const WetFace<2>& b)
      : a0(on.skin(a.skin_a)),
        a1(on.skin(a.skin_b)),
        b0(on.skin(b.skin_a)),
        b1(on.skin(b.skin_b)),
        overlap(FaceEnds<double>{a0.x(), a0.y(), a1.x(), a1.y(), 0, 0, 0, 0},
                FaceEnds<double>{b0.x(), b0.y(), b1.x(), b1.y(), 0, 0, 0, 0}) {}
  /// Relative position on either face of the point at `t` along the common direction [1].
  [[nodiscard]] double on_a(double t) const { return t * overlap.inv_a; }
  [[nodiscard]] double on_b(double t) const { return 1 - (t - overlap.sb1) * overlap.inv_b; }
  [[nodiscard]] Vec2 point(double t) const { return a0 + on_a(t) * (a1 - a0); }
  [[nodiscard]] Vec2 opposite(double t) const { return b0 + on_b(t) * (b1 - b0); }
  [[nodiscard]] double gap(double t) const {
    return overlap.gap_lo + (t - overlap.lo) / overlap.shared * (overlap.gap_hi - overlap.gap_lo);
  }
  /// Calls f(from, to) for the closed parts, where the gap is not positive or the mortar of a half is intact.
  template <class F>
  void for_closed(unsigned bonds, F&& f) const {
    const double lo = overlap.lo, hi = overlap.hi, middle = 0.5 * (lo + hi);
    if ((bonds & 1U) != 0) f(lo, middle);
    if ((bonds & 2U) != 0) f(middle, hi);
    const double g0 = overlap.gap_lo - closed_gap, g1 = overlap.gap_hi - closed_gap;
    if (g0 > 0 && g1 > 0) return;
    const double zero = g0 > 0 || g1 > 0 ? lo + g0 / (g0 - g1) * (hi - lo) : lo;
    f(g0 > 0 ? zero : lo, g1 > 0 ? zero : hi);
  }
};

/// The shared polygon of two faces in the world.
inline WetPolygon polygon_of(const FaceOverlap3& faces) {
  WetPolygon out;
  for (int i = 0; i < faces.shared.count; ++i)
    out.add(faces.plane.at(faces.shared.corner[static_cast<std::size_t>(i)]));
  return out;
}
/// The overlap of two faces, raised so that it is not negative where they are closed [m].
inline LinearField closed_field(const FaceOverlap3& faces) {
  const MeanPlane& plane = faces.plane;
  const Vec3 slope = plane.slope.x() * plane.x + plane.slope.y() * plane.y;
  return {plane.overlap + closed_gap - slope.dot(plane.origin), slope};
}

template <int D>
struct Uplift {
  std::string name;
  std::string upstream, downstream;      ///< names of the waters whose levels it follows
  LoadCurve curve;                       ///< level upstream over time [m]
  LoadCurve tail;                        ///< level downstream over time [m]; without points: none
  double density = 1000;                 ///< [kg/m3]
  bool full = false;                     ///< the head upstream acts everywhere
  double drain_at = 0;                   ///< distance of the drain from the heel [m]; 0: none
  double drain_efficiency = 0;           ///< [1]
  Attachment<D> heel, toe;               ///< on the lower body
  std::vector<WetFace<D>> upper, lower;  ///< faces of both bodies at the joint, and of their parts if they have split

  static constexpr std::string_view kind = "uplift", sentence = "water in a joint between two bodies";
  static constexpr bool in_space = true, is_water = true;
  static constexpr auto members() {
    using U = Uplift;
    return std::tuple(&U::name, &U::upstream, &U::downstream, &U::curve, &U::tail, &U::density, &U::full, &U::drain_at,
                      &U::drain_efficiency, &U::heel, &U::toe, &U::upper, &U::lower);
  }
  void scale(double factor) { density *= factor; }
  /// One part for each body: the upper one or its parts, then the lower one.
  [[nodiscard]] int parts() const { return bodies_of(upper) + bodies_of(lower); }
  [[nodiscard]] int body_of(int part) const {
    const int above = bodies_of(upper);
    return part < above ? nth_body(upper, part) : nth_body(lower, part - above);
  }
  template <class See>
  void visit(int /*part*/, See&& see) const {
    for (const auto* faces : {&upper, &lower})
      for (const WetFace<D>& face : *faces)
        if constexpr (D == 2)
          see(face.skin_a), see(face.skin_b);
        else
          see(face.at);
  }

  /// Geometry and head of the joint at the instant of a target.
  template <class Target>
  [[nodiscard]] UpliftNow<D> now(const Target& on) const {
    UpliftNow<D> out;
    out.heel = on.place_of(heel);
    const Vec<D> toe_now = on.place_of(toe), all = toe_now - out.heel;
    out.length = all.norm(), out.along = all / out.length;
    find_closed(on, out);
    if (!out.closed) out.tip = out.end = out.length;
    // A contact that begins within rounding of an end begins at the end.
    const double least = 1e-9 * out.length;
    if (out.tip < least) out.tip = 0;
    if (out.end > out.length - least) out.end = out.length;
    const double up = std::max(curve.at(on.time()), out.heel[D - 1]), dry = toe_now[D - 1];
    const double down = tail.time.empty() ? dry : std::max(tail.at(on.time()), dry);
    out.head = head_line(out, up, down);
    return out;
  }
  template <class Target>
  void apply(Target& on, int part) const {
    const UpliftNow<D> joint = now(on);
    const double weight = density * on.gravity();
    const bool onto_upper = part < bodies_of(upper);
    const int body = body_of(part);
    for (const WetFace<D>& a : upper)
      for (const WetFace<D>& b : lower)
        if ((onto_upper ? a : b).body == body) press(on, joint, weight, a, b, onto_upper);
  }
  template <class Parts>
  void split(const Parts& parts, std::vector<Uplift>& out) const {
    Uplift given = *this;
    split_faces(parts, upper, given.upper, false);
    split_faces(parts, lower, given.lower, false);
    int body = lower.front().body;
    if (parts.is_on(body)) parts.give(given.heel, body), parts.give(given.toe, body);
    out.push_back(std::move(given));
  }

 private:
  /// Number of bodies of some faces, which are in the order of their bodies.
  [[nodiscard]] static int bodies_of(const std::vector<WetFace<D>>& faces) {
    int count = 0;
    for (std::size_t i = 0; i < faces.size(); ++i)
      if (i == 0 || faces[i].body != faces[i - 1].body) ++count;
    return count;
  }
  [[nodiscard]] static int nth_body(const std::vector<WetFace<D>>& faces, int n) {
    std::size_t i = 0;
    for (; n > 0 && i + 1 < faces.size(); ++i)
      if (faces[i + 1].body != faces[i].body) --n;
    return faces[i].body;
  }

  [[nodiscard]] HeadLine head_line(const UpliftNow<D>& joint, double up, double down) const {
    HeadLine line;
    constexpr double far = HeadLine::far;
    if (full || !joint.closed) {
      line.add(-far, far, up, up);
      return line;
    }
    line.add(-far, joint.tip, up, up);
    if (drain_at > joint.tip && drain_at < joint.end) {
      const double straight = up + (drain_at - joint.tip) / (joint.end - joint.tip) * (down - up);
      const double drained = down + (1 - drain_efficiency) * (straight - down);
      line.add(joint.tip, drain_at, up, drained);
      line.add(drain_at, joint.end, drained, down);
    } else {
      line.add(joint.tip, joint.end, up, down);
    }
    line.add(joint.end, far, down, down);
    return line;
  }

  template <class Target>
  void find_closed(const Target& on, UpliftNow<D>& out) const {
    for (const WetFace<D>& a : upper)
      for (const WetFace<D>& b : lower) {
        const unsigned bonds = on.closed().bonds(a.key(), b.key());
        if constexpr (D == 2) {
          const JointStretch stretch(on, a, b);
          if (!stretch.overlap.sane) continue;
          stretch.for_closed(bonds, [&](double from, double to) {
            out.close(out.s_of(stretch.point(from))), out.close(out.s_of(stretch.point(to)));
          });
        } else {
          FaceOverlap3 shared;
          if (!overlap_of(on, a, b, shared)) continue;
          const WetPolygon polygon = polygon_of(shared);
          const WetPolygon touching = bonds != 0 ? polygon : cut(polygon.corners(), closed_field(shared));
          for (const Vec3& x : touching.corners()) out.close(out.s_of(x));
        }
      }
  }

  /// The part of two faces in the plane that the target keeps, in s.
  template <class Target>
  static std::array<double, 2> kept_span(const Target& on, const UpliftNow<2>& joint, const JointStretch& stretch,
                                         const WetFace<2>& face, bool is_upper) {
    const FaceOverlap<double>& o = stretch.overlap;
    double lo = o.lo, hi = o.hi;
    if constexpr (keeps_parts<Target>) {
      const KeptPart kept = on.kept(face.skin_a, face.skin_b);
      const auto along = [&](double at) { return is_upper ? at / o.inv_a : o.sb1 + (1 - at) / o.inv_b; };
      const double p = along(kept.from), q = along(kept.to);
      lo = std::clamp(std::min(p, q), o.lo, o.hi), hi = std::clamp(std::max(p, q), o.lo, o.hi);
    }
    const double p = joint.s_of(stretch.point(lo)), q = joint.s_of(stretch.point(hi));
    return {std::min(p, q), std::max(p, q)};
  }

  // Pressure of the joint on two faces, part by part of the head line.

  template <class Target>
  static void press(Target& on, const UpliftNow<2>& joint, double weight, const WetFace<2>& a, const WetFace<2>& b,
                    bool onto_upper) {
    const JointStretch stretch(on, a, b);
    const FaceOverlap<double>& o = stretch.overlap;
    if (!o.sane) return;
    const double s_lo = joint.s_of(stretch.point(o.lo)), s_hi = joint.s_of(stretch.point(o.hi));
    if (s_lo == s_hi) return;
    EndShares on_a, on_b;
    const auto [low, high] = kept_span(on, joint, stretch, onto_upper ? a : b, onto_upper);
    for (int i = 0; i < joint.head.count; ++i) {
      const HeadPart& part = joint.head.part[static_cast<std::size_t>(i)];
      const double from = std::max(part.from, low), to = std::min(part.to, high);
      if (!(to > from)) continue;
      const auto along = [&](double s) { return o.lo + (s - s_lo) / (s_hi - s_lo) * o.shared; };
      double t0 = along(from), t1 = along(to), h0 = part.at(from), h1 = part.at(to);
      if (t1 < t0) std::swap(t0, t1), std::swap(h0, h1);
      on_a += pressed_ends(stretch.on_a(t0), weight * (h0 - stretch.point(t0).y()), stretch.on_a(t1),
                           weight * (h1 - stretch.point(t1).y()));
      on_b += pressed_ends(stretch.on_b(t1), weight * (h1 - stretch.opposite(t1).y()), stretch.on_b(t0),
                           weight * (h0 - stretch.opposite(t0).y()));
    }
    const Vec2 onto_a = a.depth * left_of(Vec2(stretch.a1 - stretch.a0)),
               onto_b = b.depth * left_of(Vec2(stretch.b1 - stretch.b0));
    if (onto_upper)
      on.push_skin(a.skin_a, on_a.a * onto_a), on.push_skin(a.skin_b, on_a.b * onto_a);
    else
      on.push_skin(b.skin_a, on_b.a * onto_b), on.push_skin(b.skin_b, on_b.b * onto_b);
  }

  /// A placed face as input of face_overlap.
  template <class Target>
  static bool overlap_of(const Target& on, const WetFace<3>& a, const WetFace<3>& b, FaceOverlap3& out) {
    const PlacedWetFace one(on, a), other(on, b);
    return face_overlap({one.polygon.corners(), one.normal}, {other.polygon.corners(), other.normal}, out);
  }
  template <class Target>
  static void press(Target& on, const UpliftNow<3>& joint, double weight, const WetFace<3>& a, const WetFace<3>& b,
                    bool onto_upper) {
    FaceOverlap3 shared;
    if (!overlap_of(on, a, b, shared)) return;
    WetPolygon polygon = polygon_of(shared);
    if constexpr (keeps_parts<Target>) {
      const std::vector<Vec3> kept = on.keep(polygon.corners());
      polygon.count = 0;
      for (const Vec3& x : kept) polygon.add(x);
    }
    PressureSum sum;
    const double heel = joint.along.dot(joint.heel);
    for (int i = 0; i < joint.head.count; ++i) {
      const HeadPart& part = joint.head.part[static_cast<std::size_t>(i)];
      const WetPolygon from = cut(polygon.corners(), {-heel - part.from, joint.along});
      const WetPolygon slab = cut(from.corners(), {heel + part.to, Vec3(-joint.along)});
      const double rise = part.h0 == part.h1 ? 0 : (part.h1 - part.h0) / (part.to - part.from);
      const LinearField pressure{weight * (part.h0 - rise * (heel + (rise == 0 ? 0 : part.from))),
                                 Vec3(weight * (rise * joint.along - Vec3::UnitZ()))};
      sum.add(slab.corners(), shared.plane.normal, pressure, 1);
    }
    const WetFace<3>& face = onto_upper ? a : b;
    push_pressure(on, face, PlacedWetFace(on, face), sum);
  }
};

}  // namespace trilith
