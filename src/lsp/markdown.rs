//! Markdown that quotes what others wrote.
//!
//! A doc comment may come from a file that somebody else wrote, and a client may follow a link,
//! load an image or draw HTML. So of its Markdown only what arranges text is kept: paragraphs,
//! lists, headings, emphasis, code. Brackets and angle brackets are escaped wherever a client
//! would look for a link, an image or a tag. What is code is decided here, line by line, and
//! written such that no client can see it otherwise: a backtick that opens no code on its own
//! line is escaped, too.

/// Lines of a doc comment, without links, images and HTML.
pub(super) fn quoted(lines: &[String]) -> Vec<String> {
    let mut fence = None;
    let mut quoted = Vec::new();
    for line in lines {
        // A carriage return alone ends a line of Markdown.
        let line = line.replace('\r', " ");
        let start = line.trim_start();
        let ticks = start.len() - start.trim_start_matches('`').len();
        match fence {
            Some(open) if ticks >= open && start.trim_end().len() == ticks => {
                // At the margin no list and no quotation is around it.
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
    // What is not closed would swallow what comes behind the comment.
    quoted.extend(fence.map(|open| "`".repeat(open)));
    quoted
}

/// A line outside of fences: all is escaped but code that begins and ends in it.
fn prose(line: &str) -> String {
    // A line of dashes would make a table of the line before, whose bars go before code.
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
            if matches!(letter, '\\' | '[' | '<' | '&' | '~') {
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

/// Where code ends that `mark` begins: behind the next run of just as many backticks.
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
pub(super) fn fenced(word: &str, text: &str) -> String {
    let text = text.trim_end();
    let longest = text.split(|letter| letter != '`').map(str::len).max().unwrap_or(0);
    let fence = "`".repeat((longest + 1).max(3));
    format!("{fence}{word}\n{text}\n{fence}\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_arranges_text_is_left() {
        for (told, wanted) in [
            ("see [it](command:x)", "see \\[it](command:x)"),
            ("![p](https://x/y.png) <img src=x>", "!\\[p](https://x/y.png) \\<img src=x>"),
            ("*so* `v[i]` and ``a`b[0]``", "*so* `v[i]` and ``a`b[0]``"),
            ("` [x](command:x)", "\\` \\[x](command:x)"),
            ("`` [x](command:x) `", "\\`\\` \\[x](command:x) \\`"),
            ("\\`[x](command:x)`", "\\\\`[x](command:x)`"),
            ("| --- | --- |", "\\| --- | --- |"),
            ("- an item, a -> b", "- an item, a -> b"),
        ] {
            assert_eq!(prose(told), wanted);
        }
    }

    #[test]
    fn fences_end_where_every_client_ends_them() {
        let lines = |text: &str| text.split('\n').map(str::to_owned).collect::<Vec<_>>();
        let same = "a\n\n```text\n .-[x]-.\n```\nb";
        assert_eq!(quoted(&lines(same)), lines(same));
        // In a list the fence would end with the list.
        let listed = "- a\n  ```\n[x](command:x)";
        assert_eq!(quoted(&lines(listed)), lines("- a\n```\n[x](command:x)\n```"));
        let open = "```\n````\n[x](command:x)";
        assert_eq!(quoted(&lines(open)), lines("```\n```\n\\[x](command:x)"));
        let returned = "```\na\r```\r[x](command:x)";
        assert_eq!(quoted(&lines(returned)), lines("```\na ``` [x](command:x)\n```"));
        assert_eq!(fenced("x", "a ```` b"), "`````x\na ```` b\n`````\n");
    }
}
