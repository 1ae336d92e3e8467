// Floor beams of a building: their positions, and their pockets in the walls.
#pragma once

#include "build/space/building_plan.hpp"

namespace trilith {

/// Adds the beams of every storey and their pockets to a plan with walls, storeys and openings. Throws InputError as
/// build_building does.
void plan_beams(const Building& building, BuildingPlan& plan);

}  // namespace trilith
