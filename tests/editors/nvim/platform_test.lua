-- Platform files in the editor: what is typed is checked, in the file and in the program that names it.
local expect = require('expect')

local program = '(defplatform "%s")\n(defskill fly :action (fly) :success there)\n(defskill mission :body ((fly)))'
local good = '{"kind": "simulated",\n "actions": {"fly": {"duration": [1, 2]}}}'

-- The messages in a buffer whose name ends so, as one text.
local function messages(name)
  return ([[
    local all = {}
    for _, it in ipairs(vim.diagnostic.get(vim.fn.bufnr(%q))) do table.insert(all, it.message) end
    return table.concat(all, '\n')
  ]]):format(name)
end

local function has(name, part)
  return ('return (function() %s end)():find(%q, 1, true) ~= nil'):format(messages(name), part)
end

local function has_none(name)
  return ("return (function() %s end)() == ''"):format(messages(name))
end

-- Opens a program, and then the platform file that it names.
local function both(child, file)
  child:file(file, good)
  child:open(child:file('main.proskill', program:format(file)))
  child:edit(child.directory .. '/' .. file)
end

local function misspell(child)
  child:at('"|fly"')
  child:keys('cwflyy<Esc>')
end

return {
  { 'what is typed in a platform file is checked before it is saved', function(child)
    both(child, 'robot.platform.json')
    misspell(child)
    child:wait(has('robot.platform.json', 'there is no basic skill `flyy`'))
    child:wait(has('main.proskill', 'flyy'))
    local it = child:lua('return vim.diagnostic.get(0)[1]')
    expect.equal({ it.lnum, it.source }, { 1, 'proskill' })
    expect.equal(child:lua('return vim.bo.modified'), true)
    child:keys('u')
    child:wait(has_none('robot.platform.json'))
    child:wait(has_none('main.proskill'))
  end },

  { 'while it is typed, too', function(child)
    both(child, 'platform.json')
    child:at('"|fly"')
    child:keys('cwflow')
    child:wait(has('platform.json', 'there is no basic skill `flow`'))
    expect.equal(child:lua('return vim.fn.mode()'), 'i')
  end },

  { 'a file with any name is checked as long as an open program names it', function(child)
    both(child, 'sky.json')
    misspell(child)
    child:wait(has('sky.json', 'there is no basic skill `flyy`'))
    child:lua("vim.cmd('buffer main.proskill')")
    child:at('|(defplatform')
    child:keys('dd')
    child:wait(has_none('sky.json'))
    child:keys('u')
    child:wait(has('sky.json', 'there is no basic skill `flyy`'))
  end },

  { 'the file may be open before the program', function(child)
    child:edit(child:file('robot.platform.json', good))
    misspell(child)
    child:open(child:file('main.proskill', program:format('robot.platform.json')))
    child:wait(has('robot.platform.json', 'there is no basic skill `flyy`'))
  end },

  { 'a file that is closed without saving is read from the disk again', function(child)
    both(child, 'robot.platform.json')
    misspell(child)
    child:wait(has('main.proskill', 'flyy'))
    child:lua("vim.cmd('bdelete! robot.platform.json')")
    child:wait(has_none('main.proskill'))
  end },

  { 'the server has no part in the other features of a JSON file', function(child)
    both(child, 'robot.platform.json')
    misspell(child)
    child:wait(has('robot.platform.json', 'flyy'))
    expect.equal(child:lua("return require('proskill.client').of(0) == nil"), true)
    expect.equal(child:lua("return vim.fn.maparg('gO', 'n', false, true).buffer == 1"), false)
  end },

  { 'after a restart of the server a file is checked as before', function(child)
    both(child, 'robot.platform.json')
    misspell(child)
    child:wait(has('robot.platform.json', 'flyy'))
    child:lua("before = vim.tbl_map(function(it) return it.id end, require('proskill.client').all()); vim.cmd('ProskillRestart')")
    child:wait("local now = require('proskill.client').all() return #now == 1 and not vim.tbl_contains(before, now[1].id)")
    child:at('"|flyy"')
    child:keys('cwsoar<Esc>')
    child:wait(has('robot.platform.json', 'there is no basic skill `soar`'))
  end },
}
