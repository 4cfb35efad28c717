#!/usr/bin/env bash
# Builds what has changed and serves the page with HTTP range requests.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/env.sh"
scripts/build.sh
exec "$TARGET_DIR/release/ocean-globe" serve dist --port "${PORT:-8080}"
