#include "draw/results/trimmed_ground.hpp"

#include <algorithm>
#include <limits>

#include "draw/results/results_picture.hpp"

namespace trilith::draw {
namespace {

SpaceBox box_of_piece(const SolidPiece& piece) {
  const Vec3 most = Vec3::Constant(std::numeric_limits<double>::infinity());
  SpaceBox out{most, -most};
  for (const PieceFace& face : piece.faces)
    for (const Vec3& p : face.corners) out.low = out.low.cwiseMin(p), out.high = out.high.cwiseMax(p);
  return out;
}

/// True if the first box extends beyond all of the second along x and y.
bool spans(const SpaceBox& a, const SpaceBox& b) {
  return (a.low.head<2>().array() < b.low.head<2>().array()).all() &&
         (a.high.head<2>().array() > b.high.head<2>().array()).all();
}

bool lies_in(const SpaceBox& a, const SpaceBox& b) {
  return (a.low.array() >= b.low.array()).all() && (a.high.array() <= b.high.array()).all();
}

bool are_apart(const SpaceBox& a, const SpaceBox& b) {
  return (a.low.array() >= b.high.array()).any() || (a.high.array() <= b.low.array()).any();
}

/// Extends the box down to the highest ground below it, for bodies in the air.
SpaceBox down_to_ground(SpaceBox box, const std::vector<SpaceBox>& held) {
  double ground = -std::numeric_limits<double>::infinity();
  for (const SpaceBox& h : held) {
    const bool beneath = h.low.x() < box.high.x() && h.high.x() > box.low.x() && h.low.y() < box.high.y() &&
                         h.high.y() > box.low.y() && h.high.z() < box.low.z();
    if (beneath) ground = std::max(ground, h.high.z());
  }
  if (ground > -std::numeric_limits<double>::infinity()) box.low.z() = ground;
  return box;
}

std::optional<SolidPiece> part_within(std::optional<SolidPiece> piece, const SpaceBox& box, double slack) {
  for (int k = 0; k < 3; ++k)
    for (const double side : {1.0, -1.0})
      if (piece) {
        const CutPlane plane{side * Vec3(Vec3::Unit(k)), side > 0 ? box.high[k] : -box.low[k]};
        piece = divided(*piece, plane, slack, FaceKind::skin).first;
      }
  return piece;
}

}  // namespace

std::optional<SpaceBox> box_of_free(const results::Header& header, const results::Placement& at,
                                    const std::vector<bool>& left_out) {
  const std::vector<double> radius = header.vertex_radius();
  std::vector<double> along[3];
  for (std::size_t b = 0; b < header.bodies.size(); ++b) {
    const results::BodyRow& body = header.bodies[b];
    if (left_out[b] || role_of(body.support) != BodyRole::free) continue;
    for (int v = body.first_vertex; v < body.first_vertex + body.vertex_count; ++v)
      for (const double side : {-1.0, 1.0})
        for (int k = 0; k < 3; ++k)
          along[k].push_back(at.vertex(v)[k] + (radius.empty() ? 0 : side * radius[static_cast<std::size_t>(v)]));
  }
  if (along[0].empty()) return std::nullopt;
  SpaceBox all, bulk;
  for (int k = 0; k < 3; ++k) {
    std::sort(along[k].begin(), along[k].end());
    const auto last = static_cast<double>(along[k].size() - 1);
    all.low[k] = along[k].front(), all.high[k] = along[k].back();
    bulk.low[k] = along[k][static_cast<std::size_t>(0.04 * last)];
    bulk.high[k] = along[k][static_cast<std::size_t>(0.96 * last)];
  }
  const Vec3 around = Vec3::Constant(0.5 * (bulk.high - bulk.low).maxCoeff());
  return SpaceBox{all.low.cwiseMax(bulk.low - around), all.high.cwiseMin(bulk.high + around)};
}

std::optional<SpaceBox> joined(const std::optional<SpaceBox>& a, const std::optional<SpaceBox>& b) {
  if (!a || !b) return a ? a : b;
  return SpaceBox{a->low.cwiseMin(b->low), a->high.cwiseMax(b->high)};
}

std::vector<SolidPiece> trimmed_ground(std::vector<SolidPiece> pieces,
                                       const std::function<bool(const SolidPiece&)>& is_held, const SpaceBox& around) {
  std::vector<SpaceBox> held;
  for (const SolidPiece& piece : pieces)
    if (is_held(piece)) held.push_back(box_of_piece(piece));
  const SpaceBox box = down_to_ground(around, held);
  // The depth of ground is the least relevant.
  const double size = (box.high - box.low).norm();
  const Vec3 border(0.08 * size, 0.08 * size, 0.05 * size), far = Vec3::Constant(2 * size);
  const SpaceBox near{box.low - border, box.high + border}, farthest{box.low - far, box.high + far};
  std::vector<SolidPiece> kept;
  for (SolidPiece& piece : pieces) {
    if (!is_held(piece)) {
      kept.push_back(std::move(piece));
      continue;
    }
    const SpaceBox own = box_of_piece(piece);
    if (are_apart(own, near)) continue;
    const bool trims = spans(own, near) || !lies_in(own, farthest);
    std::optional<SolidPiece> left = std::move(piece);
    if (trims) left = part_within(std::move(left), near, 1e-9 * size);
    if (left) kept.push_back(std::move(*left));
  }
  return kept;
}

}  // namespace trilith::draw
