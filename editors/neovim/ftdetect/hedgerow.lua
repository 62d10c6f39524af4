vim.filetype.add({ extension = { hedge = "hedgerow" } })
