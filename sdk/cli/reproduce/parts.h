// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The parts of `meniscus reproduce pbf`. Each runs scenes and adds a section to the report. Each returns
// whether all was measured, and reports what was measured before the budget was spent. All may throw Error.
#pragma once

#include "sdk/cli/reproduce/paper_scenes.h"

namespace meniscus::cli::pbf {

bool add_times(const Context& context);      ///< tables 1 and 2
bool add_density(const Context& context);    ///< figure 4
bool add_substeps(const Context& context);   ///< how few substeps PCISPH and PBF hold with
bool add_pressure(const Context& context);   ///< artificial pressure with fewer neighbours
bool add_vorticity(const Context& context);  ///< vorticity confinement
bool add_filters(const Context& context);    ///< filters of the surface in pictures

}  // namespace meniscus::cli::pbf
