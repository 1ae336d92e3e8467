// Each kind in the lists of loads, laws and bodies has all that is needed of it, or this file does not compile. The
// lists are included nearly everywhere, where each of these checks would be made again.
#include "element/list.hpp"
#include "law/bearing/list.hpp"
#include "law/contact/list.hpp"
#include "law/fibre/list.hpp"
#include "law/material/list.hpp"
#include "load/list.hpp"

namespace trilith {

static_assert(LoadKinds<2>::all([]<class L>() { return LoadData<L>; }));
static_assert(LoadKinds<3>::all([]<class L>() { return LoadData<L>; }));
static_assert(DirectionLaws::all([]<class L>() { return DirectionLawType<L>; }));
static_assert(SolidLaws::all([]<class L>() { return SolidLawType<L>; }));
static_assert(UniaxialLaws::all([]<class L>() { return UniaxialLawType<L>; }));
static_assert(BodyKinds::all([]<class K>() { return BodyKindType<K>; }));
static_assert(ContactLaws::all([]<class L>() { return ContactLawType<L>; }));
static_assert(ContactLaws::all([]<class L>() { return has_whole_point_form<typename L::Kernel>; }),
              "a kernel K with its own effective() or friction() begins with PointLaw<K>; one with its own effective() "
              "has its own tangent()");

}  // namespace trilith
