"""Tests of .ci/check_includes on small made-up trees."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / ".ci" / "check_includes"

SOUND = {
    "solver/mesh/triangle_mesh.h": "#include <vector>\n",
    "solver/io/vtp_reader.cpp": '#include <vtkPolyData.h>\n#include "solver/mesh/triangle_mesh.h"\n',
    "solver/model/contact.h": '#include "solver/mesh/triangle_mesh.h"\n',
    "solver/model/cloth.h": '// #include "apps/run.h"\n/*\n#include "apps/run.h"\n*/\n',
    "solver/linear/cholesky.cpp": "#include <cholmod.h>\n",
    "collision/level_set.cpp": '#include <openvdb/openvdb.h>\n#include "solver/model/contact.h"\n',
    "apps/run.h": '#include "solver/model/cloth.h"\n#include "viz/series.h"\n',
    "viz/poly_data.h": "#include <vtkPolyData.h>\n",
    "viz/series.h": '#include "solver/mesh/triangle_mesh.h"\n',
    "viz/series.cpp": '#include "viz/poly_data.h"\n',
    "tests/apps/run_test.cpp": '#include <vtkPolyData.h>\n#include "apps/run.h"\n',
    "build/generated.cpp": '#include "nowhere.h"\n',
}


def check(files):
    """Exit status and output lines for the sound tree with `files` added or replaced."""
    with tempfile.TemporaryDirectory() as root:
        for name, text in {**SOUND, **files}.items():
            path = pathlib.Path(root, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        result = subprocess.run([sys.executable, SCRIPT, root], capture_output=True, text=True)
        return result.returncode, result.stdout.splitlines()


class CheckIncludes(unittest.TestCase):
    def refused(self, files, *lines):
        self.assertEqual(check(files), (1, list(lines)))

    def test_a_tree_that_follows_the_architecture_passes(self):
        self.assertEqual(check({}), (0, []))

    def test_an_include_against_the_direction_is_named_with_its_line(self):
        self.refused(
            {"solver/mesh/up.h": '#pragma once\n#include "solver/model/cloth.h"\n'},
            'solver/mesh/up.h:2: solver/mesh may not include "solver/model/cloth.h" (it may: solver/base)',
        )
        self.refused(
            {"collision/bodies.h": '#  include <solver/model/cloth.h>\n'},
            'collision/bodies.h:1: collision may not include "solver/model/cloth.h" '
            "(it may: solver/base, solver/mesh, solver/linear, solver/model/contact.h, solver/model/samples.h, collision/body)",
        )

    def test_siblings_never_see_each_other(self):
        _, lines = check({
            "garment/paint.h": '#include "adaption/clip.h"\n',
            "adaption/clip.h": "",
            "adaption/loop.h": '#include "garment/paint.h"\n',
            "viz/chart.cpp": '#include "apps/run.h"\n',
        })
        files = [line.split(":")[0] for line in lines]
        self.assertEqual(files, ["adaption/loop.h", "garment/paint.h", "viz/chart.cpp"])

    def test_a_header_that_is_not_there_is_named(self):
        self.refused(
            {"viz/chart.cpp": '#include "series.h"\n'},
            'viz/chart.cpp:1: no such header from the root of the tree: "series.h"',
        )

    def test_a_folder_nobody_knows_is_named(self):
        self.refused(
            {"utils/all.h": "", "solver/extra/all.h": "", "loose.cpp": ""},
            "loose.cpp:1: lies in no folder of the architecture",
            "solver/extra/all.h:1: lies in no folder of the architecture",
            "utils/all.h:1: lies in no folder of the architecture",
        )

    def test_a_library_stays_where_it_belongs(self):
        self.refused({"collision/level_set.h": "#include <openvdb/Grid.h>\n"},
                     "collision/level_set.h:1: OpenVDB may not be included here")
        self.refused({"solver/linear/second.cpp": "#include <suitesparse/cholmod.h>\n"},
                     "solver/linear/second.cpp:1: CHOLMOD is already included in solver/linear/cholesky.cpp: "
                     "one source is enough")

    def test_a_library_is_not_seen_through_our_headers(self):
        self.refused(
            {"viz/series.h": '#include "viz/poly_data.h"\n'},
            "apps/run.h:1: sees VTK through a header of ours",
        )

    def test_a_cycle_of_includes_is_named(self):
        self.refused(
            {"viz/a.h": '#include "viz/b.h"\n', "viz/b.h": '#include "viz/a.h"\n'},
            "viz/a.h:1: includes itself: viz/a.h -> viz/b.h -> viz/a.h",
        )

    def test_an_empty_tree_is_no_success(self):
        with tempfile.TemporaryDirectory() as root:
            result = subprocess.run([sys.executable, SCRIPT, root], capture_output=True, text=True)
            self.assertEqual(result.returncode, 1)
            self.assertIn("no C++ file found", result.stdout)


unittest.main()
