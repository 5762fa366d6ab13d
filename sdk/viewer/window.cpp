// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Opens the window with GLFW, and sets up Dear ImGui.
#include "sdk/viewer/window.h"

#include <epoxy/gl.h>
// After epoxy, so that it includes no OpenGL headers of its own.
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#include <meniscus/error.h>
#include <spdlog/spdlog.h>

#include "sdk/viewer/style.h"

namespace meniscus::viewer {
namespace {

std::string last_failure() {
  const char* words = nullptr;
  glfwGetError(&words);
  return words ? words : "no reason given";
}

Window& of(GLFWwindow* window) {
  return *static_cast<Window*>(glfwGetWindowUserPointer(window));
}

/// Errors of any severity count. Other messages are advice about speed, or tell where memory lies.
bool is_mistake(GLenum type, GLenum severity) {
  return type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR ||
         severity == GL_DEBUG_SEVERITY_HIGH;
}

}  // namespace

Window::Window(const std::string& title, int width, int height, bool check_opengl) {
  if (!glfwInit()) throw Error(ErrorCode::device, "cannot open a window: " + last_failure());
  try {
    make_window(title, width, height, check_opengl);
  } catch (...) {
    glfwTerminate();
    throw;
  }
  if (check_opengl) report_mistakes();
  make_panels();
}

void Window::make_window(const std::string& title, int width, int height, bool check_opengl) {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, check_opengl);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  if (!window_) {
    throw Error(ErrorCode::device, "cannot open a window with OpenGL 4.5: " + last_failure());
  }
  glfwMakeContextCurrent(window_);
  glfwSwapInterval(1);
  glfwSetWindowUserPointer(window_, this);
  // ImGui's own callbacks are added later, and call these.
  glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int, int action, int) {
    of(w).touched_ = true;
    if (action != GLFW_RELEASE && !ImGui::GetIO().WantTextInput) of(w).keys_.push_back(key);
  });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int, int, int) { of(w).touched_ = true; });
  glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double, double) { of(w).touched_ = true; });
  glfwSetScrollCallback(window_, [](GLFWwindow* w, double, double) { of(w).touched_ = true; });
  glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { of(w).touched_ = true; });
  glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { of(w).touched_ = true; });
}

void Window::make_panels() {
  float across = 1;
  glfwGetWindowContentScale(window_, &scale_, &across);
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;  // the viewer leaves no files behind
  set_style(scale_);
  ImGui_ImplGlfw_InitForOpenGL(window_, true);
  ImGui_ImplOpenGL3_Init("#version 450");
}

void Window::report_mistakes() {
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(
      [](GLenum, GLenum type, GLuint, GLenum severity, GLsizei, const GLchar* words, const void* self) {
        if (!is_mistake(type, severity)) return;
        ++const_cast<Window*>(static_cast<const Window*>(self))->mistakes_;
        spdlog::error("OpenGL: {}", words);
      },
      this);
}

Window::~Window() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
  glfwDestroyWindow(window_);
  glfwTerminate();
}

Window::Size Window::size() const {
  Size size;
  glfwGetFramebufferSize(window_, &size.width, &size.height);
  return size;
}

void Window::set_title(const std::string& title) {
  glfwSetWindowTitle(window_, title.c_str());
}

void Window::wait(double seconds) {
  touched_ = false;
  keys_.clear();
  glfwWaitEventsTimeout(seconds);
}

void Window::wake() {
  glfwPostEmptyEvent();
}

bool Window::should_close() const {
  return glfwWindowShouldClose(window_);
}

void Window::close() {
  glfwSetWindowShouldClose(window_, GLFW_TRUE);
}

void Window::begin() {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

void Window::draw_panels() {
  ImGui::Render();
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void Window::end() {
  glfwSwapBuffers(window_);
}

}  // namespace meniscus::viewer
