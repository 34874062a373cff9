#!/usr/bin/env python3
"""The installed library as other projects use it: installs a build, then builds and runs the examples on it.

    install_test.py CMAKE BUILD_DIRECTORY SOURCE_DIRECTORY
"""

import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CMAKE, BUILD, SOURCE = (sys.argv.pop(1) for _ in range(3))


def run(*command):
    """What the command prints; fails the test with it where the command fails."""
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return done.stdout


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.root = Path(cls.folder.name)
        cls.prefix = cls.root / "prefix"
        run(CMAKE, "--install", BUILD, "--prefix", cls.prefix, "--component", "library")

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def configure(self, source, build, *options):
        return run(CMAKE, "-S", source, "-B", build, "-DCMAKE_BUILD_TYPE=None", "-DCMAKE_CXX_FLAGS=-O2", *options)

    def test_examples_compiled_with_plain_flags_run_on_it(self):
        build = self.root / "examples"
        self.configure(Path(SOURCE) / "examples", build, f"-DCMAKE_PREFIX_PATH={self.prefix}")
        run(CMAKE, "--build", build, "-j2")
        sags = [float(x) for x in re.findall(r"sags by ([0-9.]+) m", run(build / "hang"))]
        self.assertEqual(len(sags), 6)
        self.assertGreater(sags[-1], 0.0)
        self.assertLess(sags[-1], 0.1)
        # No vertex is deeper in the ball than the millimetre by which contact gives way, and the cloth hangs around it.
        heights = re.findall(r"y = ([-0-9.]+) m, nearest ([-0-9.]+) mm", run(build / "own_obstacle"))
        self.assertLess(float(heights[-1][0]), -0.2)
        self.assertGreater(float(heights[-1][1]), -1.0)
        draped = re.search(r"grown by ([-0-9.]+) %; the deepest vertex was ([-0-9.]+) mm", run(build / "drape_on_body"))
        self.assertGreater(float(draped[1]), 0.0)
        self.assertLess(float(draped[2]), 0.5)

    def test_types_are_laid_out_alike_for_every_instruction_set(self):
        project = self.root / "layout"
        project.mkdir()
        (project / "CMakeLists.txt").write_text(
            "cmake_minimum_required(VERSION 3.25)\nproject(layout LANGUAGES CXX)\n"
            "find_package(ease REQUIRED COMPONENTS collision)\n"
            f'add_executable(plain "{SOURCE}/tests/install/layout.cpp")\n'
            f'add_executable(native "{SOURCE}/tests/install/layout.cpp")\n'
            "target_compile_options(native PRIVATE -march=native)\n"
            "target_link_libraries(plain PRIVATE ease::collision)\n"
            "target_link_libraries(native PRIVATE ease::collision)\n", encoding="utf-8")
        build = self.root / "layout_build"
        self.configure(project, build, f"-DCMAKE_PREFIX_PATH={self.prefix}")
        run(CMAKE, "--build", build, "-j2")
        plain = run(build / "plain")
        self.assertEqual(plain, run(build / "native"))
        self.assertIn("allocation 64", plain)

    def test_a_program_with_another_alignment_of_eigen_does_not_compile(self):
        compiled = subprocess.run(
            ["c++", "-std=c++20", "-fsyntax-only", "-x", "c++", "-", f"-I{self.prefix}/include", "-I/usr/include/eigen3"],
            input="#include <ease/solver/mesh/triangle_mesh.h>\n", capture_output=True, text=True, check=False)
        self.assertNotEqual(compiled.returncode, 0)
        self.assertIn("-DEIGEN_MAX_ALIGN_BYTES=64", compiled.stderr)

    def test_no_flag_of_the_build_reaches_users(self):
        exported = "".join(file.read_text() for file in self.prefix.rglob("ease_*.cmake"))
        self.assertIn("EIGEN_MAX_ALIGN_BYTES=64", exported)
        for flag in ("-march", "-Wall", "-fsanitize", "-Werror", SOURCE):
            self.assertNotIn(flag, exported)

    def test_headers_include_each_other_below_ease(self):
        for header in (self.prefix / "include").rglob("*.h"):
            self.assertNotRegex(header.read_text(encoding="utf-8"), r'#include "', header)

    def test_the_solver_alone_asks_for_no_other_library(self):
        printed = self.configure(Path(SOURCE) / "examples", self.root / "solver_alone", "-DEXAMPLES_ON_BODY=OFF",
                                 f"-DCMAKE_PREFIX_PATH={self.prefix}", "-DCMAKE_DISABLE_FIND_PACKAGE_VTK=ON",
                                 "-DCMAKE_DISABLE_FIND_PACKAGE_OpenVDB=ON", "-DCMAKE_DISABLE_FIND_PACKAGE_CGAL=ON",
                                 "-DCMAKE_DISABLE_FIND_PACKAGE_fmt=ON")
        self.assertIn("Configuring done", printed)

    def test_a_project_can_contain_the_source_tree(self):
        build = self.root / "inside"
        self.configure(Path(SOURCE) / "examples", build, f"-DEASE_SOURCE={SOURCE}", "-DEXAMPLES_ON_BODY=OFF",
                       "-DCMAKE_DISABLE_FIND_PACKAGE_VTK=ON", "-DCMAKE_DISABLE_FIND_PACKAGE_OpenVDB=ON",
                       "-DCMAKE_DISABLE_FIND_PACKAGE_CGAL=ON", "-DCMAKE_DISABLE_FIND_PACKAGE_Catch2=ON",
                       "-DCMAKE_DISABLE_FIND_PACKAGE_benchmark=ON", "-DCMAKE_DISABLE_FIND_PACKAGE_CLI11=ON",
                       "-DCMAKE_DISABLE_FIND_PACKAGE_tomlplusplus=ON")
        targets = run(CMAKE, "--build", build, "--target", "help")
        self.assertIn("ease_solver", targets)
        for target in ("test_step", "ease_collision", "ease_apps", "step_bench"):
            self.assertNotIn(target, targets)


if __name__ == "__main__":
    unittest.main()
