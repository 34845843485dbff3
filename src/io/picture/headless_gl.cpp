#include "atom_mapping/io/picture/headless_gl.h"

#include <EGL/eglext.h>

#include <stdexcept>

// VTK 9.1 loads OpenGL through GLEW, which also insists on GLX and so on an X server. This takes the place of GLEW's
// own function of that name and spares it the visit. Nothing that draws by GLX may therefore link this library.
extern "C" unsigned glxewInit();
extern "C" unsigned glxewInit() {
  return 0;
}

namespace atom_map {
namespace {

EGLDisplay surfacelessDisplay() {
  auto* get_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  return get_display == nullptr ? EGL_NO_DISPLAY
                                : get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
}

}  // namespace

HeadlessGl::HeadlessGl() : display_(surfacelessDisplay()), context_(EGL_NO_CONTEXT) {
  const EGLint version[] = {
      EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 2, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  if (display_ != EGL_NO_DISPLAY && eglInitialize(display_, nullptr, nullptr) == EGL_TRUE &&
      eglBindAPI(EGL_OPENGL_API) == EGL_TRUE) {
    context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, version);
  }
  if (context_ == EGL_NO_CONTEXT || eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != EGL_TRUE) {
    throw std::runtime_error("cannot draw: no OpenGL 3.2 through EGL; on Debian install libegl-mesa0");
  }
}

HeadlessGl::~HeadlessGl() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
  eglTerminate(display_);
}

}  // namespace atom_map
