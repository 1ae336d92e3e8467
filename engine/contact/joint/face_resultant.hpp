// The resultant of a face contact, reconstructed from the faces' positions and the contact's memory.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "base/space.hpp"
#include "law/contact/list.hpp"

namespace trilith {

/// Force of a contact as one vector at one point.
struct ContactResultant {
  Vec2 point = Vec2::Zero();  ///< centre of pressure, at mid-gap [m]
  Vec2 force = Vec2::Zero();  ///< on the second body [N]
  double normal = 0;          ///< normal component, negative in tension [N]
  double shear = 0;           ///< component along the faces, signed [N]
};

/// Elastic energy of the normal stresses of two faces [J].
template <class K>
double pressing_energy(const FaceOverlap<double>& o, const ContactMemory& memory, const LawMemory<K>& own,
                       const K& law) {
  if (!o.sane) return 0;
  const std::array<HalfGaps, 2> gaps = stressed_gaps(law, o, memory, own);
  return stored_in_half(law, gaps[0], 0.5 * o.shared, memory, own, 0) +
         stored_in_half(law, gaps[1], 0.5 * o.shared, memory, own, 1);
}

/// `memory`: as respond_face_pair left it for these ends. The force equals the sum of the forces spread to the ends.
/// The moment differs by the shear times the change in height of the mid-gap line along the contact, which is of the
/// order of the gaps. If a bond in tension would put the point beyond the shared length, it is placed at its end.
template <class K>
ContactResultant face_resultant(const FaceEnds<double>& a, const FaceEnds<double>& b, const ContactMemory& memory,
                                const LawMemory<K>& own, const K& law) {
  const FaceOverlap<double> o(a, b);
  const double half = 0.5 * o.shared, gap_mid = 0.5 * (o.gap_lo + o.gap_hi), middle = o.lo + half;
  const std::array<HalfGaps, 2> gaps = stressed_gaps(law, o, memory, own);
  const HalfPressure first = pressure_of_half(law, gaps[0], half, memory, own, 0);
  const HalfPressure second = pressure_of_half(law, gaps[1], half, memory, own, 1);
  ContactResultant out;
  out.normal = first.force + second.force + memory.damping_force[0];
  out.shear = memory.shear_total[0] + memory.shear_total[1];
  // About the middle of the shared length, to which the damping part in the memory refers.
  const double moment = first.moment - half * first.force + second.moment + memory.damping_force[1];
  const double offset = out.normal != 0 ? std::clamp(moment / out.normal, -half, half) : 0.0;
  const Vec2 d(o.dx, o.dy), n(o.dy, -o.dx), origin(a.x0, a.y0);
  const double s = middle + offset;
  const double height_a = (n.x() * (a.x1 - a.x0) + n.y() * (a.y1 - a.y0)) * o.inv_a * s;
  const double gap = gap_mid + (o.gap_hi - o.gap_lo) * (o.shared > 0 ? offset / o.shared : 0);
  out.point = origin + s * d + (height_a + 0.5 * gap) * n;
  out.force = out.normal * n - out.shear * d;
  return out;
}

/// Friction that two faces hold at most under a law without bonds or mortar, each half by its own pressure and slip
/// rate [N]. `normal`: pressing force of both [N].
template <class K>
double face_friction(const FaceEnds<double>& a, const FaceEnds<double>& b, double normal, const K& law) {
  if constexpr (!has_own_friction<K>) {
    return law.mu * normal;
  } else {
    const FaceOverlap<double> o(a, b);
    const FaceRates<double> rates(o, a, b);
    const FaceHalves<double> halves(o, rates, rates, {});
    std::array<HalfResponse<double>, 2> pressed{};
    std::array<double, 2> active{};
    law.press(halves.half, active.data(), pressed.data());
    double sum = 0;
    for (const std::size_t h : {0, 1})
      sum += friction_limit_of(law, pressed[h].normal, active[h] * halves.half[h].length * law.thickness,
                               [&] { return std::abs(halves.half[h].slip_rate); });
    return sum;
  }
}

/// For a general contact: `normal` is its normal resultant on the second body at `centre`.
inline ContactResultant general_resultant(const Vec2& centre, const Vec2& normal, const ContactMemory& memory) {
  const double size = normal.norm(), shear = memory.shear_total[0] + memory.shear_total[1];
  const Vec2 t = size > 0 ? left_of(Vec2(normal / size)) : Vec2::Zero();
  return {centre, normal - shear * t, size, size > 0 ? shear : 0};
}

}  // namespace trilith
