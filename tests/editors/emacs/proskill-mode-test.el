;;; proskill-mode-test.el --- Tests of the mode, in Emacs itself  -*- lexical-binding: t; -*-

(require 'ert)
(require 'imenu)
(require 'package)
(require 'project)
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

(ert-deftest the-mode-is-there-before-its-file-is-loaded ()
  (with-temp-buffer
    (insert-file-contents (locate-library "proskill-mode.el"))
    (dolist (command '("define-derived-mode proskill-mode" "add-to-list 'auto-mode-alist"))
      (goto-char (point-min))
      (should (re-search-forward (concat "^;;;###autoload\n(" (regexp-quote command)) nil t)))))

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

;; Exit code 1 is a verdict, and no failure of the program.
(ert-deftest the-end-of-a-verification-is-said-in-words ()
  (with-current-buffer (find-file-noselect (example "drone/drone"))
    (let ((buffer (proskill-verify "uav_mission.no_overshoot")))
      (wait-for (lambda () (not (get-buffer-process buffer))))
      (with-current-buffer buffer
        (goto-char (point-min))
        (should (search-forward "finished: there are bad properties" nil t))
        (should-not (search-forward "abnormally" nil t))))))

(ert-deftest the-project-of-a-program-is-where-its-settings-are ()
  (let* ((folder (file-name-as-directory (make-temp-file "project" t)))
         (part (concat folder "parts/lamp.proskill")))
    (make-directory (concat folder "parts"))
    (dolist (file (list part (concat folder ".proskill.json"))) (write-region "" nil file))
    (with-current-buffer (find-file-noselect part)
      (should (equal (project-root (project-current)) folder)))
    (delete-directory folder t)))

;; As in a terminal: there are no images and no other display.
(ert-deftest a-terminal-never-shows-the-text-of-a-picture ()
  (with-current-buffer (find-file-noselect (example "drone/drone"))
    (let ((process-environment (append '("DISPLAY" "WAYLAND_DISPLAY") process-environment)) said)
      (cl-letf (((symbol-function 'message) (lambda (&rest args) (setq said (apply #'format args)))))
        (proskill-automaton "takeoff"))
      (should (string-match "it is in \\(.*takeoff\\.svg\\)$" said))
      (should (file-exists-p (match-string 1 said)))
      (should-not (get-file-buffer (match-string 1 said))))))

(ert-deftest a-component-becomes-a-program-beside-it ()
  (let* ((folder (make-temp-file "proskill" t))
         (component (expand-file-name "gripper.gen" folder)))
    (copy-file (expand-file-name "../gripper/gripper.gen" (file-name-directory (example "drone/drone"))) component)
    (proskill-import component)
    (should (equal (buffer-file-name) (expand-file-name "gripper.proskill" folder)))
    (should (string-match-p "(defskill calibrate" (buffer-string)))
    (cl-letf (((symbol-function 'yes-or-no-p) #'ignore))
      (should-error (proskill-import component) :type 'user-error))
    (let ((imported (buffer-string)))
      (goto-char (point-min))
      (insert "; mine\n")
      (save-buffer)
      (cl-letf (((symbol-function 'yes-or-no-p) #'always))
        (proskill-import component))
      (should (equal (buffer-string) imported)))
    (should-error (proskill-import (expand-file-name "robot.urdf" folder)) :type 'user-error)))

(ert-deftest a-run-is-served-to-a-browser ()
  (with-current-buffer (find-file-noselect (example "drone/drone"))
    (proskill-run "--no-open --clock real")
    (let ((process (get-buffer-process "*ProSkill run*")))
      (wait-for (lambda ()
                  (with-current-buffer "*ProSkill run*"
                    (goto-char (point-min))
                    (re-search-forward "the run is shown at http://127\\.0\\.0\\.1:" nil t))))
      (signal-process process 'SIGTERM)
      (wait-for (lambda () (not (process-live-p process)))))))

(defun messages-of-findings ()
  (mapcar #'flymake-diagnostic-text (flymake-diagnostics)))

(defun has-finding (part)
  (seq-some (lambda (text) (string-match-p (regexp-quote part) text)) (messages-of-findings)))

;; In a copy of the drone that the server serves.
(defmacro with-served-drone (&rest body)
  `(let* ((directory (make-temp-file "proskill" t))
          (file (concat directory "/drone.proskill")))
     (copy-file (example "drone/drone") file)
     (with-current-buffer (find-file file)
       (let ((eglot-sync-connect t) (eglot-events-buffer-size 0) (flymake-no-changes-timeout 0))
         (apply #'eglot (eglot--guess-contact))
         (unwind-protect (progn ,@body)
           (eglot-shutdown (eglot-current-server))
           (set-buffer-modified-p nil)
           (kill-buffer))))))

(defun pause-in-typing ()
  (eglot--signal-textDocument/didChange)
  (flymake-start))

(ert-deftest eglot-shows-what-the-server-finds ()
  (skip-unless (require 'eglot nil t))
  (with-served-drone
   (goto-char (point-min))
   (search-forward "(takeoff height")
   (goto-char (+ 1 (match-beginning 0)))
   (delete-char 1)
   (pause-in-typing)
   (wait-for (lambda () (has-finding "unknown skill `akeoff`")))
   (insert "t")
   (pause-in-typing)
   (wait-for (lambda () (not (has-finding "akeoff"))))))

(defun line-of-step (trace count)
  (with-current-buffer trace (goto-char (point-min)))
  (next-error count t)
  (line-number-at-pos))

(defmacro with-verified-drone (&rest body)
  `(let* ((directory (make-temp-file "proskill" t))
          (file (concat directory "/drone.proskill")))
     (copy-file (example "drone/drone") file)
     (with-current-buffer (find-file file)
       (let ((trace (proskill-verify "uav_mission.no_overshoot")))
         (unwind-protect (progn ,@body)
           (with-current-buffer (find-buffer-visiting file)
             (set-buffer-modified-p nil)
             (kill-buffer)))))))

;; Emacs formats no mode line without a screen: this evaluates what it would evaluate.
(defun says-that-it-is-older (trace)
  (with-current-buffer trace
    (seq-some (lambda (part) (equal (eval (car (alist-get :eval (list part))) t) "(of an older text)"))
              mode-line-buffer-identification)))

(ert-deftest the-steps-of-an-older-trace-lead-to-where-their-text-is-now ()
  (with-verified-drone
   (wait-for (lambda () (not (get-buffer-process trace))))
   (should-not (says-that-it-is-older trace))
   (goto-char (point-min))
   (insert "; one\n; two\n")
   (should (equal (line-of-step trace 7) 86))
   (should (says-that-it-is-older trace))
   (with-current-buffer (find-buffer-visiting file)
     (delete-region (point-min) (progn (goto-char (point-min)) (forward-line 2) (point))))
   (should (equal (line-of-step trace 7) 84))
   (should-not (says-that-it-is-older trace))))

(ert-deftest a-text-that-is-edited-while-it-is-verified-is-not-that-of-the-trace ()
  (with-verified-drone
   (goto-char (point-max))
   (insert "; one\n")
   (wait-for (lambda () (not (get-buffer-process trace))))
   (should (says-that-it-is-older trace))))

;; The text on the disk is verified.
(ert-deftest a-text-that-was-not-saved-is-not-that-of-the-trace ()
  (with-verified-drone
   (wait-for (lambda () (not (get-buffer-process trace))))
   (insert "; one\n")
   (cl-letf (((symbol-function 'save-some-buffers) #'ignore))
     (proskill-verify "uav_mission.no_overshoot"))
   (wait-for (lambda () (not (get-buffer-process trace))))
   (should (says-that-it-is-older trace))))

(defun where-everything-is (trace)
  (list (selected-window) (current-buffer) (point) (window-start) (length (window-list))
        (with-current-buffer trace (list (point) (window-point (get-buffer-window trace)) (buffer-size)))))

(ert-deftest an-edit-while-a-trace-is-open-moves-nothing ()
  (skip-unless (require 'eglot nil t))
  (with-served-drone
   (let ((trace (proskill-verify "uav_mission.no_overshoot")))
     (wait-for (lambda () (not (get-buffer-process trace))))
     (next-error 7)
     (should (equal (line-number-at-pos) 84))
     (goto-char (point-min))
     (search-forward "[60,120")
     (delete-char -3)
     (insert "130")
     (redisplay)
     (let ((before (where-everything-is trace)))
       (pause-in-typing)
       (wait-for (lambda () (has-finding "takes at most 130 s from its start: violated")))
       (redisplay)
       (should (equal (where-everything-is trace) before))))))

;; A program that names a platform file, both in buffers, and the program's server.
(defmacro with-served-platform (name &rest body)
  `(let* ((directory (make-temp-file "proskill" t))
          (program (expand-file-name "main.proskill" directory))
          (platform (expand-file-name ,name directory))
          (eglot-sync-connect t) (eglot-events-buffer-size 0) (flymake-no-changes-timeout 0))
     (write-region (format "(defplatform %S)\n(defskill fly :action (fly) :success there)
(defskill mission :body ((fly)))\n" ,name) nil program)
     (write-region "{\"kind\": \"simulated\",\n \"actions\": {\"fly\": {\"duration\": [1, 2]}}}\n" nil platform)
     (find-file platform)
     (with-current-buffer (find-file-noselect program)
       (apply #'eglot (eglot--guess-contact))
       (unwind-protect
           (progn (proskill-platform-follow) (flymake-start) ,@body)
         (eglot-shutdown (eglot-current-server))
         (dolist (file (list program platform))
           (when (find-buffer-visiting file)
             (with-current-buffer (find-buffer-visiting file)
               (set-buffer-modified-p nil)
               (kill-buffer))))))))

(defun misspell-in (file)
  (with-current-buffer (find-buffer-visiting file)
    (goto-char (point-min))
    (search-forward "\"fly")
    (insert "y")
    (flymake-start)))

(defun has-finding-in (file part)
  (and (find-buffer-visiting file)
       (with-current-buffer (find-buffer-visiting file) (has-finding part))))

(ert-deftest a-platform-file-is-checked-before-it-is-saved ()
  (skip-unless (require 'eglot nil t))
  (with-served-platform "robot.platform.json"
    (misspell-in platform)
    (wait-for (lambda () (has-finding-in platform "there is no basic skill `flyy`")))
    (wait-for (lambda () (has-finding-in program "flyy")))
    (with-current-buffer (find-buffer-visiting platform)
      (should (buffer-modified-p))
      (should-not (eglot-managed-p))
      (let ((finding (car (flymake-diagnostics))))
        (should (equal (line-number-at-pos (flymake-diagnostic-beg finding)) 2)))
      (goto-char (point-min))
      (search-forward "flyy")
      (delete-char -1)
      (flymake-start))
    (wait-for (lambda () (not (has-finding-in platform "flyy"))))
    (wait-for (lambda () (not (has-finding-in program "flyy"))))))

(ert-deftest a-file-with-any-name-is-checked-while-a-program-names-it ()
  (skip-unless (require 'eglot nil t))
  (with-served-platform "sky.json"
    (misspell-in platform)
    (wait-for (lambda () (has-finding-in platform "there is no basic skill `flyy`")))
    (goto-char (point-min))
    (kill-whole-line)
    (eglot--signal-textDocument/didChange)
    (proskill-platform-follow)
    (wait-for (lambda () (not (has-finding-in platform "flyy"))))
    (should-not (buffer-local-value 'proskill-platform-mode (find-buffer-visiting platform)))))

(ert-deftest a-platform-file-that-is-closed-is-read-from-the-disk-again ()
  (skip-unless (require 'eglot nil t))
  (with-served-platform "platform.json"
    (misspell-in platform)
    (wait-for (lambda () (has-finding-in program "flyy")))
    (with-current-buffer (find-buffer-visiting platform)
      (set-buffer-modified-p nil)
      (kill-buffer))
    (wait-for (lambda () (not (has-finding-in program "flyy"))))))

(ert-deftest other-json-files-are-left-alone ()
  (let ((file (make-temp-file "proskill" nil ".json")))
    (with-current-buffer (find-file-noselect file)
      (proskill-platform-follow)
      (should-not proskill-platform-mode)
      (proskill-platform-mode 1)
      (proskill-platform-follow)
      (should proskill-platform-mode)
      (kill-buffer))))

;;; proskill-mode-test.el ends here
