// Ctrl-C: the stage in flight is dropped, what the stages before it wrote is kept.
#pragma once

namespace headland {

inline constexpr char kInterruptedText[] = "interrupted; what the finished stages wrote is kept";

// Thrown by a stage that was interrupted; the command exits with 130.
struct Interrupted {};

// From here on a first Ctrl-C, or request to end (SIGTERM), is noted and a second one ends the
// program at once. A file beyond the limit of file sizes is an error of writing it, no end of the
// program.
void catch_interrupts();

bool interrupted();

// Throws Interrupted.
void stop_if_interrupted();

// While one lives, a first Ctrl-C ends the program at once, with the message and exit code of any
// other: for work with no place to stop at and nothing on disk yet (reading, planning, drawing).
// Its constructor throws Interrupted as stop_if_interrupted does.
class InterruptAtOnce {
 public:
  InterruptAtOnce();
  ~InterruptAtOnce();
  InterruptAtOnce(const InterruptAtOnce&) = delete;
  InterruptAtOnce& operator=(const InterruptAtOnce&) = delete;
};

}  // namespace headland
