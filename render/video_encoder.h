// Frames into a video file by ffmpeg, which is called as a program.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <span>

#include "render/pictures.h"

namespace headland {

// Throws InputError when ffmpeg is not installed: to be asked before long work whose video it is.
void require_ffmpeg();

// H.264 in an MP4 that plays anywhere. The file is written under a temporary name beside its place
// and takes its name in finish(); without it nothing is left.
class VideoEncoder {
 public:
  // Width and height are even. Throws InputError when ffmpeg cannot be started.
  VideoEncoder(std::filesystem::path file, const PictureSize& size, double frames_per_s);
  ~VideoEncoder();
  VideoEncoder(const VideoEncoder&) = delete;
  VideoEncoder& operator=(const VideoEncoder&) = delete;

  // RGBA, rows from top to bottom. Throws InputError when ffmpeg gave up (a full disk).
  void write(std::span<const std::uint8_t> rgba);
  void finish();

 private:
  int wait();  // for ffmpeg to end; its exit status

  std::filesystem::path file_;
  std::filesystem::path unfinished_;
  pid_t ffmpeg_ = -1;
  int frames_ = -1;  // the pipe into it
};

}  // namespace headland
