-- Verdicts and traces.
local expect = require('expect')

local function drone(child)
  child:lua([[
    told = {}
    vim.notify = function(text) table.insert(told, text) end
  ]])
  child:open(child:copy('drone') .. '/drone.proskill')
end

-- The lamp is on after the first call.
local kLamp = [[
(defsv lamp :states (Off On) :init Off)
(defskill mission
  :body
    ((skill)))
(defskill skill
  :action (a)
  :start (lamp On))
(defproperty dark (never (lamp On)))
]]

local function stop_server(child)
  child:lua("vim.lsp.stop_client(vim.tbl_map(function(it) return it.id end, require('proskill.client').all()))")
  child:wait("return require('proskill.client').of(0) == nil")
end

local function trace(child, name)
  child:lua("vim.cmd('ProskillTrace ' .. ...)", name)
  child:wait("return require('proskill.trace').shown ~= nil")
end

-- The virtual text after lines, with the line numbers.
local notes = [[
  local space = vim.api.nvim_get_namespaces()['proskill.trace']
  for _, mark in ipairs(vim.api.nvim_buf_get_extmarks(0, space, 0, -1, { details = true })) do
    if mark[4].virt_text then
      local words = vim.tbl_map(function(chunk) return chunk[1] end, mark[4].virt_text)
      return { mark[2] + 1, table.concat(words) }
    end
  end
]]

local values = [[
  for _, buffer in ipairs(vim.api.nvim_list_bufs()) do
    if vim.api.nvim_buf_get_name(buffer):find('proskill://values', 1, true) then
      return vim.api.nvim_buf_get_lines(buffer, 0, -1, true)
    end
  end
]]

local function step_at(number)
  return ("return require('proskill.trace').shown.at == %d"):format(number)
end

return {
  { 'verdicts that are bad come into the quickfix list, the worst counted', function(child)
    drone(child)
    child:lua("vim.cmd('ProskillVerify')")
    child:wait("return #vim.fn.getqflist() > 0")
    local list = child:lua("return vim.fn.getqflist({ title = 1, items = 1 })")
    expect.contains(list.title, 'properties: ')
    expect.contains(list.title, ' 3 bad, 21 warnings')
    expect.equal(#list.items, 24)
    local found
    for _, item in ipairs(list.items) do
      if item.module == 'uav_mission.no_overshoot' then found = item end
    end
    expect.equal({ found.type, found.lnum, found.col }, { 'E', 162, 18 })
    expect.contains(found.text, '`uav_mission` takes at most 120 s from its start: violated')
    child:lua("vim.cmd('ProskillVerify! takeoff')")
    child:wait([[
      local kinds = {}
      for _, item in ipairs(vim.fn.getqflist()) do kinds[item.type] = true end
      return kinds.I and #vim.fn.getqflist() < 24
    ]])
  end },

  { 'a trace is gone through, step by step, with what each has changed', function(child)
    drone(child)
    trace(child, 'uav_mission.no_overshoot')
    local list = child:lua("return vim.fn.getqflist({ title = 1, items = 1, idx = 0 })")
    expect.equal(list.title, 'trace of uav_mission.no_overshoot')
    expect.equal(list.idx, 1)
    expect.contains(list.items[1].text, 'takes at most 120 s from its start: violated')
    expect.contains(list.items[7].text, '1 … 5 s  start_drone: fails with `motors_dead`')
    expect.contains(list.items[7].text, 'start_drone.status: no_status → failure')
    expect.contains(list.items[10].text, '>120 s …')

    expect.equal(child:lua('return told'), { 'proskill: 9 steps; :cnext and :cprevious step, in the list ] and [; m: only the relevant steps, q ends' })
    child:lua("require('proskill.trace').next()")
    child:wait(step_at(1))
    local note = child:lua(notes)
    expect.equal(note[1], 161)
    expect.contains(note[2], 'step 1 of 9')
    expect.contains(note[2], 'mission_status: Unknown → Ongoing')
    expect.equal(child:lua("return vim.fn.line('.')"), 161)
    local shown = table.concat(child:lua(values), '\n')
    expect.contains(shown, '~ mission_status')
    expect.contains(shown, 'Unknown → Ongoing')
    expect.contains(shown, '  battery')

    -- Only relevant steps: the others do not affect the duration of the mission.
    child:lua("require('proskill.trace').toggle_relevant()")
    child:lua("require('proskill.trace').next()")
    child:wait(step_at(4))
    expect.contains(child:lua(notes)[2], 'why: step 1: uav_mission starts')
  end },

  { 'variables are listed by their numbers', function(child)
    local names = child:lua([[
      return require('proskill.steps').variables({ initial = { s10 = '', s2 = '', s02 = '', room = '', ['k10.status'] = '', ['k9.status'] = '' } })
    ]])
    expect.equal(names, { 'room', 's02', 's2', 's10', 'k9.status', 'k10.status' })
  end },

  { 'the quickfix list\'s own commands go through the trace', function(child)
    drone(child)
    trace(child, 'uav_mission.no_overshoot')
    child:keys(':6cc<CR>')
    child:wait(step_at(5))
    expect.equal(child:lua(notes)[1], 191)
    child:keys(':cnext<CR>')
    child:wait(step_at(6))
    expect.equal(child:lua("return vim.fn.line('.')"), 84)
    expect.contains(child:lua(notes)[2], 'start_drone.status: no_status → failure')
    child:keys(':cprevious<CR>')
    child:wait(step_at(5))
    expect.contains(table.concat(child:lua(values), '\n'), '  start_drone.status')
  end },

  { 'an edit while a trace is open moves neither cursor nor window nor step', function(child)
    drone(child)
    trace(child, 'uav_mission.no_overshoot')
    child:keys(':6cc<CR>')
    child:wait(step_at(5))
    child:at(':time_interval [60,|120]')
    child:lua("vim.cmd('normal! zz')")
    local state = [[
      local view = vim.fn.winsaveview()
      return { vim.api.nvim_get_current_win(), view.lnum, view.col, view.topline, require('proskill.trace').shown.at,
               vim.fn.getqflist({ idx = 0 }).idx, #vim.api.nvim_list_wins(), vim.fn.mode() }
    ]]
    local before = child:lua(state)
    child:keys('cw130')
    child:wait([[
      for _, it in ipairs(vim.diagnostic.get(0)) do
        if it.message:find('takes at most 130 s from its start: violated', 1, true) then return true end
      end
      return false
    ]])
    before[3], before[8] = before[3] + 3, 'i'
    expect.equal(child:lua(state), before)
    expect.equal(child:lua("return vim.fn.getline('.')"), '  :time_interval [60,130]')
  end },

  { 'moving through the list moves the program\'s window along', function(child)
    drone(child)
    trace(child, 'uav_mission.no_overshoot')
    child:keys(':copen<CR>6G')
    child:wait(step_at(5))
    child:keys('j')
    child:wait(step_at(6))
    child:wait([[
      local window = require('proskill.trace').shown.window
      return vim.api.nvim_win_get_cursor(window)[1] == 84
    ]])
    expect.equal(child:lua('return vim.bo.buftype'), 'quickfix')
    child:keys('q')
    child:wait("return require('proskill.trace').shown == nil")
    expect.equal(child:lua('return #vim.api.nvim_list_wins()'), 1)
  end },

  { 'steps lead into the program\'s other files', function(child)
    child:open(child:copy('rover') .. '/rover.proskill')
    trace(child, 'explore.can_succeed.home')
    child:wait([[
      local trace = require('proskill.trace')
      if vim.fn.expand('%:t') == 'mission.proskill' then return true end
      trace.next()
      return false
    ]])
    expect.yes(child:lua(notes), 'the step is not marked in the file that it leads to')
  end },

  { 'without a name one is chosen among what is bad', function(child)
    drone(child)
    child:lua([[
      vim.ui.select = function(choices, options, done)
        offered = vim.tbl_map(options.format_item, choices)
        for _, choice in ipairs(choices) do
          if choice.name == 'battery.no_forbidden_transition' then done(choice) end
        end
      end
    ]])
    trace(child, '')
    expect.contains(table.concat(child:lua('return offered'), '\n'), 'takes at most 120 s from its start, violated')
    expect.equal(child:lua("return #vim.fn.getqflist()"), 2) -- the beginning, and one step
  end },

  { 'violated properties come before warnings, and each is named', function(child)
    drone(child)
    child:lua([[
      vim.ui.select = function(choices, options) offered = vim.tbl_map(options.format_item, choices) end
    ]])
    child:lua("vim.cmd('ProskillTrace')")
    local offered = child:wait('return offered')
    expect.contains(offered[1], 'battery.no_forbidden_transition: ')
    local last_error, first_warning
    for index, words in ipairs(offered) do
      if words:find('never_refused', 1, true) then first_warning = first_warning or index end
      if words:find('uav_mission.no_overshoot', 1, true) then last_error = index end
    end
    expect.yes(last_error < first_warning, 'a warning comes before a violated property')
  end },

  { 'an open trace says what has become of the verdict, and nothing moves', function(child)
    child:file('lamp.proskill', kLamp)
    child:open(child.directory .. '/lamp.proskill')
    trace(child, 'dark')
    child:lua("require('proskill.trace').next()")
    child:wait(step_at(1))
    local title = "return vim.fn.getqflist({ title = 0 }).title == %q"
    -- a line above: the same steps, each at its new place
    child:at('|(defsv lamp')
    child:keys('O; a lamp<Esc>')
    child:wait(("return vim.fn.getqflist({ items = 0 }).items[2].lnum == 3 and (function() %s end)()"):format(title:format('trace of dark')))
    child:wait(notes:gsub('return {', 'return mark[2] + 1 == 3 and {', 1))
    expect.equal(child:lua('return { vim.fn.line("."), vim.fn.col(".") }'), { 1, 8 })
    expect.equal(child:lua("return require('proskill.trace').shown.at"), 1)
    -- a repair: there are no steps any more
    child:at('(lamp |On))')
    child:keys('cwOff<Esc>')
    child:wait(title:format('trace of dark (of an older text; now: holds)'))
    expect.equal(child:lua("return require('proskill.trace').shown.at"), 1)
    child:keys('u')
    child:wait(title:format('trace of dark'))
    -- other steps
    child:at('((|skill)')
    child:keys('i^ 1) (<Esc>')
    child:wait(title:format('trace of dark (of an older text; :ProskillTrace dark shows the present one)'))
    child:lua("vim.cmd('ProskillTrace dark')")
    child:wait(title:format('trace of dark'))
  end },

  { 'the steps of an older trace lead to where their text is now', function(child)
    child:file('lamp.proskill', kLamp)
    child:open(child.directory .. '/lamp.proskill')
    trace(child, 'dark')
    local call = child:wait([[
      local trace = require('proskill.trace')
      if vim.fn.getline('.'):find('(skill)', 1, true) and trace.shown.at > 0 then return trace.shown.at end
      trace.next()
      return false
    ]])
    expect.equal(child:lua(notes)[1], 4)
    -- lines above and words before it; the definition is only begun, so that no verification brings new places
    child:at('|((skill)')
    child:keys('i (^ 1)<Esc>')
    child:at('|(defsv lamp')
    child:keys('O(defskill half<CR><CR><Esc>')
    child:wait("return vim.fn.getqflist({ title = 0 }).title == 'trace of dark (of an older text)'")
    child:lua("require('proskill.trace').go(0)")
    child:lua("require('proskill.trace').go(...)", call)
    expect.equal(child:lua(notes)[1], 7)
    expect.equal(child:lua('return { vim.fn.line("."), vim.fn.col(".") }'), { 7, 12 })
    -- what was removed has no mark, until it is there again
    child:keys('dd')
    child:lua("require('proskill.trace').go(...)", call)
    expect.equal(child:lua(notes), vim.NIL)
    child:keys('u')
    child:wait("return vim.fn.getline(7):find('(skill)', 1, true) ~= nil")
    child:lua("require('proskill.trace').go(...)", call)
    expect.equal(child:lua(notes)[1], 7)
  end },

  { 'a text that is replaced as a whole keeps its steps only if it is the same', function(child)
    child:file('lamp.proskill', kLamp)
    child:open(child.directory .. '/lamp.proskill')
    stop_server(child)
    trace(child, 'dark')
    local at = [[
      local trace, found = require('proskill.trace'), {}
      for number = 0, #trace.shown.trace.steps do
        trace.go(number)
        found[number + 1] = (function() %s end)() or false
      end
      return found
    ]]
    at = at:format(notes)
    local before = child:lua(at)
    child:lua('vim.api.nvim_buf_set_lines(0, 0, -1, false, vim.api.nvim_buf_get_lines(0, 0, -1, false))')
    expect.equal(child:lua(at), before)
    child:lua("vim.cmd('silent %d')")
    for _, found in ipairs(child:lua(at)) do
      expect.equal(found, false)
    end
  end },

  { 'steps lead into a file that has become shorter since', function(child)
    child:file('lamp.proskill', kLamp)
    child:open(child.directory .. '/lamp.proskill')
    stop_server(child)
    trace(child, 'dark')
    child:file('lamp.proskill', '; a lamp')
    child:lua([[
      local buffer = vim.api.nvim_get_current_buf()
      vim.cmd('enew')
      vim.cmd('bunload ' .. buffer)
      for number = 0, #require('proskill.trace').shown.trace.steps do require('proskill.trace').go(number) end
    ]])
    expect.equal(child:lua("return { vim.fn.expand('%:t'), vim.fn.line('.') }"), { 'lamp.proskill', 1 })
  end },

  { 'without a server, too, a trace says that the text has been edited since', function(child)
    child:file('lamp.proskill', kLamp)
    child:open(child.directory .. '/lamp.proskill')
    stop_server(child)
    trace(child, 'dark')
    local title = "return vim.fn.getqflist({ title = 0 }).title == %q"
    child:wait(title:format('trace of dark'))
    child:at('|(defsv lamp')
    child:keys('O; a lamp<Esc>')
    child:wait(title:format('trace of dark (of an older text)'))
    child:lua("require('proskill.trace').go(1)")
    expect.equal(child:lua(notes)[1], 3)
    child:keys('u')
    child:wait(title:format('trace of dark'))
  end },

  { 'a text that is edited while it is verified is not the one of the trace', function(child)
    child:lua('told = {}; vim.notify = function(text) table.insert(told, text) end')
    child:file('lamp.proskill', kLamp)
    child:open(child.directory .. '/lamp.proskill')
    stop_server(child)
    child:lua("vim.cmd('ProskillTrace dark'); vim.api.nvim_buf_set_lines(0, 0, 0, true, { '; a lamp' })")
    child:wait("return vim.fn.getqflist({ title = 0 }).title == 'trace of dark (of an older text)'")
    expect.contains(table.concat(child:lua('return told'), '\n'), 'the program has changed since: places may have moved')
  end },

  { 'what has no trace, and what is no property, is said', function(child)
    drone(child)
    child:lua("vim.cmd('ProskillTrace no.such.thing')")
    child:wait('return #told > 0')
    expect.contains(child:lua('return told[1]'), 'no.such.thing')
  end },

  { 'the help is found by its commands', function(child)
    child:lua([[
      local doc = vim.fn.tempname()
      vim.fn.mkdir(doc .. '/doc', 'p')
      vim.fn.writefile(vim.fn.readfile(... .. '/editors/nvim/doc/proskill.txt'), doc .. '/doc/proskill.txt')
      vim.cmd('helptags ' .. doc .. '/doc')
      vim.opt.runtimepath:prepend(doc)
    ]], vim.env.PROSKILL_ROOT)
    for _, name in ipairs(child:lua('return vim.tbl_keys(vim.api.nvim_get_commands({}))')) do
      if name:find('^Proskill') then
        child:lua("vim.cmd('help :' .. ...)", name)
        expect.contains(child:lua("return vim.fn.getline('.')"), '*:' .. name .. '*')
      end
    end
  end },
}
