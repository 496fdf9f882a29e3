// Frames of a video drawn by several processes, delivered in order.
#pragma once

#include <sys/types.h>

#include <functional>
#include <vector>

#include "render/image.h"

namespace headland {

// Draws one frame; each process makes its own in begin(), as OpenGL's contexts are not shared.
using DrawFrame = std::function<Image(int frame)>;

// Frame k is drawn by process k modulo `processes`, each of which draws its frames in order.
class FrameWorkers {
 public:
  // Starts the processes; `begin` is called once in each. No other thread may be running. Throws
  // InputError, with no process left, when there are no more of them or of pipes.
  FrameWorkers(int frames, int processes, const std::function<DrawFrame()>& begin);
  // Ends them, whatever they are at.
  ~FrameWorkers();
  FrameWorkers(const FrameWorkers&) = delete;
  FrameWorkers& operator=(const FrameWorkers&) = delete;

  // The bytes of frame k (0, 1, 2, ...), `size` of them. False when `stop` said so, which is asked
  // ten times a second. Throws InputError with what a process threw.
  bool read(int frame, std::vector<std::uint8_t>& rgba, std::size_t size,
            const std::function<bool()>& stop);

 private:
  struct Worker {
    pid_t process = -1;
    int frames = -1;  // the pipe from it
  };
  void start(int frames, int first, int step, const std::function<DrawFrame()>& begin);
  void end();
  std::vector<Worker> workers_;
};

}  // namespace headland
