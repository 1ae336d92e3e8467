// The laws of a fibre. A new law is its own file and a row here.
#pragma once

#include <concepts>
#include <variant>

#include "law/fibre/bilinear_steel.hpp"
#include "law/fibre/elastic.hpp"
#include "law/fibre/kent_park.hpp"
#include "law/fibre/mander.hpp"
#include "law/fibre/menegotto_pinto.hpp"

namespace trilith {

using UniaxialLaws = TypeList<UniaxialElastic, BilinearSteel, MenegottoPinto, KentPark, Mander>;
using UniaxialLaw = UniaxialLaws::Variant;

/// `tangent` is the largest stiffness of a law [Pa]; `stored` is the energy of a memory [J/m3]. `loses_at_every_step`
/// is true where no step of any size returns more energy than was stored. An all-zero memory is a new fibre.
template <class L>
concept UniaxialLawType = Declared<L> && requires(const L& law, double strain, const typename L::Memory& before) {
  requires std::same_as<typename L::Memory, std::array<double, L::memory_size>>;
  requires L::memory_size >= 2;
  { L::loses_at_every_step } -> std::convertible_to<bool>;
  { law.tangent() } -> std::same_as<double>;
  { law.stored(before) } -> std::same_as<double>;
  { law.respond(strain, before) } -> std::same_as<UniaxialResponse<L::memory_size>>;
};

/// Size of the memory of a fibre with `law`.
inline int memory_size(const UniaxialLaw& law) {
  return std::visit([](const auto& l) { return std::decay_t<decltype(l)>::memory_size; }, law);
}
/// Whether it has a fracture energy, so that its strains depend on the length of the beam.
inline bool depends_on_length(const UniaxialLaw& law) {
  return std::visit(
      [](const auto& l) {
        if constexpr (requires { l.crush_energy; })
          return l.crush_energy > 0 || l.energy_tension > 0;
        else
          return false;
      },
      law);
}
/// The law of the fibres of a beam of `length` [m]: of laws with fracture energies, the one with their strains. Throws
/// InputError if the beam is too long for them.
inline UniaxialLaw law_for_length(const UniaxialLaw& law, double length) {
  return std::visit(
      [&](const auto& l) -> UniaxialLaw {
        if constexpr (requires { l.for_length(length); })
          return l.for_length(length);
        else
          return l;
      },
      law);
}
/// Largest stiffness [Pa].
inline double stiffest(const UniaxialLaw& law) {
  return std::visit([](const auto& l) { return l.tangent(); }, law);
}

}  // namespace trilith
