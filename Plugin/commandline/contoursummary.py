# SPDX-License-Identifier: GPL-3.0-or-later
"""What became of the files of a call, as a table and as JSON. Needs no ParaView."""
import json
import math
import os

from contouroptions import NO_CERTIFICATE, UsageError
from contourreplaced import replaced
from contourtable import format_table, quantity, volume, yes

PRIVATE = ("Certificates", "SettingIsWrong")


def without_nan(value):
    """The same with None for what is no number, which JSON has no word for."""
    if isinstance(value, dict):
        return {name: without_nan(inner) for name, inner in value.items()}
    if isinstance(value, list):
        return [without_nan(inner) for inner in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def write_json(path, content):
    """A whole file or none."""
    try:
        with replaced(path) as part, open(part, "w", encoding="utf-8") as file:
            json.dump(without_nan(content), file, indent=2, allow_nan=False)
            file.write("\n")
    except OSError as error:
        raise UsageError(f"{path} could not be written: {error.strerror}.")


def count(outcomes, status):
    return sum(outcome["Status"] == status for outcome in outcomes)


def summary(outcomes):
    """The outcomes as they are told to programs."""
    return {"Files": len(outcomes), "Done": count(outcomes, "done"), "Nothing": count(outcomes, "nothing"),
            "Failed": count(outcomes, "failed"), "NotTried": count(outcomes, "not tried"),
            "Outcomes": [{name: value for name, value in outcome.items() if name not in PRIVATE} for outcome in outcomes]}


def write_files(options, outcomes, by_file=False):
    """The certificates and the summary, where they are asked for."""
    found = {outcome["File"]: outcome["Certificates"] for outcome in outcomes if outcome.get("Certificates")}
    if found and options.certificate not in (None, NO_CERTIFICATE):
        write_json(options.certificate, found if by_file else next(iter(found.values())))
        print("Written: " + options.certificate)
    if options.summary:
        write_json(options.summary, summary(outcomes))
        print("Written: " + options.summary)


def short_names(paths):
    """Paths without the folder that all of them are in."""
    if len(paths) < 2:
        return {path: os.path.basename(path) for path in paths}
    common = os.path.commonpath([os.path.dirname(os.path.abspath(path)) for path in paths])
    return {path: os.path.relpath(os.path.abspath(path), common) for path in paths}


def _row(name, region):
    size, unit = volume(region.get("Volume"), region.get("Unit"))
    crossings = region.get("CrossingPairs")
    return [name, region["Name"], region.get("Status", "").replace("failed", "FAILED"), region.get("Contours", ""),
            region.get("Triangles", ""), yes(region.get("Closed")), yes(region.get("Manifold")),
            "-" if crossings is None else crossings, "-" if size is None else f"{quantity(size)} {unit}",
            len(region.get("Notes", [])), f"{region.get('Seconds', 0):.2f}"]


def table(outcomes):
    """A row a region of each file; a file that gave none has one as well."""
    titles = ["file", "region", "", "contours", "triangles", "closed", "manifold", "crossings", "volume", "notes", "seconds"]
    names, rows = short_names([outcome["File"] for outcome in outcomes]), []
    for outcome in outcomes:
        regions = outcome["Regions"] or [{"Name": "", "Status": outcome["Status"]}]
        rows += [_row(names[outcome["File"]], region) for region in regions]
    return format_table(rows, titles)
