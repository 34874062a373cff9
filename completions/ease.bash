# Completion of `ease` for bash: commands, their options, scene files and directories.
_ease() {
  local current=$2 previous=$3 command=""
  COMPREPLY=()
  [ "$COMP_CWORD" -gt 1 ] && command=${COMP_WORDS[1]}

  case $previous in
    -o | --output | --resume)
      compopt -o filenames
      mapfile -t COMPREPLY < <(compgen -d -- "$current")
      return
      ;;
    --threads)
      return
      ;;
  esac

  local words
  case $command in
    "") words="run check garment pattern --help --version" ;;
    run) words="--output --threads --resume --force --help" ;;
    check) words="--help" ;;
    garment) words="--output --pieces --help" ;;
    pattern) words="--output --threads --help" ;;
    *) return ;;
  esac
  if [ -z "$command" ] || [[ $current == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
  else
    compopt -o filenames
    mapfile -t COMPREPLY < <(compgen -f -X '!*.toml' -- "$current" && compgen -d -- "$current" || compgen -d -- "$current")
  fi
}
complete -F _ease ease
