//! `parsim2d man`: the help as manual pages, one for the program and one for each subcommand.

use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Args, Command};
use clap_mangen::Man;

use super::failure::Failure;
use crate::output::recorder::make_folder;
use crate::output::replace::replace;

pub(super) const EXAMPLES: &str = "\
Examples:
  parsim2d man > parsim2d.1                all pages in one file, to read: man -l parsim2d.1
  parsim2d man --out-dir man1              a page for each subcommand: man -l man1/parsim2d-plot.1

In ~/.local/share/man/man1, `man parsim2d` finds them.";

#[derive(Args)]
pub(super) struct ManArguments {
    /// Folder for a file for each page; it is made if it is not there [default: all pages on stdout]
    #[arg(long, value_name = "DIR")]
    out_dir: Option<PathBuf>,
}

/// Prints or writes the pages of `program`.
pub(super) fn print(arguments: &ManArguments, program: Command) -> Result<ExitCode, Failure> {
    let mut program = program.disable_help_subcommand(true);
    program.build();
    let mut pages = Vec::new();
    gather(&program, "", &mut pages)?;
    let Some(folder) = &arguments.out_dir else {
        for (_, page) in pages {
            io::stdout().write_all(&page)?;
        }
        return Ok(ExitCode::SUCCESS);
    };
    make_folder(folder)?;
    for (name, page) in &pages {
        replace(&folder.join(format!("{name}.1")), |file| file.write_all(page))?;
    }
    let (count, folder) = (pages.len(), folder.display());
    writeln!(io::stdout(), "wrote {count} pages to {folder}")?;
    Ok(ExitCode::SUCCESS)
}

/// The pages of `command` and of all below it, with their names; `above` is the name of the page above.
fn gather(command: &Command, above: &str, pages: &mut Vec<(String, Vec<u8>)>) -> io::Result<()> {
    let name = match above {
        "" => command.get_name().to_owned(),
        above => format!("{above}-{}", command.get_name()),
    };
    pages.push((name.clone(), page(command, &name)?));
    let below = command.get_subcommands().filter(|below| below.get_name() != "help");
    below.into_iter().try_for_each(|below| gather(below, &name, pages))
}

fn page(command: &Command, name: &str) -> io::Result<Vec<u8>> {
    let mut page = Vec::new();
    let man = Man::new(command.clone()).title(name).manual("parsim2d").section("1");
    man.render_title(&mut page)?;
    man.render_name_section(&mut page)?;
    man.render_synopsis_section(&mut page)?;
    man.render_description_section(&mut page)?;
    man.render_options_section(&mut page)?;
    if command.has_subcommands() {
        man.render_subcommands_section(&mut page)?;
    }
    if let Some(text) = command.get_after_help() {
        page.extend(as_it_stands("EXAMPLES", &text.to_string()).as_bytes());
    }
    Ok(page)
}

/// A section in the lines of `text`, which the generator would fill.
fn as_it_stands(heading: &str, text: &str) -> String {
    let mut section = format!(".SH {heading}\n.nf\n");
    for line in text.lines().filter(|line| *line != "Examples:") {
        let escaped = line.replace('\\', "\\e").replace('-', "\\-").replace('\'', "\\(aq");
        if escaped.starts_with('.') {
            section.push_str("\\&"); // or it would be a command
        }
        section.push_str(&escaped);
        section.push('\n');
    }
    section.push_str(".fi\n");
    section
}
