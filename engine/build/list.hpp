// The builders of scripts: outlines in the plane, solids in space. A new one is its own file and a row here.
#pragma once

#include "base/schema.hpp"
#include "build/builder_keys.hpp"
#include "build/plane/arch.hpp"
#include "build/plane/block.hpp"
#include "build/plane/bridge.hpp"
#include "build/plane/flying_buttress.hpp"
#include "build/plane/ground.hpp"
#include "build/plane/rubble.hpp"
#include "build/plane/running_bond.hpp"
#include "build/plane/stack.hpp"
#include "build/plane/wall.hpp"
#include "build/space/barrel_vault.hpp"
#include "build/space/building.hpp"
#include "build/space/cross_vault.hpp"
#include "build/space/dome.hpp"
#include "build/space/drum.hpp"
#include "build/space/grains.hpp"
#include "build/space/solid_block.hpp"
#include "build/space/solid_file.hpp"
#include "build/space/solid_rubble.hpp"

namespace trilith {

using PlaneBuilders = TypeList<GroundProfile, Pier, Abutment, Block, PolygonShape, Stack, HarmonicStack, Arch,
                               FlyingButtress, Wall, Rubble, RunningBond, BenchWall, Span>;
static_assert(PlaneBuilders::all([]<class B>() { return DeclaredBuilder<B>; }));

using SpaceBuilders = TypeList<SolidBox, Extrusion, HullSolid, RegularPrism, Column, SolidWall, Building, BarrelVault,
                               CrossVault, Dome, SolidRubble, SolidFile, Ball, Clump, Pour>;
static_assert(SpaceBuilders::all([]<class B>() { return DeclaredBuilder<B>; }));

}  // namespace trilith
