// Private to results/: the bodies of a model as cells of VTK.
#pragma once

#include <string>
#include <vector>

#include "results/file/placement.hpp"
#include "results/vtk/vtk_file.hpp"

namespace trilith::results {

/// The constant part of the bodies while the same ones are present: made once, then used for each frame's file.
class VtkBodies {
 public:
  /// `left_out`: [body] true for an absent body.
  VtkBodies(const Header& header, const std::vector<bool>& left_out);
  /// Bytes of the .vtu file of a frame.
  [[nodiscard]] std::string file(const Frame& frame) const;

 private:
  /// A point of the file, attached to a node.
  struct Point {
    std::int32_t node;
    Vec3 local;  ///< in the axes of the node [m]
  };
  /// Arrays of cells: type, points of the outline, and in space the faces in VTK's format.
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
  [[nodiscard]] std::vector<double> per_point(const std::vector<double>& of_nodes, int width) const;
  [[nodiscard]] std::vector<double> per_cell(const std::vector<double>& of_bodies, int width) const;

  const Header* header_;
  std::vector<Point> points_;
  std::vector<Vec3> start_;     ///< of the points
  std::vector<double> radius_;  ///< of the points: of spheres, otherwise 0; empty without spheres [m]
  Cells cells_;
  std::vector<VtkArray> topology_;  ///< the section Cells
  std::vector<VtkArray> fixed_;     ///< data of cells that are constant
};

}  // namespace trilith::results
