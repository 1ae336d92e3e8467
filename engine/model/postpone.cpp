#include "model/postpone.hpp"

#include <algorithm>

namespace trilith {

template <int D>
void postpone_courses(Model<D>& model, double by) {
  if (by == 0) return;
  for (Drive& drive : model.drives) drive.start += by;
  for (Push<D>& push : model.pushes) push.start += by;
  model.loads.for_each([by](auto& load) {
    for (double& time : load.curve.time) time += by;
  });
  Gravity<D>& g = model.gravity;
  g.tilt_start += by, g.tilt_end += by, g.grow_start += by, g.grow_end += by;
}

template <int D>
bool has_courses_to_come(const Model<D>& model, double now) {
  const auto moves = [now](const Drive& drive) { return now < drive.start + drive.motion->end_time(); };
  if (std::any_of(model.drives.begin(), model.drives.end(), moves)) return true;
  bool changes = false;
  model.loads.for_each(
      [&](const auto& load) { changes = changes || (!load.curve.time.empty() && now < load.curve.time.back()); });
  return changes;
}

template void postpone_courses(Model<2>&, double);
template void postpone_courses(Model<3>&, double);
template bool has_courses_to_come(const Model<2>&, double);
template bool has_courses_to_come(const Model<3>&, double);

}  // namespace trilith
