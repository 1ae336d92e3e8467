#include "results/study/study_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <system_error>

#include "base/fresh_file.hpp"
#include "results/file/file_driver.hpp"
#include "results/file/growing_set.hpp"
#include "results/file/layout.hpp"
#include "results/file/open_written.hpp"
#include "results/reading/set_reading.hpp"

namespace trilith::results {
namespace {

constexpr const char* format_name = "trilith study";

std::size_t rows_of(const StudyColumn& column) {
  return std::visit([](const auto& values) { return values.size(); }, column.values);
}

std::size_t text_length(const std::vector<std::string>& texts) {
  std::size_t length = 1;
  for (const std::string& t : texts) length = std::max(length, t.size());
  return length;
}

TableType type_of(const std::vector<StudyColumn>& columns) {
  TableType type;
  for (const StudyColumn& c : columns) {
    const Kind kind = c.values.index() == 0 ? Kind::real : c.values.index() == 1 ? Kind::int32 : Kind::text;
    const std::size_t length =
        kind == Kind::text ? text_length(std::get<std::vector<std::string>>(c.values)) : stored_size(kind);
    type.columns.push_back({c.name, c.unit, c.description, kind, length});
  }
  type.place();
  return type;
}

std::vector<std::byte> records_of(const std::vector<StudyColumn>& columns, const TableType& type, std::size_t rows) {
  std::vector<std::byte> bytes(type.size * rows);
  for (std::size_t i = 0; i < rows; ++i) {
    Packer packer(type, 2, bytes.data() + i * type.size);
    for (const StudyColumn& c : columns) {
      if (const auto* reals = std::get_if<std::vector<double>>(&c.values)) packer.number("", (*reals)[i], "", "");
      if (const auto* whole = std::get_if<std::vector<std::int32_t>>(&c.values)) packer.number("", (*whole)[i], "", "");
      if (const auto* texts = std::get_if<std::vector<std::string>>(&c.values)) packer.text("", (*texts)[i], 1, "");
    }
  }
  return bytes;
}

void write_study_provenance(hid_t file, const Provenance& provenance) {
  make_group(file, "/provenance", "origin of the study");
  const h5::Handle group(H5Oopen(file, "/provenance", H5P_DEFAULT), H5Oclose, "cannot open /provenance");
  for (const ProvenanceText& t : provenance_texts) h5::write_attribute(group.get(), t.name, provenance.*(t.member));
  write_text(file, {"/provenance/script", "", "full text of the script of the cases"}, provenance.script);
}

/// Number of rows of the table `dataset`. A damaged size must not allocate excessive memory: the limit is the largest
/// compression ratio of deflate.
std::size_t require_rows(hid_t dataset, hid_t type) {
  constexpr double most_compressed = 1100;
  const std::vector<hsize_t> extent = h5::extents(dataset);
  if (extent.size() != 1 || H5Tget_class(type) != H5T_COMPOUND) throw h5::Failure("/cases is not a table");
  h5::require_plain(type, "/cases");
  const double bytes = static_cast<double>(extent[0]) * static_cast<double>(H5Tget_size(type));
  if (bytes > most_compressed * static_cast<double>(H5Dget_storage_size(dataset)))
    throw h5::Failure("/cases is damaged: it announces more rows than it holds");
  return static_cast<std::size_t>(extent[0]);
}

/// Column `name` of all rows as numbers.
std::vector<double> read_numbers(hid_t dataset, const char* name, std::size_t rows) {
  const h5::Handle one(H5Tcreate(H5T_COMPOUND, sizeof(double)), H5Tclose, "cannot make a type");
  h5::check(H5Tinsert(one.get(), name, 0, H5T_NATIVE_DOUBLE), "cannot make a type");
  std::vector<double> values(rows);
  h5::check(H5Dread(dataset, one.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "cannot read /cases");
  return values;
}

/// Column `name` of all rows as texts; `member` is its stored type.
std::vector<std::string> read_member_texts(hid_t dataset, const char* name, hid_t member, std::size_t rows) {
  if (H5Tis_variable_str(member) != 0) throw h5::Failure("/cases has texts of no length of their own");
  const std::size_t length = H5Tget_size(member);
  const h5::Handle one(H5Tcreate(H5T_COMPOUND, length), H5Tclose, "cannot make a type");
  h5::check(H5Tinsert(one.get(), name, 0, member), "cannot make a type");
  std::string packed(rows * length, '\0');
  h5::check(H5Dread(dataset, one.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, packed.data()), "cannot read /cases");
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < rows; ++i) {
    const auto begin = packed.begin() + static_cast<std::ptrdiff_t>(i * length);
    texts.emplace_back(begin, std::find(begin, begin + static_cast<std::ptrdiff_t>(length), '\0'));
  }
  return texts;
}

std::string member_name(hid_t type, unsigned member) {
  char* const text = H5Tget_member_name(type, member);
  if (text == nullptr) h5::fail("unreadable column of /cases");
  std::string name = text;
  H5free_memory(text);
  return name;
}

}  // namespace

bool is_study_table(const std::filesystem::path& path) {
  const h5::Quiet quiet;
  try {
    const h5::Handle file = open_written(path);
    return h5::has_attribute(file.get(), "format") && h5::read_text(file.get(), "format") == format_name;
  } catch (const h5::Failure&) {
    return false;
  }
}

std::vector<StudyColumn> read_study_table(const std::filesystem::path& path) {
  const h5::Quiet quiet;
  try {
    const h5::Handle file = open_written(path);
    const h5::Handle dataset(H5Dopen2(file.get(), "/cases", H5P_DEFAULT), H5Dclose, "there is no table /cases");
    const h5::Handle type(H5Dget_type(dataset.get()), H5Tclose, "/cases has no readable type");
    const std::vector<std::string> units = h5::read_texts(dataset.get(), "units"),
                                   descriptions = h5::read_texts(dataset.get(), "columns");
    const std::size_t rows = require_rows(dataset.get(), type.get());
    std::vector<StudyColumn> columns;
    const int members = h5::check(H5Tget_nmembers(type.get()), "/cases is not a table");
    if (static_cast<int>(std::min(units.size(), descriptions.size())) < members)
      throw h5::Failure("/cases has columns without a unit or a description");
    for (unsigned i = 0; i < static_cast<unsigned>(members); ++i) {
      const std::string name = member_name(type.get(), i);
      const h5::Handle member(H5Tget_member_type(type.get(), i), H5Tclose, "unreadable column of /cases");
      columns.push_back({name, units[i], descriptions[i], {}});
      if (H5Tget_class(member.get()) == H5T_STRING)
        columns.back().values = read_member_texts(dataset.get(), name.c_str(), member.get(), rows);
      else
        columns.back().values = read_numbers(dataset.get(), name.c_str(), rows);
    }
    return columns;
  } catch (const std::exception& e) {
    throw ResultsError(fmt::format("{}: {}", path.string(), e.what()));
  }
}

void require_study_path(const std::filesystem::path& path) {
  std::error_code ignored;
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  if (!std::filesystem::is_directory(folder, ignored))
    throw ResultsError(fmt::format("{}: there is no folder {}", path.string(), folder.string()));
  if (std::filesystem::exists(path, ignored) && !is_study_table(path))
    throw ResultsError(
        fmt::format("{} exists already and is not the table of a study; give another name", path.string()));
}

void write_study_table(const std::filesystem::path& path, const std::vector<StudyColumn>& columns,
                       const Provenance& provenance, bool complete) {
  assert(!columns.empty());
  const h5::Quiet quiet;
  try {
    FreshFile fresh(path);
    const h5::Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "cannot make a property list");
    h5::FileStatus status;
    h5::use_driver(access.get(), fresh.descriptor(), status);
    h5::Handle file(H5Fcreate(fresh.path().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.get()), H5Fclose,
                    "cannot create it");
    h5::write_attribute(file.get(), "format", format_name);
    h5::write_attribute(file.get(), "format_version", 1);
    h5::write_attribute(file.get(), "finished", complete ? 1 : 0);
    const TableType type = type_of(columns);
    const std::size_t rows = rows_of(columns[0]);
    const std::vector<std::byte> records = records_of(columns, type, rows);
    write_table(file.get(), {"/cases", "", "one row for each case of the study"}, type, rows, records.data());
    write_study_provenance(file.get(), provenance);
    file.close("cannot close it");
    h5::require_written(status, "cannot be written");
    fresh.take_place();
  } catch (const std::system_error& e) {
    throw ResultsError(fmt::format("{}: cannot be written: {}", path.string(), e.code().message()));
  } catch (const std::exception& e) {
    throw ResultsError(fmt::format("{}: {}", path.string(), e.what()));
  }
}

}  // namespace trilith::results
