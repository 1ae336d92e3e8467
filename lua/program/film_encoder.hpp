// Pipes raw pictures to the program ffmpeg, which writes a film.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace trilith::program {

/// A film in progress. The file gets its name when it is complete; an unfinished one is removed.
class FilmEncoder {
 public:
  struct Format {
    int columns = 1280, rows = 720;  ///< pixels, even
    double rate = 30;                ///< pictures per second
  };
  /// The container follows from the extension: .mp4, .webm or .gif. Throws InputError for any other extension, where
  /// ffmpeg is not installed, and where the folder cannot be written.
  FilmEncoder(std::filesystem::path path, const Format& format);
  FilmEncoder(const FilmEncoder&) = delete;
  FilmEncoder& operator=(const FilmEncoder&) = delete;
  ~FilmEncoder();

  /// Adds a picture: rows from the top, 4 bytes per pixel (blue, green, red, unused). Throws InputError with ffmpeg's
  /// message if it has failed.
  void add(std::string_view pixels);
  /// Waits for ffmpeg. Throws InputError with its message if it has failed.
  void finish();

 private:
  [[noreturn]] void fail();
  void close_pipe();
  int wait();

  std::filesystem::path path_, unfinished_, errors_;
  int pipe_ = -1;
  pid_t child_ = -1;
};

/// Throws InputError unless `path` has the extension of a film.
void check_film_name(const std::filesystem::path& path);

}  // namespace trilith::program
