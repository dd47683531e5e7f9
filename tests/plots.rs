//! The gnuplot scripts, run by gnuplot into pictures that are looked at pixel by pixel.
//!
//! Without gnuplot these tests say what they skipped; with `PARSIM2D_REQUIRE_GNUPLOT` set they
//! fail instead.
#![allow(clippy::too_many_lines)] // a picture is looked at from several sides

use std::fs::{self, File};
use std::io::BufReader;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

use tempfile::TempDir;

/// Whether gnuplot can be run. If not, says that `what` was not tested.
fn has_gnuplot(what: &str) -> bool {
    let found = Command::new("gnuplot").arg("--version").output().is_ok();
    if !found {
        let required = std::env::var_os("PARSIM2D_REQUIRE_GNUPLOT").is_some();
        assert!(!required, "gnuplot is not installed, and PARSIM2D_REQUIRE_GNUPLOT is set");
        eprintln!("SKIPPED: gnuplot is not installed, so {what} was not tested");
    }
    found
}

fn script(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("plot").join(name)
}

/// Runs the program in a fresh folder.
fn simulated(arguments: &str) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let status = simulator(folder.path(), arguments).status().unwrap();
    assert!(status.success());
    folder
}

fn simulator(folder: &Path, arguments: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_parsim2d"));
    command.current_dir(folder).args(arguments.split_whitespace()).arg("-q");
    command
}

/// Runs gnuplot on a script in `folder` with `settings` made first.
fn gnuplot(folder: &Path, settings: &str, script: &Path) -> Output {
    let mut command = Command::new("gnuplot");
    command.current_dir(folder).env_remove("DISPLAY").stdin(Stdio::null());
    command.args(["-e", settings]).arg(script).output().unwrap()
}

/// A child process that does not outlive its test.
struct Running(Child);

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

struct Picture {
    width: usize,
    height: usize,
    rgb: Vec<[u8; 3]>,
}

impl Picture {
    fn read(path: &Path) -> Self {
        let file = File::open(path).unwrap_or_else(|why| panic!("{}: {why}", path.display()));
        let mut decoder = png::Decoder::new(BufReader::new(file));
        decoder.set_transformations(png::Transformations::EXPAND | png::Transformations::STRIP_16);
        let mut reader = decoder.read_info().unwrap();
        let mut buffer = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut buffer).unwrap();
        let channels = info.color_type.samples();
        let rgb = buffer[..info.buffer_size()]
            .chunks(channels)
            .map(|p| [p[0], p[1 % channels], p[2 % channels]]);
        Self { width: info.width as usize, height: info.height as usize, rgb: rgb.collect() }
    }

    /// Places of the pixels that are coloured: neither grey, black nor white.
    fn coloured(&self) -> Vec<(usize, usize)> {
        let is_coloured = |p: &[u8; 3]| p.iter().max().unwrap() - p.iter().min().unwrap() > 40;
        let places = self.rgb.iter().enumerate().filter(|(_, p)| is_coloured(p));
        places.map(|(k, _)| (k % self.width, k / self.width)).collect()
    }

    /// Pixels nearest to `colour` within a few shades.
    fn count_of(&self, colour: [u8; 3]) -> usize {
        let is_near = |p: &&[u8; 3]| p.iter().zip(colour).all(|(&a, b)| a.abs_diff(b) < 12);
        self.rgb.iter().filter(is_near).count()
    }
}

#[test]
fn loop_plot_draws_discs_to_scale() {
    if !has_gnuplot("plot/loop.plot") {
        return;
    }
    // One disc of a quarter of the box across, in the middle.
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("start.txt"), "0.02 0.02 0.005\n").unwrap();
    let arguments = "--start start.txt --time 0 --seed 1";
    assert!(simulator(folder.path(), arguments).status().unwrap().success());
    let output = gnuplot(folder.path(), "redraws=1; png='now.png'", &script("loop.plot"));
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let picture = Picture::read(&folder.path().join("now.png"));
    let disc = picture.coloured();
    let range =
        |values: Vec<usize>| values.iter().max().unwrap() - values.iter().min().unwrap() + 1;
    let width = range(disc.iter().map(|&(x, _)| x).collect());
    let height = range(disc.iter().map(|&(_, y)| y).collect());
    // As wide as high, to the pixel or two that drawing rounds, and filled: pi/4 of its square.
    assert!(width.abs_diff(height) <= 2 && width > 80, "{width} x {height}");
    let filling = disc.len() as f64 / (width * height) as f64;
    assert!((filling - std::f64::consts::FRAC_PI_4).abs() < 0.05, "{filling}");
    // A quarter of the box, which is 0.04 of the 0.0424 m drawn: a bit under a quarter of the plot.
    assert!(width * 3 < picture.width && width * 6 > picture.width, "{width} of {}", picture.width);
    assert!(picture.height > 500);
}

#[test]
fn loop_plot_shows_a_run_that_is_still_going() {
    if !has_gnuplot("the live view") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let arguments = "-n 20 --radius 5e-4 --time 100 --seed 1 --slowdown 10";
    let child = simulator(folder.path(), arguments).spawn().unwrap();
    let mut running = Running(child);
    let mut shown = Vec::new();
    for name in ["one.png", "two.png"] {
        std::thread::sleep(Duration::from_millis(400));
        let settings = format!("redraws=1; png='{name}'");
        let output = gnuplot(folder.path(), &settings, &script("loop.plot"));
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let picture = Picture::read(&folder.path().join(name));
        // 20 discs of 1 mm in 42 mm on 700 pixels: some 150 pixels each, overlaps aside.
        assert!(picture.coloured().len() > 1500, "{}", picture.coloured().len());
        shown.push(picture.rgb);
    }
    assert!(running.0.try_wait().unwrap().is_none(), "the run ended too early to be watched");
    assert_ne!(shown[0], shown[1], "the discs did not move");
}

#[test]
fn loop_plot_waits_for_a_file_that_is_not_there_yet() {
    if !has_gnuplot("waiting for out.txt") {
        return;
    }
    for first in [None, Some(""), Some("# step 0 time_s 0 n 0 side_m 0.04 columns x y r\n")] {
        let folder = tempfile::tempdir().unwrap();
        if let Some(text) = first {
            fs::write(folder.path().join("out.txt"), text).unwrap();
        }
        let mut command = Command::new("gnuplot");
        command.current_dir(&folder).stderr(Stdio::null());
        command.args(["-e", "redraws=1; png='late.png'"]).arg(script("loop.plot"));
        let mut waiting = Running(command.spawn().unwrap());
        std::thread::sleep(Duration::from_millis(500));
        assert!(waiting.0.try_wait().unwrap().is_none(), "gave up on {first:?}");
        assert!(simulator(folder.path(), "-n 20 --time 0 --seed 1").status().unwrap().success());
        let begun = Instant::now();
        let status = loop {
            if let Some(status) = waiting.0.try_wait().unwrap() {
                break status;
            }
            assert!(begun.elapsed() < Duration::from_secs(10), "did not see the file");
            std::thread::sleep(Duration::from_millis(50));
        };
        assert!(status.success());
        assert!(!Picture::read(&folder.path().join("late.png")).coloured().is_empty());
    }
}

#[test]
fn the_guides_own_four_line_script_works() {
    if !has_gnuplot("the guide's script") {
        return;
    }
    let folder = simulated("-n 20 --radius 5e-4 --time 0.01 --seed 1 --border");
    // A terminal instead of a window, then the four lines.
    let guides = "set terminal pngcairo size 600,600\nset output 'guide.png'\n\
                  set xrange [0:0.04]\nset yrange [0:0.04]\n\
                  plot 'out.txt' using 1:2:3 with circles\npause 1\nreread\n";
    fs::write(
        folder.path().join("guide.plot"),
        guides.replace("reread\n", "unset output\nreread\n"),
    )
    .unwrap();
    let mut command = Command::new("gnuplot");
    command.current_dir(&folder).arg("guide.plot").stderr(Stdio::piped());
    let mut running = Running(command.spawn().unwrap());
    std::thread::sleep(Duration::from_millis(1500));
    assert!(running.0.try_wait().unwrap().is_none(), "it stopped before its first reread");
    let picture = Picture::read(&folder.path().join("guide.png"));
    assert!(picture.coloured().len() > 500, "{}", picture.coloured().len());
}

#[test]
fn replay_plot_draws_frames_and_an_animation() {
    if !has_gnuplot("plot/replay.plot") {
        return;
    }
    let folder = simulated("-n 20 --radius 5e-4 --time 0.05 --seed 1 --every 1000");
    let mut pictures = Vec::new();
    for settings in ["png='0.png'; frame=0", "png='last.png'"] {
        let output = gnuplot(folder.path(), settings, &script("replay.plot"));
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let name = settings.split('\'').nth(1).unwrap();
        let picture = Picture::read(&folder.path().join(name));
        assert!(picture.coloured().len() > 1500, "{}", picture.coloured().len());
        pictures.push(picture.rgb);
    }
    assert_ne!(pictures[0], pictures[1]);
    let output = gnuplot(folder.path(), "gif='replay.gif'", &script("replay.plot"));
    assert!(output.status.success());
    let gif = fs::read(folder.path().join("replay.gif")).unwrap();
    assert!(gif.starts_with(b"GIF89a"));
    // Each frame of an animation begins with a graphic control extension.
    let frames = gif
        .windows(4)
        .filter(|bytes| bytes == b"\x21\xF9\x04\x08" || bytes == b"\x21\xF9\x04\x04")
        .count();
    let written = fs::read_to_string(folder.path().join("trajectory.txt")).unwrap();
    assert_eq!(frames, written.matches('#').count(), "frames in the GIF");
}

#[test]
fn energy_plot_draws_every_curve_of_the_ledger() {
    if !has_gnuplot("plot/energy.plot") {
        return;
    }
    let folder = simulated("-n 20 --radius 1e-3 --kn 1e3 --restitution 0.5 --time 0.2 --seed 1");
    let output = gnuplot(folder.path(), "png='energy.png'", &script("energy.plot"));
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let picture = Picture::read(&folder.path().join("energy.png"));
    // The colours of kinetic, gravitational, elastic, dissipated; a legend line alone has 100.
    for colour in [[0xD5, 0x5E, 0], [0, 0x72, 0xB2], [0, 0x9E, 0x73], [0xE6, 0x9F, 0]] {
        assert!(picture.count_of(colour) > 300, "{colour:?}: {}", picture.count_of(colour));
    }
}

#[test]
fn velocity_plot_draws_an_arrow_for_every_moving_disc() {
    if !has_gnuplot("plot/velocity.plot") {
        return;
    }
    let coloured = |arguments: &str| {
        let folder = simulated(arguments);
        let output = gnuplot(folder.path(), "png='velocity.png'", &script("velocity.plot"));
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        Picture::read(&folder.path().join("velocity.png")).coloured().len()
    };
    let at_rest = coloured("-n 50 --radius 5e-4 --time 0 --seed 1");
    let moving = coloured("-n 50 --radius 5e-4 --time 0 --seed 1 --speed 0.5");
    // Fifty arrows of 32 pixels and their heads, beside the colour box that both have.
    assert!(moving > at_rest + 50 * 32, "{moving} {at_rest}");
}

#[test]
fn scripts_without_data_say_so_and_stop() {
    if !has_gnuplot("missing data") {
        return;
    }
    for (name, file) in [
        ("replay.plot", "trajectory.txt"),
        ("energy.plot", "energy.csv"),
        ("velocity.plot", "trajectory.txt"),
    ] {
        let folder = tempfile::tempdir().unwrap();
        let output = gnuplot(folder.path(), "png='x.png'", &script(name));
        assert_eq!(output.status.code(), Some(1), "{name}");
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(said.contains(&format!("{file} is missing or empty")), "{name}: {said}");
        assert_eq!(said.trim().lines().count(), 1, "{name}: {said}");
    }
}
