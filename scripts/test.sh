#!/usr/bin/env bash
# Sets headland up on a bare Debian 12 and checks everything: format, build, tests, tests under
# AddressSanitizer and UndefinedBehaviorSanitizer, clang-tidy. Stops at the first stage that fails
# and says which. Takes no arguments.
set -euo pipefail
cd "$(dirname "$0")/.."

jobs=$(nproc)
begin=$SECONDS
log=$(mktemp)
trap 'rm -f "$log"' EXIT

# Runs a stage: one line with its time when it passes, all it said when it fails.
stage() {
  local name=$1 start=$SECONDS
  shift
  if "$@" >"$log" 2>&1; then
    grep '% tests passed' "$log" || true
    printf 'test.sh: %-22s ok   %4d s\n' "$name" $((SECONDS - start))
  else
    cat "$log"
    printf 'test.sh: %-22s FAILED after %d s\n' "$name" $((SECONDS - start)) >&2
    exit 1
  fi
}

sources() {
  git ls-files --cached --others --exclude-standard "$@"
}

check_format() {
  sources '*.cpp' '*.h' | xargs clang-format-14 --dry-run -Werror
}

# After the build, which fetches the formatter.
check_web_format() {
  npm --prefix web run --silent check
}

build() {
  cmake --preset "$1" && cmake --build --preset "$1" -j "$jobs"
}

run_tests() {
  ctest --preset "$1" -j "$jobs"
}

# In the build's larger units: file by file it takes six times as long. The tests themselves are
# compiled with warnings as errors but left out here: GoogleTest's macros take longest of all.
check_tidy() {
  find build/CMakeFiles -name 'unity_*.cxx' | sort |
    xargs -P "$jobs" -n 1 clang-tidy-14 -p build --quiet
}

stage "install" scripts/install_deps.sh
stage "format" check_format
stage "build release" build release
stage "web format" check_web_format
stage "tests release" run_tests release
stage "build asan" build asan
stage "tests asan" run_tests asan
stage "clang-tidy" check_tidy
echo "test.sh: all passed in $((SECONDS - begin)) s"
