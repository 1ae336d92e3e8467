#include "run/record/space_stress_field.hpp"

#include "assembly/element/element_stress.hpp"

namespace trilith {

void describe_space_stress(results::Header& header) {
  header.fields.push_back({"body_stress_tensor", "Pa",
                           "mean stress of each body that deforms: xx, yy, zz, xy, yz, zx; tension positive",
                           header.bodies.size(), 6});
  header.fields.push_back(
      {"body_plastic_strain", "1", "mean plastic measure of each body that deforms", header.bodies.size(), 1});
}

/// Volume-weighted means over the elements.
void take_space_stress(const Instant<3>& now, std::vector<std::vector<double>>& fields) {
  const std::size_t bodies = now.model.bodies.size();
  fields.assign(2, {});
  fields[0].assign(6 * bodies, 0), fields[1].assign(bodies, 0);
  std::vector<double> volume(bodies, 0);
  for (std::size_t e = 0; e < now.model.space_elements.size(); ++e) {
    const SpaceElementStress stress = element_stress(now.model, now.state, static_cast<int>(e));
    const SpaceVector mean = in_world(stress);
    const auto b = static_cast<std::size_t>(now.model.space_elements[e].body);
    volume[b] += stress.volume, fields[1][b] += stress.volume * stress.plastic;
    for (std::size_t k = 0; k < 6; ++k) fields[0][6 * b + k] += stress.volume * mean[static_cast<Eigen::Index>(k)];
  }
  for (std::size_t b = 0; b < bodies; ++b) {
    if (!(volume[b] > 0)) continue;
    fields[1][b] /= volume[b];
    for (std::size_t k = 0; k < 6; ++k) fields[0][6 * b + k] /= volume[b];
  }
}

}  // namespace trilith
