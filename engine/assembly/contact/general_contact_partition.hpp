// Partition of the rows of general contacts between threads.
//
// Input: the active rows (in space all rows), sorted by their first piece. Each thread has neighbouring runs of equal
// length, so that the pieces it places and its results stay in its own cache. Output: forces at skin points, lists of
// touching and changed rows, and energy sums. They have the same bits as if one row were processed after the other. A
// body with all rows in one run receives their forces directly, in the order of rows. Forces on other bodies are stored
// and added run by run after all rows are done. Dissipated energies are added in the same order.
#pragma once

#include "model/model.hpp"
#include "model/work.hpp"

namespace trilith {

/// Partitions Work::awake_rows, in space all rows, into Work::general_runs: some runs for each thread, or one run for
/// few rows. No row touches yet. Returns the number of runs with rows, which come first.
int partition_general_contacts(const Model<2>& model, Work<2>& work);
int partition_general_contacts(const Model<3>& model, Work<3>& work);

/// Adds the results of the rows of a run from `first` to before `last`, one answer each.
void take_up(const Model<2>& model, Work<2>& work, GeneralRun<2>& run, int first, int last,
             const OverlapAnswer* answers);
void take_up(const Model<3>& model, Work<3>& work, GeneralRun<3>& run, int first, int last, const SolidAnswer* answers);

/// Adds the stored results of the runs after all rows are done.
void join_general_partitions(Work<2>& work);
void join_general_partitions(Work<3>& work);

}  // namespace trilith
