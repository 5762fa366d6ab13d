# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
#
# What samples/run, tests/run, .ci/run and cmake/install-deps share. To be sourced, with $root set to the repository.
# shellcheck shell=dash

say() {
  printf 'meniscus: %s\n' "$1" >&2
}

fail() {
  say "$1"
  exit 1
}

# quietly WHAT COMMAND...: runs a command whose output matters only when it fails.
quietly() {
  local what=$1 log status=0
  shift
  say "$what"
  log=$(mktemp "${TMPDIR:-/tmp}/meniscus.XXXXXX")
  "$@" >"$log" 2>&1 </dev/null || status=$?
  if [ $status != 0 ]; then
    cat "$log" >&2
    say "$what failed (status $status)"
  fi
  rm -f "$log"
  return $status
}

cpu_count() {
  nproc 2>/dev/null || echo 2
}

# need_writable FOLDER: stops where a build folder cannot be written, as in a checkout that somebody else owns.
need_writable() {
  if ! mkdir -p "$root/$1" 2>/dev/null || [ ! -w "$root/$1" ]; then
    fail "cannot write in $root/$1: the build needs a checkout of your own"
  fi
}

# Build folders side by side share the objects in the compiler's cache.
export CCACHE_BASEDIR="$root"

# configure PRESET FOLDER OPTION...: configures a build folder. Small sources are merged, as most of their time goes into the
# headers that they share.
configure() {
  local preset=$1 folder=$2
  shift 2
  need_writable "$folder"
  quietly "configuring $folder/" cmake -S "$root" -B "$root/$folder" --preset "$preset" \
    -DMENISCUS_MERGE_SOURCES=ON "$@"
}

# build FOLDER [TARGET]: builds. On a terminal ninja shows its progress in one line.
build() {
  local folder=$1
  need_writable "$folder"
  set -- --parallel "$(cpu_count)" ${2:+--target "$2"}
  if [ -t 1 ]; then
    say "building in $folder/"
    cmake --build "$root/$folder" "$@"
  else
    quietly "building in $folder/" cmake --build "$root/$folder" "$@"
  fi
}

# has_option FOLDER NAME VALUE: whether a folder is configured so.
has_option() {
  [ -e "$root/$1/build.ninja" ] && grep -q "^$2:[A-Z]*=$3\$" "$root/$1/CMakeCache.txt"
}

has_gpu() {
  ls /dev/nvidia[0-9]* >/dev/null 2>&1 || nvidia-smi -L >/dev/null 2>&1
}

has_nvcc() {
  command -v nvcc >/dev/null || [ -x /usr/local/cuda/bin/nvcc ] || [ -x "${CUDACXX:-}" ]
}
