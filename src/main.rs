//! parsim2d: parse, dispatch, print the error, set the exit code. All in `cli`.

fn main() -> std::process::ExitCode {
    parsim2d::cli::run()
}
