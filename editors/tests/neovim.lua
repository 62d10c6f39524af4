-- Neovim 0.11 with the configuration of ../neovim: what is wrong is told, mended and formatted;
-- with PARSER, the compiled grammar, the text is coloured by tree-sitter.
--
--     HEDGEROW=… [PARSER=…] nvim --headless --clean -l editors/tests/neovim.lua

local here = vim.fs.dirname(vim.fs.abspath(debug.getinfo(1, "S").source:sub(2)))
local editors = vim.fs.dirname(here)
vim.opt.runtimepath:append(editors .. "/neovim")
vim.cmd("runtime! ftdetect/*.lua")
vim.cmd("filetype plugin on")
if vim.env.PARSER then vim.treesitter.language.add("hedgerow", { path = vim.env.PARSER }) end
vim.lsp.enable("hedgerow")

local failed = false
local function holds(what, test)
  local fine = vim.wait(20000, test, 50)
  failed = failed or not fine
  io.write(fine and "ok  " or "NOT ", what, "\n")
end

local path = vim.fn.tempname() .. ".hedge"
vim.fn.writefile({
  "op flip(e:edge) {",
  "  before {",
  "    face f0: v0 -a-> v1 -b-> v2 =P=> v0",
  "    face f1: v1 -d-> v0 -g-> v3 =Q=> v1",
  "    edge e: a | d",
  "  }",
  "  after {",
  "    face f0: v3 -a-> v2 =P=> v0 -g-> v3",
  "    face f1: v2 -d-> v3 =Q=> v1 -b-> v2",
  "    edge e: a | x",
  "  }",
  "}",
}, path)
vim.cmd.edit(path)
holds("the file is known", function() return vim.bo.filetype == "hedgerow" end)
holds("the server is there", function() return #vim.lsp.get_clients({ bufnr = 0 }) == 1 end)
holds("what is wrong is told", function()
  return vim.iter(vim.diagnostic.get(0)):any(function(found) return found.code == "unknown-name" end)
end)
vim.api.nvim_buf_set_lines(0, 9, 10, false, { "    edge e: a | d" })
holds("nothing is wrong any more", function() return #vim.diagnostic.get(0) == 0 end)
vim.lsp.buf.format({ timeout_ms = 10000 })
holds("the file is formatted", function()
  return vim.api.nvim_buf_get_lines(0, 0, 1, false)[1] == "op flip(e: edge) {"
end)
if vim.env.PARSER then
  holds("tree-sitter reads it", function()
    return not vim.treesitter.get_parser(0, "hedgerow"):parse()[1]:root():has_error()
  end)
end
os.exit(failed and 1 or 0)
