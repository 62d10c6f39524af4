-- A conversation with Neovim 0.11:  nvim --headless --clean -l tests/clients/with_neovim.lua
local broken = [[
/// Rotates an edge between two triangles by one corner, 𝄞.
op flip(e: edge) {
  before {
    face f0: v0 -a-> v1 -b-> v2 -c-> v0
    face f1: v1 -d-> v0 -g-> v3 -h-> v1
    edge e: a | d
  }
  after {
    face f0: v3 -a-> v2 -c-> v0 -g-> v3
    face f1: v2 -d-> v3 -h-> v1 -b-> v2
  }
}]]

local function say(what, value)
  print(what .. ': ' .. (type(value) == 'string' and value or vim.inspect(value)))
end

local function fail(why)
  say('FAILED', why)
  os.exit(1)
end

local function wait(what, condition)
  if not vim.wait(10000, condition, 20) then fail('waited in vain for ' .. what) end
end

local folder = vim.fn.tempname()
vim.fn.mkdir(folder, 'p')
local path = folder .. '/flip.hedge'
vim.fn.writefile(vim.split(broken, '\n'), path)
vim.filetype.add({ extension = { hedge = 'hedgerow' } })
vim.lsp.config('hedgerow', {
  cmd = { os.getenv('HEDGEROW') or 'hedgerow', 'lsp' },
  filetypes = { 'hedgerow' },
})
vim.lsp.enable('hedgerow')
vim.cmd('filetype on')
vim.cmd.edit(path)
vim.bo.filetype = 'hedgerow'

local buffer = vim.api.nvim_get_current_buf()
local function client() return vim.lsp.get_clients({ bufnr = buffer })[1] end
wait('the client', function() return client() ~= nil and client().initialized end)
say('encoding', client().offset_encoding)

wait('the squiggle', function() return #vim.diagnostic.get(buffer) == 1 end)
local told = vim.diagnostic.get(buffer)[1]
say('squiggle', ('%d:%d %s %s'):format(told.lnum + 1, told.col + 1, told.code, told.message:match('[^\n]*')))

-- The quick fix, as `gra` applies it.
vim.api.nvim_win_set_cursor(0, { told.lnum + 1, told.col })
vim.lsp.buf.code_action({ filter = function(action) return action.isPreferred end, apply = true })
wait('the fix', function() return #vim.diagnostic.get(buffer) == 0 end)
say('mended', table.concat(vim.api.nvim_buf_get_lines(buffer, 9, 12, false), '\n'))

local function ask(method, line, column, more)
  local params = vim.tbl_extend('force', {
    textDocument = vim.lsp.util.make_text_document_params(buffer),
    position = { line = line, character = column },
  }, more or {})
  local answer = client():request_sync(method, params, 10000, buffer)
  if not answer or answer.err then fail(method .. ': ' .. vim.inspect(answer)) end
  return answer.result
end

local hover = ask('textDocument/hover', 1, 4)
say('hover', hover.contents.value)
if not hover.contents.value:find('proved', 1, true) then fail('the hover') end
if hover.contents.value:find('base64', 1, true) then fail('a terminal draws no images') end

local lit = ask('textDocument/documentHighlight', 3, 17)
say('highlight', tostring(#lit) .. ' places')
if #lit ~= 4 then fail('the highlight') end

local offered = ask('textDocument/completion', 9, 18)
say('completion', table.concat(vim.tbl_map(function(item) return item.label end, vim.list_slice(offered.items, 1, 8)), ' '))

-- Typing, with characters outside of the first plane before the change.
vim.api.nvim_buf_set_lines(buffer, 0, 1, false, { '/// 𝄞𝄞 é' })
vim.api.nvim_buf_set_text(buffer, 0, 12, 0, 15, { 'x' })
vim.api.nvim_win_set_cursor(0, { 4, 17 })
vim.lsp.buf.rename('spoke')
wait('the rename', function()
  return vim.api.nvim_buf_get_lines(buffer, 3, 4, false)[1]:find('-spoke->', 1, true)
end)
say('renamed', table.concat(vim.api.nvim_buf_get_lines(buffer, 0, -1, false), '\n'))
local tokens = ask('textDocument/semanticTokens/full', 0, 0)
say('tokens', tostring(#tokens.data / 5))
vim.lsp.buf.format({ timeout_ms = 10000 })
wait('what is right', function() return #vim.diagnostic.get(buffer) == 0 end)
say('formatted', table.concat(vim.api.nvim_buf_get_lines(buffer, 0, -1, false), '\n'))
client():stop()
wait('the goodbye', function() return client() == nil end)
say('done', 'all is well')
os.exit(0)
