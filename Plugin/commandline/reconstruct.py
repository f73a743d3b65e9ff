# SPDX-License-Identifier: GPL-3.0-or-later
"""Contours to closed surfaces on the command line; run it as `./run reconstruct` or `contour-reconstruct`.

This part needs no ParaView, so that help comes at once: one file is handed to pvpython, several to a cohort of them.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import contouroptions
from contourchecks import check_call
from contourcohort import HERE, Cohort, pvpython


def hand_over(arguments):
    """Become the process that does one file."""
    command = pvpython() + [os.path.join(HERE, "contourworker.py")] + arguments
    try:
        os.execvp(command[0], command)
    except OSError as error:
        raise contouroptions.UsageError(f"{command[0]} cannot be run ({error.strerror}): install ParaView 5.11, or put its "
                                        "bin folder into PATH.")


def main(arguments):
    options = contouroptions.parse(arguments)
    try:
        if options.list:
            hand_over(arguments)
        check_call(options)
        if not options.many:
            hand_over(arguments)
        cohort = Cohort(options, arguments)
        cohort.run()
        return cohort.tell()
    except contouroptions.UsageError as error:
        print(f"contour-reconstruct: {error}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
