// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// From light to sRGB, by a curve like that of film (Narkowicz's fit to ACES); luma beside it.
vec4 developed(vec3 light) {
  vec3 c = 0.80 * light;
  c = clamp(c * (2.51 * c + 0.03) / (c * (2.43 * c + 0.59) + 0.14), 0.0, 1.0);
  c = mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
  return vec4(c, dot(c, vec3(0.299, 0.587, 0.114)));
}
