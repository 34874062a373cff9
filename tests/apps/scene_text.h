// Reads scenes from strings, and returns the error messages of wrong ones.
#pragma once

#include <catch2/catch.hpp>

#include "apps/scene.h"
#include "solver/base/error.h"
#include "tests/apps/temporary_directory.h"

namespace ease {

inline Scene sceneOf(const std::string& toml) {
  const TemporaryDirectory directory;
  return readScene(directory.write("scene.toml", toml));
}

/// Returns the error message for a scene, beginning with the name of its file: "scene.toml:LINE: ...".
inline std::string errorOf(const std::string& toml) {
  const std::string message = messageOf<InputError>([&] { sceneOf(toml); });
  CHECK(message.find('\n') == std::string::npos);
  const size_t name = message.find("scene.toml");
  return name == std::string::npos ? message : message.substr(name);
}

// Smallest valid scenes.  Tests append lines to them.
inline const std::string kBody = "body = {poses = ['t.ply', 'a.ply']}\n[garment]\nmesh = 's.obj'\n";
inline const std::string kNoBody = "solver = {steps = 10}\n[garment]\nmesh = 's.obj'\n";

}  // namespace ease
