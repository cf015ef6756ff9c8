#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# examples.sh FOLDER FILE.md...: each block of C++ in the files becomes a program of FOLDER, printed lines as they are.
# A block with a main() is a whole file. Of others, #include lines come first, then what the page takes for granted, which stands
# in a comment before the block (<!-- example: ... -->, declarations), and the rest makes main(). <!-- example: needs COMPONENT -->
# puts the component into the name, NAME.COMPONENT.cpp.
set -euo pipefail
folder=$1
shift
mkdir -p "$folder"
awk -v folder="$folder" '
  function finish(   i) {
    name = FILENAME
    sub(/.*\//, "", name); sub(/\.md$/, "", name); gsub(/[^A-Za-z0-9]/, "_", name)
    out = folder "/" tolower(name) "_" (++count[name]) needs ".cpp"
    if (whole ~ /int main\(/) printf "#line %d \"%s\"\n%s", start, FILENAME, whole > out
    else printf "%s%sint main() {\n#line %d \"%s\"\n%s}\n", includes, granted, start, FILENAME, body > out
    close(out)
  }
  /^<!-- example: needs [a-z_]+ -->/ { needs = "." $4; next }
  /^<!-- example:/ { in_comment = 1; granted = ""; next }
  in_comment && /-->/ { in_comment = 0; next }
  in_comment { granted = granted $0 "\n"; next }
  /^```cpp/ { in_block = 1; includes = body = whole = ""; start = FNR + 1; next }
  in_block && /^```/ { in_block = 0; finish(); granted = needs = ""; next }
  in_block {
    whole = whole $0 "\n"
    if ($0 ~ /^#include/) { includes = includes $0 "\n"; body = body "\n" }
    else body = body $0 "\n"
  }
' "$@"
