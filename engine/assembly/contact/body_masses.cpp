#include "assembly/contact/body_masses.hpp"

#include <algorithm>
#include <cstddef>

namespace trilith {

template <int D>
void list_masses(const Model<D>& model, Work<D>& work) {
  ImpactWork& own = work.impacts;
  own.mass.assign(model.bodies.size(), 0);
  own.total = 0, own.lightest = unbounded, own.still = -1;
  for (std::size_t b = 0; b < own.mass.size(); ++b) {
    const Body& body = model.bodies[b];
    if (!model.body_moves(static_cast<int>(b))) {
      if (own.still < 0) own.still = body.first_node;
      continue;
    }
    for (int n = body.first_node; n < body.first_node + body.nodes; ++n) {
      own.mass[b] += model.mass[n];
      own.lightest = std::min(own.lightest, model.mass[n]);
    }
    own.total += own.mass[b];
  }
}

template void list_masses(const Model<2>&, Work<2>&);
template void list_masses(const Model<3>&, Work<3>&);

}  // namespace trilith
