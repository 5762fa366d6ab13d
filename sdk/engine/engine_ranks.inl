// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// DeviceEngine's part in a shared world. Rank 0 leads: it announces each call that needs all ranks. The
// others follow. Read-outs go to rank 0.
#pragma once

#include <new>
#include <numeric>

#include "pbd/host_memory.h"
#include "sdk/engine/engine.inl"

namespace meniscus {

template <class D>
void DeviceEngine<D>::share(pbd::Ranks& ranks, const pbd::CutPolicy& policy) {
  guarded(&ranks, [&] {
    all_particles_ = particle_count();
    device_.monitor().commit();
    fetch_contacts();
    held_ ? share_held(ranks, policy) : solver_.share(ranks, policy);
    if (diffuse_) diffuse_->share([this](Vec3 p) { return solver_.owns(p); });
    release_readouts();
    removal_.reserve(0);
  });
  ranks_ = &ranks;
}

template <class D>
void DeviceEngine<D>::end_following() {
  guarded(ranks_, [&] { announce({RankCall::end}); });
}

template <class D>
bool DeviceEngine<D>::follow() {
  return guarded(ranks_, [&] {
    for (;;) {
      RankCommand command{};
      const pbd::Received received{0, &command, sizeof command};
      ranks_->exchange({}, {&received, 1});
      if (command.call == RankCall::end) return false;
      if (command.call == RankCall::pause) return true;
      follow(command);
    }
  });
}

template <class D>
void DeviceEngine<D>::follow(const RankCommand& command) {
  switch (command.call) {
    case RankCall::step:
      begin_step(command.dt, command.iterations);
      end_step();
      return;
    case RankCall::positions:
      return read_positions({});
    case RankCall::velocities:
      return read_velocities({});
    case RankCall::fluids:
      return read_fluids({});
    case RankCall::pressures:
      return read_pressures({}, command.dt);
    case RankCall::density_errors:
      read_density_errors({}, {});
      return;
    case RankCall::ellipsoids:
      return read_ellipsoids({});
    case RankCall::diffuse:
      return read_diffuse({});
    case RankCall::hash:
      hash_particles();
      return;
    case RankCall::diagnostics:
      measure(def_.solver.gravity);
      return;
    case RankCall::counts:
      particles_by_rank();
      return;
    case RankCall::probes: {
      std::vector<fluid::ProbeSum> means(probes_.probes().size());
      return read_probes(means);
    }
    case RankCall::set_sinks:
      return set_sinks(std::vector<Sink>(static_cast<size_t>(command.iterations)));
    case RankCall::take_sinks: {
      std::vector<uint32_t> taken(sinks_.count()), takers;
      take_sinks(taken, takers);
      return;
    }
    case RankCall::find_room: {
      std::vector<uint8_t> has_room;
      return find_room(std::vector<Arrival>(static_cast<size_t>(command.iterations)), has_room);
    }
    case RankCall::append: {
      const auto count = static_cast<size_t>(command.iterations);
      ParticleBatch batch;
      batch.position.resize(count);
      batch.velocity.resize(count);
      batch.phase.resize(count);
      return append(batch);
    }
    case RankCall::keep:
      return keep({});
    case RankCall::set_pistons:
      return set_pistons({}, {});
    case RankCall::save: {
      std::string file(static_cast<size_t>(command.iterations), '\0');
      std::vector<uint64_t> offsets(particle_items.size());
      pbd::copy_from_first(*ranks_, std::span(file));
      pbd::copy_from_first(*ranks_, std::span(offsets));
      write_own_items(file, offsets);
      return;
    }
    case RankCall::end:
    case RankCall::pause:
      return;
  }
}

template <class D>
void DeviceEngine<D>::announce(const RankCommand& command) {
  if (ranks_->rank() != 0) return;
  std::vector<pbd::Sent> sent;
  for (int r = 1; r < ranks_->count(); ++r) sent.push_back({r, &command, sizeof command});
  ranks_->exchange(sent, {});
}

template <class D>
std::vector<uint32_t> DeviceEngine<D>::particles_by_rank() {
  return together({RankCall::counts}, [&] {
    if (diffuse_) diffuse_->set_gathered(gather_diffuse());
    return pbd::values_of_all(*ranks_, particles_.sorted());
  });
}

template <class D>
std::vector<uint64_t> DeviceEngine<D>::write_particle_items(const std::string& file,
                                                            std::span<const uint64_t> offsets) {
  std::string path = file;
  std::vector<uint64_t> places(offsets.begin(), offsets.end());
  const auto [is_written, hashes] = together({RankCall::save, static_cast<int32_t>(path.size())}, [&] {
    pbd::copy_from_first(*ranks_, std::span(path));
    pbd::copy_from_first(*ranks_, std::span(places));
    return write_own_items(path, places);
  });
  if (!is_written) throw Error(ErrorCode::io, "cannot write " + file + ": a rank could not write its part");
  return hashes;
}

/// Whether all ranks could write, and the hashes of all parts.
template <class D>
std::pair<bool, std::vector<uint64_t>> DeviceEngine<D>::write_own_items(const std::string& file,
                                                                        std::span<const uint64_t> offsets) {
  const std::vector<uint32_t> counts = pbd::values_of_all(*ranks_, particles_.sorted());
  uint64_t before = 0;
  for (int r = 0; r < ranks_->rank(); ++r) before += counts[static_cast<size_t>(r)];
  ParticleItemReader reader(device_, particles_.sorted());
  visit_state(reader);
  std::vector<pbd::FilePart> parts;
  std::vector<uint64_t> own;
  for (size_t k = 0; k < offsets.size(); ++k) {
    const ParticleItem& item = reader.items().at(k);
    parts.push_back({offsets[k] + before * item.element_bytes, item.data.data(), item.data.size()});
    own.push_back(pbd::bytes_hash(item.data));
  }
  const bool is_written = ranks_->write_to_file(file.c_str(), parts);
  const auto ranks = static_cast<size_t>(ranks_->count());
  std::vector<uint64_t> by_rank(own.size() * ranks), hashes(by_rank.size());
  ranks_->gather_everywhere(std::as_bytes(std::span(own)), std::as_writable_bytes(std::span(by_rank)));
  for (size_t r = 0; r < ranks; ++r) {
    for (size_t k = 0; k < own.size(); ++k) hashes[k * ranks + r] = by_rank[r * own.size() + k];
  }
  return {!pbd::is_on_any(*ranks_, !is_written), std::move(hashes)};
}

/// Runs work, in which all ranks take part. If it fails here, the others cannot go on.
template <class D>
template <class Work>
decltype(auto) DeviceEngine<D>::guarded(pbd::Ranks* ranks, const Work& work) {
  if (!ranks) return work();
  try {
    return work();
  } catch (const Error& error) {
    if (error.code() != ErrorCode::lost) ranks->fail(error.what());
    throw;
  } catch (const std::bad_alloc&) {
    ranks->fail(pbd::no_host_memory.what());
    throw;
  } catch (const std::exception& error) {
    ranks->fail(error.what());
    throw;
  }
}

template <class D>
template <class Work>
decltype(auto) DeviceEngine<D>::together(const RankCommand& command, const Work& work) {
  return guarded(ranks_, [&]() -> decltype(auto) {
    if (!ranks_) return work();
    announce(command);
    struct Finally {
      DeviceEngine& engine;
      ~Finally() { engine.release_readouts(); }
    } const finally{*this};
    return work();
  });
}

/// Where kernels write the values of particles for a read-out: by slot, or in a shared world by place. There
/// the room for them lasts as long as the read-out. So take the views of the read-outs after this.
template <class D>
pbd::View<const uint32_t> DeviceEngine<D>::readout_places() {
  if (!ranks_) return particles_.slot.current.view();
  reserve_readouts(particles_.sorted());
  std::vector<uint32_t> places(particles_.sorted());
  std::iota(places.begin(), places.end(), 0u);
  replace(places_, std::span<const uint32_t>(places));
  return places_.view();
}

template <class D>
void DeviceEngine<D>::release_readouts() {
  for (pbd::Buffer<uint32_t>* buffer : {&places_, &index_out_}) buffer->resize_discard(0);
  for (pbd::Buffer<float>* buffer : {&scalar_out_, &full_out_}) buffer->resize_discard(0);
  vector_out_.resize_discard(0);
  ellipsoid_out_.resize_discard(0);
}

/// The slots of this rank's particles by place; none in a world that is not shared.
template <class D>
std::vector<uint32_t> DeviceEngine<D>::slots_by_place() {
  return ranks_ ? particles_.slot.current.read(particles_.sorted()) : std::vector<uint32_t>();
}

/// Reads what kernels have written. In a shared world rank 0 gets the values of all ranks.
template <class D>
template <class T>
void DeviceEngine<D>::deliver(const pbd::Buffer<T>& values, const std::vector<uint32_t>& slots,
                              std::span<T> out) {
  if (!ranks_) return values.read(out);
  const std::vector<T> own = values.read(slots.size());
  const auto counts = pbd::values_of_all(*ranks_, static_cast<uint32_t>(slots.size()));
  if (ranks_->rank() != 0) {
    const pbd::Sent sent[] = {{0, slots.data(), slots.size() * sizeof(uint32_t)},
                              {0, own.data(), own.size() * sizeof(T)}};
    return ranks_->exchange(sent, {});
  }
  for (size_t k = 0; k < slots.size(); ++k) out[slots[k]] = own[k];
  for (int r = 1; r < ranks_->count(); ++r) {
    std::vector<uint32_t> its_slots(counts[static_cast<size_t>(r)]);
    std::vector<T> its_values(its_slots.size());
    const pbd::Received received[] = {{r, its_slots.data(), its_slots.size() * sizeof(uint32_t)},
                                      {r, its_values.data(), its_values.size() * sizeof(T)}};
    ranks_->exchange({}, received);
    for (size_t k = 0; k < its_slots.size(); ++k) out[its_slots[k]] = its_values[k];
  }
}

}  // namespace meniscus
