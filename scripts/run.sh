#!/usr/bin/env bash
# Builds the page if anything has changed, and serves it with HTTP range requests.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/env.sh"
scripts/page.sh
exec node scripts/serve/serve.mjs "$QUICK_PAGE" "${PORT:-8080}"
