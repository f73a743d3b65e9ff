# SPDX-License-Identifier: GPL-3.0-or-later
"""The part of the command line that runs in pvpython: one file with words for people, or task after task of a cohort.

    pvpython contourworker.py ARGUMENTS...     one file, or --list
    pvpython contourworker.py --tasks          a JSON line a task on standard input, one an outcome on standard output
"""
import signal

for number in (signal.SIGINT, signal.SIGTERM):
    signal.signal(number, signal.SIG_DFL)  # Ctrl-C ends it, without the stack of whatever library it is in
import json
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import contourcli as cli
import contouroptions
from contourchecks import check_call
from contoursummary import write_files
from contourtask import Task, list_all, outcome
from contourstart import simple


def forget_nodes():
    """Whatever a task has left in the pipeline."""
    for node in list(simple.GetSources().values()):
        simple.Delete(node)


def serve():
    """Outcomes have standard output to themselves; what libraries print goes to standard error."""
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)
    cli.load_plugin()
    for line in os.fdopen(os.dup(0), encoding="utf-8"):  # sys.stdin is pvpython's own, and gives no lines
        task = json.loads(line)
        options = contouroptions.parse(task["Arguments"])
        answers.write(json.dumps(outcome(Task(options, task["Input"], task["Output"], quiet=True))) + "\n")
        answers.flush()
        forget_nodes()


def one(options):
    if options.list:
        failed = list_all(options)
        if failed:
            raise cli.CommandError("; ".join(failed))
        return
    check_call(options)
    task = Task(options, options.inputs[0], options.output)
    task.check()
    cli.load_plugin()
    found = outcome(task)
    write_files(options, [found])
    if found["Error"]:
        raise cli.CommandError(found["Error"])


def main():
    if sys.argv[1:] == ["--tasks"]:
        serve()
        return 0
    options = contouroptions.parse(sys.argv[1:])
    try:
        one(options)
    except contouroptions.UsageError as error:
        print(f"contour-reconstruct: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    code = main()
    sys.stdout.flush()
    sys.exit(code)
