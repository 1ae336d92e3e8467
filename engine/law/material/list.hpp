// The material laws. A new law is its own file and a row here.
#pragma once

#include <variant>

#include "law/material/drucker_prager.hpp"
#include "law/material/j2.hpp"
#include "law/material/linear_elastic.hpp"
#include "law/material/mohr_coulomb.hpp"
#include "law/material/point.hpp"
#include "law/material/tensor_form.hpp"

namespace trilith {

using SolidLaws = TypeList<LinearElastic, J2, MohrCoulomb, DruckerPrager>;
using SolidLaw = SolidLaws::Variant;
/// The elastic law defined by E, nu and damping alone.
using ElasticSolid = LinearElastic;

/// Requirements of a law. An inelastic law has `respond(strain, memory)` in space, from which the plane forms follow,
/// or `respond(plane, strain, memory)`, for the plane alone unless it `acts_across`.
template <class L>
concept SolidLawType = Declared<L> && requires(const L& law, const PlaneVector& strain, const PlasticMemory& memory) {
  { law.young } -> std::convertible_to<double>;
  { law.poisson } -> std::convertible_to<double>;
  { law.damping } -> std::convertible_to<double>;
  { L::is_elastic } -> std::convertible_to<bool>;
  requires L::is_elastic || TensorLaw<L> || requires {
    { law.respond(Plane::strain, strain, memory) } -> std::same_as<PointResponse>;
  };
};

/// How an element's strain follows from nodal displacements, see element/solid/plane_element.hpp.
enum class ElementForm : std::uint8_t { assumed, plain };

/// True where law and all declared parameters agree.
inline bool same_numbers(const SolidLaw& a, const SolidLaw& b) {
  if (a.index() != b.index()) return false;
  return std::visit(
      [&](const auto& l) {
        using T = std::decay_t<decltype(l)>;
        for (const Parameter<T>& p : T::parameters())
          if (l.*(p.member) != std::get<T>(b).*(p.member)) return false;
        return true;
      },
      a);
}

/// The laws here use nominal strain (stretch minus 1) and the reference area. Compressed to half its length a solid has
/// a true (logarithmic) strain of 0.69 instead of 0.5, and its area is uncertain. Beyond this limit the laws are not
/// valid, well before an element inverts at 1.
inline constexpr double usual_strain_limit = 0.5;

/// A solid material: law, plane case and limits.
struct Solid {
  SolidLaw law;
  Plane plane = Plane::stress;
  ElementForm form = ElementForm::assumed;
  double strain_limit = usual_strain_limit;  ///< largest valid principal strain, of either sign [1]

  friend bool operator==(const Solid& a, const Solid& b) {
    return a.plane == b.plane && a.form == b.form && a.strain_limit == b.strain_limit && same_numbers(a.law, b.law);
  }
  [[nodiscard]] bool is_elastic() const {
    return std::visit([](const auto& l) { return std::decay_t<decltype(l)>::is_elastic; }, law);
  }
  [[nodiscard]] double damping() const {
    return std::visit([](const auto& l) { return l.damping; }, law);
  }
  /// [Pa], see elastic_matrix.
  [[nodiscard]] Eigen::Matrix3d elastic() const {
    return std::visit([&](const auto& l) { return elastic_matrix(l.young, l.poisson, plane); }, law);
  }
};

/// Stress at `strain` with the plastic strain in `memory`, without further flow.
inline Stress point_stress(const Solid& solid, const PlaneVector& strain, const PlasticMemory& memory) {
  const PlaneVector elastic = strain - PlaneVector(memory.xx, memory.yy, memory.xy);
  return std::visit([&](const auto& l) { return elastic_stress(l.young, l.poisson, solid.plane, elastic, memory.zz); },
                    solid.law);
}

/// Whether a law has equations in space.
inline bool has_space_form(const SolidLaw& law) {
  return std::visit([](const auto& l) { return acts_in_space<std::decay_t<decltype(l)>>; }, law);
}

/// "linear_elastic{E=...}, plane stress".
inline std::string describe(const Solid& solid) {
  return std::visit([](const auto& l) { return describe(l); }, solid.law) +
         (solid.plane == Plane::stress ? ", plane stress" : ", plane strain") +
         (solid.form == ElementForm::plain ? ", plain elements" : "") +
         (solid.strain_limit != usual_strain_limit ? fmt::format(", strains up to {:g}", solid.strain_limit) : "");
}

}  // namespace trilith
