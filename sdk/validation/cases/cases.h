// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Declares the cases, each of which has a file of its own.
#pragma once

#include "sdk/validation/case.h"

namespace meniscus::validation {

Case martin_moyce();
Case koshizuka_oka();
Case marin();
Case sloshing();
Case hydrostatics();
Case torricelli();
Case added_mass();
Case couette();
Case poiseuille();
Case taylor_green_vortices();
Case draft();
Case neutral_density();
Case friction();
Case catenary();
Case elastica();
Case chain();
Case membrane();
Case elastic_gate();
Case drop();

}  // namespace meniscus::validation
