autocmd BufRead,BufNewFile *.fcr setfiletype fiacre
