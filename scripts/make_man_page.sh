#!/bin/sh
# Prints the man page of a command, made by help2man from its --help and --version.
#
#   scripts/make_man_page.sh COMMAND YEAR-MONTH-DAY NAMES...    NAMES: of all commands
set -eu
command=$1
# The second form is that of BSD and macOS.
SOURCE_DATE_EPOCH=$(date -u -d "$2" +%s 2>/dev/null || date -u -j -f %Y-%m-%d "$2" +%s)
export SOURCE_DATE_EPOCH
shift 2
name=$(basename "$command")

help=$("$command" --help)
# The first paragraph of the help, as one clause.
summary=$(printf '%s\n' "$help" | sed '/^$/,$d' | tr '\n' ' ' | awk '{ sub(/\. *$/, ""); print tolower(substr($0, 1, 1)) substr($0, 2) }')

roff() { sed 's/[\\-]/\\&/g'; }

# help2man would fill the lines of the examples, and does not know what follows them.
include=$(mktemp)
trap 'rm -f "$include"' EXIT
{
  printf '[=examples]\n.nf\n'
  printf '%s\n' "$help" | sed -n '/^Examples:$/,/^$/s/^  //p' | roff
  printf '.fi\n[exit status]\n'
  printf '%s\n' "$help" | awk '/^Exit codes: / { found = 1; sub(/^Exit codes: /, "") } found' | roff
  printf '[see also]\n'
  printf '%s\n' "$@" | grep -v -x "$name" | roff | sed '$!s/$/ (1),/; $s/$/ (1)/; s/^/.BR /'
} > "$include"
help2man --no-info --section 1 --name "$summary" --include "$include" "$command"
