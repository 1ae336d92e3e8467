// A prescribed value over the time of a field.
#pragma once

#include <string>
#include <vector>

namespace trilith {

/// Linear between its points, constant before the first and after the last one. With a period the points repeat, and
/// the value between the last point and the first one of the next period is linear too.
struct FieldCourse {
  std::vector<double> time;   ///< from `start` on, increasing [s]; none for a constant value
  std::vector<double> value;  ///< as many as times; one without times
  double start = 0;           ///< clock of the field at time 0 [s]
  double period = 0;          ///< above the span of the times [s]; 0: no repetition

  [[nodiscard]] double at(double clock) const;
};

/// Throws InputError, beginning with `owner`, for times that do not increase, numbers that are not finite, no value,
/// and a period that is not longer than the span of the points.
void check_course(const FieldCourse& course, const std::string& owner);

}  // namespace trilith
