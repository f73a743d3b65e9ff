// SPDX-License-Identifier: GPL-3.0-or-later
#include "PipelineBefore.h"

#include "vtkSmartPointer.h"
#include "vtkSMInputProperty.h"
#include "vtkSMPropertyIterator.h"
#include "vtkSMProxy.h"

#include <deque>
#include <set>

namespace
{
void AddInputs(vtkSMProxy* proxy, std::deque<vtkSMProxy*>& waiting)
{
  const auto property = vtk::TakeSmartPointer(proxy->NewPropertyIterator());
  for (property->Begin(); !property->IsAtEnd(); property->Next())
  {
    auto* input = vtkSMInputProperty::SafeDownCast(property->GetProperty());
    for (unsigned int i = 0; input && i < input->GetNumberOfProxies(); ++i)
    {
      waiting.push_back(input->GetProxy(i));
    }
  }
}
}

vtkSMProxy* FindBefore(vtkSMProxy* proxy, const std::function<bool(vtkSMProxy*)>& isAskedFor)
{
  std::deque<vtkSMProxy*> waiting;
  std::set<vtkSMProxy*> seen;
  AddInputs(proxy, waiting);
  // Ends, as each node is looked at once.
  while (!waiting.empty())
  {
    vtkSMProxy* next = waiting.front();
    waiting.pop_front();
    if (!next || !seen.insert(next).second)
    {
      continue;
    }
    if (isAskedFor(next))
    {
      return next;
    }
    AddInputs(next, waiting);
  }
  return nullptr;
}
