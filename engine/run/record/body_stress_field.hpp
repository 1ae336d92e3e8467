// Field of bodies in each frame: mean stress.
#pragma once

#include "run/record/body_forces.hpp"
#include "run/record/field_source.hpp"

namespace trilith {

struct BodyStress {
  static constexpr std::string_view name = "body_stress", unit = "Pa";
  static constexpr std::string_view sentence =
      "mean stress of each body from contacts and bearings: xx, yy, xy; tension positive";
  static constexpr RowsOf rows = RowsOf::bodies;
  static constexpr int width = 3;
  static void take(const FieldSource<2>& from, std::vector<double>& out) {
    for (const MeanStress& s : mean_stress(from.now.model, from.now.state, from.now.work, from.touching))
      out.insert(out.end(), {s.xx, s.yy, s.xy});
  }
};

}  // namespace trilith
