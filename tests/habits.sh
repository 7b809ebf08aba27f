#!/usr/bin/env bash
# Formatting of all C++ files (.clang-format) and chosen checks of clang-tidy (.clang-tidy) over the physics.
#   bash tests/habits.sh [ROOM...]      ROOM for clang-tidy: config, forest and rockfall by default
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/bootstrap.sh"

install_missing clang-format clang-tidy libeigen3-dev librandom123-dev libgomp1
cd "$root"
git ls-files -z '*.cpp' '*.hpp' | xargs -0 clang-format --dry-run -Werror
echo "formatting: as .clang-format has it" >&2

rooms=("$@")
if [ ${#rooms[@]} -eq 0 ]; then
    rooms=(config forest rockfall)
fi
# All files of a room together: reading the same headers again would take most of the time. Names in unnamed
# namespaces are unique within a room.
units=$(mktemp -d)
trap 'rm -rf "$units"' EXIT
while read -r file; do
    # CGAL takes long and is not ours; tables are built in by another compiler's directives.
    case $file in
        */mesh.cpp | */shipped_tables.cpp | */version.cpp) ;;
        *) echo "#include \"$file\"" >>"$units/${file%%/*}.cpp" ;;
    esac
done < <(git ls-files "${rooms[@]/%//*.cpp}")
# The longest first.
find "$units" -name '*.cpp' -printf '%s %p\0' | sort -znr | cut -zd ' ' -f 2- | xargs -0 -n 1 -P "$(job_count)" sh -c '
    clang-tidy --quiet --config-file=.clang-tidy "$1" -- -std=c++20 -I. -isystem /usr/include/eigen3 -DNDEBUG -w' sh
echo "clang-tidy: nothing found in ${rooms[*]}" >&2
