// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// What stands at a pixel, beside its distance: a whole number.
const int is_nothing = 0, is_ground = 1, is_solid = 2, is_floor = 3;  // is_floor + 6 · vessel + face
