// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkSurfaceCertificate
 * @brief What may be trusted about a surface, as data: any surface in, the same surface with its
 * certificate out.
 *
 * Input port 0: the surface, ours or another's, as vtkPolyData or a composite of such; polygons and
 * strips are triangulated, vertices and lines left out. Input port 1 (optional): the contours that
 * it was made from, as vtkPolyData for all blocks of the surface, or a composite whose blocks are
 * matched with the surface's by name, else by position.
 *
 * Units are those of the input, squared for areas and cubed for volumes; angles are in degrees.
 * Topology is by point index and exact; intersections are decided exactly; formulas stand in the
 * headers of the core (Mesh/MeshTopology.h, Mesh/SelfIntersections.h, Mesh/MassProperties.h,
 * Mesh/SectionComparison.h).
 *
 * Output port 0: the surface, triangles only, in the structure of the input, with
 * - cell array `Defect` (int, bits; 0 = nothing wrong): 1 open edge, 2 edge of more than two
 *   triangles, 4 neighbours that disagree in orientation, 8 pinched vertex, 16 duplicate, 32
 * degenerate, 64 crosses another triangle (or sheets cross at an edge of it), 128 overlaps another,
 * 256 of a component that is inside out, 512 touches another (not in itself wrong; `Threshold` from
 * 1 to 511 shows what is);
 * - cell array `ComponentId` (int, by first triangle; -1 for collapsed triangles on their own);
 * - field data, one value each, for the whole surface: the flags (0 or 1) `Sound`, `Closed`,
 *   `EdgeManifold`, `VertexManifold`, `Oriented`, `Outward`; the counts `Components`, `Points`,
 *   `Edges`, `Triangles`, `OpenEdges`, `OverusedEdges`, `MisorientedEdges`, `PinchedVertices`,
 *   `DuplicateTriangles`, `DegenerateTriangles`, `Euler`, `Genus`, `Nesting`, `CrossingPairs`,
 *   `OverlappingPairs`, `TouchingPairs`, `CrossingEdges` (edges of equal coordinates at which
 * sheets of the surface pass through one another); the reals `Volume`, `Area`, `CentroidX`,
 * `CentroidY`, `CentroidZ`, `LowX` ... `HighZ` (bounds), `SmallestAngle`. A figure without meaning
 * (the volume of a surface that encloses none, the genus of one that is no closed manifold) is NaN,
 * of a count -1;
 * - with contours, field data `ContourVertices`, `FarthestContourVertex`, `MeanContourVertex`,
 *   `FarthestContourEdge`, `MeanContourEdge`, `FarthestContourX`, `FarthestContourY`,
 *   `FarthestContourZ`, `WorstSectionPercent`, `TotalSectionPercent`, and what parallel contours
 *   say about the volume, whatever the surface is (Contours/VolumeInterval.h): `VolumeByContours`,
 *   `LowestVolume`, `HighestVolume`, an entry a place where a slice would tell more, the widest
 *   first, `DoubtOffset` and `DoubtWidth`, and an entry a level
 *   `SectionOffset`, `SectionContourArea`, `SectionSurfaceArea`, `SectionDifference`,
 *   `SectionPercent` (NaN where the surface is open in that plane);
 * - field data `Certificate` (strings, a few lines for people) and `CertificateJSON` (one string,
 *   everything).
 *
 * Output port 1: vtkTable to be read, a row a figure in the order of recon::ListLines, the verdict
 * first; columns `(figure)` (which a spreadsheet puts first), and text a surface: `Surface`, or the
 * name (number where it has none) of each block. Volumes are in cm3 where all blocks are regions of a
 * structure set.
 *
 * Output port 2: vtkTable to be computed with, a row a component and a row for the whole: columns
 * `Block` (name, or number where it has none; only of a composite), `Component` ("0", "1", ...,
 * "Total"), and the figures above.
 *
 * On an MPI server each rank judges the surfaces that it has; both tables and the verdict, of all
 * surfaces, are on the first rank.
 *
 * An empty surface gives a table that says so. Errors (a sentence through vtkErrorMacro, and no
 * output): a coordinate that is not finite, contours of which none is usable, blocks of contours
 * that fit no surface.
 */
#ifndef vtkSurfaceCertificate_h
#define vtkSurfaceCertificate_h

#include "ContourFiltersModule.h" // for export macro
#include "vtkDataObjectAlgorithm.h"

#include <string> // for std::string

class CONTOURFILTERS_EXPORT vtkSurfaceCertificate : public vtkDataObjectAlgorithm
{
public:
  static vtkSurfaceCertificate* New();
  vtkTypeMacro(vtkSurfaceCertificate, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The contours that the surface was made from; optional.
  void SetContoursConnection(vtkAlgorithmOutput* contours);

  ///@{
  /**
   * Judge the surface with points of equal coordinates taken for one: for surfaces that were stored
   * without connectivity. Off by default.
   */
  vtkSetMacro(Weld, bool);
  vtkGetMacro(Weld, bool);
  vtkBooleanMacro(Weld, bool);
  ///@}

  /// A line a surface: its name, verdict and volume. Empty before the first execution.
  const char* GetVerdict();

  ///@{
  /// Number of threads; 0 (the default) takes all of the machine. The result does not depend on it.
  vtkSetClampMacro(Threads, int, 0, 1024);
  vtkGetMacro(Threads, int);
  ///@}

protected:
  vtkSurfaceCertificate();
  ~vtkSurfaceCertificate() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkSurfaceCertificate(const vtkSurfaceCertificate&) = delete;
  void operator=(const vtkSurfaceCertificate&) = delete;

  bool Weld = false;
  int Threads = 0;
  std::string Verdict;
};

#endif
