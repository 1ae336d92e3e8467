// Floor beams of a building: where each lies, and the pockets that they have in the walls.
#pragma once

#include "build/space/building_plan.hpp"

namespace trilith {

/// Adds the beams of every storey and their pockets to a plan whose walls, storeys and openings are there. Throws
/// InputError as build_building does.
void plan_beams(const Building& building, BuildingPlan& plan);

}  // namespace trilith
