#!/usr/bin/env bash
# Completes command lines as the shells do, with the scripts of --print-completion and `gvd --completion`, and compares with --help.
#
#   check_completion.bash BIN WORK_FOLDER COMMAND...
#
# zsh and fish are tested where they are installed.
set -euo pipefail
here=$(realpath "$(dirname "$0")")
bin=$1 work=$2
shift 2

fail() { echo "check_completion: $*" >&2; exit 1; }

# complete_line COMMAND WORD...: what bash offers for the last word, a candidate a line. Call it in a subshell.
complete_line() {
  COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)) COMPREPLY=()
  set +e  # a shell that completes does not end where nothing fits
  "_${1//-/_}"
  printf '%s\n' "${COMPREPLY[@]}"
}

# expect WHAT WANTED...: the lines of standard input, in any order, are exactly WANTED.
expect() {
  local what=$1 got
  shift
  got=$(sort | tr '\n' ' ')
  [ "$got" = "$(printf '%s\n' "$@" | sort | tr '\n' ' ')" ] || fail "$what gives: $got; expected: $*"
}

rm -rf "$work"
mkdir -p "$work/scripts" "$work/files/folder"
touch "$work/files/"{report.json,mesh.ply,options.toml,"two words.json"}
cd "$work/files"

for command in "$@"; do
  help=$("$bin/$command" --help)
  for shell in bash zsh fish; do "$bin/$command" --print-completion $shell > "$work/scripts/$command.$shell"; done
  ! grep -q -e --print-completion <<< "$help" || fail "--help of $command lists --print-completion"
  "$bin/$command" --print-completion bsah 2>/dev/null && fail "$command takes an unknown shell"

  source "$work/scripts/$command.bash"
  complete -p "$command" | grep -q "_${command//-/_}" || fail "bash has no completion for $command"
  mapfile -t options < <(sed -n '1,/^Examples:/s/^  \(-[^ ,]*\(, --[^ ]*\)\?\).*/\1/p' <<< "$help" | sed 's/, /\n/')
  [ ${#options[@]} -gt 25 ] || fail "only ${#options[@]} options in --help of $command"
  complete_line "$command" mesh.ply - | expect "$command -" "${options[@]}"
  complete_line "$command" --input-f | expect "$command --input-f" --input-format

  # Every list of words that --help shows is offered, as a word of its own and behind "=". A long list goes on in the next
  # line.
  joined=$(sed -e ':more' -e '/|$/{N;s/|\n */|/;b more' -e '}' <<< "$help")
  lists=0
  while read -r option words; do
    mapfile -t words < <(tr '|' '\n' <<< "$words" | grep '[a-z]')
    complete_line "$command" "$option" "" | expect "$command $option" "${words[@]}"
    complete_line "$command" "$option" = "${words[0]}" | grep -q -x -e "${words[0]}" || fail "$option=${words[0]} is not offered"
    complete_line "$command" "$option" = | expect "$command $option=" "${words[@]}"
    lists=$((lists + 1))
  done < <(sed -n 's/^  .*\(--[a-z-]*\) \([A-Za-z-]*[a-z|][^ ]*|[^ ]*\).*/\1 \2/p' <<< "$joined" | grep -v FILE)
  [ $lists -ge 4 ] || fail "only $lists lists of words in --help of $command"

  complete_line "$command" "" | expect "$command" mesh.ply folder  # INPUT is a mesh
  complete_line "$command" --output-format ply,vt | expect "$command --output-format ply,vt" ply,vtp ply,vtu
  complete_line "$command" -o m | expect "$command -o m" mesh.ply
  complete_line "$command" --report "" | expect "$command --report" report.json folder "two words.json"
  if [ "$command" = gvd-segment ]; then
    touch labels.npy labels.csv labels.txt
    complete_line "$command" --face-labels l | expect "$command --face-labels l" labels.npy labels.csv
    rm labels.*
  fi
  complete_line "$command" --config o | expect "$command --config o" options.toml
  complete_line "$command" --output-dir "" | expect "$command --output-dir" folder
  complete_line "$command" --threads "" | expect "$command --threads" ""

  if command -v zsh >/dev/null; then zsh -n "$work/scripts/$command.zsh"; fi
  if command -v fish >/dev/null; then
    offer() { HOME=$work fish -c "source $work/scripts/$command.fish; complete -C '$command $1'" | cut -f 1; }
    offer '--on-defect ' | expect "fish: $command --on-defect" error repair largest
    offer '--input-f' | expect "fish: $command --input-f" --input-format
    offer '-o m' | expect "fish: $command -o m" mesh.ply
    offer 'm' | expect "fish: $command m" mesh.ply
    offer '--output-format ply,vt' | expect "fish: $command --output-format ply,vt" ply,vtp ply,vtu
    offer '--output-dir ' | expect "fish: $command --output-dir" folder/
    if [ "$command" = gvd-segment ]; then
      touch labels.npy labels.csv labels.txt
      offer '--face-labels ' | grep -e npy -e csv | expect "fish: $command --face-labels" labels.npy labels.csv
      rm labels.*
    fi
    offer '--config o' | expect "fish: $command --config o" options.toml
    offer '-' | grep -c -e '^--[a-z]' | expect "fish: $command -" "$(printf '%s\n' "${options[@]}" | grep -c -e '^--')"
  fi
done
# gvd offers its commands, and behind one what the command's own script offers.
names=("${@#gvd-}")
for shell in bash zsh fish; do "$bin/gvd" --completion $shell > "$work/scripts/gvd.$shell"; done
for command in "$@"; do complete -r "$command" && unset -f "_${command//-/_}"; done
source "$work/scripts/gvd.bash"
complete_line gvd "" | expect gvd "${names[@]}" help
complete_line gvd - | expect "gvd -" -h --help --version --completion
complete_line gvd re | expect "gvd re" remesh
complete_line gvd help "" | expect "gvd help" "${names[@]}"
complete_line gvd help remesh "" | expect "gvd help remesh" ""
complete_line gvd --completion z | expect "gvd --completion z" zsh
complete_line gvd --completion = | expect "gvd --completion=" bash zsh fish
complete_line gvd nothing "" | expect "gvd nothing" ""
for name in "${names[@]}"; do
  complete -p "gvd-$name" | grep -q "_gvd_$name" || fail "the script of gvd does not complete gvd-$name"
  complete_line gvd "$name" mesh.ply - | expect "gvd $name -" $(complete_line "gvd-$name" mesh.ply -)
  complete_line gvd "$name" "" | expect "gvd $name" mesh.ply folder
  complete_line gvd "$name" --on-defect "" | expect "gvd $name --on-defect" error repair largest
  complete_line gvd "$name" -o m | expect "gvd $name -o m" mesh.ply
done

if command -v zsh >/dev/null; then
  zsh -n "$work/scripts/gvd.zsh"
  mkdir -p "$work/zsh"
  cp "$work/scripts/gvd.zsh" "$work/zsh/_gvd"
  tab() { (cd "$work/files" && zsh -f "$here/complete.zsh" "$work/zsh" "$work" "$1" </dev/null); }
  tab "gvd " | expect "zsh: gvd" "${names[@]}" help
  tab "gvd help " | expect "zsh: gvd help" "${names[@]}"
  tab "gvd --v" | expect "zsh: gvd --v" --version
  tab "gvd --completion " | expect "zsh: gvd --completion" bash zsh fish
  for name in "${names[@]}"; do
    tab "gvd $name --input-f" | expect "zsh: gvd $name --input-f" --input-format
    tab "gvd $name --on-defect " | expect "zsh: gvd $name --on-defect" error repair largest
    tab "gvd $name mesh.ply --on-defect " | expect "zsh: gvd $name mesh.ply --on-defect" error repair largest
    tab "gvd $name -o m" | expect "zsh: gvd $name -o m" mesh.ply
    tab "gvd-$name --on-defect " | expect "zsh: gvd-$name --on-defect" error repair largest
  done
fi

if command -v fish >/dev/null; then
  offer() { HOME=$work fish -c "source $work/scripts/gvd.fish; complete -C '$1'" | cut -f 1; }
  offer 'gvd ' | expect "fish: gvd" "${names[@]}" help
  offer 'gvd help ' | expect "fish: gvd help" "${names[@]}"
  offer 'gvd --v' | expect "fish: gvd --v" --version
  offer 'gvd --completion ' | expect "fish: gvd --completion" bash zsh fish
  for name in "${names[@]}"; do
    offer "gvd $name --on-defect " | expect "fish: gvd $name --on-defect" error repair largest
    offer "gvd $name --input-f" | expect "fish: gvd $name --input-f" --input-format
    offer "gvd $name -o m" | expect "fish: gvd $name -o m" mesh.ply
    offer "gvd $name m" | expect "fish: gvd $name m" mesh.ply
    offer "gvd-$name m" | expect "fish: gvd-$name m" mesh.ply
  done
fi
for shell in zsh fish; do command -v $shell >/dev/null || echo "$shell is not installed: not tested"; done
echo "completions of gvd, $* are what --help lists"
