// Scenes as text, and what is said of wrong ones.
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

/// The error for a scene, from its file's name on: "scene.toml:LINE: ...".
inline std::string errorOf(const std::string& toml) {
  const std::string message = messageOf<InputError>([&] { sceneOf(toml); });
  CHECK(message.find('\n') == std::string::npos);
  const size_t name = message.find("scene.toml");
  return name == std::string::npos ? message : message.substr(name);
}

// Smallest scenes, to which the tests add lines; one line each, so that what is added begins on the second.
inline const std::string kBody = "body = {poses = ['t.ply', 'a.ply']}\n[garment]\nmesh = 's.obj'\n";
inline const std::string kNoBody = "solver = {steps = 10}\n[garment]\nmesh = 's.obj'\n";

}  // namespace ease
