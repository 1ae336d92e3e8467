#include "model/postpone.hpp"

#include <algorithm>

namespace trilith {

template <int D>
void postpone_courses(Model<D>& model, double by) {
  if (by == 0) return;
  for (Drive& drive : model.drives) drive.start += by;
  for (Push<D>& push : model.pushes) push.start += by;
  const auto shift = [by](auto& loads) {
    for (auto& load : loads)
      for (double& time : load.curve.time) time += by;
  };
  shift(model.point_loads), shift(model.face_loads);
  Gravity<D>& g = model.gravity;
  g.tilt_start += by, g.tilt_end += by, g.grow_start += by, g.grow_end += by;
}

template <int D>
bool has_courses_to_come(const Model<D>& model, double now) {
  const auto moves = [now](const Drive& drive) { return now < drive.start + drive.motion->end_time(); };
  const auto changes = [now](const auto& load) { return !load.curve.time.empty() && now < load.curve.time.back(); };
  return std::any_of(model.drives.begin(), model.drives.end(), moves) ||
         std::any_of(model.point_loads.begin(), model.point_loads.end(), changes) ||
         std::any_of(model.face_loads.begin(), model.face_loads.end(), changes);
}

template void postpone_courses(Model<2>&, double);
template void postpone_courses(Model<3>&, double);
template bool has_courses_to_come(const Model<2>&, double);
template bool has_courses_to_come(const Model<3>&, double);

}  // namespace trilith
