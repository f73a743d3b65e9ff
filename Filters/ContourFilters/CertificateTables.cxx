// SPDX-License-Identifier: GPL-3.0-or-later
#include "CertificateTables.h"

#include "FieldArrays.h"

#include "vtkIdTypeArray.h"
#include "vtkMultiProcessStream.h"
#include "vtkNew.h"
#include "vtkTable.h"

#include <algorithm>
#include <limits>

namespace recon
{
namespace
{
/// Rows are appended to columns that the first of them makes; a table takes whole columns only.
class TableWriter
{
public:
  explicit TableWriter(bool withBlocks) : WithBlocks(withBlocks) {}

  void Add(const JudgedSurface& surface)
  {
    for (const JudgedComponent& row : surface.Rows)
    {
      if (this->WithBlocks)
      {
        this->AddText("Block", surface.Name);
      }
      this->AddText("Component", row.Component);
      this->AddNumbers(row.Figures);
    }
  }

  void WriteTo(vtkTable* table) const
  {
    for (const auto& column : this->Columns)
    {
      table->AddColumn(column);
    }
  }

private:
  vtkAbstractArray* Find(const std::string& name) const
  {
    const auto column = std::find_if(this->Columns.begin(), this->Columns.end(),
      [&](vtkAbstractArray* array) { return array->GetName() == name; });
    return column == this->Columns.end() ? nullptr : column->Get();
  }

  void Append(const std::string& name, vtkAbstractArray* column)
  {
    column->SetName(name.c_str());
    this->Columns.emplace_back(column);
  }

  void AddText(const char* name, const std::string& text)
  {
    if (!this->Find(name))
    {
      this->Append(name, vtkNew<vtkStringArray>());
    }
    vtkStringArray::SafeDownCast(this->Find(name))->InsertNextValue(text);
  }

  void AddNumbers(const std::vector<CertificateFigure>& figures)
  {
    for (const auto& figure : figures)
    {
      if (!this->Find(figure.Name))
      {
        this->Append(figure.Name, MakeArrayFor(figure));
      }
      vtkDataArray::SafeDownCast(this->Find(figure.Name))->InsertNextTuple1(ValueOf(figure));
    }
  }

  std::vector<vtkSmartPointer<vtkAbstractArray>> Columns;
  bool WithBlocks;
};

/// A name that no other column has.
std::string ColumnName(const std::string& wanted, vtkTable* table)
{
  std::string name = wanted;
  for (int more = 2; table->GetColumnByName(name.c_str()); ++more)
  {
    name = wanted + " (" + std::to_string(more) + ")";
  }
  return name;
}

JudgedComponent RowOf(const std::string& component, const ComponentCertificate& certificate,
  const SurfaceCertificate& contours, bool withContours)
{
  JudgedComponent row{ component, ListFigures(certificate) };
  if (withContours)
  {
    const std::vector<CertificateFigure> more = ListContourFigures(contours);
    row.Figures.insert(row.Figures.end(), more.begin(), more.end());
  }
  return row;
}

/// A count, then as many as that.
template <typename Item, typename Function>
void SendAll(const std::vector<Item>& items, vtkMultiProcessStream& stream, Function&& send)
{
  stream << static_cast<int>(items.size());
  std::for_each(items.begin(), items.end(), send);
}

template <typename Item, typename Function>
void ReceiveAll(std::vector<Item>& items, vtkMultiProcessStream& stream, Function&& receive)
{
  int count = 0;
  stream >> count;
  items.resize(static_cast<std::size_t>(count));
  std::for_each(items.begin(), items.end(), receive);
}

void SendRow(const JudgedComponent& row, vtkMultiProcessStream& stream)
{
  stream << row.Component;
  SendAll(row.Figures, stream,
    [&](const CertificateFigure& figure)
    {
      stream << figure.Name << static_cast<int>(figure.Kind) << figure.Value.has_value()
             << figure.Value.value_or(0);
    });
}

void ReceiveRow(JudgedComponent& row, vtkMultiProcessStream& stream)
{
  stream >> row.Component;
  ReceiveAll(row.Figures, stream,
    [&](CertificateFigure& figure)
    {
      int kind = 0;
      bool hasValue = false;
      double value = 0;
      stream >> figure.Name >> kind >> hasValue >> value;
      figure.Kind = static_cast<CertificateFigure::KindType>(kind);
      figure.Value = hasValue ? std::optional<double>(value) : std::nullopt;
    });
}
}

JudgedSurface Judge(const SurfaceCertificate& certificate, const std::string& name, int number,
  bool millimetres, bool withContours)
{
  JudgedSurface judged;
  judged.Number = number;
  judged.Name = name.empty() ? std::to_string(number) : name;
  judged.Lines = ListLines(certificate, millimetres, withContours);
  judged.Verdict = ToVerdict(certificate, millimetres);
  const SurfaceCertificate none;
  for (std::size_t c = 0; c < certificate.Components.size(); ++c)
  {
    judged.Rows.push_back(RowOf(std::to_string(c), certificate.Components[c], none, withContours));
  }
  judged.Rows.push_back(RowOf("Total", certificate.Total, certificate, withContours));
  return judged;
}

void Send(const std::vector<JudgedSurface>& surfaces, vtkMultiProcessStream& stream)
{
  SendAll(surfaces, stream,
    [&](const JudgedSurface& surface)
    {
      stream << surface.Number << surface.Name << surface.Verdict;
      SendAll(surface.Lines, stream,
        [&](const CertificateLine& line) { stream << line.Figure << line.Value; });
      SendAll(surface.Rows, stream, [&](const JudgedComponent& row) { SendRow(row, stream); });
    });
}

std::vector<JudgedSurface> Receive(vtkMultiProcessStream& stream)
{
  std::vector<JudgedSurface> surfaces;
  ReceiveAll(surfaces, stream,
    [&](JudgedSurface& surface)
    {
      stream >> surface.Number >> surface.Name >> surface.Verdict;
      ReceiveAll(
        surface.Lines, stream, [&](CertificateLine& line) { stream >> line.Figure >> line.Value; });
      ReceiveAll(surface.Rows, stream, [&](JudgedComponent& row) { ReceiveRow(row, stream); });
    });
  return surfaces;
}

void FillReadingTable(const std::vector<JudgedSurface>& surfaces, bool withBlocks, vtkTable* table)
{
  for (const JudgedSurface& surface : surfaces)
  {
    std::vector<std::string> figures;
    std::vector<std::string> values;
    for (const CertificateLine& line : surface.Lines)
    {
      figures.push_back(line.Figure);
      values.push_back(line.Value);
    }
    if (table->GetNumberOfColumns() == 0)
    {
      table->AddColumn(MakeArray("(figure)", figures));
    }
    const std::string name = withBlocks ? surface.Name : "Surface";
    table->AddColumn(MakeArray(ColumnName(name, table).c_str(), values));
  }
}

void FillComponentTable(
  const std::vector<JudgedSurface>& surfaces, bool withBlocks, vtkTable* table)
{
  TableWriter writer(withBlocks);
  for (const JudgedSurface& surface : surfaces)
  {
    writer.Add(surface);
  }
  writer.WriteTo(table);
}

std::string VerdictOf(const std::vector<JudgedSurface>& surfaces, bool withBlocks)
{
  std::string text;
  for (const JudgedSurface& surface : surfaces)
  {
    text += text.empty() ? "" : "\n";
    text += withBlocks ? surface.Name + ": " : "";
    text += surface.Verdict;
  }
  return text;
}

vtkSmartPointer<vtkDataArray> MakeArrayFor(const CertificateFigure& figure)
{
  switch (figure.Kind)
  {
    case CertificateFigure::Flag:
      return vtkSmartPointer<vtkIntArray>::New();
    case CertificateFigure::Count:
      return vtkSmartPointer<vtkIdTypeArray>::New();
    case CertificateFigure::Real:
      break;
  }
  return vtkSmartPointer<vtkDoubleArray>::New();
}

double ValueOf(const CertificateFigure& figure)
{
  const bool isReal = figure.Kind == CertificateFigure::Real;
  return figure.Value.value_or(isReal ? std::numeric_limits<double>::quiet_NaN() : -1);
}
}
