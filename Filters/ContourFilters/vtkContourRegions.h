// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkContourRegions
 * @brief Says what the regions of an input are: its blocks, slices of one object, or the values of an
 * array.
 *
 * Input: contours as poly data, or a collection of them. Output: a collection with a block a region,
 * which every other filter of the plugin works on one by one.
 *
 * First, Blocks decides what the blocks of a collection are. Then, with SplitBy, each of them is taken
 * apart by the values of a cell array of that name (a label, a layer, a material), in the order in
 * which they come first. Points and cells stay as they are; each block has field data `ROIName`.
 *
 * Field data `Report` says what was decided.
 *
 * On an MPI server every rank looks at the contours of all ranks, and keeps the regions that are its
 * share (Pieces.h). So this is also what brings contours together of which several ranks have a part, as
 * Slice of a surface in pieces gives them.
 */
#ifndef vtkContourRegions_h
#define vtkContourRegions_h

#include "ContourFiltersModule.h" // for export macro
#include "vtkPartitionedDataSetCollectionAlgorithm.h"

#include <string> // for std::string

class CONTOURFILTERS_EXPORT vtkContourRegions : public vtkPartitionedDataSetCollectionAlgorithm
{
public:
  static vtkContourRegions* New();
  vtkTypeMacro(vtkContourRegions, vtkPartitionedDataSetCollectionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum BlocksType
  {
    Automatic = 0,
    Regions = 1,
    Slices = 2
  };

  ///@{
  /**
   * What the blocks of a collection are. Automatic, the default: slices of one object where each lies
   * in a plane and none is a region of a structure set or a material; otherwise regions. Slices: of
   * one object in any case. Regions: in any case.
   */
  vtkSetClampMacro(Blocks, int, Automatic, Slices);
  vtkGetMacro(Blocks, int);
  ///@}

  ///@{
  /**
   * A cell array whose values are regions; none, the default, splits nothing.
   */
  vtkSetStringMacro(SplitBy);
  vtkGetStringMacro(SplitBy);
  ///@}

  /// See vtkContourAlgorithm.
  const char* GetReport();

protected:
  vtkContourRegions() = default;
  ~vtkContourRegions() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkContourRegions(const vtkContourRegions&) = delete;
  void operator=(const vtkContourRegions&) = delete;

  int Blocks = Automatic;
  char* SplitBy = nullptr;
  std::string ReportText; // what GetReport gave out last
};

#endif
