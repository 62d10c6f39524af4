;;; hedgerow-mode.el --- Operations on halfedge meshes, drawn -*- lexical-binding: t -*-

;; Package-Requires: ((emacs "28.1"))

;;; Commentary:

;; Colours, comments and indentation of hedgerow programs; eglot starts `hedgerow lsp'.

;;; Code:

(defgroup hedgerow nil "Operations on halfedge meshes, drawn." :group 'languages)

(defcustom hedgerow-program (or (getenv "HEDGEROW") "hedgerow")
  "The program hedgerow."
  :type 'string)

(defconst hedgerow-keywords
  '("use" "private" "attr" "fn" "op" "script" "test" "keeps" "rule" "before" "require" "guard"
    "alias" "after" "steps" "face" "hole" "loop" "edge" "vertex" "each" "new" "keep" "erase" "let"
    "var" "if" "else" "repeat" "parallel" "for" "in" "where" "while" "drain" "by" "update" "must"
    "can" "why" "print" "assert" "return" "break" "continue" "and" "or" "not" "div" "mod" "true"
    "false"))

(defvar hedgerow-mode-syntax-table
  (let ((table (make-syntax-table)))
    (modify-syntax-entry ?/ ". 12" table)
    (modify-syntax-entry ?\n ">" table)
    (modify-syntax-entry ?_ "w" table)
    (modify-syntax-entry ?' "w" table)
    (modify-syntax-entry ?\" "\"" table)
    (dolist (sign '(?+ ?- ?* ?< ?> ?= ?|)) (modify-syntax-entry sign "." table))
    table))

(defvar hedgerow-font-lock
  `(("\\_<\\(?:op\\|fn\\|script\\|rule\\)\\s-+\\(\\w+\\)" 1 font-lock-function-name-face)
    ("\\.\\s-*\\(\\w+\\)" 1 font-lock-variable-name-face)
    ("-\\(\\w+\\(?:\\[[^]\n]*\\]\\)?\\)->" 1 font-lock-constant-face)
    ("=\\(\\w+\\(?:\\[[^]\n]*\\]\\)?\\)=>" 1 font-lock-constant-face)
    (,(regexp-opt hedgerow-keywords 'words) . font-lock-keyword-face)))

(defun hedgerow-indent-line ()
  "Indent the line by the braces around it."
  (interactive)
  (let* ((depth (save-excursion
                  (back-to-indentation)
                  (- (car (syntax-ppss)) (if (looking-at "[})]") 1 0))))
         (behind (- (point) (save-excursion (back-to-indentation) (point)))))
    (indent-line-to (* 2 (max 0 depth)))
    (when (> behind 0) (forward-char behind))))

;;;###autoload
(define-derived-mode hedgerow-mode prog-mode "hedgerow"
  "Operations on halfedge meshes, drawn before and after."
  (setq-local comment-start "// "
              comment-end ""
              indent-tabs-mode nil
              font-lock-defaults '(hedgerow-font-lock)
              indent-line-function #'hedgerow-indent-line))

;;;###autoload
(add-to-list 'auto-mode-alist '("\\.hedge\\'" . hedgerow-mode))

(with-eval-after-load 'eglot
  (add-to-list 'eglot-server-programs
               `(hedgerow-mode . ,(lambda (&rest _) (list hedgerow-program "lsp")))))

(provide 'hedgerow-mode)

;;; hedgerow-mode.el ends here
