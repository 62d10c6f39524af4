return {
  cmd = { vim.env.HEDGEROW or "hedgerow", "lsp" },
  filetypes = { "hedgerow" },
  root_markers = { ".git" },
}
