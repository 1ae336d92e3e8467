// The energy ledger: its terms and its residual.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace trilith {

/// Terms of the ledger [J]. Elastic and kinetic terms are computed from the state. The others are summed step by step,
/// each from its own law, so the residual is a check and not an identity.
enum class EnergyTerm : int {
  kinetic,
  gravity,  ///< work against gravity
  contact_elastic,
  bearing_elastic,
  strain,  ///< elastic energy of deformable bodies
  contact_damping,
  contact_friction,
  contact_fracture,  ///< elastic energy of a bond at its loss, minus the energy at its setting; crushing of mortar
  bearing_damping,
  bearing_inner,    ///< plastic and frictional dissipation
  bearing_failure,  ///< elastic energy of a bearing at its failure
  plastic,          ///< plastic work in deformable bodies
  element_damping,  ///< strain rate damping in deformable bodies
  mass_damping,
  rest_damping,  ///< damping of consolidation
  support,       ///< work of moving supports
  load,          ///< work of steady forces
  left_bounds,   ///< energy of bodies that left the bounds
  numerical,     ///< numerical dissipation of an implicit scheme
  added,         ///< energy of bodies and bearings added later, and of changed laws
  removed,       ///< energy of removed bodies and bearings
  water,         ///< work of the pressure and the drag of water
  heat,          ///< elastic energy that changes of temperature put into bodies
};
inline constexpr int energy_terms = 23;
/// Number of terms in every digest of a run. Later terms belong to models that change, to water and to heat. They are
/// included where they are not 0, so the hashes of all other runs do not change.
inline constexpr std::size_t plain_energy_terms = 19;
/// Number of terms without water, and without heat.
inline constexpr std::size_t dry_energy_terms = 21, cold_energy_terms = 22;

struct EnergyTermInfo {
  std::string_view name, sentence;
  int sign;                 ///< +1: has received energy, -1: has supplied it
  bool dissipated = false;  ///< irreversible: friction, damping, fracture, yielding
};

inline constexpr std::array<EnergyTermInfo, energy_terms> energy_term_info{{
    {"kinetic", "kinetic energy", +1},
    {"gravity", "potential energy of the weight, from the start", +1},
    {"contact_elastic", "elastic energy of contacts", +1},
    {"bearing_elastic", "elastic energy of bearings", +1},
    {"strain", "elastic energy of deformable bodies", +1},
    {"contact_damping", "dissipated by contact damping", +1, true},
    {"contact_friction", "dissipated by sliding friction, and by faces that separate while sliding", +1, true},
    {"contact_fracture", "dissipated by breaking bonds, less their initial energy, and by crushing of mortar", +1,
     true},
    {"bearing_damping", "dissipated by the dashpots of bearings", +1, true},
    {"bearing_inner", "dissipated by yielding or sliding of bearings", +1, true},
    {"bearing_failure", "dissipated by failing bearings", +1, true},
    {"plastic", "dissipated by plastic strain of deformable bodies", +1, true},
    {"element_damping", "dissipated by the damping of deformable bodies", +1, true},
    {"mass_damping", "dissipated by mass-proportional damping", +1, true},
    {"rest_damping", "dissipated by the damping of consolidation", +1, true},
    {"support", "work of moving supports (input)", -1},
    {"load", "work of loads (input)", -1},
    {"left_bounds", "energy of bodies that left the bounds", +1, true},
    {"numerical", "dissipated by the numerical damping of implicit steps, less the energy gained by their errors", +1,
     true},
    {"added", "energy of bodies and bearings that were added, and of changed laws (input)", -1},
    {"removed", "energy of bodies and bearings that were removed", +1, true},
    {"water", "work of the pressure and the drag of water (input)", -1},
    {"heat", "elastic energy that changes of temperature put into bodies (input)", -1},
}};

struct Energy {
  std::array<double, energy_terms> value{};
  [[nodiscard]] double& operator[](EnergyTerm t) { return value[static_cast<std::size_t>(t)]; }
  [[nodiscard]] double operator[](EnergyTerm t) const { return value[static_cast<std::size_t>(t)]; }
  /// Sum of received energy minus supplied energy: 0 up to integration errors.
  [[nodiscard]] double balance() const {
    double sum = 0;
    for (int i = 0; i < energy_terms; ++i) sum += energy_term_info[i].sign * value[i];
    return sum;
  }
};

/// Work on one node, or on several, along a path [J].
struct NodeWork {
  double weight = 0, load = 0, support = 0, element_damping = 0, rest = 0, mass = 0;

  NodeWork& operator+=(const NodeWork& w) {
    weight += w.weight, load += w.load, support += w.support;
    element_damping += w.element_damping, rest += w.rest, mass += w.mass;
    return *this;
  }
};

/// Adds it to the ledger's sums.
inline void add(const NodeWork& w, Energy& given) {
  given[EnergyTerm::gravity] -= w.weight;
  given[EnergyTerm::load] += w.load;
  given[EnergyTerm::support] -= w.support;
  given[EnergyTerm::element_damping] -= w.element_damping;
  given[EnergyTerm::rest_damping] -= w.rest;
  given[EnergyTerm::mass_damping] -= w.mass;
}

}  // namespace trilith
