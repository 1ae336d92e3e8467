// Geometries in which the equations of a contact law act.
//
//     | geometry                      | members of the kernel in use        | caller                       |
//     |-------------------------------|-------------------------------------|------------------------------|
//     | faces in the plane            | begin, press, slide, end            | contact/plane/face_pair.hpp        |
//     | polygons of any shape         | stretch, over, slide                | contact/plane/overlap_pair.hpp     |
//     | flat faces, polyhedra, spheres| effective, friction                 | contact/space/solid_contact.hpp    |
//
// PointLaw derives all other members from `effective` and `friction`, so a law with these acts everywhere. A kernel
// that overrides other members acts only where they are called; models that could use it elsewhere are rejected. A
// kernel may still declare that it is complete. It names itself as the type, so that derived kernels do not inherit the
// declaration:
//
//     using FrictionRemains = Kernel   outside of face contact, pressure and Coulomb friction are complete
//     using JointForm = Kernel         contact/joint/joint.hpp has its equations for faces in space
//
// All checks run at compile time.
#pragma once

#include <array>
#include <string_view>

#include "law/contact/point_law.hpp"

namespace trilith {

enum class ContactForm : std::uint8_t { plane_faces, polygons, flat_faces, polyhedra, spheres };
inline constexpr std::array<ContactForm, 5> contact_forms{ContactForm::plane_faces, ContactForm::polygons,
                                                          ContactForm::flat_faces, ContactForm::polyhedra,
                                                          ContactForm::spheres};
inline constexpr std::array<std::string_view, 5> contact_form_names{
    "faces in the plane", "polygons of any shape in the plane", "flat faces in space", "polyhedra in space",
    "spheres in space"};

/// True for the owners of members that belong to the point form: Coulomb and PointLaw.
template <class C>
struct PointFormOwner : std::false_type {};
template <>
struct PointFormOwner<std::type_identity<Coulomb>> : std::true_type {};
template <class K>
struct PointFormOwner<std::type_identity<PointLaw<K>>> : std::true_type {
  using Kernel = K;
};

/// Whether a kernel overrides the members used by faces and polygons.
template <class K>
struct OwnMembers {
  using M = typename K::template Memory<double>;
  static constexpr bool begin = !requires {
    requires PointFormOwner<decltype(owner_of(&K::template begin<double, M>))>::value;
  };
  static constexpr bool press = !requires {
    requires PointFormOwner<decltype(owner_of(&K::template press<double>))>::value;
  };
  static constexpr bool slide = !requires {
    requires PointFormOwner<decltype(owner_of(&K::template slide<double>))>::value;
  };
  static constexpr bool end = !requires {
    requires PointFormOwner<decltype(owner_of(&K::template end<double, M>))>::value;
  };
  static constexpr bool stretch = !requires {
    requires PointFormOwner<decltype(owner_of(&K::template stretch<double>))>::value;
  };
  static constexpr bool over = [] {
    if constexpr (requires { owner_of(&K::over); })
      return !PointFormOwner<decltype(owner_of(&K::over))>::value;
    else
      return &K::over != &Coulomb::over;
  }();
  static constexpr bool any = begin || press || slide || end || stretch || over;
};

template <class K>
inline constexpr bool friction_remains = [] {
  if constexpr (requires { typename K::FrictionRemains; }) return std::is_same_v<typename K::FrictionRemains, K>;
  return false;
}();
template <class K>
inline constexpr bool has_joint_form = [] {
  if constexpr (requires { typename K::JointForm; }) return std::is_same_v<typename K::JointForm, K>;
  return false;
}();

/// slide() of an unbonded contact: where friction remains, the friction of the base law.
template <class K, class T>
TRILITH_INLINE void slide_unbonded(const K& law, HalfState<T>& half, T active, const ShearBefore<T>& before,
                                   HalfResponse<T>& out) {
  if constexpr (friction_remains<K>)
    law.Coulomb::slide(half, active, before, out);
  else
    law.slide(half, active, before, out);
}

/// Whether PointLaw calls K's `Member`, a member of the point form, to derive `Made`.
template <class Member, class Made>
inline constexpr bool is_asked_by = false;
template <class E, class P>
inline constexpr bool is_asked_by<std::type_identity<E>, std::type_identity<PointLaw<P>>> = std::is_base_of_v<E, P>;

/// Whether a kernel with its own pressure or friction at a point derives all members used by faces and polygons from
/// it, and defines its stiffness.
template <class K>
inline constexpr bool has_whole_point_form = [] {
  if constexpr (has_own_effective<K>) {
    if constexpr (!requires {
                    requires is_asked_by<decltype(owner_of(&K::effective)),
                                         decltype(owner_of(&K::template press<double>))>;
                    requires is_asked_by<decltype(owner_of(&K::effective)),
                                         decltype(owner_of(&K::template stretch<double>))>;
                    requires !std::is_same_v<decltype(owner_of(&K::tangent)), std::type_identity<Coulomb>>;
                  })
      return false;
  }
  if constexpr (has_own_friction<K>) {
    if constexpr (!requires {
                    requires is_asked_by<decltype(owner_of(&K::friction)),
                                         decltype(owner_of(&K::template slide<double>))>;
                  })
      return false;
  }
  return true;
}();

/// The equations of its own that a geometry does not use, as text; empty if it uses all.
template <class K>
constexpr std::string_view left_out(ContactForm form) {
  using Own = OwnMembers<K>;
  switch (form) {
    case ContactForm::plane_faces:
      return (Own::stretch || Own::over) && !Own::press ? "stretch and over" : "";
    case ContactForm::polygons:
      if (friction_remains<K>) return "";
      if (Own::begin || Own::end) return "begin and end";
      return Own::press && !(Own::stretch && Own::over) ? "press" : "";
    case ContactForm::spheres:
      if (friction_remains<K>) return "";
      break;
    default:
      if (has_joint_form<K>) return "";
  }
  if (Own::press) return "press";
  if (Own::slide) return "slide";
  return Own::any ? "begin, end, stretch or over" : "";
}

}  // namespace trilith
