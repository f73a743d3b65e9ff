// SPDX-License-Identifier: GPL-3.0-or-later
#include "RunCore.h"

#include "Base/Geometry.h"
#include "Base/Monitor.h"
#include "ContourConversion.h"
#include "Pieces.h"
#include "SurfaceSummaries.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cctype>
#include <fstream>

namespace recon
{
namespace
{
void Clear(Outputs outputs)
{
  for (vtkDataObject* output : outputs)
  {
    output->Initialize();
  }
}

bool EndsMeet(vtkPolyData* input, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  input->GetCellPoints(cell, ids);
  const vtkIdType count = ids->GetNumberOfIds();
  if (count < 4)
  {
    return false;
  }
  Point3 first{};
  Point3 last{};
  input->GetPoint(ids->GetId(0), first.data());
  input->GetPoint(ids->GetId(count - 1), last.data());
  return first == last;
}

std::string RegionOf(vtkDataObject* input)
{
  auto* names = vtkStringArray::SafeDownCast(input->GetFieldData()->GetAbstractArray("ROIName"));
  return names && names->GetNumberOfValues() > 0
    ? "Region \"" + std::string(names->GetValue(0)) + "\""
    : std::string("The region");
}

void SayIn(Outputs outputs, vtkDataObject* input, const std::string& sentence)
{
  std::vector<std::string> report = GetReport(input);
  report.push_back(sentence);
  for (vtkDataObject* output : outputs)
  {
    FinishOutput(input, report, output);
  }
}

/// Of a region that another rank works on: its name and colour.
void PassFieldData(vtkDataObject* input, Outputs outputs)
{
  for (vtkDataObject* output : outputs)
  {
    FinishOutput(input, GetReport(input), output);
  }
}

void ClearAndReport(Outputs outputs, const char* sentence)
{
  Clear(outputs);
  for (vtkDataObject* output : outputs)
  {
    SetReport({ sentence }, output);
  }
}

/// Whether there was nothing to work on; the outputs say it then.
bool PassNothing(vtkAlgorithm* filter, vtkDataObject* input, Outputs outputs)
{
  auto* data = vtkPolyData::SafeDownCast(input);
  if (!data)
  {
    return false;
  }
  if (data->GetNumberOfPoints() == 0 && data->GetNumberOfCells() == 0)
  {
    if (OwnerElsewhere(data))
    {
      PassFieldData(data, outputs);
      return true;
    }
    SayIn(outputs, data, "The input is empty, so the output is empty.");
    return true;
  }
  const std::string nothing = NothingOf(data);
  if (!nothing.empty())
  {
    const std::string sentence = RegionOf(data) + " is " + nothing + ": nothing is made of it.";
    SayIn(outputs, data, sentence);
    vtkWarningWithObjectMacro(filter, << sentence);
    return true;
  }
  return false;
}

bool IsMissing(vtkDataObject* input, Outputs outputs)
{
  return !input || std::find(outputs.begin(), outputs.end(), nullptr) != outputs.end();
}
}

std::string NothingOf(vtkPolyData* input)
{
  auto* types =
    vtkStringArray::SafeDownCast(input->GetCellData()->GetAbstractArray("GeometricType"));
  const vtkIdType cells = input->GetNumberOfCells();
  if (!types || cells == 0 || types->GetNumberOfValues() != cells)
  {
    return {};
  }
  bool pointsOnly = true;
  for (vtkIdType i = 0; i < cells; ++i)
  {
    const std::string type = types->GetValue(i);
    const bool isOpen = type == "OPEN_PLANAR" || type == "OPEN_NONPLANAR";
    if ((type != "POINT" && !isOpen) || (isOpen && EndsMeet(input, i)))
    {
      return {};
    }
    pointsOnly = pointsOnly && !isOpen;
  }
  return pointsOnly ? "points only, without a contour" : "open contours only";
}

int RunCore(vtkAlgorithm* filter, vtkDataObject* input, const char* needs, Outputs outputs,
  const std::function<void()>& work)
{
  if (IsMissing(input, outputs))
  {
    vtkErrorWithObjectMacro(filter, << "There is no input. This filter needs " << needs << ".");
    return 1;
  }
  if (PassNothing(filter, input, outputs))
  {
    return 1;
  }
  return RunOnAnything(filter, outputs, work);
}

int RunOnAnything(vtkAlgorithm* filter, Outputs outputs, const std::function<void()>& work)
{
  try
  {
    work();
  }
  catch (const Aborted&)
  {
    Clear(outputs);
  }
  catch (const NothingLeft& reason)
  {
    ClearAndReport(outputs, reason.what());
  }
  catch (const NothingToDo& reason)
  {
    ClearAndReport(outputs, reason.what());
    vtkWarningWithObjectMacro(filter, << reason.what());
  }
  catch (const std::exception& error)
  {
    Clear(outputs);
    vtkErrorWithObjectMacro(filter, << error.what());
  }
  return 1;
}

FileOutcome TryFile(
  const char* fileName, const char* kind, unsigned long failure, const std::function<void()>& work)
{
  if (!fileName || !*fileName)
  {
    return { vtkErrorCode::NoFileNameError,
      std::string("No file name is set: set FileName to ") + kind + "." };
  }
  try
  {
    work();
    return {};
  }
  catch (const Aborted&)
  {
    return { vtkErrorCode::UserError, {} };
  }
  catch (const std::exception& error)
  {
    return { failure, error.what() };
  }
}

unsigned long RunOnFile(vtkAlgorithm* algorithm, const char* fileName, const char* kind,
  unsigned long failure, Outputs outputs, const std::function<void()>& work)
{
  const FileOutcome outcome = TryFile(fileName, kind, failure, work);
  if (!outcome.IsWhole())
  {
    Clear(outputs);
  }
  if (!outcome.Sentence.empty())
  {
    vtkErrorWithObjectMacro(algorithm, << outcome.Sentence);
  }
  return outcome.ErrorCode;
}

bool HasExtension(const char* fileName, std::initializer_list<const char*> extensions)
{
  const std::string name = fileName ? fileName : "";
  const std::size_t dot = name.rfind('.');
  if (dot == std::string::npos || !std::ifstream(name))
  {
    return false;
  }
  std::string extension = name.substr(dot);
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

void FinishOutput(
  vtkDataObject* input, const std::vector<std::string>& report, vtkDataObject* output)
{
  vtkFieldData* from = input->GetFieldData();
  vtkFieldData* to = output->GetFieldData();
  for (int a = 0; a < from->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = from->GetAbstractArray(a);
    const char* name = array->GetName();
    if (name && std::string(name) != SummaryName && !to->HasArray(name))
    {
      to->AddArray(array);
    }
  }
  SetReport(report, output);
}
}
