# Completion of proskill for bash.

# Made by completions/generate.py from what `proskill help-data` says.

# The values of an option; of a command's first argument where the name of the command precedes it.
_proskill_values() {
  case "$1 $2" in
    'check --format') echo 'text short json sarif' ;;
    'check --color') echo 'auto always never' ;;
    'conform --color') echo 'auto always never' ;;
    'emit --color') echo 'auto always never' ;;
    'emit --outcomes') echo 'best all' ;;
    'emit --sv-automata') echo 'exact paper' ;;
    'emit emit') echo 'fiacre tina hfiacre hippo bt rl pddl promela tchecker' ;;
    'explain --color') echo 'auto always never' ;;
    'graph --kind') echo 'sv event skill body calls' ;;
    'graph --format') echo 'dot svg png' ;;
    'graph --color') echo 'auto always never' ;;
    'import import') echo 'bt gen rl' ;;
    'plan --planner') echo 'aries tamer enhsp fast-downward' ;;
    'plan --outcomes') echo 'best all' ;;
    'replay --color') echo 'auto always never' ;;
    'run --clock') echo 'real simulated Nx' ;;
    'run --format') echo 'text json' ;;
    'run --color') echo 'auto always never' ;;
    'stubs --language') echo 'python c cpp' ;;
    'stubs --color') echo 'auto always never' ;;
    'verify --format') echo 'text json junit sarif' ;;
    'verify --traces') echo 'failed all none' ;;
    'verify --graph') echo 'counts' ;;
    'verify --graph-of') echo 'classes markings untimed' ;;
    'verify --color') echo 'auto always never' ;;
    'verify --backend') echo 'engine tina both' ;;
    'verify --reduce') echo 'all none dead-variables live-variables free-inputs private-moves stubborn-sets slices refinement inclusion extrapolation' ;;
    'verify --runs') echo 'fair all' ;;
    'verify --sv-automata') echo 'exact paper' ;;
  esac
}

# What compgen completes an option with: files, directories or commands.
_proskill_kinds() {
  case "$1 $2" in
    'emit -o') echo '-f' ;;
    'emit --output') echo '-f' ;;
    'emit --leaves') echo '-f' ;;
    'graph --out-dir') echo '-d' ;;
    'graph -o') echo '-f' ;;
    'graph --output') echo '-f' ;;
    'import -o') echo '-f' ;;
    'import --output') echo '-f' ;;
    'import --leaves') echo '-f' ;;
    'lsp --log') echo '-f' ;;
    'lsp --cache') echo '-d' ;;
    'plan -o') echo '-f' ;;
    'plan --output') echo '-f' ;;
    'plan --python') echo '-c' ;;
    'run --platform') echo '-f' ;;
    'run --script') echo '-f' ;;
    'run --record') echo '-f' ;;
    'verify --properties') echo '-f' ;;
    'verify --environment') echo '-f' ;;
    'verify --save-traces') echo '-d' ;;
    'verify --report') echo '-d' ;;
    'verify --spill') echo '-d' ;;
    'verify --checkpoint') echo '-f' ;;
    'verify --frac') echo '-c' ;;
    'verify --sift') echo '-c' ;;
    'verify --tina') echo '-c' ;;
    'verify --selt') echo '-c' ;;
    'verify --ktzio') echo '-c' ;;
    'verify --cc') echo '-c' ;;
    'verify --fraclib') echo '-d' ;;
    'verify --keep') echo '-d' ;;
    'verify --difference') echo '-f' ;;
    'verify --cache') echo '-d' ;;
  esac
}

# How the names of the files end that a command reads.
_proskill_endings() {
  case "$1" in
    view) echo 'proskill json' ;;
    *) echo 'proskill fcr' ;;
  esac
}

_proskill_files() {
  local ending
  for ending in $(_proskill_endings "$1"); do compgen -f -X "!*.$ending" -- "$2"; done
  compgen -d -S / -- "$2"
}

_proskill_options() {
  case "$1" in
    check) echo '--help --fragment --style --fix --format --color' ;;
    conform) echo '--help --tolerance --edited --learn --also --time-limit --color' ;;
    dap) echo '--help --port' ;;
    emit) echo '--help --main --output --expanded --prove --color --rate --goal --leaves --outcomes --sv-automata' ;;
    explain) echo '--help --list --markdown --color' ;;
    fmt) echo '--help --check --diff' ;;
    graph) echo '--help --kind --name --forbidden --format --out-dir --output --dark --color' ;;
    import) echo '--help --output --force --leaves --main' ;;
    lsp) echo '--help --port --log --debounce --cache --no-cache --stdio' ;;
    plan) echo '--help --output --name --anml --planner --outcomes --time-limit --memory-limit --python' ;;
    replay) echo '--help --color' ;;
    run) echo '--help --main --platform --no-platform --script --clock --rate --seed --until --format --record --no-record --view --no-controls --no-open --port --groot --groot-port --realtime --controls --color' ;;
    stubs) echo '--help --language --main --color' ;;
    verify) echo '--help --property --list --properties --environment --main --format --traces --save-traces --report --graph --graph-of --durations --explain-size --strict --color --time-limit --memory-limit --spill --class-limit --checkpoint --every --backend --frac --sift --tina --selt --ktzio --cc --fraclib --keep --difference --cache --jobs --mpi --reduce --runs --expanded --sv-automata' ;;
    view) echo '--help --main --from --no-open --time-limit --memory-limit --port' ;;
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
  local kind
  kind=$(_proskill_kinds "$command" "$previous")
  if [ "$COMP_CWORD" -eq 1 ]; then
    words="check conform dap emit explain fmt graph import lsp plan replay run stubs verify view $(_proskill_options)"
  elif [ "$previous" = --property ]; then
    words=$(_proskill_properties)
  elif [ -n "$kind" ]; then
    mapfile -t COMPREPLY < <(compgen "$kind" -- "$current")
    return
  else
    words=$(_proskill_values "$command" "$previous")
    if [ -z "$words" ] && [[ "$current" == -* ]]; then words=$(_proskill_options "$command"); fi
  fi
  if [ -n "$words" ]; then
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
  else
    mapfile -t COMPREPLY < <(_proskill_files "$command" "$current")
    compopt -o nospace
  fi
}

complete -F _proskill proskill
