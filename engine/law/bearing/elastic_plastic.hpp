// Bilinear spring: elastic to `yield`, then kinematic hardening with `hardening` times the stiffness, and a dashpot.
//
// f = k (d - p), |f - h p| <= f_y, with h = k r/(1 - r) for r = hardening. Return mapping: Simo and Hughes,
// "Computational Inelasticity", 1998, box 1.5. For both horizontal directions f, d and p are vectors. The yield surface
// is a moving circle, and p flows along its normal (box 3.1, radial return).
#pragma once

#include <array>
#include <cmath>

#include "base/portable.hpp"
#include "base/schema.hpp"
#include "law/bearing/direction.hpp"
#include "law/bearing/horizontal.hpp"

namespace trilith {

struct ElasticPlastic {
  double stiffness = 0;  ///< [N/m]
  double yield = 0;      ///< [N]
  double hardening = 0;  ///< [1]
  double damping = 0;    ///< [N s/m]

  static constexpr std::string_view name = "elastic_plastic";
  static constexpr std::string_view sentence = "bilinear spring with kinematic hardening and a dashpot";
  static constexpr auto parameters() {
    using P = Parameter<ElasticPlastic>;
    return std::array{P{&ElasticPlastic::stiffness, "stiffness", "N/m", no_default, 0, unbounded, false,
                        "elastic force per displacement"},
                      P{&ElasticPlastic::yield, "yield", "N", no_default, 0, unbounded, false, "force at first yield"},
                      P{&ElasticPlastic::hardening, "hardening", "1", 0, 0, 0.99, true,
                        "stiffness after yield over elastic stiffness"},
                      P{&ElasticPlastic::damping, "damping", "N s/m", 0, 0, unbounded, true, "force per velocity"}};
  }
  [[nodiscard]] double tangent() const { return stiffness; }
  [[nodiscard]] double dashpot() const { return damping; }

  [[nodiscard]] DirectionResponse respond(const DirectionMotion& m, const DirectionMemory& before) const {
    DirectionResponse out;
    out.memory = before;
    const double h = stiffness * hardening / (1 - hardening);
    const double trial = stiffness * (m.displacement - before.inner);
    const double beyond = std::abs(trial - h * before.inner) - yield;
    if (beyond > 0) {
      const double flow = std::copysign(beyond / (stiffness + h), trial - h * before.inner);
      out.memory.inner += flow;
      out.memory.travelled += std::abs(flow);
      out.yielding = true;
    }
    out.memory.force = stiffness * (m.displacement - out.memory.inner);
    const double moved = out.memory.inner - before.inner, middle = 0.5 * (out.memory.inner + before.inner);
    out.lost_inner = (0.5 * (out.memory.force + before.force) - h * middle) * moved;
    const double bent = m.displacement - out.memory.inner;
    out.stored = 0.5 * stiffness * (bent * bent) + 0.5 * h * out.memory.inner * out.memory.inner;
    add_dashpot(damping, m, before, out);
    return out;
  }

  struct Horizontal {
    AlongAcross inner{}, force{};  ///< plastic displacement [m], force [N]
    double travelled = 0;          ///< path length of the plastic displacement [m]
  };
  [[nodiscard]] HorizontalResponse<Horizontal> respond_horizontal(const HorizontalMotion& m,
                                                                  const Horizontal& before) const {
    const double h = stiffness * hardening / (1 - hardening);
    const Vec2 was = vector_of(before.inner), trial = stiffness * (m.displacement - was), over = trial - h * was;
    const double size = portable::hypot(over.x(), over.y()), beyond = size - yield;
    HorizontalResponse<Horizontal> out{before};
    Vec2 inner = was;
    if (beyond > 0) {
      inner += beyond / (stiffness + h) * (over / size);
      out.memory.travelled += beyond / (stiffness + h);
      out.yielding = true;
    }
    out.force = stiffness * (m.displacement - inner);
    const Vec2 moved = inner - was, middle = 0.5 * (inner + was), mean = 0.5 * (out.force + vector_of(before.force));
    out.lost_inner = (mean - h * middle).dot(moved);
    out.stored = 0.5 * stiffness * (m.displacement - inner).squaredNorm() + 0.5 * h * inner.squaredNorm();
    out.memory.inner = along_across(inner), out.memory.force = along_across(out.force);
    return out;
  }
};

}  // namespace trilith
