//! Lessons: a short text, a program with a gap, and a check of how the gap is filled.
//!
//! A lesson is a file of [`texts`](self): a title, the mesh to try it on, the text in Markdown, and
//! the complete program. What is left out at first is between `//{` and `//}`; lines that begin
//! with `//|` are shown instead of it. After that come the mistakes of hand-written operations that
//! the lesson is about, twenty-four in all lessons together: a title, a text, and a diff of the
//! solution, as lines with `-`, `+` or a space before them; or several, of which each is the mistake.
//!
//! A text solves a lesson if it does what the lesson's own program does: every operation is proved,
//! applies and refuses at the same elements of small meshes, and leaves the same mesh; every script
//! does the same to them.

mod judge;

pub use judge::{Rejection, judge, judge_file};

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Lesson {
    /// Its number and a word, `03_flip`, to name it by.
    pub name: &'static str,
    pub title: &'static str,
    /// The name of the mesh to try it on.
    pub mesh: &'static str,
    /// Its text, in Markdown.
    pub text: &'static str,
    /// The program with its gap.
    pub program: String,
    /// The complete program.
    pub(crate) solution: String,
    /// The common mistakes that it is about.
    pub mistakes: Vec<Mistake>,
}

/// A mistake that is common in operations written by hand.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mistake {
    /// The mistake in a few words.
    pub title: &'static str,
    /// Its consequences, in Markdown.
    pub text: &'static str,
    /// The solution of the lesson with the mistake in it.
    pub program: String,
    /// The same in other ways.
    pub(crate) others: Vec<String>,
}

macro_rules! lessons {
    ($($name:literal),* $(,)?) => {
        &[$(($name, include_str!(concat!("texts/", $name, ".md")))),*]
    };
}

const LESSONS: &[(&str, &str)] = lessons![
    "01_halfedge",
    "02_twin",
    "03_flip",
    "04_outside",
    "05_guard",
    "06_new",
    "07_border",
    "08_fan",
    "09_link",
    "10_family",
    "11_script",
    "12_remesh",
    "13_drain",
    "14_attribute",
    "15_steps",
];

/// All lessons, in order.
pub fn all() -> impl Iterator<Item = Lesson> {
    LESSONS.iter().filter_map(|&(name, text)| Lesson::read(name, text))
}

/// The lesson of a name, or of its number.
pub fn lesson(name: &str) -> Option<Lesson> {
    let number = |lesson: &Lesson| lesson.name.split('_').next().and_then(|it| it.parse().ok());
    let wanted: Option<u32> = name.parse().ok();
    let is_meant =
        |lesson: &Lesson| lesson.name == name || wanted.is_some() && number(lesson) == wanted;
    all().find(is_meant)
}

impl Lesson {
    fn read(name: &'static str, file: &'static str) -> Option<Self> {
        let (title, rest) = file.strip_prefix("# ")?.split_once('\n')?;
        let (mesh, rest) = rest.strip_prefix("mesh: ")?.split_once('\n')?;
        let (text, program) = rest.split_once("```hedge\n")?;
        let (program, mistakes) = program.split_once("```\n")?;
        let solution = version(program, true);
        let mistakes = mistakes.split("\n## ").skip(1);
        Some(Self {
            name,
            title,
            mesh,
            text: text.trim(),
            program: version(program, false),
            mistakes: mistakes.map(|file| Mistake::read(file, &solution)).collect::<Option<_>>()?,
            solution,
        })
    }

    pub fn number(&self) -> u32 {
        self.name.split('_').next().and_then(|number| number.parse().ok()).unwrap_or(0)
    }

    /// The program with its gap filled.
    pub fn solution(&self) -> &str {
        &self.solution
    }
}

impl Mistake {
    fn read(file: &'static str, solution: &str) -> Option<Self> {
        let (title, rest) = file.split_once('\n')?;
        let mut parts = rest.split("```diff\n");
        let text = parts.next()?.trim();
        let changed = |part: &str| {
            let (change, _) = part.split_once("```")?;
            let lines = |without: char| {
                let kept = change.lines().filter(|line| !line.starts_with(without));
                kept.map(|line| format!("{}\n", line.get(1..).unwrap_or(""))).collect::<String>()
            };
            let (before, after) = (lines('+'), lines('-'));
            let program = solution.replacen(&before, &after, 1);
            (program != solution).then_some(program)
        };
        let program = changed(parts.next()?)?;
        let others = parts.map(changed).collect::<Option<_>>()?;
        Some(Self { title, text, program, others })
    }

    /// The solution with the mistake in it, in every way.
    fn programs(&self) -> impl Iterator<Item = &String> {
        std::iter::once(&self.program).chain(&self.others)
    }
}

/// A program with its gap, or solved.
fn version(program: &str, is_solved: bool) -> String {
    let mut text = String::new();
    let mut within = false;
    for line in program.lines() {
        let shown = match line {
            "//{" | "//}" => {
                within = line == "//{";
                None
            }
            line => match (line.strip_prefix("//|"), within) {
                (Some(instead), _) => (!is_solved).then_some(instead),
                (None, true) => is_solved.then_some(line),
                (None, false) => Some(line),
            },
        };
        if let Some(line) = shown {
            text.push_str(line);
            text.push('\n');
        }
    }
    text
}
