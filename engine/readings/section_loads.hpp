// Loads on a body in a section: the targets that read them (load/load_kind.hpp), and the loads of each body.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "assembly/load_target.hpp"

namespace trilith {

/// Moment of a force at an arm.
inline double moment_at(const Vec2& arm, const Vec2& force) {
  return cross(arm, force);
}
inline Vec3 moment_at(const Vec3& arm, const Vec3& force) {
  return cross(arm, force);
}

/// A force and its moment about a point.
template <int D>
struct ForceSum {
  Vec<D> about = Vec<D>::Zero();            ///< this point [m]
  Vec<D> force = Vec<D>::Zero();            ///< [N]
  Moment<D> moment = nothing<Moment<D>>();  ///< [N m]

  void add(const Vec<D>& at, const Vec<D>& f, const Moment<D>& m) {
    force += f;
    moment += moment_at(Vec<D>(at - about), f) + m;
  }
};

/// Sum of whole loads.
template <int D>
struct WholeLoads : LoadPlaces<D> {
  ForceSum<D>& sum;

  void push(const Attachment<D>& at, const Vec<D>& f, const Moment<D>& m) { sum.add(this->place_of(at), f, m); }
  void push_skin(int i, const Vec2& f) requires(D == 2) { sum.add(this->skin(i), f, 0); }
};

/// Sizes of loads, without regard to directions [N].
template <int D>
struct LoadSizes : LoadPlaces<D> {
  double& sum;

  void push(const Attachment<D>& /*at*/, const Vec<D>& f, const Moment<D>& /*m*/) { sum += f.norm(); }
  void push_skin(int /*i*/, const Vec2& f) requires(D == 2) { sum += f.norm(); }
};

/// Sum of the loads behind a plane, with the parts of pressures behind it.
template <int D>
struct LoadsBehind : LoadPlaces<D> {
  static constexpr bool keeps_parts = true;
  Vec<D> on_plane, normal;  ///< a point of the plane [m]; unit vector from behind
  ForceSum<D>& sum;

  [[nodiscard]] double ahead(const Vec<D>& x) const { return normal.dot(x - on_plane); }
  void push(const Attachment<D>& at, const Vec<D>& f, const Moment<D>& m) {
    const Vec<D> place = this->place_of(at);
    if (ahead(place) <= 0) sum.add(place, f, m);
  }
  void push_skin(int i, const Vec2& f) requires(D == 2) { sum.add(this->skin(i), f, 0); }
  void push_part(const Attachment<D>& at, const Vec<D>& f, const Moment<D>& m) { sum.add(this->place_of(at), f, m); }
  [[nodiscard]] KeptPart kept(int skin_a, int skin_b) const requires(D == 2) {
    const double p = ahead(this->skin(skin_a)), q = ahead(this->skin(skin_b));
    if (p <= 0 && q <= 0) return {0, 1};
    if (p >= 0 && q >= 0) return {0, 0};
    const double cut = p / (p - q);
    return p < 0 ? KeptPart{0, cut} : KeptPart{cut, 1};
  }
  [[nodiscard]] std::vector<Vec3> corners_of(int body, int face) const requires(D == 3) {
    const Body& b = this->model.bodies[static_cast<std::size_t>(body)];
    const Polyhedron& shape = this->model.piece_solid[static_cast<std::size_t>(b.first_piece)].shape;
    const auto n = static_cast<std::size_t>(b.first_node);
    const Turn3 turn(this->state.rotation[n]);
    std::vector<Vec3> out;
    for (const int c : shape.faces[face])
      out.push_back(this->state.position[n] + turn.apply(shape.corners[static_cast<std::size_t>(c)]));
    return out;
  }
  [[nodiscard]] std::vector<Vec3> keep(std::span<const Vec3> corners) const requires(D == 3) {
    std::vector<Vec3> out;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec3 &x = corners[i], &y = corners[i + 1 < corners.size() ? i + 1 : 0];
      const double p = ahead(x), q = ahead(y);
      if (p <= 0) out.push_back(x);
      if ((p < 0 && q > 0) || (p > 0 && q < 0)) out.push_back(x + p / (p - q) * (y - x));
    }
    return out;
  }
};

/// A part of a load of a model: its kind by its place in LoadKinds, and its index among the loads of this kind.
struct LoadPart {
  int kind = 0;
  std::size_t load = 0;
  int part = 0;
};

/// Calls f(load, part, row) for the parts of all loads, with their row as LoadPart. `f` returns nothing.
template <int D, class F>
void for_load_parts(const Model<D>& model, F&& f) {
  int kind = 0;
  model.loads.for_each_kind([&]<class L>(const std::vector<L>& loads) {
    if constexpr (acts_in<L, D>)
      for (std::size_t i = 0; i < loads.size(); ++i)
        for (int part = 0; part < loads[i].parts(); ++part) f(loads[i], part, LoadPart{kind, i, part});
    ++kind;
  });
}

/// Adds some parts of loads to a target.
template <int D, class Target>
void apply_parts(const Model<D>& model, std::span<const LoadPart> parts, Target& on) {
  if (parts.empty()) return;
  int kind = 0;
  model.loads.for_each_kind([&]<class L>(const std::vector<L>& loads) {
    if constexpr (acts_in<L, D>)
      for (const LoadPart& p : parts)
        if (p.kind == kind) loads[p.load].apply(on, p.part);
    ++kind;
  });
}

}  // namespace trilith
