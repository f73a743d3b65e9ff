# SPDX-License-Identifier: GPL-3.0-or-later
"""A file that is written beside its name and renamed when it is whole. Needs no ParaView."""
import contextlib
import errno
import os
import secrets


@contextlib.contextmanager
def replaced(path):
    """Gives a name of the same ending to write to, which no other writer has. Where all goes well it becomes path, else it is
    gone, and what was there under path stays."""
    folder, name = os.path.split(os.path.realpath(path))  # of a link, what it points to is replaced
    if os.path.exists(path) and not os.path.isfile(path):
        raise OSError(errno.EINVAL, "it is a folder or a device, not a file")
    part = os.path.join(folder, f".{name}.{secrets.token_hex(4)}.part{os.path.splitext(name)[1]}")
    try:
        yield part
        os.replace(part, os.path.join(folder, name))
    finally:
        with contextlib.suppress(FileNotFoundError):
            os.remove(part)
