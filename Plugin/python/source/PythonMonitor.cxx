// SPDX-License-Identifier: GPL-3.0-or-later
#include "PythonMonitor.h"

namespace recon
{
namespace
{
/// Long enough to cost nothing, short enough that Ctrl-C feels immediate.
constexpr std::chrono::milliseconds Interval(50);
}

void PythonMonitor::OnProgress(double fraction, const char* stage)
{
  const auto now = std::chrono::steady_clock::now();
  if (now < this->Next)
  {
    return;
  }
  this->Next = now + Interval;
  const nb::gil_scoped_acquire locked;
  if (PyErr_CheckSignals() != 0)
  {
    throw nb::python_error();
  }
  if (this->Progress.is_none())
  {
    return;
  }
  const nb::object answer = this->Progress(fraction, stage);
  if (answer.ptr() == Py_False)
  {
    throw Aborted();
  }
}
}
