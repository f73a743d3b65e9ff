# SPDX-License-Identifier: GPL-3.0-or-later
"""The ground of the command line tools: one kind of failure, the plugin, nodes that are watched while they run.

Runs in pvpython with the plugin's path in CONTOUR_PLUGIN. Every failure is a CommandError whose text is
one sentence for the user.
"""
import contextlib
import os
import re
import signal
import sys
import time

from contourstart import simple

from contouroptions import UsageError


class CommandError(UsageError):
    """One sentence for the user."""


class NothingToDo(CommandError):
    """A region of which nothing can be made, through no fault of its own; no failure."""


class Notes:
    """What the user should know though all went on: sentences on standard error, or kept for a summary, or both."""

    printed = True
    said = []

    @classmethod
    @contextlib.contextmanager
    def kept(cls, printed):
        """The notes of a task are in the list that this gives."""
        before, cls.said, cls.printed = (cls.said, cls.printed), [], printed
        try:
            yield cls.said
        finally:
            cls.said, cls.printed = before


def note(sentence):
    Notes.said.append(sentence)
    if Notes.printed:
        print("Note: " + sentence, file=sys.stderr)


@contextlib.contextmanager
def uninterrupted():
    """Ctrl-C and an end from outside wait until this is over: nothing half done stays behind."""
    caught = []
    before = {number: signal.signal(number, lambda seen, _: caught.append(seen)) for number in (signal.SIGINT, signal.SIGTERM)}
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler or signal.SIG_DFL)  # None: one that is not Python's
        if caught:
            os.kill(os.getpid(), caught[0])


def load_plugin():
    """Load the plugin named by CONTOUR_PLUGIN; its nodes are then in paraview.simple."""
    path = os.environ.get("CONTOUR_PLUGIN", "")
    if not os.path.exists(path):
        raise CommandError(f"The plugin is not at '{path}': build it with ./run build, or set CONTOUR_PLUGIN.")
    try:
        simple.LoadPlugin(path, remote=False, ns=simple.__dict__)
    except RuntimeError:
        raise CommandError(f"ParaView cannot load the plugin {path}; it must be built against this ParaView.")


class ProgressBar:
    """A bar on standard error where that is a terminal, nothing otherwise."""

    def __init__(self, title):
        self.title = title
        self.shown = os.isatty(2)  # pvpython's sys.stderr never says so

    def update(self, fraction, stage):
        if not self.shown:
            return
        width = 30
        filled = int(round(width * min(max(fraction, 0.0), 1.0)))
        bar = "#" * filled + "." * (width - filled)
        sys.stderr.write(f"\r\x1b[K{self.title} [{bar}] {100 * fraction:3.0f}% {stage or ''}"[:160])
        sys.stderr.flush()

    def clear(self):
        if self.shown:
            sys.stderr.write("\r\x1b[K")
            sys.stderr.flush()


def _sentence(message):
    """The text of a VTK error without file, line and object."""
    text = message.strip()
    match = re.search(r"\(0x[0-9a-fA-F]+\): (.*)", text, re.DOTALL)
    return " ".join((match.group(1) if match else text).split())


class Watched:
    """Collects the errors of an algorithm, which pvpython raises nothing for, and shows its progress."""

    def __init__(self, algorithm, bar=None):
        self.errors = []
        self.warnings = []
        self.tags = []

        def on_error(_, __, message):
            self.errors.append(_sentence(message))

        on_error.CallDataType = "string0"

        def on_warning(_, __, message):
            self.warnings.append(_sentence(message))

        on_warning.CallDataType = "string0"

        def on_executive_error(_, __, message):
            # What the executive itself finds: an input of another type, none at all.
            if not self.errors:
                self.errors.append(_sentence(message))

        on_executive_error.CallDataType = "string0"
        self._observe(algorithm, "ErrorEvent", on_error)
        self._observe(algorithm, "WarningEvent", on_warning)
        executive = algorithm.GetExecutive() if hasattr(algorithm, "GetExecutive") else None
        if executive is not None:
            self._observe(executive, "ErrorEvent", on_executive_error)
        if bar is not None:
            self._observe(algorithm, "ProgressEvent",
                          lambda source, _: bar.update(source.GetProgress(), source.GetProgressText()))

    def _observe(self, target, event, function):
        self.tags.append((target, target.AddObserver(event, function)))

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for target, tag in self.tags:
            target.RemoveObserver(tag)

    def check(self):
        if self.errors:
            raise CommandError(self.errors[0])
        for warning in self.warnings:
            note(warning)


def run_proxy(proxy, bar=None):
    """Bring a source or filter up to date; its errors become a CommandError. Returns seconds."""
    start = time.perf_counter()
    with Watched(proxy.GetClientSideObject(), bar) as watched:
        proxy.UpdatePipeline()
        watched.check()
    return time.perf_counter() - start


def new_node(name, **arguments):
    if not hasattr(simple, name):
        raise CommandError(f"This build of the plugin has no node {name}.")
    return getattr(simple, name)(**arguments)


def as_source(data):
    producer = simple.PVTrivialProducer()
    producer.GetClientSideObject().SetOutput(data)
    producer.UpdatePipeline()
    return producer


def detached(data):
    copy = data.NewInstance()
    copy.ShallowCopy(data)
    return copy


def strings(data, name):
    array = data.GetFieldData().GetAbstractArray(name)
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())] if array else []


def values(data, name):
    array = data.GetFieldData().GetArray(name)
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())] if array else []
