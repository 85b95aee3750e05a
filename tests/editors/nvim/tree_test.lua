-- Colours, folds and indentation by the parser.
local expect = require('expect')

local root = vim.env.PROSKILL_ROOT
local examples = vim.fn.glob(root .. '/examples/*/*.proskill', false, true)

-- The highlight group at a place, from the tree or a syntax file.
local function group_at(child, pattern)
  child:at(pattern)
  return child:lua([[
    local line, column = unpack(vim.api.nvim_win_get_cursor(0))
    if vim.fn.has('nvim-0.9') == 1 then
      local captures = vim.treesitter.get_captures_at_pos(0, line - 1, column)
      for index = #captures, 1, -1 do
        if captures[index].capture ~= 'spell' then return captures[index].capture end
      end
      return ''
    end
    local highlighter = vim.treesitter.highlighter.active[vim.api.nvim_get_current_buf()]
    local query = highlighter:get_query('proskill'):query()
    local last = ''
    for id, node in query:iter_captures(highlighter.tree:parse()[1]:root(), 0, line - 1, line) do
      local r1, c1, r2, c2 = node:range()
      local from = r1 < line - 1 or c1 <= column
      local to = r2 > line - 1 or c2 > column
      if from and to then last = query.captures[id] end
    end
    return last
  ]])
end

return {
  { 'the filetype is known, with its comments', function(child)
    child:edit(root .. '/examples/drone/drone.proskill')
    expect.equal(child:lua('return vim.bo.filetype'), 'proskill')
    expect.equal(child:lua('return vim.bo.commentstring'), '; %s')
  end },

  { 'the tree colours the text', function(child)
    child:edit(root .. '/examples/drone/drone.proskill')
    local new = child:lua("return vim.fn.has('nvim-0.8') == 1")
    local expected = {
      { '; A su|rvey', 'comment', 'Comment' }, { '(def|skill takeoff', 'keyword', 'Keyword' },
      { '(defskill take|off', 'function', 'Function' }, { ':tim|e_interval [1,3]', 'property', 'Identifier' },
      { '(takeoff height 3|.0', 'number', 'Number' }, { '"Miss|ion failed"', 'string', 'String' },
      { '|(if (= takeoff', 'punctuation.bracket', 'Delimiter' },
      { '(i|f (= takeoff', 'keyword.conditional', 'Conditional' },
    }
    for _, case in ipairs(expected) do
      expect.equal({ case[1], group_at(child, case[1]) }, { case[1], new and case[2] or case[3] })
    end
  end },

  { 'every word of every example has a colour', function(child)
    for _, path in ipairs(examples) do
      child:edit(path)
      local plain = child:lua([[
        local root = require('proskill.treesitter').root(0)
        local query = require('proskill.treesitter').query('highlights')
        local coloured, plain = {}, {}
        for _, node in query:iter_captures(root, 0, 0, -1) do coloured[node:id()] = true end
        local function look(node, inherited)
          inherited = inherited or coloured[node:id()]
          if node:child_count() == 0 and not inherited and node:start() ~= select(3, node:range()) + 1 then
            table.insert(plain, node:type() .. ' in line ' .. node:start() + 1)
          end
          for child in node:iter_children() do look(child, inherited) end
        end
        look(root, false)
        return plain
      ]])
      expect.equal({ path, plain }, { path, {} })
    end
  end },

  { 'skills and what is in them can be folded', function(child)
    child:edit(root .. '/examples/drone/drone.proskill')
    child:at('|(defskill takeoff')
    child:wait("return vim.fn.foldlevel('.') == 1")
    child:keys('zc')
    child:wait("return vim.fn.foldclosed('.') == vim.fn.line('.')")
    local last = child:lua("return vim.fn.getline(vim.fn.foldclosedend('.'))")
    expect.contains(last, ':postcondition (flight_status InAirUnsafe))))')
    child:at('|(if (= takeoff.status')
    child:wait("return vim.fn.foldlevel('.') > 1")
  end },

  { 'folds follow the text', function(child)
    child:edit(root .. '/examples/drone/drone.proskill')
    child:wait("return vim.fn.foldlevel(6) == 1")
    child:keys('ggdd')
    child:wait("return vim.fn.foldlevel(5) == 1 and vim.fn.foldlevel(4) == 0")
  end },

  { 'the examples are indented already, and are again when all white space is taken away', function(child)
    for _, path in ipairs(examples) do
      child:edit(path)
      local wanted = child:lines()
      child:lua([[vim.cmd('silent %s/^\\s\\+//e | silent normal! gg=G')]])
      expect.lines(child:lines(), wanted, path)
      child:lua([[vim.cmd('edit!')]])
    end
  end },

  { 'lines are indented as they are typed, before anything is closed', function(child)
    child:edit(child:file('typed.proskill', ''))
    child:keys('i(defskill fly<CR>:success there<CR>:body<CR>((takeoff)<CR>(if (= takeoff.status success)<CR>'
               .. '(land)<CR>elseif (battery Low)<CR>(rest)<CR>else<CR>(fail)<Esc>')
    child:wait("return vim.fn.mode() == 'n' and vim.fn.line('$') == 10")
    expect.equal(child:lines(), {
      '(defskill fly', '  :success there', '  :body', '    ((takeoff)',
      '     (if (= takeoff.status success)', '        (land)', '      elseif (battery Low)',
      '        (rest)', '      else', '        (fail)',
    })
  end },

  { 'the parser can be compiled by the editor', function(child)
    local built = child:lua([[
      require('proskill.config').set({ client = false })
      vim.cmd('ProskillBuildParser')
      return vim.fn.filereadable(vim.fn.stdpath('data') .. '/site/parser/proskill.so')
    ]])
    expect.equal(built, 1)
    child:edit(root .. '/examples/drone/drone.proskill')
    expect.equal(child:lua("return require('proskill.treesitter').available()"), true)
  end },

  { 'without a parser there are colours by patterns', function(child)
    child:lua("require('proskill.config').set({ client = false, parser = '/nowhere.so' })")
    child:edit(root .. '/examples/drone/drone.proskill')
    child:at('(def|skill takeoff')
    expect.equal(child:lua([[
      local line, column = unpack(vim.api.nvim_win_get_cursor(0))
      return vim.fn.synIDattr(vim.fn.synID(line, column + 1, 1), 'name')
    ]]), 'proskillDefinition')
  end },
}
