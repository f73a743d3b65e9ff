// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file PipelineBefore.h
 * @brief What comes before a node in the pipeline.
 */
#ifndef PipelineBefore_h
#define PipelineBefore_h

#include <functional>

class vtkSMProxy;

/// The nearest node before this one, along any of its inputs, that is asked for; nullptr for none.
vtkSMProxy* FindBefore(vtkSMProxy* proxy, const std::function<bool(vtkSMProxy*)>& isAskedFor);

#endif
