// The laws of a bearing's direction. A new law is its own file and a row here.
#pragma once

#include <algorithm>
#include <variant>

#include "law/bearing/bouc_wen.hpp"
#include "law/bearing/cable.hpp"
#include "law/bearing/elastic_plastic.hpp"
#include "law/bearing/friction.hpp"
#include "law/bearing/gap.hpp"
#include "law/bearing/horizontal.hpp"
#include "law/bearing/lead_rubber.hpp"
#include "law/bearing/linear.hpp"
#include "law/bearing/maxwell.hpp"
#include "law/bearing/pendulum.hpp"
#include "law/bearing/pounding.hpp"
#include "law/bearing/shear_key.hpp"
#include "law/bearing/table.hpp"
#include "law/bearing/viscous.hpp"

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

/// Numbers that a bearing reserves for its law of both horizontal directions: the largest memory of these laws.
inline constexpr std::size_t most_horizontal_numbers = [] {
  std::size_t most = 0;
  DirectionLaws::for_each([&]<class L>() {
    if constexpr (HorizontalLaw<L>) most = std::max(most, horizontal_numbers<L>);
  });
  return most;
}();

/// A law given by points in addition to its declared parameters.
template <class L>
concept TabulatedLaw = requires(L& law) {
  law.displacement.push_back(0.0);
  law.force.push_back(0.0);
};

}  // namespace trilith
