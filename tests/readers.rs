//! What we write, read by the programs it is written for: pandas, numpy and ASE; and what ASE writes.

use std::path::Path;
use std::process::Command;

use parsim2d::output::frames::{Frame, Frames};

use crate::support::runs::{outcome, text};

const SCRIPT: &str = r#"
import ase.io, numpy, pandas
frames = numpy.loadtxt("trajectory.txt")
table = pandas.read_csv("run.csv")
assert list(table.columns) == "frame step time_s side_m id x y r vx vy m".split(), table.columns
assert numpy.array_equal(table[["x", "y", "r", "vx", "vy", "m"]].to_numpy(), frames)
last = table[table.frame == table.frame.max()]
assert numpy.array_equal(numpy.loadtxt("out.txt"), last[["x", "y", "r"]].to_numpy())
xyz = ase.io.read("run.xyz", index=":")
dump = ase.io.read("run.dump", index=":", format="lammps-dump-text")
assert len(xyz) == len(dump) == table.frame.nunique()
for number, (atoms, other) in enumerate(zip(xyz, dump)):
    rows = table[table.frame == number]
    for name, columns in ("radius", "r"), ("mass", "m"), ("id", "id"):
        assert numpy.array_equal(atoms.arrays[name], rows[columns].to_numpy()), name
    assert numpy.array_equal(atoms.positions[:, :2], rows[["x", "y"]].to_numpy())
    assert numpy.array_equal(atoms.arrays["velo"][:, :2], rows[["vx", "vy"]].to_numpy())
    assert atoms.info["Time"] == rows.time_s.iloc[0] and atoms.info["Step"] == rows.step.iloc[0]
    assert atoms.cell.lengths()[0] == atoms.cell.lengths()[1] == rows.side_m.iloc[0] and not atoms.pbc.any()
    assert numpy.array_equal(other.positions, atoms.positions)
ase.io.write("ase.extxyz", xyz)
"#;

/// The Python of the environment, or the usual one.
fn python() -> String {
    std::env::var("PARSIM2D_PYTHON").unwrap_or_else(|_| "python3".to_owned())
}

/// True, and says so, if there is no Python with these modules.
fn readers_are_missing() -> bool {
    let imports = Command::new(python()).args(["-c", "import ase.io, numpy, pandas"]).output();
    let there = imports.is_ok_and(|output| output.status.success());
    if !there {
        let message =
            "SKIPPED: ase, numpy and pandas are not all installed, so their reading was not tested";
        assert!(std::env::var_os("PARSIM2D_REQUIRE_READERS").is_none(), "{message}");
        // Not `eprintln!`, which the test runner hides.
        std::io::Write::write_all(&mut std::io::stderr(), format!("{message}\n").as_bytes())
            .unwrap();
    }
    !there
}

fn frames(path: &Path) -> Vec<Frame> {
    let text = std::fs::read(path).unwrap();
    Frames::of(&text[..]).map(Result::unwrap).collect()
}

#[test]
fn pandas_numpy_and_ase_read_every_number_of_a_run() {
    if readers_are_missing() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let scenario = "time = 0.02\nseed = 2\n[[population]]\nn = 4\nmass = 2e-3\n[[population]]\nn = 5\nradius = 3e-4\n";
    std::fs::write(folder.path().join("kinds.toml"), scenario).unwrap();
    for arguments in [
        "kinds.toml -q",
        "convert trajectory.txt run.csv",
        "convert trajectory.txt run.xyz",
        "convert trajectory.txt run.dump",
    ] {
        let output = outcome(folder.path(), arguments);
        assert!(output.status.success(), "{arguments}: {}", text(&output.stderr));
    }
    let output =
        Command::new(python()).current_dir(folder.path()).args(["-c", SCRIPT]).output().unwrap();
    assert!(output.status.success(), "{}", text(&output.stderr));
    // ASE prints eight decimals: 5e-9 m, m/s and kg.
    let [ours, theirs] = ["run.xyz", "ase.extxyz"].map(|name| frames(&folder.path().join(name)));
    assert_eq!(ours.len(), theirs.len());
    for (one, other) in ours.iter().zip(&theirs) {
        assert_eq!(
            (one.step, one.side, one.rows.len()),
            (other.step, other.side, other.rows.len())
        );
        for (a, b) in one.rows.iter().zip(&other.rows) {
            assert!(a.position.distance(b.position) < 1e-8, "{a:?} {b:?}");
            assert!((a.velocity.unwrap() - b.velocity.unwrap()).length() < 1e-8, "{a:?} {b:?}");
            let (m, n) = (a.mass.unwrap(), b.mass.unwrap());
            assert!((a.radius - b.radius).abs() < 1e-8 && (m - n).abs() < 1e-8, "{a:?} {b:?}");
            assert_eq!(a.id, b.id);
        }
    }
}
