#include "render/video_encoder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <string>
#include <system_error>

#include "terrains/input_error.h"

namespace headland {
namespace {

constexpr char kMissing[] = "is not installed; it writes videos (Debian: ffmpeg)";

}  // namespace

void require_ffmpeg() {
  // Asking a shell would lose a Ctrl-C.
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::string program = (folder.empty() ? "." : folder) + "/ffmpeg";
    if (::access(program.c_str(), X_OK) == 0) return;
  }
  throw InputError("ffmpeg", "", "", kMissing);
}

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
    ::_exit(127);
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
    if (written < 0) {
      const int status = wait();
      throw InputError(file_.string(), "", fmt::format("ffmpeg's exit status {}", status),
                       status == 127 ? kMissing : "the video cannot be written");
    }
    rgba = rgba.subspan(static_cast<std::size_t>(written));
  }
}

void VideoEncoder::finish() {
  const int status = wait();
  std::error_code fault;
  if (status == 0) std::filesystem::rename(unfinished_, file_, fault);
  if (status != 0 || fault) {
    throw InputError(file_.string(), "", fmt::format("ffmpeg's exit status {}", status),
                     status == 127 ? kMissing : "the video cannot be written");
  }
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
