"""How much memory a job of Ease needs, from the sizes of its meshes."""

import pathlib

from scene_template import of

PROGRAM_MB = 700  # the program, its libraries and pictures: 400 MB measured for a run, 460 MB for a pattern
VERTEX_MB = 0.02  # each vertex of the garment: 0.005 MB measured for a run, 0.009 MB for a pattern
FILE_FACTOR = 10  # a scan in memory, with its neighbours and level set, against its file
BYTES_PER_VERTEX = 35  # of a binary mesh file; files of text have more, so that they count as larger
BUILT_IN = 3000  # vertices of a garment whose scene does not say


def memory_mb(parsed, files):
    """Memory for a scene and the files that its row names, MB, with room to spare."""
    vertices = of(parsed, "garment", "vertices") or of(parsed, "garment", "resolution")
    mesh = of(parsed, "garment", "mesh")
    if mesh and pathlib.Path(mesh).is_file():
        vertices = pathlib.Path(mesh).stat().st_size / BYTES_PER_VERTEX
    if not isinstance(vertices, (int, float)) or vertices <= 0:
        vertices = BUILT_IN
    scans = sum(pathlib.Path(file).stat().st_size for file in files) / 1e6
    return int(PROGRAM_MB + VERTEX_MB * vertices + FILE_FACTOR * scans)
