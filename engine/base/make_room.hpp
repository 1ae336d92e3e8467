// Capacity of lists whose length varies from step to step.
#pragma once

#include <cstddef>
#include <vector>

namespace trilith {

/// Reserves `count` and a quarter more where the capacity is too small. With exact capacity, a list that grows by one
/// element at a time would be moved at each growth.
template <class T>
void make_room(std::vector<T>& list, std::size_t count) {
  if (list.capacity() < count) list.reserve(count + count / 4);
}

}  // namespace trilith
