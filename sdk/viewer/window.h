// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The window, its OpenGL context and its input.
#pragma once

#include <string>
#include <vector>

struct GLFWwindow;

namespace meniscus::viewer {

/// One window with OpenGL 4.5, current on this thread, and Dear ImGui drawing in it.
class Window {
 public:
  /// With `check_opengl`, OpenGL reports mistakes (KHR_debug), at some cost. Throws Error(device) if there is
  /// no screen or no such OpenGL.
  Window(const std::string& title, int width, int height, bool check_opengl);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  struct Size {
    int width = 0, height = 0;  ///< pixels; 0 if it is minimised
    friend bool operator==(const Size&, const Size&) = default;
  };
  Size size() const;
  void set_title(const std::string& title);
  /// Pixels per unit length of the desktop.
  float scale() const { return scale_; }

  /// Sleeps until an event comes, at most this many seconds.
  void wait(double seconds);
  /// Wakes a waiting window; any thread may call it.
  static void wake();
  /// Whether an event in the last wait may change the picture.
  bool touched() const { return touched_; }
  /// The keys pressed in it, as GLFW_KEY_…, except those typed into a field.
  const std::vector<int>& keys() const { return keys_; }
  bool should_close() const;
  void close();

  void begin();  ///< begins a frame; ImGui's and OpenGL's calls stand between begin and end
  void draw_panels();
  void end();

  /// Number of mistakes that OpenGL has reported so far.
  int mistakes() const { return mistakes_; }

 private:
  void make_window(const std::string& title, int width, int height, bool check_opengl);
  void make_panels();
  void report_mistakes();

  GLFWwindow* window_ = nullptr;
  float scale_ = 1;
  bool touched_ = true;
  int mistakes_ = 0;
  std::vector<int> keys_;
};

}  // namespace meniscus::viewer
