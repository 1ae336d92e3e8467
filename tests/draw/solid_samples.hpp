// Invented collapses in space for pictures: a wall of bricks whose upper half falls, a dome that breaks apart.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "results/tumbling_boxes.hpp"

namespace trilith::testing {

/// Pseudo-random numbers between -1 and 1 by index.
inline double scatter(int i) {
  return std::remainder(0.7548776662466927 * i + 0.31, 1.0) * 2;
}

/// 20 courses of 10 bricks in running bond on a slab; bricks above the diagonal fly outwards, the higher ones earlier.
inline std::vector<FlyingBox> falling_wall() {
  const Vec3 half(0.125, 0.06, 0.0325);
  std::vector<FlyingBox> boxes{{{30, 30, 2}, {0, 0, -2}, Vec3::Zero(), Vec3::Zero(), "ground", "fixed"}};
  for (int course = 0; course < 20; ++course)
    for (int i = 0; i < 10; ++i) {
      const double x = 0.25 * (i - 4.5) + (course % 2 == 0 ? 0 : 0.125), z = 0.065 * course + half.z();
      FlyingBox box{half, {x, 0, z}};
      const double share = (z - 0.45 - 0.25 * std::abs(x)) / 0.8;
      const int k = 10 * course + i;
      if (share > 0) {
        box.velocity = {0.15 * scatter(k), -0.3 - 1.2 * share, 0.1 - 0.25 * share};
        box.spin = {2.5 * share + scatter(k + 7), 0.8 * scatter(k + 3), 0.9 * scatter(k + 5)};
        box.begin = 0.4 * (1 - share);
      }
      box.group = course < 10 ? "lower" : "upper";
      boxes.push_back(box);
    }
  return boxes;
}

/// Closed rings of stones on a sphere of radius 3 m; a third of the stones has begun to fall.
inline std::vector<FlyingBox> opening_dome() {
  std::vector<FlyingBox> boxes{{{3.6, 3.6, 0.15}, {0, 0, -0.15}, Vec3::Zero(), Vec3::Zero(), "slab", "fixed"}};
  const double radius = 3, pi = std::numbers::pi;
  for (int ring = 0; ring < 13; ++ring) {
    const double height = (ring + 0.5) * pi / 2 / 14, around = radius * std::cos(height);
    const int count = std::max(3, static_cast<int>(2 * pi * around / 0.55));
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * pi * (i + 0.5 * (ring % 2)) / count;
      const UnitQuaternion turn = rotation_by({0, 0, angle}) * rotation_by({0, -height, 0});
      const double width = pi * (around - 0.15 * std::cos(height) - 0.16 * std::sin(height)) / count * 0.94;
      FlyingBox box{{0.14, width, 0.13}, turn_of(turn).apply({radius, 0, 0})};
      box.rotation = turn;
      box.group = ring % 2 == 0 ? "even rings" : "odd rings";
      const int k = 40 * ring + i;
      if (ring > 8 && angle < pi / 1.5) {
        box.velocity = {0.2 * scatter(k), 0.2 * scatter(k + 1), -1 - 0.3 * scatter(k + 2)};
        box.spin = {scatter(k + 3), scatter(k + 4), scatter(k + 5)};
      }
      boxes.push_back(box);
    }
  }
  return boxes;
}

/// `count` stones of random sizes and rotations in a heap, each in its own cell, so that none overlap.
inline std::vector<FlyingBox> heap(int count) {
  std::vector<FlyingBox> boxes;
  const int side = static_cast<int>(std::ceil(std::cbrt(count)));
  for (int i = 0; i < count; ++i) {
    const Vec3 cell(i % side, i / side % side, i / (side * side));
    const Vec3 half = Vec3(0.25 + 0.02 * scatter(i), 0.27 + 0.02 * scatter(2 * i), 0.25 + 0.02 * scatter(3 * i));
    FlyingBox box{half, cell};
    box.rotation = rotation_by(Vec3(3 * scatter(5 * i), 3 * scatter(7 * i), 3 * scatter(11 * i)));
    boxes.push_back(box);
  }
  return boxes;
}

}  // namespace trilith::testing
