# Completion of proskill for bash.

# What may follow an option; nothing: no option that takes a value from a list.
_proskill_values() {
  case "$1 $2" in
    'check --format') echo 'text short json sarif' ;;
    'verify --format') echo 'text json junit sarif' ;;
    'graph --format') echo 'dot svg png' ;;
    'graph --kind') echo 'sv skill body calls' ;;
    'verify --traces') echo 'failed all none' ;;
    'verify --reduce') echo 'all none dead-variables live-variables open-variables safe-steps inclusion extrapolation' ;;
    'verify --graph') echo 'counts' ;;
    'verify --backend') echo 'engine tina both' ;;
    'verify --graph-of') echo 'classes markings untimed' ;;
    *' --sv-automata') echo 'exact paper' ;;
    *' --color') echo 'auto always never' ;;
  esac
}

_proskill_options() {
  case "$1" in
    check) echo '--format --fragment --style --fix --color --help' ;;
    explain) echo '--list --markdown --color --help' ;;
    fmt) echo '--check --diff --help' ;;
    emit) echo '--output --expanded --rate --prove --sv-automata --main --color --help' ;;
    verify)
      echo '--property --environment --properties --list --main --format --traces --save-traces --jobs --time-limit --memory-limit
            --class-limit --report --reduce --graph --graph-of --backend --frac --sift --tina --selt --ktzio --cc
            --fraclib --keep --difference --strict --expanded --sv-automata --color --help' ;;
    graph) echo '--kind --name --format --dark --forbidden --out-dir --output --color --help' ;;
    view) echo '--main --port --no-open --time-limit --memory-limit --help' ;;
    lsp) echo '--stdio --port --log --debounce --help' ;;
    dap) echo '--port --help' ;;
    *) echo '--help --version' ;;
  esac
}

_proskill_properties() {
  local word
  for word in "${COMP_WORDS[@]:2}"; do
    case "$word" in *.proskill | *.fcr) proskill verify --list "$word" 2>/dev/null; return ;; esac
  done
}

_proskill() {
  local current="${COMP_WORDS[COMP_CWORD]}" previous="${COMP_WORDS[COMP_CWORD - 1]}"
  local command="${COMP_WORDS[1]}" words
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ]; then
    words="check explain fmt emit verify graph view lsp dap $(_proskill_options)"
  elif [ "$previous" = --property ]; then
    words=$(_proskill_properties)
  elif [ "$previous" = --save-traces ] || [ "$previous" = --report ] || [ "$previous" = --out-dir ] ||
       [ "$previous" = --keep ] || [ "$previous" = --fraclib ]; then
    mapfile -t COMPREPLY < <(compgen -d -- "$current")
    return
  else
    words=$(_proskill_values "$command" "$previous")
    if [ -z "$words" ] && [[ "$current" == -* ]]; then words=$(_proskill_options "$command"); fi
    if [ -z "$words" ] && [ "$command" = emit ] && [ "$COMP_CWORD" -eq 2 ]; then words='fiacre tina hfiacre'; fi
  fi
  if [ -n "$words" ]; then
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
  else
    mapfile -t COMPREPLY < <(compgen -f -X '!*.proskill' -- "$current"; compgen -d -S / -- "$current")
    compopt -o nospace
  fi
}

complete -F _proskill proskill
