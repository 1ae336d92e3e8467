// Private to results/: the bodies of a model as cells of VTK.
#pragma once

#include <string>
#include <vector>

#include "results/file/placement.hpp"
#include "results/vtk/vtk_file.hpp"

namespace trilith::results {

/// What of the bodies does not change while the same ones are there: made once, then asked for each frame's file.
class VtkBodies {
 public:
  /// `left_out`: [body] true where the body is not there.
  VtkBodies(const Header& header, const std::vector<bool>& left_out);
  /// Bytes of the .vtu of a frame.
  [[nodiscard]] std::string file(const Frame& frame) const;

 private:
  /// A point of the file goes with a node.
  struct Point {
    std::int32_t node;
    Vec3 local;  ///< in the axes of the node, m
  };
  /// A cell under way: what it is, the points of its outline, and in space its faces as VTK counts them.
  struct Cells {
    std::vector<std::int32_t> corners, ends, faces, face_ends, body, element;
    std::vector<std::int8_t> kinds;
    void close(std::int8_t kind, std::int32_t of_body, std::int32_t of_element);
  };
  void add_solid(const BodyRow& body, std::int32_t index);
  void add_spheres(const BodyRow& body, std::int32_t index);
  void add_outline(const BodyRow& body, std::int32_t index);
  void add_elements(std::int32_t index);
  void add_names();
  [[nodiscard]] std::vector<double> per_cell(const std::vector<double>& of_bodies, int width) const;

  const Header* header_;
  std::vector<Point> points_;
  std::vector<Vec3> start_;     ///< of the points
  std::vector<double> radius_;  ///< of the points: of spheres, else 0; empty without spheres [m]
  Cells cells_;
  std::vector<VtkArray> topology_;  ///< the section Cells
  std::vector<VtkArray> fixed_;     ///< data of cells that no frame changes
};

}  // namespace trilith::results
