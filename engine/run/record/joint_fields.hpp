// Fields of joints in each frame: opening, slip, and lost share of the bond.
#pragma once

#include "run/record/field_source.hpp"

namespace trilith {

struct JointOpening {
  static constexpr std::string_view name = "joint_opening", unit = "m";
  static constexpr std::string_view sentence = "opening of each joint since the start, at its farther end";
  static constexpr RowsOf rows = RowsOf::joints;
  static constexpr int width = 1;
  template <int D>
  static void take(const FieldSource<D>& from, std::vector<double>& out) {
    for (const JointDisplacement& moved : from.joint_displacements) out.push_back(moved.opening);
  }
};

struct JointSlip {
  static constexpr std::string_view name = "joint_slip", unit = "m";
  static constexpr std::string_view sentence = "slip of each joint since the start, at its middle";
  static constexpr RowsOf rows = RowsOf::joints;
  static constexpr int width = 1;
  template <int D>
  static void take(const FieldSource<D>& from, std::vector<double>& out) {
    for (const JointDisplacement& moved : from.joint_displacements) out.push_back(moved.slip);
  }
};

struct JointDamage {
  static constexpr std::string_view name = "joint_damage", unit = "1";
  static constexpr std::string_view sentence = "part of each joint's bond that is lost";
  static constexpr RowsOf rows = RowsOf::joints;
  static constexpr int width = 1;
  template <int D>
  static void take(const FieldSource<D>& from, std::vector<double>& out) {
    for (const JointOf<D>& joint : from.joints) out.push_back(joint_damage(joint, from.now.state));
  }
};

}  // namespace trilith
