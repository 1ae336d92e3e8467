// Events as text, for the terminal, the results file and plots.
#pragma once

#include <string>

#include "model/event/event_list.hpp"
#include "model/model.hpp"

namespace trilith {

/// "bearing S3.left failed at 50.8 mm", "S3 lost its seat on P3 (S3.right)", "S3 hit P3 at 4.2 m/s", "shaking ended
/// (rest)".
template <int D>
std::string event_text(const Event& event, const Model<D>& model);

}  // namespace trilith
