//! Which file of `src/` imports which: read from the sources, as far as paths tell.
//!
//! The rule. Every file is a module. A path (`use` or in the code) that begins with `crate`, `self`, `super`, a child
//! module or an imported name is followed segment by segment, through what a module re-exports, to the file
//! that *defines* what it names; the file in which the path stands imports that file. So `mod child;` imports
//! nothing, nor does a `pub use` of something in a child: who asks the parent for that asks the child. But
//! a child that uses what its parent's own file defines imports the parent. Methods, fields and what stands behind
//! `#[cfg(test)]` are not followed.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// The path of a module: `["output", "frames"]`.
type Module = Vec<String>;

/// What one file says of others.
#[derive(Default)]
struct Source {
    /// Names by which others are known in it: what is imported, and what is handed on (`pub use`).
    names: Vec<(String, Vec<String>)>,
    /// Names handed on alone.
    handed_on: BTreeSet<String>,
    /// All other paths.
    paths: Vec<Vec<String>>,
}

/// The files of a crate, by module.
pub struct Sources(BTreeMap<Module, Source>);

impl Sources {
    /// Those below `folder`, `lib.rs` being the root; `main.rs` is another crate.
    pub fn below(folder: &Path) -> Self {
        let mut sources = BTreeMap::new();
        let mut waiting = vec![folder.to_owned()];
        while let Some(place) = waiting.pop() {
            for path in fs::read_dir(place).unwrap().map(|entry| entry.unwrap().path()) {
                let inside = path.strip_prefix(folder).unwrap().with_extension("");
                let module = inside.iter().map(|part| part.to_str().unwrap().to_owned());
                let mut module: Module = module.collect();
                if path.is_dir() {
                    waiting.push(path);
                } else if path.extension().is_some_and(|end| end == "rs") && module != ["main"] {
                    module.retain(|name| name != "lib");
                    sources.insert(module, Source::of(&fs::read_to_string(&path).unwrap()));
                }
            }
        }
        Self(sources)
    }

    /// Who imports whom.
    pub fn imports(&self) -> BTreeMap<Module, BTreeSet<Module>> {
        let imports = self.0.iter().map(|(module, source)| {
            let is_import = |(name, path): &&(String, Vec<String>)| {
                !source.handed_on.contains(name) || !self.is_below(module, path)
            };
            let named = source.names.iter().filter(is_import).map(|(_, path)| path);
            let targets =
                named.chain(&source.paths).flat_map(|path| self.files_of(module, path, 9));
            (module.clone(), targets.filter(|target| target != module).collect())
        });
        imports.collect()
    }

    /// Whether `path`, as it stands in `module`, leads into a child of it.
    fn is_below(&self, module: &Module, path: &[String]) -> bool {
        let child = path.iter().find(|segment| *segment != "self");
        child.is_some_and(|child| {
            self.0.contains_key(&[&module[..], std::slice::from_ref(child)].concat())
        })
    }

    /// The files that define what `path` names where it stands in `module` (two, if the machine decides).
    fn files_of(&self, module: &Module, path: &[String], hops: usize) -> Vec<Module> {
        let (mut at, mut rest) = match path[0].as_str() {
            "crate" => (Vec::new(), &path[1..]),
            "self" | "super" => (module.clone(), path),
            first if self.is_below(module, path) => {
                ([&module[..], &[first.to_owned()]].concat(), &path[1..])
            }
            first => return self.through(module, first, &path[1..], hops),
        };
        while let Some(segment) = rest.first() {
            if segment == "super" {
                at.pop();
            } else if segment != "self" && self.is_below(&at, rest) {
                at.push(segment.clone());
            } else if segment != "self" {
                let further = self.through(&at, segment, &rest[1..], hops);
                return if further.is_empty() { vec![at] } else { further };
            }
            rest = &rest[1..];
        }
        vec![at]
    }

    /// The files of `name::rest`, if `module` knows `name` from elsewhere.
    fn through(&self, module: &Module, name: &str, rest: &[String], hops: usize) -> Vec<Module> {
        let Some(hops) = hops.checked_sub(1) else { return Vec::new() };
        let known =
            self.0[module].names.iter().filter(|(known, path)| known == name && path[0] != name);
        known.flat_map(|(_, path)| self.files_of(module, &[path, rest].concat(), hops)).collect()
    }
}

impl Source {
    fn of(text: &str) -> Self {
        let mut source = Self::default();
        let code = code_of(text.split("#[cfg(test)]").next().unwrap());
        let mut words = words_of(&code).into_iter().peekable();
        let mut is_public = false;
        while let Some(word) = words.next() {
            match word.as_str() {
                "use" => {
                    let tree: Vec<String> = words.by_ref().take_while(|word| word != ";").collect();
                    for (name, path) in leaves(&tree) {
                        source.handed_on.extend(is_public.then(|| name.clone()));
                        source.names.push((name, path));
                    }
                }
                // Who may see it is no import.
                "in" if is_public => while words.next_if(|word| word != ")").is_some() {},
                "::" | "." => {
                    // Of `a::b` only `a` begins a path; what follows a turbofish or a type does not.
                    while words.next_if(|word| word == "::" || is_name(word)).is_some() {}
                }
                first if is_name(first) => {
                    let mut path = vec![word.clone()];
                    while words.next_if(|word| word == "::").is_some() {
                        path.extend(words.next_if(|word| is_name(word)));
                    }
                    if path.len() > 1 {
                        source.paths.push(path);
                    }
                }
                _ => {}
            }
            is_public = matches!(word.as_str(), "pub")
                || is_public && matches!(word.as_str(), "(" | ")" | "in" | "crate" | "super");
        }
        source
    }
}

/// The names and paths of a `use`: `a::{b, c as d}` has b: a::b and d: a::c.
fn leaves(tree: &[String]) -> Vec<(String, Vec<String>)> {
    let Some(open) = tree.iter().position(|word| word == "{") else {
        let mut names: Vec<_> = tree.iter().filter(|word| *word != "::").cloned().collect();
        if names.len() > 1 && names.last().is_some_and(|name| name == "self") {
            names.pop();
        }
        let (path, name) = match names.iter().position(|word| word == "as") {
            Some(k) => (names[..k].to_vec(), names[k + 1].clone()),
            None => (names.clone(), names.last().cloned().unwrap_or_default()),
        };
        return if path.is_empty() { Vec::new() } else { vec![(name, path)] };
    };
    let (before, inside) = (&tree[..open], &tree[open + 1..tree.len() - 1]);
    let mut depth = 0;
    let parts = inside.split(|word| {
        depth += i32::from(word == "{") - i32::from(word == "}");
        word == "," && depth == 0
    });
    parts
        .filter(|part| !part.is_empty())
        .flat_map(|part| leaves(&[before, part].concat()))
        .collect()
}

fn is_name(word: &str) -> bool {
    word.starts_with(|c: char| c.is_alphabetic() || c == '_')
}

/// Names, `::` and single signs.
fn words_of(code: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    let mut characters = code.chars().peekable();
    while let Some(c) = characters.next() {
        let mut word = c.to_string();
        let is_part = |c: &char| c.is_alphanumeric() || *c == '_';
        while is_part(&c) && characters.peek().is_some_and(is_part) {
            word.extend(characters.next());
        }
        if c == ':' && characters.next_if_eq(&':').is_some() {
            word.push(':');
        }
        if !c.is_whitespace() {
            words.push(word);
        }
    }
    words
}

/// The text without comments, strings and characters.
fn code_of(text: &str) -> String {
    let mut code = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let raw = rest.strip_prefix('r').map(|after| after.trim_start_matches('#'));
        let is_inside_a_name = code.ends_with(|c: char| c.is_alphanumeric() || c == '_');
        let skipped = match raw {
            _ if rest.starts_with("//") => rest.find('\n').unwrap_or(rest.len()),
            Some(after) if after.starts_with('"') && !is_inside_a_name => {
                let end = format!("\"{}", "#".repeat(rest.len() - 1 - after.len()));
                rest.len() - after.len() + 1 + after[1..].find(&end).unwrap() + end.len()
            }
            _ if c == '"' => 1 + end_of_string(&rest[1..]),
            _ if c == '\'' => character(rest),
            _ => 0,
        };
        if skipped == 0 {
            code.push(c);
        }
        rest = &rest[skipped.max(c.len_utf8())..];
    }
    code
}

/// Bytes up to and with the quotation mark that ends a string.
fn end_of_string(text: &str) -> usize {
    let mut is_escaped = false;
    let end = text.bytes().position(|byte| {
        let is_end = byte == b'"' && !is_escaped;
        is_escaped = byte == b'\\' && !is_escaped;
        is_end
    });
    end.unwrap() + 1
}

/// Bytes of the character that `text` begins with; none if it is a lifetime.
fn character(text: &str) -> usize {
    let inside = text.chars().nth(1).unwrap();
    match inside {
        '\\' => 4 + text[3..].find('\'').unwrap(),
        _ if text[1 + inside.len_utf8()..].starts_with('\'') => 2 + inside.len_utf8(),
        _ => 0,
    }
}

/// The rings in a graph: each a set of nodes that all reach one another.
pub fn circles<T: Ord + Clone>(graph: &BTreeMap<T, BTreeSet<T>>) -> Vec<BTreeSet<T>> {
    let reached = |start: &T| {
        let mut seen = BTreeSet::new();
        let mut waiting = vec![start.clone()];
        while let Some(node) = waiting.pop() {
            waiting.extend(graph[&node].iter().filter(|next| !seen.contains(*next)).cloned());
            seen.extend(graph[&node].iter().cloned());
        }
        seen
    };
    let all: BTreeMap<&T, BTreeSet<T>> = graph.keys().map(|node| (node, reached(node))).collect();
    let back =
        |node: &T| all[node].iter().filter(|other| all[*other].contains(node)).cloned().collect();
    let circles: BTreeSet<BTreeSet<T>> =
        graph.keys().map(back).filter(|circle: &BTreeSet<T>| !circle.is_empty()).collect();
    circles.into_iter().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn path(text: &str) -> Vec<String> {
        text.split("::").filter(|part| !part.is_empty()).map(str::to_owned).collect()
    }

    fn files_imported_by(text: &str) -> Vec<String> {
        let others = [
            ("", "pub mod a; pub mod b;"),
            ("a", "pub mod c; mod d; pub use self::d::{Deep, Low as Other}; pub fn own() {}"),
            ("a::c", ""),
            ("a::d", "pub struct Deep; pub struct Low;"),
        ];
        let others = others.map(|(module, text)| (path(module), Source::of(text)));
        let sources = Sources(others.into_iter().chain([(path("b"), Source::of(text))]).collect());
        sources.imports()[&path("b")].iter().map(|file| file.join("::")).collect()
    }

    #[test]
    fn an_import_leads_to_the_file_that_defines_what_it_names() {
        for (text, expected) in [
            ("use crate::a::Deep;", vec!["a::d"]),
            ("use crate::a::{self, Other, own};", vec!["a", "a::d"]),
            ("use super::a::c::{X, Y as Z};", vec!["a::c"]),
            ("fn f() -> crate::a::Deep { super::a::c::x::<u8>() }", vec!["a::c", "a::d"]),
            ("use crate::a; fn f() { a::c::g(); }", vec!["a", "a::c"]),
            (
                "// use crate::a;\nconst A: &str = \"crate::a\"; const B: char = '\"'; fn f<'a>() {}",
                vec![],
            ),
            ("pub(in crate::a) use super::a::c::X; pub(in crate::a) fn f() {}", vec!["a::c"]),
            ("use std::fs;\n#[cfg(test)]\nmod tests { use crate::a; }", vec![]),
        ] {
            assert_eq!(files_imported_by(text), expected, "{text}");
        }
    }

    #[test]
    fn circles_are_found_whatever_their_length() {
        let graph = |arrows: &[(u8, u8)]| -> BTreeMap<u8, BTreeSet<u8>> {
            let of = |k| arrows.iter().filter(|arrow| arrow.0 == k).map(|arrow| arrow.1).collect();
            (0..6).map(|k| (k, of(k))).collect()
        };
        assert!(circles(&graph(&[(0, 1), (1, 2), (0, 2), (2, 3)])).is_empty());
        let found = circles(&graph(&[(0, 1), (1, 2), (2, 0), (2, 3), (4, 5), (5, 4)]));
        assert_eq!(found, [BTreeSet::from([0, 1, 2]), BTreeSet::from([4, 5])]);
    }
}
