#include "assembly/contact/closing_contacts.hpp"

#include "base/make_room.hpp"

namespace trilith {

template <int D>
void reserve_closing_contacts(Work<D>& work) {
  make_room(work.closing, work.pairs.size()), make_room(work.closed_again, work.pairs.size());
  work.may_close.resize(closing_flags);
}

template void reserve_closing_contacts(Work<2>&);
template void reserve_closing_contacts(Work<3>&);

}  // namespace trilith
