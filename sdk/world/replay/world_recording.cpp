// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// World's recordings: the calls that change it, its hash after each step, and its whole state where calls do
// not tell it.
#include <meniscus/error.h>
#include <meniscus/version.h>
#include <meniscus/world.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "sdk/files/output_file.h"
#include "sdk/world/world_recorded.h"

namespace meniscus {

namespace {

/// A file that goes when this does.
class PassingFile {
 public:
  explicit PassingFile(const std::filesystem::path& path) : path_(io::make_part(path)) {}
  ~PassingFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  PassingFile(const PassingFile&) = delete;
  PassingFile& operator=(const PassingFile&) = delete;

  std::string path() const { return path_.string(); }
  std::vector<uint8_t> bytes() const {
    std::ifstream stream(path_, std::ios::binary);
    std::vector<uint8_t> all(std::filesystem::file_size(path_));
    stream.read(reinterpret_cast<char*>(all.data()), static_cast<std::streamsize>(all.size()));
    if (!stream) io::throw_io_error("read", path_);
    return all;
  }

 private:
  std::filesystem::path path_;
};

}  // namespace

/// Notes the whole state, as a snapshot file.
void World::Impl::note_state() {
  if (!recorder) return;
  recorder->guard([&] {
    const PassingFile file(recorder->path());
    run([&](auto w) { w.save(file.path()); });
    recorder->write(RecordKind::state, file.bytes());
  });
}

void World::Impl::note_step(float dt, const StepReport& report) {
  if (!recorder) return;
  recorder->guard([&] {
    const uint64_t hash = run([&](auto w) { return w.state_hash(); });
    const call_text::Ids from{first_generation};
    recorder->write(RecordKind::call, call_text::encoded("step", from, dt, report.iterations, hash));
  });
}

void World::Impl::warn_of_hooks() const {
  log.warn("the world is being recorded, and hooks are in no recording");
}

void World::Calls::start_recording(const std::string& path) {
  if (impl_->recorder)
    throw Error(ErrorCode::invalid_argument,
                "start_recording was called while the world is recorded to " + impl_->recorder->path());
  const RecordingHeader header{MENISCUS_VERSION_STRING, impl_->device.kind};
  impl_->recorder = std::make_unique<Recorder>(path, header, impl_->log);
  if (!impl_->hooks.empty()) impl_->warn_of_hooks();
}

void World::Calls::stop_recording() {
  if (!impl_->recorder)
    throw Error(ErrorCode::invalid_argument, "stop_recording was called, and nothing is being recorded");
  const std::unique_ptr<Recorder> done = std::move(impl_->recorder);
  done->stop();
}

void World::start_recording(const std::string& path) {
  impl_->run([&](auto w) { w.start_recording(path); });
  impl_->note_state();
  if (impl_->recorder->failed()) stop_recording();  // throws
}
void World::stop_recording() {
  return impl_->run([&](auto w) { w.stop_recording(); });
}

}  // namespace meniscus
