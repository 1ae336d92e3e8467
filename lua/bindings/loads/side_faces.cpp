#include "bindings/loads/side_faces.hpp"

#include <fmt/ranges.h>

#include <algorithm>

#include "base/nearest.hpp"
#include "model/water/water.hpp"

namespace trilith::script {

template <int D>
SideFaces read_sides(Keys& keys, const std::string& needed) {
  SideFaces faces;
  std::vector<std::string> names{"all"};
  for (const FaceSide& s : face_sides)
    if (D == 3 || s.plane != std::array<double, 2>{}) names.emplace_back(s.name);
  faces.side = keys.text("side", "");
  if (D == 2) {
    faces.from = keys.maybe_point("from"), faces.to = keys.maybe_point("to");
    if (faces.from.has_value() != faces.to.has_value())
      keys.problem("give both 'from' and 'to', points of the outline");
  }
  if (faces.side.empty() == !faces.from.has_value())
    keys.problem(fmt::format("{}: give side = \"left\" ({}){}", needed, fmt::join(names, ", "),
                             D == 2 ? ", or 'from' and 'to' counter-clockwise" : ""));
  if (!faces.side.empty() && std::find(names.begin(), names.end(), faces.side) == names.end())
    keys.problem(fmt::format("'side' is '{}', must be one of {}{}", faces.side, fmt::join(names, ", "),
                             name_hint(faces.side, names)));
  return faces;
}

std::vector<WetFace<2>> faces_of(const Model<2>& model, int body, const SideFaces& choice, const std::string& owner) {
  if (choice.from) return wet_faces(model, body, faces_between(model, body, *choice.from, *choice.to, owner));
  if (choice.side == "all") return wet_faces(model, body, outline_faces(model, body));
  for (const FaceSide& s : face_sides)
    if (s.name == choice.side) return wet_faces(model, body, faces_on_side(model, body, Vec2(s.plane[0], s.plane[1])));
  return {};
}
std::vector<WetFace<3>> faces_of(const Model<3>& model, int body, const SideFaces& choice,
                                 const std::string& /*owner*/) {
  if (choice.side == "all") return wet_faces(model, body, surface_faces(model, body));
  for (const FaceSide& s : face_sides)
    if (s.name == choice.side)
      return wet_faces(model, body, faces_on_side(model, body, Vec3(s.space[0], s.space[1], s.space[2])));
  return {};
}

template SideFaces read_sides<2>(Keys&, const std::string&);
template SideFaces read_sides<3>(Keys&, const std::string&);

}  // namespace trilith::script
