# Completion of proskill for fish. Made by completions/generate.py.

function __proskill_properties
    for word in (commandline -opc)
        if string match -q '*.proskill' -- $word
            proskill verify --list $word 2>/dev/null
            return
        end
    end
end

complete -c proskill -f
complete -c proskill -n __fish_use_subcommand -l version -d 'show the version'
complete -c proskill -n __fish_use_subcommand -a check -d 'Find errors in programs'
complete -c proskill -n '__fish_seen_subcommand_from check' -s h -l help -d 'Print this help message and exit'
complete -c proskill -n '__fish_seen_subcommand_from check' -l fragment -d 'The files are parts of programs: names defined elsewhere are only hints'
complete -c proskill -n '__fish_seen_subcommand_from check' -l style -d 'Report hints on style too'
complete -c proskill -n '__fish_seen_subcommand_from check' -l fix -d 'Apply the fixes that are safe to the files, then report what is left'
complete -c proskill -n '__fish_seen_subcommand_from check' -l format -d 'How to print findings; short: one line each (default text)' -x -a 'text short json sarif'
complete -c proskill -n '__fish_seen_subcommand_from check' -l color -d 'Colours; auto: on a terminal where NO_COLOR is not set (default auto)' -x -a 'auto always never'
complete -c proskill -n '__fish_seen_subcommand_from check' -ka '(__fish_complete_suffix .proskill)'
complete -c proskill -n '__fish_seen_subcommand_from check' -ka '(__fish_complete_suffix .fcr)'
complete -c proskill -n __fish_use_subcommand -a conform -d 'Check whether a recorded run is a run of the verified model'
complete -c proskill -n '__fish_seen_subcommand_from conform' -s h -l help -d 'Print this help message and exit'
complete -c proskill -n '__fish_seen_subcommand_from conform' -l tolerance -d 'Tolerance on the intervals of actions, in seconds (default 0)' -x
complete -c proskill -n '__fish_seen_subcommand_from conform' -l edited -d 'Ignore where in the program steps are: it has been edited since the recording'
complete -c proskill -n '__fish_seen_subcommand_from conform' -l learn -d 'Widen the intervals that actions did not keep, and show which verdicts change then'
complete -c proskill -n '__fish_seen_subcommand_from conform' -l also -d 'With --learn: another recording to learn from; may be repeated' -x
complete -c proskill -n '__fish_seen_subcommand_from conform' -l time-limit -d 'With --learn: time limit of the verifications in seconds (default 60); properties not decided by then are listed' -x
complete -c proskill -n '__fish_seen_subcommand_from conform' -l color -d 'Colours; auto: on a terminal where NO_COLOR is not set (default auto)' -x -a 'auto always never'
complete -c proskill -n '__fish_seen_subcommand_from conform' -ka '(__fish_complete_suffix .proskill)'
complete -c proskill -n '__fish_seen_subcommand_from conform' -ka '(__fish_complete_suffix .fcr)'
complete -c proskill -n __fish_use_subcommand -a dap -d 'Step through traces and simulations in a debugger (Debug Adapter Protocol)'
complete -c proskill -n '__fish_seen_subcommand_from dap' -s h -l help -d 'Print this help message and exit'
complete -c proskill -n '__fish_seen_subcommand_from dap' -l port -d 'Wait for one client on this port of the loopback interface (0: any free port) instead of standard input' -x
complete -c proskill -n __fish_use_subcommand -a emit -d 'Print a program as a Fiacre model, or in another language'
complete -c proskill -n '__fish_seen_subcommand_from emit' -s h -l help -d 'Print this help message and exit'
complete -c proskill -n '__fish_seen_subcommand_from emit' -l main -d 'Skill to use as the mission, if several are possible' -x
complete -c proskill -n '__fish_seen_subcommand_from emit' -s o -l output -d 'Write to this file instead of standard output; hippo: the directory' -r
complete -c proskill -n '__fish_seen_subcommand_from emit' -l expanded -d 'fiacre: one state per step of a skill, easier to read'
complete -c proskill -n '__fish_seen_subcommand_from emit' -l prove -d 'Write `prove` instead of `assert` for each property'
complete -c proskill -n '__fish_seen_subcommand_from emit' -l color -d 'Colours; auto: on a terminal where NO_COLOR is not set (default auto)' -x -a 'auto always never'
complete -c proskill -n '__fish_seen_subcommand_from emit' -l rate -d 'hfiacre, hippo: ticks per second (default 100)' -x
complete -c proskill -n '__fish_seen_subcommand_from emit' -l goal -d 'pddl: write the problem of making this condition true' -x
complete -c proskill -n '__fish_seen_subcommand_from emit' -l leaves -d 'bt: write the durations and results of the leaves to this file' -r
complete -c proskill -n '__fish_seen_subcommand_from emit' -l outcomes -d 'pddl: best: skills succeed; all: a planner may choose failures, too (default best)' -x -a 'best all'
complete -c proskill -n '__fish_seen_subcommand_from emit' -l sv-automata -d 'exact: detect every forbidden move of a state variable; paper: poll, as the paper does (default exact)' -x -a 'exact paper'
complete -c proskill -n '__fish_seen_subcommand_from emit' -a 'fiacre tina hfiacre hippo bt rl pddl promela tchecker'
complete -c proskill -n '__fish_seen_subcommand_from emit' -ka '(__fish_complete_suffix .proskill)'
complete -c proskill -n '__fish_seen_subcommand_from emit' -ka '(__fish_complete_suffix .fcr)'
complete -c proskill -n __fish_use_subcommand -a explain -d 'Explain a diagnostic, with an example'
complete -c proskill -n '__fish_seen_subcommand_from explain' -s h -l help -d 'Print this help message and exit'
complete -c proskill -n '__fish_seen_subcommand_from explain' -l list -d 'List all codes, one line each'
complete -c proskill -n '__fish_seen_subcommand_from explain' -l markdown -d 'Print all of them as a manual page'
complete -c proskill -n '__fish_seen_subcommand_from explain' -l color -d 'Colours; auto: on a terminal where NO_COLOR is not set (default auto)' -x -a 'auto always never'
complete -c proskill -n __fish_use_subcommand -a fmt -d 'Format programs and models in Fiacre (.fcr)'
complete -c proskill -n '__fish_seen_subcommand_from fmt' -s h -l help -d 'Print this help message and exit'
complete -c proskill -n '__fish_seen_subcommand_from fmt' -l check -d 'Change nothing; list the files that would change'
complete -c proskill -n '__fish_seen_subcommand_from fmt' -l diff -d 'Change nothing; print what would change'
complete -c proskill -n '__fish_seen_subcommand_from fmt' -ka '(__fish_complete_suffix .proskill)'
complete -c proskill -n '__fish_seen_subcommand_from fmt' -ka '(__fish_complete_suffix .fcr)'
complete -c proskill -n __fish_use_subcommand -a graph -d 'Draw state variables, skills, bodies and calls'
complete -c proskill -n '__fish_seen_subcommand_from graph' -s h -l help -d 'Print this help message and exit'
complete -c proskill -n '__fish_seen_subcommand_from graph' -l kind -d 'A state variable, an event, a skill, the body of a skill, or who calls whom' -x -a 'sv event skill body calls'
complete -c proskill -n '__fish_seen_subcommand_from graph' -l name -d 'Which state variable, event, skill or environment to draw' -x
complete -c proskill -n '__fish_seen_subcommand_from graph' -l forbidden -d 'Draw the forbidden moves of state variables too'
complete -c proskill -n '__fish_seen_subcommand_from graph' -l format -d 'Image format (default: by the name of the output, else svg)' -x -a 'dot svg png'
complete -c proskill -n '__fish_seen_subcommand_from graph' -l out-dir -d 'Draw everything, one file each, into this directory' -x -a '(__fish_complete_directories)'
complete -c proskill -n '__fish_seen_subcommand_from graph' -s o -l output -d 'Write to this file instead of standard output' -r
complete -c proskill -n '__fish_seen_subcommand_from graph' -l dark -d 'Colours for a dark background'
complete -c proskill -n '__fish_seen_subcommand_from graph' -l color -d 'Colours; auto: on a terminal where NO_COLOR is not set (default auto)' -x -a 'auto always never'
complete -c proskill -n '__fish_seen_subcommand_from graph' -ka '(__fish_complete_suffix .proskill)'
complete -c proskill -n '__fish_seen_subcommand_from graph' -ka '(__fish_complete_suffix .fcr)'
complete -c proskill -n __fish_use_subcommand -a import -d 'Translate a program of another language'
complete -c proskill -n '__fish_seen_subcommand_from import' -s h -l help -d 'Print this help message and exit'
complete -c proskill -n '__fish_seen_subcommand_from import' -s o -l output -d 'Write to this file instead of standard output' -r
complete -c proskill -n '__fish_seen_subcommand_from import' -l force -d 'Replace the output even if it was edited since it was imported'
complete -c proskill -n '__fish_seen_subcommand_from import' -l leaves -d 'bt, gen: durations and results of actions, conditions and services, as JSON' -r
complete -c proskill -n '__fish_seen_subcommand_from import' -l main -d 'bt: tree to import (default: the `main_tree_to_execute`)' -x
complete -c proskill -n '__fish_seen_subcommand_from import' -a 'bt gen rl'
complete -c proskill -n '__fish_seen_subcommand_from import' -ka '(__fish_complete_suffix .proskill)'
complete -c proskill -n '__fish_seen_subcommand_from import' -ka '(__fish_complete_suffix .fcr)'
complete -c proskill -n __fish_use_subcommand -a lsp -d 'Serve an editor (Language Server Protocol)'
complete -c proskill -n '__fish_seen_subcommand_from lsp' -s h -l help -d 'Print this help message and exit'
complete -c proskill -n '__fish_seen_subcommand_from lsp' -l port -d 'Wait for one client on this port of the loopback interface (0: any free port) instead of standard input' -x
complete -c proskill -n '__fish_seen_subcommand_from lsp' -l log -d 'Append one line per request to this file' -r
complete -c proskill -n '__fish_seen_subcommand_from lsp' -l debounce -d 'Wait this long after the last edit before reporting (default 50)' -x
complete -c proskill -n '__fish_seen_subcommand_from lsp' -l cache -d 'Keep verdicts in this directory (default: proskill/verdicts in the user\'s cache directory)' -x -a '(__fish_complete_directories)'
complete -c proskill -n '__fish_seen_subcommand_from lsp' -l no-cache -d 'Keep no verdicts'
complete -c proskill -n '__fish_seen_subcommand_from lsp' -l stdio -d 'Use standard input and output, as by default'
complete -c proskill -n __fish_use_subcommand -a plan -d 'Write a mission by a planner, and verify it'
complete -c proskill -n '__fish_seen_subcommand_from plan' -s h -l help -d 'Print this help message and exit'
complete -c proskill -n '__fish_seen_subcommand_from plan' -s o -l output -d 'Write to this file instead of standard output' -r
complete -c proskill -n '__fish_seen_subcommand_from plan' -l name -d 'Name of the mission (default plan)' -x
complete -c proskill -n '__fish_seen_subcommand_from plan' -l anml -d 'Write the planning problem in ANML instead of a plan'
complete -c proskill -n '__fish_seen_subcommand_from plan' -l planner -d 'Planner to use (default: the first that is installed and finds a plan)' -x -a 'aries tamer enhsp fast-downward'
complete -c proskill -n '__fish_seen_subcommand_from plan' -l outcomes -d 'best: skills succeed; all: the planner may choose failures, too (default best)' -x -a 'best all'
complete -c proskill -n '__fish_seen_subcommand_from plan' -l time-limit -d 'Time limit of each call of a planner, in seconds (default 60)' -x
complete -c proskill -n '__fish_seen_subcommand_from plan' -l memory-limit -d 'Memory limit of a planner, in MiB (default 4096)' -x
complete -c proskill -n '__fish_seen_subcommand_from plan' -l python -d 'Python with the package unified-planning (default python3)' -r
complete -c proskill -n '__fish_seen_subcommand_from plan' -ka '(__fish_complete_suffix .proskill)'
complete -c proskill -n '__fish_seen_subcommand_from plan' -ka '(__fish_complete_suffix .fcr)'
complete -c proskill -n __fish_use_subcommand -a replay -d 'Replay saved runs, and compare how they end'
complete -c proskill -n '__fish_seen_subcommand_from replay' -s h -l help -d 'Print this help message and exit'
complete -c proskill -n '__fish_seen_subcommand_from replay' -l color -d 'Colours; auto: on a terminal where NO_COLOR is not set (default auto)' -x -a 'auto always never'
complete -c proskill -n '__fish_seen_subcommand_from replay' -ka '(__fish_complete_suffix .proskill)'
complete -c proskill -n '__fish_seen_subcommand_from replay' -ka '(__fish_complete_suffix .fcr)'
complete -c proskill -n __fish_use_subcommand -a run -d 'Execute a program on a robot, or on a simulated one'
complete -c proskill -n '__fish_seen_subcommand_from run' -s h -l help -d 'Print this help message and exit'
complete -c proskill -n '__fish_seen_subcommand_from run' -l main -d 'Skill to use as the mission, if several are possible' -x
complete -c proskill -n '__fish_seen_subcommand_from run' -l platform -d 'Platform that performs the actions (JSON): a program, a library, ROS 1 or 2, or a simulation; default: the one that the program names by `defplatform`, else a simulation' -r
complete -c proskill -n '__fish_seen_subcommand_from run' -l no-platform -d 'Simulate everything, although the program names a platform'
complete -c proskill -n '__fish_seen_subcommand_from run' -l script -d 'Script of a simulation (JSON): results, events, interrupts' -r
complete -c proskill -n '__fish_seen_subcommand_from run' -l clock -d 'Real time, N times real time (10x), or simulated: time jumps to the next step (default of a simulation)' -x -a 'real simulated Nx'
complete -c proskill -n '__fish_seen_subcommand_from run' -l rate -d 'Take steps at ticks only: so many per second (default: at any time)' -x
complete -c proskill -n '__fish_seen_subcommand_from run' -l seed -d 'Seed of a simulation (default 0); the same seed gives the same run' -x
complete -c proskill -n '__fish_seen_subcommand_from run' -l until -d 'End the run after this time, in seconds or with m, h, d (a simulation: 1d)' -x
complete -c proskill -n '__fish_seen_subcommand_from run' -l format -d 'How to print what happens (default text)' -x -a 'text json'
complete -c proskill -n '__fish_seen_subcommand_from run' -l record -d 'Record the run in this file, as a trace that `proskill view` opens; a name that ends in .mcap: as MCAP, in .btlog: as a log of a behavior tree, for other tools. Default: nowhere in a simulation, otherwise a new file of the user' -r
complete -c proskill -n '__fish_seen_subcommand_from run' -l no-record -d 'Do not record the run of a robot'
complete -c proskill -n '__fish_seen_subcommand_from run' -l view -d 'Show the run in a browser while it happens, and afterwards until Ctrl-C; in simulated time it begins paused'
complete -c proskill -n '__fish_seen_subcommand_from run' -l no-controls -d 'With --view: pages cannot pause the run, or send events and interrupts'
complete -c proskill -n '__fish_seen_subcommand_from run' -l no-open -d 'With --view: print the address without opening a browser'
complete -c proskill -n '__fish_seen_subcommand_from run' -l port -d 'With --view: port on the loopback interface (0, the default: any free port)' -x
complete -c proskill -n '__fish_seen_subcommand_from run' -l groot -d 'Let Groot2 and other viewers of behavior trees watch the run, and afterwards until Ctrl-C; composite skills are shown as trees'
complete -c proskill -n '__fish_seen_subcommand_from run' -l groot-port -d 'With --groot: port of requests on the loopback interface, the next one is for messages (default 1667; 0: any free ones)' -x
complete -c proskill -n '__fish_seen_subcommand_from run' -l realtime -d 'Lock the memory and ask for SCHED_FIFO; report what is refused'
complete -c proskill -n '__fish_seen_subcommand_from run' -l controls -d 'With --realtime: pages of --view and viewers of --groot may influence the run all the same'
complete -c proskill -n '__fish_seen_subcommand_from run' -l color -d 'Colours; auto: on a terminal where NO_COLOR is not set (default auto)' -x -a 'auto always never'
complete -c proskill -n '__fish_seen_subcommand_from run' -ka '(__fish_complete_suffix .proskill)'
complete -c proskill -n '__fish_seen_subcommand_from run' -ka '(__fish_complete_suffix .fcr)'
complete -c proskill -n __fish_use_subcommand -a stubs -d 'Write a typed function for each action of a program, to be filled in'
complete -c proskill -n '__fish_seen_subcommand_from stubs' -s h -l help -d 'Print this help message and exit'
complete -c proskill -n '__fish_seen_subcommand_from stubs' -l language -d 'The language of the functions (default python)' -x -a 'python c cpp'
complete -c proskill -n '__fish_seen_subcommand_from stubs' -l main -d 'Skill to use as the mission, if several are possible' -x
complete -c proskill -n '__fish_seen_subcommand_from stubs' -l color -d 'Colours; auto: on a terminal where NO_COLOR is not set (default auto)' -x -a 'auto always never'
complete -c proskill -n '__fish_seen_subcommand_from stubs' -ka '(__fish_complete_suffix .proskill)'
complete -c proskill -n '__fish_seen_subcommand_from stubs' -ka '(__fish_complete_suffix .fcr)'
complete -c proskill -n __fish_use_subcommand -a verify -d 'Verify the properties of a program'
complete -c proskill -n '__fish_seen_subcommand_from verify' -s h -l help -d 'Print this help message and exit'
complete -c proskill -n '__fish_seen_subcommand_from verify' -l property -d 'Verify only this property, or all whose names begin with this word and a dot; may be repeated' -x -a '(__proskill_properties)'
complete -c proskill -n '__fish_seen_subcommand_from verify' -l list -d 'List the names of the properties, and stop'
complete -c proskill -n '__fish_seen_subcommand_from verify' -l properties -d 'Verify the properties of this file too: Fiacre, or one formula (.ltl)' -r
complete -c proskill -n '__fish_seen_subcommand_from verify' -l environment -d 'Replace the environment by the Fiacre process in this file' -r
complete -c proskill -n '__fish_seen_subcommand_from verify' -l main -d 'Skill to use as the mission, if several are possible' -x
complete -c proskill -n '__fish_seen_subcommand_from verify' -l format -d 'How to print verdicts (default text)' -x -a 'text json junit sarif'
complete -c proskill -n '__fish_seen_subcommand_from verify' -l traces -d 'Which traces to print: of failed properties, all, or none (default failed)' -x -a 'failed all none'
complete -c proskill -n '__fish_seen_subcommand_from verify' -l save-traces -d 'Save every trace in this directory, as JSON and text' -x -a '(__fish_complete_directories)'
complete -c proskill -n '__fish_seen_subcommand_from verify' -l report -d 'Write a web page with verdicts, traces and pictures to this directory' -x -a '(__fish_complete_directories)'
complete -c proskill -n '__fish_seen_subcommand_from verify' -l graph -d 'Write the state graph to this file (.aut or .txt), or print its size (counts)' -r -a counts
complete -c proskill -n '__fish_seen_subcommand_from verify' -l graph-of -d 'States of that graph: state classes, markings, or markings without time (default classes)' -x -a 'classes markings untimed'
complete -c proskill -n '__fish_seen_subcommand_from verify' -l durations -d 'Also print how long each skill takes at least and at most'
complete -c proskill -n '__fish_seen_subcommand_from verify' -l explain-size -d 'Also explain which variables, clocks and processes multiply the states'
complete -c proskill -n '__fish_seen_subcommand_from verify' -l strict -d 'Exit with 1 for warnings too'
complete -c proskill -n '__fish_seen_subcommand_from verify' -l color -d 'Colours; auto: on a terminal where NO_COLOR is not set (default auto)' -x -a 'auto always never'
complete -c proskill -n '__fish_seen_subcommand_from verify' -l time-limit -d 'Time limit in seconds (default: none); properties not decided by then are inconclusive' -x
complete -c proskill -n '__fish_seen_subcommand_from verify' -l memory-limit -d 'Memory limit in MiB (default: none)' -x
complete -c proskill -n '__fish_seen_subcommand_from verify' -l spill -d 'Keep the states of a search that needs more memory than its limit in this directory; nothing is left there at the end' -x -a '(__fish_complete_directories)'
complete -c proskill -n '__fish_seen_subcommand_from verify' -l class-limit -d 'Limit of explored state classes (default: none)' -x
complete -c proskill -n '__fish_seen_subcommand_from verify' -l checkpoint -d 'Save the state of a long search in this file, and go on from there if it exists; it is removed at the end' -r
complete -c proskill -n '__fish_seen_subcommand_from verify' -l every -d 'Seconds between two checkpoints (default 60); more if writing would take over a tenth of the time' -x
complete -c proskill -n '__fish_seen_subcommand_from verify' -l backend -d 'Verify with the built-in engine, with the Tina tools, or with both and compare (default engine)' -x -a 'engine tina both'
complete -c proskill -n '__fish_seen_subcommand_from verify' -l frac -d 'Path of `frac` (default: the variable PROSKILL_FRAC, else PATH)' -r
complete -c proskill -n '__fish_seen_subcommand_from verify' -l sift -d 'Path of `sift` (default: the variable PROSKILL_SIFT, else PATH)' -r
complete -c proskill -n '__fish_seen_subcommand_from verify' -l tina -d 'Path of `tina` (default: the variable PROSKILL_TINA, else PATH)' -r
complete -c proskill -n '__fish_seen_subcommand_from verify' -l selt -d 'Path of `selt` (default: the variable PROSKILL_SELT, else PATH)' -r
complete -c proskill -n '__fish_seen_subcommand_from verify' -l ktzio -d 'Path of `ktzio` (default: the variable PROSKILL_KTZIO, else PATH)' -r
complete -c proskill -n '__fish_seen_subcommand_from verify' -l cc -d 'Path of a C compiler (default: CC, else `cc`)' -r
complete -c proskill -n '__fish_seen_subcommand_from verify' -l fraclib -d 'Directory of frac\'s headers (default: the variable FRACLIB)' -x -a '(__fish_complete_directories)'
complete -c proskill -n '__fish_seen_subcommand_from verify' -l keep -d 'Run the tools in this new directory, and keep their files' -x -a '(__fish_complete_directories)'
complete -c proskill -n '__fish_seen_subcommand_from verify' -l difference -d 'both: write a report of differences to this file (default proskill-difference.md)' -r
complete -c proskill -n '__fish_seen_subcommand_from verify' -l cache -d 'Keep verdicts in this directory, and use those that are kept there' -x -a '(__fish_complete_directories)'
complete -c proskill -n '__fish_seen_subcommand_from verify' -l jobs -d 'Threads for a long search (default: one for each processor, at most 8); results do not depend on their number' -x
complete -c proskill -n '__fish_seen_subcommand_from verify' -l mpi -d 'Share a long search with the other processes that `mpirun` has started'
complete -c proskill -n '__fish_seen_subcommand_from verify' -l reduce -d 'Reductions of the state space, separated by commas; verdicts do not depend on them' -x -a 'all none dead-variables live-variables free-inputs private-moves stubborn-sets slices refinement inclusion extrapolation'
complete -c proskill -n '__fish_seen_subcommand_from verify' -l runs -d 'Which infinite runs count for your properties that do not say :fair. fair: time goes on, and actions without a time limit end; all: every run, as in Tina (default fair)' -x -a 'fair all'
complete -c proskill -n '__fish_seen_subcommand_from verify' -l expanded -d 'Verify the expanded model, with one state per step of a skill'
complete -c proskill -n '__fish_seen_subcommand_from verify' -l sv-automata -d 'exact: detect every forbidden move of a state variable; paper: poll, as the paper does (default exact)' -x -a 'exact paper'
complete -c proskill -n '__fish_seen_subcommand_from verify' -ka '(__fish_complete_suffix .proskill)'
complete -c proskill -n '__fish_seen_subcommand_from verify' -ka '(__fish_complete_suffix .fcr)'
complete -c proskill -n __fish_use_subcommand -a view -d 'Show verdicts, traces and automata in a browser, live'
complete -c proskill -n '__fish_seen_subcommand_from view' -s h -l help -d 'Print this help message and exit'
complete -c proskill -n '__fish_seen_subcommand_from view' -l main -d 'Skill to use as the mission, if several are possible' -x
complete -c proskill -n '__fish_seen_subcommand_from view' -l from -d 'Show the part of a long recording that begins at this time of its run, in seconds or with m, h, d; default: the last part' -x
complete -c proskill -n '__fish_seen_subcommand_from view' -l no-open -d 'Print the address without opening a browser'
complete -c proskill -n '__fish_seen_subcommand_from view' -l time-limit -d 'Time limit of a verification in seconds (default 60); properties not decided by then are inconclusive' -x
complete -c proskill -n '__fish_seen_subcommand_from view' -l memory-limit -d 'Memory limit of a verification in MiB (default 2048)' -x
complete -c proskill -n '__fish_seen_subcommand_from view' -l port -d 'Port on the loopback interface (0, the default: any free port)' -x
complete -c proskill -n '__fish_seen_subcommand_from view' -ka '(__fish_complete_suffix .proskill)'
complete -c proskill -n '__fish_seen_subcommand_from view' -ka '(__fish_complete_suffix .json)'
