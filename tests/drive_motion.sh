#!/usr/bin/env bash
# Opens motions of other programs in the real window under Xvfb, as a person would: from the control panel, by a path that
# is typed and by a click on the list of files. Reads from the screen that the verdict on a right motion is green and the
# one on a wrong motion is not, and that a file that does not fit is refused. Places are those of a 1280x720 window.
#   tests/drive_motion.sh TYG SOURCE_DIR PYTHON [PICTURES]     with PICTURES, a folder: keeps pictures there
set -euo pipefail

tyg=$1 source_dir=$(readlink -f "$2") python=$3 pictures=${4:+$(readlink -m "$4")} backend=glfw
limit=220 # seconds for everything, on a slow and busy machine
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/driving.sh"
command -v ffmpeg >/dev/null || { echo "missing: ffmpeg (.ci/setup installs it)" && exit 1; }

if [[ -n $pictures ]]; then mkdir -p "$pictures"; fi
picture() {
  few_frames 6
  [[ -z $pictures ]] || ffmpeg -v error -y -f x11grab -video_size "$screen" -i "$DISPLAY" -frames:v 1 "$pictures/$1.png"
}
