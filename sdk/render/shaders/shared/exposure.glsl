// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// How long drops and spray move while a picture is taken.
const float exposure = 0.008;  // s, half of the time that a picture of film takes in
