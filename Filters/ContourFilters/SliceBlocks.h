// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SliceBlocks.h
 * @brief Collections whose blocks are the slices of one object, as many of ParaView's readers give.
 */
#ifndef SliceBlocks_h
#define SliceBlocks_h

#include "vtkSmartPointer.h"

#include <vector>

class vtkDataObject;
class vtkPolyData;

namespace recon
{
/**
 * The blocks with cells, in order, where there are two or more, each of which lies in a plane, and
 * none is a region of its own (an ROI of a structure set, a material): then they are slices of one
 * object. Otherwise none.
 */
std::vector<vtkPolyData*> FindSliceBlocks(vtkDataObject* object);

/// The same, also where there is one only: of slices that several ranks have.
std::vector<vtkPolyData*> FindFlatBlocks(vtkDataObject* object);

/// All of them as one, in double precision.
vtkSmartPointer<vtkPolyData> JoinBlocks(const std::vector<vtkPolyData*>& blocks);
}

#endif
