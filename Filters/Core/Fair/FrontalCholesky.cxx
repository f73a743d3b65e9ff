// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/FrontalCholesky.h"

#include "Base/Parallel.h"
#include "Fair/DenseFront.h"

#include <algorithm>

namespace recon
{
namespace
{
/// Of a solution, what a thread takes at once.
constexpr std::size_t NodesABlock = 8;
}

FrontalCholesky::FrontalCholesky(const std::vector<DissectionNode>& nodes, const Matrix& pattern)
  : Nodes(nodes),
    Fronts(nodes.size())
{
  for (std::size_t node = 0; node < nodes.size(); ++node)
  {
    const std::size_t depth = nodes[node].Depth;
    this->NodesOfDepth.resize(std::max(this->NodesOfDepth.size(), depth + 1));
    this->NodesOfDepth[depth].push_back(static_cast<int>(node));
  }
  this->FindRows(pattern);
}

/// Those in which its columns have entries, and those that its parts hand on.
void FrontalCholesky::FindRows(const Matrix& pattern)
{
  std::vector<int> seen(pattern.rows(), -1);
  for (std::size_t node = 0; node < this->Nodes.size(); ++node)
  {
    std::vector<int>& rows = this->Fronts[node].Rows;
    const auto add = [&](int row)
    {
      if (row >= this->Nodes[node].To && seen[row] != static_cast<int>(node))
      {
        seen[row] = static_cast<int>(node);
        rows.push_back(row);
      }
    };
    for (int column = this->Nodes[node].From; column < this->Nodes[node].To; ++column)
    {
      for (Matrix::InnerIterator entry(pattern, column); entry; ++entry)
      {
        add(static_cast<int>(entry.row()));
      }
    }
    for (const int part : this->Nodes[node].Parts)
    {
      if (part >= 0)
      {
        std::for_each(this->Fronts[part].Rows.begin(), this->Fronts[part].Rows.end(), add);
      }
    }
    std::sort(rows.begin(), rows.end());
  }
}

/// Of a row of the matrix within a front.
int FrontalCholesky::PlaceOf(std::size_t node, int row) const
{
  if (row < this->Nodes[node].To)
  {
    return row - this->Nodes[node].From;
  }
  const std::vector<int>& rows = this->Fronts[node].Rows;
  return this->Width(node) +
    static_cast<int>(std::lower_bound(rows.begin(), rows.end(), row) - rows.begin());
}

void FrontalCholesky::TakeEntries(std::size_t node, const Matrix& matrix)
{
  for (int column = this->Nodes[node].From; column < this->Nodes[node].To; ++column)
  {
    for (Matrix::InnerIterator entry(matrix, column); entry; ++entry)
    {
      if (entry.row() >= column)
      {
        this->Fronts[node].Panel(this->PlaceOf(node, static_cast<int>(entry.row())),
          column - this->Nodes[node].From) += entry.value();
      }
    }
  }
}

void FrontalCholesky::TakeUpdate(std::size_t node, Front& part)
{
  const int count = static_cast<int>(part.Rows.size());
  const int width = this->Width(node);
  std::vector<int> places(count);
  std::transform(part.Rows.begin(), part.Rows.end(), places.begin(),
    [&](int row) { return this->PlaceOf(node, row); });
  Front& front = this->Fronts[node];
  for (int j = 0; j < count; ++j)
  {
    const bool own = places[j] < width;
    double* column =
      own ? front.Panel.col(places[j]).data() : front.Update.col(places[j] - width).data() - width;
    for (int i = j; i < count; ++i)
    {
      column[places[i]] += part.Update(i, j);
    }
  }
  part.Update.resize(0, 0);
}

bool FrontalCholesky::FactoriseFront(std::size_t node, const Matrix& matrix)
{
  Front& front = this->Fronts[node];
  const int width = this->Width(node);
  const int below = static_cast<int>(front.Rows.size());
  front.Panel.setZero(width + below, width);
  front.Update.setZero(below, below);
  this->TakeEntries(node, matrix);
  for (const int part : this->Nodes[node].Parts)
  {
    if (part >= 0)
    {
      this->TakeUpdate(node, this->Fronts[part]);
    }
  }
  if (width == 0)
  {
    return true;
  }
  if (!FactorisePanel(front.Panel.data(), width + below, width))
  {
    return false;
  }
  SubtractOwnProduct(front.Update.data(), below, front.Panel.data() + width, width + below, width);
  return true;
}

bool FrontalCholesky::Factorise(const Matrix& matrix, int threads, Monitor& monitor)
{
  std::vector<char> good(this->Nodes.size(), 0);
  for (std::size_t depth = this->NodesOfDepth.size(); depth-- > 0;)
  {
    const std::vector<int>& nodes = this->NodesOfDepth[depth];
    ParallelForBlocks(nodes.size(), 1, threads,
      [&](std::size_t from, std::size_t)
      { good[nodes[from]] = this->FactoriseFront(nodes[from], matrix) ? 1 : 0; },
      monitor, { 0, 0, "fairing" });
  }
  return std::all_of(good.begin(), good.end(), [](char g) { return g != 0; });
}

/// From the parts' own rows: what they leave for those of this node, and of later ones.
void FrontalCholesky::SolveDown(std::size_t node, Eigen::MatrixXd& solved)
{
  Front& front = this->Fronts[node];
  const int width = this->Width(node);
  front.Carried.setZero(static_cast<Eigen::Index>(front.Rows.size()), solved.cols());
  auto own = solved.middleRows(this->Nodes[node].From, width);
  for (const int part : this->Nodes[node].Parts)
  {
    for (std::size_t i = 0; part >= 0 && i < this->Fronts[part].Rows.size(); ++i)
    {
      const int place = this->PlaceOf(node, this->Fronts[part].Rows[i]);
      const auto carried = this->Fronts[part].Carried.row(static_cast<Eigen::Index>(i));
      if (place < width)
      {
        own.row(place) += carried;
      }
      else
      {
        front.Carried.row(place - width) += carried;
      }
    }
  }
  front.Panel.topRows(width).triangularView<Eigen::Lower>().solveInPlace(own);
  front.Carried.noalias() -= front.Panel.bottomRows(front.Rows.size()) * own;
}

void FrontalCholesky::SolveUp(std::size_t node, Eigen::MatrixXd& solved) const
{
  const Front& front = this->Fronts[node];
  const int width = this->Width(node);
  Eigen::MatrixXd known(front.Rows.size(), solved.cols());
  for (std::size_t i = 0; i < front.Rows.size(); ++i)
  {
    known.row(static_cast<Eigen::Index>(i)) = solved.row(front.Rows[i]);
  }
  auto own = solved.middleRows(this->Nodes[node].From, width);
  own -= front.Panel.bottomRows(front.Rows.size()).transpose() * known;
  front.Panel.topRows(width).triangularView<Eigen::Lower>().transpose().solveInPlace(own);
}

Eigen::MatrixXd FrontalCholesky::Solve(const Eigen::MatrixXd& right, int threads, Monitor& monitor)
{
  Eigen::MatrixXd solved = right;
  const auto forNodes = [&](std::size_t depth, const auto& work)
  {
    const std::vector<int>& nodes = this->NodesOfDepth[depth];
    ParallelForBlocks(
      nodes.size(), NodesABlock, threads,
      [&](std::size_t from, std::size_t to)
      {
        for (std::size_t i = from; i < to; ++i)
        {
          work(nodes[i]);
        }
      },
      monitor, { 0, 0, "fairing" }, 2);
  };
  for (std::size_t depth = this->NodesOfDepth.size(); depth-- > 0;)
  {
    forNodes(depth, [&](std::size_t node) { this->SolveDown(node, solved); });
  }
  for (std::size_t depth = 0; depth < this->NodesOfDepth.size(); ++depth)
  {
    forNodes(depth, [&](std::size_t node) { this->SolveUp(node, solved); });
  }
  return solved;
}
}
