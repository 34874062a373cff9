#!/usr/bin/env pvpython
"""Shows a result of Ease in ParaView (tried with 5.11): the garment coloured by a value, on the body.

  pvpython viz/ease_view.py RESULT_DIR --picture last.png         stretch in the last frame
  pvpython viz/ease_view.py RESULT_DIR --show pressure            or ease, growth; as on the page of a run, fit.html
  pvpython viz/ease_view.py RESULT_DIR --series before            the first rest shape ([output] replays = true)
  pvpython viz/ease_view.py RESULT_DIR --animation motion.avi     all frames (.avi, .ogv, or .png: numbered)
  paraview --script=viz/ease_view.py                              open in the window; EASE_RESULT names RESULT_DIR,
                                                                  EASE_SHOW what is shown

Without a display: xvfb-run -a -s "-screen 0 1600x1000x24" pvpython ...

RESULT_DIR holds garment.pvd and, if the scene has a body, body.pvd.  Colours have one range over all time; triangles
over the limit stand out in orange and red.
"""

import argparse
import json
import os
import sys

SIZE = [1600, 1000]  # pixels
FRAMES_PER_SECOND = 25
LIGHT = (0.3, 0.8)  # ambient, diffuse

# Pale to blue up to the limit, then at once orange to dark red: as in the pictures that a run writes.
BELOW = [(234, 242, 248), (190, 214, 229), (124, 176, 211)]
OVER = [(243, 112, 33), (201, 42, 28), (122, 8, 38)]
DEEP = [(44, 104, 160), (12, 44, 92)]  # goes on from BELOW where no limit is marked

# What --show shows: array, title, ends of the scale, where orange begins, values that are marked.  None: from the result.
PRESETS = {
    "stretch": ("sigma_1", "stretch", None, None, []),
    "pressure": ("contact_pressure_Pa", "pressure, Pa: 2000 firm, 5900 painful", (0, 10000), 5900, [2000, 5900]),
    "ease": ("gap_m", "ease beyond the comfort offset, m", (0, 0.05), None, []),
    "growth": ("rest_area_ratio", "rest area over the first", None, None, []),
}


class InputError(Exception):
    """What the user gave cannot be used; one line."""


def parse_arguments(arguments):
    """The command line, checked as far as it can be without ParaView."""
    parser = argparse.ArgumentParser(
        prog="ease_view.py", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("result", metavar="RESULT_DIR", nargs="?", default=os.environ.get("EASE_RESULT"))
    parser.add_argument("--picture", metavar="FILE.png", help="save the last frame")
    parser.add_argument("--animation", metavar="FILE", help="save all frames (.avi, .ogv, or .png: numbered)")
    parser.add_argument("--show", choices=PRESETS, default=os.environ.get("EASE_SHOW", "stretch"), help="what to show")
    parser.add_argument("--array", help="show this array instead")
    parser.add_argument("--series", choices=("before", "after"), help="show a replay instead of the run")
    parser.add_argument("--range", type=float, nargs=2, metavar=("LO", "HI"), help="ends of the colour scale")
    parser.add_argument("--limit", type=float, help="where orange begins (default for stretch: the report's limit)")
    options = parser.parse_args(arguments)
    if options.result is None:
        raise InputError("no result directory: give RESULT_DIR or set EASE_RESULT")
    if options.show not in PRESETS:
        raise InputError(f"EASE_SHOW={options.show}: expected one of {', '.join(PRESETS)}")
    apply_preset(options)
    if options.range and not options.range[0] < options.range[1]:
        raise InputError("--range {:g} {:g}: the first must be below the second".format(*options.range))
    check_ending("--picture", options.picture, [".png"])
    check_ending("--animation", options.animation, [".png", ".avi", ".ogv"])
    return options


def apply_preset(options):
    """What is shown, where the command line does not say otherwise."""
    options.title, options.marks = options.array, []
    if options.array is None:
        options.array, options.title, value_range, limit, options.marks = PRESETS[options.show]
        options.range = options.range or value_range
        options.limit = limit if options.limit is None else options.limit


def check_ending(option, name, endings):
    """An output's kind, and that its directory is there: ParaView itself would fail only after rendering."""
    if name is None:
        return
    if os.path.splitext(name)[1] not in endings:
        raise InputError(f"{option} {name}: expected a name that ends in {', '.join(endings)}")
    if not os.path.isdir(os.path.dirname(os.path.abspath(name))):
        raise InputError(f"{option} {name}: no such directory")


def open_series(directory, name):
    """The reader of NAME.pvd and its times, s; None where there is no such file."""
    path = os.path.join(directory, name + ".pvd")
    if not os.path.isfile(path):
        return None, []
    reader = simple.PVDReader(registrationName=name, FileName=os.path.abspath(path))
    reader.UpdatePipelineInformation()
    return reader, list(reader.TimestepValues)


def reported_limit(directory):
    """The stretch limit of the run, from its report; None without one."""
    try:
        with open(os.path.join(directory, "report.json"), encoding="utf-8") as report:
            return json.load(report)["sigma_1"]["limit"]
    except (FileNotFoundError, KeyError):
        return None
    except ValueError as error:
        raise InputError(f"{os.path.join(directory, 'report.json')}: {error}") from None


def find_array(reader, name):
    """POINTS or CELLS, wherever the array lives."""
    reader.UpdatePipeline(reader.TimestepValues[0])
    for association, information in (("CELLS", reader.CellData), ("POINTS", reader.PointData)):
        if information.GetArray(name) is not None:
            return association
    known = sorted(list(reader.CellData.keys()) + list(reader.PointData.keys()))
    raise InputError(f"no array {name} in this series; there are: {', '.join(known)}")


def range_over_time(reader, times, association, name):
    """Least and greatest value over all frames; of the magnitude for a vector."""
    low, high = float("inf"), float("-inf")
    for time in times:
        reader.UpdatePipeline(time)
        data = reader.CellData if association == "CELLS" else reader.PointData
        array = data.GetArray(name)
        least, greatest = array.GetRange(0 if array.GetNumberOfComponents() == 1 else -1)
        low, high = min(low, least), max(high, greatest)
    return (low, high) if low < high else (low - 0.5, low + 0.5)


def is_marked(limit, value_range):
    """True if the limit lies within the scale, which then has two halves."""
    return limit is not None and value_range[0] < limit < value_range[1]


def color_points(low, high, limit):
    """Control points of the colour scale: value, red, green, blue, ..."""
    points = []

    def add(colors, start, end):
        for i, color in enumerate(colors):
            points.append(start + (end - start) * i / (len(colors) - 1))
            points.extend(channel / 255 for channel in color)

    if is_marked(limit, (low, high)):
        add(BELOW, low, limit)
        add(OVER, limit + 1e-6 * (high - low), high)
    else:
        add(BELOW + DEEP, low, high)
    return points


def color_garment(display, view, association, options, value_range):
    """Colours with a fixed range, and the scale bar."""
    low, high = value_range
    simple.ColorBy(display, (association, options.array))
    table = simple.GetColorTransferFunction(options.array)
    table.AutomaticRescaleRangeMode = "Never"
    table.ColorSpace = "Lab"
    table.RGBPoints = color_points(low, high, options.limit)
    table.ScalarRangeInitialized = 1.0
    bar = simple.GetScalarBar(table, view)
    bar.Title = options.title
    bar.ComponentTitle = ""
    bar.TitleColor = bar.LabelColor = [0.15, 0.17, 0.19]
    bar.TitleFontSize = bar.LabelFontSize = 18
    bar.AutomaticLabelFormat = 0
    bar.LabelFormat = bar.RangeLabelFormat = "%.5g"
    bar.WindowLocation = "Any Location"
    bar.Orientation = "Vertical"
    bar.Position = [0.88, 0.06]
    bar.ScalarBarLength = 0.5
    marks = options.marks or [options.limit]
    if all(is_marked(mark, value_range) for mark in marks):
        bar.UseCustomLabels = 1
        bar.CustomLabels = marks
    display.SetScalarBarVisibility(view, True)


def common_box(reader, times):
    """Box around the garment over all frames: (xmin, xmax, ymin, ymax, zmin, zmax)."""
    box = [float("inf"), float("-inf")] * 3
    for time in times:
        reader.UpdatePipeline(time)
        now = reader.GetDataInformation().GetBounds()
        box = [(min if i % 2 == 0 else max)(box[i], now[i]) for i in range(6)]
    return box


def place_camera(view, box):
    """Looks along -z, from a little aside and above, at all that the garment will ever reach and the head above it."""
    center = [(box[2 * i] + box[2 * i + 1]) / 2 for i in range(3)]
    width, height = box[1] - box[0], box[3] - box[2]
    angle = 20.0  # degrees, of the view's height
    reach = 1.55 * max(height, width * SIZE[1] / SIZE[0])
    distance = reach / 2 / 0.1763 + (box[5] - box[4]) / 2  # tan(10 degrees)
    view.CameraFocalPoint = center
    view.CameraPosition = [center[0] + 0.25 * distance, center[1] + 0.12 * distance, center[2] + 0.96 * distance]
    view.CameraViewUp = [0, 1, 0]
    view.CameraViewAngle = angle
    view.CenterOfRotation = center


def show(options):
    """Builds the scene and returns its view."""
    if not os.path.isdir(options.result):
        raise InputError(f"no such directory: {options.result}")
    replay = options.series + "_" if options.series else ""
    garment, times = open_series(options.result, replay + "garment")
    if garment is None:
        raise InputError(f"no {replay}garment.pvd in {options.result}: the scene needs [output]"
                         + (" with replays = true" if replay else ""))
    if not times:
        raise InputError(f"no frames in {os.path.join(options.result, replay + 'garment.pvd')}")
    association = find_array(garment, options.array)
    if options.limit is None and options.array == "sigma_1":
        options.limit = reported_limit(options.result)
    value_range = options.range or range_over_time(garment, times, association, options.array)

    view = simple.GetActiveViewOrCreate("RenderView")
    view.ViewSize = SIZE
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0
    cloth = simple.Show(garment, view)
    cloth.Ambient, cloth.Diffuse = LIGHT
    color_garment(cloth, view, association, options, value_range)
    body, _ = open_series(options.result, replay + "body")
    if body is not None:
        skin = simple.Show(body, view)
        skin.Ambient, skin.Diffuse = LIGHT
        skin.AmbientColor = skin.DiffuseColor = [0.78, 0.78, 0.78]
    caption = simple.AnnotateTimeFilter(registrationName="time", Input=garment, Format="{time:.2f} s")
    text = simple.Show(caption, view)
    text.Color = [0.15, 0.17, 0.19]
    text.FontSize = 18

    scene = simple.GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    scene.AnimationTime = times[-1]
    simple.Render(view)  # the first rendering resets the camera
    place_camera(view, common_box(garment, times))
    simple.Render(view)
    return view


def save(options, view):
    """Writes what the options ask for; true if anything."""
    if options.picture:
        simple.SaveScreenshot(options.picture, view, ImageResolution=SIZE)
    if options.animation:
        simple.SaveAnimation(options.animation, view, ImageResolution=SIZE, FrameRate=FRAMES_PER_SECOND)
    return bool(options.picture or options.animation)


def main():
    options = parse_arguments(sys.argv[1:])
    view = show(options)
    if not save(options, view) and not IN_WINDOW:
        simple.Interact(view)


if __name__ == "__main__":
    try:
        from paraview import simple
    except ImportError as error:
        sys.exit(f"ease_view: {error}: this is for ParaView's own Python, pvpython, not {sys.executable}")

    IN_WINDOW = not sys.argv[0]  # ParaView's own window gives a script no command line, and must not be ended
    try:
        main()
    except InputError as error:
        print(f"ease_view: {error}", file=sys.stderr)
        if not IN_WINDOW:
            sys.exit(1)
