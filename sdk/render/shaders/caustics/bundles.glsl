// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// How bundles of light are counted.
const float whole_bundle = 1024.0;
