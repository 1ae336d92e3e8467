// trilith movie RESULT [-o FILE] [--fps N] [--slow FACTOR] [--poster T,...]
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/error.hpp"
#include "draw/results/results_picture.hpp"
#include "program/comma_list.hpp"
#include "program/film_encoder.hpp"
#include "program/newer_run.hpp"
#include "program/output_folder.hpp"
#include "program/positive.hpp"
#include "program/scene_options.hpp"
#include "program/share_status.hpp"
#include "program/verbs.hpp"

namespace trilith::program {
namespace {

struct MovieOptions {
  SceneOptions scene;
  std::string out, from = "start", to = "end", poster, size = "1280x720";
  double rate = 30, slow = 1;
};

constexpr double most_pictures = 200000;

/// "1280x720": columns and rows of pixels.
FilmEncoder::Format film_format(const MovieOptions& options) {
  const std::size_t cross = options.size.find('x');
  FilmEncoder::Format format{0, 0, options.rate};
  const auto side = [&](const std::string& digits) {
    const bool read =
        !digits.empty() && digits.size() < 5 && digits.find_first_not_of("0123456789") == std::string::npos;
    return read ? std::stoi(digits) : 0;
  };
  if (cross != std::string::npos) {
    format.columns = side(options.size.substr(0, cross));
    format.rows = side(options.size.substr(cross + 1));
  }
  const auto fits = [](int pixels) { return pixels >= 160 && pixels <= 4096 && pixels % 2 == 0; };
  if (!fits(format.columns) || !fits(format.rows))
    throw InputError(
        fmt::format("--size: '{}' must be COLUMNSxROWS in pixels, even numbers from 160 to 4096, such as "
                    "1280x720",
                    options.size));
  return format;
}

/// Times of the pictures [s of the run]: the last one is the end of the window.
std::vector<double> picture_times(double from, double to, const MovieOptions& options) {
  const double step = 1 / (options.rate * options.slow);
  const double count = std::floor((to - from) / step + 1e-9) + 1;
  if (!(to > from))
    throw InputError(fmt::format("movie: --to must be above --from; they are {:g} s and {:g} s of the run", to, from));
  if (count > most_pictures)
    throw InputError(
        fmt::format("movie: {:g} s at {:g} pictures per second, slowed by {:g}, are {:.0f} pictures, at "
                    "most {:.0f} are possible; lower --fps or --slow, or choose --from and --to",
                    to - from, options.rate, options.slow, count, most_pictures));
  std::vector<double> times;
  for (double i = 0; i < count; ++i) times.push_back(std::min(to, from + i * step));
  if (times.back() < to) times.push_back(to);
  return times;
}

/// The scenes of a film share a title, so that it does not change with the stages.
class Film {
 public:
  Film(const results::ResultsReader& reader, const MovieOptions& options, const SceneWindow& window, double from,
       double to)
      : reader_(reader), choice_(scene_choice(options.scene, reader.header().dim)), format_(film_format(options)) {
    constexpr int samples = 17;
    choice_.origin = window.origin;
    std::vector<double> times;
    for (int i = 0; i < samples; ++i) times.push_back(from + (to - from) * i / (samples - 1));
    choice_.around = draw::box_of_free_bodies(reader, times);
    draw::PictureStyle style = scene_style(options.scene, reader);
    style.height = style.width * format_.rows / format_.columns;
    std::vector<draw::Scene> scenes = draw::results_scenes(reader, times, choice_);
    for (draw::Scene& scene : scenes) set_title(scene);
    series_ = std::make_unique<draw::SceneSeries>(scenes, style);
  }
  [[nodiscard]] draw::Canvas picture(double time) const {
    draw::Scene scene = draw::results_scene(reader_, time, choice_);
    set_title(scene);
    return series_->picture(scene);
  }
  [[nodiscard]] const FilmEncoder::Format& format() const { return format_; }

 private:
  void set_title(draw::Scene& scene) const {
    if (!scene.title.empty()) scene.stage = scene.title + (scene.stage.empty() ? "" : ", " + scene.stage);
    scene.title = reader_.title();
  }
  const results::ResultsReader& reader_;
  draw::SceneChoice choice_;
  FilmEncoder::Format format_;
  std::unique_ptr<draw::SceneSeries> series_;
};

void write_posters(const Film& film, const std::vector<double>& times, const std::filesystem::path& out) {
  for (std::size_t i = 0; i < times.size(); ++i) {
    std::filesystem::path path = out;
    path.replace_filename(out.stem().string() + (times.size() > 1 ? fmt::format("_{}", i + 1) : "") + ".png");
    film.picture(times[i]).save(path);
    fmt::print("{}\n", path.string());
  }
}

int make_movie(const MovieOptions& options) {
  const std::filesystem::path out = options.out.empty()
                                        ? std::filesystem::path(options.scene.result).replace_extension(".mp4")
                                        : std::filesystem::path(options.out);
  check_film_name(out);
  const results::ResultsReader reader(options.scene.result);
  const SceneWindow window = scene_window(reader, options.scene);
  const double from = scene_time(reader, window, options.from, "--from"),
               to = scene_time(reader, window, options.to, "--to");
  std::vector<double> posters;
  if (!options.poster.empty())
    for (const std::string& text : comma_list(options.poster))
      posters.push_back(scene_time(reader, window, text, "--poster"));
  const std::vector<double> times = picture_times(from, to, options);
  const Film film(reader, options, window, from, to);
  make_folder_for(out);
  write_posters(film, posters, out);
  FilmEncoder encoder(out, film.format());
  ShareStatus status(fmt::format("{} pictures", times.size()));
  for (std::size_t i = 0; i < times.size(); ++i) {
    encoder.add(film.picture(times[i]).pixels(film.format().columns, film.format().rows));
    status(static_cast<double>(i + 1) / static_cast<double>(times.size()));
  }
  encoder.finish();
  status.clear();
  fmt::print("{}\n", out.string());
  tell_of_newer_run(reader);
  return ended_well;
}

}  // namespace

void add_movie(CLI::App& app, int& code) {
  auto o = std::make_shared<MovieOptions>();
  CLI::App* verb = app.add_subcommand("movie", "Write a film of a run: mp4, webm or gif, through the program ffmpeg");
  add_scene_options(*verb, o->scene, "--from, --to and --poster");
  verb->add_option("-o,--output", o->out, "film, .mp4, .webm or .gif; default RESULT with .mp4")->type_name("FILE");
  verb->add_option("--fps", o->rate, "pictures per second of the film")
      ->type_name("N")
      ->check(CLI::Range(1.0, 120.0, " "))
      ->capture_default_str();
  verb->add_option("--slow", o->slow, "slow motion: seconds of film per second of the run; below 1 is time lapse")
      ->type_name("FACTOR")
      ->check(CLI::Validator(is_positive, "", ""))
      ->capture_default_str();
  verb->add_option("--from", o->from, "first moment: seconds, 'start', or an event such as seat.lost")
      ->type_name("T")
      ->capture_default_str();
  verb->add_option("--to", o->to, "last moment: seconds, 'end', or an event")->type_name("T")->capture_default_str();
  verb->add_option("--size", o->size, "pixels")->type_name("COLUMNSxROWS")->capture_default_str();
  verb->add_option("--poster", o->poster, "single pictures of these moments too, FILE with .png")
      ->type_name("T[,T...]");
  verb->callback([o, &code] { code = make_movie(*o); });
}

}  // namespace trilith::program
