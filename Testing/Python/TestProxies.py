# SPDX-License-Identifier: GPL-3.0-or-later
"""Every proxy of every XML of the plugin can be created, and it and its properties are documented.

A wrong `command` or class name in an XML shows only when the proxy is made, so make each once.
"""
import glob
import os
import xml.etree.ElementTree as ET

import contourtesting as ct

simple = ct.load_plugin()
from paraview import servermanager
from paraview.modules.vtkRemotingServerManager import vtkSMOrderedPropertyIterator



def panel_of(made):
    """The properties that a panel shows before its gear is pressed, in their order."""
    each = vtkSMOrderedPropertyIterator()
    each.SetProxy(made)
    each.Begin()
    names = []
    while not each.IsAtEnd():
        if each.GetProperty().GetPanelVisibility() == "default":
            names.append(each.GetKey())
        each.Next()
    return names


manager = servermanager.ProxyManager().SMProxyManager

files = sorted(glob.glob(os.path.join(ct.SOURCE, "Plugin", "*.xml")))
ct.check(len(files) > 0, "the plugin has server manager XML files")
for path in files:
    name = os.path.basename(path)
    for group in ET.parse(path).getroot().iter("ProxyGroup"):
        for element in group:
            if not element.tag.endswith("Proxy"):
                continue
            proxy_name = element.get("name")
            where = f"{name}: {proxy_name}"
            if group.get("name") == "contour_bases":
                # Parts of nodes, not nodes; what they bring is documented all the same.
                for prop in (part for part in element if part.tag.endswith("Property")):
                    words = prop.findtext("Documentation")
                    ct.check(words and words.strip(), f"{where}.{prop.get('name')} has a documentation")
                continue
            text = element.findtext("Documentation")
            if text is None and element.find("Documentation") is not None:
                text = ""
            doc = element.find("Documentation")
            ct.check(doc is not None and (text or "").strip(), f"{where} has a documentation")
            ct.check(doc is None or doc.get("short_help"), f"{where} has a short_help")
            proxy = manager.NewProxy(group.get("name"), proxy_name)
            if not ct.check(proxy is not None, f"{where} can be created"):
                continue
            proxy.UnRegister(None)
            proxy.UpdateVTKObjects()
            ct.check(proxy.GetVTKClassName() == element.get("class"), f"{where} makes its class")
            ct.check(proxy.GetClientSideObject() is not None, f"{where} makes a VTK object")
            # What it said is not in the way of what is to be chosen.
            shown = panel_of(proxy)
            ct.check("Report" not in shown or shown[-1] == "Report", f"{where} has its Report last: {shown}")
            for prop in element.iter():
                if not prop.tag.endswith("Property") or prop.get("is_internal") == "1":
                    continue
                if prop.get("information_only") == "1" or prop.tag == "Property":
                    continue
                if prop.get("name") is None or prop.get("exposed_name") is not None:
                    continue
                words = prop.findtext("Documentation")
                inherited = element.get("base_proxyname") and len(prop) == 0
                ct.check(inherited or (words and words.strip()), f"{where}.{prop.get('name')} has a documentation")
                ct.check(proxy.GetProperty(prop.get("name")) is not None,
                         f"{where}.{prop.get('name')} exists")
ct.finish()
