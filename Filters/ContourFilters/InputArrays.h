// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file InputArrays.h
 * @brief What the input knew about its cells and itself stays with the contours.
 */
#ifndef InputArrays_h
#define InputArrays_h

#include "Contours/ContourSet.h"

class vtkPolyData;

namespace recon
{
/// Cell arrays of the input, for the cell that each contour came from; own arrays are not replaced.
void PassCellData(const ContourSet& set, vtkPolyData* input, vtkPolyData* output);

/// Field data of the input; own arrays are not replaced.
void PassInputFieldData(vtkPolyData* input, vtkPolyData* output);
}

#endif
