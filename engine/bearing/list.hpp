// The laws a direction of a bearing can follow: a new one is its own file and a row here.
#pragma once

#include <variant>

#include "bearing/bouc_wen.hpp"
#include "bearing/elastic_plastic.hpp"
#include "bearing/friction.hpp"
#include "bearing/gap.hpp"
#include "bearing/linear.hpp"
#include "bearing/pendulum.hpp"
#include "bearing/table.hpp"

namespace trilith {

using DirectionLaws = TypeList<Linear, ElasticPlastic, Gap, Table, Friction, Pendulum, BoucWen>;
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
