// Contacts that open for a moment: contacts lost among the closing ones, and the list of separated contacts.
#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "assembly/contact/closing_contacts.hpp"
#include "events/parted_contacts.hpp"

namespace trilith::testing {
namespace {

/// A step of random contacts in space: some of `rows` are closed before and some after; `parted` of the others opened
/// shortly before, in an order of their own.
struct ChanceStep {
  State<3> state;
  Work<3> work;

  ChanceStep(int rows, int parted, unsigned seed) {
    std::mt19937 chance(seed);
    for (int row = 0; row < rows; ++row) {
      for (SolidHistory* contacts : {&state.contacts, &work.contacts}) {
        contacts->key.push_back(contact_key(row / 7, 1000 + row));
        contacts->memory.emplace_back();
        if (chance() % 2 == 0) contacts->memory.back().state |= contact_touching;
      }
      work.changed_rows.push_back(row);
    }
    work.pairs.resize(static_cast<std::size_t>(rows));
    reserve_closing_contacts(work);
    std::vector<ContactKey> keys = state.contacts.key;
    std::shuffle(keys.begin(), keys.end(), chance);
    for (int i = 0; i < parted; ++i) state.parted.push_back({keys[static_cast<std::size_t>(i)], 1e-3 * i});
  }
  [[nodiscard]] bool closes(std::size_t row) const {
    return (state.contacts.memory[row].state & contact_touching) == 0 &&
           (work.contacts.memory[row].state & contact_touching) != 0;
  }
};

}  // namespace

TEST_CASE("contacts that opened recently and close are found, and no others, one by one or all at once") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    ChanceStep step(500, static_cast<int>(25 * seed) - 25, seed);
    // One after the other, in the order of the queries.
    std::vector<Parted> left = step.state.parted;
    std::vector<bool> again;
    for (std::size_t row = 0; row < 500; ++row)
      again.push_back(step.closes(row) && std::erase_if(left, [&](const Parted& p) {
                                            return p.contact == step.work.contacts.key[row];
                                          }) == 1);
    take_back(step.state, step.work);
    for (std::size_t row = 0; row < 500; ++row)
      CHECK(has_closed_again(step.work, step.work.contacts.key[row]) == again[row]);
    REQUIRE(step.state.parted.size() == left.size());
    for (std::size_t i = 0; i < left.size(); ++i) {
      CHECK(step.state.parted[i].contact == left[i].contact);
      CHECK(step.state.parted[i].time == left[i].time);
    }
  }
}

TEST_CASE("the closing of a contact is reported in its own step") {
  ChanceStep step(50, 50, 3);
  take_back(step.state, step.work);
  const std::size_t closed = step.work.closed_again.size();
  CHECK(closed > 5);
  step.work.changed_rows.clear();
  take_back(step.state, step.work);
  for (const ContactKey key : step.work.contacts.key) CHECK_FALSE(has_closed_again(step.work, key));
  CHECK(step.state.parted.size() == 50 - closed);
}

}  // namespace trilith::testing
