;;; emacs.el --- The major mode of ../emacs with eglot, if it is there -*- lexical-binding: t -*-

;;; Commentary:

;; HEDGEROW=… emacs --batch -q -l editors/tests/emacs.el

;;; Code:

(defvar failed nil)
(defun holds (what fine)
  "Say whether WHAT holds, as FINE says."
  (unless fine (setq failed t))
  (message "%s %s" (if fine "ok " "NOT") what))

(let ((folder (file-name-directory load-file-name)))
  (add-to-list 'load-path (expand-file-name "../emacs" folder)))
(require 'hedgerow-mode)
(let ((file (make-temp-file "swap" nil ".hedge"
                            "// a \"comment\nop swap(e:edge) {\nbefore { edge e: a' | d }\nafter { keep e }\n}\n")))
  (find-file file)
  (holds "the file is known" (eq major-mode 'hedgerow-mode))
  (font-lock-ensure)
  (goto-char (point-min))
  (search-forward "before")
  (holds "keywords are coloured"
         (eq (get-text-property (1- (point)) 'face) 'font-lock-keyword-face))
  (search-forward "a'")
  (holds "a prime begins no text" (null (get-text-property (1- (point)) 'face)))
  (indent-region (point-min) (point-max))
  (goto-char (point-min))
  (holds "lines are indented" (search-forward "\n  before {" nil t))
  (when (require 'eglot nil t)
    (setq eglot-sync-connect 20)
    (apply #'eglot (eglot--guess-contact))
    (holds "the server is there" (eglot-current-server))
    (dotimes (_ 20) (accept-process-output nil 0.1))
    (eglot-format-buffer)
    (goto-char (point-min))
    (holds "the file is formatted" (search-forward "swap(e: edge)" nil t)))
  (set-buffer-modified-p nil)
  (delete-file file))
(kill-emacs (if failed 1 0))

;;; emacs.el ends here
