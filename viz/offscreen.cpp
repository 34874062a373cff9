#include "viz/offscreen.h"

#include <EGL/eglext.h>
#include <fmt/format.h>
#include <vtkGenericOpenGLRenderWindow.h>

#include <cstring>
#include <string_view>
#include <vector>

#include "solver/base/error.h"

namespace ease {

namespace {

bool has(const char* extensions, std::string_view wanted) {
  return extensions && fmt::format(" {} ", extensions).find(fmt::format(" {} ", wanted)) != std::string::npos;
}

[[noreturn]] void fail(std::string_view what, EGLint error) {
  throw ComputationError(fmt::format("no OpenGL without a display: {} (EGL error {:#x})", what, error));
}

/// Returns the display of the first device that is, or is not, the software rasteriser; EGL_NO_DISPLAY without one.
EGLDisplay deviceDisplay(const char* client_extensions, bool is_software) {
  if (!has(client_extensions, "EGL_EXT_platform_device") || !has(client_extensions, "EGL_EXT_device_enumeration")) {
    return EGL_NO_DISPLAY;
  }
  const auto query_devices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  const auto device_string =
      reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(eglGetProcAddress("eglQueryDeviceStringEXT"));
  EGLint count = 0;
  if (!query_devices || !device_string || !query_devices(0, nullptr, &count) || count <= 0) return EGL_NO_DISPLAY;
  std::vector<EGLDeviceEXT> devices(count);
  if (!query_devices(count, devices.data(), &count)) return EGL_NO_DISPLAY;
  for (int i = 0; i < count; ++i) {
    if (has(device_string(devices[i], EGL_EXTENSIONS), "EGL_MESA_device_software") == is_software) {
      return eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr);
    }
  }
  return EGL_NO_DISPLAY;
}

EGLDisplay softwareDisplay(const char* client_extensions) {
  return deviceDisplay(client_extensions, true);
}

EGLDisplay hardwareDisplay(const char* client_extensions) {
  return deviceDisplay(client_extensions, false);
}

EGLDisplay surfacelessDisplay(const char* client_extensions) {
  if (!has(client_extensions, "EGL_MESA_platform_surfaceless")) return EGL_NO_DISPLAY;
  return eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
}

EGLContext createContext(EGLDisplay display) {
  const EGLint config_wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
  EGLConfig config;
  EGLint count = 0;
  if (!eglChooseConfig(display, config_wanted, &config, 1, &count) || count == 0) return EGL_NO_CONTEXT;
  const EGLint version[] = {
      EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 2, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  return eglCreateContext(display, config, EGL_NO_CONTEXT, version);
}

}  // namespace

OffscreenContext::OffscreenContext(Renderer renderer) {
  const char* client_extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  std::vector<EGLDisplay (*)(const char*)> ways = {softwareDisplay, surfacelessDisplay};
  if (renderer == Renderer::hardware_first) ways.insert(ways.begin(), hardwareDisplay);
  EGLint error = EGL_SUCCESS;
  for (const auto open : ways) {
    display_ = open(client_extensions);
    if (display_ == EGL_NO_DISPLAY || !eglInitialize(display_, nullptr, nullptr)) continue;
    is_software_ = open != hardwareDisplay;
    if (eglBindAPI(EGL_OPENGL_API)) context_ = createContext(display_);
    if (context_ != EGL_NO_CONTEXT && eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) return;
    error = eglGetError();
    if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
    context_ = EGL_NO_CONTEXT;
  }
  if (error != EGL_SUCCESS) fail("no context of OpenGL 3.2", error);
  fail("EGL offers no display", eglGetError());
}

void OffscreenContext::lend(vtkGenericOpenGLRenderWindow& window) const {
  window.SetOwnContext(0);
  window.SetIsCurrent(true);
  window.SetReadyForRendering(true);
  window.SetSupportsOpenGL(1);
  window.SetIsDirect(1);
  window.SetMapped(1);
  window.SetOffScreenRendering(1);
  window.SetFrameBlitModeToNoBlit();  // pictures are read from memory, no screen shows them
}

void OffscreenContext::makeCurrent() const {
  if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) fail("the context is lost", eglGetError());
}

// The display is not terminated: EGL keeps one for the whole process, and Mesa's driver leaks memory each time it is
// unloaded.
OffscreenContext::~OffscreenContext() {
  if (eglGetCurrentContext() == context_) eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
}

}  // namespace ease
