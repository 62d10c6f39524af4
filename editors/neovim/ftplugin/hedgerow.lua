vim.bo.commentstring = "// %s"
vim.bo.shiftwidth = 2
vim.bo.expandtab = true
vim.bo.iskeyword = "@,48-57,_,',192-255"
-- Without the grammar the text is shown plain.
pcall(vim.treesitter.start, 0, "hedgerow")
