// Four pairs of faces and their memories as columns of lanes.
#pragma once

#include <array>
#include <vector>

#include "contact/face_scene.hpp"

namespace trilith::testing {

inline Lanes pack(const double (&v)[lane_count]) {
  return Lanes{v[0], v[1], v[2], v[3]};
}

inline FaceEnds<Lanes> pack(const std::array<Faces, lane_count>& f, bool second) {
  const auto each = [&](double FaceEnds<double>::*member) {
    double v[lane_count];
    for (int i = 0; i < lane_count; ++i) v[i] = second ? f[i].b.*member : f[i].a.*member;
    return pack(v);
  };
  using E = FaceEnds<double>;
  return {each(&E::x0), each(&E::y0), each(&E::x1), each(&E::y1),
          each(&E::u0), each(&E::v0), each(&E::u1), each(&E::v1)};
}

inline FaceMemory<Lanes> pack(const std::array<FaceMemory<double>, lane_count>& m) {
  FaceMemory<Lanes> out{};
  for (int i = 0; i < lane_count; ++i) {
    for (const int h : {0, 1}) {
      out.shear_elastic[h][i] = m[i].shear_elastic[h];
      out.shear_total[h][i] = m[i].shear_total[h];
      out.damping_force[h][i] = m[i].damping_force[h];
      out.active[h][i] = m[i].active[h];
      out.bonds[h][i] = m[i].bonds[h] ? -1 : 0;
    }
    out.slip[i] = m[i].slip;
  }
  return out;
}

/// History of a law for four contacts, packed by lanes.
template <class K>
typename K::template Memory<Lanes> pack(const std::array<LawMemory<K>, lane_count>& m) {
  typename K::template Memory<Lanes> out;
  for (int i = 0; i < lane_count; ++i) {
    std::vector<double> numbers;
    LawMemory<K> one = m[i];
    one.fields([&](double first, double second) { numbers.push_back(first), numbers.push_back(second); });
    auto next = numbers.begin();
    out.fields([&](Lanes& first, Lanes& second) { first[i] = *next++, second[i] = *next++; });
  }
  return out;
}

}  // namespace trilith::testing
