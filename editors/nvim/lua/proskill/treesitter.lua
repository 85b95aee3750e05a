-- The parser: where it is, how to build it, and how to call it in each version of Neovim.
local config = require('proskill.config')
local message = require('proskill.message')

local M = {}

local language = 'proskill'

-- Output directory of :ProskillBuildParser, which is on the runtime path.
local function built()
  return vim.fn.stdpath('data') .. '/site/parser/proskill.so'
end

local function candidates()
  local found = {}
  if config.get().parser then
    table.insert(found, vim.fn.expand(config.get().parser))
  end
  vim.list_extend(found, vim.api.nvim_get_runtime_file('parser/proskill.so', true))
  table.insert(found, built())
  return vim.tbl_filter(function(path) return vim.fn.filereadable(path) == 1 end, found)
end

-- For Neovim 0.9 and later, 0.8, and 0.7. Each raises an error if the file is not a parser; those of 0.11 and later return it.
local function load(path)
  local ts = vim.treesitter
  if ts.language and ts.language.add then
    local _, problem = ts.language.add(language, { path = path })
    assert(not problem, problem)
  else
    (ts.require_language or ts.language.require_language)(language, path)
  end
end

local loaded = false

-- Whether there is a parser; loads it on the first call.
function M.available()
  if loaded then
    return true
  end
  for _, path in ipairs(candidates()) do
    loaded = pcall(load, path)
    if loaded then
      return true
    end
  end
  return false
end

function M.query(name)
  local ts = vim.treesitter
  return (ts.query.get or ts.query.get_query or ts.get_query)(language, name)
end

-- The root of the tree for the buffer's current text; nil without a parser.
function M.root(buffer)
  if not M.available() then
    return nil
  end
  return vim.treesitter.get_parser(buffer, language):parse()[1]:root()
end

-- Neovim 0.7 uses older names of captures; these are mapped to highlight groups.
local groups = {
  ['comment'] = 'Comment', ['string'] = 'String', ['string.escape'] = 'SpecialChar',
  ['number'] = 'Number', ['boolean'] = 'Boolean', ['error'] = 'Error', ['type'] = 'Type',
  ['constant'] = 'Constant', ['constant.builtin'] = 'Special', ['label'] = 'Label',
  ['variable'] = 'None', ['variable.parameter'] = 'Identifier', ['variable.member'] = 'Identifier',
  ['property'] = 'Identifier', ['function'] = 'Function', ['function.call'] = 'Function',
  ['function.builtin'] = 'Special', ['operator'] = 'Operator', ['keyword'] = 'Keyword',
  ['keyword.import'] = 'Include', ['keyword.conditional'] = 'Conditional',
  ['keyword.repeat'] = 'Repeat', ['keyword.return'] = 'Statement',
  ['keyword.coroutine'] = 'Statement', ['keyword.operator'] = 'Operator',
  ['punctuation.bracket'] = 'Delimiter', ['punctuation.delimiter'] = 'Delimiter',
}

local function highlights_of_old()
  local text = {}
  for _, path in ipairs(vim.api.nvim_get_runtime_file('queries/proskill/highlights.scm', true)) do
    vim.list_extend(text, vim.fn.readfile(path))
  end
  local query = table.concat(text, '\n'):gsub('%s@spell', '')
  return (query:gsub('@([%w_.]+)', function(name) return '@' .. (groups[name] or 'None') end))
end

-- Highlights with the tree, or with syntax/proskill.vim if there is no parser.
function M.highlight(buffer)
  if not M.available() then
    return
  end
  local fine, problem = pcall(function()
    if vim.treesitter.start then
      vim.treesitter.start(buffer, language)
    else
      local parser = vim.treesitter.get_parser(buffer, language)
      vim.treesitter.highlighter.new(parser, { queries = { [language] = highlights_of_old() } })
    end
  end)
  if not fine then
    message.warn('the parser does not fit the queries; try :ProskillBuildParser\n' .. problem)
  end
end

local function grammar()
  local here = vim.fn.fnamemodify(debug.getinfo(1, 'S').source:sub(2), ':p:h')
  local places = {
    config.get().grammar or '',
    here .. '/../../../../tree-sitter-proskill', -- in the repository
    '/usr/local/share/proskill/tree-sitter-proskill',
    '/usr/share/proskill/tree-sitter-proskill',
  }
  for _, place in ipairs(places) do
    place = vim.fn.expand(place)
    if vim.fn.filereadable(place .. '/src/parser.c') == 1 then
      return place
    end
  end
end

local function compiler()
  for _, name in ipairs({ vim.env.CC or '', 'cc', 'gcc', 'clang' }) do
    if name ~= '' and vim.fn.executable(name) == 1 then
      return name
    end
  end
end

local function refresh()
  for _, buffer in ipairs(vim.api.nvim_list_bufs()) do
    if vim.api.nvim_buf_is_loaded(buffer) and vim.bo[buffer].filetype == language then
      vim.api.nvim_buf_call(buffer, function() vim.bo.filetype = language end)
    end
  end
end

-- Compiles the parser. Returns whether it succeeded.
function M.build()
  local source, cc = grammar(), compiler()
  if not source then
    message.error('the grammar is nowhere to be found; say where by `grammar`, see :help proskill-parser')
    return false
  elseif not cc then
    message.error('no C compiler: install gcc')
    return false
  end
  local target = built()
  vim.fn.mkdir(vim.fn.fnamemodify(target, ':h'), 'p')
  -- Writes another file first: a parser in use must not change.
  local fresh = target .. '.' .. vim.fn.getpid()
  local said = vim.fn.system({ cc, '-O2', '-fPIC', '-shared', '-I' .. source .. '/src', '-o', fresh,
                               source .. '/src/parser.c', source .. '/src/scanner.c' })
  if vim.v.shell_error ~= 0 or vim.fn.rename(fresh, target) ~= 0 then
    vim.fn.delete(fresh)
    message.error('the parser cannot be compiled\n' .. said)
    return false
  end
  if loaded then
    message.info('parser compiled; Neovim takes it when it is started again')
  else
    refresh()
    message.info('parser compiled')
  end
  return true
end

return M
