" Colours of Fiacre.
if exists("b:current_syntax")
  finish
endif

syntax keyword fiacreStatement begin case do else elsif end foreach from if loop of on par return select start then to unless wait where while
syntax keyword fiacreType array bool int nat none queue record sync union
syntax keyword fiacreConstant any false null true
syntax keyword fiacreOperator and append dequeue empty enqueue first full not or release until
syntax keyword fiacrePreProc absent after always before between deadlockfree duration enter event for infinitelyoften interval lasting leadsto leave ltl mortal precedes present state tag value within
syntax keyword fiacreKeyword assert channel component const extern function in init is out port priority process property prove read states task type var write
syntax match fiacreNumber "\<\d\+\>"
syntax match fiacreTag "#\h\w*"
syntax match fiacreLabel "\(\<\(from\|to\)\s\+\)\@<=\h\w*"
syntax region fiacreString start=+"+ end=+"\|$+
syntax match fiacreComment "//.*$" contains=@Spell
syntax region fiacreComment start="/\*" end="\*/" contains=@Spell

highlight default link fiacreStatement Statement
highlight default link fiacreType Type
highlight default link fiacreConstant Constant
highlight default link fiacreOperator Operator
highlight default link fiacrePreProc PreProc
highlight default link fiacreKeyword Keyword
highlight default link fiacreNumber Number
highlight default link fiacreTag Tag
highlight default link fiacreLabel Label
highlight default link fiacreString String
highlight default link fiacreComment Comment

let b:current_syntax = "fiacre"
