// SPDX-License-Identifier: GPL-3.0-or-later
#include "Readers/ReaderTesting.h"

#include "Common/ClosedLoops.h"

using namespace readertesting;

namespace
{
/// A unit square at z, its edges as loose pieces.
recon::LoopSoup Pieces()
{
  recon::LoopSoup soup;
  soup.Points = { { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
  soup.Chains = { { { 0, 1 }, false, 0 }, { { 2, 1 }, false, 1 }, { { 2, 3, 0 }, false, 2 } };
  return soup;
}

recon::LoopSoup Close(const recon::LoopSoup& soup, int& looseVertices)
{
  recon::Monitor monitor;
  return recon::CloseLoops(soup, "such files hold", looseVertices, monitor);
}
}

TEST(ClosedLoops, PiecesAreChained)
{
  int looseVertices = 0;
  const recon::LoopSoup closed = Close(Pieces(), looseVertices);
  ASSERT_EQ(closed.Chains.size(), 1u);
  EXPECT_TRUE(closed.Chains[0].Closed);
  EXPECT_EQ(closed.Chains[0].Points.size(), 4u);
  EXPECT_EQ(closed.Points, Pieces().Points);
  EXPECT_EQ(looseVertices, 0);
}

TEST(ClosedLoops, ClosedOnesPassAndVerticesAreCounted)
{
  recon::LoopSoup soup = Pieces();
  soup.Chains.push_back({ { 0, 1, 2 }, true, 3 });
  soup.Chains.push_back({ { 3 }, false, 4 });
  int looseVertices = 0;
  const recon::LoopSoup closed = Close(soup, looseVertices);
  ASSERT_EQ(closed.Chains.size(), 2u);
  EXPECT_EQ(closed.Chains[0].Points, (std::vector<int>{ 0, 1, 2 }));
  EXPECT_EQ(looseVertices, 1);
}

TEST(ClosedLoops, PiecesThatMeetByCoordinatesOnlyAreChained)
{
  recon::LoopSoup soup = Pieces();
  soup.Points.push_back(soup.Points[0]);
  soup.Chains[2].Points.back() = 4;
  int looseVertices = 0;
  EXPECT_EQ(Close(soup, looseVertices).Chains.size(), 1u);
}

TEST(ClosedLoops, OpenPiecesAreASentence)
{
  recon::LoopSoup soup = Pieces();
  soup.Chains.pop_back();
  int looseVertices = 0;
  ExpectSentence(SentenceOf([&] { Close(soup, looseVertices); }), "such files hold",
    "the line of cell 0 does not close");
}
