# SPDX-License-Identifier: AGPL-3.0-or-later
# Completion of ameco's commands and options for bash (zsh: after `autoload bashcompinit`). It asks
# the program itself, so that it never offers what is not there.
_ameco() {
    local word=${COMP_WORDS[COMP_CWORD]} command= i
    for ((i = 1; i < COMP_CWORD; i++)); do
        if [[ ${COMP_WORDS[i]} != -* ]]; then
            command=${COMP_WORDS[i]}
            break
        fi
    done
    local offered=
    if [[ -z $command && $word != -* ]]; then
        offered=$(ameco --help 2>/dev/null | sed -n '/^Commands:/,/^$/s/^  \([a-z]*\) .*/\1/p')
    elif [[ $word == -* ]]; then
        offered=$(ameco $command --help 2>/dev/null | grep -oE -- '^ +(-[a-zA-Z], ?)?--[a-z-]+' |
            grep -oE -- '--[a-z-]+')
    fi
    if [[ -n $offered ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$offered" -- "$word")
    else
        mapfile -t COMPREPLY < <(compgen -f -- "$word")
    fi
}
complete -o filenames -F _ameco ameco
