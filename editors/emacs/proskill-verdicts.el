;;; proskill-verdicts.el --- Verdicts and traces of ProSkill programs  -*- lexical-binding: t; -*-

;; SPDX-License-Identifier: MIT

;;; Commentary:

;; M-x proskill-verify lists verdicts and traces, and `next-error' goes through the
;; steps.  Their places become markers when the traces arrive: a step leads to where
;; its text is now.  The mode line says when the trace is of an older text.

;;; Code:

(require 'compile)
(require 'seq)
(require 'subr-x)

(defvar proskill-program)
(declare-function proskill--file "proskill-mode")

(define-compilation-mode proskill-verdicts-mode "Verdicts"
  "Verdicts of `proskill verify'; \\[next-error] goes through the steps of their traces."
  (setq-local compilation-error-regexp-alist-alist
              '((proskill "\\(?:^ *--> \\| \\)\\([^ \n:]+\\.proskill\\):\\([0-9]+\\):\\([0-9]+\\)$"
                          1 2 3)))
  (setq-local compilation-error-regexp-alist '(proskill))
  (setq-local compilation-exit-message-function #'proskill--verified)
  (setq-local mode-line-buffer-identification
              (append mode-line-buffer-identification
                      '((:eval (if (proskill--is-older) (propertize "(of an older text)" 'face 'warning) "")))))
  (add-hook 'compilation-start-hook #'proskill--note-texts nil t)
  (add-hook 'compilation-finish-functions #'proskill--place-markers nil t))

(defun proskill--verified (_status code message)
  "What to say of a verification that ended with CODE; MESSAGE is that of Emacs."
  (pcase code
    (0 '("finished: all properties are good\n" . "good"))
    (1 '("finished: there are bad properties\n" . "bad"))
    (_ (cons message code))))

;;; Texts that are edited after, or during their verification

(defvar-local proskill--texts nil
  "A list of (BUFFER TICK HASH): the texts of the programs when they were verified.
HASH is nil for a text that was not saved: the one on the disk was verified.")

(defun proskill--note-texts (_process)
  (setq proskill--texts
        (mapcar (lambda (buffer)
                  (list buffer (buffer-chars-modified-tick buffer)
                        (unless (buffer-modified-p buffer) (buffer-hash buffer))))
                (seq-filter (lambda (buffer) (with-current-buffer buffer (derived-mode-p 'proskill-mode)))
                            (buffer-list)))))

(defun proskill--is-older ()
  "Whether a text is not the one that was verified."
  (seq-some (lambda (text)
              (pcase-let ((`(,buffer ,tick ,hash) text))
                (and (buffer-live-p buffer)
                     (not (and hash (= tick (buffer-chars-modified-tick buffer))))
                     (not (equal hash (buffer-hash buffer))))))
            proskill--texts))

(defun proskill--place-markers (buffer _status)
  "Mark the places of all steps in BUFFER, in the files that are open."
  (with-current-buffer buffer
    (compilation--ensure-parse (point-max))
    (let ((at (point-min)))
      (while (setq at (next-single-property-change at 'compilation-message))
        (when-let ((step (get-text-property at 'compilation-message)))
          (proskill--place-marker (compilation--message->loc step)))))))

(defun proskill--place-marker (place)
  "Mark PLACE, a location of `compile', in the text of its file."
  (pcase-let* ((`(,file ,directory) (car (compilation--loc->file-struct place)))
               (text (find-buffer-visiting (expand-file-name file directory)))
               (line (compilation--loc->line place))
               (column (compilation--loc->col place))
               (columns compilation-error-screen-columns))
    (when (and text (not (compilation--loc->marker place)))
      (with-current-buffer text
        (save-excursion
          (save-restriction
            (widen)
            (goto-char (point-min))
            (forward-line (1- line))
            (compilation-move-to-column column columns)
            (setf (compilation--loc->marker place) (point-marker))))))))

;;; The command

(defun proskill-verify (property)
  "Verify the program, or only PROPERTY: a name, or its beginning up to a dot."
  (interactive "sProperty (empty: all): ")
  (let ((file (proskill--file)))
    (save-some-buffers nil (lambda () (derived-mode-p 'proskill-mode)))
    (compilation-start
     (mapconcat #'shell-quote-argument
                (append (list proskill-program "verify" "--color" "never")
                        (and (not (string-empty-p property)) (list "--property" property))
                        (list file))
                " ")
     #'proskill-verdicts-mode)))

(provide 'proskill-verdicts)
;;; proskill-verdicts.el ends here
