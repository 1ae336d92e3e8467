// Bearings, seats, loads, controls and supports of a mesh that splits move to its parts.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "base/rotation_3d.hpp"
#include "edit/split_mesh.hpp"
#include "edit/split_parts.hpp"
#include "model/crack_cut.hpp"

namespace trilith {
namespace {

/// Attached points, loads and displacement controls of a mesh for its parts; see load/load_kind.hpp.
template <int D>
class MeshLinks {
 public:
  MeshLinks(const Model<D>& model, const SplitBody& split, const MeshParts<D>& parts, const MeshCut& cut)
      : model_(model), split_(split), parts_(parts), cut_(cut) {}

  [[nodiscard]] bool is_on(int body) const { return body == split_.body; }
  [[nodiscard]] bool is_on(const Attachment<D>& at) const {
    if (at.nodes == 0) return false;
    return on_frame(at) ? parts_.frame(at.node[0]).side >= 0 : parts_.has_node(at.node[0]);
  }
  [[nodiscard]] bool is_behind(int body) const { return body == split_.behind; }
  /// Attaches a point to the part that has its element, if it is on the body.
  void give(Attachment<D>& at, int& body) const {
    if (!is_on(at)) return;
    if (!on_frame(at)) return give(at, body, side_of(at));
    const auto own = parts_.frame(at.node[0]);
    body = parts_.body(own.side);
    at.node[0] = at.turn[0] = own.frame;
  }
  void give(std::vector<PushRow<D>>& rows) const {
    std::vector<PushRow<D>> given;
    for (const PushRow<D>& row : rows) {
      if (!parts_.has_node(row.node)) {
        given.push_back(row);
        continue;
      }
      const double all = mass(parts_.copy(0, row.node)) + mass(parts_.copy(1, row.node));
      for (const int side : {0, 1}) {
        if (parts_.copy(side, row.node) < 0) continue;
        PushRow<D> part = row;
        part.node = part.turn = parts_.copy(side, row.node);
        if (parts_.on_both(row.node)) part.weight *= mass(part.node) / all;
        given.push_back(part);
      }
    }
    rows = std::move(given);
  }

  // At nodes, as all points in the plane and the shares of a force in space. To the side whose part has all nodes of
  // the point, and behind if both have.

  /// Both copies carry a point between nodes of the cut.
  [[nodiscard]] bool is_on_cut(const Attachment<D>& at) const {
    if (on_frame(at)) return false;
    for (int i = 0; i < at.nodes; ++i)
      if (has_weight(at, i) && !parts_.on_both(at.node[static_cast<std::size_t>(i)])) return false;
    return true;
  }
  /// Share of the mass that a side has at a point on the cut.
  [[nodiscard]] double share(int side, const Attachment<D>& at) const {
    double own = 0, all = 0;
    for (int i = 0; i < at.nodes; ++i) {
      if (!has_weight(at, i)) continue;
      const int node = at.node[static_cast<std::size_t>(i)];
      own += mass(parts_.copy(side, node)), all += mass(parts_.copy(0, node)) + mass(parts_.copy(1, node));
    }
    return own / all;
  }
  void give(Attachment<D>& at, int& body, int side) const {
    if (!is_on(at)) return;
    body = parts_.body(side);
    int known = 0;  // nodes without weight may be missing on this side
    for (int i = 0; i < at.nodes; ++i)
      if (has_weight(at, i)) known = parts_.copy(side, at.node[static_cast<std::size_t>(i)]);
    for (std::size_t i = 0; i < static_cast<std::size_t>(at.nodes); ++i)
      for (int* node : {&at.node[i], &at.turn[i]}) {
        if (!parts_.has_node(*node)) continue;  // nothing turns the arm of a point between nodes
        const int copy = parts_.copy(side, *node);
        *node = copy >= 0 ? copy : known;
      }
  }

  template <class See>
  void for_face(const SplitFace& face, See&& see) const requires(D == 2) {
    const PartPiece at = parts_.face(face.skin_a, face.skin_b);
    if (at.side >= 0)
      see(SplitFace{parts_.body(at.side), parts_.skin_copy(at.side, face.skin_a),
                    parts_.skin_copy(at.side, face.skin_b)});
  }
  template <class See>
  void for_face(const WetFace<3>& face, See&& see) const requires(D == 3) {
    const PartPiece own = parts_.piece(face.piece);
    if (own.side < 0) return;
    WetFace<3> given = face;
    given.piece = own.piece;
    give(given.at, given.body);
    see(given);
  }
  template <class See>
  void for_new_faces(See&& see) const {
    if constexpr (D == 2) {
      const int first = model_.bodies[static_cast<std::size_t>(split_.body)].first_skin;
      for (const auto& face : cut_.faces)
        for (const int side : {0, 1}) {
          const int from = parts_.skin_copy(side, first + face[0]), to = parts_.skin_copy(side, first + face[1]);
          see(side == 0 ? SplitFace{split_.behind, from, to} : SplitFace{split_.ahead, to, from});
        }
    } else {
      for (const CutFace& face : space_cut(cut_).plates)
        for (const std::size_t side : {0, 1}) see(new_face(face, side));
    }
  }

  /// In the plane a wet end of the face is a node of the cut.
  [[nodiscard]] bool is_at_crack(const WetFace<2>& face) const requires(D == 2) {
    const auto is_on_both = [&](int skin) { return parts_.skin_copy(0, skin) >= 0 && parts_.skin_copy(1, skin) >= 0; };
    return is_on(face.body) &&
           ((face.from <= 0 && is_on_both(face.skin_a)) || (face.to >= 1 && is_on_both(face.skin_b)));
  }
  /// In space two wet corners of the face are nodes of the cut. Corners lie on the plane that is fitted to a warped
  /// face.
  [[nodiscard]] bool is_at_crack(const WetFace<3>& face) const requires(D == 3) {
    if (!is_on(face.body) || !on_frame(face.at)) return false;
    constexpr double same_place = 1e-3;  // share of the size of the face
    const BodyMotion start = start_of(model_, face.at.node[0]);
    const Turn3 turn(start.rotation);
    double size = 0;
    for (const Vec3& x : face.corners) size = std::max(size, (x - face.corners.front()).norm());
    const auto touches = [&](const Vec3& corner) {
      const Vec3 x = start.place + turn.apply(corner);
      return std::any_of(cut_.nodes.begin(), cut_.nodes.end(), [&](int n) {
        return (model_.start_position[static_cast<std::size_t>(first_node() + n)] - x).norm() < same_place * size;
      });
    };
    return std::count_if(face.corners.begin(), face.corners.end(), touches) >= 2;
  }

  // Only rigid bodies have loads over whole faces and axes of their own.

  [[nodiscard]] Turn3 axes_of(int /*part*/) const requires(D == 3) { return Turn3(UnitQuaternion{}); }
  [[nodiscard]] std::vector<Vec3> corners_of(int /*face*/) const requires(D == 3) { return {}; }
  [[nodiscard]] int face_with(int /*part*/, int face, const std::vector<Vec3>& /*corners*/) const requires(D == 3) {
    return face;
  }
  template <class See>
  void for_polygon(const std::vector<Vec3>& /*corners*/, See&& /*see*/) const requires(D == 3) {}

 private:
  [[nodiscard]] int first_node() const { return model_.bodies[static_cast<std::size_t>(split_.body)].first_node; }
  /// In space: attached to a contact frame, see model/contact/contact_frame.hpp.
  [[nodiscard]] static bool on_frame(const Attachment<D>& at) { return D == 3 && at.node[0] < 0; }
  [[nodiscard]] static bool has_weight(const Attachment<D>& at, int i) {
    return std::abs(at.weight[static_cast<std::size_t>(i)]) > 1e-9;
  }
  [[nodiscard]] double mass(int node) const { return node < 0 ? 0 : model_.mass[static_cast<std::size_t>(node)]; }
  [[nodiscard]] bool holds(int side, const Attachment<D>& at, bool weighted) const {
    for (int i = 0; i < at.nodes; ++i)
      if ((!weighted || has_weight(at, i)) && parts_.copy(side, at.node[static_cast<std::size_t>(i)]) < 0) return false;
    return true;
  }
  [[nodiscard]] int side_of(const Attachment<D>& at) const {
    for (const bool weighted : {false, true})
      for (const int side : {0, 1})
        if (holds(side, at, weighted)) return side;
    return 0;
  }
  /// A face of the crack in the axes of its contact frame.
  [[nodiscard]] WetFace<3> new_face(const CutFace& face, std::size_t side) const requires(D == 3) {
    WetFace<3> given;
    given.body = parts_.body(static_cast<int>(side));
    given.piece = parts_.piece_of_element(face.element[side]), given.face = face.face[side];
    const int frame = model_.carrier_of(given.piece, given.face);
    given.at = Attachment<3>::to_node(frame, Vec3::Zero());
    const BodyMotion start = start_of(model_, frame);
    const Turn3 turn(start.rotation);
    for (const Vec2& p : face.section.corners)
      given.corners.push_back(turn.undo(Vec3(face.section.at(p) - start.place)));
    if (side == 1) std::reverse(given.corners.begin(), given.corners.end());
    given.normal = turn.undo(Vec3(side == 0 ? face.section.normal : Vec3(-face.section.normal)));
    return given;
  }

  const Model<D>& model_;
  SplitBody split_;
  const MeshParts<D>& parts_;
  const MeshCut& cut_;
};

/// A load at a point of the cut becomes two, which share it like the mass.
template <int D, class L>
void give_load(const L& load, const MeshLinks<D>& parts, std::vector<L>& given) {
  if constexpr (requires(L l) {
                  l.at;
                  l.body;
                })
    if (parts.is_on(load.body) && parts.is_on_cut(load.at)) {
      for (const int side : {0, 1}) {
        L part = load;
        part.scale(parts.share(side, load.at));
        parts.give(part.at, part.body, side);
        given.push_back(std::move(part));
      }
      return;
    }
  hand_over(load, parts, given);
}

/// Supports, motions and steady forces of the nodes.
template <int D>
void copy_conditions(Model<D>& model, const MeshParts<D>& parts, int body) {
  const Body b = model.bodies[static_cast<std::size_t>(body)];
  for (int n = b.first_node; n < b.first_node + b.nodes; ++n)
    for (const int side : {0, 1}) {
      const int copy = parts.copy(side, n);
      if (copy < 0) continue;
      const auto p = static_cast<std::size_t>(copy), from = static_cast<std::size_t>(n);
      model.support[p] = model.support[from];
      model.load[p] = model.mass[p] / model.mass[from] * model.load[from];
      for (std::size_t k = 0; k < model.drive_of[from].size(); ++k) {
        if (model.drive_of[from][k] < 0) continue;
        Drive drive = model.drives[static_cast<std::size_t>(model.drive_of[from][k])];
        drive.node = copy;
        model.drive_of[p][k] = static_cast<int>(model.drives.size());
        model.drives.push_back(std::move(drive));
      }
    }
}

template <int D>
void give_ends(Model<D>& model, const MeshParts<D>& rows, const MeshLinks<D>& parts) {
  const auto give_end = [&](Attachment<D>& at, int& body, int& piece) {
    if (!parts.is_on(at)) return;
    parts.give(at, body);
    const PartPiece own = piece >= 0 ? rows.piece(piece) : PartPiece{};
    piece = own.piece >= 0 ? own.piece : model.bodies[static_cast<std::size_t>(body)].first_piece;
  };
  for (Bearing<D>& b : model.bearings) {
    give_end(b.end_a, b.body_a, b.piece_a);
    give_end(b.end_b, b.body_b, b.piece_b);
  }
  for (Seat<D>& s : model.seats) {
    if (parts.is_on(s.end)) parts.give(s.end, s.body);
    if (parts.is_on(s.edge)) parts.give(s.edge, s.support);
  }
  for (Push<D>& push : model.pushes) parts.give(push.rows);
}

template <int D>
void give_loads_of_mesh(Model<D>& model, const MeshLinks<D>& parts) {
  replace_loads(model, [&](const auto& load, auto& given) { give_load(load, parts, given); });
}

}  // namespace

template <int D>
void hand_over_mesh_links(Model<D>& model, const SplitBody& split, const MeshCut& cut) {
  const MeshParts<D> rows(model, split, cut);
  const MeshLinks<D> parts(model, split, rows, cut);
  give_ends(model, rows, parts);
  give_loads_of_mesh(model, parts);
  give_field_faces(model, parts);
  copy_conditions(model, rows, split.body);
}
std::vector<SplitFace> mesh_crack_faces(const Model<2>& model, const SplitBody& split, const MeshCut& cut) {
  const MeshParts<2> rows(model, split, cut);
  std::vector<SplitFace> out;
  MeshLinks<2>(model, split, rows, cut).for_new_faces([&](const SplitFace& face) { out.push_back(face); });
  return out;
}

template void hand_over_mesh_links(Model<2>&, const SplitBody&, const MeshCut&);
template void hand_over_mesh_links(Model<3>&, const SplitBody&, const MeshCut&);

}  // namespace trilith
