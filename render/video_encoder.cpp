#include "render/video_encoder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <string>
#include <system_error>

#include "render/called_program.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

// What a child says of a program that it cannot start, as shells do.
constexpr int kNotStarted = 127;

[[noreturn]] void refuse(const std::filesystem::path& file, int status) {
  throw InputError(file.string(), "", fmt::format("ffmpeg's exit status {}", status),
                   status == kNotStarted ? "ffmpeg cannot be started (Debian: ffmpeg)"
                                         : "the video cannot be written");
}

}  // namespace

void require_ffmpeg() { require_program("ffmpeg", "writes videos", "ffmpeg"); }

VideoEncoder::VideoEncoder(std::filesystem::path file, const PictureSize& size, double frames_per_s)
    : file_(std::move(file)),
      unfinished_(file_.parent_path() /
                  fmt::format(".{}.{}.part", file_.filename().string(), ::getpid())) {
  const std::string frame = fmt::format("{}x{}", size.width, size.height);
  const std::string rate = fmt::format("{:g}", frames_per_s);
  const std::string to = unfinished_.string();
  const std::array<const char*, 33> arguments = {
      "ffmpeg",  "-nostdin",   "-hide_banner", "-loglevel", "fatal",     "-y",
      "-f",      "rawvideo",   "-pix_fmt",     "rgba",      "-s",        frame.c_str(),
      "-r",      rate.c_str(), "-i",           "pipe:0",    "-an",       "-c:v",
      "libx264", "-preset",    "veryfast",     "-crf",      "20",        "-pix_fmt",
      "yuv420p", "-flags",     "+bitexact",    "-fflags",   "+bitexact", "-f",
      "mp4",     to.c_str(),   nullptr};
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) throw InputError("ffmpeg", "", "", "no pipe to it");
  ffmpeg_ = ::fork();
  if (ffmpeg_ == 0) {
    // A Ctrl-C is for the program alone, which then ends ffmpeg.
    ::setpgid(0, 0);
    ::dup2(pipe[0], STDIN_FILENO);
    ::execvp("ffmpeg", const_cast<char* const*>(arguments.data()));
    ::_exit(kNotStarted);
  }
  ::close(pipe[0]);
  frames_ = pipe[1];
  if (ffmpeg_ < 0) {
    ::close(frames_);
    throw InputError("ffmpeg", "", "", "cannot be started");
  }
}

VideoEncoder::~VideoEncoder() {
  if (ffmpeg_ > 0) {
    ::kill(ffmpeg_, SIGKILL);
    wait();
  }
  std::error_code ignored;
  std::filesystem::remove(unfinished_, ignored);
}

void VideoEncoder::write(std::span<const std::uint8_t> rgba) {
  while (!rgba.empty()) {
    const ssize_t written = ::write(frames_, rgba.data(), rgba.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) refuse(file_, wait());
    rgba = rgba.subspan(static_cast<std::size_t>(written));
  }
}

void VideoEncoder::finish() {
  const int status = wait();
  std::error_code fault;
  if (status == 0) std::filesystem::rename(unfinished_, file_, fault);
  if (status != 0 || fault) refuse(file_, status);
}

int VideoEncoder::wait() {
  ::close(frames_);
  int status = 0;
  while (::waitpid(ffmpeg_, &status, 0) < 0 && errno == EINTR) {
  }
  ffmpeg_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

}  // namespace headland
