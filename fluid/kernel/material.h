// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The material parameters of a fluid.
#pragma once

namespace meniscus::fluid {

/// One fluid of a world. All fluids have the same rest spacing, hence the same volume for each particle; they
/// differ in mass.
struct Material {
  float rest_density = 1000;        ///< kg/m³
  float dynamic_viscosity = 0;      ///< Pa·s
  float xsph = 0;                   ///< 1/s
  float vorticity_confinement = 0;  ///< ε, dimensionless
  float cohesion = 0;               ///< N/m
  float surface_tension = 0;        ///< N/m
};

}  // namespace meniscus::fluid
