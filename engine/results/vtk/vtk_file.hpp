// VTK files in XML for ParaView: named arrays, compressed, after a head with their offsets.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace trilith::results {

/// One array of a file, packed: made once if it does not change from frame to frame.
struct VtkArray {
  std::string name;
  std::string type;    ///< of VTK: "Float64", "Int32", "String", ...
  int components = 1;  ///< numbers per row
  std::size_t rows = 0;
  std::string packed = {};  ///< bytes in the file
};

/// `components` numbers per row. Coordinates keep all digits; other numbers have 7 digits, sufficient for display.
VtkArray vtk_coordinates(const std::vector<double>& values);
VtkArray vtk_numbers(std::string name, int components, const std::vector<double>& values);
VtkArray vtk_integers(std::string name, const std::vector<std::int32_t>& values);
VtkArray vtk_bytes(std::string name, const std::vector<std::int8_t>& values);
VtkArray vtk_texts(std::string name, const std::vector<std::string>& values);

/// A part of a piece: "Points", "Cells", "PointData", ...
struct VtkSection {
  std::string name;
  std::vector<const VtkArray*> arrays;
};

/// Bytes of a file with one piece. `kind`: "UnstructuredGrid" or "PolyData"; `counts`: the numbers that a piece
/// declares, as {"NumberOfPoints", 8}; `time` [s].
std::string vtk_file(std::string_view kind, const std::vector<std::pair<std::string, std::size_t>>& counts,
                     const std::vector<VtkSection>& sections, double time);

/// Bytes of a .pvd file: the file of each time [s]. Paths are relative to it.
std::string vtk_series(const std::vector<std::pair<double, std::string>>& files);

/// Text escaped for an attribute or element of XML.
std::string xml_text(std::string_view text);

}  // namespace trilith::results
