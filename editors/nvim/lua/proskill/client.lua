-- The language server's client: one for each project.
local config = require('proskill.config')
local message = require('proskill.message')

local M = {}

local name = 'proskill'

-- The nearest root of a client, also of one that is starting, that has this directory.
local function known_root(directory)
  local roots = vim.tbl_keys(M.starting or {})
  for _, client in ipairs((vim.lsp.get_clients or vim.lsp.get_active_clients)()) do
    table.insert(roots, client.name == name and client.config.root_dir or nil)
  end
  local nearest
  for _, root in ipairs(roots) do
    if vim.startswith(directory .. '/', root .. '/') and #root > #(nearest or '') then
      nearest = root
    end
  end
  return nearest
end

-- Root of a buffer's program: the directory of its settings, else of its repository, else one that already has a client, else
-- its own.
function M.root(buffer)
  local file = vim.api.nvim_buf_get_name(buffer)
  local start = file ~= '' and vim.fn.fnamemodify(file, ':p:h') or vim.fn.getcwd()
  for _, mark in ipairs({ '.proskill.json', '.git' }) do
    local directory = start
    while true do
      if vim.loop.fs_stat(directory .. '/' .. mark) then
        return directory
      end
      local parent = vim.fn.fnamemodify(directory, ':h')
      if parent == directory then
        break
      end
      directory = parent
    end
  end
  return known_root(start) or start
end

-- The clients that are initialized.
function M.all()
  local clients = (vim.lsp.get_clients or vim.lsp.get_active_clients)()
  return vim.tbl_filter(function(client) return client.name == name end, clients)
end

-- The client of a buffer; nil if it has none yet.
function M.of(buffer)
  buffer = buffer == 0 and vim.api.nvim_get_current_buf() or buffer
  for _, client in ipairs(M.all()) do
    if vim.lsp.buf_is_attached(buffer, client.id) then
      return client
    end
  end
end

local function capabilities()
  local result = vim.lsp.protocol.make_client_capabilities()
  result.offsetEncoding = config.get().offset_encodings
  result.general = result.general or {}
  result.general.positionEncodings = config.get().offset_encodings
  result.experimental = vim.tbl_extend('force', result.experimental or {}, { verdicts = 'changes' })
  return result
end

-- The keys that Neovim 0.11 defines for every server, for older versions.
local keys = {
  K = 'hover', gd = 'definition', grr = 'references', gri = 'implementation',
  grn = 'rename', gra = 'code_action', gO = 'document_symbol',
}

local function map_keys(buffer)
  for key, action in pairs(keys) do
    if vim.fn.maparg(key, 'n') == '' then
      vim.keymap.set('n', key, function() vim.lsp.buf[action]() end,
                     { buffer = buffer, desc = 'ProSkill: ' .. action:gsub('_', ' ') })
    end
  end
end

local function attached(client, buffer)
  local options = vim.bo[buffer]
  options.omnifunc = options.omnifunc ~= '' and options.omnifunc or 'v:lua.vim.lsp.omnifunc'
  options.tagfunc = options.tagfunc ~= '' and options.tagfunc or 'v:lua.vim.lsp.tagfunc'
  if client.server_capabilities.documentRangeFormattingProvider and options.formatexpr == '' then
    options.formatexpr = 'v:lua.vim.lsp.formatexpr()'
  end
  if config.get().keymaps then
    map_keys(buffer)
  end
  if config.get().on_attach then
    config.get().on_attach(client, buffer)
  end
  require('proskill.platform').update_soon()
end

-- Progress and highlights: notifications beyond the protocol.
local function handlers()
  return {
    ['proskill/verdicts'] = function(_, params) require('proskill.verify').told(params) end,
  }
end

local function options_for(root)
  return {
    name = name,
    cmd = config.command('lsp'),
    root_dir = root,
    capabilities = capabilities(),
    handlers = handlers(),
    settings = { proskill = config.get().settings },
    init_options = config.get().init_options,
    flags = config.get().flags,
    on_init = function(client, result)
      -- Neovim before 0.10 ignores the server's choice.
      client.offset_encoding = result.capabilities.positionEncoding or result.offsetEncoding
                               or client.offset_encoding
    end,
    on_attach = attached,
  }
end

local function start(buffer, root)
  if vim.lsp.start then
    return vim.lsp.start(options_for(root), { bufnr = buffer })
  end
  for _, client in ipairs(vim.tbl_values(vim.lsp.get_active_clients())) do
    if client.name == name and client.config.root_dir == root then
      vim.lsp.buf_attach_client(buffer, client.id)
      return client.id
    end
  end
  -- Clients that are not initialized yet are not in the list of active ones.
  M.starting = M.starting or {}
  local id = M.starting[root]
  if not (id and vim.lsp.get_client_by_id(id)) then
    id = vim.lsp.start_client(options_for(root))
    M.starting[root] = id
  end
  if id then
    vim.lsp.buf_attach_client(buffer, id)
  end
  return id
end

-- Gives a buffer the client of its project; starts one if there is none.
function M.attach(buffer)
  if vim.bo[buffer].buftype ~= '' then
    return
  end
  local program = config.get().cmd[1]
  if vim.fn.executable(program) == 0 then
    if not M.told then
      M.told = true
      message.warn(('`%s` is not installed, or not on the PATH: no language server'):format(program))
    end
    return
  end
  return start(buffer, M.root(buffer))
end

-- The buffers with programs.
function M.programs()
  return vim.tbl_filter(function(buffer)
    return vim.api.nvim_buf_is_loaded(buffer) and vim.bo[buffer].filetype == 'proskill'
  end, vim.api.nvim_list_bufs())
end

local function text_of(buffer)
  return table.concat(vim.api.nvim_buf_get_lines(buffer, 0, -1, false), '\n')
end

-- The texts of all open programs, by buffer.
function M.texts()
  local texts = {}
  for _, buffer in ipairs(M.programs()) do
    texts[buffer] = text_of(buffer)
  end
  return texts
end

-- Whether none of these texts has been edited; those of buffers that were closed do not count.
function M.are_current(texts)
  for buffer, text in pairs(texts) do
    if vim.api.nvim_buf_is_loaded(buffer) and text_of(buffer) ~= text then
      return false
    end
  end
  return true
end

-- Stops all servers; when they have ended, starts those that the open programs need.
function M.restart()
  local stopping = vim.tbl_map(function(client) return client.id end, M.all())
  vim.lsp.stop_client(stopping)
  local timer, tries = vim.loop.new_timer(), 0
  timer:start(0, 50, vim.schedule_wrap(function()
    if timer:is_closing() then
      return
    end
    tries = tries + 1
    local left = vim.tbl_filter(function(id) return vim.lsp.get_client_by_id(id) ~= nil end, stopping)
    if #left > 0 and tries == 40 then
      vim.lsp.stop_client(left, true)
    end
    if #left > 0 and tries < 100 then
      return
    end
    timer:close()
    M.starting = {}
    for _, buffer in ipairs(M.programs()) do
      M.attach(buffer)
    end
  end))
end

-- Sends a request to the buffer's server. `answer` receives the error of the protocol, or nil and the
-- result. Returns whether there is a server, and a function that cancels the request.
function M.ask(buffer, method, params, answer)
  local client = M.of(buffer)
  if not client then
    return false
  end
  local new = vim.fn.has('nvim-0.11') == 1
  local function handler(problem, result) answer(problem, result) end
  local sent, id
  if new then
    sent, id = client:request(method, params, handler, buffer)
  else
    sent, id = client.request(method, params, handler, buffer)
  end
  return sent, function()
    if new then client:cancel_request(id) else client.cancel_request(id) end
  end
end

-- The protocol's error code for an unknown method.
M.unknown_method = -32601

return M
