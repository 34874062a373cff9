#include "viz/offscreen.h"

#include <EGL/eglext.h>
#include <fmt/format.h>

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

/// Returns the display of the software rasteriser, or EGL_NO_DISPLAY if EGL does not list it as a device.
EGLDisplay softwareDisplay(const char* client_extensions) {
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
    if (has(device_string(devices[i], EGL_EXTENSIONS), "EGL_MESA_device_software")) {
      return eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr);
    }
  }
  return EGL_NO_DISPLAY;
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

OffscreenContext::OffscreenContext() {
  const char* client_extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  for (const auto& open : {softwareDisplay, surfacelessDisplay}) {
    display_ = open(client_extensions);
    if (display_ != EGL_NO_DISPLAY && eglInitialize(display_, nullptr, nullptr)) break;
    display_ = EGL_NO_DISPLAY;
  }
  if (display_ == EGL_NO_DISPLAY) fail("EGL offers no display", eglGetError());
  if (eglBindAPI(EGL_OPENGL_API)) context_ = createContext(display_);
  if (context_ != EGL_NO_CONTEXT && eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) return;
  const EGLint error = eglGetError();
  if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
  fail("no context of OpenGL 3.2", error);
}

// The display is not terminated: EGL keeps one for the whole process, and Mesa's driver leaks memory each time it is
// unloaded.
OffscreenContext::~OffscreenContext() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
}

}  // namespace ease
