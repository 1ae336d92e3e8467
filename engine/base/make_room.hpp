// Room for lists that come and go.
#pragma once

#include <cstddef>
#include <vector>

namespace trilith {

/// Room for `count` and a quarter more, where there is too little: a list that has just room for what it holds would
/// move each time that it is longer by one.
template <class T>
void make_room(std::vector<T>& list, std::size_t count) {
  if (list.capacity() < count) list.reserve(count + count / 4);
}

}  // namespace trilith
