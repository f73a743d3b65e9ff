// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a stack of contours with options: its polyhedral surface keeps what README promises.
#include "DrawnContours.h"
#include "FuzzTarget.h"
#include "SurfacePromises.h"

#include "Polyhedral/PolyhedralSurface.h"

void fuzz::Try(const std::string& bytes)
{
  InputBytes input(bytes);
  const recon::ContourSetOptions cleaning = DrawSetOptions(input);
  const std::string drawn = input.Text(BytesOfOptions);
  const recon::LoopSoup soup = DrawStack(input);
  recon::Monitor monitor;
  const recon::ContourSet contours = recon::BuildContourSet(soup, cleaning, monitor);
  InputBytes choices(drawn);
  const recon::PolyhedralOptions options =
    DrawPolyhedralOptions(choices, static_cast<int>(contours.Contours.size()));
  RequirePromises(recon::BuildPolyhedralSurface(contours, options, monitor), contours, options);
}
