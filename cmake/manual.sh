#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# manual.sh PROGRAM FOLDER: from what `PROGRAM --help` and `PROGRAM SUBCOMMAND --help` print, writes to FOLDER the manual pages
# man1/leonhard.1 and man1/leonhard-SUBCOMMAND.1, and completions for bash (bash/leonhard) and zsh (zsh/_leonhard).
set -euo pipefail
program=$1 folder=$2
mkdir -p "$folder/man1" "$folder/bash" "$folder/zsh"
version=$("$program" --version | awk '{ print $NF }')
date=$(LC_ALL=C date -u -d "@${SOURCE_DATE_EPOCH:-$(date +%s)}" +%Y-%m-%d)

# records: a help text as lines TYPE<tab>A<tab>B: text (before the usage), usage, section (its name), item (name, words), footer.
records() {
  awk '
    { line[NR] = $0 }
    # Names stand in columns 3 to 30, words from column 31 on, on a line of their own where the name is longer.
    function is_words(i) { return line[i] != "" && substr(line[i], 1, 30) ~ /^ +$/ && substr(line[i], 31, 1) ~ /[^ ]/ }
    function words_of(i,   words) {
      words = is_words(i + 1) ? "" : substr(line[i], 31)
      while (is_words(i + 1)) { ++i; words = words (words == "" ? "" : " ") substr(line[i], 31) }
      last = i
      return words
    }
    function name_of(i,   name) {
      name = is_words(i + 1) ? substr(line[i], 3) : substr(line[i], 3, 28)
      sub(/ +$/, "", name)
      return name
    }
    END {
      for (i = 1; i <= NR; ++i) {
        if (line[i] ~ /^Usage: /) { sub(/^Usage: +/, "", line[i]); print "usage\t" line[i]; used = 1 }
        else if (used && line[i] ~ /^[A-Z][A-Za-z ]*:$/) { sub(/:$/, "", line[i]); print "section\t" line[i] }
        else if (used && line[i] ~ /^  [^ ]/) { name = name_of(i); words = words_of(i); i = last; print "item\t" name "\t" words }
        else if (line[i] != "") print (used ? "footer\t" : "text\t") line[i]
      }
    }'
}

roff() {  # roff NAME: a page from records
  awk -F '\t' -v name="$1" -v version="$version" -v date="$date" '
    function plain(s) { gsub(/\\/, "\\e", s); gsub(/-/, "\\-", s); sub(/^[.\x27]/, "\\\\\\&&", s); return s }
    BEGIN { printf ".TH %s 1 %s \"Leonhard %s\" \"User Commands\"\n.SH NAME\n", toupper(name), date, version }
    $1 == "text" { text[++texts] = $2 }
    $1 == "usage" {
      summary = text[1]; sub(/\.$/, "", summary)
      printf "%s \\- %s\n.SH SYNOPSIS\n.B %s\n", plain(name), plain(summary), plain($2)
      for (i = 2; i <= texts; ++i) { if (i == 2) print ".SH DESCRIPTION"; print plain(text[i]) }
    }
    $1 == "section" { printf ".SH %s\n", toupper($2) }
    $1 == "item" { printf ".TP\n.B %s\n%s\n", plain($2), plain($3) }
    $1 == "footer" { if (!footers++) print ".SH NOTES"; else print ".br"; print plain($2) }'
  printf '.SH SEE ALSO\n%s\n' "$2"
}

help=$("$program" --help | records)
mapfile -t subcommands < <(awk -F '\t' '$1 == "section" { inside = $2 ~ /^Subcommand/ } inside && $1 == "item" { print $2 }' <<<"$help")
if [ ${#subcommands[@]} -eq 0 ]; then
  echo "manual.sh: no subcommands in the help of $program" >&2
  exit 1
fi

bash_file=$folder/bash/leonhard zsh_file=$folder/zsh/_leonhard
pages=""
cat >"$bash_file" <<EOF
# bash completion for leonhard, made from its help
_leonhard() {
  local word=\${COMP_WORDS[COMP_CWORD]} before=\${COMP_WORDS[COMP_CWORD - 1]} options=""
  if [ "\$COMP_CWORD" -eq 1 ]; then
    mapfile -t COMPREPLY < <(compgen -W "${subcommands[*]} --help --version" -- "\$word")
    return
  fi
  case \${COMP_WORDS[1]} in
EOF
{
  printf '#compdef leonhard\n# zsh completion for leonhard, made from its help\nlocal -a commands\ncommands=(\n'
  awk -F '\t' '$1 == "section" { inside = $2 ~ /^Subcommand/ } inside && $1 == "item" { gsub(/\x27/, "\x27\\\x27\x27", $3); gsub(/:/, "\\:", $3); printf "  \x27%s:%s\x27\n", $2, $3 }' <<<"$help"
  printf ')\nif (( CURRENT == 2 )); then\n  _describe command commands\n  _arguments "--help" "--version"\n  return\nfi\ncase $words[2] in\n'
} >"$zsh_file"

for subcommand in "${subcommands[@]}"; do
  text=$("$program" "$subcommand" --help | records)
  roff "leonhard-$subcommand" ".BR leonhard (1)" <<<"$text" >"$folder/man1/leonhard-$subcommand.1"
  pages="$pages${pages:+,
}.BR leonhard\\-$subcommand (1)"
  # An option's name in the help: -k,--parts FLOAT:{one,two}=one REQUIRED
  awk -F '\t' -v subcommand="$subcommand" '
    $1 == "item" && $2 ~ /^-/ {
      names = $2; sub(/ .*/, "", names); gsub(/,/, " ", names)
      all = all (all == "" ? "" : " ") names
      if (match($2, /[{][^}]*[}]/)) {
        values = substr($2, RSTART + 1, RLENGTH - 2); gsub(/,/, " ", values)
        pattern = names; gsub(/ /, "|", pattern)
        cases = cases sprintf("        %s) mapfile -t COMPREPLY < <(compgen -W \"%s\" -- \"$word\") && return ;;\n", pattern, values)
      }
    }
    END {
      printf "    %s)\n      options=\"%s\"\n", subcommand, all
      if (cases != "") printf "      case $before in\n%s      esac\n", cases
      print "      ;;"
    }' <<<"$text" >>"$bash_file"
  awk -F '\t' -v subcommand="$subcommand" '
    BEGIN { printf "  %s)\n    _arguments", subcommand }
    $1 == "item" && $2 ~ /^-/ {
      n = split(substr($2, 1, index($2 " ", " ") - 1), names, ",")
      takes = ""
      rest = substr($2, index($2 " ", " ") + 1)
      if (rest ~ /^[A-Z]/ && rest !~ /^Excludes/) {
        takes = ":value:_files"
        if (match(rest, /[{][^}]*[}]/)) { takes = substr(rest, RSTART + 1, RLENGTH - 2); gsub(/,/, " ", takes); takes = ":value:(" takes ")" }
      }
      words = $3; gsub(/[\[\]:\\]/, "\\\\&", words); gsub(/\x27/, "\x27\\\x27\x27", words)
      for (i = 1; i <= n; ++i) printf " \\\n      \x27%s[%s]%s\x27", names[i], words, takes
    }
    END { printf " \\\n      \x27*:file:_files\x27\n    ;;\n" }' <<<"$text" >>"$zsh_file"
done

cat >>"$bash_file" <<'EOF'
  esac
  # Without a match the default: files.
  if [[ $word == -* ]]; then mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word"); fi
}
complete -o default -F _leonhard leonhard
EOF
echo 'esac' >>"$zsh_file"
roff leonhard "$pages" <<<"$help" >"$folder/man1/leonhard.1"
