#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes window.png, the picture of ParaView's window in README: the contours of a head, and the brain made from its own.
# Needs xvfb, xdotool and ImageMagick. Usage: window.sh PLUGIN_FOLDER   (that of `./run plugin`)
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
if [[ -z "${WINDOW_ON_DISPLAY:-}" ]]; then
  export WINDOW_ON_DISPLAY=yes
  exec xvfb-run -a -n 330 -s '-screen 0 1320x900x24 -noreset' "$0" "$@"
fi

home="$(mktemp -d)"
trap 'rm -rf "$home"' EXIT
mkdir -p "$home/.config/ParaView"
printf '[General]\nGeneralSettings.ShowWelcomeDialog=false\n' >"$home/.config/ParaView/ParaView5.11.0.ini"
cat >"$home/scene.py" <<END
from paraview.simple import *
head = NUAGESContourReader(registrationName="head.cnt", FileName="$here/../../Data/head.cnt")
PolyhedralSurface(registrationName="Head", Input=head)
contours = NUAGESContourReader(registrationName="brain.cnt", FileName="$here/../../Data/brain.cnt")
brain = PolyhedralSurface(registrationName="Brain", Input=contours)
view = GetActiveViewOrCreate("RenderView")
for source, colour in (head, [0.2, 0.4, 0.75]), (brain, [0.93, 0.74, 0.68]):
    display = Show(source, view)
    display.ColorArrayName = ["POINTS", ""]
    display.DiffuseColor = display.AmbientColor = colour
    display.LineWidth = 1.5
    display.Opacity = 1 if source is brain else 0.6
view.UseColorPaletteForBackground = 0
view.Background = [1, 1, 1]
view.OrientationAxesVisibility = 0
SetActiveSource(brain)
view.CameraViewUp, view.CameraFocalPoint, view.CameraPosition = [0, 0, 1], [0, 0, 0], [-0.75, 0.85, 0.3]
ResetCamera()
GetActiveCamera().Zoom(1.3)
Render()
brain.UpdatePipeline()
brain.SMProxy.UpdatePropertyInformation()
open("$home/ready", "w").close()
END
HOME="$home" PV_PLUGIN_PATH="$1" paraview --script="$home/scene.py" >"$home/log" 2>&1 &
paraview=$!
for ((i = 0; i < 150; ++i)); do
  sleep 2
  [[ -f "$home/ready" ]] && break
done
window="$(xdotool search --onlyvisible --name '^ParaView 5' | tail -n 1)"
xdotool windowmove "$window" 0 0 windowsize "$window" 1320 900
sleep 5
# A wider and higher panel, by its borders; slowly, as a loaded machine misses quick moves.
drag()
{
  xdotool mousemove "$1" "$2" sleep 2 mousedown 1 sleep 2
  xdotool mousemove "$((($1 + $3) / 2))" "$((($2 + $4) / 2))" sleep 2 mousemove "$3" "$4" sleep 2 mouseup 1
}
drag 295 600 370 600
drag 185 400 185 300
xdotool mousemove 800 600
sleep 5
import -window root "$here/window.png"
kill "$paraview"
