// Common contact direction of several pieces of one body at one place.
//
// Input: rows of contacts of any shape; the edges that pieces of a body share (model/builder/shared_edges.hpp). Output:
// for each row in which such an edge lies in the other piece, its spring force s and the direction n of the sum at
// these edges:
//
//     n = sum of s_i / |sum of s_i|,     i: the row, and all rows of pieces that share such an edge with one of its
//     two.
//
// Damping and friction of these rows act relative to n. So the shared edge of a chevron slides like the edge of a
// convex stone. A piece enters with zero force when the edge does, so n changes continuously.
#pragma once

#include <array>
#include <cstddef>

#include "model/work.hpp"

namespace trilith {

/// Fills work.met from work.awake_rows.
void join_shared_edges(const Model<2>& model, const State<2>& state, Work<2>& work, double dt);
/// Fills work.met from all rows of work.pairs.
void join_shared_edges(const Model<3>& model, const State<3>& state, Work<3>& work, double dt);

/// Largest number of rows summed for one row. If more meet, as with very many tetrahedra, the first ones count.
inline constexpr std::size_t most_at_shared_edges = 64;

/// The rows that determine n for one of them, which is the first.
template <int D>
struct SharedEdgeRows {
  std::array<const MetRow<D>*, most_at_shared_edges> row;
  std::size_t count = 0;
  Vec<D> push = Vec<D>::Zero();  ///< sum of their spring forces [N]

  /// True if another row presses there in addition to the first.
  [[nodiscard]] bool has_others() const { return count > 1 && push != row[0]->push && push.norm() > 0; }
};

/// Empty if no shared edge of the row lies in the other piece.
template <int D>
SharedEdgeRows<D> rows_at_shared_edges(const Work<D>& work, int row);
extern template SharedEdgeRows<2> rows_at_shared_edges(const Work<2>& work, int row);
extern template SharedEdgeRows<3> rows_at_shared_edges(const Work<3>& work, int row);

/// Spring force of a contact in the plane on b [N]; `law_after`: buffer of its law memory.
Vec2 spring_force(const PlacedPiece& a, const PlacedPiece& b, const Remembered& before, const LawInUse& law,
                  double* law_after);
/// Spring force of a row in space.
Vec3 spring_force(const Model<3>& model, const State<3>& state, Work<3>& work, int row, double dt, SolidRoom& room);

/// Sets `along` to n; false if no other row presses at the shared edges of the row.
template <int D>
bool direction_at_shared_edges(const Work<D>& work, int row, Vec<D>& along);
extern template bool direction_at_shared_edges(const Work<2>& work, int row, Vec2& along);
extern template bool direction_at_shared_edges(const Work<3>& work, int row, Vec3& along);

}  // namespace trilith
