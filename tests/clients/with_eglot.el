;;; A conversation with eglot:  emacs --batch -q -l tests/clients/with_eglot.el  -*- lexical-binding: t -*-
;; Emacs 29 has eglot; before, it is the package elpa-eglot of Debian, or eglot of GNU ELPA.
(require 'package)
(package-initialize)
;; `-q' leaves out the packages of the system, too.
(dolist (folder (file-expand-wildcards "/usr/share/emacs/site-lisp/elpa/*"))
  (add-to-list 'load-path folder))
(require 'eglot)
(require 'flymake)
(require 'xref)

(define-derived-mode hedgerow-mode prog-mode "hedgerow"
  (setq-local comment-start "// "))
(add-to-list 'auto-mode-alist '("\\.hedge\\'" . hedgerow-mode))
(add-to-list 'eglot-server-programs
             `(hedgerow-mode . (,(or (getenv "HEDGEROW") "hedgerow") "lsp")))
(setq eglot-sync-connect t eglot-autoshutdown nil eglot-confirm-server-initiated-edits nil)

(defun say (what value) (princ (format "%s: %s\n" what value)))
(defun fail (why) (say "FAILED" why) (kill-emacs 1))
(defun wait (what condition)
  ;; Changes are sent when Emacs is idle, which it never is in a batch.
  (eglot--signal-textDocument/didChange)
  (let ((until (+ (float-time) 10)))
    (while (and (not (funcall condition)) (< (float-time) until))
      (accept-process-output nil 0.05))
    (unless (funcall condition) (fail (concat "waited in vain for " what)))))

(let* ((folder (make-temp-file "hedgerow" t))
       (path (expand-file-name "flip.hedge" folder)))
  (with-temp-file path
    (insert "/// Rotates an edge between two triangles by one corner.
op flip(e: edge) {
  before {
    face f0: v0 -a-> v1 -b-> v2 -c-> v0
    face f1: v1 -d-> v0 -g-> v3 -h-> v1
    edge e: a | d
  }
  after {
    face f0: v3 -a-> v2 -c-> v0 -g-> v3
    face f1: v2 -d-> v3 -h-> v1 -b-> v2
  }
}
"))
  (find-file path)
  (hedgerow-mode)
  (apply #'eglot (eglot--guess-contact))
  (unless (eglot-current-server) (fail "no server"))
  (say "server" (plist-get (eglot--server-info (eglot-current-server)) :name))
  (flymake-mode 1)
  (wait "the squiggle" (lambda () (flymake-start) (= 1 (length (flymake-diagnostics)))))
  (let ((told (car (flymake-diagnostics))))
    (say "squiggle" (format "%d %s" (line-number-at-pos (flymake-diagnostic-beg told))
                            (car (split-string (flymake-diagnostic-text told) "\n"))))
    (goto-char (flymake-diagnostic-beg told)))
  ;; The preferred quick fix, as `eglot-code-action-quickfix' applies it.
  (let* ((actions (append (jsonrpc-request
                           (eglot-current-server) :textDocument/codeAction
                           (list :textDocument (eglot--TextDocumentIdentifier)
                                 :range (list :start (eglot--pos-to-lsp-position)
                                              :end (eglot--pos-to-lsp-position))
                                 :context (list :diagnostics [])))
                          nil))
         (preferred (seq-find (lambda (action) (eq t (plist-get action :isPreferred))) actions)))
    (say "actions" (mapconcat (lambda (action) (plist-get action :title)) actions "; "))
    (unless preferred (fail "no fix"))
    (eglot--apply-workspace-edit (plist-get preferred :edit)))
  (wait "the fix" (lambda () (flymake-start) (null (flymake-diagnostics))))
  (say "mended" (buffer-string))
  (goto-char (point-min))
  (search-forward "op fl")
  (let ((hover (jsonrpc-request (eglot-current-server) :textDocument/hover
                                (eglot--TextDocumentPositionParams))))
    (say "hover" (plist-get (plist-get hover :contents) :value))
    (unless (string-match-p "proved" (plist-get (plist-get hover :contents) :value))
      (fail "the hover")))
  ;; `M-.' on a name of `after' leads into `before'.
  (search-forward "after {")
  (search-forward "-c")
  (backward-char 1)
  (let ((places (xref-backend-definitions 'eglot (xref-backend-identifier-at-point 'eglot))))
    (say "definition" (xref-location-line (xref-item-location (car places)))))
  (eglot-rename "spoke")
  (say "renamed" (buffer-string))
  (unless (= 2 (count-matches "-spoke->" (point-min) (point-max))) (fail "the rename"))
  (eglot-format-buffer)
  (eglot-shutdown (eglot-current-server))
  (say "done" "all is well")
  (kill-emacs 0))
