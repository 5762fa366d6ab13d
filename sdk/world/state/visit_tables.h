// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The items of a world's tables, besides the definitions.
#pragma once

#include "pbd/state/state_visitor.h"
#include "sdk/world/state/world_tables.h"

namespace meniscus {

/// All cloth as the engine got it.
void visit_engine_cloth(pbd::StateVisitor& v, EngineCloth& cloth);

/// What the tables hold besides definitions and what follows from them. To restore it, all entries must be
/// there with their definitions. Ids have generations that count from 0 in the items.
void visit_tables(pbd::StateVisitor& v, WorldTables& tables);

}  // namespace meniscus
