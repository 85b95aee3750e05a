autocmd BufRead,BufNewFile *.proskill setfiletype proskill
