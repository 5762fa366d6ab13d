// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// For C: what a program that contains worlds gives them, as callbacks in a world's definition.
// meniscus/host.h says when they are called. `user` is passed on and may be null. A null callback takes one
// away.
#pragma once

#include <meniscus/c/defs.h>

#ifdef __cplusplus
extern "C" {
#endif

/// Takes the bytes of a file.
typedef struct MeniscusFileBytes MeniscusFileBytes;

/// Reads the file of that name. It gives its bytes to meniscus_file_bytes() and returns 1, or returns 0 if
/// there is no such file.
typedef int (*MeniscusReadFile)(const char* name, MeniscusFileBytes* file, void* user);
/// Gives a copy of the bytes of a file. Of several calls the last one counts. `bytes` may be null if `size`
/// is 0.
MENISCUS_C_API MeniscusStatus meniscus_file_bytes(MeniscusFileBytes* file, const void* bytes, size_t size);
/// Sets WorldDef::read_file.
MENISCUS_C_API MeniscusStatus meniscus_def_set_read_file(MeniscusDef* def, MeniscusReadFile read, void* user);

/// How much a message matters: meniscus::LogLevel.
typedef enum MeniscusLogLevel MENISCUS_ANY_INT { MENISCUS_NOTE = 0, MENISCUS_WARNING = 1 } MeniscusLogLevel;

/// Takes a message, which is valid during the call.
typedef void (*MeniscusLog)(MeniscusLogLevel level, const char* text, void* user);
/// Sets WorldDef::log.
MENISCUS_C_API MeniscusStatus meniscus_def_set_log(MeniscusDef* def, MeniscusLog log, void* user);

/// The body of a loop, valid while the loop runs.
typedef struct MeniscusLoopBody MeniscusLoopBody;

/// Works on [begin, end) of a loop. Any thread may call this.
MENISCUS_C_API void meniscus_loop_run(const MeniscusLoopBody* body, uint32_t begin, uint32_t end);
/// Calls meniscus_loop_run() for ranges that cover [0, count) once, and returns when all are done.
typedef void (*MeniscusParallelFor)(uint32_t count, uint32_t grain, const MeniscusLoopBody* body, void* user);
/// Sets WorldDef::parallel_for.
MENISCUS_C_API MeniscusStatus meniscus_def_set_parallel_for(MeniscusDef* def, MeniscusParallelFor loop,
                                                            void* user);
/// Sets WorldDef::cuda_stream, a cudaStream_t. Null: a stream of the world's own.
MENISCUS_C_API MeniscusStatus meniscus_def_set_cuda_stream(MeniscusDef* def, void* stream);

#ifdef __cplusplus
}
#endif
