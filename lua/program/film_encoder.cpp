#include "program/film_encoder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <vector>

#include "base/error.hpp"

namespace trilith::program {
namespace {

namespace fs = std::filesystem;

std::string film_ending(const fs::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return c < 128 ? static_cast<char>(std::tolower(c)) : '?'; });
  return ending;
}

/// Codec options by container. A GIF has a palette per picture, so that ffmpeg keeps no earlier picture.
std::vector<std::string> codec_of(const std::string& ending) {
  if (ending == ".mp4")
    return {"-c:v", "libx264", "-preset", "medium", "-crf", "20", "-pix_fmt", "yuv420p", "-movflags", "+faststart"};
  if (ending == ".webm") return {"-c:v", "libvpx-vp9", "-crf", "30", "-b:v", "0", "-pix_fmt", "yuv420p"};
  return {"-vf", "split[a][b];[a]palettegen=stats_mode=single[p];[b][p]paletteuse=new=1:dither=none", "-loop", "0"};
}

std::vector<std::string> encoder_command(const fs::path& out, const std::string& ending,
                                         const FilmEncoder::Format& format) {
  std::vector<std::string> words{"ffmpeg",
                                 "-nostdin",
                                 "-loglevel",
                                 "error",
                                 "-y",
                                 "-f",
                                 "rawvideo",
                                 "-pix_fmt",
                                 "bgr0",
                                 "-video_size",
                                 fmt::format("{}x{}", format.columns, format.rows),
                                 "-framerate",
                                 fmt::format("{:g}", format.rate),
                                 "-i",
                                 "pipe:0",
                                 "-an"};
  for (const std::string& word : codec_of(ending)) words.push_back(word);
  // "file:" keeps a colon or a minus in the name from being read as a protocol or an option.
  for (const std::string& word : {std::string("-fflags"), std::string("+bitexact"), "file:" + out.string()})
    words.push_back(word);
  return words;
}

/// Starts the command with a pipe as its input. Returns the process, or -1 with errno.
pid_t start_reader(const std::vector<std::string>& words, const fs::path& errors, int& pipe_end) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return -1;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  std::vector<char*> list;
  for (const std::string& word : words) list.push_back(const_cast<char*>(word.c_str()));
  list.push_back(nullptr);
  pid_t child = -1;
  const int trouble = ::posix_spawnp(&child, list[0], &actions, nullptr, list.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(ends[0]);
  if (trouble != 0) {
    ::close(ends[1]);
    errno = trouble;
    return -1;
  }
  pipe_end = ends[1];
  return child;
}

}  // namespace

void check_film_name(const fs::path& path) {
  const std::string ending = film_ending(path);
  if (ending != ".mp4" && ending != ".webm" && ending != ".gif")
    throw InputError(fmt::format("film '{}': the extension '{}' is not a film format, must be .mp4, .webm or .gif",
                                 path.string(), path.extension().string()));
}

FilmEncoder::FilmEncoder(fs::path path, const Format& format) : path_(std::move(path)) {
  check_film_name(path_);
  const std::string ending = film_ending(path_);
  const std::string stem = fmt::format(".{}.{}", path_.stem().string(), ::getpid());
  unfinished_ = path_.parent_path() / (stem + ending);
  errors_ = fs::temp_directory_path() / fmt::format("trilith-film-{}.txt", ::getpid());
  // A write to an ended ffmpeg must return an error here, instead of ending this program without a message.
  ::signal(SIGPIPE, SIG_IGN);
  child_ = start_reader(encoder_command(unfinished_, ending, format), errors_, pipe_);
  if (child_ >= 0) return;
  const int trouble = errno;
  if (trouble == ENOENT)
    throw InputError(
        "movie: the program ffmpeg is not installed, which encodes films; install it with 'sudo apt install ffmpeg', "
        "or make single pictures with trilith draw");
  throw InputError(fmt::format("movie: the program ffmpeg does not start: {}", std::strerror(trouble)));
}

FilmEncoder::~FilmEncoder() {
  close_pipe();
  if (child_ > 0) {
    ::kill(child_, SIGTERM);
    wait();
  }
  std::error_code error;
  fs::remove(unfinished_, error);
  fs::remove(errors_, error);
}

void FilmEncoder::close_pipe() {
  if (pipe_ >= 0) ::close(pipe_);
  pipe_ = -1;
}

int FilmEncoder::wait() {
  int status = 0;
  while (::waitpid(child_, &status, 0) < 0 && errno == EINTR) {
  }
  child_ = -1;
  return status;
}

void FilmEncoder::fail() {
  close_pipe();
  if (child_ > 0) wait();
  std::ifstream stream(errors_);
  std::string line, last = "no message";
  while (std::getline(stream, line))
    if (!line.empty()) last = line;
  throw InputError(fmt::format("movie: ffmpeg cannot write '{}': {}", path_.string(), last));
}

void FilmEncoder::add(std::string_view pixels) {
  while (!pixels.empty()) {
    const ssize_t written = ::write(pipe_, pixels.data(), pixels.size());
    if (written > 0)
      pixels.remove_prefix(static_cast<std::size_t>(written));
    else if (errno != EINTR)
      fail();
  }
}

void FilmEncoder::finish() {
  close_pipe();
  if (wait() != 0) fail();
  std::error_code error;
  fs::rename(unfinished_, path_, error);
  if (error) throw InputError(fmt::format("movie: cannot write '{}': {}", path_.string(), error.message()));
}

}  // namespace trilith::program
