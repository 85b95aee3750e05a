;;; proskill-mode.el --- Major mode for ProSkill, a language for the skills of robots  -*- lexical-binding: t; -*-

;; Version: 0.1.0
;; Package-Requires: ((emacs "27.1"))
;; Keywords: languages
;; SPDX-License-Identifier: MIT

;;; Commentary:

;; Colours, indentation in the formatter's style, imenu, and the language server
;; through eglot (M-x eglot).  M-x proskill-verify lists verdicts and traces, each step
;; at its line; M-x proskill-automaton draws a definition.

;;; Code:

(require 'compile)
(require 'imenu)
(require 'subr-x)
(require 'proskill-platform)
(require 'proskill-verdicts)

(defgroup proskill nil
  "Robot skills in ProSkill."
  :group 'languages)

(defcustom proskill-program "proskill"
  "The program `proskill', which is also the language server."
  :type 'string)

(defvar eglot-server-programs)

(with-eval-after-load 'eglot
  (add-to-list 'eglot-server-programs
               (cons '(proskill-mode fiacre-mode) (lambda (&rest _) (list proskill-program "lsp")))))

;;; Syntax and colours

(defvar proskill-mode-syntax-table
  (let ((table (make-syntax-table)))
    (modify-syntax-entry ?\; "<" table)
    (modify-syntax-entry ?\n ">" table)
    (modify-syntax-entry ?\" "\"" table)
    (modify-syntax-entry ?_ "_" table)
    (dolist (character '(?: ?$ ?- ?+ ?* ?/ ?= ?< ?> ?& ?| ?~ ?^))
      (modify-syntax-entry character "_" table))
    (modify-syntax-entry ?. "." table)
    ;; Intervals need not be balanced: ]0,1] and [1,...[
    (modify-syntax-entry ?\[ "." table)
    (modify-syntax-entry ?\] "." table)
    table))

(defconst proskill--definitions
  '("defconst" "defsv" "defevent" "defskill" "defresource" "defproperty" "defenvironment"
    "defplatform"))

(defconst proskill--top-level
  (concat "(" (regexp-opt (cons "include" proskill--definitions)) "\\_>"))

(defconst proskill--statements
  '("if" "case" "while" "do" "do-until" "label" "goto" "//" "race" "set" "printf" "success"
    "failure" "emit" "choose"))

(defconst proskill--patterns
  '("always" "never" "reachable" "always_reachable" "deadlockfree" "infinitelyoften" "leadsto"
    "precedes" "present" "absent" "longest" "shortest" "ltl" "running" "called" "ended" "occurs"
    "at" "value"))

(defconst proskill--font-lock
  `((,(concat "(" (regexp-opt '("defskill") t) "\\s-+\\(\\_<[A-Za-z_][A-Za-z0-9_]*\\)")
     (1 font-lock-keyword-face) (2 font-lock-function-name-face))
    (,(concat "(" (regexp-opt '("defevent" "defenvironment") t)
              "\\s-+\\(\\_<[A-Za-z_][A-Za-z0-9_]*\\)")
     (1 font-lock-keyword-face) (2 font-lock-type-face))
    (,(concat "(" (regexp-opt '("defconst" "defsv" "defresource" "defproperty") t)
              "\\s-+\\(\\_<[A-Za-z_][A-Za-z0-9_]*\\)")
     (1 font-lock-keyword-face) (2 font-lock-variable-name-face))
    ("(\\(include\\)\\_>" 1 font-lock-preprocessor-face)
    (,(concat "(" (regexp-opt proskill--statements t) "\\_>") 1 font-lock-keyword-face)
    (,(concat "^\\s-*" (regexp-opt '("elseif" "else" "until") t) "\\_>") 1 font-lock-keyword-face)
    ("\\_<break\\_>" . font-lock-keyword-face)
    (,(concat "(" (regexp-opt proskill--patterns t) "\\_>") 1 font-lock-builtin-face)
    ("(\\([GFXUWRM]\\)\\s-*(" 1 font-lock-builtin-face)
    ("\\_<:[A-Za-z_]+\\_>" . font-lock-builtin-face)
    ("\\_<\\$[A-Za-z_][A-Za-z0-9_]*" . font-lock-variable-name-face)
    ("\\_<\\(?:true\\|false\\)\\_>" . font-lock-constant-face)
    ("\\_<[A-Z][A-Za-z0-9_]*\\_>" . font-lock-constant-face)
    ("\\.\\(status\\|res\\|interrupt\\)\\_>" 1 font-lock-builtin-face)))

;;; Indentation: the innermost parenthesis that is open decides, as in the formatter.

(defconst proskill--list-fields
  '(":states" ":transitions" ":input" ":precondition" ":invariant" ":success" ":failure"
    ":resources" ":interrupt" ":body")
  "Fields whose value is a list without a head word.")

(defun proskill--word-before (position)
  "The symbol before POSITION and white space; nil where there is none."
  (save-excursion
    (goto-char position)
    (forward-comment (- (point)))
    (let ((end (point)))
      (skip-chars-backward "A-Za-z0-9_:$")
      (and (< (point) end) (buffer-substring-no-properties (point) end)))))

(defun proskill--parts (open limit)
  "The positions of the parts of the form at OPEN that begin before LIMIT."
  (save-excursion
    (goto-char (1+ open))
    (let (parts)
      (forward-comment (buffer-size))
      (while (and (< (point) limit) (not (eobp)) (not (looking-at ")")))
        (push (point) parts)
        (condition-case nil
            (if (looking-at "\\s.") (forward-char) (forward-sexp))
          (scan-error (goto-char limit)))
        (forward-comment (buffer-size)))
      (nreverse parts))))

(defun proskill--column (position)
  (save-excursion (goto-char position) (current-column)))

(defun proskill--is-list (open)
  "Whether the form at OPEN has no head word."
  (or (memq (char-after (1+ open)) '(?\( ?:))
      (member (proskill--word-before open) proskill--list-fields)))

(defun proskill--hanging (parts line)
  "The column below the field or tag that goes on in LINE, or nil.
PARTS are those of the form around it."
  (let* ((behind (reverse parts))
         (last (car behind))
         (before (cadr behind))
         (opens (save-excursion (goto-char line) (looking-at "[ \t]*\\((\\|$\\)")))
         (is-form (and last (memq (char-after last) '(?\( ?\" ?\[ ?\]))))
         (is-field (lambda (at) (and at (eq (char-after at) ?:)))))
    (cond ((or (not opens) (not last) is-form) nil)
          ((funcall is-field last) (+ 2 (proskill--column last)))
          ;; `:success landed', and a clause below it.
          ((and (funcall is-field before)
                (member (proskill--symbol-at before) '(":success" ":failure"))
                (save-excursion (goto-char line) (looking-at "[ \t]*(")))
           (+ 2 (proskill--column before))))))

(defun proskill--symbol-at (position)
  (save-excursion
    (goto-char position)
    (buffer-substring-no-properties
     (point) (progn (skip-chars-forward "A-Za-z0-9_:$/^-") (point)))))

(defun proskill--indentation ()
  "The column in which the line at point begins."
  (save-excursion
    (beginning-of-line)
    (let* ((line (point))
           (open (nth 1 (syntax-ppss)))
           (begins (lambda (words) (looking-at (concat "[ \t]*" (regexp-opt words) "\\_>")))))
      (if (or (not open) (looking-at proskill--top-level))
          0
        (let* ((base (proskill--column open))
               (head (proskill--symbol-at (1+ open)))
               (parts (proskill--parts open line)))
          (cond
           ((member head proskill--definitions)
            (or (proskill--hanging (cdr parts) line) (+ base 2)))
           ((proskill--is-list open)
            (or (and (eq (char-after (1+ open)) ?:) (proskill--hanging parts line))
                (let ((tag (car (last parts))))
                  (and tag (looking-at "[ \t]*(") (not (memq (char-after tag) '(?\( ?:)))
                       (not (equal (proskill--word-before open) ":body"))
                       (+ 2 (proskill--column tag))))
                (1+ base)))
           ((member head '("if" "case" "while" "do" "do-until"))
            (+ base (if (funcall begins '("elseif" "else" "until")) 1 3)))
           ((and (cdr parts) (= (line-number-at-pos open) (line-number-at-pos (cadr parts))))
            (proskill--column (cadr parts)))
           (t (1+ base))))))))

(defun proskill-indent-line ()
  "Indent the line as the formatter does."
  (interactive)
  (let ((column (proskill--indentation)))
    (if (<= (current-column) (current-indentation))
        (indent-line-to column)
      (save-excursion (indent-line-to column)))))

;;; Commands

(defun proskill--file ()
  (or (and (derived-mode-p 'proskill-mode) buffer-file-name)
      (user-error "Not a ProSkill program")))

(defun proskill-automaton (name)
  "Draw the state variable, skill or environment that is called NAME."
  (interactive
   (list (completing-read "Draw: " (imenu--make-index-alist t) (lambda (it) (stringp (car it))))))
  (let ((file (proskill--file))
        (picture (expand-file-name (concat name ".svg") temporary-file-directory)))
    (with-temp-buffer
      (unless (zerop (call-process proskill-program nil t nil
                                   "graph" "--format" "svg" "--name" name "-o" picture file))
        (user-error "%s" (string-trim (buffer-string)))))
    (cond ((and (display-images-p) (image-type-available-p 'svg))
           (find-file-other-window picture))
          ;; In a terminal an SVG would be shown as its text.
          ((or (getenv "DISPLAY") (getenv "WAYLAND_DISPLAY")) (browse-url-of-file picture))
          (t (message "A terminal shows no pictures: it is in %s" picture)))))

(defun proskill-run (options)
  "Run the program, and show the run in the browser while it happens.
OPTIONS are those of `proskill run', such as \"--clock real\".  With a prefix
argument, ask for them.  A run that this has started before is ended."
  (interactive (list (if current-prefix-arg (read-string "Options: " "--clock real ") "")))
  (let* ((file (proskill--file))
         (name "*ProSkill run*")
         (former (get-buffer-process name)))
    (save-some-buffers nil (lambda () (derived-mode-p 'proskill-mode)))
    (when former
      (signal-process former 'SIGTERM)
      (while (process-live-p former) (accept-process-output former 0.1)))
    (with-current-buffer (get-buffer-create name)
      (erase-buffer))
    (apply #'start-process "proskill-run" name proskill-program
           (append '("run" "--view" "--color" "never") (split-string-and-unquote options) (list file)))
    (message "The run is shown in the browser; its steps are in %s" name)))

;;;###autoload
(defun proskill-import (file)
  "Write FILE, a behavior tree, component or skillset, as a program, and open it.
The program is written beside FILE.  A file `leaves.json' there gives durations."
  (interactive "fImport (.xml, .gen, .rl, .rlc): ")
  (let* ((file (expand-file-name file))
         (language (cdr (assoc (file-name-extension file) '(("xml" . "bt") ("gen" . "gen") ("rl" . "rl") ("rlc" . "rl")))))
         (target (concat (file-name-sans-extension file) ".proskill"))
         (leaves (expand-file-name "leaves.json" (file-name-directory file)))
         (there (file-exists-p target)))
    (unless language
      (user-error "Not a behavior tree (.xml), a component (.gen), a skillset (.rl) or a composite (.rlc)"))
    (when (and there
               (not (yes-or-no-p (format "%s exists; replace it? " (file-name-nondirectory target)))))
      (user-error "Nothing was imported"))
    (with-temp-buffer
      (let ((code (apply #'call-process proskill-program nil t nil "import" language file "-o" target
                         (append (and there '("--force"))
                                 (and (not (equal language "rl")) (file-exists-p leaves) (list "--leaves" leaves))))))
        (unless (eql code 0)
          (user-error "%s" (string-trim (buffer-string))))
        (message "%s" (string-trim (buffer-string)))))
    (find-file target)
    (revert-buffer t t t)))

;;; The mode

(defvar proskill-mode-map
  (let ((map (make-sparse-keymap)))
    (define-key map (kbd "C-c C-v") #'proskill-verify)
    (define-key map (kbd "C-c C-a") #'proskill-automaton)
    (define-key map (kbd "C-c C-r") #'proskill-run)
    map))

(defvar proskill--imenu
  (mapcar (lambda (it)
            (list nil (concat "^(" it "\\s-+\\([A-Za-z_][A-Za-z0-9_]*\\)") 1))
          proskill--definitions))

(defun proskill--project (directory)
  "The project of a program in DIRECTORY: where its settings are."
  (let ((root (locate-dominating-file directory ".proskill.json")))
    (and root (cons 'transient (expand-file-name root)))))

;;;###autoload
(define-derived-mode proskill-mode prog-mode "ProSkill"
  "Major mode for programs in ProSkill."
  (setq-local comment-start "; ")
  (setq-local comment-start-skip ";+ *")
  (setq-local comment-end "")
  (setq-local font-lock-defaults '(proskill--font-lock))
  (setq-local indent-line-function #'proskill-indent-line)
  (setq-local indent-tabs-mode nil)
  (setq-local imenu-generic-expression proskill--imenu)
  (add-hook 'project-find-functions #'proskill--project nil t)
  (setq-local beginning-of-defun-function
              (lambda (&optional count) (re-search-backward "^(" nil 'move (or count 1))))
  (setq-local electric-indent-chars (append "():" electric-indent-chars)))

;;;###autoload
(add-to-list 'auto-mode-alist '("\\.proskill\\'" . proskill-mode))

;;; Models in Fiacre

(defconst fiacre--control
  '("begin" "case" "do" "else" "elsif" "end" "foreach" "from" "if" "loop" "of" "on" "par"
    "return" "select" "start" "then" "to" "unless" "wait" "where" "while"))
(defconst fiacre--declarations
  '("assert" "channel" "component" "const" "extern" "function" "in" "init" "is" "out" "port"
    "priority" "process" "property" "prove" "read" "states" "task" "type" "var" "write"))
(defconst fiacre--types '("array" "bool" "int" "nat" "none" "queue" "record" "sync" "union"))
(defconst fiacre--builtins
  '("and" "append" "dequeue" "empty" "enqueue" "first" "full" "not" "or" "release" "until"
    "absent" "after" "always" "before" "between" "deadlockfree" "duration" "enter" "event"
    "for" "infinitelyoften" "interval" "lasting" "leadsto" "leave" "ltl" "mortal"
    "precedes" "present" "state" "tag" "value" "within"))

(defconst fiacre--font-lock
  `((,(concat "\\_<" (regexp-opt '("process" "component" "function" "type" "channel" "property") t)
              "\\_>\\s-+\\([A-Za-z_][A-Za-z0-9_]*\\)")
     (1 font-lock-keyword-face) (2 font-lock-function-name-face))
    ("\\_<\\(from\\|to\\)\\_>\\s-+\\([A-Za-z_][A-Za-z0-9_]*\\)"
     (1 font-lock-keyword-face) (2 font-lock-constant-face))
    ("#[A-Za-z_][A-Za-z0-9_]*" . font-lock-constant-face)
    (,(regexp-opt (append fiacre--control fiacre--declarations) 'symbols) . font-lock-keyword-face)
    (,(regexp-opt fiacre--types 'symbols) . font-lock-type-face)
    (,(regexp-opt fiacre--builtins 'symbols) . font-lock-builtin-face)
    ("\\_<\\(?:true\\|false\\|null\\|any\\)\\_>" . font-lock-constant-face)))

(defvar fiacre-mode-syntax-table
  (let ((table (make-syntax-table prog-mode-syntax-table)))
    (modify-syntax-entry ?/ ". 124b" table)
    (modify-syntax-entry ?* ". 23" table)
    (modify-syntax-entry ?\n "> b" table)
    (modify-syntax-entry ?_ "_" table)
    ;; Intervals of time open with `]' and close with `['.
    (modify-syntax-entry ?\[ "." table)
    (modify-syntax-entry ?\] "." table)
    table))

;;;###autoload
(define-derived-mode fiacre-mode prog-mode "Fiacre"
  "Major mode for models in Fiacre."
  (setq-local comment-start "// ")
  (setq-local comment-end "")
  (setq-local comment-start-skip "\\(?://+\\|/\\*+\\)\\s-*")
  (setq-local indent-tabs-mode nil)
  (setq-local tab-width 4)
  (setq-local indent-line-function #'indent-relative)
  (setq-local font-lock-defaults '(fiacre--font-lock)))

;;;###autoload
(add-to-list 'auto-mode-alist '("\\.fcr\\'" . fiacre-mode))

(provide 'proskill-mode)
;;; proskill-mode.el ends here
