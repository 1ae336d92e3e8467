#include "results/tables/csv_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "results/tables/run_tables.hpp"

namespace trilith::results {
namespace {

class CsvText : public TableSink {
 public:
  void text(std::string_view text) override {
    if (begun_) text_ += ',';
    begun_ = true;
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
      text_ += text;
      return;
    }
    text_ += '"';
    for (const char c : text) {
      if (c == '"') text_ += '"';
      text_ += c;
    }
    text_ += '"';
  }
  /// The shortest digits that give the same number.
  void number(double value) override { text(std::isnan(value) ? std::string() : fmt::format("{}", value)); }
  void count(std::int64_t value) override { text(fmt::format("{}", value)); }
  void end_row() override {
    text_ += '\n';
    begun_ = false;
  }
  [[nodiscard]] std::string take() { return std::move(text_); }

 private:
  std::string text_;
  bool begun_ = false;
};

}  // namespace

std::string csv_table(const ResultsReader& reader, std::string_view name, const std::vector<double>& times,
                      const UnitSystem& units) {
  CsvText out;
  write_table(reader, name, times, out, units);
  return out.take();
}

}  // namespace trilith::results
