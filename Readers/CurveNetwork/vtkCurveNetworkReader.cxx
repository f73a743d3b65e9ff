// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkCurveNetworkReader.h"

#include "ContourConversion.h"
#include "CurveNetwork/CurveNetworkParser.h"
#include "FieldArrays.h"
#include "Pieces.h"
#include "RunCore.h"
#include "vtkContourAlgorithm.h"
#include "vtkContourMonitor.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"

#include <string>
#include <utility>

vtkStandardNewMacro(vtkCurveNetworkReader);

/// The type of the output depends on the file, so that it is read before there is an output.
class vtkCurveNetworkReader::Internals
{
public:
  void Read(vtkCurveNetworkReader* self)
  {
    this->Network.reset();
    this->Outcome = recon::TryFile(self->FileName,
      "a cross-section set (.csl) or a curve network (.contour)", vtkErrorCode::FileFormatError,
      [this, self]
      {
        vtkContourMonitor monitor(self);
        auto network =
          std::make_unique<recon::CurveNetwork>(recon::ReadCurveNetwork(self->FileName, monitor));
        if (network->Materials.empty())
        {
          throw recon::Error(
            "Cannot read " + std::string(self->FileName) + ": it has no contours.");
        }
        this->Network = std::move(network);
      });
  }

  std::unique_ptr<recon::CurveNetwork> Network; ///< none where the outcome is not whole
  recon::FileOutcome Outcome;
};

namespace
{
/// soup: the material's, or none where the material is in another piece.
void FillMaterial(
  const recon::MaterialContours& material, const recon::LoopSoup& soup, vtkPolyData* output)
{
  const std::vector<int> chains = recon::ToPolyData(soup, output);
  std::vector<int> planes;
  for (const int chain : chains)
  {
    planes.push_back(material.Planes[static_cast<std::size_t>(chain)]);
  }
  recon::AddArray(output->GetCellData(), "Plane", planes);
  recon::AddValue(output->GetFieldData(), "Material", material.Label);
}

void FillMaterials(
  const recon::CurveNetwork& network, recon::Piece piece, vtkPartitionedDataSetCollection* output)
{
  std::vector<std::size_t> weights;
  for (const recon::MaterialContours& material : network.Materials)
  {
    weights.push_back(material.Soup.Points.size());
  }
  const recon::RegionShares shares(weights, piece);
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    const recon::MaterialContours& material = network.Materials[i];
    const auto block = static_cast<unsigned int>(i);
    vtkNew<vtkPolyData> contours;
    FillMaterial(material, shares.IsOwn(i) ? material.Soup : recon::LoopSoup(), contours);
    shares.Mark(i, contours);
    output->SetPartition(block, 0, contours);
    const std::string name = "Material " + std::to_string(material.Label);
    output->GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), name.c_str());
  }
}
}

vtkCurveNetworkReader::vtkCurveNetworkReader() : Implementation(std::make_unique<Internals>())
{
  this->SetNumberOfInputPorts(0);
}

vtkCurveNetworkReader::~vtkCurveNetworkReader()
{
  this->SetFileName(nullptr);
}

void vtkCurveNetworkReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << endl;
}

const char* vtkCurveNetworkReader::GetReport()
{
  this->ReportText = vtkContourAlgorithm::ReportOf(this);
  return this->ReportText.c_str();
}

int vtkCurveNetworkReader::CanReadFile(const char* fileName)
{
  const bool canRead = fileName &&
    (recon::HasExtension(fileName, { ".csl", ".contour" }) ||
      recon::CurveNetworkFormatOf(fileName) != recon::CurveNetworkFormat::None);
  return canRead ? 1 : 0;
}

int vtkCurveNetworkReader::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject");
  return 1;
}

int vtkCurveNetworkReader::RequestDataObject(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  // What is wrong with the file RequestData says; until then an empty output stands for it.
  this->Implementation->Read(this);
  const recon::CurveNetwork* network = this->Implementation->Network.get();
  const bool isCollection = network && network->Materials.size() > 1;
  vtkInformation* info = outputVector->GetInformationObject(0);
  vtkDataObject* output = vtkDataObject::GetData(info);
  if (isCollection && !vtkPartitionedDataSetCollection::SafeDownCast(output))
  {
    info->Set(vtkDataObject::DATA_OBJECT(), vtkNew<vtkPartitionedDataSetCollection>());
  }
  else if (!isCollection && !vtkPolyData::SafeDownCast(output))
  {
    info->Set(vtkDataObject::DATA_OBJECT(), vtkNew<vtkPolyData>());
  }
  return 1;
}

int vtkCurveNetworkReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  recon::AnswerPieces(outputVector);
  return 1;
}

int vtkCurveNetworkReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  Internals& internals = *this->Implementation;
  if (!internals.Network && internals.Outcome.IsWhole())
  {
    internals.Read(this); // the pipeline asks again for data that it has let go
  }
  // Read once more next time: the file may have changed.
  const std::unique_ptr<recon::CurveNetwork> network = std::move(internals.Network);
  const recon::FileOutcome outcome = std::exchange(internals.Outcome, {});
  this->SetErrorCode(outcome.ErrorCode);
  if (!outcome.Sentence.empty())
  {
    vtkErrorMacro(<< outcome.Sentence);
  }
  if (!outcome.IsWhole())
  {
    return 1; // or stopped by the user
  }
  auto* polyData = vtkPolyData::SafeDownCast(output);
  auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(output);
  if (network->Materials.size() == 1 ? !polyData : !collection)
  {
    vtkErrorMacro(
      "The file " << this->FileName << " has changed while it was read; read it again.");
    this->SetErrorCode(vtkErrorCode::FileFormatError);
    return 1;
  }
  const recon::Piece piece = recon::RequestedPiece(outputVector);
  if (polyData && piece.Number > 0)
  {
    return 1; // the one material is in the first piece
  }
  if (polyData)
  {
    const recon::MaterialContours& material = network->Materials.front();
    FillMaterial(material, material.Soup, polyData);
  }
  else
  {
    FillMaterials(*network, piece, collection);
  }
  recon::SetReport(network->Report, output);
  return 1;
}
