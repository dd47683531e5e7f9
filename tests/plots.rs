//! The gnuplot scripts of `plot/`, each run on what the program wrote, its picture read back.
//! Discs, arrows and curves are the only things in colour: axes, box and letters are black.

use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use tempfile::TempDir;

use crate::support::gnuplot_is_missing;

/// Twenty moving discs.
const MOVING: &str = "-n 20 --time 0.02 --seed 1 -q --speed 0.5 --radius 5e-4";
/// Damped discs with many contacts.
const CROWDED: &str = "-n 50 --time 0.02 --seed 1 -q --speed 0.5 --radius 1e-3 --restitution 0.5";
/// One large disc that does not move.
const RESTING: &str = "-n 1 --time 0.001 --seed 1 -q --gravity 0 --radius 5e-3";

#[test]
fn loop_plot_shows_a_run_that_is_still_going() {
    if gnuplot_is_missing("a live run") {
        return;
    }
    let folder = TempDir::new().unwrap();
    let mut run = start(simulator(&folder, "-n 20 --slowdown 50 --seed 1 -q --speed 0.5"));
    let header = || {
        let text = fs::read_to_string(folder.path().join("out.txt")).ok()?;
        text.lines().next().map(str::to_owned)
    };
    let mut seen = None;
    let discs = ["first.png", "second.png"].map(|name| {
        wait_for("a frame of another time", || header().filter(|new| Some(new) != seen.as_ref()));
        let variables = format!("redraws=1; png='{name}'");
        assert_eq!(said(&plot(&folder, "loop", &variables)), "");
        seen = header();
        Picture::read(&folder, name).places(in_colour)
    });
    assert!(run.0.try_wait().unwrap().is_none(), "the run ended early");
    assert!(discs[0].len() > 20, "twenty discs, no pixels");
    assert!(discs[0] != discs[1], "nothing moved");
}

#[test]
fn loop_plot_waits_for_a_file_that_is_not_there_yet() {
    if gnuplot_is_missing("a plot started before the run") {
        return;
    }
    let folder = TempDir::new().unwrap();
    let mut waiting = start(gnuplot(&folder, "loop", "redraws=1; png='now.png'"));
    sleep(Duration::from_millis(300));
    assert!(waiting.0.try_wait().unwrap().is_none(), "it did not wait");
    simulate_in(&folder, MOVING);
    let output = waiting.finish();
    assert!(output.status.success());
    assert_eq!(said(&output), "waiting for out.txt\n");
    assert!(Picture::read(&folder, "now.png").count(in_colour) > 20);
}

#[test]
fn the_guides_own_four_line_script_works() {
    if gnuplot_is_missing("the guide's script") {
        return;
    }
    let folder = TempDir::new().unwrap();
    let _run = start(simulator(&folder, "-n 20 --slowdown 50 --seed 1 -q --speed 0.5"));
    fs::write(
        folder.path().join("guide.plot"),
        "set xrange [0:0.04]; set yrange [0:0.04]\n\
         plot 'out.txt' using 1:2:3 with circles\n\
         pause 1\n\
         reread\n",
    )
    .unwrap();
    wait_for("out.txt", || folder.path().join("out.txt").exists().then_some(()));
    let mut command = Command::new("gnuplot");
    let to_file = "set terminal pngcairo; set output 'guide.png'";
    command.args(["-d", "-e", to_file, "guide.plot"]).current_dir(&folder);
    let mut guide = start(command);
    // gnuplot writes one picture after the other into the file.
    let pictures = || fs::read(folder.path().join("guide.png")).unwrap_or_default();
    let beginnings = || pictures().windows(8).filter(|w| w == b"\x89PNG\r\n\x1a\n").count();
    wait_for("a second picture", || (beginnings() >= 2).then_some(()));
    assert!(guide.0.try_wait().unwrap().is_none(), "it stopped redrawing");
    assert!(Picture::read(&folder, "guide.png").count(in_colour) > 20);
}

#[test]
fn replay_plot_draws_one_frame_or_an_animation() {
    if gnuplot_is_missing("the replay") {
        return;
    }
    let folder = simulate(MOVING);
    let discs = [("first.png", "; frame=0"), ("last.png", "")].map(|(name, frame)| {
        let output = plot(&folder, "replay", &format!("png='{name}'{frame}"));
        assert_eq!(said(&output), format!("wrote {name}\n"));
        Picture::read(&folder, name).places(in_colour)
    });
    assert!(discs[0].len() > 1000, "twenty discs, no pixels");
    assert!(discs[0] != discs[1], "nothing moved");
    plot(&folder, "replay", "gif='some.gif'; first=10; last=30; step=5");
    assert_eq!(frames_of_gif(&fs::read(folder.path().join("some.gif")).unwrap()), 5);
}

#[test]
fn energy_plot_draws_every_curve() {
    if gnuplot_is_missing("the energy plot") {
        return;
    }
    // At rest all curves lie on one another: what is left of a colour is its legend.
    let [moving, resting] = [CROWDED, RESTING].map(|run| {
        let folder = simulate(run);
        plot(&folder, "energy", "png='energy.png'");
        let picture = Picture::read(&folder, "energy.png");
        let (upper, lower) = picture.pixels.split_at(picture.pixels.len() / 2);
        [upper.to_vec(), lower.to_vec()]
    });
    for (panel, curve, colour) in [
        (0, "gravitational", [0x00, 0x72, 0xB2]),
        (0, "kinetic", [0xD5, 0x5E, 0x00]),
        (0, "elastic", [0x00, 0x9E, 0x73]),
        (0, "dissipated", [0xCC, 0x79, 0xA7]),
        (1, "integration error: gain", [0xE6, 0x9F, 0x00]),
        (1, "integration error: loss", [0x56, 0xB4, 0xE9]),
        (1, "work residue", [0x88, 0x22, 0x55]),
    ] {
        let near = |pixel: &&[u8; 3]| pixel.iter().zip(colour).all(|(a, b)| a.abs_diff(b) < 12);
        let [drawn, legend] = [&moving, &resting].map(|of| of[panel].iter().filter(near).count());
        let least = match curve {
            "dissipated" => 200, // drawn last, so at rest too
            _ => legend + 100,
        };
        assert!(drawn > least, "{curve}: {drawn} pixels, at rest {legend}");
    }
}

#[test]
fn velocity_plot_draws_arrows_along_the_velocities() {
    if gnuplot_is_missing("the velocity field") {
        return;
    }
    let radius = 2e-3;
    let folder = simulate("-n 1 --time 0.01 --seed 3 -q --gravity 0 --speed 0.5 --radius 2e-3");
    plot(&folder, "velocity", "png='velocity.png'");
    let picture = Picture::read(&folder, "velocity.png");
    let [left, right, top, bottom] = picture.bounds(light_grey);
    let pixel = 2.0 * radius / (right - left + 1) as f64; // m
    let centre = [(left + right) as f64 / 2.0, (top + bottom) as f64 / 2.0];

    let text = fs::read_to_string(folder.path().join("trajectory.txt")).unwrap();
    let row = text.lines().last().unwrap();
    let row: Vec<f64> = row.split(' ').map(|word| word.parse().unwrap()).collect();
    let speed = row[3].hypot(row[4]);
    let along = [row[3] / speed, -row[4] / speed]; // rows of pixels count downward

    let arrow = picture.places(in_colour);
    assert!(arrow.len() > 20, "no arrow");
    let mut farthest = 0.0_f64;
    for (x, y) in arrow {
        let [dx, dy] = [x as f64 - centre[0], y as f64 - centre[1]];
        let (forward, aside) = (dx * along[0] + dy * along[1], dx * along[1] - dy * along[0]);
        assert!(
            forward > -3.0 && aside.abs() < 6.0,
            "({dx}, {dy}) from the centre is not on an arrow along {along:?}"
        );
        farthest = farthest.max(forward);
    }
    let expected = 0.05 * 0.04 / pixel; // 5 % of the box
    assert!(
        (farthest - expected).abs() < 4.0,
        "the fastest arrow has {farthest} pixels, not {expected}"
    );
}

#[test]
fn velocity_plot_of_discs_at_rest_has_no_arrows() {
    if gnuplot_is_missing("the velocity field at rest") {
        return;
    }
    let folder = simulate(RESTING);
    let output = plot(&folder, "velocity", "png='velocity.png'");
    assert_eq!(said(&output), "wrote velocity.png\n");
    let picture = Picture::read(&folder, "velocity.png");
    assert_eq!(picture.places(in_colour), []);
}

#[test]
fn discs_are_drawn_to_scale() {
    if gnuplot_is_missing("the scale of the discs") {
        return;
    }
    let folder = simulate(RESTING);
    for (script, disc) in [
        ("loop", in_colour as fn([u8; 3]) -> bool),
        ("replay", in_colour),
        ("velocity", light_grey),
    ] {
        let name = format!("{script}.png");
        plot(&folder, script, &format!("png='{name}'"));
        let picture = Picture::read(&folder, &name);
        let [left, right, top, bottom] = picture.bounds(disc);
        let [west, east, north, south] = picture.walls();
        assert!((east - west).abs_diff(south - north) <= 1, "{script}: not square");
        for (size, side) in [(right - left + 1, east - west), (bottom - top + 1, south - north)] {
            let expected = side as f64 * 2.0 * 5e-3 / 0.04;
            assert!(
                (size as f64 - expected).abs() <= 3.0,
                "{script}: {size} pixels, not {expected}"
            );
        }
    }
}

#[test]
fn a_missing_or_empty_file_is_one_clear_message() {
    if gnuplot_is_missing("missing files") {
        return;
    }
    for (script, file) in
        [("replay", "trajectory.txt"), ("velocity", "trajectory.txt"), ("energy", "energy.csv")]
    {
        let folder = TempDir::new().unwrap();
        for state in ["missing", "empty"] {
            let output = start(gnuplot(&folder, script, "png='no.png'")).finish();
            let said = said(&output);
            assert_eq!(output.status.code(), Some(1), "{script}, {state}: {said}");
            assert_eq!(said.lines().count(), 1, "{script}, {state}: {said}");
            assert!(said.starts_with(file) && said.contains("run the simulator"), "{said}");
            File::create(folder.path().join(file)).unwrap();
        }
        assert!(!folder.path().join("no.png").exists());
    }
}

#[test]
fn a_frame_that_is_not_there_is_one_clear_message() {
    if gnuplot_is_missing("wrong frame numbers") {
        return;
    }
    let folder = simulate(RESTING);
    for script in ["replay", "velocity"] {
        let output = start(gnuplot(&folder, script, "png='no.png'; frame=999")).finish();
        let said = said(&output);
        assert_eq!(output.status.code(), Some(1), "{script}: {said}");
        assert!(said.starts_with("trajectory.txt holds frames 0 to 113;"), "{said}");
        assert_eq!(said.lines().count(), 1, "{said}");
    }
}

#[test]
fn a_gnuplot_without_windows_writes_files_or_text() {
    if gnuplot_is_missing("gnuplot without windows") {
        return;
    }
    let folder = simulate(RESTING);
    for (script, file) in [
        ("replay", "replay.gif"),
        ("velocity", "velocity.png"),
        ("energy", "energy.png"),
        ("loop", ""),
    ] {
        // `set output` sends the text picture to a file.
        let settings = if script == "loop" { "redraws=1; set output 'drawn.txt'" } else { "" };
        let mut command = gnuplot(&folder, script, settings);
        command.env("GNUTERM", "unknown");
        let output = start(command).finish();
        let said = said(&output);
        if script == "loop" {
            // The live view is drawn as text.
            assert!(output.status.success(), "{said}");
            let drawn = fs::read_to_string(folder.path().join("drawn.txt")).unwrap();
            assert!(drawn.contains("t = ") && drawn.contains('*'), "{drawn}{said}");
        } else {
            assert!(output.status.success(), "{said}");
            assert!(said.ends_with(&format!("wrote {file}\n")), "{said}");
            assert!(folder.path().join(file).exists());
        }
    }
}

fn simulator(folder: &TempDir, arguments: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_parsim2d"));
    command.args(arguments.split_whitespace()).current_dir(folder);
    command
}

fn simulate_in(folder: &TempDir, arguments: &str) {
    let output = start(simulator(folder, arguments)).finish();
    assert!(output.status.success(), "{}", said(&output));
}

/// A folder with the files of a run.
fn simulate(arguments: &str) -> TempDir {
    let folder = TempDir::new().unwrap();
    simulate_in(&folder, arguments);
    folder
}

/// gnuplot on a script of `plot/`, without the settings of whoever runs the test.
fn gnuplot(folder: &TempDir, script: &str, variables: &str) -> Command {
    let scripts = Path::new(env!("CARGO_MANIFEST_DIR")).join("plot");
    let mut command = Command::new("gnuplot");
    command.args(["-d", "-e", variables]);
    command.arg(scripts.join(script).with_extension("plot"));
    command.current_dir(folder);
    command
}

/// Runs a script to its end, which must be a good one.
fn plot(folder: &TempDir, script: &str, variables: &str) -> Output {
    let output = start(gnuplot(folder, script, variables)).finish();
    assert!(output.status.success(), "{script}: {}", said(&output));
    output
}

fn said(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

/// A child process that does not outlive its test.
struct Running(Child);

fn start(mut command: Command) -> Running {
    command.stdin(Stdio::null());
    command.stdout(Stdio::null()).stderr(Stdio::piped());
    Running(command.spawn().unwrap())
}

impl Running {
    /// Waits for the end; the little that our programs say on stderr fits into a pipe.
    fn finish(mut self) -> Output {
        let status = wait_for("the end of a program", || self.0.try_wait().unwrap());
        let mut stderr = Vec::new();
        let mut pipe = self.0.stderr.take().unwrap();
        std::io::Read::read_to_end(&mut pipe, &mut stderr).unwrap();
        Output { status, stdout: Vec::new(), stderr }
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.0.kill(); // it may have ended
        let _ = self.0.wait();
    }
}

fn wait_for<T>(what: &str, mut look: impl FnMut() -> Option<T>) -> T {
    let began = Instant::now();
    loop {
        if let Some(found) = look() {
            return found;
        }
        assert!(began.elapsed() < Duration::from_secs(30), "waited too long for {what}");
        sleep(Duration::from_millis(10));
    }
}

/// A PNG, read back.
struct Picture {
    width: usize,
    height: usize,
    pixels: Vec<[u8; 3]>,
}

/// A disc, an arrow or a curve.
fn in_colour(pixel: [u8; 3]) -> bool {
    pixel.iter().max().unwrap() - pixel.iter().min().unwrap() > 40
}

/// A disc of the velocity plot.
fn light_grey(pixel: [u8; 3]) -> bool {
    pixel.iter().all(|channel| (0xE3..=0xE7).contains(channel))
}

impl Picture {
    fn read(folder: &TempDir, name: &str) -> Self {
        let path: PathBuf = folder.path().join(name);
        let file = std::io::BufReader::new(File::open(path).unwrap());
        let mut decoder = png::Decoder::new(file);
        decoder.set_transformations(png::Transformations::normalize_to_color8());
        let mut reader = decoder.read_info().unwrap();
        let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut bytes).unwrap();
        let pixels = bytes.chunks_exact(info.color_type.samples());
        Self {
            width: info.width as usize,
            height: info.height as usize,
            pixels: pixels.map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect(),
        }
    }

    fn count(&self, wanted: impl Fn([u8; 3]) -> bool) -> usize {
        self.pixels.iter().filter(|pixel| wanted(**pixel)).count()
    }

    /// Columns and rows of the wanted pixels inside the box, where only discs and arrows are.
    fn places(&self, wanted: impl Fn([u8; 3]) -> bool) -> Vec<(usize, usize)> {
        let [left, right, top, bottom] = self.walls();
        let rows = (top + 3)..(bottom - 2); // a line may be two pixels wide
        rows.flat_map(|y| ((left + 3)..(right - 2)).map(move |x| (x, y)))
            .filter(|(x, y)| wanted(self.pixels[y * self.width + x]))
            .collect()
    }

    /// Left, right, top and bottom of the wanted pixels inside the box.
    fn bounds(&self, wanted: impl Fn([u8; 3]) -> bool) -> [usize; 4] {
        let start = [usize::MAX, 0, usize::MAX, 0];
        let places = self.places(wanted).into_iter();
        places.fold(start, |[l, r, t, b], (x, y)| [l.min(x), r.max(x), t.min(y), b.max(y)])
    }

    /// Columns of the left and right wall, rows of the upper and lower one: the second and third
    /// long dark line, after the frame of the axes.
    fn walls(&self) -> [usize; 4] {
        let (mut columns, mut rows) = (vec![0; self.width], vec![0; self.height]);
        for (index, pixel) in self.pixels.iter().enumerate() {
            if pixel.iter().all(|channel| *channel < 150) {
                columns[index % self.width] += 1;
                rows[index / self.width] += 1;
            }
        }
        let [[left, right], [top, bottom]] = [columns, rows].map(|dark| {
            let long = |k: usize| dark[k] > self.height / 2;
            let mut lines = (1..dark.len()).filter(|&k| long(k) && !long(k - 1));
            [1, 0].map(|skip| lines.nth(skip).expect("a wall"))
        });
        [left, right, top, bottom]
    }
}

/// Number of pictures in a GIF, found by walking over its blocks.
fn frames_of_gif(bytes: &[u8]) -> usize {
    let table = |flags: u8| {
        if flags & 0x80 == 0 { 0 } else { 3 << ((flags & 7) + 1) }
    };
    let (mut at, mut frames) = (13 + table(bytes[10]), 0);
    loop {
        at += match bytes[at] {
            0x21 => 2, // an extension
            0x2C => {
                frames += 1;
                11 + table(bytes[at + 9])
            }
            end => {
                assert_eq!(end, 0x3B, "not the end of a GIF");
                return frames;
            }
        };
        while bytes[at] != 0 {
            at += 1 + bytes[at] as usize; // a block of data
        }
        at += 1;
    }
}
