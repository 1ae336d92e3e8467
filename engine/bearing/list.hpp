// The laws a direction of a bearing can follow: a new one is its own file and a row here.
#pragma once

#include <variant>

#include "bearing/bouc_wen.hpp"
#include "bearing/cable.hpp"
#include "bearing/elastic_plastic.hpp"
#include "bearing/friction.hpp"
#include "bearing/gap.hpp"
#include "bearing/lead_rubber.hpp"
#include "bearing/linear.hpp"
#include "bearing/maxwell.hpp"
#include "bearing/pendulum.hpp"
#include "bearing/pounding.hpp"
#include "bearing/shear_key.hpp"
#include "bearing/table.hpp"
#include "bearing/viscous.hpp"

namespace trilith {

using DirectionLaws = TypeList<Linear, ElasticPlastic, Gap, Table, Friction, Pendulum, BoucWen, LeadRubber, Pounding,
                               Viscous, Maxwell, Cable, ShearKey>;
/// std::monostate: free.
using DirectionLaw = DirectionLaws::VariantOrNone;

template <class L>
concept DirectionLawType = Declared<L> && requires(const L& law, const DirectionMotion& m, const DirectionMemory& d) {
  { law.respond(m, d) } -> std::same_as<DirectionResponse>;
  { law.tangent() } -> std::convertible_to<double>;
  { law.dashpot() } -> std::convertible_to<double>;
};
static_assert(DirectionLaws::all([]<class L>() { return DirectionLawType<L>; }));

/// Given by points, beside its declared numbers.
template <class L>
concept TabulatedLaw = requires(L& law) {
  law.displacement.push_back(0.0);
  law.force.push_back(0.0);
};

}  // namespace trilith
