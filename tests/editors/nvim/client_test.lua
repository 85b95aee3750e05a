-- The language server in the editor, from the user's view.
local expect = require('expect')

local function has_diagnostic(part)
  return ([[
    for _, it in ipairs(vim.diagnostic.get(0)) do
      if it.message:find(%q, 1, true) then return true end
    end
    return false
  ]]):format(part)
end

local function drone(child)
  local directory = child:copy('drone')
  child:open(directory .. '/drone.proskill')
  return directory
end

return {
  { 'a mistake is told when it is typed, and forgotten when it is undone', function(child)
    drone(child)
    child:at('(|takeoff height 3.0')
    child:keys('cwtakeof<Esc>')
    child:wait(has_diagnostic('unknown skill `takeof`'))
    local at = child:lua([[
      for _, it in ipairs(vim.diagnostic.get(0)) do
        if it.message:find('takeof`', 1, true) then return { it.lnum, it.col, it.end_col, it.code } end
      end
    ]])
    expect.equal(at, { 170, 6, 12, 'PS0201' })
    child:keys('u')
    child:wait('return not (function() ' .. has_diagnostic('unknown skill `takeof`') .. ' end)()')
  end },

  { 'an edit tells its mistakes in the other texts that are open, and forgets them there', function(child)
    local directory = child:copy('rover')
    child:open(directory .. '/mission.proskill')
    child:open(directory .. '/skills.proskill')
    child:lua("mission = vim.fn.bufnr('mission.proskill')")
    local told = [[
      for _, it in ipairs(vim.diagnostic.get(mission)) do
        if it.message:find('unknown skill `drive_to`', 1, true) then return true end
      end
      return false
    ]]
    child:wait('return #vim.diagnostic.get(mission) >= 0 and not (function() ' .. told .. ' end)()')
    child:at('(defskill |drive_to')
    child:keys('cwdrive<Esc>')
    child:wait(told)
    child:keys('u')
    child:wait('return not (function() ' .. told .. ' end)()')
  end },

  { 'an edit changes verdicts in the other texts that are open', function(child)
    child:file('lamp.proskill', '(defsv lamp :states (On Off) :init Off :transitions :all)\n'
      .. '(defskill light :action (a) :start (lamp On) :success lit)')
    child:open(child:file('main.proskill', '(include "lamp.proskill")\n(defskill mission :body ((light)))\n(defproperty dark (never (lamp On)))'))
    child:lua("main = vim.api.nvim_get_current_buf()")
    local violated = [[
      for _, it in ipairs(vim.diagnostic.get(main)) do
        if it.message:find('(never (lamp On)): violated', 1, true) then return true end
      end
      return false
    ]]
    child:wait(violated)
    child:open(child.directory .. '/lamp.proskill')
    child:at(':start (lamp |On)')
    child:keys('cwOff<Esc>')
    child:wait('return not (function() ' .. violated .. ' end)()')
    child:keys('u')
    child:wait(violated)
  end },

  { 'what is told stands where it should, whatever comes before it', function(child)
    local text = '(defskill a :body ((printf "😀é€") (b)))'
    child:open(child:file('wide.proskill', text))
    child:wait(has_diagnostic('unknown skill `b`'))
    local it = child:lua([[
      for _, it in ipairs(vim.diagnostic.get(0)) do
        if it.message:find('unknown skill', 1, true) then return it end
      end
    ]])
    local column = text:find('b)', 1, true) - 1
    expect.equal({ it.col, it.end_col }, { column, column + 1 })
  end },

  { 'models in Fiacre have colours, and are served as programs are', function(child)
    local text = '// One.\nprocess P is\nstates a\nfrom a to b\ncomponent m is par P end\nm\n'
    child:open(child:file('m.fcr', text))
    expect.equal(child:lua('return vim.bo.filetype'), 'fiacre')
    local group = 'return vim.fn.synIDattr(vim.fn.synIDtrans(vim.fn.synID(%d, %d, 1)), "name")'
    expect.equal(child:lua(group:format(1, 4)), 'Comment')
    expect.equal(child:lua(group:format(2, 1)), 'Statement')
    child:wait(has_diagnostic('the state `b` is not declared'))
    child:at('states |a')
    child:lua("vim.lsp.buf.references()")
    child:wait('return #vim.fn.getqflist() == 2')
    child:lua([[
      vim.cmd('cclose')
      if vim.lsp.buf.format then vim.lsp.buf.format() else vim.lsp.buf.formatting_sync() end
    ]])
    child:wait("return vim.fn.getline(6) == '    to b'")
  end },

  { 'names are completed, those that fit the place', function(child)
    drone(child)
    child:at('(^ (localization_status |Valid))')
    child:keys('cw<C-x><C-o>')
    child:wait('return vim.fn.pumvisible() == 1')
    local words = child:lua([[
      return vim.tbl_map(function(it) return it.word end, vim.fn.complete_info({ 'items' }).items)
    ]])
    expect.equal(words, { 'Invalid', 'Coarse', 'Valid' })
    child:keys('<C-n><Esc>')
    child:wait("return vim.fn.mode() == 'n'")
    expect.contains(child:lua("return vim.fn.getline('.')"), '(^ (localization_status ')
  end },

  { 'a definition is gone to, in another file too', function(child)
    local directory = child:copy('rover')
    child:open(directory .. '/mission.proskill')
    child:at('(|drive_to where Field')
    child:keys('gd')
    child:wait("return vim.fn.expand('%:t') == 'skills.proskill'")
    expect.contains(child:lua("return vim.fn.getline('.')"), '(defskill drive_to')
    expect.equal(child:lua("return vim.fn.col('.')"), 11)
    child:keys('<C-o>')
    child:wait("return vim.fn.expand('%:t') == 'mission.proskill'")
  end },

  { 'a name is renamed, in the other file too', function(child)
    local directory = child:copy('rover')
    child:open(directory .. '/mission.proskill')
    child:at('(|drive_to where Field')
    child:lua([[vim.ui.input = function(options, done) offered = options.default; done('drive') end]])
    child:keys('grn')
    child:wait("return vim.fn.search('(drive where Field', 'nw') > 0")
    expect.equal(child:lua('return offered'), 'drive_to')
    child:edit(directory .. '/skills.proskill')
    child:wait("return vim.fn.search('(defskill drive$', 'nw') > 0")
    child:wait('return #vim.diagnostic.get(0, { severity = vim.diagnostic.severity.ERROR }) == 0')
  end },

  { 'a code is explained, at the cursor, by its name, and by the code action', function(child)
    drone(child)
    child:at('(|takeoff height 3.0')
    child:keys('cwtakeof<Esc>')
    child:wait(has_diagnostic('unknown skill `takeof`'))
    local shown = [[
      for _, window in ipairs(vim.api.nvim_list_wins()) do
        if vim.api.nvim_win_get_config(window).relative ~= '' then
          return table.concat(vim.api.nvim_buf_get_lines(vim.api.nvim_win_get_buf(window), 0, -1, true), ' ')
        end
      end
    ]]
    for _, way in ipairs({ "vim.cmd('ProskillExplain')", "vim.cmd('ProskillExplain PS0101')",
                           "vim.lsp.commands['proskill.explain']({ arguments = { 'PS0203' } }, {})" }) do
      local code = way:match('PS%d+') or 'PS0201'
      child:lua(way)
      child:wait('local text = (function() ' .. shown .. ' end)() return text and text:find(...) ~= nil', code)
    end
  end },

  { 'all places that use a thing are listed', function(child)
    drone(child)
    child:at('(defskill |landing')
    child:keys('grr')
    child:wait("return #vim.fn.getqflist() == 4")
  end },

  { 'the project of a file is where its settings are, else its repository, else its directory', function(child)
    local directory = child:copy('rover')
    local root = "return require('proskill.client').root(0)"
    child:edit(directory .. '/mission.proskill')
    expect.equal(child:lua(root), directory)
    vim.fn.mkdir(child.directory .. '/.git')
    expect.equal(child:lua(root), child.directory)
    vim.fn.writefile({ '{}' }, directory .. '/.proskill.json')
    expect.equal(child:lua(root), directory)
  end },

  { 'a file in a folder below has the server of the program above', function(child)
    child:file('main.proskill', '(include "parts/lamp.proskill")')
    child:lua('vim.fn.mkdir(...)', child.directory .. '/parts')
    child:file('parts/lamp.proskill', '(defsv lamp :states (On Off) :init Off)')
    child:open(child.directory .. '/main.proskill')
    child:open(child.directory .. '/parts/lamp.proskill')
    expect.equal(child:lua("return #require('proskill.client').all()"), 1)
    expect.equal(child:lua("return require('proskill.client').root(0)"), child.directory)
  end },

  { 'files of a project have one server', function(child)
    local directory = child:copy('rover')
    child:open(directory .. '/mission.proskill')
    local first = child:lua("return require('proskill.client').of(0).id")
    child:open(directory .. '/world.proskill')
    expect.equal(child:lua("return require('proskill.client').of(0).id"), first)
  end },

  { 'the server can be started again, and knows the text as it is', function(child)
    drone(child)
    local first = child:lua("return require('proskill.client').of(0).id")
    child:at('(|takeoff height 3.0')
    child:keys('cwtakeof<Esc>')
    child:wait(has_diagnostic('unknown skill `takeof`'))
    child:lua("vim.cmd('ProskillRestart')")
    child:wait([[
      local client = require('proskill.client').of(0)
      return client ~= nil and client.id ~= ...
    ]], first)
    child:wait(has_diagnostic('unknown skill `takeof`'))
  end },

  { 'a server that is not installed is told once, and the text is shown all the same', function(child)
    child:lua("require('proskill').setup({ cmd = { 'no-such-program' } })")
    child:lua([[told = {}; vim.notify = function(text) table.insert(told, text) end]])
    child:edit(child:copy('drone') .. '/drone.proskill')
    child:edit(child.directory .. '/drone/other.proskill')
    expect.equal(child:lua('return #told'), 1)
    expect.contains(child:lua('return told[1]'), 'no-such-program')
  end },
}
