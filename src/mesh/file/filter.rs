//! The text that `tobj` gets to see.
//!
//! The parser re-indexes the vertices of every group by first use, drops those that no
//! face uses, cannot tell lines, knows no continued lines, and keeps a missing texture
//! index by making one up. So it is given one statement at a time, vertices and faces
//! only, the faces with their vertex indices alone. After each run of vertices stands
//! a *roll*, a polygon that names them in order: from the rolls one reads off where the
//! parser has put which vertex. Everything else is kept here on the way.
//!
//! ```text
//! file                      parser
//! v 0 0 0                   v 0 0 0
//! v 1 0 0 0.5 0.5 0.5       v 1 0 0
//! v 0 1 0                   v 0 1 0
//! g wing
//!                           f 1 2 3          (roll)
//! f 1/1 2/2 \               f 1 2 -1
//!   -1/3
//! ```
//!
//! Since a statement is handed over only when the parser asks for more, the line at
//! hand is the line at fault when it gives up.

use std::io::{self, BufRead, Read, Write};

use super::error::{FileReason, Indexed};
use super::kept::{Kept, MISSING, State, number};
use super::lines::Statements;

/// Rolls are cut after so many vertices, which bounds the length of a line.
const ROLL: usize = 4096;

pub(super) struct Filter<R> {
    statements: Statements<R>,
    out: Vec<u8>,
    given: usize,
    at_end: bool,
    /// The first vertex that no roll has named yet.
    unrolled: usize,
    corners: usize,
    colored: bool,
    highest: [Highest; 3],
    pub(super) failure: Option<(Option<u32>, FileReason)>,
    pub(super) kept: Kept,
    pub(super) vertex_lines: Vec<u32>,
    pub(super) face_lines: Vec<u32>,
    pub(super) colors: Vec<[f64; 3]>,
    /// Which of the faces given to the parser are rolls.
    pub(super) rolls: Vec<usize>,
}

/// The highest index of its kind and the line that has it.
#[derive(Clone, Copy, Default)]
struct Highest {
    index: u64,
    line: u32,
}

impl<R: BufRead> Filter<R> {
    pub(super) fn new(input: R) -> Self {
        Self {
            statements: Statements::new(input),
            out: Vec::new(),
            given: 0,
            at_end: false,
            unrolled: 0,
            corners: 0,
            colored: true,
            highest: [Highest::default(); 3],
            failure: None,
            kept: Kept::default(),
            vertex_lines: Vec::new(),
            face_lines: Vec::new(),
            colors: Vec::new(),
            rolls: Vec::new(),
        }
    }

    /// The line of the statement the parser has seen last.
    pub(super) fn line(&self) -> u32 {
        self.statements.line()
    }

    /// An index that leads out of the file. Known at its end only: a face may name a
    /// vertex that comes later.
    pub(super) fn index_out_of_range(&self) -> Option<(Option<u32>, FileReason)> {
        let have =
            [self.vertex_lines.len(), self.kept.texture.rows.len(), self.kept.normals.rows.len()];
        (0..3).find_map(|i| {
            let Highest { index, line } = self.highest[i];
            let reason =
                || FileReason::NoSuch { what: KINDS[i], index: index as i64, have: have[i] };
            (index > have[i] as u64).then(|| (Some(line), reason()))
        })
    }

    /// Ends the tables that are as long as the corners.
    pub(super) fn finish(&mut self) {
        for table in [&mut self.kept.corner_texture, &mut self.kept.corner_normals] {
            if !table.is_empty() {
                table.resize(self.corners, MISSING);
            }
        }
        if !self.colored {
            self.colors = Vec::new();
        }
    }

    /// Makes the next line for the parser.
    fn refill(&mut self) -> io::Result<()> {
        self.out.clear();
        self.given = 0;
        while self.out.is_empty() && !self.at_end {
            if self.vertex_lines.len() - self.unrolled >= ROLL {
                self.roll();
            } else if !self.advance()? {
                self.at_end = true;
                self.roll();
            } else if let Err(reason) = self.statement() {
                self.failure = Some((Some(self.line()), reason));
                return Err(io::Error::other("refused"));
            }
        }
        Ok(())
    }

    /// Goes to the next statement, keeping the reason if that fails: the parser drops it.
    fn advance(&mut self) -> io::Result<bool> {
        self.statements.advance().map_err(|error| {
            let kind = error.kind();
            self.failure = Some((None, FileReason::Io(error)));
            kind.into()
        })
    }

    /// Names the vertices since the last roll.
    fn roll(&mut self) {
        if self.unrolled == self.vertex_lines.len() {
            return;
        }
        self.rolls.push(self.face_lines.len() + self.rolls.len());
        self.out.push(b'f');
        for number in self.unrolled + 1..=self.vertex_lines.len() {
            write!(self.out, " {number}").expect("a vector takes what is written");
        }
        self.out.push(b'\n');
        self.unrolled = self.vertex_lines.len();
    }

    fn statement(&mut self) -> Result<(), FileReason> {
        let text = self.statements.text().trim_ascii();
        let end = text.iter().position(u8::is_ascii_whitespace).unwrap_or(text.len());
        let (keyword, rest) = text.split_at(end);
        match keyword {
            b"v" => self.vertex(),
            b"f" | b"fo" => self.face(),
            b"vt" => match self.kept.texture.push(words(rest), 1) {
                true => Ok(()),
                false => Err(FileReason::NotNumbers { statement: "vt", needs: "a number or more" }),
            },
            b"vn" => match self.kept.normals.push(words(rest), 3) {
                true => Ok(()),
                false => Err(FileReason::NotNumbers { statement: "vn", needs: "three numbers" }),
            },
            b"mtllib" => {
                let library = rest.trim_ascii();
                if !self.kept.libraries.iter().any(|known| known == library) {
                    self.kept.libraries.push(library.to_vec());
                }
                Ok(())
            }
            _ => {
                let place = State::KEYWORDS.iter().position(|k| k.as_bytes() == keyword);
                match place {
                    Some(place) => {
                        let face = self.face_lines.len() as u32;
                        self.kept.enter_state(face, place, rest.trim_ascii());
                    }
                    None => self.kept.pass_over(keyword),
                }
                Ok(())
            }
        }
    }

    fn vertex(&mut self) -> Result<(), FileReason> {
        let mut words = words(self.statements.text()).skip(1);
        self.out.push(b'v');
        for _ in 0..3 {
            // A weight after the coordinates belongs to curves; it is passed over.
            let needs = FileReason::NotNumbers { statement: "v", needs: "three numbers" };
            let word = words.next().and_then(|word| std::str::from_utf8(word).ok());
            self.out.push(b' ');
            self.out.extend_from_slice(word.ok_or(needs)?.as_bytes());
        }
        self.out.push(b'\n');
        self.vertex_lines.push(self.statements.line());
        if self.colored {
            let mut color = [0.0; 3];
            let mut channels = 0;
            for (channel, value) in color.iter_mut().zip(words.map_while(number)) {
                *channel = value;
                channels += 1;
            }
            self.colored = channels == 3;
            if self.colored {
                self.colors.push(color);
            }
        }
        Ok(())
    }

    fn face(&mut self) -> Result<(), FileReason> {
        if self.unrolled < self.vertex_lines.len() {
            self.roll();
        }
        let line = self.statements.line();
        let have =
            [self.vertex_lines.len(), self.kept.texture.rows.len(), self.kept.normals.rows.len()];
        let first = self.corners;
        self.out.push(b'f');
        for word in words(self.statements.text()).skip(1) {
            let malformed = || FileReason::NotAnIndex { text: lossy(word) };
            let mut places = [MISSING; 3];
            let mut parts = word.split(|&b| b == b'/');
            for (i, part) in parts.by_ref().take(3).enumerate() {
                if part.is_empty() && i > 0 {
                    continue;
                }
                let index = integer(part).ok_or_else(malformed)?;
                let number = resolve(index, KINDS[i], have[i])?;
                if number > self.highest[i].index {
                    self.highest[i] = Highest { index: number, line };
                }
                // What does not fit is out of range and refused at the end.
                places[i] = u32::try_from(number - 1).unwrap_or(MISSING);
                if i == 0 {
                    self.out.push(b' ');
                    self.out.extend_from_slice(part);
                }
            }
            if parts.next().is_some() {
                return Err(malformed());
            }
            keep_corner(&mut self.kept.corner_texture, self.corners, places[1]);
            keep_corner(&mut self.kept.corner_normals, self.corners, places[2]);
            self.corners += 1;
        }
        self.out.push(b'\n');
        self.face_lines.push(line);
        match self.corners - first {
            corners @ 0..=2 => Err(FileReason::FewCorners { corners }),
            _ => Ok(()),
        }
    }
}

const KINDS: [Indexed; 3] = [Indexed::Vertex, Indexed::Texture, Indexed::Normal];

/// The number, from 1, of what an index names: negative ones count back from the last.
fn resolve(index: i64, what: Indexed, have: usize) -> Result<u64, FileReason> {
    match index {
        0 => Err(FileReason::ZeroIndex),
        1.. => Ok(index as u64),
        _ => match (have as u64).checked_sub(index.unsigned_abs()) {
            Some(place) => Ok(place + 1),
            None => Err(FileReason::NoSuch { what, index, have }),
        },
    }
}

/// Notes what a corner has, once any corner has had something.
fn keep_corner(table: &mut Vec<u32>, corner: usize, place: u32) {
    if place != MISSING || !table.is_empty() {
        table.resize(corner, MISSING);
        table.push(place);
    }
}

fn words(text: &[u8]) -> impl Iterator<Item = &[u8]> {
    text.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty())
}

fn integer(word: &[u8]) -> Option<i64> {
    // Almost all indices are a few digits.
    if matches!(word.len(), 1..=18) && word.iter().all(u8::is_ascii_digit) {
        return Some(word.iter().fold(0, |value, &digit| value * 10 + i64::from(digit - b'0')));
    }
    std::str::from_utf8(word).ok()?.parse().ok()
}

/// The start of a word, as text.
fn lossy(word: &[u8]) -> String {
    String::from_utf8_lossy(&word[..word.len().min(40)]).into_owned()
}

impl<R: BufRead> BufRead for Filter<R> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        if self.given == self.out.len() {
            self.refill()?;
        }
        Ok(&self.out[self.given..])
    }

    fn consume(&mut self, amount: usize) {
        self.given += amount;
    }
}

impl<R: BufRead> Read for Filter<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let amount = self.fill_buf()?.read(buffer)?;
        self.consume(amount);
        Ok(amount)
    }
}
