#!/usr/bin/env bash
# Makes fonts/panel.ttf: the Latin and Greek letters and the signs of a font, as the panel and the credits need them, under the name that its
# licence asks of a part (fonts/UFL.txt). Needs fonttools (pip install fonttools).
#   scripts/make-font.sh Ubuntu-Light.ttf    as in the crate epaint_default_fonts, or from the Ubuntu font family 0.83
set -euo pipefail
cd "$(dirname "$0")/.."
source=${1:?the path of Ubuntu-Light.ttf}
pyftsubset "$source" --output-file=fonts/panel.ttf --no-hinting --desubroutinize --layout-features=kern --name-IDs='*' \
  --unicodes=U+0020-007E,U+00A0-017F,U+0370-03FF,U+2010-2027,U+2030-203A,U+2070-209F,U+20AC,U+2190-2193,U+2200-22FF
python3 - <<'PYTHON'
from fontTools.ttLib import TTFont
font = TTFont("fonts/panel.ttf", recalcTimestamp=False)
for record in font["name"].names:
    if record.nameID in (1, 3, 4, 6, 16):
        name = "Ubuntu derivative Ocean Globe"
        record.string = name.replace(" ", "") if record.nameID == 6 else name
font.save("fonts/panel.ttf")
PYTHON
