// Partition of the rows of face contacts between threads.
#pragma once

#include "model/model.hpp"
#include "model/work.hpp"

namespace trilith {

/// True if the rows of face contacts are partitioned between work.threads. The partition is made after the pairs have
/// been unchanged for several evaluations.
///
/// Input: the pairs, in the order of rows. Output: some runs of rows of equal length for each thread, and the border
/// sides of rows, whose bodies have rows in two runs. All other bodies receive their forces from one run alone, so its
/// thread can add them directly, in the order of rows.
bool partition_face_contacts(const Model<2>& model, Work<2>& work);

}  // namespace trilith
