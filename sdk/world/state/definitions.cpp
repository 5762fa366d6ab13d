// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The definitions of all that is in a world, as JSON.
#include "sdk/world/state/definitions.h"

#include "sdk/world/state/definition_json.h"

namespace meniscus {

template <class V>
void fields(V& v, ParticleMaterial& m) {
  v("name", m.name, any_value, "", "");
  v("rest_density", m.fluid.rest_density, any_value, "kg/m³", "");
  v("dynamic_viscosity", m.fluid.dynamic_viscosity, any_value, "Pa·s", "");
  v("xsph", m.fluid.xsph, any_value, "1/s", "");
  v("vorticity_confinement", m.fluid.vorticity_confinement, any_value, "", "");
  v("cohesion", m.fluid.cohesion, any_value, "N/m", "");
  v("surface_tension", m.fluid.surface_tension, any_value, "N/m", "");
  v("is_grain", m.grain.is_grain, any_value, "", "");
  v("friction", m.grain.friction, any_value, "", "of contacts among grains");
  v("filter", m.filter, any_value, "", "");
  v("color", m.color, any_value, "", "");
  v("slope", m.slope, any_value, "", "of a heap, as given");
}

namespace {

using definition_json::Ids;
using definition_json::Json;

/// The definition in an entry of a table.
template <class Entry>
auto& def_of(Entry& entry) {
  if constexpr (requires { entry.def; })
    return entry.def;
  else
    return entry;
}

template <class Id, class Entry>
Json to_json(const IdTable<Id, Entry>& table, const Ids& ids) {
  Json list = Json::array();
  table.for_each([&](uint32_t index, const Entry& entry) {
    while (list.size() < index) list.push_back(nullptr);
    auto def = def_of(entry);  // fields() takes a mutable struct
    list.push_back(definition_json::to_json(def, ids));
  });
  return list;
}

Json parsed(const std::string& text) {
  Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) throw Error(ErrorCode::io, "the definitions in the file are no JSON");
  return json;
}

}  // namespace

std::string definitions_text(const WorldTables& t) {
  const Ids ids{t.first_generation};
  WorldDef def = t.given;
  const Json all{{"world", definition_json::to_json(def, ids)},
                 {"fluids", to_json(t.fluids, ids)},
                 {"shapes", to_json(t.shapes, ids)},
                 {"bodies", to_json(t.bodies, ids)},
                 {"joints", to_json(t.joints, ids)},
                 {"emitters", to_json(t.emitters, ids)},
                 {"sinks", to_json(t.sinks, ids)},
                 {"probes", to_json(t.probes, ids)},
                 {"force_fields", to_json(t.force_fields, ids)},
                 {"cloths", to_json(t.cloths, ids)},
                 {"ropes", to_json(t.ropes, ids)},
                 {"attachments", to_json(t.attachments, ids)}};
  return all.dump(-1, ' ', false, Json::error_handler_t::replace);
}

WorldDef read_world_def(const std::string& text) {
  WorldDef def;
  const Json json = parsed(text);
  definition_json::from_json(definition_json::at(json, "world"), "world", def, {});
  return def;
}

Definitions read_definitions(const std::string& text, uint32_t first_generation) {
  const Ids ids{first_generation};
  const Json json = parsed(text);
  Definitions all;
  const auto read = [&](const char* key, auto& list) {
    definition_json::from_json(definition_json::at(json, key), key, list, ids);
  };
  read("world", all.world);
  read("fluids", all.fluids);
  read("shapes", all.shapes);
  read("bodies", all.bodies);
  read("joints", all.joints);
  read("emitters", all.emitters);
  read("sinks", all.sinks);
  read("probes", all.probes);
  read("force_fields", all.force_fields);
  read("cloths", all.cloths);
  read("ropes", all.ropes);
  read("attachments", all.attachments);
  return all;
}

}  // namespace meniscus
