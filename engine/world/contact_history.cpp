#include "world/contact_history.hpp"

#include <algorithm>

namespace trilith {

void ContactHistory::clear(std::size_t row) {
  memory[row] = {};
  std::fill_n(law_numbers(row), law_number_counts[law_row[row].place], 0.0);
}

int ContactHistory::find(ContactKey contact) const {
  const auto at = std::lower_bound(key.begin(), key.end(), contact);
  return at != key.end() && *at == contact ? static_cast<int>(at - key.begin()) : -1;
}

}  // namespace trilith
