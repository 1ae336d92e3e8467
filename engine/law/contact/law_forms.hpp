// In which geometries the equations of a contact law act.
//
// | geometry                      | asks of a kernel                    | by way of                    |
// |-------------------------------|-------------------------------------|------------------------------|
// | faces in the plane            | begin, press, slide, end            | contact/plane/face_pair.hpp        |
// | polygons of any shape         | stretch, over, slide                | contact/plane/overlap_pair.hpp     |
// | flat faces, polyhedra, spheres| effective, friction                 | contact/space/solid_contact.hpp    |
//
// `effective` and `friction` on PointLaw make all the others, so a law of those acts everywhere. A kernel that has some
// of the others of its own acts where they are asked, and a model that could meet it elsewhere is refused. It may say
// that it is complete all the same, by itself as a type, so that no kernel that begins with it says so unasked:
//   using FrictionRemains = Kernel   where its faces are faces no more, pressure and Coulomb friction are all of it
//   using JointForm = Kernel         contact/joint/joint.hpp has its equations, of faces in space
// All of it is found at compile time.
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

/// Of a class that has a member of the point form, or what the point form makes of it.
template <class C>
struct PointFormOwner : std::false_type {};
template <>
struct PointFormOwner<std::type_identity<Coulomb>> : std::true_type {};
template <class K>
struct PointFormOwner<std::type_identity<PointLaw<K>>> : std::true_type {
  using Kernel = K;
};

/// Whether a kernel has its own of what faces and polygons ask.
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

/// slide() of a contact that no bond holds: of a law of which friction remains, that.
template <class K, class T>
TRILITH_INLINE void slide_unbonded(const K& law, HalfState<T>& half, T active, const ShearBefore<T>& before,
                                   HalfResponse<T>& out) {
  if constexpr (friction_remains<K>)
    law.Coulomb::slide(half, active, before, out);
  else
    law.slide(half, active, before, out);
}

/// Whether what `Member`, a member of the point form, is in K is also what PointLaw asks as it makes `Made`.
template <class Member, class Made>
inline constexpr bool is_asked_by = false;
template <class E, class P>
inline constexpr bool is_asked_by<std::type_identity<E>, std::type_identity<PointLaw<P>>> = std::is_base_of_v<E, P>;

/// Whether a kernel with its own pressure or friction at a point has made of it all that faces and polygons ask, and
/// says how stiff its pressure is.
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

/// Which of its own equations a geometry leaves out, as text; empty where all of them act.
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
