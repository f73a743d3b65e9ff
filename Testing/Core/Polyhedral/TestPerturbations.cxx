// SPDX-License-Identifier: GPL-3.0-or-later
// Contours as other programs leave them; a few of what the slow test does.
#include "Perturbations.h"

using namespace recon::testing;

using Perturbations = SharedData;

TEST_F(Perturbations, HardlyChangeTheSurface)
{
  PerturbSets(16);
}
