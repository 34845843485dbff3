// OpenGL without a screen.
#pragma once

#include <EGL/egl.h>

namespace atom_map {

// Makes an OpenGL context current in this thread, for as long as it lives. Needs no X server, draws in software where
// there is no graphics card. Throws std::runtime_error when there is no OpenGL at all.
class HeadlessGl {
 public:
  HeadlessGl();
  ~HeadlessGl();
  HeadlessGl(const HeadlessGl&) = delete;
  HeadlessGl& operator=(const HeadlessGl&) = delete;

 private:
  EGLDisplay display_;
  EGLContext context_;
};

}  // namespace atom_map
