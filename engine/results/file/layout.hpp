// Private to results/: the objects of a results file, created once before the first row.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "results/file/growing_set.hpp"
#include "results/file/results.hpp"
#include "results/reading/table_rows.hpp"

namespace trilith::results {

/// The attributes of /provenance.
struct ProvenanceText {
  const char* name;
  std::string Provenance::*member;
};
inline constexpr ProvenanceText provenance_texts[] = {{"script_path", &Provenance::script_path},
                                                      {"program_version", &Provenance::program_version},
                                                      {"git_commit", &Provenance::git_commit},
                                                      {"compiler", &Provenance::compiler},
                                                      {"platform", &Provenance::platform},
                                                      {"start_time", &Provenance::start_time},
                                                      {"command_line", &Provenance::command_line},
                                                      {"model", &Provenance::model},
                                                      {"units", &Provenance::units}};
/// Files of earlier program versions do not have these.
inline constexpr std::array<std::string_view, 2> later_provenance_texts{"model", "units"};

/// Throws ResultsError if arrays of the header have inconsistent sizes or contain a number that is not finite,
/// InputError if a history or energy term has an invalid name.
void check_header(const Header& header);

/// Writes root attributes (finished = 0), /provenance and /model.
void write_header(hid_t file, const Header& header);

/// A table that grows, with its record type.
struct GrowingTable {
  GrowingTable(hid_t file, const SetText& text, const char* counter, TableType record)
      : type(std::move(record)), set(file, text, counter, type) {}
  template <class Row>
  void append(const Row& row, int dim) {
    pack(type, dim, row, set.add());
  }
  TableType type;
  GrowingSet set;
};

/// The growing data sets of a file.
struct Layout {
  Layout(hid_t file, const Header& header);
  /// All sets, in the order of writing.
  std::vector<GrowingSet*> sets();

  GrowingSet time, step, stage, position, rotation;
  std::optional<GrowingSet> velocity, spin, stress, plastic;
  GrowingSet contact_first, contact_count;
  GrowingTable contacts;
  std::optional<GrowingSet> bearing_state, bearing_force, bearing_displacement;
  std::vector<GrowingSet> fields;
  GrowingSet history_time;
  std::vector<GrowingSet> histories;
  GrowingSet energy_time;
  std::vector<GrowingSet> energy_terms;
  GrowingSet energy_residual;
  GrowingTable events, stages, notes, modes;
  GrowingSet mode_position, mode_rotation, mode_displacement, mode_turn;
  GrowingTable motions;
  GrowingSet motion_acceleration;
};

/// Writes the table of the seal.
void write_seal(hid_t file, const std::vector<SealRow>& rows, int dim);

}  // namespace trilith::results
