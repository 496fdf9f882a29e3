// A frame of a run's video: the machine from behind, the map beside it, a strip with what it does.
#pragma once

#include <memory>

#include "render/pictures.h"

namespace headland {

struct VideoFrameOptions {
  PictureSize size{1280, 720};
  double working_width_m = 0.0;  // of the coverage
  double cell_m = 0.25;          // likewise; made coarser where the video would not show it
  double speed = 1.0;            // seconds of the run in one of the video, for the strip
};

// Draws frames of a whole run (the scene's coverage is not used), each later than the one before.
// Same scene, options and time, same bytes, whatever frames were drawn before. Throws InputError as
// the pictures do, and for a run without samples.
class VideoPainter {
 public:
  VideoPainter(const PictureScene& scene, const VideoFrameOptions& options);
  ~VideoPainter();
  VideoPainter(const VideoPainter&) = delete;
  VideoPainter& operator=(const VideoPainter&) = delete;

  Image draw(double time_s);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace headland
