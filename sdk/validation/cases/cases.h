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

}  // namespace meniscus::validation
