# SPDX-License-Identifier: GPL-3.0-or-later
"""What the pvpython tests share: paths, the loaded plugin, skipping, checks and image comparison.

    import contourtesting as ct
    simple = ct.load_plugin()          # paraview.simple with the plugin's proxies in it
    path = ct.shared("cnt/manytomany.cnt")   # exits 77 (skipped) where the file is absent
    out = ct.data(filter)              # the filter's output data object, up to date
    ct.check(condition, "sentence")    # counts; ct.finish() at the end exits with the verdict
"""
import os
import sys

SOURCE = os.environ["CONTOUR_SOURCE_DIR"]
OUTPUT = os.environ["CONTOUR_TEST_OUTPUT"]
_failures = []
_checks = 0


def load_plugin():
    """Load the plugin that was built and return paraview.simple."""
    from paraview import simple
    simple.LoadPlugin(os.environ["CONTOUR_PLUGIN"], remote=False, ns=simple.__dict__)
    return simple


def skip(sentence):
    print("SKIPPED: " + sentence)
    sys.stdout.flush()
    sys.exit(77)


def shared(path):
    """The path of a file of the shared test data; the test is skipped where it is absent."""
    full = os.path.join(os.environ["CONTOUR_SHARED_DATA"], path)
    if not os.path.exists(full):
        skip(f"{full} is not there; set the CMake variable CONTOUR_SHARED_DATA to the test data.")
    return full


def own(path):
    """The path of a file of the project's own Data folder."""
    full = os.path.join(SOURCE, "Data", path)
    if not os.path.exists(full):
        raise FileNotFoundError(full)
    return full


def output(name):
    """A path to write to."""
    return os.path.join(OUTPUT, name)


def data(proxy, port=0):
    """The output data object of a source or filter, brought up to date."""
    proxy.UpdatePipeline()
    return proxy.GetClientSideObject().GetOutputDataObject(port)


def closed_polylines(polygons):
    """Contours of lists of points, as poly data in doubles."""
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
    points, lines = vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    for polygon in polygons:
        ids = [points.InsertNextPoint(p) for p in polygon]
        lines.InsertNextCell(len(ids) + 1)
        for i in ids + ids[:1]:
            lines.InsertCellPoint(i)
    made = vtkPolyData()
    made.SetPoints(points)
    made.SetLines(lines)
    return made


def silent(algorithm):
    """Collect errors and warnings instead of printing them."""
    heard = {"ErrorEvent": [], "WarningEvent": []}
    for event, lines in heard.items():
        def listen(_caller, _event, text=None, lines=lines):
            lines.append(text)
        listen.CallDataType = "string0"
        algorithm.AddObserver(event, listen)
    # The executive has a line of its own to say about an algorithm that failed.
    algorithm.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
    return heard


def errors_of(function):
    """What VTK says while the function runs, kept from the test's own output."""
    from vtkmodules.vtkCommonCore import vtkFileOutputWindow, vtkLogger, vtkOutputWindow
    path = output(os.path.splitext(os.path.basename(sys.argv[0]))[0] + "Errors.txt")
    open(path, "w", encoding="utf-8").close()
    window = vtkFileOutputWindow()
    window.SetFileName(path)
    window.SetFlush(True)
    before = vtkOutputWindow.GetInstance()
    vtkOutputWindow.SetInstance(window)
    verbosity = vtkLogger.GetCurrentVerbosityCutoff()
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
    try:
        function()
    finally:
        vtkLogger.SetStderrVerbosity(verbosity)
        vtkOutputWindow.SetInstance(before)
    with open(path, encoding="utf-8") as file:
        return file.read()


def check(condition, sentence):
    """Note a failure and go on; finish() turns notes into the exit code."""
    global _checks
    _checks += 1
    if not condition:
        _failures.append(sentence)
        print("FAILED: " + sentence)
    return bool(condition)


def finish():
    """Every test ends with this. A test that checked nothing fails."""
    print(f"{_checks} checks, {len(_failures)} failed")
    sys.stdout.flush()
    sys.exit(1 if _failures or _checks == 0 else 0)


def compare_image(view, name, threshold=0.02, size=(600, 600)):
    """Render view and compare with Testing/Baseline/<name>.png.

    threshold: largest allowed mean difference of a pixel, as a fraction of full scale, after a
    tolerance for edges that fall a pixel aside. Where there is no baseline the picture is
    left in the output folder and the check fails.
    """
    from paraview import simple
    from vtkmodules.vtkIOImage import vtkPNGReader
    from vtkmodules.vtkImagingCore import vtkImageDifference
    view.ViewSize = list(size)
    view.OrientationAxesVisibility = 0
    picture = output(name + ".png")
    simple.SaveScreenshot(picture, view, ImageResolution=list(size), TransparentBackground=0)
    baseline = os.path.join(SOURCE, "Testing", "Baseline", name + ".png")
    if not os.path.exists(baseline):
        return check(False, f"no baseline {name}.png; look at {picture}, then copy it to Testing/Baseline")
    readers = []
    for path in (picture, baseline):
        reader = vtkPNGReader()
        reader.SetFileName(path)
        reader.Update()
        readers.append(reader)
    if readers[0].GetOutput().GetDimensions() != readers[1].GetOutput().GetDimensions():
        return check(False, f"{picture} and its baseline differ in size")
    difference = vtkImageDifference()
    difference.SetInputConnection(readers[0].GetOutputPort())
    difference.SetImageConnection(readers[1].GetOutputPort())
    difference.SetThreshold(12)
    difference.AllowShiftOn()
    difference.Update()
    pixels = size[0] * size[1]
    # GetThresholdedError is a sum over pixels of colour distances, 1 for a pixel at full scale.
    error = difference.GetThresholdedError() / pixels
    return check(error <= threshold, f"{picture} differs from its baseline by {error:.4f} of full scale")
