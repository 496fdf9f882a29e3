// The three scenes of IGA-CPP (003): start fixed, start and end fixed, neither.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "bench/scratch.h"

namespace headland::bench {

// Scenes whose name has `only`: its six planners and ours, `runs` seeds each, on made-up regions of
// five parts (the paper's coordinates are lost) a tenth as long as its own; what their lengths are
// above the proven least, then the shortest plan and the one of least measured energy driven by the
// transplanter on rolling ground. Prints tables, or returns them as JSON.
nlohmann::ordered_json run_scenes(const Scratch& scratch, const std::string& only, int runs,
                                  bool as_json);

}  // namespace headland::bench
