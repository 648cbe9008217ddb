#!/usr/bin/env zsh
# Prints what zsh offers at the end of a command line, a candidate a line.
#
#   zsh -f complete.zsh FUNCTIONS WORK_FOLDER LINE     FUNCTIONS: the folder of completion functions
#
# zsh completes only a line that it edits. So another zsh edits it on a terminal of its own, where `compadd`, which every completion
# ends in, also writes down what fits; it exits after the first completion.
zmodload zsh/zpty
candidates=$2/candidates
: > $candidates
cat > $2/shell.zsh <<END
fpath=(${(q)1} \$fpath)
candidates=${(q)candidates}
END
cat >> $2/shell.zsh <<'END'
PS1= PS2=
autoload -Uz compinit
compinit -u -D
bindkey '^I' complete-word
zstyle ':completion:*' insert-tab false
comppostfuncs=(exit)
compadd() {
  local -a options=("${(@)@[1,(i)(-|--)]}") fits
  if (( ! ${#${(M)options:#-[OAD]}} )); then
    builtin compadd -A fits "$@"
    (( $#fits )) && print -rl -- $fits >> $candidates
  fi
  builtin compadd "$@"
}
END
zpty shell zsh -f -i
zpty -w shell "source ${(q)2}/shell.zsh"
zpty -n -w shell "$3"$'\t'
while zpty -r shell text; do :; done
sort -u $candidates
