// Solids in space have no bonds yet: they start as they are placed.
#include "step/start.hpp"

namespace trilith {

State<3> start_state(const Model<3>& model, double /*reach*/) {
  return initial_state(model);
}
void set_bonds(const Model<3>& /*model*/, State<3>& /*state*/, double /*reach*/) {}
void lift_bonds(const Model<3>& /*model*/, State<3>& /*state*/) {}

}  // namespace trilith
