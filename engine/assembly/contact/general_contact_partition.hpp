// The rows of general shape parted between threads.
//
// Comes in: the rows that are worked on, in space all, in their order, sorted by their first piece. Each thread has
// runs of them side by side, all as long, so that what it places and answers stays in its own cache. Goes out: forces
// at skin points, lists of what touches and what changed, sums of energy, with the bits of one row after the other: a
// body all of whose rows are in one run gets their forces as they are found, in the order of rows; those on others are
// kept, and added run by run once all are answered. What rows give off is added in their order too.
#pragma once

#include "model/model.hpp"
#include "model/work.hpp"

namespace trilith {

/// Parts Work::awake_rows, in space all rows, into Work::general_runs: some for each thread, or one where more are not
/// worth it. None touches yet. Returns how many of them have rows: the first ones.
int partition_general_contacts(const Model<2>& model, Work<2>& work);
int partition_general_contacts(const Model<3>& model, Work<3>& work);

/// Adds what rows of a run came to, from `first` on to before `last`, one answer each.
void take_up(const Model<2>& model, Work<2>& work, GeneralRun<2>& run, int first, int last,
             const OverlapAnswer* answers);
void take_up(const Model<3>& model, Work<3>& work, GeneralRun<3>& run, int first, int last, const SolidAnswer* answers);

/// Adds what runs have kept, once all rows are answered.
void join_general_partitions(Work<2>& work);
void join_general_partitions(Work<3>& work);

}  // namespace trilith
