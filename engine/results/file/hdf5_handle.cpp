#include "results/file/hdf5_handle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace trilith::results::h5 {
namespace {

constexpr std::size_t most_attribute = 60000;  // bytes; HDF5 holds 64 KiB

// HDF5 contains the system's message in its description: "... error message = 'No space left on device', ...".
herr_t take_reason(unsigned, const H5E_error2_t* error, void* data) {
  auto& deepest = *static_cast<std::string*>(data);
  const std::string text = error->desc ? error->desc : "";
  static constexpr std::string_view mark = "error message = '";
  const std::size_t begin = text.find(mark);
  if (begin == std::string::npos) {
    if (deepest.empty()) deepest = text;
    return 0;
  }
  const std::size_t from = begin + mark.size();
  deepest = text.substr(from, text.find('\'', from) - from);
  return 1;
}

// Bytes of the UTF-8 character that starts at `at`, or 0 if it is invalid.
std::size_t character_length(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(at);
  if (lead == 0) return 0;
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xF0 && lead < 0xF5 ? 4 : lead >= 0xE0 ? 3 : lead >= 0xC2 ? 2 : 0;
  if (lead >= 0xF5 || length == 0 || at + length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(at + i) & 0xC0) != 0x80) return 0;
  const unsigned char second = byte(at + 1);
  const bool overlong = (lead == 0xE0 && second < 0xA0) || (lead == 0xF0 && second < 0x90);
  const bool surrogate = lead == 0xED && second >= 0xA0;
  const bool too_high = lead == 0xF4 && second >= 0x90;
  return overlong || surrogate || too_high ? 0 : length;
}

Handle new_attribute(hid_t object, const char* name, hid_t type, hid_t extent) {
  const hid_t id = H5Acreate2(object, name, type, extent, H5P_DEFAULT, H5P_DEFAULT);
  return Handle(id, H5Aclose, fmt::format("cannot create attribute '{}'", name));
}

std::string name_of_link(hid_t group, hsize_t index) {
  const ssize_t length =
      H5Lget_name_by_idx(group, ".", H5_INDEX_CRT_ORDER, H5_ITER_INC, index, nullptr, 0, H5P_DEFAULT);
  check(length, "cannot read a name");
  std::string name(static_cast<std::size_t>(length) + 1, '\0');
  check(H5Lget_name_by_idx(group, ".", H5_INDEX_CRT_ORDER, H5_ITER_INC, index, name.data(), name.size(), H5P_DEFAULT),
        "cannot read a name");
  name.pop_back();
  return name;
}

}  // namespace

std::string reason() {
  std::string deepest;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take_reason, &deepest);
  return deepest.empty() ? "unknown HDF5 error" : deepest;
}

void fail(std::string_view what) {
  throw Failure(fmt::format("{}: {}", what, reason()));
}

Handle text_type(std::size_t length) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "cannot make a text type");
  check(H5Tset_size(type.get(), length), "cannot set a text length");
  check(H5Tset_cset(type.get(), H5T_CSET_UTF8), "cannot set UTF-8");
  check(H5Tset_strpad(type.get(), H5T_STR_NULLPAD), "cannot set padding");
  return type;
}

Handle space(const std::vector<hsize_t>& extent) {
  if (extent.empty()) return Handle(H5Screate(H5S_SCALAR), H5Sclose, "cannot make a scalar space");
  return Handle(H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr), H5Sclose,
                "cannot make a data space");
}

std::string clean(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = character_length(text, at);
    if (length == 0)
      result += '?';
    else
      result += text.substr(at, length);
    at += std::max<std::size_t>(length, 1);
  }
  return result;
}

void write_attribute(hid_t object, const char* name, std::string_view text) {
  std::string cleaned = clean(text);
  if (cleaned.size() > most_attribute) cleaned.resize(most_attribute);
  cleaned = clean(cleaned);
  const Handle type = text_type(std::max<std::size_t>(1, cleaned.size()));
  const Handle attribute = new_attribute(object, name, type.get(), space({}).get());
  check(H5Awrite(attribute.get(), type.get(), cleaned.c_str()), fmt::format("cannot write attribute '{}'", name));
}

void write_attribute(hid_t object, const char* name, const std::vector<std::string>& texts) {
  std::size_t length = 1;
  const std::string packed = pack_texts(texts, length);
  const Handle type = text_type(length);
  const Handle attribute = new_attribute(object, name, type.get(), space({texts.size()}).get());
  check(H5Awrite(attribute.get(), type.get(), packed.data()), fmt::format("cannot write attribute '{}'", name));
}

std::string pack_texts(const std::vector<std::string>& texts, std::size_t& length) {
  length = 1;
  for (const std::string& text : texts) length = std::max(length, text.size());
  std::string packed;
  for (const std::string& text : texts) {
    std::string cleaned = clean(text);
    cleaned.resize(length, '\0');
    packed += cleaned;
  }
  return packed;
}

void write_attribute(hid_t object, const char* name, int value) {
  const Handle attribute = new_attribute(object, name, H5T_STD_I32LE, space({}).get());
  check(H5Awrite(attribute.get(), H5T_NATIVE_INT, &value), fmt::format("cannot write attribute '{}'", name));
}

bool has_attribute(hid_t object, const char* name) {
  return H5Aexists(object, name) > 0;
}

std::string read_text(hid_t object, const char* name) {
  const Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose, fmt::format("no attribute '{}'", name));
  const Handle stored(H5Aget_type(attribute.get()), H5Tclose, "unreadable attribute type");
  const Handle extent(H5Aget_space(attribute.get()), H5Sclose, "unreadable attribute space");
  const bool one_text = H5Tget_class(stored.get()) == H5T_STRING && H5Tis_variable_str(stored.get()) == 0 &&
                        H5Sget_simple_extent_npoints(extent.get()) == 1;
  const std::size_t length = one_text ? H5Tget_size(stored.get()) : 0;
  if (length == 0 || length > most_attribute) throw Failure(fmt::format("attribute '{}' is not text", name));
  std::string text(length, '\0');
  check(H5Aread(attribute.get(), stored.get(), text.data()), fmt::format("cannot read attribute '{}'", name));
  text.resize(std::min(text.find('\0'), length));
  return text;
}

namespace {

bool is_usual_number(hid_t type) {
  for (const hid_t usual :
       {H5T_STD_I8LE,  H5T_STD_I16LE,  H5T_STD_I32LE,  H5T_STD_I64LE, H5T_STD_U8LE,   H5T_STD_U16LE, H5T_STD_U32LE,
        H5T_STD_U64LE, H5T_IEEE_F32LE, H5T_IEEE_F64LE, H5T_STD_I8BE,  H5T_STD_I16BE,  H5T_STD_I32BE, H5T_STD_I64BE,
        H5T_STD_U8BE,  H5T_STD_U16BE,  H5T_STD_U32BE,  H5T_STD_U64BE, H5T_IEEE_F32BE, H5T_IEEE_F64BE})
    if (H5Tequal(type, usual) > 0) return true;
  return false;
}

}  // namespace

void require_plain(hid_t type, std::string_view owner) {
  const H5T_class_t kind = H5Tget_class(type);
  if (kind == H5T_STRING && H5Tis_variable_str(type) == 0) return;
  if (kind == H5T_COMPOUND) {
    const int members = H5Tget_nmembers(type);
    for (unsigned i = 0; i < static_cast<unsigned>(std::max(members, 0)); ++i) {
      const Handle member(H5Tget_member_type(type, i), H5Tclose, fmt::format("unreadable column of {}", owner));
      // HDF5 reads a column that begins or ends outside of its row without a check.
      if (H5Tget_member_offset(type, i) + H5Tget_size(member.get()) > H5Tget_size(type))
        throw Failure(fmt::format("{} is damaged: a column lies outside of its rows", owner));
      require_plain(member.get(), owner);
    }
    return;
  }
  if (kind == H5T_ARRAY) {
    const Handle one(H5Tget_super(type), H5Tclose, fmt::format("unreadable type of {}", owner));
    return require_plain(one.get(), owner);
  }
  if (!is_usual_number(type)) throw Failure(fmt::format("{} is damaged: its numbers have an unknown type", owner));
}

std::vector<std::string> read_texts(hid_t object, const char* name) {
  const Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose, fmt::format("no attribute '{}'", name));
  const Handle stored(H5Aget_type(attribute.get()), H5Tclose, "unreadable attribute type");
  const Handle extent(H5Aget_space(attribute.get()), H5Sclose, "unreadable attribute space");
  if (H5Tget_class(stored.get()) != H5T_STRING || H5Tis_variable_str(stored.get()) > 0)
    throw Failure(fmt::format("attribute '{}' holds no texts", name));
  const std::size_t length = H5Tget_size(stored.get());
  const auto count =
      static_cast<std::size_t>(check(H5Sget_simple_extent_npoints(extent.get()), "unreadable attribute"));
  std::string packed(count * length, '\0');
  check(H5Aread(attribute.get(), stored.get(), packed.data()), fmt::format("cannot read attribute '{}'", name));
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < count; ++i) texts.emplace_back(packed.substr(i * length, length).c_str());
  return texts;
}

int read_int(hid_t object, const char* name) {
  const Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose, fmt::format("no attribute '{}'", name));
  const Handle extent(H5Aget_space(attribute.get()), H5Sclose, "unreadable attribute space");
  if (H5Sget_simple_extent_npoints(extent.get()) != 1)
    throw Failure(fmt::format("attribute '{}' is not one number", name));
  const Handle stored(H5Aget_type(attribute.get()), H5Tclose, "unreadable attribute type");
  require_plain(stored.get(), fmt::format("attribute '{}'", name));
  int value = 0;
  check(H5Aread(attribute.get(), H5T_NATIVE_INT, &value), fmt::format("cannot read attribute '{}'", name));
  return value;
}

std::vector<std::string> member_names(hid_t group) {
  H5G_info_t info;
  check(H5Gget_info(group, &info), "cannot list a group");
  std::vector<std::string> names;
  for (hsize_t i = 0; i < info.nlinks; ++i) names.push_back(name_of_link(group, i));
  return names;
}

std::vector<hsize_t> extents(hid_t dataset) {
  const Handle extent(H5Dget_space(dataset), H5Sclose, "unreadable extents");
  const int rank = check(H5Sget_simple_extent_ndims(extent.get()), "unreadable extents");
  std::vector<hsize_t> result(static_cast<std::size_t>(rank));
  if (rank > 0) H5Sget_simple_extent_dims(extent.get(), result.data(), nullptr);
  return result;
}

}  // namespace trilith::results::h5
