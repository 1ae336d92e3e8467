// An event in words.
#pragma once

#include <string>

#include "world/event.hpp"
#include "world/model.hpp"

namespace trilith::script {

/// An event in one line, without its time: what, who, how much, caused by what.
std::string event_line(const Event& event, const Model<2>& model);

}  // namespace trilith::script
