#include "results/vtk/vtk_file.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <stdexcept>

#include "base/markup.hpp"
#include "results/file/hdf5_handle.hpp"

namespace trilith::results {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written in the byte order of the memory");

constexpr int zlib_level = 3;

void put(std::uint64_t number, std::string& out) {
  char bytes[sizeof number];
  std::memcpy(bytes, &number, sizeof number);
  out.append(bytes, sizeof number);
}

/// One zlib block after VTK's four words: number of blocks, block length, length of a shorter last block, compressed
/// length. Empty data have no block.
std::string pack_bytes(const void* data, std::size_t bytes) {
  std::string out;
  if (bytes == 0) {
    for (int i = 0; i < 3; ++i) put(0, out);
    return out;
  }
  uLongf packed = compressBound(static_cast<uLong>(bytes));
  std::string block(packed, '\0');
  if (compress2(reinterpret_cast<Bytef*>(block.data()), &packed, static_cast<const Bytef*>(data),
                static_cast<uLong>(bytes), zlib_level) != Z_OK)
    throw std::runtime_error("zlib could not compress an array");
  put(1, out), put(bytes, out), put(0, out), put(packed, out);
  return out.append(block, 0, packed);
}

template <class T>
VtkArray packed_array(std::string name, const char* type, int components, const std::vector<T>& values) {
  return {std::move(name), type, components, values.size() / static_cast<std::size_t>(components),
          pack_bytes(values.data(), values.size() * sizeof(T))};
}

}  // namespace

VtkArray vtk_coordinates(const std::vector<double>& values) {
  return packed_array("Points", "Float64", 3, values);
}

VtkArray vtk_numbers(std::string name, int components, const std::vector<double>& values) {
  return packed_array(std::move(name), "Float32", components, std::vector<float>(values.begin(), values.end()));
}

VtkArray vtk_integers(std::string name, const std::vector<std::int32_t>& values) {
  return packed_array(std::move(name), "Int32", 1, values);
}

VtkArray vtk_bytes(std::string name, const std::vector<std::int8_t>& values) {
  return packed_array(std::move(name), "Int8", 1, values);
}

VtkArray vtk_texts(std::string name, const std::vector<std::string>& values) {
  std::string all;
  for (const std::string& value : values) all += h5::clean(value) + '\0';
  return {std::move(name), "String", 1, values.size(), pack_bytes(all.data(), all.size())};
}

std::string vtk_file(std::string_view kind, const std::vector<std::pair<std::string, std::size_t>>& counts,
                     const std::vector<VtkSection>& sections, double time) {
  std::string head = fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"{0}\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n<{0}>\n<FieldData>\n<DataArray type=\"Float64\" "
      "Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{1}</DataArray>\n</FieldData>\n<Piece",
      kind, time);
  for (const auto& [name, count] : counts) head += fmt::format(" {}=\"{}\"", name, count);
  head += ">\n";
  std::string data;
  for (const VtkSection& section : sections) {
    head += fmt::format("<{}>\n", section.name);
    for (const VtkArray* a : section.arrays) {
      head += fmt::format(
          "<{} type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" NumberOfTuples=\"{}\" format=\"appended\" "
          "offset=\"{}\"/>\n",
          a->type == "String" ? "Array" : "DataArray", a->type, xml_text(a->name), a->components, a->rows, data.size());
      data += a->packed;
    }
    head += fmt::format("</{}>\n", section.name);
  }
  return head + fmt::format("</Piece>\n</{}>\n<AppendedData encoding=\"raw\">\n_", kind) + data +
         "\n</AppendedData>\n</VTKFile>\n";
}

std::string vtk_series(const std::vector<std::pair<double, std::string>>& files) {
  std::string out =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      "<Collection>\n";
  for (const auto& [time, file] : files)
    out += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", time, xml_text(file));
  return out + "</Collection>\n</VTKFile>\n";
}

std::string xml_text(std::string_view text) {
  std::string out = markup_text(text);
  std::replace_if(
      out.begin(), out.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
  return out;
}

}  // namespace trilith::results
