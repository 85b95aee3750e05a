-- Platform files in the editor: the servers of the open programs get their texts, and nothing else, so that a
-- server for JSON is not disturbed. They publish what is wrong with a file that an open program names.
local M = {}

-- By the id of a client and the URI of a file: the buffer, and the change of its text that was sent.
local sent = {}

local function is_json(buffer)
  return vim.api.nvim_buf_is_loaded(buffer) and vim.bo[buffer].buftype == ''
    and vim.api.nvim_buf_get_name(buffer):match('%.json$') ~= nil
end

local function json_buffers()
  return vim.tbl_filter(is_json, vim.api.nvim_list_bufs())
end

local function real(path)
  return vim.loop.fs_realpath(path) or path
end

-- The files that open programs name, by their real paths.
local function named()
  local files = {}
  for _, buffer in ipairs(require('proskill.client').programs()) do
    local directory = vim.fn.fnamemodify(vim.api.nvim_buf_get_name(buffer), ':p:h')
    local text = table.concat(vim.api.nvim_buf_get_lines(buffer, 0, -1, true), '\n')
    for file in text:gmatch('%(%s*defplatform%s+"([^"\n]+)"') do
      files[real(file:sub(1, 1) == '/' and file or directory .. '/' .. file)] = true
    end
  end
  return files
end

-- Whether its name is that of a platform file, as in VS Code.
local function has_usual_name(path)
  local name = vim.fn.fnamemodify(path, ':t')
  return name == 'platform.json' or name:match('%.platform%.json$') ~= nil
end

local function text_of(buffer)
  local text = table.concat(vim.api.nvim_buf_get_lines(buffer, 0, -1, true), '\n')
  return vim.bo[buffer].endofline and text .. '\n' or text
end

local function notify(client, method, params)
  if vim.fn.has('nvim-0.11') == 1 then
    client:notify(method, params)
  else
    client.notify(method, params)
  end
end

local function send(client, buffer, uri)
  local open = sent[client.id][uri]
  local change = vim.api.nvim_buf_get_changedtick(buffer)
  if open and open.buffer == buffer and open.change == change then
    return
  end
  sent[client.id][uri] = { buffer = buffer, change = change }
  if not open then
    return notify(client, 'textDocument/didOpen', { textDocument = {
      uri = uri, languageId = 'json', version = change, text = text_of(buffer) } })
  end
  notify(client, 'textDocument/didChange', {
    textDocument = { uri = uri, version = change }, contentChanges = { { text = text_of(buffer) } } })
end

-- The platform files that are open, by URI.
local function wanted()
  local buffers, files = {}, nil
  for _, buffer in ipairs(json_buffers()) do
    local path = vim.api.nvim_buf_get_name(buffer)
    files = files or named()
    if has_usual_name(path) or files[real(path)] then
      buffers[vim.uri_from_bufnr(buffer)] = buffer
    end
  end
  return buffers
end

local function follow(client, buffers)
  sent[client.id] = sent[client.id] or {}
  for uri, buffer in pairs(buffers) do
    send(client, buffer, uri)
  end
  for uri in pairs(sent[client.id]) do
    if not buffers[uri] then
      sent[client.id][uri] = nil
      notify(client, 'textDocument/didClose', { textDocument = { uri = uri } })
    end
  end
end

-- Gives the servers what has changed.
function M.update()
  local clients = require('proskill.client').all()
  local buffers = #clients > 0 and wanted() or {}
  local running = {}
  for _, client in ipairs(clients) do
    follow(client, buffers)
    running[client.id] = true
  end
  for id in pairs(sent) do
    if not running[id] then
      sent[id] = nil
    end
  end
end

-- The same, once what happens now is over: a buffer that is unloaded is still there.
function M.update_soon()
  if M.is_planned then
    return
  end
  M.is_planned = true
  vim.schedule(function()
    M.is_planned = false
    M.update()
  end)
end

return M
