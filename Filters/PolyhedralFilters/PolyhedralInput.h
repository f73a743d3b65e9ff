// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file PolyhedralInput.h
 * @brief The same beginning and the same output arrays for every filter of the polyhedral method.
 */
#ifndef PolyhedralInput_h
#define PolyhedralInput_h

#include "ContourConversion.h"
#include "Contours/ContourSetBuilder.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <string>
#include <vector>

namespace recon
{
/**
 * Clean parallel contours of the input. What the input's own Report and ToLoopSoup say comes first
 * in Report, so that nothing an earlier filter left out is forgotten.
 *
 * @throws Error, Aborted
 */
inline ContourSet ReadParallelContours(vtkPolyData* input, Monitor& monitor)
{
  const ConvertedLoops loops = ToLoopSoup(input);
  ContourSet contours = BuildContourSet(loops.Soup, ContourSetOptions(), monitor);
  std::vector<std::string> report = GetReport(input);
  report.insert(report.end(), loops.Report.begin(), loops.Report.end());
  contours.Report.insert(contours.Report.begin(), report.begin(), report.end());
  return contours;
}

/**
 * A region of interest without contours is common in a structure set and must not stop the others:
 * the output is empty and says so, and is not an error.
 *
 * @return whether that was so
 */
inline bool PassEmptyInput(vtkPolyData* input, vtkDataObject* output)
{
  if (input->GetNumberOfCells() > 0)
  {
    return false;
  }
  std::vector<std::string> report = GetReport(input);
  output->GetFieldData()->PassData(input->GetFieldData());
  report.push_back("The input has no contours, so the output is empty.");
  SetReport(report, output);
  return true;
}

/// Field data of the input (name, number and colour of a region of interest) goes along.
/// First thing a filter does, so that its own arrays replace those of the same name.
inline void PassFieldData(vtkPolyData* input, vtkDataObject* output)
{
  output->GetFieldData()->PassData(input->GetFieldData());
}

/// A named array of ints, one a value; Values is any container of something that an int can hold.
template <typename Values>
void AddIntArray(vtkFieldData* data, const char* name, const Values& values)
{
  vtkNew<vtkIntArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  vtkIdType i = 0;
  for (const auto& value : values)
  {
    array->SetValue(i++, static_cast<int>(value));
  }
  data->AddArray(array);
}

/// LevelNormal (a tuple of three) and LevelOffset (a value a level) into the field data.
inline void AddLevels(const ContourSet& contours, vtkFieldData* data)
{
  vtkNew<vtkDoubleArray> normal;
  normal->SetName("LevelNormal");
  normal->SetNumberOfComponents(3);
  normal->InsertNextTuple(contours.Levels.front().Frame.Normal.data());
  data->AddArray(normal);
  vtkNew<vtkDoubleArray> offset;
  offset->SetName("LevelOffset");
  for (const Level& level : contours.Levels)
  {
    offset->InsertNextValue(level.Offset);
  }
  data->AddArray(offset);
}
}

#endif
