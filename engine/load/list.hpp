// The kinds of loads, and the loads of a model. A new kind is its own file and a row here.
#pragma once

#include <cstddef>
#include <tuple>
#include <vector>

#include "base/schema.hpp"
#include "load/face_load.hpp"
#include "load/point_load.hpp"
#include "load/water/added_mass.hpp"
#include "load/water/drag.hpp"
#include "load/water/uplift.hpp"
#include "load/water/water.hpp"

namespace trilith {

template <int D>
using LoadKinds = TypeList<PointLoad<D>, FaceLoad<D>, Water<D>, Uplift<D>, Drag<D>, AddedMass<D>>;

/// Number of kinds in every fingerprint of a model with loads. Later kinds are included where a model has such loads,
/// so that the fingerprints of all other models do not change.
inline constexpr std::size_t plain_load_kinds = 2;

/// One array for each kind of a list.
template <class List>
struct LoadArrays;
template <class... L>
struct LoadArrays<TypeList<L...>> {
  using Tuple = std::tuple<std::vector<L>...>;
};

/// The loads of a model: one array for each kind, in the order of the list. Loops over them are unrolled.
template <int D>
class Loads {
 public:
  /// The loads of one kind.
  template <class L>
  [[nodiscard]] std::vector<L>& of() {
    return std::get<std::vector<L>>(arrays_);
  }
  template <class L>
  [[nodiscard]] const std::vector<L>& of() const {
    return std::get<std::vector<L>>(arrays_);
  }
  /// Appends loads of one kind.
  template <class L>
  void add(const std::vector<L>& more) {
    of<L>().insert(of<L>().end(), more.begin(), more.end());
  }
  /// Calls f(array) for each kind.
  template <class F>
  void for_each_kind(F&& f) {
    std::apply([&](auto&... arrays) { (f(arrays), ...); }, arrays_);
  }
  template <class F>
  void for_each_kind(F&& f) const {
    std::apply([&](const auto&... arrays) { (f(arrays), ...); }, arrays_);
  }
  /// Calls f(load) for each load of every kind that acts in D dimensions.
  template <class F>
  void for_each(F&& f) {
    for_each_kind([&]<class L>(std::vector<L>& loads) {
      if constexpr (acts_in<L, D>)
        for (L& load : loads) f(load);
    });
  }
  template <class F>
  void for_each(F&& f) const {
    for_each_kind([&]<class L>(const std::vector<L>& loads) {
      if constexpr (acts_in<L, D>)
        for (const L& load : loads) f(load);
    });
  }
  /// Removes the loads for which `is_gone` is true. Returns their number.
  template <class F>
  int erase_if(F&& is_gone) {
    std::size_t count = 0;
    for_each_kind([&](auto& loads) { count += std::erase_if(loads, is_gone); });
    return static_cast<int>(count);
  }
  [[nodiscard]] bool empty() const {
    return std::apply([](const auto&... arrays) { return (arrays.empty() && ...); }, arrays_);
  }

 private:
  typename LoadArrays<LoadKinds<D>>::Tuple arrays_;
};

/// The loads of one kind in a model.
template <class L, class M>
auto& loads_of(M& model) {
  return model.loads.template of<L>();
}

}  // namespace trilith
