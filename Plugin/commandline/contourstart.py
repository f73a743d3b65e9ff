# SPDX-License-Identifier: GPL-3.0-or-later
"""ParaView's simple module, started without the help texts of its functions.

paraview.simple makes a function of every node, and goes through the definitions of all nodes once for each, only to find
its help text: more than half of what a small surface takes. The command line shows none of them.
"""
from paraview import servermanager

_nodes = getattr(servermanager, "ProxyNamespace", None)  # not in every version
if hasattr(_nodes, "getDocumentation"):
    _nodes.getDocumentation = lambda self, name: ""

from paraview import simple  # noqa: E402,F401
