// Pictures of the moments that a run's report shows from close by.
#pragma once

#include <vector>

#include "evaluate/report_record.h"
#include "render/report_page.h"

namespace headland {

struct Job;

// What the verdict's reasons are about first, then the worst slip, the tightest turn and the
// largest load transfer, as far as they happened; at most kMostCloseUps, each moment once. None of
// a run without samples.
inline constexpr std::size_t kMostCloseUps = 4;
std::vector<PagePicture> close_ups(const Job& job, const RecordedRun& recorded);

}  // namespace headland
