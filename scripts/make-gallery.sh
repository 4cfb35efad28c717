#!/usr/bin/env bash
# Draws the gallery, docs/gallery/*.jpg, from the links in docs/gallery/links.txt, and views.jpg, the small pictures of the panel's named views.
# As a graphics card draws them: with smooth edges, which processors leave out unless they are asked for.
# OCEAN_GLOBE=program: with a program that is there already.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/env.sh"
if [ -z "${OCEAN_GLOBE:-}" ]; then
  cargo build --release --locked
  OCEAN_GLOBE=$TARGET_DIR/release/ocean-globe
fi
while IFS='|' read -r name title fragment; do
  case $name in ''|'#'*) continue;; esac
  printf '%s …\n' "$title"
  "$OCEAN_GLOBE" render --state "#$fragment&quality=high" --size 1280x720 -o "docs/gallery/$name.jpg"
done <docs/gallery/links.txt
"$OCEAN_GLOBE" render --views --size 112x63 -o docs/gallery/views.jpg
