#include "apps/interrupt.h"

#include <unistd.h>

#include <csignal>

#include "apps/commands.h"

namespace headland {
namespace {

// A signal handler has no argument to carry them.
volatile std::sig_atomic_t interrupt_seen = 0;
volatile std::sig_atomic_t ends_at_once = 0;

extern "C" void note_interrupt(int signal) {
  if (ends_at_once != 0) {
    for (const char* text : {"headland: ", kInterruptedText, "\n"}) {
      std::size_t length = 0;
      while (text[length] != '\0') ++length;
      if (::write(STDERR_FILENO, text, length) < 0) break;
    }
    ::_exit(kExitInterrupted);
  }
  interrupt_seen = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void catch_interrupts() {
  std::signal(SIGINT, note_interrupt);
  std::signal(SIGTERM, note_interrupt);
  // A closed terminal; not when it is to be outlived (nohup).
  if (std::signal(SIGHUP, note_interrupt) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
  // A file that grows too large is an error of its writing, told like a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
}

bool interrupted() { return interrupt_seen != 0; }

void stop_if_interrupted() {
  if (interrupted()) throw Interrupted{};
}

InterruptAtOnce::InterruptAtOnce() {
  ends_at_once = 1;
  if (!interrupted()) return;
  ends_at_once = 0;
  throw Interrupted{};
}

InterruptAtOnce::~InterruptAtOnce() { ends_at_once = 0; }

}  // namespace headland
