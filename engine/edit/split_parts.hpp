// Data of a model that move from a body that has split to its parts: motion, bearings, seats and loads.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "edit/split_contacts.hpp"
#include "load/list.hpp"
#include "model/crack_planes.hpp"
#include "model/field/heat.hpp"
#include "model/state.hpp"

namespace trilith {

/// Sets the motion of both parts to the rigid motion of their body, and deactivates the body at the present time.
template <int D>
void place_parts(const Model<D>& model, State<D>& state, const SplitBody& split);

/// Attaches bearings, seats, loads and displacement controls of the body to the part that holds their point. A load on
/// a face that spans the plane is divided by its kind, see load/load_kind.hpp.
template <int D>
void hand_over_links(Model<D>& model, const SplitBody& split, const CrackSection<D>& section);

/// Replaces each load of a model, except inertia, by the loads that give(load, list) appends.
template <int D, class Give>
void replace_loads(Model<D>& model, Give&& give) {
  model.loads.for_each_kind([&]<class L>(std::vector<L>& loads) {
    if constexpr (acts_in<L, D> && !is_inertia<L>) {
      std::vector<L> given;
      for (const L& load : loads) give(load, given);
      loads = std::move(given);
    }
  });
}

/// Joints with the faces of a body, and their ends on it, on its parts.
template <class Parts>
JointFlow given_joints(JointFlow flow, const Parts& parts) {
  for (FlowJoint& joint : flow.joints) {
    if (!joint.has_bodies()) continue;
    int body = -1;
    parts.give(joint.heel, body), parts.give(joint.toe, body);
    for (std::vector<FlowFace>* faces : {&joint.upper, &joint.lower}) {
      const std::vector<FlowFace> whole = std::move(*faces);
      faces->clear();
      for (const FlowFace& face : whole) {
        if (!parts.is_on(face.body)) {
          faces->push_back(face);
          continue;
        }
        parts.for_face(SplitFace{face.body, face.skin_a, face.skin_b}, [&](const SplitFace& part) {
          faces->push_back({part.body, part.skin_a, part.skin_b, face.depth});
        });
      }
    }
  }
  return flow;
}

/// Gives the faces of a body at which its fields exchange to its parts: see HeatFaces, and FlowJoint. `parts`: see
/// load/load_kind.hpp.
template <int D, class Parts>
void give_field_faces(Model<D>& model, const Parts& parts) {
  if (const auto heat = field_of(model.fields, FieldKind::heat); heat && heat->faces) {
    HeatFaces<D> faces = heat_faces<D>(*heat);
    for (ExchangeFaces<D>& row : faces.rows) {
      const std::vector<WetFace<D>> whole = std::move(row.faces);
      split_faces(parts, whole, row.faces, false);
    }
    Field given = *heat;
    given.faces = std::make_shared<const HeatFaces<D>>(std::move(faces));
    set_field(model.fields, std::move(given));
  }
  if constexpr (D == 2)
    if (const auto water = field_of(model.fields, FieldKind::seepage)) {
      Field given = *water;
      given.flow = std::make_shared<const JointFlow>(given_joints(*water->flow, parts));
      set_field(model.fields, std::move(given));
    }
}

/// The faces of the crack of a body that has split, from one end to the other: for each the face of the part behind,
/// then of the part ahead, counter-clockwise on its part.
std::vector<SplitFace> crack_faces(const Model<2>& model, const SplitBody& split, const CrackSection<2>& section);

}  // namespace trilith
