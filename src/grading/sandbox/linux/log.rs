//! What a submission prints: read to the end, kept up to a limit, and made harmless.

use std::fs::File;
use std::io::Read;

/// The beginning and the end of what was printed.
#[derive(Default)]
pub(super) struct Log {
    head: Vec<u8>,
    tail: Vec<u8>,
    left_out: u64,
}

impl Log {
    /// All that comes out of `pipe`, of which `limit` bytes are kept.
    pub fn of(mut pipe: File, limit: usize) -> Self {
        let mut log = Self::default();
        let mut buffer = vec![0; 64 << 10];
        while let Ok(count @ 1..) = pipe.read(&mut buffer) {
            log.take(&buffer[..count], limit / 2);
        }
        log
    }

    fn take(&mut self, mut bytes: &[u8], half: usize) {
        let room = half.saturating_sub(self.head.len()).min(bytes.len());
        self.head.extend_from_slice(&bytes[..room]);
        bytes = &bytes[room..];
        self.tail.extend_from_slice(bytes);
        let too_many = self.tail.len().saturating_sub(half);
        self.left_out += too_many as u64;
        self.tail.drain(..too_many);
    }

    /// As text that no terminal obeys.
    pub fn text(&self) -> String {
        if self.left_out == 0 {
            return harmless(&[&self.head[..], &self.tail].concat());
        }
        let (head, tail) = (harmless(&self.head), harmless(&self.tail));
        format!("{head}\n[{} bytes left out]\n{tail}", self.left_out)
    }
}

/// `bytes` as text, without what terminals take for commands and what turns the direction of text.
fn harmless(bytes: &[u8]) -> String {
    let mut text = String::with_capacity(bytes.len());
    let decoded = String::from_utf8_lossy(bytes);
    let mut characters = decoded.chars().peekable();
    while let Some(c) = characters.next() {
        match c {
            '\u{1b}' if characters.peek() == Some(&'[') => {
                // A sequence ends with a letter or its like; it is left out as a whole.
                characters.next();
                while characters.next_if(|&c| matches!(c, ' '..='?')).is_some() {}
                characters.next_if(|&c| matches!(c, '@'..='~'));
            }
            '\n' | '\t' => text.push(c),
            '\r' if characters.peek() == Some(&'\n') => {}
            c if c.is_control() => {}
            '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' => {}
            c => text.push(c),
        }
    }
    text
}
