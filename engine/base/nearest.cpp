#include "base/nearest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace trilith {

/// Dynamic programming over all prefixes of a and b (Damerau, "A technique for computer detection and correction of
/// spelling errors", Comm. ACM 7, 1964): an insertion, deletion, substitution or swap of neighbours costs 1.
int edit_distance(std::string_view a, std::string_view b) {
  const std::size_t n = b.size() + 1;
  std::vector<int> before(n), last(n), row(n);
  for (std::size_t j = 0; j < n; ++j) last[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j < n; ++j) {
      const int change = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, change});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before.swap(last);
    last.swap(row);
  }
  return last[n - 1];
}

/// A name matches if at most a third of its letters differ, one letter in short words. A single letter matches nothing.
std::string nearest_name(std::string_view given, const std::vector<std::string>& known) {
  std::string best;
  const int letters = static_cast<int>(given.size());
  int least = std::min(std::max(1, letters / 3), letters - 1) + 1;
  for (const std::string& name : known) {
    const int distance = edit_distance(given, name);
    if (distance < least) {
      least = distance;
      best = name;
    }
  }
  if (!best.empty() || given.size() < 3) return best;
  // No spelling is near: a prefix matches if only one name begins with it.
  const auto begins = [&](const std::string& name) { return name.starts_with(given); };
  if (std::count_if(known.begin(), known.end(), begins) == 1) best = *std::find_if(known.begin(), known.end(), begins);
  return best;
}

namespace {

struct FormerName {
  std::string_view before, now;
  std::string_view table = {};  ///< how to write `now` where `before` has become a key of its table
};
/// Names before version 1.0, and the names of today. Of several successors the known one applies.
constexpr std::array former_names{
    FormerName{"until_rest", "rest"},
    FormerName{"still", "rest"},
    FormerName{"ratio", "rest", "rest = { ratio = }"},
    FormerName{"speed", "rest", "rest = { speed = }"},
    FormerName{"hold", "rest", "rest = { hold = }"},
    FormerName{"course", "load_curve"},
    FormerName{"damping", "local_damping"},
    FormerName{"damping", "damping_ratio"},
    FormerName{"damping", "beta"},
    FormerName{"friction", "friction_angle"},
    FormerName{"dilation", "dilation_angle"},
    FormerName{"axis", "station"},
    FormerName{"x", "station"},
    FormerName{"turn_x", "rotation_x"},
    FormerName{"turn_y", "rotation_y"},
    FormerName{"turn_z", "rotation_z"},
};

/// Present spelling of `given` if it is a former name of one of `known`, otherwise "".
std::string_view written_today(std::string_view given, const std::vector<std::string>& known) {
  for (const FormerName& former : former_names)
    if (former.before == given && std::find(known.begin(), known.end(), former.now) != known.end())
      return former.table.empty() ? former.now : former.table;
  return {};
}

}  // namespace

std::string name_hint(std::string_view given, const std::vector<std::string>& known) {
  if (const std::string_view now = written_today(given, known); !now.empty())
    return fmt::format("; since version 1.0 it is '{}'", now);
  const std::string best = nearest_name(given, known);
  if (!best.empty()) return fmt::format("; did you mean '{}'?", best);
  if (known.empty()) return "; there are none";
  constexpr std::size_t most_in_a_line = 150, first_ones = 10;
  if (known.size() <= most_in_a_line) return fmt::format("; known: {}", fmt::join(known, ", "));
  return fmt::format("; known: {}, and {} more", fmt::join(known.begin(), known.begin() + first_ones, ", "),
                     known.size() - first_ones);
}

}  // namespace trilith
