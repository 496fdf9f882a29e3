#include "render/frame_workers.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <span>
#include <string>

#include "terrains/input_error.h"

namespace headland {
namespace {

void write_all(int to, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(to, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) ::_exit(1);
    if (written > 0) bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

// Every frame is preceded by a byte: 0 and the frame, or 1 and what went wrong in words.
[[noreturn]] void draw_frames(int to, int first, int step, int frames,
                              const std::function<DrawFrame()>& begin) {
  constexpr std::array<std::uint8_t, 1> kFrame{0};
  constexpr std::array<std::uint8_t, 1> kFault{1};
  // Ctrl-C and a closed terminal are the parent's to hear; when it ends, writing to its pipe ends
  // this process.
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGHUP, SIG_IGN);
  std::signal(SIGTERM, SIG_DFL);
  std::signal(SIGPIPE, SIG_DFL);
  // Processes share the cores out, threads of each would only wait for each other.
  ::setenv("LP_NUM_THREADS", "0", 1);
  try {
    const DrawFrame draw = begin();
    for (int frame = first; frame < frames; frame += step) {
      const Image image = draw(frame);
      write_all(to, kFrame);
      write_all(to, image.rgba);
    }
  } catch (const std::exception& fault) {
    const std::string words = fault.what();
    write_all(to, kFault);
    write_all(to, std::span(reinterpret_cast<const std::uint8_t*>(words.data()), words.size()));
  }
  ::_exit(0);
}

// Reads up to `size` bytes; fewer at the end of the pipe. -1: stopped.
ssize_t read_some(int from, std::span<std::uint8_t> bytes, const std::function<bool()>& stop) {
  constexpr int kWait_ms = 100;
  std::size_t at = 0;
  while (at < bytes.size()) {
    if (stop()) return -1;
    pollfd ready{from, POLLIN, 0};
    if (::poll(&ready, 1, kWait_ms) <= 0) continue;
    const ssize_t got = ::read(from, bytes.data() + at, bytes.size() - at);
    if (got == 0) break;
    if (got > 0) at += static_cast<std::size_t>(got);
  }
  return static_cast<ssize_t>(at);
}

}  // namespace

FrameWorkers::FrameWorkers(int frames, int processes, const std::function<DrawFrame()>& begin) {
  try {
    for (int k = 0; k < processes; ++k) start(frames, k, processes, begin);
  } catch (...) {
    end();
    throw;
  }
}

FrameWorkers::~FrameWorkers() { end(); }

void FrameWorkers::start(int frames, int first, int step, const std::function<DrawFrame()>& begin) {
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) throw InputError("video", "", "", "no more pipes");
  const pid_t process = ::fork();
  if (process == 0) {
    ::close(pipe[0]);
    for (const Worker& other : workers_) ::close(other.frames);
    draw_frames(pipe[1], first, step, frames, begin);
  }
  ::close(pipe[1]);
  workers_.push_back({process, pipe[0]});
  if (process < 0) throw InputError("video", "", "", "no more processes can be started");
}

void FrameWorkers::end() {
  for (const Worker& worker : workers_) {
    ::close(worker.frames);
    if (worker.process < 0) continue;
    ::kill(worker.process, SIGKILL);
    while (::waitpid(worker.process, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  workers_.clear();
}

bool FrameWorkers::read(int frame, std::vector<std::uint8_t>& rgba, std::size_t size,
                        const std::function<bool()>& stop) {
  const Worker& worker = workers_[static_cast<std::size_t>(frame) % workers_.size()];
  std::array<std::uint8_t, 1> kind{};
  const ssize_t told = read_some(worker.frames, kind, stop);
  if (told < 0) return false;
  rgba.resize(size);
  const ssize_t got = told == 0 ? 0 : read_some(worker.frames, rgba, stop);
  if (got < 0) return false;
  if (told == 1 && kind[0] == 0 && static_cast<std::size_t>(got) == size) return true;
  const std::string why(rgba.begin(), rgba.begin() + got);
  throw InputError("video", "", "",
                   told == 1 && kind[0] == 1 ? why : "a process that draws frames has ended");
}

}  // namespace headland
