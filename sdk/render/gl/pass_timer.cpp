// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Reads OpenGL's timestamp queries.
#include "sdk/render/gl/pass_timer.h"

namespace meniscus::render {

PassTimer::~PassTimer() {
  glDeleteQueries(static_cast<GLsizei>(queries_.size()), queries_.data());
}

void PassTimer::start() {
  used_ = 0;
  note("");
}

void PassTimer::mark(const char* pass) {
  note(pass);
}

void PassTimer::note(const char* pass) {
  if (!is_on_) return;
  if (used_ == queries_.size()) {
    glGenQueries(1, &queries_.emplace_back());
    names_.emplace_back();
  }
  names_[used_] = pass;
  glQueryCounter(queries_[used_++], GL_TIMESTAMP);
}

std::vector<PassTime> PassTimer::times() const {
  std::vector<PassTime> times;
  GLuint64 before = 0;
  for (std::size_t i = 0; i < used_; ++i) {
    GLuint64 now = 0;
    glGetQueryObjectui64v(queries_[i], GL_QUERY_RESULT, &now);
    if (i > 0) times.push_back({names_[i], 1e-6 * static_cast<double>(now - before)});
    before = now;
  }
  return times;
}

}  // namespace meniscus::render
