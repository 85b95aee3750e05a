" Colours without a tree: for as long as the parser is not built. See :ProskillBuildParser.
if exists('b:current_syntax')
  finish
endif

syntax match proskillComment ";.*$" contains=@Spell
syntax region proskillString start=+"+ skip=+\\.+ end=+"\|$+ contains=proskillEscape
syntax match proskillEscape +\\["\\nt]+ contained
syntax match proskillNumber "\v<-?\d+(\.\d+)?>"
syntax match proskillParameter "\$\h\w*"
syntax match proskillField ":\h\w*"
syntax match proskillDefinition "\v\(@<=(defconst|defsv|defevent|defskill|defresource|defproperty|defenvironment|defplatform)>"
syntax match proskillInclude "\v\(@<=include>"
syntax match proskillProperty "\v\(@<=(always|never|reachable|always_reachable|deadlockfree|infinitelyoften|leadsto|precedes|present|absent|longest|shortest|ltl)>"
syntax match proskillStatement "\v\(@<=(set|label|goto|emit|success|failure|printf|choose|race)>"
syntax match proskillConditional "\v(\(@<=(if|case)|<elseif|<else)>"
syntax match proskillRepeat "\v(\(@<=(while|do-until|do)|<until|<break)>"
syntax match proskillOperator "\v\(@<=(and|or|not|until)>"
syntax match proskillOperator "\v\(@<=[GFXUWRM]\ze\s*\("
syntax keyword proskillBoolean true false

highlight default link proskillComment Comment
highlight default link proskillString String
highlight default link proskillEscape SpecialChar
highlight default link proskillNumber Number
highlight default link proskillParameter Identifier
highlight default link proskillField Identifier
highlight default link proskillDefinition Keyword
highlight default link proskillInclude Include
highlight default link proskillProperty Operator
highlight default link proskillStatement Statement
highlight default link proskillConditional Conditional
highlight default link proskillRepeat Repeat
highlight default link proskillOperator Operator
highlight default link proskillBoolean Boolean

let b:current_syntax = 'proskill'
