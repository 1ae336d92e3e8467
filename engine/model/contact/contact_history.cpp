#include "model/contact/contact_history.hpp"

#include <algorithm>

namespace trilith {
namespace {

int row_of_key(const std::vector<ContactKey>& sorted, ContactKey contact) {
  const auto at = std::lower_bound(sorted.begin(), sorted.end(), contact);
  return at != sorted.end() && *at == contact ? static_cast<int>(at - sorted.begin()) : -1;
}

}  // namespace

void ContactHistory::clear(std::size_t row) {
  memory[row] = {};
  std::fill_n(law_numbers(row), law_number_counts[law_row[row].place], 0.0);
}

int ContactHistory::find(ContactKey contact) const {
  return row_of_key(key, contact);
}

int SolidHistory::find(ContactKey contact) const {
  return row_of_key(key, contact);
}

}  // namespace trilith
