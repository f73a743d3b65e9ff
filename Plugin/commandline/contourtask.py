# SPDX-License-Identifier: GPL-3.0-or-later
"""One file of the command line, from its contours to what is written and known of them."""
import contextlib

import contourcli as cli
from contourchecks import checked_reference, parse_offset
from contourconvert import write_contours
from contouroptions import NO_CERTIFICATE, UsageError, is_contours


def reading_of(options):
    """What the options tell of how files are to be read."""
    return {"unit": options.unit, "spacing": options.spacing, "pixel": options.pixel,
            "drawings": options.inputs if options.stack else None}


class Task:
    """A file and what becomes of it; what goes on is printed unless it is to be quiet."""

    def __init__(self, options, path, output, quiet=False):
        self.options = options
        self.path = path
        self.output = output
        self.quiet = quiet
        self.regions = []       # dictionaries, see figures()
        self.certificates = {}  # by region
        self.reference = None

    def say(self, sentence):
        if not self.quiet:
            print(sentence)

    def check(self):
        """What can be said before any work."""
        self.reference = checked_reference(self.options, self.path, self.output)

    def run(self):
        """Do it all. What fails is raised at the end, after everything that could be done."""
        self.check()
        blocks, reading = cli.read_contours(self.path, self.options.roi, **reading_of(self.options))
        filled = [block for block in blocks if not block.nothing]
        for block in blocks:
            if block.nothing:
                self._nothing(block, block.nothing, f"{block.name}: {block.nothing}, nothing to do.")
        if not filled:
            if any(block.nothing != "no contours" for block in blocks):
                return  # points and open contours, which are nothing to be reconstructed
            raise cli.CommandError(f"{self.path} holds no contours.")
        if is_contours(self.output):
            self._write_contours(filled)
        elif self.reference:
            self._write_structure_set(filled)
        else:
            self._write_surfaces(filled, reading)

    def _nothing(self, block, why, sentence):
        self.regions.append({"Name": block.name, "Status": "nothing", "Error": str(why)})
        self.say(sentence)

    @contextlib.contextmanager
    def _attempt(self, block, failures):
        """A progress bar while a region is worked on; what goes wrong with it is noted, and the others go on."""
        bar = cli.ProgressBar(block.name)
        if self.quiet:
            bar.shown = False
        try:
            yield bar
        except cli.SettingError:
            raise
        except cli.NothingToDo as reason:
            bar.clear()
            self._nothing(block, reason, f"{block.name}: nothing to do: {reason}")
        except cli.CommandError as error:
            failures.add(block.name, error)
            self.regions.append({"Name": block.name, "Status": "failed", "Error": failures.found[-1][1]})
        finally:
            bar.clear()

    def _write_contours(self, blocks):
        failures, rows, files = Failures(len(blocks), "file of contours"), [], []
        for block, path, contours, error in write_contours(self.output, blocks):
            if error:
                failures.add(block.name, error)
                self.regions.append({"Name": block.name, "Status": "failed", "Error": failures.found[-1][1]})
                continue
            rows.append([block.name, contours, block.data.GetNumberOfPoints()])
            files += [path] if path not in files else []
            self.regions.append({"Name": block.name, "Status": "done", "Output": path, "ContoursWritten": contours})
        if rows:
            self.say(cli.format_table(rows, ["", "contours", "points"]))
            self.say("\nWritten: " + ", ".join(files))
        failures.check()

    def _write_structure_set(self, blocks):
        options = self.options
        writer = cli.StructureSetWriter(self.output, self.reference, options.settings, options.extrapolate)
        failures = Failures(len(blocks), "contours")
        for block in blocks:
            with self._attempt(block, failures) as bar:
                writer.trace(block, bar)
        if writer.traced:
            writer.write()
            for name, drawn, written, slices, seconds in writer.rows:
                self.regions.append({"Name": name, "Status": "done", "Output": self.output, "Contours": drawn,
                                     "ContoursWritten": written, "Slices": slices, "Seconds": float(seconds)})
            self.say(cli.format_table(writer.rows, ["", "contours drawn", "written", "slices", "seconds"]))
            self.say("\nWritten: " + self.output)
        failures.check()

    def _write_surfaces(self, blocks, reading):
        options = self.options
        results, files, writing = [], [], 0.0
        failures = Failures(len(blocks), "surface")
        offset = parse_offset(options.offset)
        settings = cli.settings_for(self.output, options.method, options.settings)
        for block, path in zip(blocks, cli.output_paths(self.output, blocks)):
            with self._attempt(block, failures) as bar:
                result = cli.reconstruct(block, options.method, settings, bar, options.certificate != NO_CERTIFICATE)
                bar.clear()
                writing += cli.write_surface(path, result, offset)
                results.append(result)
                files.append(path)
                self.regions.append({"Status": "done", "Output": path, "Unit": block.unit, **cli.figures(result)})
                if result.certificate:
                    self.certificates[result.name] = result.certificate["JSON"]
        if results and not self.quiet:
            cli.print_results(results, [("read", reading), ("write", writing)])
            print("\nWritten: " + ", ".join(files))
        failures.check()


class Failures:
    """What could not be done, a region each; the others are done all the same."""

    def __init__(self, count, what):
        self.count = count
        self.what = what
        self.found = []

    def add(self, name, error):
        words = str(error)
        self.found.append((name, words[len(name) + 2:] if words.startswith(name + ": ") else words))

    def check(self):
        if self.found and self.count == 1:
            name, why = self.found[0]
            raise cli.CommandError(f"{name}: {why}")
        if self.found:
            raise cli.CommandError(f"{len(self.found)} of {self.count} ROIs gave no {self.what}: "
                                   + "; ".join(f"{name}: {why}" for name, why in self.found))


def outcome(task):
    """Run a task, and what became of it as a dictionary: Status is done, nothing or failed."""
    with cli.Notes.kept(printed=not task.quiet) as notes:
        error, setting = None, False
        try:
            task.run()
        except UsageError as sentence:
            error, setting = str(sentence), isinstance(sentence, cli.SettingError)
    done = any(region["Status"] == "done" for region in task.regions)
    return {"File": task.path, "Status": "failed" if error else "done" if done else "nothing", "Error": error,
            "Regions": task.regions, "Notes": notes, "Certificates": task.certificates, "SettingIsWrong": setting}


def list_all(options):
    """What --roi and --set may name. The sentences of files that could not be read."""
    cli.load_plugin()
    failed, sample = [], None
    for path in options.inputs:
        try:
            blocks, _ = cli.read_contours(path, options.roi, **reading_of(options))
        except UsageError as error:
            failed.append(str(error))
            continue
        sample = sample or next((block.data for block in blocks if not block.nothing), None)
        rows = [[block.name, 0 if block.data is None else block.data.GetNumberOfCells(), block.nothing] for block in blocks]
        print((f"{path}\n" if len(options.inputs) > 1 else "") + cli.format_table(rows, ["region", "contours", ""]) + "\n")
    if failed and len(failed) == len(options.inputs):
        return failed
    for name in (cli.METHODS[options.method], "SurfaceCertificate"):
        node = cli.new_node(name, **({"Input": cli.as_source(sample)} if sample is not None else {}))
        print(f"{node.GetXMLLabel()}")
        print("\n".join("  " + line for line in cli.describe(node)) + "\n")
    return failed
