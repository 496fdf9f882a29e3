// How long planning takes and how much memory, over the number of swaths.
#pragma once

namespace headland::bench {

// Prints times and the peak of memory for 100 to 10 000 swaths and, where the data is there, for
// the Gartner field.
void print_planning_times(bool as_json);

}  // namespace headland::bench
