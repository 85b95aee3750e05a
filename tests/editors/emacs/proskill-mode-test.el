;;; proskill-mode-test.el --- Tests of the mode, in Emacs itself  -*- lexical-binding: t; -*-

(require 'ert)
(require 'imenu)
(require 'package)
(package-initialize)
(require 'proskill-mode)

(defconst root (getenv "PROSKILL_ROOT"))
(setq proskill-program (getenv "PROSKILL_PROGRAM"))

(defun example (name)
  (concat root "/examples/" name ".proskill"))

(defmacro with-program (text &rest body)
  "Run BODY in a buffer with TEXT."
  (declare (indent 1))
  `(with-temp-buffer
     (proskill-mode)
     (insert ,text)
     ,@body))

(defun lines-that-differ (wanted got)
  (let (result)
    (cl-mapc (lambda (a b) (unless (equal a b) (push (list a b) result)))
             (split-string wanted "\n") (split-string got "\n"))
    (nreverse result)))

(ert-deftest examples-are-indented-again ()
  "Without its white space every example is indented as it was."
  (dolist (file (file-expand-wildcards (example "*/*")))
    (with-temp-buffer
      (insert-file-contents file)
      (let ((wanted (buffer-string)))
        (proskill-mode)
        (goto-char (point-min))
        (while (re-search-forward "^[ \t]+" nil t) (replace-match ""))
        (let ((inhibit-message t)) (indent-region (point-min) (point-max)))
        (should (equal (cons file (lines-that-differ wanted (buffer-string))) (list file)))))))

(ert-deftest models-in-fiacre-have-a-mode ()
  (with-temp-buffer
    (insert "// One.\nprocess P is\nstates a\n\nfrom a\n    wait ]0,...[; /* so */\n    to a\n")
    (let ((buffer-file-name "m.fcr")) (set-auto-mode))
    (should (eq major-mode 'fiacre-mode))
    (font-lock-ensure)
    (dolist (case '(("One" font-lock-comment-face) ("process" font-lock-keyword-face)
                    ("P" font-lock-function-name-face) ("wait" font-lock-keyword-face)
                    ("so" font-lock-comment-face)))
      (goto-char (point-min))
      (let (case-fold-search) (search-forward (car case)))
      (should (equal (list (car case) (get-text-property (match-beginning 0) 'face))
                     case)))))

(ert-deftest lines-are-indented-while-they-are-typed ()
  (with-program ""
    (dolist (line '("(defskill fly" ":success there" ":body" "((takeoff)"
                    "(if (= takeoff.status success)" "(land)" "elseif (battery Low)" "(rest)"
                    "else" "(fail)"))
      (insert line)
      (indent-according-to-mode)
      (end-of-line)
      (insert "\n"))
    (should (equal (buffer-string)
                   "(defskill fly
  :success there
  :body
    ((takeoff)
     (if (= takeoff.status success)
        (land)
      elseif (battery Low)
        (rest)
      else
        (fail)
"))))

(ert-deftest words-have-colours ()
  (with-program "; fly\n(defskill fly :input ($height float) :body ((printf \"up\") (if (battery Low) break)))"
    (font-lock-ensure)
    (dolist (case '(("fly\n" font-lock-comment-face) ("defskill" font-lock-keyword-face)
                    ("fly :input" font-lock-function-name-face) (":input" font-lock-builtin-face)
                    ("$height" font-lock-variable-name-face) ("up" font-lock-string-face)
                    ("if " font-lock-keyword-face) ("Low" font-lock-constant-face)
                    ("break" font-lock-keyword-face)))
      (goto-char (point-min))
      (let (case-fold-search) (search-forward (car case)))
      (should (equal (cons (car case) (list (get-text-property (match-beginning 0) 'face))) case)))))

(ert-deftest comments-are-made-and-taken-away ()
  (with-program "(defsv a :init 0)\n"
    (comment-region (point-min) (point-max))
    (should (equal (buffer-string) "; (defsv a :init 0)\n"))
    (uncomment-region (point-min) (point-max))
    (should (equal (buffer-string) "(defsv a :init 0)\n"))))

(ert-deftest definitions-are-in-the-index ()
  (with-current-buffer (find-file-noselect (example "drone/drone"))
    (should (eq major-mode 'proskill-mode))
    (let ((index (imenu--make-index-alist t)))
      (dolist (name '("battery" "battery_to_low" "takeoff" "uav_mission"))
        (should (assoc name index))))))

(defun wait-for (condition)
  "Wait until CONDITION gives something; fail where it does not in time."
  (let ((limit (+ (float-time) 20)) value)
    (while (not (or (setq value (funcall condition)) (> (float-time) limit)))
      (accept-process-output nil 0.05))
    (should value)
    value))

(ert-deftest steps-of-traces-lead-to-their-lines ()
  (with-current-buffer (find-file-noselect (example "drone/drone"))
    (let ((buffer (proskill-verify "uav_mission.no_overshoot")))
      (wait-for (lambda () (not (get-buffer-process buffer))))
      (with-current-buffer buffer
        (goto-char (point-min))
        (compilation-next-error 1)
        (let ((place (compilation--message->loc (get-text-property (point) 'compilation-message))))
          (should (equal (compilation--loc->line place) 162)))
        (dotimes (_ 6) (compilation-next-error 1))
        (let ((place (compilation--message->loc (get-text-property (point) 'compilation-message))))
          (should (equal (compilation--loc->line place) 84)))))))

;; As in a terminal: there are no images and no other display.
(ert-deftest a-terminal-never-shows-the-text-of-a-picture ()
  (with-current-buffer (find-file-noselect (example "drone/drone"))
    (let ((process-environment (append '("DISPLAY" "WAYLAND_DISPLAY") process-environment)) said)
      (cl-letf (((symbol-function 'message) (lambda (&rest args) (setq said (apply #'format args)))))
        (proskill-automaton "takeoff"))
      (should (string-match "it is in \\(.*takeoff\\.svg\\)$" said))
      (should (file-exists-p (match-string 1 said)))
      (should-not (get-file-buffer (match-string 1 said))))))

(defun messages-of-findings ()
  (mapcar #'flymake-diagnostic-text (flymake-diagnostics)))

(defun has-finding (part)
  (seq-some (lambda (text) (string-match-p (regexp-quote part) text)) (messages-of-findings)))

(ert-deftest eglot-shows-what-the-server-finds ()
  (skip-unless (require 'eglot nil t))
  (let* ((directory (make-temp-file "proskill" t))
         (file (concat directory "/drone.proskill")))
    (copy-file (example "drone/drone") file)
    (with-current-buffer (find-file-noselect file)
      (let ((eglot-sync-connect t) (eglot-events-buffer-size 0) (flymake-no-changes-timeout 0))
        (apply #'eglot (eglot--guess-contact))
        (goto-char (point-min))
        (search-forward "(takeoff height")
        (goto-char (+ 1 (match-beginning 0)))
        (delete-char 1)
        ;; simulates a pause in typing
        (eglot--signal-textDocument/didChange)
        (flymake-start)
        (wait-for (lambda () (has-finding "unknown skill `akeoff`")))
        (insert "t")
        (eglot--signal-textDocument/didChange)
        (flymake-start)
        (wait-for (lambda () (not (has-finding "akeoff"))))
        (eglot-shutdown (eglot-current-server))
        (set-buffer-modified-p nil)
        (kill-buffer)))))

;;; proskill-mode-test.el ends here
