# SPDX-License-Identifier: GPL-3.0-or-later
# Completion of circle-voronoi for bash. It asks the program's own --help, so that there is nothing to keep in step.

_circle_voronoi() {
  local program=${COMP_WORDS[0]} current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}
  local commands command='' positionals=0 i help choices=''
  COMPREPLY=()

  # Bash takes --format=svg apart at the equals sign.
  if [[ $current == '=' ]]; then
    current=''
  elif [[ $previous == '=' ]]; then
    previous=${COMP_WORDS[COMP_CWORD - 2]}
  fi

  commands=$("$program" --help 2>/dev/null | sed -n '/^Subcommands:/,$ s/^  \([a-z]\{1,\}\) .*/\1/p')
  for ((i = 1; i < COMP_CWORD; ++i)); do
    if [[ -n $command && ${COMP_WORDS[i]} != -* ]]; then
      ((++positionals))
    elif [[ -z $command && " ${commands//$'\n'/ } " == *" ${COMP_WORDS[i]} "* ]]; then
      command=${COMP_WORDS[i]}
    fi
  done

  help=$("$program" ${command:+"$command"} --help 2>/dev/null)
  if [[ $previous == --* ]]; then
    # An option that takes one of some words, as help puts it: --format FORMAT:{json,csv}=json
    choices=$(sed -n "s/^  [^ ]*$previous [A-Z]*:{\([^}]*\)}.*/\1/p" <<<"$help")
    choices=${choices//,/ }
  fi
  if [[ -n $choices ]]; then
    :
  elif [[ $current == -* ]]; then
    choices=$(sed -n 's/^  \(-[^ ]*\).*/\1/p' <<<"$help" | tr , '\n')
  elif [[ -z $command ]]; then
    choices=$commands
  elif [[ $command == generate && $positionals -eq 0 ]]; then
    choices=$("$program" generate --list 2>/dev/null | sed 's/ .*//')
  fi
  mapfile -t COMPREPLY < <(compgen -W "$choices" -- "$current")
}

# Where there is nothing to offer, names of files are.
complete -o default -F _circle_voronoi circle-voronoi
