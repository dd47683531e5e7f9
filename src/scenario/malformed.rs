//! What a mistake in a scenario file most likely is, in the words of the person who made it: the parser's own
//! message knows TOML, and not what was meant.

use clap::builder::PossibleValue;

use super::keys::KEYS;
use super::nearest::did_you_mean;
use super::quantity::is_with_unit;
use crate::number::shortest;

/// A sentence for the parser's `message` on line `number` (from 1) of `text`, with the line as it should be;
/// `None` where the parser says it well.
pub(super) fn sentence(message: &str, text: &str, number: usize) -> Option<String> {
    let lines: Vec<&str> = text.lines().collect();
    let line = lines.get(number - 1).copied().unwrap_or_default().trim();
    let message = message.trim_end();
    if message == "duplicate key" {
        return Some(said_twice(&lines[..number], line));
    }
    if let Some(field) = message.strip_prefix("missing field ") {
        return Some(missing(field.trim_matches('`')));
    }
    if line.contains(['“', '”', '‘', '’', '„']) {
        return Some("quotes are straight ones: ' or \"".to_owned());
    }
    if message.contains("unclosed array table") {
        return Some("two brackets on each side: [[disc]], [[population]]".to_owned());
    }
    if message.contains("missing comma between array") || message.contains("unclosed array") {
        return Some("the list does not end: it wants a ] like [0.01, 0.02]".to_owned());
    }
    if message.starts_with("key with no value") {
        return Some(no_equals_sign(line));
    }
    let (key, value) = key_and_value(line)?;
    if let Some(pair) = with_dots(value) {
        return Some(format!("{DOT}: {key} = {pair}"));
    }
    of_kind(message, key, value).or_else(|| of_value(message, key, value))
}

const DOT: &str = "numbers take a dot, not a comma";

/// The pair that was meant by a list with decimal commas, told by the blank behind the other one: `[0, -9,81]`.
fn with_dots(list: &str) -> Option<String> {
    let (x, y) = list.strip_prefix('[')?.strip_suffix(']')?.split_once(", ")?;
    let number = |text: &str| {
        let dotted = text.trim().replacen(',', ".", 1);
        (dotted.parse::<f64>().is_ok() && !dotted.ends_with('.')).then_some(dotted)
    };
    let (x_said, y_said) = (number(x)?, number(y)?);
    (x.contains(',') || y.contains(',')).then(|| format!("[{x_said}, {y_said}]"))
}

/// A list of numbers with units, each of these in quotes; nothing if it is something else.
fn each_quoted(list: &str) -> Option<String> {
    let items = list.strip_prefix('[')?.strip_suffix(']')?.split(',').map(str::trim);
    let quoted = items.map(|item| match item.parse::<f64>() {
        Ok(_) => Some(item.to_owned()),
        Err(_) => is_with_unit(item).then(|| format!("'{item}'")),
    });
    Some(format!("[{}]", quoted.collect::<Option<Vec<_>>>()?.join(", ")))
}

/// The name that was probably meant by `value` among those that `key` takes.
fn nearest_name(key: &str, value: &str) -> Option<String> {
    let flag = KEYS.iter().find(|known| known.name == key)?.arg();
    let names = flag.get_possible_values();
    let names: Vec<&str> = names.iter().map(PossibleValue::get_name).collect();
    did_you_mean(value, &names).filter(|_| !flag.is_require_equals_set()).map(str::to_owned)
}

/// The key and the value of a line, without the remark behind it.
fn key_and_value(line: &str) -> Option<(&str, &str)> {
    let (key, value) = line.split_once('=').filter(|(key, _)| !key.trim().is_empty())?;
    let value = if value.contains(['\'', '"']) { value } else { value.split('#').next()? };
    Some((key.trim(), value.trim()))
}

fn said_twice(until: &[&str], line: &str) -> String {
    let named = |line: &str| {
        let line = line.trim();
        let name = line.split_once('=').map_or(line, |(key, _)| key);
        name.trim_matches(|c: char| c.is_whitespace() || c == '[' || c == ']').to_owned()
    };
    let name = named(line);
    let first = until.iter().position(|line| named(line) == name).map_or(0, |k| k + 1);
    if line.starts_with('[') {
        return format!(
            "[{name}] is there twice, first on line {first}: lists take two brackets, [[{name}]]"
        );
    }
    format!("`{name}` is said twice, first on line {first}: leave one of them")
}

fn missing(field: &str) -> String {
    match field {
        "position" => "each [[disc]] wants its centre: position = [0.01, 0.02]".to_owned(),
        "n" => "each [[population]] wants its number of discs: n = 100".to_owned(),
        _ => format!("`{field}` is missing"),
    }
}

/// A line without `=` in the right place.
fn no_equals_sign(line: &str) -> String {
    if line.starts_with("//") || line.starts_with([';', '%']) {
        return "remarks begin with #".to_owned();
    }
    let bare = line.trim_start_matches('-');
    let ends = bare.find(|c: char| c == ':' || c.is_whitespace()).unwrap_or(bare.len());
    let (key, rest) = bare.split_at(ends);
    let value = rest.trim_start_matches(|c: char| c == ':' || c.is_whitespace());
    let is_plain = |word: &str| word.chars().all(|c| c.is_alphanumeric() || "_-+.'\"".contains(c));
    match !key.is_empty() && !value.is_empty() && is_plain(key) && is_plain(value) {
        true => format!("a line is KEY = VALUE: {} = {}", key.replace('-', "_"), as_toml(value)),
        false => "a line is KEY = VALUE, for example: radius = 5e-4".to_owned(),
    }
}

/// A value as TOML takes it.
fn as_toml(value: &str) -> String {
    let is_said = value.parse::<f64>().is_ok() || ["true", "false"].contains(&value);
    if is_said || value.starts_with(['\'', '"']) { value.to_owned() } else { format!("'{value}'") }
}

/// A value of the wrong kind, as a string where a number is wanted.
fn of_kind(message: &str, key: &str, value: &str) -> Option<String> {
    let wanted = message.strip_prefix("invalid type: ")?.split("expected ").nth(1)?;
    let bare = value.trim_matches(['\'', '"']);
    match wanted {
        "i64" => Some(match bare.parse::<f64>() {
            Ok(number) if number.fract() == 0.0 && number.abs() < 1e15 => {
                format!("a whole number has no quotes, dot or exponent: {key} = {number:.0}")
            }
            _ => format!("`{key}` takes a whole number, and this is {value}"),
        }),
        "a boolean" => Some(format!("`{key}` takes true or false: {key} = {}", meant(bare)?)),
        "a sequence" if !value.starts_with('{') => {
            Some(format!("two numbers in brackets are wanted, x and y: {key} = [0.01, 0.02]"))
        }
        _ => None,
    }
}

/// The truth value that was meant by a word of another language.
fn meant(word: &str) -> Option<bool> {
    match word.to_ascii_lowercase().as_str() {
        "true" | "yes" | "on" | "1" => Some(true),
        "false" | "no" | "off" | "0" => Some(false),
        _ => None,
    }
}

/// A value that is no TOML.
fn of_value(message: &str, key: &str, value: &str) -> Option<String> {
    if ["invalid type", "unknown", "expected [x, y]"].iter().any(|start| message.starts_with(start))
    {
        return None; // it is TOML
    }
    if value.is_empty() {
        return Some(format!("nothing stands behind `{key} =`"));
    }
    let quotes = |quote| value.matches(quote).count();
    if value.starts_with(['\'', '"']) && (quotes('\'') == 1 || quotes('"') == 1) {
        let bare = value.trim_matches(['\'', '"']);
        return Some(format!("the quote does not end: {key} = '{bare}'"));
    }
    if !value.contains(['\'', '"']) && value.contains([';', '=']) {
        return Some("one KEY = VALUE a line, nothing behind it".to_owned());
    }
    if value.contains(',') {
        return of_commas(message, key, value);
    }
    if value.starts_with(['[', '{', '\'', '"']) {
        return None;
    }
    if is_with_unit(value) {
        return Some(format!("a number with a unit stands in quotes: {key} = '{value}'"));
    }
    if let Some(truth) = meant(value).filter(|_| value.parse::<f64>().is_err()) {
        return Some(format!("write true or false, in small letters: {key} = {truth}"));
    }
    match value.parse::<f64>() {
        Ok(number) => Some(format!(
            "a number has no leading zero, and a digit on each side of its dot: {key} = {}",
            shortest(number)
        )),
        Err(_) if value.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c)) => {
            Some(format!("a number stands alone and is written out, as 5e-4: {value} is none"))
        }
        Err(_) => {
            let name = nearest_name(key, value).unwrap_or(value.to_owned());
            Some(format!("text stands in quotes: {key} = '{name}'"))
        }
    }
}

/// A comma in place of the dot of a number, or between two numbers without brackets.
fn of_commas(message: &str, key: &str, value: &str) -> Option<String> {
    if value.starts_with('[') {
        if let Some(list) = each_quoted(value) {
            return Some(format!("numbers with a unit stand in quotes, each: {key} = {list}"));
        }
        return message.contains("leading zero").then(|| format!("{DOT}: {key} = [0.01, 0.02]"));
    }
    let are_two = value.contains(", ") && value.split(',').all(|x| x.trim().parse::<f64>().is_ok());
    let is_thousands = value.split(',').skip(1).all(|part| part.len() == 3);
    let whole = value.replace(',', "").parse::<i64>().ok().filter(|_| is_thousands);
    match value.replacen(',', ".", 1).parse::<f64>() {
        _ if are_two => Some(format!("two numbers stand in brackets: {key} = [{value}]")),
        Ok(small) if whole.is_some_and(|whole| whole != 0) => Some(format!(
            "{DOT}, and nothing between thousands: {key} = {}, or {}",
            value.replace(',', ""),
            shortest(small)
        )),
        Ok(number) => Some(format!("{DOT}: {key} = {}", shortest(number))),
        Err(_) => Some(DOT.to_owned()),
    }
}
