// The laws a direction of a bearing can follow: a new one is its own file and a row here.
#pragma once

#include <variant>

#include "bearing/elastic_plastic.hpp"
#include "bearing/friction.hpp"
#include "bearing/gap.hpp"
#include "bearing/linear.hpp"
#include "bearing/pendulum.hpp"
#include "bearing/table.hpp"

namespace trilith {

using DirectionLaws = TypeList<Linear, ElasticPlastic, Gap, Table, Friction, Pendulum>;
/// std::monostate: free.
using DirectionLaw = std::variant<std::monostate, Linear, ElasticPlastic, Gap, Table, Friction, Pendulum>;
static_assert(std::variant_size_v<DirectionLaw> == DirectionLaws::size + 1);

template <class L>
concept DirectionLawType = Declared<L> && requires(const L& law, const DirectionMotion& m, const DirectionMemory& d) {
  { law.respond(m, d) } -> std::same_as<DirectionResponse>;
  { law.tangent() } -> std::convertible_to<double>;
  { law.dashpot() } -> std::convertible_to<double>;
};
static_assert(DirectionLawType<Linear> && DirectionLawType<ElasticPlastic> && DirectionLawType<Gap> &&
              DirectionLawType<Table> && DirectionLawType<Friction> && DirectionLawType<Pendulum>);

}  // namespace trilith
