// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkContourAlgorithm.h"

#include "Base/Text.h"
#include "ContourConversion.h"
#include "Pieces.h"
#include "SurfaceBlocks.h"
#include "SurfaceSummaries.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <map>
#include <sstream>
#include <vector>

vtkStandardNewMacro(vtkContourAlgorithm);

namespace
{
/// More lines than this do not help in a panel; all are in the field data.
constexpr std::size_t MostLines = 100;

/// Names of regions in a line.
constexpr std::size_t MostNames = 10;

/// The panel's box does not wrap, and is about as wide.
constexpr std::size_t PanelWidth = 40;

/// An item of the list, over as many lines as it takes.
std::string Wrapped(const std::string& line)
{
  std::string text;
  std::string row = "-";
  std::istringstream words(line);
  for (std::string word; words >> word;)
  {
    if (row.size() + 1 + word.size() > PanelWidth && row.size() > 1)
    {
      text += row + "\n";
      row = " ";
    }
    row += " " + word;
  }
  return text + row;
}

/// A line a rank that has regions which this one has not.
std::string ElsewhereIn(vtkDataObject* output)
{
  std::map<int, std::vector<std::string>> namesOn;
  for (const recon::NamedPolyData& block : recon::ListPolyData(output))
  {
    if (const auto owner = recon::OwnerElsewhere(block.Data))
    {
      namesOn[*owner].push_back(block.Name);
    }
  }
  std::string text;
  for (const auto& [rank, names] : namesOn)
  {
    text += "On rank " + std::to_string(rank) +
      ", with their Report: " + recon::Listed(names, MostNames) + "\n";
  }
  return text;
}

/// Lines of the output as a whole where it has some, as those of a reader hold those of its blocks.
std::vector<std::string> LinesOf(vtkDataObject* output)
{
  std::vector<std::string> lines = recon::GetReport(output);
  if (!lines.empty())
  {
    return lines;
  }
  for (const recon::NamedPolyData& block : recon::ListPolyData(output))
  {
    for (const std::string& line : recon::GetReport(block.Data))
    {
      lines.push_back(block.Name.empty() ? line : block.Name + ": " + line);
    }
  }
  return lines;
}
}

void vtkContourAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

vtkTypeBool vtkContourAlgorithm::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const vtkTypeBool result = this->Superclass::ProcessRequest(request, inputVector, outputVector);
  const bool isSource = this->GetNumberOfInputPorts() == 0;
  if (isSource && request->Has(vtkDemandDrivenPipeline::REQUEST_INFORMATION()))
  {
    recon::AnswerPieces(outputVector);
  }
  if (request->Has(vtkStreamingDemandDrivenPipeline::REQUEST_UPDATE_EXTENT()))
  {
    for (int port = 1; port < this->GetNumberOfInputPorts(); ++port)
    {
      recon::RequestWhole(inputVector[port]);
    }
  }
  return result;
}

const char* vtkContourAlgorithm::GetReport()
{
  this->ReportText = vtkContourAlgorithm::ReportOf(this);
  return this->ReportText.c_str();
}

std::string vtkContourAlgorithm::ReportOf(vtkAlgorithm* algorithm)
{
  vtkDataObject* output = algorithm->GetOutputDataObject(0);
  if (!output || output->GetUpdateTime() == 0)
  {
    return {};
  }
  std::string text = recon::SummariesOf(output) + ElsewhereIn(output);
  const std::vector<std::string> lines = LinesOf(output);
  if (lines.empty())
  {
    return text + "Nothing was changed or left out.";
  }
  text +=
    lines.size() == 1 ? "One thing to know:" : std::to_string(lines.size()) + " things to know:";
  for (std::size_t i = 0; i < lines.size() && i < MostLines; ++i)
  {
    text += "\n" + Wrapped(lines[i]);
  }
  if (lines.size() > MostLines)
  {
    text += "\n" +
      Wrapped("... and " + std::to_string(lines.size() - MostLines) +
        " more, in the field data array Report.");
  }
  return text;
}
