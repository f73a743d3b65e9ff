# SPDX-License-Identifier: GPL-3.0-or-later
"""Write the bash completion of contour-reconstruct, made of the parser that its help is made of.

    python3 completion.py > contour-reconstruct
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import contouroptions

SCRIPT = """\
# bash completion of contour-reconstruct; made of its options.
_contour_reconstruct()
{{
  local word="${{COMP_WORDS[COMP_CWORD]}}" before="${{COMP_WORDS[COMP_CWORD - 1]}}"
  case "$before" in
{cases}
  esac
  if [[ "$word" == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W '{options}' -- "$word")
    return
  fi
  compopt -o filenames
  mapfile -t COMPREPLY < <(compgen -d -- "$word"; compgen -f -X '!*@({formats})' -- "$word")
}}
complete -F _contour_reconstruct contour-reconstruct
"""


def case(action):
    """What may follow an option: one of its choices, any file, or nothing that is known here."""
    names = "|".join(action.option_strings)
    if action.choices:
        words = " ".join(action.choices)
        return f"    {names}) mapfile -t COMPREPLY < <(compgen -W '{words}' -- \"$word\"); return ;;"
    if action.metavar and "FILE" in action.metavar:
        return f"    {names}) compopt -o filenames; mapfile -t COMPREPLY < <(compgen -f -- \"$word\"); return ;;"
    return f"    {names}) return ;;"


def script():
    actions = [action for action in contouroptions.make_parser()._actions if action.option_strings]
    takers = [action for action in actions if action.nargs != 0]
    formats = sorted({*contouroptions.READERS, *contouroptions.PARAVIEW_FORMATS, *contouroptions.SURFACE_FORMATS})
    return SCRIPT.format(cases="\n".join(case(action) for action in takers), formats="|".join(formats),
                         options=" ".join(name for action in actions for name in action.option_strings))


if __name__ == "__main__":
    sys.stdout.write(script())
