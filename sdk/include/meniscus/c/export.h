// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// For C: files of the present state, as `meniscus run` writes them. The ending of the path is the format:
// .ply (binary), .vtp (ParaView) or .obj. A file is complete or is not there.
#pragma once

#include <meniscus/c/world.h>

#ifdef __cplusplus
extern "C" {
#endif

/// Writes the particles of fluids and grains with their attributes. MENISCUS_IO if the file cannot be
/// written.
MENISCUS_C_API MeniscusStatus meniscus_export_particles(const MeniscusWorld* world, const char* path);
/// Writes spray, foam and bubbles.
MENISCUS_C_API MeniscusStatus meniscus_export_diffuse(const MeniscusWorld* world, const char* path);
/// Writes the surfaces of fluids, one after another.
MENISCUS_C_API MeniscusStatus meniscus_export_surface(const MeniscusWorld* world, const MeniscusId* fluids,
                                                      size_t count, const char* path);
/// Writes pieces of cloth, one after another.
MENISCUS_C_API MeniscusStatus meniscus_export_cloth(const MeniscusWorld* world, const MeniscusId* cloths,
                                                    size_t count, const char* path);

#ifdef __cplusplus
}
#endif
