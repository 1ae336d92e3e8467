// Bearings that slide on a dish: the axial direction follows the dish.
//
// The slider of a pendulum law is on a dish of radius R. A horizontal displacement u raises it by h(u) with the slope
// h'(u):
//
//     h(u) = R - sqrt(R^2 - u^2),      dh/du = u / sqrt(R^2 - u^2) = tan(angle of the dish)
//
// So the axial law uses z - h(u) instead of its displacement z. Its force F acts along the normal of the dish: F
// axially and -F dh/du horizontally, which is N tan(angle) under a compression N. Both derive from the one potential
// V(z - h(u)) of the axial law, so the axial law accounts for the work of the dish, and the horizontal law is the
// slider alone. Beyond 0.9 R the dish continues as a cone. If along and across have single laws, their dishes are
// cylinders whose rises add up.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <type_traits>
#include <variant>

#include "base/portable.hpp"
#include "law/bearing/bearing.hpp"

namespace trilith {

/// Height of the slider above the centre of the dish [m] and its slope, at a distance u from the centre [m].
struct DishRise {
  double height, slope;
};
inline DishRise rise_of_dish(double radius, double u) {
  constexpr double last = 0.9;  // share of the radius up to which the dish is a sphere
  const double within = std::min(std::abs(u), last * radius);
  const double depth = std::sqrt(radius * radius - within * within), slope = within / depth;
  return {radius - depth + slope * (std::abs(u) - within), std::copysign(slope, u)};
}

/// A law whose slider may stand on a dish.
template <class L>
concept HasDish = requires(const L& law, const DirectionMotion& m, const DirectionMemory& before) {
  { law.rise } -> std::convertible_to<double>;
  { law.respond_on_dish(m, before, 0.0) } -> std::same_as<DirectionResponse>;
};

/// 0 for all laws without a dish that rises.
inline double dish_radius(const DirectionLaw& law) {
  return std::visit(
      [](const auto& l) {
        if constexpr (HasDish<std::decay_t<decltype(l)>>)
          return l.rise > 0 ? l.radius : 0.0;
        else
          return 0.0;
      },
      law);
}

/// True for a bearing on a dish: a pendulum with `rise` and an axial law.
template <int D>
bool has_dish(const Bearing<D>& b) {
  if (std::holds_alternative<std::monostate>(b.law[Directions<D>::axial])) return false;
  if constexpr (D == 3)
    if (dish_radius(b.horizontal) > 0) return true;
  for (int k = 0; k < Directions<D>::axial; ++k)
    if (dish_radius(b.law[k]) > 0) return true;
  return false;
}

/// Rise of a bearing's dish at a displacement, and its slopes along the directions before the axial one.
template <int D>
struct Dish {
  double height = 0;  ///< [m]
  std::array<double, D - 1> slope{};

  Dish() = default;
  Dish(const Bearing<D>& b, const std::array<double, Space<D>::dofs>& displacement) {
    if constexpr (D == 3)
      if (const double radius = dish_radius(b.horizontal); radius > 0) {
        const double u = portable::hypot(displacement[0], displacement[1]);
        const DishRise rise = rise_of_dish(radius, u);
        height = rise.height;
        for (std::size_t k = 0; u > 0 && k < 2; ++k) slope[k] = rise.slope * displacement[k] / u;
        return;
      }
    for (std::size_t k = 0; k < slope.size(); ++k)
      if (const double radius = dish_radius(b.law[k]); radius > 0) {
        const DishRise rise = rise_of_dish(radius, displacement[k]);
        height += rise.height, slope[k] = rise.slope;
      }
  }
  [[nodiscard]] double along_slope(const std::array<double, Space<D>::dofs>& of) const {
    double sum = 0;
    for (std::size_t k = 0; k < slope.size(); ++k) sum += slope[k] * of[k];
    return sum;
  }
};

/// Motion of a bearing as its laws use it: the axial displacement is measured from the surface of the dish.
template <int D>
struct LawMotion {
  static constexpr std::size_t axial = Directions<D>::axial;
  using Numbers = std::array<double, Space<D>::dofs>;

  Numbers displacement, rate, mean;
  Dish<D> dish;
  bool on_dish;

  LawMotion(const Bearing<D>& b, const Numbers& displacement_now, const Numbers& rate_now, const Numbers& mean_now,
            double dt)
      : displacement(displacement_now), rate(rate_now), mean(mean_now), on_dish(has_dish(b)) {
    if (!on_dish) return;
    dish = Dish<D>(b, displacement);
    displacement[axial] -= dish.height;
    rate[axial] -= dish.along_slope(rate);
    if (!(dt > 0)) {
      mean[axial] -= dish.along_slope(mean);
      return;
    }
    Numbers from = displacement_now;
    for (std::size_t k = 0; k < axial; ++k) from[k] -= mean[k] * dt;
    mean[axial] -= (dish.height - Dish<D>(b, from).height) / dt;
  }
  /// Resisting force along direction k due to an axial force [N].
  [[nodiscard]] double thrust(std::size_t k, double axial_force) const {
    return on_dish && k < axial ? -axial_force * dish.slope[k] : 0;
  }
};

}  // namespace trilith
