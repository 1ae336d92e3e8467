// Readers of the masonry builders' tables: stacks, arches, walls, rubble.
#pragma once

#include "bindings/geometry/part_makers.hpp"

namespace trilith::script {

MakeParts read_stack(Keys& k);
MakeParts read_harmonic_stack(Keys& k);
MakeParts read_arch(Keys& k);
MakeParts read_flying_buttress(Keys& k);
MakeParts read_wall(Keys& k);
MakeParts read_rubble(Keys& k);
MakeParts read_running_bond(Keys& k);
MakeParts read_bench_wall(Keys& k);

}  // namespace trilith::script
