//! Tells the code what the compiler has: the processor's registers of eight numbers (AVX-512) can be used from Rust 1.89
//! on. With an earlier one everything is built without them, and is slower by a twentieth.

use std::env;
use std::process::Command;

fn main() {
    println!("cargo::rustc-check-cfg=cfg(has_avx512)");
    println!("cargo::rerun-if-changed=build.rs");
    if minor_version().is_some_and(|minor| minor >= 89) {
        println!("cargo::rustc-cfg=has_avx512");
    }
}

/// The N of a compiler that says `rustc 1.N.0`.
fn minor_version() -> Option<u32> {
    let rustc = env::var_os("RUSTC")?;
    let said = Command::new(rustc).arg("--version").output().ok()?;
    let version = String::from_utf8(said.stdout).ok()?;
    version.split_whitespace().nth(1)?.split('.').nth(1)?.parse().ok()
}
