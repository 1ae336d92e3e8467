// Positions of the ticks of an axis, and the format of their numbers.
#pragma once

#include <string>
#include <vector>

namespace trilith::draw {

/// Multiples of a step of 1, 2 or 5 times a power of ten within [low, high]. The step is the smallest with at most
/// `most` (>= 2) ticks, or the next smaller one if that leaves fewer than three. Needs finite ends with high - low
/// above 1e-12 times the larger of them.
std::vector<double> linear_ticks(double low, double high, int most);

/// Labelled ticks on a logarithmic axis within [low, high], 0 < low < high. They are the powers of ten if there are two
/// or more (every second, third, ... if there are more than `most`). Otherwise they are 1, 2 and 5 times the powers of
/// ten, or linear ticks.
std::vector<double> log_ticks(double low, double high, int most = 8);

/// The 2 to 9 fold of every power of ten within [low, high], for grid lines; none if they are too dense (more than
/// eight decades).
std::vector<double> log_minor_ticks(double low, double high);

/// The largest of 1, 2, 5 times a power of ten that is not above `value` (> 0).
double nice_at_most(double value);

/// Numbers of the ticks, all with the decimals that the finest needs; minus as U+2212, zero without a sign.
std::vector<std::string> tick_texts(const std::vector<double>& ticks);

/// Numbers of logarithmic ticks: plain from 0.001 to 10,000 (excluded), otherwise powers of ten such as 10⁻⁴ or 2·10⁵.
std::vector<std::string> log_tick_texts(const std::vector<double>& ticks);

}  // namespace trilith::draw
