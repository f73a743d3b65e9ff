// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file CertificateTables.h
 * @brief The tables of a certificate, of surfaces that may have been judged on other ranks.
 */
#ifndef CertificateTables_h
#define CertificateTables_h

#include "Mesh/CertificateText.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkDataArray;
class vtkMultiProcessStream;
class vtkTable;

namespace recon
{
/// A row of the table of components.
struct JudgedComponent
{
  std::string Component; ///< "0", "1", ..., "Total"
  std::vector<CertificateFigure> Figures;
};

/// What the tables say of a surface.
struct JudgedSurface
{
  int Number = 0;   ///< among the blocks of all ranks
  std::string Name; ///< or its number
  std::vector<CertificateLine> Lines;
  std::vector<JudgedComponent> Rows;
  std::string Verdict;
};

/// Parameters are those of ListLines.
JudgedSurface Judge(const SurfaceCertificate& certificate, const std::string& name, int number,
  bool millimetres, bool withContours);

void Send(const std::vector<JudgedSurface>& surfaces, vtkMultiProcessStream& stream);
std::vector<JudgedSurface> Receive(vtkMultiProcessStream& stream);

/// The table that people read: a row a figure, a column a surface.
void FillReadingTable(const std::vector<JudgedSurface>& surfaces, bool withBlocks, vtkTable* table);
/// The table to be computed with: a row a component, and one for the whole.
void FillComponentTable(
  const std::vector<JudgedSurface>& surfaces, bool withBlocks, vtkTable* table);
/// A line a surface.
std::string VerdictOf(const std::vector<JudgedSurface>& surfaces, bool withBlocks);

/// An empty array for the figure's kind, and what it holds where the figure has no meaning: NaN, or -1
/// for a count.
vtkSmartPointer<vtkDataArray> MakeArrayFor(const CertificateFigure& figure);
double ValueOf(const CertificateFigure& figure);
}

#endif
