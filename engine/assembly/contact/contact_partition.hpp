// The rows of faces parted between threads.
#pragma once

#include "model/model.hpp"
#include "model/work.hpp"

namespace trilith {

/// True where the rows of faces are parted between work.threads: made where the pairs have been the same for long
/// enough to be worth it.
///
/// Comes in: the pairs, in the order of rows. Goes out: some runs of rows for each thread, all as long, and which sides
/// of rows are at a border: those of bodies that have rows in two runs. All other bodies get their forces from one run
/// alone, whose thread can add them as it goes, in the order of rows.
bool partition_face_contacts(const Model<2>& model, Work<2>& work);

}  // namespace trilith
