// The video of a run, as `headland render --video` asks for it.
#pragma once

#include <optional>

#include "apps/stages.h"
#include "evaluate/report_record.h"

namespace headland {

struct VideoRequest {
  std::filesystem::path file;  // ends in .mp4
  PictureSize size{1280, 720};
  std::optional<double> speed;  // seconds of the run in one of the video; none: a minute at most
  std::optional<double> from_s;
  std::optional<double> to_s;
  double frames_per_s = 25.0;
  std::optional<int> processes;  // that draw frames; none: as many as there are processors
  bool quiet = false;
};

// Throws InputError for what makes no video of any run (size, speed, frames a second, processes),
// for a file that could not be written, and when ffmpeg is missing.
void check_video_request(const VideoRequest& request);

// Takes a request that was checked. Throws InputError for times the run does not have, and
// Interrupted after Ctrl-C. What does not come to its end leaves no file.
void video_stage(const Job& job, const RecordedRun& recorded, const VideoRequest& request);

}  // namespace headland
