# The files that `cmake --install` copies with the program, and its Debian package.
include(GNUInstallDirs)

# Installs the program only, not the tests and benchmarks.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)

install(FILES man/proskill.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES completions/proskill.bash
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME proskill)
install(FILES completions/_proskill DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
install(FILES completions/proskill.fish
        DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)

# The grammar for editors, which compile src/ and read queries/ themselves.
install(DIRECTORY tree-sitter-proskill/ DESTINATION ${CMAKE_INSTALL_DATADIR}/proskill/tree-sitter-proskill
        FILES_MATCHING PATTERN "*.scm" PATTERN "*.js" PATTERN "*.json" PATTERN "*.c" PATTERN "*.h"
        PATTERN "bindings" EXCLUDE PATTERN "test" EXCLUDE PATTERN "node_modules" EXCLUDE
        PATTERN "build" EXCLUDE)

# Neovim finds the system's plugins below share/nvim/site; its copy of the queries is a link.
set(nvim_site ${CMAKE_INSTALL_DATADIR}/nvim/site/pack/proskill/start/proskill)
install(DIRECTORY editors/nvim/ DESTINATION ${nvim_site}
        PATTERN "queries" EXCLUDE PATTERN "setup.lua" EXCLUDE PATTERN "parser" EXCLUDE
        PATTERN ".gitignore" EXCLUDE)
install(DIRECTORY tree-sitter-proskill/queries/ DESTINATION ${nvim_site}/queries/proskill)
install(TARGETS proskill_parser LIBRARY DESTINATION ${nvim_site}/parser)
install(DIRECTORY editors/helix/ DESTINATION ${CMAKE_INSTALL_DATADIR}/proskill/helix
        PATTERN "*.py" EXCLUDE)
install(FILES editors/emacs/proskill-mode.el editors/emacs/proskill-platform.el editors/emacs/proskill-verdicts.el
        DESTINATION ${CMAKE_INSTALL_DATADIR}/emacs/site-lisp)

install(FILES README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
install(DIRECTORY python/proskill DESTINATION lib/python3/dist-packages
  FILES_MATCHING PATTERN *.py PATTERN py.typed)
install(FILES python/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR}/python)
install(DIRECTORY docs examples DESTINATION ${CMAKE_INSTALL_DOCDIR})

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME proskill)
set(CPACK_PACKAGE_CONTACT "The ProSkill tools' authors <proskill@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION devel)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS libzmq5) # for `proskill run --groot`
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
    "ProSkill is a Lisp-like language for the skills of robots. This package checks
 programs, translates them to Fiacre, verifies them, and draws their automata.")
include(CPack)
