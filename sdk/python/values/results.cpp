// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The classes of reports and measurements.
#include "sdk/python/values/results.h"

#include <meniscus/batch.h>
#include <nanobind/stl/string.h>

#include "sdk/python/values/to_python.h"

namespace meniscus::python {

namespace {

nb::object value_of(const auto& value) {
  return nb::cast(value);
}
nb::object value_of(Vec3 value) {
  return nb::make_tuple(double{value.x}, double{value.y}, double{value.z});
}

template <class T>
const char* type_of(const T&) {
  if constexpr (std::is_same_v<T, bool>) return "bool";
  if constexpr (std::is_integral_v<T>) return "int";
  if constexpr (std::is_floating_point_v<T>) return "float";
  if constexpr (std::is_same_v<T, std::string>) return "str";
  if constexpr (std::is_same_v<T, Vec3>) return "tuple[float, float, float]";
  if constexpr (std::is_same_v<T, MemoryUse>) return "MemoryUse";
  return "Overflows";
}

/// A class with read-only members.
template <class T>
struct Result {
  nb::class_<T> type;

  Result(nb::module_& module, const char* name, const char* doc) : type(module, name, doc) {
    type.def("__repr__", [](nb::handle self) {
      std::string text;
      const nb::object kind = nb::borrow(self.type());
      for (const nb::handle key : nb::cast<nb::tuple>(kind.attr("_members")))
        text += (text.empty() ? "" : ", ") + nb::cast<std::string>(key) + "=" +
                nb::cast<std::string>(nb::repr(self.attr(key)));
      return nb::cast<std::string>(kind.attr("__name__")) + "(" + text + ")";
    });
    type.attr("_members") = nb::tuple();
  }

  template <class M>
  Result& has(const char* key, M T::*member, const char* doc) {
    const std::string getter = "def " + std::string(key) + "(self) -> " + type_of(T{}.*member);
    type.def_prop_ro(
        key, [member](const T& self) { return value_of(self.*member); },
        nb::for_getter(nb::sig(getter.c_str())), doc);
    type.attr("_members") = type.attr("_members") + nb::make_tuple(key);
    return *this;
  }
};

template <class Report>
void bind_stages(Result<Report>& report) {
  report.type.def_prop_ro(
      "stage_ms",
      [](const Report& self) {
        nb::dict stages;
        for (std::size_t i = 0; i < stage_count; ++i)
          stages[stage_name(static_cast<Stage>(i))] = self.stage_ms[i];
        return stages;
      },
      nb::for_getter(nb::sig("def stage_ms(self) -> dict[str, float]")),
      "On the device, by stage, summed over the substeps.");
}

void bind_step_report(nb::module_& module) {
  Result<Overflows>(module, "Overflows", "What exceeded a fixed size in a step, summed over its substeps.")
      .has("cloth_layers", &Overflows::cloth_layers, "Particles near more than three layers of cloth.")
      .has("cloth_vertices", &Overflows::cloth_vertices, "Contacts with more than 32 vertices of cloth.")
      .has("fluid_failsafe", &Overflows::fluid_failsafe,
           "Particles that the fail-safe did not keep from cloth.")
      .has("cloth_failsafe", &Overflows::cloth_failsafe, "Substeps in which it did not keep cloth apart.")
      .has("emitter_hold", &Overflows::emitter_hold,
           "Emitted particles that do not get away from an opening.");
  Result<StepReport> report(module, "StepReport", "Counts and times of one step.");
  report
      .has("substeps", &StepReport::substeps,
           "Made; more than World.substeps while a fast body is near cloth.")
      .has("iterations", &StepReport::iterations, "Per substep.")
      .has("density_iterations", &StepReport::density_iterations, "Per substep, on average.")
      .has("ms", &StepReport::ms, "Wall clock, host and device.")
      .has("rigid_ms", &StepReport::rigid_ms, "Of Bullet on the host, contained in ms.")
      .has("contacts", &StepReport::contacts, "In the last substep.")
      .has("max_neighbours", &StepReport::max_neighbours, "The longest list of neighbours so far.")
      .has("removed", &StepReport::removed, "Particles that sinks removed.")
      .has("emitted", &StepReport::emitted, "Particles that emitters made.")
      .has("emission_refused", &StepReport::emission_refused, "m³ that found no room.")
      .has("absorbed", &StepReport::absorbed, "Particles that cloth absorbed.")
      .has("dripped", &StepReport::dripped, "Particles that dripped from cloth.")
      .has("diffuse", &StepReport::diffuse, "All spray, foam and bubbles.")
      .has("diffuse_refused", &StepReport::diffuse_refused, "Those for which there was no room.")
      .has("max_speed", &StepReport::max_speed, "m/s, of particles and of vertices of cloth and ropes.")
      .has("overflows", &StepReport::overflows, "What exceeded a fixed size.");
  bind_stages(report);
}

void bind_diagnostics(nb::module_& module) {
  Result<Diagnostics>(module, "Diagnostics", "The state of the particles. The density error is ρ/ρ₀ − 1.")
      .has("particles", &Diagnostics::particles, "Of fluids and granular materials.")
      .has("density_error_mean", &Diagnostics::density_error_mean, "Mean of the excess over all particles.")
      .has("density_error_max", &Diagnostics::density_error_max, "The largest.")
      .has("density_error_interior", &Diagnostics::density_error_interior,
           "Mean of its size over particles with a full support.")
      .has("neighbours_mean", &Diagnostics::neighbours_mean, "Particles within the support radius of one.")
      .has("kinetic_energy", &Diagnostics::kinetic_energy, "J, of particles, cloth and ropes.")
      .has("potential_energy", &Diagnostics::potential_energy, "J, of them, relative to the origin.")
      .has("max_speed", &Diagnostics::max_speed, "m/s, of them.")
      .has("contacts", &Diagnostics::contacts, "Between particles and solids.")
      .has("non_finite", &Diagnostics::non_finite, "Particles and vertices that are not finite.")
      .has("outside", &Diagnostics::outside, "Those beyond the wall of a container or inside a solid.")
      .has("wall_overflows", &Diagnostics::wall_overflows, "Particles with more than three walls in reach.");
  Result<ClothState>(module, "ClothState", "Measurements of a piece of cloth.")
      .has("mass", &ClothState::mass, "kg, with the fluid that it holds.")
      .has("fluid_mass", &ClothState::fluid_mass, "kg, of that fluid.")
      .has("area", &ClothState::area, "m², at rest.")
      .has("mean_stretch", &ClothState::mean_stretch, "Mean of |l/L − 1| over edges.")
      .has("max_stretch", &ClothState::max_stretch, "Largest l/L: 1 is unstretched.")
      .has("volume", &ClothState::volume, "m³, of a closed piece.")
      .has("pressure", &ClothState::pressure, "Pa, overpressure of its gas.")
      .has("centre", &ClothState::centre, "m, of mass.")
      .has("momentum", &ClothState::momentum, "kg·m/s.")
      .has("kinetic_energy", &ClothState::kinetic_energy, "J.")
      .has("closed", &ClothState::closed, "Whether it has no border.");
}

void bind_memory(nb::module_& module) {
  Result<MemoryUse>(module, "MemoryUse", "Memory from one allocator.")
      .has("bytes", &MemoryUse::bytes, "Held now.")
      .has("peak_bytes", &MemoryUse::peak_bytes, "The most that was ever held.")
      .has("allocations", &MemoryUse::allocations, "So far; constant over a step that needs no more room.");
  Result<MemoryStats>(module, "MemoryStats", "What a world has taken from its allocators.")
      .has("device", &MemoryStats::device,
           "Arrays on the device, with those of snapshots; on the CPU they are host memory.")
      .has("shared", &MemoryStats::shared, "Host memory that the device reads and writes as well.");
}

void bind_batches(nb::module_& module) {
  Result<WorldStatus>(module, "WorldStatus", "The state of one world of a batch.")
      .has("active", &WorldStatus::active, "Whether steps advance it.")
      .has("failed", &WorldStatus::failed,
           "Its last step was not finite: it has the state before, and waits for its reset.")
      .has("time", &WorldStatus::time, "s.");
  Result<BatchReport> report(module, "BatchReport", "The results of a step of a batch.");
  report.has("ms", &BatchReport::ms, "Wall clock time.")
      .has("substeps", &BatchReport::substeps, "The largest number of any world.")
      .has("turns", &BatchReport::turns, "In which the worlds have stepped.")
      .has("rigid_ms", &BatchReport::rigid_ms, "Of Bullet on the host, contained in ms.")
      .has("stepped", &BatchReport::stepped, "Worlds that have advanced.")
      .has("failed", &BatchReport::failed, "Worlds that failed in this step.")
      .has("contacts", &BatchReport::contacts, "Of the last substep, in all worlds.")
      .has("max_neighbours", &BatchReport::max_neighbours, "Of a particle.");
  bind_stages(report);
}

}  // namespace

void bind_results(nb::module_& module) {
  bind_step_report(module);
  bind_diagnostics(module);
  bind_memory(module);
  bind_batches(module);
  Result<DeviceInfo>(module, "DeviceInfo", "A device as `meniscus devices` lists it.")
      .has("kind", &DeviceInfo::kind, "\"cpu\" or \"cuda\".")
      .has("name", &DeviceInfo::name, "Of the processor.")
      .has("usable", &DeviceInfo::usable, "Whether worlds can run there.")
      .has("reason", &DeviceInfo::reason, "Why it is not usable, or why the world fell back to the CPU.")
      .has("memory_bytes", &DeviceInfo::memory_bytes, "Of its memory.");
  Result<MeshRepair>(module, "MeshRepair", "A mesh file whose surface was rebuilt.")
      .has("file", &MeshRepair::file, "Its path.")
      .has("cell_size", &MeshRepair::cell_size, "m: no part of either surface is further from the other.")
      .has("deviation", &MeshRepair::deviation, "m, the largest from the old outer surface to the new one.")
      .has("volume_before", &MeshRepair::volume_before, "m³, of the file.")
      .has("volume", &MeshRepair::volume, "m³, of the new surface.")
      .has("open_edges", &MeshRepair::open_edges, "Of the file.")
      .has("odd_edges", &MeshRepair::odd_edges, "Of the file.")
      .has("crossings", &MeshRepair::crossings, "Of the file.");
}

}  // namespace meniscus::python
