# SPDX-License-Identifier: GPL-3.0-or-later
"""Contour Mapping as a node: groups, the table of joins, overrides of both kinds, and what keeps them.

The data is the project's branching pipe: contour 0, then 1 and 2 above it, and so on.
"""
import contourtesting as ct

simple = ct.load_plugin()
from vtkmodules.vtkCommonDataModel import vtkPolyData

COLUMNS = ["Slab", "LowerContour", "UpperContour", "LowerContours", "UpperContours", "OverlapArea",
           "LowerRatio", "UpperRatio", "Solid", "Rule", "Joined", "Words", "Decision"]
PIPE = ct.own("branching_pipe.cnt")


def rows(mapping):
    """The joins as dictionaries."""
    ct.data(mapping)
    table = mapping.GetClientSideObject().GetOutputDataObject(1)
    ct.check([table.GetColumnName(c) for c in range(table.GetNumberOfColumns())] == COLUMNS,
             "the table has its columns")
    return [{name: table.GetValueByName(r, name).ToString() for name in COLUMNS}
            for r in range(table.GetNumberOfRows())]


def row(mapping, lower, upper):
    found = [r for r in rows(mapping)
             if (r["LowerContour"], r["UpperContour"]) == (str(lower), str(upper))]
    ct.check(len(found) <= 1, f"{lower} and {upper} are decided once")
    return found[0] if found else None


def column(data, name):
    array = data.GetCellData().GetArray(name)
    return [array.GetTuple1(i) for i in range(array.GetNumberOfTuples())]


def report(data):
    array = data.GetFieldData().GetAbstractArray("Report")
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())] if array else []


def check_overrides_hold(mapping, what):
    """1 forced onto the other branch's 4, and 0 cut off from 2."""
    forced = row(mapping, 1, 4)
    ct.check(forced and forced["Rule"] == "Forced" and forced["Joined"] == "1",
             f"{what}: the forced join is there")
    forbidden = row(mapping, 0, 2)
    ct.check(forbidden and forbidden["Rule"] == "Forbidden" and forbidden["Joined"] == "0",
             f"{what}: the forbidden join is not made")


# By overlap alone.
reader = simple.NUAGESContourReader(FileName=PIPE)
hierarchy = simple.ContourHierarchy(Input=reader)
mapping = simple.ContourMapping(Input=hierarchy)
out = ct.data(mapping)
ct.check(column(out, "ContourId") == column(ct.data(hierarchy), "ContourId"),
         "contours keep the numbers that Contour Hierarchy gave them")
ct.check(all(abs(a - b) < 1e-12 for a, b in
             zip(column(out, "SignedArea"), column(ct.data(hierarchy), "SignedArea"))),
         "and are the same")
first = row(mapping, 0, 1)
ct.check(first["Joined"] == "1" and first["Rule"] == "Overlap", "a branch overlaps the stem")
ct.check(first["Words"].startswith("Contour 0 (z = 0) is joined to contour 1 (z = 5): they share "),
         "in words: " + first["Words"])
ct.check(0.1 < float(first["UpperRatio"]) < 1 and float(first["OverlapArea"]) > 0, "with figures")
ct.check(row(mapping, 1, 4) is None, "branches that do not overlap have nothing to decide")
below, above = column(out, "MappingGroupBelow"), column(out, "MappingGroupAbove")
ct.check(above[0] == below[1] == below[2] == 0, "the stem and both branches are one group")
ct.check(below[0] == -1 and above[-1] == -1, "outside of the stack there are no groups")
ct.check(above[1] != above[2], "further up the branches are groups of their own")
groups = sorted(set(below + above) - {-1})
ct.check(groups == list(range(len(groups))), "groups are numbered without gaps")

# Properties.
mapping.ForcedJoins = [4, 1]
mapping.ForbiddenJoins = [0, 2]
check_overrides_hold(mapping, "properties")
out = ct.data(mapping)
ct.check(column(out, "MappingGroupBelow")[2] != column(out, "MappingGroupAbove")[0],
         "a forbidden branch is in another group than the stem")
mapping.ForcedJoins = [0, 99]
ct.check(len([r for r in report(ct.data(mapping)) if "there is no contour 99" in r]) == 1,
         "an override of a contour that is not there is reported")
mapping.ForcedJoins = [4, 1]



def has_overrides(script):
    """Whether a script sets both, as attributes or, as ParaView 6 writes it, as arguments."""
    plain = script.replace(" = [", "=[")
    return "ForcedJoins=[4, 1]" in plain and "ForbiddenJoins=[0, 2]" in plain


# A saved state, and the same as Python.
state = ct.output("TestContourMapping.pvsm")
simple.SaveState(state)
from paraview import smstate
text = smstate.get_state()
ct.check(has_overrides(text), "a Python state has the overrides")
simple.ResetSession()
simple = ct.load_plugin()
simple.LoadState(state)
restored = [p for (name, _), p in simple.GetSources().items() if name.startswith("ContourMapping")]
ct.check(len(restored) == 1, "the state brings the node back")
ct.check(list(restored[0].ForcedJoins) == [4, 1] and list(restored[0].ForbiddenJoins) == [0, 2],
         "with its overrides")
check_overrides_hold(restored[0], "state file")

# A Python trace, played back.
simple.ResetSession()
simple = ct.load_plugin()
from paraview import smtrace
smtrace.start_trace()
reader = simple.NUAGESContourReader(FileName=PIPE)
simple.ContourMapping(Input=reader, ForcedJoins=[4, 1], ForbiddenJoins=[0, 2])
trace = smtrace.stop_trace()
ct.check(has_overrides(trace), "a trace has the overrides")
simple.ResetSession()
simple = ct.load_plugin()
names = {}
exec(trace, names)
played = [p for (name, _), p in simple.GetSources().items() if name.startswith("ContourMapping")]
ct.check(len(played) == 1, "the trace makes the node")
check_overrides_hold(played[0], "trace")

# A table of overrides from a CSV file, columns in any order and one more.
path = ct.output("TestContourMappingOverrides.csv")
with open(path, "w") as file:
    file.write("Join,Why,LowerContour,UpperContour\n1,seen on MR,1,4\n0,artefact,0,2\n,undecided,2,3\n"
               "1,no partner,3,-1\n")
reader = simple.NUAGESContourReader(FileName=PIPE)
table = simple.CSVReader(FileName=[path])
mapping = simple.ContourMapping(Input=reader, Overrides=table)
check_overrides_hold(mapping, "table")
ct.check(report(ct.data(mapping)) == [], "rows that ask for nothing are no trouble")

# Both: properties and table.
mapping.ForbiddenJoins = [1, 4]
ct.check(row(mapping, 1, 4)["Rule"] == "Forbidden", "forbidding wins over the table's force")
ct.check(any("both forced and forbidden" in r for r in report(ct.data(mapping))), "and is reported")
mapping.Overrides = None
mapping.ForbiddenJoins = []
ct.check(row(mapping, 1, 4) is None, "without the table and the property nothing is left of them")

# Tables that are none.
for content, words in (("Lower,Upper\n1,4\n", "has no column LowerContour"),
                       ("LowerContour,UpperContour,Join\n1,4,2\n", "give 1 to force and 0 to forbid"),
                       ("LowerContour,UpperContour,Join\n1,four,1\n", "is no whole number"),
                       ("LowerContour,UpperContour,Join\n1,4.5,1\n", "is no whole number")):
    with open(path, "w") as file:
        file.write(content)
    bad = simple.ContourMapping(Input=reader, Overrides=simple.CSVReader(FileName=[path]))
    said = ct.errors_of(lambda: bad.UpdatePipeline())
    ct.check(words in said, f"'{words}' is said of a wrong table, not: {said}")
    ct.check(bad.GetClientSideObject().GetOutputDataObject(0).GetNumberOfCells() == 0,
             "and nothing comes out")

# A region of interest without contours.
empty = simple.TrivialProducer()
empty.GetClientSideObject().SetOutput(vtkPolyData())
mapping = simple.ContourMapping(Input=empty)
ct.check(ct.data(mapping).GetNumberOfCells() == 0 and rows(mapping) == [], "no contours, no joins")

# A collection: every region of interest by itself.
collection = simple.GroupDatasets(Input=[reader, simple.Transform(Input=reader)])
mapping = simple.ContourMapping(Input=collection)
out = ct.data(mapping)
joins = mapping.GetClientSideObject().GetOutputDataObject(1)
ct.check(out.GetNumberOfBlocks() == 2 and joins.GetNumberOfBlocks() == 2,
         "a collection gives contours and joins a region of interest")
ct.check(joins.GetBlock(0).GetNumberOfRows() == joins.GetBlock(1).GetNumberOfRows() > 0,
         "each with its rows")
ct.finish()
