// Ctrl-C: the stage in flight is dropped, what the stages before it wrote is kept.
#pragma once

namespace headland {

// Thrown by a stage that was interrupted; the command exits with 130.
struct Interrupted {};

// From here on a first Ctrl-C is noted and a second one ends the program at once.
void catch_interrupts();

bool interrupted();

// Throws Interrupted.
void stop_if_interrupted();

}  // namespace headland
