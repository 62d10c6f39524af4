//! `hedgerow learn`

use std::path::Path;

use super::arguments::LearnArguments;
use super::failure::Failure;
use super::files;
use super::output::{eprint_line, print_line, prose, table};
use crate::analysis::read_program;
use crate::lessons::{self, Lesson, judge_file};

/// Lists the lessons, shows one, or checks a solution.
pub(super) fn learn(arguments: &LearnArguments) -> Result<(), Failure> {
    let Some(name) = &arguments.lesson else {
        let rows = lessons::all().map(|it| vec![it.number().to_string(), it.title.to_owned()]);
        let rows: Vec<_> = rows.collect();
        print_line(&table(&rows, &[true, false]));
        print_line(
            "\n`hedgerow learn 1` begins; `hedgerow play` shows the same lessons in a browser",
        );
        return Ok(());
    };
    let lesson = lessons::lesson(name).ok_or_else(|| {
        Failure::usage(format!("there is no lesson `{name}`; `hedgerow learn` lists them"))
    })?;
    match &arguments.file {
        None => show(&lesson),
        Some(file) if arguments.start => start(&lesson, file),
        Some(file) => check(&lesson, file),
    }
}

fn show(lesson: &Lesson) -> Result<(), Failure> {
    let number = lesson.number();
    let text = prose(lesson.text);
    print_line(&format!("{number}. {}\n\n{text}\n\n{}", lesson.title, lesson.program));
    for mistake in &lesson.mistakes {
        let text = prose(mistake.text);
        print_line(&format!("A common mistake: {}\n\n{text}\n", mistake.title));
    }
    print_line(&prose(&format!(
        "`hedgerow learn {number} lesson.hedge --start` writes this program to a file; edit it, \
         and\n`hedgerow learn {number} lesson.hedge` says whether the lesson is solved. `hedgerow plan \
         lesson.hedge`\nshows the plan of an operation, `hedgerow play lesson.hedge` the view to click in"
    )));
    Ok(())
}

/// Writes the program of a lesson to a file that does not exist yet.
fn start(lesson: &Lesson, file: &Path) -> Result<(), Failure> {
    if file.exists() {
        let shown = file.display();
        return Err(Failure::usage(format!("`{shown}` is there already; give another name")));
    }
    files::write(file, lesson.program.as_bytes())?;
    eprint_line(&format!("written: {}", file.display()));
    Ok(())
}

fn check(lesson: &Lesson, file: &Path) -> Result<(), Failure> {
    let text = read_program(file)
        .map_err(|why| Failure::usage(format!("cannot read `{}`: {why}", file.display())))?;
    match judge_file(lesson, &file.display().to_string(), &text) {
        Ok(()) => {
            let next = lessons::lesson(&(lesson.number() + 1).to_string());
            let next = next.map(|next| format!("; next: {}. {}", next.number(), next.title));
            print_line(&format!("solved: {}{}", lesson.title, next.unwrap_or_default()));
            Ok(())
        }
        Err(why) => {
            eprint_line(why.to_string().trim_end());
            eprint_line(&format!("not solved yet: {}", lesson.title));
            Err(Failure::NotProved)
        }
    }
}
