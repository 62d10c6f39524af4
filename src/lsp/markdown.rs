//! Markdown that quotes untrusted text.
//!
//! A doc comment may come from a file by someone else, and a client may follow a link, load an
//! image or draw HTML. So of its Markdown only what arranges text is kept: paragraphs, lists,
//! headings, emphasis, code. Brackets, angle brackets and addresses are escaped wherever a client
//! would look for a link, an image or a tag. What is code is decided here, line by line, and
//! written such that no client can interpret it otherwise: a backtick that opens no code on its own
//! line is escaped, too.

/// Lines of a doc comment, without links, images and HTML.
pub fn quoted(lines: &[String]) -> Vec<String> {
    let mut fence = None;
    let mut quoted = Vec::new();
    for line in lines {
        // A carriage return alone ends a line of Markdown.
        let line = line.replace('\r', " ");
        let start = line.trim_start();
        let ticks = start.len() - start.trim_start_matches('`').len();
        match fence {
            Some(open) if ticks >= open && start.trim_end().len() == ticks => {
                // At the margin it is in no list and no quotation.
                quoted.push("`".repeat(open));
                fence = None;
            }
            Some(_) => quoted.push(line),
            None if ticks >= 3 && !start[ticks..].contains('`') => {
                let word = start[ticks..].chars().filter(char::is_ascii_alphanumeric);
                quoted.push("`".repeat(ticks) + &word.collect::<String>());
                fence = Some(ticks);
            }
            None => quoted.push(prose(&line)),
        }
    }
    // An open fence would swallow what follows the comment.
    quoted.extend(fence.map(|open| "`".repeat(open)));
    quoted
}

/// A line outside of fences: all is escaped but code that begins and ends in it.
pub fn prose(line: &str) -> String {
    // A line of dashes would make the previous line the head of a table, whose bars take precedence
    // over code.
    let is_rule = line.contains('-') && line.chars().all(|letter| " :-|\t".contains(letter));
    if is_rule {
        return format!("\\{}", line.trim_start());
    }
    let mut out = String::with_capacity(line.len());
    let mut rest = line;
    while let Some(letter) = rest.chars().next() {
        let ticks = rest.len() - rest.trim_start_matches('`').len();
        let mark = &rest[..ticks];
        if ticks == 0 {
            // Addresses are links for some clients, without any brackets.
            let is_address = match letter {
                ':' => rest.starts_with("://"),
                '.' => {
                    let before = out.get(out.len().saturating_sub(3)..);
                    before.is_some_and(|word| word.eq_ignore_ascii_case("www"))
                }
                letter => letter == '@',
            };
            if is_address || matches!(letter, '\\' | '[' | '<' | '&' | '~') {
                out.push('\\');
            }
            out.push(letter);
            rest = &rest[letter.len_utf8()..];
            continue;
        }
        match end_of_code(&rest[ticks..], mark) {
            Some(end) => {
                let whole = ticks + end;
                out.push_str(&rest[..whole]);
                rest = &rest[whole..];
            }
            None => {
                out.push_str(&"\\`".repeat(ticks));
                rest = &rest[ticks..];
            }
        }
    }
    out
}

/// The end of the code that `mark` begins: after the next run of exactly as many backticks.
fn end_of_code(text: &str, mark: &str) -> Option<usize> {
    let mut at = 0;
    while let Some(start) = text[at..].find('`') {
        let run = &text[at + start..];
        let length = run.len() - run.trim_start_matches('`').len();
        at += start + length;
        if length == mark.len() {
            return Some(at);
        }
    }
    None
}

/// A block of code, in a fence that its text cannot end.
pub fn fenced(word: &str, text: &str) -> String {
    let text = text.trim_end();
    let longest = text.split(|letter| letter != '`').map(str::len).max().unwrap_or(0);
    let fence = "`".repeat((longest + 1).max(3));
    format!("{fence}{word}\n{text}\n{fence}\n")
}
