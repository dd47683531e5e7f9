//! The file of a checkpoint: what it holds comes back with every bit, and nothing damaged is believed.
//!
//! `PARSIM2D_CORRUPTIONS=10000 cargo test --test all checkpoint_file::` tries as many; `make corruption-test`
//! does.

use parsim2d::output::checkpoint::container::{self, Content, Flaw, Section};
use parsim2d::output::checkpoint::{self, Checkpoint, Progress};
use parsim2d::output::growing::Extent;
use parsim2d::output::written::Written;
use parsim2d::scenario::Scenario;
use parsim2d::scenario::settings::Settings;
use parsim2d::simulation::State;
use parsim2d::simulation::state::Array;
use proptest::prelude::*;
use rand::{Rng, RngExt, SeedableRng};
use rand_pcg::Pcg64;

const TEXT: &str = "n = 12\nradius = 4e-4\nseed = 5\nspeed = 0.3\neta = 0.01\ntime = 0.01\n";

fn progress(step: u64, numbers: [f64; 5]) -> Progress {
    let [kinetic, gravitational, elastic, movable, overlap] = numbers;
    Progress {
        version: "0.1.0".to_owned(),
        step,
        time_s: 0.5,
        state_hash: "0123456789abcdef".to_owned(),
        command: vec!["parsim2d".to_owned(), "a 'word' of\ttwo \\ lines".to_owned()],
        kinetic_at_start_J: kinetic,
        gravitational_at_start_J: gravitational,
        elastic_at_start_J: elastic,
        movable_at_start_J: movable,
        supplied_at_start_J: 0.0,
        overlap_at_start: overlap,
        grown_at: Some(64),
        written: Written {
            frame_every: 10,
            frame_at: step,
            energy_every: 3,
            energy_at: step,
            ledger_kinetic_J: kinetic,
            trajectory: Extent { bytes: 1000, crc32: 0xffff_ffff },
            energy: Some(Extent { bytes: 100, crc32: 1 }),
        },
    }
}

/// A checkpoint of a real state, with contacts and a ledger.
fn checkpoint() -> Checkpoint {
    let scenario = Scenario::from_toml(TEXT).unwrap();
    let mut simulation = scenario.build().unwrap();
    simulation.keep_work_ledger();
    (0..500).for_each(|_| simulation.step());
    let arrays = simulation.state().arrays();
    let arrays = arrays.into_iter().map(|(name, array)| (name.to_owned(), array)).collect();
    Checkpoint { scenario: scenario.to_toml(), progress: progress(500, [0.1; 5]), arrays }
}

fn sealed(sections: &[(&str, Section)]) -> Vec<u8> {
    let mut bytes = Vec::new();
    container::write(&mut bytes, sections).unwrap();
    bytes
}

/// The same of sections that were read.
fn sealed_again(sections: &[(String, Content)]) -> Vec<u8> {
    let sections: Vec<_> =
        sections.iter().map(|(name, content)| (name.as_str(), content.into())).collect();
    sealed(&sections)
}

fn bits(array: &Array) -> Vec<u64> {
    match array {
        Array::Numbers(numbers) => numbers.iter().map(|number| number.to_bits()).collect(),
        Array::Counts(counts) => counts.clone(),
    }
}

#[test]
fn a_state_comes_back_with_every_bit_and_steps_on_alike() {
    for ledger in [false, true] {
        let scenario = Scenario::from_toml(TEXT).unwrap();
        let mut simulation = scenario.build().unwrap();
        if ledger {
            simulation.keep_work_ledger();
        }
        (0..2000).for_each(|_| simulation.step());
        let named = |state: &State| -> Vec<(String, Array)> {
            state.arrays().into_iter().map(|(name, array)| (name.to_owned(), array)).collect()
        };
        let arrays = named(&simulation.state());
        let state = State::from_arrays(arrays.clone()).unwrap();
        for ((name, there), (_, back)) in arrays.iter().zip(named(&state)) {
            assert_eq!(bits(there), bits(&back), "{name}");
        }
        let mut other = scenario.assemble(state.particles(), state.is_of_engine());
        other.set_state(&state);
        for _ in 0..2000 {
            simulation.step();
            other.step();
        }
        assert_eq!(other.state_hash(), simulation.state_hash());
        for ((name, there), (_, back)) in
            named(&simulation.state()).iter().zip(named(&other.state()))
        {
            assert_eq!(bits(there), bits(&back), "{name} 2000 steps later");
        }
    }
}

#[test]
fn arrays_that_do_not_fit_each_other_are_refused_by_name() {
    let arrays = checkpoint().arrays;
    let shorter = |array: &Array| match array {
        Array::Numbers(numbers) => Array::Numbers(numbers[1..].to_vec()),
        Array::Counts(_) => Array::Counts(Vec::new()),
    };
    for (at, (name, array)) in arrays.iter().enumerate() {
        let mut changed = arrays.clone();
        changed[at].1 = shorter(array);
        let why = State::from_arrays(changed.clone()).map(|_| ()).unwrap_err();
        assert!(why.contains(name.as_str()), "{name}: {why}");
        changed[at].1 = Array::Counts(vec![1, 2]);
        let why = State::from_arrays(changed.clone()).map(|_| ()).unwrap_err();
        assert!(why.contains(name.as_str()), "{name}: {why}");
        changed.remove(at);
        // Without a ledger there are no shares.
        assert_eq!(State::from_arrays(changed.clone()).is_ok(), name == "shares", "without {name}");
    }
}

#[test]
fn a_checkpoint_begins_with_its_scenario_in_plain_text() {
    let checkpoint = checkpoint();
    let bytes = sealed(&checkpoint.sections());
    let head: Vec<&[u8]> = bytes.split(|&byte| byte == b'\n').take(12).collect();
    assert_eq!(head[0], b"parsim2d checkpoint 2");
    assert!(head[1].starts_with(b"section scenario text "));
    assert!(head.contains(&&b"n = 12"[..]) && head.contains(&&b"seed = 5"[..]));
    assert_eq!(Checkpoint::from_bytes(&bytes).unwrap(), checkpoint);
}

/// A checkpoint as the format tells it, put together from whole arrays.
fn plainly_written(sections: &[(String, Content)]) -> Vec<u8> {
    let mut file = b"parsim2d checkpoint 2\n".to_vec();
    for (name, content) in sections {
        let (kind, bytes) = match content {
            Content::Text(text) => ("text", text.clone().into_bytes()),
            Content::Array(array) => {
                let kind = if matches!(array, Array::Counts(_)) { "u64" } else { "f64" };
                (kind, bits(array).into_iter().flat_map(u64::to_le_bytes).collect())
            }
        };
        let crc = crc32fast::hash(&bytes);
        let head = format!("section {name} {kind} {} crc32 {crc:08x}\n", bytes.len());
        file.extend([head.as_bytes(), &bytes, b"\n"].concat());
    }
    let crc = crc32fast::hash(&file);
    file.extend(format!("end {} crc32 {crc:08x}\n", sections.len()).as_bytes());
    file
}

#[test]
fn a_file_written_a_piece_at_a_time_has_the_bytes_of_the_format() {
    // Discs of more and of less than one piece, in rows of eight, four, two and one number.
    for (n, by_engine, ledger) in
        [(12, false, true), (3000, false, true), (3000, true, true), (3000, true, false)]
    {
        let text = format!("{TEXT}placement = 'lattice'\n").replace("n = 12", &format!("n = {n}"));
        let text = text.replace("radius = 4e-4", "radius = 2e-4");
        let scenario = Scenario::from_toml(&text).unwrap();
        let mut simulation = scenario.assemble(scenario.place().unwrap(), by_engine);
        if ledger {
            simulation.keep_work_ledger();
        }
        (0..20).for_each(|_| simulation.step());
        let progress = progress(20, [0.1; 5]);
        let streamed = sealed(&checkpoint::sections(&text, &progress, simulation.arrays()));
        let read = container::read(&streamed).unwrap();
        assert!(streamed == plainly_written(&read), "{n} discs, the engine: {by_engine}");
        let arrays = simulation.state().arrays();
        assert_eq!(arrays.len() + 2, read.len());
        for ((name, there), (other, back)) in arrays.iter().zip(&read[2..]) {
            let Content::Array(back) = back else { panic!("{other} is a text") };
            assert_eq!((*name, bits(there)), (other.as_str(), bits(back)));
        }
    }
}

proptest! {
    #![proptest_config(crate::support::steady())]

    #[test]
    fn numbers_of_the_progress_come_back_with_every_bit(
        numbers in prop::array::uniform5(prop::num::f64::ANY),
        step in 0..i64::MAX as u64 / 2,
    ) {
        let there = Checkpoint { progress: progress(step, numbers), ..checkpoint() };
        let back = Checkpoint::from_bytes(&sealed(&there.sections())).unwrap().progress;
        let of = |p: &Progress| [
            p.kinetic_at_start_J, p.gravitational_at_start_J, p.elastic_at_start_J,
            p.movable_at_start_J, p.overlap_at_start, p.written.ledger_kinetic_J,
        ];
        for (there, back) in of(&there.progress).iter().zip(of(&back)) {
            // Which of the many no-numbers it was does not matter.
            prop_assert!(there.to_bits() == back.to_bits() || there.is_nan() && back.is_nan());
        }
        prop_assert_eq!(back.step, step);
        prop_assert_eq!(&back.command, &there.progress.command);
    }

    #[test]
    fn any_list_of_named_arrays_is_carried(
        arrays in prop::collection::vec(
            ("[a-z_]{1,20}", prop_oneof![
                prop::collection::vec(prop::num::f64::ANY, 0..40).prop_map(Array::Numbers),
                prop::collection::vec(any::<u64>(), 0..40).prop_map(Array::Counts),
            ]),
            0..10,
        ),
    ) {
        let sections: Vec<(String, Content)> =
            arrays.iter().cloned().map(|(name, array)| (name, Content::Array(array))).collect();
        let back = container::read(&sealed_again(&sections)).unwrap();
        prop_assert_eq!(back.len(), arrays.len());
        for ((name, array), (other, content)) in arrays.iter().zip(&back) {
            let Content::Array(content) = content else { panic!("{other} is a text") };
            prop_assert_eq!(name, other);
            prop_assert_eq!(bits(array), bits(content));
        }
    }

    #[test]
    fn no_bytes_make_the_reader_panic(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        prop_assert!(Checkpoint::from_bytes(&bytes).is_err());
        let begun = [b"parsim2d checkpoint 2\n".to_vec(), bytes].concat();
        prop_assert!(Checkpoint::from_bytes(&begun).is_err());
    }
}

/// How many random faults to try.
fn tries() -> usize {
    std::env::var("PARSIM2D_CORRUPTIONS").map_or(500, |count| count.parse().unwrap())
}

/// One random fault, of the kinds that disks, copies and editors make.
fn harm(bytes: &mut Vec<u8>, dice: &mut Pcg64) {
    let at = dice.random_range(0..bytes.len());
    let end = (at + dice.random_range(1..200)).min(bytes.len());
    match dice.random_range(0..9) {
        0 => bytes[at] ^= 1 << dice.random_range(0..8),
        1 => bytes[at] = dice.random(),
        2 => bytes.truncate(at),
        3 => drop(bytes.drain(at..end)),
        4 => bytes.insert(at, dice.random()),
        5 => bytes[at..end].fill(0),
        6 => dice.fill_bytes(&mut bytes[at..end]),
        7 => {
            let copy = bytes[at..end].to_vec();
            let to = dice.random_range(0..bytes.len());
            bytes.splice(to..to, copy);
        }
        _ => bytes.extend((0..dice.random_range(1..50)).map(|_| dice.random::<u8>())),
    }
}

#[test]
fn no_corruption_is_accepted() {
    let whole = sealed(&checkpoint().sections());
    assert!(Checkpoint::from_bytes(&whole).is_ok());
    let mut dice = Pcg64::seed_from_u64(2019);
    let mut tried = 0;
    while tried < tries() {
        let mut bytes = whole.clone();
        for _ in 0..dice.random_range(1..4) {
            if !bytes.is_empty() {
                harm(&mut bytes, &mut dice);
            }
        }
        if bytes != whole {
            tried += 1;
            let read = Checkpoint::from_bytes(&bytes);
            assert!(read.is_err(), "corruption {tried} was accepted");
        }
    }
    println!("{tried} corruptions, none accepted");
    // Every length that a file cut off could have.
    for length in 0..whole.len() {
        let flaw = Checkpoint::from_bytes(&whole[..length]).unwrap_err();
        assert!(matches!(flaw, Flaw::Foreign | Flaw::Damaged(_)), "{length}: {flaw}");
    }
}

#[test]
fn a_damaged_section_is_named() {
    let whole = sealed(&checkpoint().sections());
    for name in ["scenario", "progress", "particles", "shares"] {
        let line = format!("\nsection {name} ");
        let at = whole.windows(line.len()).position(|bytes| bytes == line.as_bytes()).unwrap();
        let mut bytes = whole.clone();
        bytes[at + 100] ^= 4; // the line of a section is shorter
        let flaw = Checkpoint::from_bytes(&bytes).unwrap_err().to_string();
        assert!(flaw.contains(&format!("checksum of section {name} does not")), "{name}: {flaw}");
    }
}

#[test]
fn nothing_under_a_good_checksum_makes_a_reader_panic() {
    // Somebody may build a checkpoint by hand: what is inside is not believed either.
    let whole = sealed(&checkpoint().sections());
    let mut dice = Pcg64::seed_from_u64(2020);
    let (mut read, mut refused) = (0, 0);
    for _ in 0..tries() {
        let mut sections = container::read(&whole).unwrap();
        let at = dice.random_range(0..sections.len());
        match &mut sections[at].1 {
            Content::Text(text) => {
                let mut bytes = text.as_bytes().to_vec();
                harm(&mut bytes, &mut dice);
                *text = String::from_utf8_lossy(&bytes).into_owned();
            }
            Content::Array(Array::Numbers(numbers)) if dice.random() => {
                let at = dice.random_range(0..numbers.len());
                numbers[at] = f64::from_bits(dice.random());
            }
            Content::Array(Array::Numbers(numbers)) => {
                numbers.truncate(dice.random_range(0..numbers.len()));
            }
            Content::Array(Array::Counts(counts)) => counts[0] = dice.random(),
        }
        let outcome =
            Checkpoint::from_bytes(&sealed_again(&sections)).map_err(|why| why.to_string());
        let outcome = outcome.and_then(|Checkpoint { scenario, progress, mut arrays }| {
            let changes = Settings::default();
            Scenario::continued(&scenario, &mut arrays, &progress.written, changes)
                .map_err(|why| why.to_string())?;
            State::from_arrays(arrays)
        });
        if outcome.is_ok() { read += 1 } else { refused += 1 }
    }
    println!("{read} read, {refused} refused");
    assert!(read > 0 && refused > 0, "{read} read, {refused} refused: one side is not tested");
}

#[test]
fn no_text_makes_the_scenario_reader_panic() {
    let tables = "[[disc]]\nposition = [0.01, '2cm']\nvelocity = [0, 1]\n[[population]]\nn = 3\n";
    let whole = format!("{TEXT}dt = 'auto'\nstart = 'x'\nwalls = false\n{tables}");
    let mut dice = Pcg64::seed_from_u64(2021);
    for _ in 0..tries() {
        let mut bytes = whole.as_bytes().to_vec();
        for _ in 0..dice.random_range(1..6) {
            if !bytes.is_empty() {
                harm(&mut bytes, &mut dice);
            }
        }
        let _ = Scenario::from_toml(&String::from_utf8_lossy(&bytes)); // good or refused
    }
}
