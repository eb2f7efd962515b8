#!/usr/bin/env bash
# Takes the tutorial's pictures from those that the tests of the window have made (./dev test).
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."
while read -r taken name; do
  cp "out/gui/$taken.png" "docs/images/tutorial-$name.png"
done <<'PICTURES'
wing-panel panel
wing-growing growing
wing-results results
walls walls
wing-quality quality
PICTURES
