;;; proskill-platform.el --- Platform files of ProSkill programs, checked while they are edited  -*- lexical-binding: t; -*-

;; Version: 0.1.0
;; Package-Requires: ((emacs "27.1"))
;; Keywords: languages
;; SPDX-License-Identifier: MIT

;;; Commentary:

;; The language servers of the open programs (eglot) get the texts of open platform
;; files, and nothing else, so that a server for JSON is not disturbed.  What they find
;; in a file is shown by flymake, beside what others find.

;;; Code:

(require 'flymake)
(require 'seq)
(require 'subr-x)
(require 'url-util)

(declare-function eglot-current-server "eglot")
(declare-function eglot--capabilities "eglot")
(declare-function jsonrpc-notify "jsonrpc")
(declare-function jsonrpc-running-p "jsonrpc")

(defvar-local proskill-platform--servers nil
  "The servers that have the text of this buffer.")
(defvar-local proskill-platform--version 0
  "The number of changes that the servers have got.")
(defvar-local proskill-platform--tick nil
  "The change of the buffer whose text the servers have.")
(defvar-local proskill-platform--is-followed nil
  "Whether the mode was switched on by `proskill-platform-follow'.")
(defvar-local proskill-platform--report nil
  "The function by which flymake gets findings.")
(defvar-local proskill-platform--findings nil
  "What the servers have found: an alist of servers and diagnostics.")

(defun proskill-platform--programs ()
  "The buffers with programs."
  (seq-filter (lambda (it) (eq (buffer-local-value 'major-mode it) 'proskill-mode)) (buffer-list)))

(defun proskill-platform--running ()
  "The servers of the open programs."
  (when (featurep 'eglot)
    (seq-filter #'jsonrpc-running-p
                (delete-dups (delq nil (mapcar (lambda (it) (with-current-buffer it (eglot-current-server)))
                                               (proskill-platform--programs)))))))

(defun proskill-platform--is-named (file)
  "Whether an open program names FILE."
  (seq-some
   (lambda (program)
     (with-current-buffer program
       (save-excursion
         (save-restriction
           (widen)
           (goto-char (point-min))
           (let (found)
             (while (and (not found)
                         (re-search-forward "(\\s-*defplatform\\s-+\"\\([^\"\n]+\\)\"" nil t))
               (setq found (file-equal-p (expand-file-name (match-string 1)) file)))
             found)))))
   (proskill-platform--programs)))

(defun proskill-platform--is-platform ()
  "Whether the current buffer has a platform file."
  (and buffer-file-name
       (not (file-remote-p buffer-file-name))
       (string-suffix-p ".json" buffer-file-name)
       (or (string-match-p "\\(?:/\\|\\.\\)platform\\.json\\'" buffer-file-name)
           (proskill-platform--is-named buffer-file-name))))

;;; What goes to the servers

(defun proskill-platform--uri ()
  (concat "file://" (url-hexify-string (file-truename buffer-file-name) url-path-allowed-chars)))

(defun proskill-platform--text ()
  (save-restriction (widen) (buffer-substring-no-properties (point-min) (point-max))))

(defun proskill-platform--open (server)
  (push server proskill-platform--servers)
  (setq proskill-platform--tick (buffer-chars-modified-tick))
  (jsonrpc-notify server :textDocument/didOpen
                  (list :textDocument (list :uri (proskill-platform--uri) :languageId "json"
                                            :version proskill-platform--version
                                            :text (proskill-platform--text)))))

(defun proskill-platform--send-change ()
  "Give the servers the text as it is now, if it has changed."
  (let ((tick (buffer-chars-modified-tick)))
    (unless (eql tick proskill-platform--tick)
      (setq proskill-platform--tick tick
            proskill-platform--version (1+ proskill-platform--version))
      (dolist (server (seq-filter #'jsonrpc-running-p proskill-platform--servers))
        (jsonrpc-notify server :textDocument/didChange
                        (list :textDocument (list :uri (proskill-platform--uri)
                                                  :version proskill-platform--version)
                              :contentChanges (vector (list :text (proskill-platform--text)))))))))

(defun proskill-platform--close ()
  (dolist (server (seq-filter #'jsonrpc-running-p proskill-platform--servers))
    (jsonrpc-notify server :textDocument/didClose
                    (list :textDocument (list :uri (proskill-platform--uri)))))
  (setq proskill-platform--servers nil
        proskill-platform--findings nil))

;;; What comes back

(defun proskill-platform--position (place server)
  "The position in the buffer of PLACE, as the encoding of SERVER counts."
  (let* ((encoding (or (plist-get (eglot--capabilities server) :positionEncoding) "utf-16"))
         (width (pcase encoding
                  ("utf-8" (lambda (it) (string-bytes (char-to-string it))))
                  ("utf-32" (lambda (_) 1))
                  (_ (lambda (it) (if (> it #xffff) 2 1)))))
         (left (plist-get place :character)))
    (save-excursion
      (goto-char (point-min))
      (forward-line (plist-get place :line))
      (while (and (> left 0) (not (eolp)))
        (setq left (- left (funcall width (char-after))))
        (forward-char))
      (point))))

(defun proskill-platform--finding (diagnostic server)
  "The finding of flymake for DIAGNOSTIC of SERVER."
  (let* ((range (plist-get diagnostic :range))
         (begin (proskill-platform--position (plist-get range :start) server))
         (end (proskill-platform--position (plist-get range :end) server)))
    (when (<= end begin)
      (setq end (save-excursion (goto-char begin)
                                (if (eolp) (min (point-max) (1+ begin))
                                  (or (ignore-errors (forward-sexp) (min (point) (line-end-position)))
                                      (1+ begin))))))
    (flymake-make-diagnostic (current-buffer) begin (max end (1+ begin))
                             (if (eql (plist-get diagnostic :severity) 1) :error :warning)
                             (plist-get diagnostic :message))))

(defun proskill-platform--show ()
  (when proskill-platform--report
    (funcall proskill-platform--report
             (apply #'append (mapcar #'cdr proskill-platform--findings))
             :region (cons (point-min) (point-max)))))

(defun proskill-platform--flymake (report &rest _)
  "A backend of flymake: REPORT is called now, and whenever servers publish."
  (setq proskill-platform--report report)
  (when proskill-platform--servers (proskill-platform--send-change))
  (proskill-platform--show))

(defun proskill-platform--take (server diagnostics)
  "Show what SERVER has found in the current buffer."
  (save-restriction
    (widen)
    (setf (alist-get server proskill-platform--findings)
          (mapcar (lambda (it) (proskill-platform--finding it server)) diagnostics)))
  (proskill-platform--show))

(defun proskill-platform--buffer (uri server)
  "The buffer of the platform file URI whose text SERVER has."
  (let ((file (url-unhex-string (string-remove-prefix "file://" uri))))
    (seq-find (lambda (it)
                (and (memq server (buffer-local-value 'proskill-platform--servers it))
                     (equal (file-truename (buffer-file-name it))
                            (decode-coding-string file 'utf-8))))
              (buffer-list))))

(defun proskill-platform--notified (handle server method &rest params)
  "Take diagnostics of platform files instead of eglot, whose buffers they are not.
HANDLE is what eglot does with METHOD of SERVER and its PARAMS otherwise."
  (let ((buffer (and (eq method 'textDocument/publishDiagnostics)
                     (proskill-platform--buffer (plist-get params :uri) server))))
    (if (not buffer)
        (apply handle server method params)
      (with-current-buffer buffer
        (proskill-platform--take server (append (plist-get params :diagnostics) nil))))))

(with-eval-after-load 'eglot
  (advice-add 'eglot-handle-notification :around #'proskill-platform--notified))

;;; The mode

;;;###autoload
(define-minor-mode proskill-platform-mode
  "Check a platform file while it is edited, with the open programs that name it.
It is on by itself in files that an open program names, in `platform.json' and
in files `NAME.platform.json'."
  :lighter " Platform"
  (cond (proskill-platform-mode
         (add-hook 'flymake-diagnostic-functions #'proskill-platform--flymake nil t)
         ;; This default of Emacs 28 does not suit JSON, and would warn.
         (when (equal (default-value 'flymake-diagnostic-functions) '(flymake-proc-legacy-flymake))
           (setq flymake-diagnostic-functions (remq t flymake-diagnostic-functions)))
         (add-hook 'kill-buffer-hook #'proskill-platform--close nil t)
         (flymake-mode 1)
         (proskill-platform--join))
        (t
         (proskill-platform--close)
         (proskill-platform--show)
         (setq proskill-platform--is-followed nil)
         (setq proskill-platform--report nil)
         (remove-hook 'flymake-diagnostic-functions #'proskill-platform--flymake t)
         (remove-hook 'kill-buffer-hook #'proskill-platform--close t))))

(defun proskill-platform--join ()
  "Give the text of the current buffer to the servers that do not have it."
  (let ((running (proskill-platform--running)))
    (setq proskill-platform--servers (seq-intersection proskill-platform--servers running)
          proskill-platform--findings
          (seq-filter (lambda (it) (memq (car it) running)) proskill-platform--findings))
    (dolist (server running)
      (unless (memq server proskill-platform--servers)
        (proskill-platform--open server)))))

;;;###autoload
(defun proskill-platform-follow (&rest _)
  "Switch `proskill-platform-mode' on in open platform files, and off in others."
  (dolist (buffer (buffer-list))
    (when (string-suffix-p ".json" (or (buffer-file-name buffer) ""))
      (with-current-buffer buffer
        (cond (proskill-platform-mode
               (if (or (not proskill-platform--is-followed) (proskill-platform--is-platform))
                   (proskill-platform--join)
                 (proskill-platform-mode -1)))
              ((proskill-platform--is-platform)
               (proskill-platform-mode 1)
               (setq proskill-platform--is-followed t)))))))

(defvar proskill-platform--timer nil)

(defun proskill-platform-follow-soon (&rest _)
  "Follow what open programs name once there is time."
  (unless proskill-platform--timer
    (setq proskill-platform--timer
          (run-with-idle-timer 0.2 nil (lambda ()
                                         (setq proskill-platform--timer nil)
                                         (proskill-platform-follow))))))

;; A program may name a file from now on, or none any more; its server may have started.
(add-hook 'find-file-hook #'proskill-platform-follow-soon)
(add-hook 'eglot-managed-mode-hook #'proskill-platform-follow-soon)

(defun proskill-platform--follow-program ()
  "Follow the platform file that the program in this buffer names."
  (add-hook 'after-change-functions #'proskill-platform-follow-soon nil t))
(add-hook 'proskill-mode-hook #'proskill-platform--follow-program)

(provide 'proskill-platform)
;;; proskill-platform.el ends here
