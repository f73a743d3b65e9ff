# SPDX-License-Identifier: GPL-3.0-or-later
"""--set PROPERTY=VALUE for nodes: names and values are checked against what the nodes themselves say of them."""
import math
import os

from contourstart import simple

from contourcommon import CommandError

# Of the command line itself, or nothing to set.
HIDDEN = ("Input", "Contours", "Planes", "FileName", "FileNames", "ReferenceFileName", "ROIs", "ROIsInfo", "Report")
YES_NO = {"on": 1, "true": 1, "yes": 1, "1": 1, "off": 0, "false": 0, "no": 0, "0": 0}


class SettingError(CommandError):
    """A setting that is wrong for every region alike."""


def settable(proxy):
    """Names of the properties of a node that --set takes."""
    return [name for name in proxy.ListProperties() if name not in HIDDEN]


def describe(proxy):
    """A line a property: its name, its value, and what it takes."""
    lines = []
    for name in settable(proxy):
        inner = proxy.GetProperty(name).SMProperty
        choice = _domain(inner, "vtkSMEnumerationDomain")
        if inner.IsA("vtkSMInputProperty"):
            lines.append(f"{name}: a .csv file")
            continue
        if choice is not None:
            takes = ", ".join(choice.GetEntryText(i) for i in range(choice.GetNumberOfEntries()))
        elif _domain(inner, "vtkSMBooleanDomain") is not None:
            takes = "on or off"
        elif inner.IsA("vtkSMStringVectorProperty"):
            takes = "text"
        else:
            takes = _range_words(inner, 0, not inner.IsA("vtkSMDoubleVectorProperty"))
        value = str(proxy.GetPropertyValue(name)).strip("'")
        lines.append(f"{name} = {value}: {takes}")
    return lines


def apply_settings(proxies, settings):
    """settings: list of PROPERTY=VALUE, each for those of the proxies that have it."""
    for setting in settings:
        name, equals, value = setting.partition("=")
        if not equals:
            raise SettingError(f"--set {setting}: write PROPERTY=VALUE.")
        having = [(proxy, known) for proxy in proxies for known in settable(proxy)
                  if _plain(known) == _plain(name)]
        if not having:
            raise SettingError("; ".join(f"{proxy.GetXMLLabel()} has no property '{name}'; it has: "
                                         f"{', '.join(settable(proxy))}" for proxy in proxies) + ".")
        for proxy, known in having:
            _set(proxy, known, value, setting)


def _plain(word):
    """Case, spaces, hyphens and underscores do not count."""
    return "".join(letter for letter in word.casefold() if letter not in " -_")


def _set(proxy, name, value, setting):
    wrapped = proxy.GetProperty(name)
    inner = wrapped.SMProperty
    if inner.IsA("vtkSMInputProperty"):
        setattr(proxy, name, _table(value, setting))
        return
    words = [word.strip() for word in value.split(",")] if value.strip() else []
    numbers = [_value(name, inner, i, word, setting) for i, word in enumerate(words)]
    if inner.GetRepeatCommand():
        each = max(1, inner.GetNumberOfElementsPerCommand())
        if len(numbers) % each:
            raise SettingError(f"--set {setting}: {name} takes values by {each}, and here are {len(numbers)}.")
    elif len(numbers) != inner.GetNumberOfElements() and not inner.IsA("vtkSMStringVectorProperty"):
        raise SettingError(f"--set {setting}: {name} takes {_count(inner.GetNumberOfElements(), 'value')}, "
                           f"and here are {len(numbers)}.")
    if inner.IsA("vtkSMStringVectorProperty") and not inner.GetRepeatCommand():
        numbers = [value]
    try:
        setattr(proxy, name, numbers if len(numbers) != 1 or inner.GetRepeatCommand() else numbers[0])
    except (TypeError, ValueError, RuntimeError, AttributeError) as error:
        raise SettingError(f"--set {setting}: {' '.join(str(error).split())}.")


def _count(number, noun):
    return f"{number} {noun}" + ("" if number == 1 else "s")


def _domain(inner, kind):
    """The domain of that class, or None."""
    iterator = inner.NewDomainIterator()
    iterator.Begin()
    found = None
    while not iterator.IsAtEnd():
        if iterator.GetDomain().IsA(kind):
            found = iterator.GetDomain()
        iterator.Next()
    iterator.UnRegister(None)
    return found


def _value(name, inner, index, word, setting):
    """What the word means to the property; a CommandError that lists what is valid where it means nothing."""
    choice = _domain(inner, "vtkSMEnumerationDomain")
    if choice is not None:
        return _entry(name, choice, word, setting)
    if _domain(inner, "vtkSMBooleanDomain") is not None:
        if word.casefold() not in YES_NO:
            raise SettingError(f"--set {setting}: {name} is on or off.")
        return YES_NO[word.casefold()]
    if inner.IsA("vtkSMStringVectorProperty"):
        return word
    whole = not inner.IsA("vtkSMDoubleVectorProperty")
    number = _number(word, whole)
    if number is None:
        raise SettingError(f"--set {setting}: '{word}' is no {'whole number' if whole else 'number'}, and {name} "
                           f"takes {_range_words(inner, index, whole)}.")
    low, high = _range(inner, index)
    if (low is not None and not number >= low) or (high is not None and not number <= high):
        raise SettingError(f"--set {setting}: {name} takes {_range_words(inner, index, whole)}.")
    return number


def _entry(name, choice, word, setting):
    entries = [(choice.GetEntryText(i), choice.GetEntryValue(i)) for i in range(choice.GetNumberOfEntries())]
    for text, number in entries:
        if _plain(text) == _plain(word) or str(number) == word:
            return text
    raise SettingError(f"--set {setting}: {name} is one of {', '.join(text for text, _ in entries)}.")


def _number(word, whole):
    try:
        number = float(word)
    except ValueError:
        return None
    if not whole:
        return number
    return int(number) if math.isfinite(number) and number == int(number) else None


def _range(inner, index):
    """(lowest, highest), None where there is no end."""
    for kind in ("vtkSMIntRangeDomain", "vtkSMDoubleRangeDomain"):
        domain = _domain(inner, kind)
        if domain is not None:
            entry = min(index, max(0, domain.GetNumberOfEntries() - 1)) if hasattr(domain, "GetNumberOfEntries") else 0
            return (domain.GetMinimum(entry) if domain.GetMinimumExists(entry) else None,
                    domain.GetMaximum(entry) if domain.GetMaximumExists(entry) else None)
    return None, None


def _range_words(inner, index, whole):
    low, high = _range(inner, index)
    kind = "whole numbers" if whole else "numbers"
    if low is not None and high is not None:
        return f"{kind} from {low:g} to {high:g}"
    if low is not None:
        return f"{kind} of {low:g} and above"
    return f"{kind} up to {high:g}" if high is not None else kind


def _table(path, setting):
    """A table of overrides out of a .csv file."""
    if not os.path.isfile(path):
        raise SettingError(f"--set {setting}: there is no file {path}; give a .csv file with a header.")
    reader = simple.CSVReader(FileName=[path])
    reader.UpdatePipeline()
    return reader
