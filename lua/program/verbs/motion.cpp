// trilith motion FILE [-o FILE]: a record, or a motion of a run
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "base/error.hpp"
#include "draw/chart/motion_chart.hpp"
#include "draw/chart/stored_motion.hpp"
#include "load/motion_plain.hpp"
#include "load/motion_process.hpp"
#include "load/motion_read.hpp"
#include "load/motion_summary.hpp"
#include "program/output_folder.hpp"
#include "program/positive.hpp"
#include "program/verbs.hpp"

namespace trilith::program {
namespace {

struct MotionOptions {
  std::string file, out;
  std::optional<double> scale, peak, time_scale;
  bool reverse = false, no_picture = false;
  std::string unit, column;
  int number = 1;
  std::optional<double> step;
  std::optional<int> skip;
  char decimal = 0;
  std::optional<int> baseline;
  FilterBand band;
};

/// Motion `number` (from 1) of the motions that a run applied.
GroundMotion motion_of_run(const std::string& file, int number) {
  const std::vector<results::MotionRow> rows = results::ResultsReader(file).motions();
  if (rows.empty()) throw InputError(fmt::format("results file '{}': it holds no motion", file));
  if (number < 1 || static_cast<std::size_t>(number) > rows.size())
    throw InputError(fmt::format("--number: '{}' has motions 1 to {}", file, rows.size()));
  return draw::stored_motion(rows[static_cast<std::size_t>(number) - 1]);
}

GroundMotion read_record(const MotionOptions& options) {
  if (std::filesystem::path(options.file).extension() == ".h5") return motion_of_run(options.file, options.number);
  return options.unit.empty() ? read_motion(options.file)
                              : read_plain_motion(options.file, {options.unit, options.step, options.column,
                                                                 options.skip, options.decimal});
}

GroundMotion read_processed(const MotionOptions& options) {
  if (options.unit.empty() && (options.step || !options.column.empty() || options.skip || options.decimal != 0))
    throw InputError("--dt, --column, --skip and --decimal need --unit, for a file of plain columns");
  GroundMotion motion = read_record(options);
  if (options.baseline) motion = baseline_corrected(motion, *options.baseline);
  return options.band.low > 0 || options.band.high > 0 ? filtered(motion, options.band) : motion;
}

GroundMotion read_scaled(const MotionOptions& options) {
  GroundMotion motion = read_processed(options);
  if (options.scale) motion = motion.scaled(*options.scale);
  if (options.time_scale) motion = motion.time_scaled(*options.time_scale);
  if (options.peak) motion = motion.scaled_to_peak(*options.peak * standard_gravity);
  return options.reverse ? motion.reversed() : motion;
}

int show_motion(const MotionOptions& options) {
  const std::filesystem::path out = options.out.empty()
                                        ? std::filesystem::path(options.file).stem().replace_extension(".png")
                                        : std::filesystem::path(options.out);
  draw::picture_format(out);
  const GroundMotion motion = read_scaled(options);
  fmt::print("{}", motion_summary(motion));
  if (options.no_picture) return ended_well;
  make_folder_for(out);
  draw::draw_charts({draw::motion_chart(motion), draw::spectrum_chart({motion})}, draw::Arrangement::beside, out);
  fmt::print("{}\n", out.string());
  return ended_well;
}

}  // namespace

void add_motion(CLI::App& app, int& code) {
  auto o = std::make_shared<MotionOptions>();
  CLI::App* verb = app.add_subcommand("motion", "Measure and draw a ground motion");
  verb->add_option("file", o->file, "record: PEER .AT2, CSV, or plain columns with --unit; or a results file, .h5")
      ->required()
      ->type_name("FILE");
  verb->add_option("-o,--output", o->out, "picture, .svg, .pdf or .png; default FILE with .png, in the current folder")
      ->type_name("FILE");
  verb->add_option("--number", o->number, "of a results file: number of the motion, from 1")
      ->type_name("N")
      ->capture_default_str();
  verb->add_option("--unit", o->unit, "unit of the accelerations, for a file of plain columns: " + plain_units())
      ->type_name("UNIT");
  verb->add_option("--dt", o->step, "with --unit: time step of the samples [s], without a time column")
      ->type_name("STEP");
  verb->add_option("--column", o->column, "with --unit: number or name of the acceleration column; rows: line by line")
      ->type_name("COLUMN");
  verb->add_option("--skip", o->skip, "with --unit: number of header lines")
      ->check(CLI::Validator(is_not_negative, "", ""))
      ->type_name("LINES");
  verb->add_option("--decimal", o->decimal, "with --unit: decimal sign, . or ,")
      ->check(CLI::IsMember(std::vector<char>{'.', ','}))
      ->type_name("SIGN");
  verb->add_option("--baseline", o->baseline, "baseline correction: subtract the polynomial of this degree")
      ->type_name("DEGREE");
  verb->add_option("--low", o->band.low, "Butterworth filter: remove lower frequencies [Hz]")->type_name("HZ");
  verb->add_option("--high", o->band.high, "Butterworth filter: remove higher frequencies [Hz]")->type_name("HZ");
  verb->add_option("--order", o->band.order, "order of the filter")->type_name("N")->capture_default_str();
  verb->add_option("--scale", o->scale, "factor on the amplitudes")->type_name("FACTOR");
  verb->add_option("--peak", o->peak, "scale to this peak acceleration, in g")->type_name("PGA");
  verb->add_option("--time-scale", o->time_scale, "factor on the time axis")->type_name("FACTOR");
  verb->add_flag("--reverse", o->reverse, "reverse the sign");
  verb->add_flag("--no-picture", o->no_picture, "print the figures only");
  verb->callback([o, &code] { code = show_motion(*o); });
}

}  // namespace trilith::program
