# Completion of proskill for fish.

function __proskill_properties
    for word in (commandline -opc)
        if string match -q '*.proskill' -- $word
            proskill verify --list $word 2>/dev/null
            return
        end
    end
end

# __proskill_option COMMANDS OPTION DESCRIPTION ARGUMENTS…: the arguments say what may follow the option.
function __proskill_option
    complete -c proskill -n "__fish_seen_subcommand_from $argv[1]" -l $argv[2] -d $argv[3] $argv[4..]
end

complete -c proskill -f
complete -c proskill -l help -d 'show help'
complete -c proskill -n __fish_use_subcommand -l version -d 'show the version'
complete -c proskill -n __fish_use_subcommand -a check -d 'say what is wrong with programs'
complete -c proskill -n __fish_use_subcommand -a explain -d 'explain a code of a diagnostic'
complete -c proskill -n __fish_use_subcommand -a fmt -d 'lay out programs'
complete -c proskill -n __fish_use_subcommand -a emit -d 'print the model that a program means'
complete -c proskill -n __fish_use_subcommand -a verify -d 'decide the properties of a program'
complete -c proskill -n __fish_use_subcommand -a graph -d 'draw a part of a program'
complete -c proskill -n __fish_use_subcommand -a view -d 'show verdicts and traces in a browser'
complete -c proskill -n __fish_use_subcommand -a lsp -d 'serve an editor'
complete -c proskill -n __fish_use_subcommand -a dap -d 'step through traces in a debugger'
complete -c proskill -n '__fish_seen_subcommand_from check fmt emit verify graph view' -ka '(__fish_complete_suffix .proskill)'
complete -c proskill -n '__fish_seen_subcommand_from view' -ka '(__fish_complete_suffix .json)'
complete -c proskill -n '__fish_seen_subcommand_from emit' -a 'fiacre tina hfiacre'

__proskill_option check format 'how to print' -x -a 'text short json sarif'
__proskill_option check fragment 'the files are parts of programs'
__proskill_option check style 'hints of style too'
__proskill_option check fix 'mend what one edit mends'
__proskill_option explain list 'all codes, a line each'
__proskill_option explain markdown 'all of them as a page'
__proskill_option fmt check 'name the files that would change'
__proskill_option fmt diff 'print what would change'
__proskill_option 'emit graph' output 'write there' -r
__proskill_option emit rate 'ticks per second' -x
__proskill_option emit prove 'prove instead of assert'
__proskill_option 'check explain emit verify graph' color 'when to use colours' -x -a 'auto always never'
__proskill_option 'emit verify view' main 'the skill that is the mission' -x
__proskill_option 'emit verify' expanded 'name every state'
__proskill_option 'emit verify' sv-automata 'form of the automata' -x -a 'exact paper'
__proskill_option verify property 'only these' -x -a '(__proskill_properties)'
__proskill_option verify environment 'a process in Fiacre for the environment' -r
__proskill_option verify properties 'more properties' -r
__proskill_option verify list 'print the names of the properties'
__proskill_option verify format 'how to print' -x -a 'text json junit sarif'
__proskill_option verify traces 'whose traces to show' -x -a 'failed all none'
__proskill_option verify save-traces 'write every trace there' -x -a '(__fish_complete_directories)'
__proskill_option verify jobs threads -x
__proskill_option 'verify view' time-limit seconds -x
__proskill_option 'verify view' memory-limit MiB -x
__proskill_option verify report 'a page with all of it there' -x -a '(__fish_complete_directories)'
__proskill_option verify class-limit classes -x
__proskill_option verify reduce 'measures to use' -x -a 'all none dead-variables live-variables open-variables safe-steps inclusion extrapolation'
__proskill_option verify graph 'write the state graph there, or counts' -r -a counts
__proskill_option verify graph-of 'what its states are' -x -a 'classes markings untimed'
__proskill_option verify backend 'who verifies' -x -a 'engine tina both'
__proskill_option verify frac 'where frac is' -r
__proskill_option verify sift 'where sift is' -r
__proskill_option verify tina 'where tina is' -r
__proskill_option verify selt 'where selt is' -r
__proskill_option verify ktzio 'where ktzio is' -r
__proskill_option verify cc 'a compiler of C' -r
__proskill_option verify fraclib 'headers of frac' -x -a '(__fish_complete_directories)'
__proskill_option verify keep 'leave the files of Tina there' -x -a '(__fish_complete_directories)'
__proskill_option verify difference 'write what differs there' -r
__proskill_option verify strict 'warnings count'
__proskill_option graph kind 'what to draw' -x -a 'sv skill body calls'
__proskill_option graph name 'which state variable or skill' -x
__proskill_option graph format 'how to print' -x -a 'dot svg png'
__proskill_option graph dark 'for a dark page'
__proskill_option graph forbidden 'forbidden moves, too'
__proskill_option graph out-dir 'each picture into a file there' -x -a '(__fish_complete_directories)'
__proskill_option view port 'of the loopback interface' -x
__proskill_option view no-open 'print the address only'
__proskill_option lsp stdio 'standard input and output'
__proskill_option lsp port 'of the loopback interface' -x
__proskill_option lsp log 'a line for each request' -r
__proskill_option dap port 'of the loopback interface' -x
__proskill_option lsp debounce 'milliseconds before diagnostics are sent' -x
