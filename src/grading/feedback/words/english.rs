//! English.

use super::{Face, Words};

/// English.
pub const ENGLISH: Words = Words {
    grade: &crate::grading::judge::words::ENGLISH,
    sheet: "Graded:",
    class: "The class",
    face,
    kindly,
    not_told: "Programs of this course are not told how many discs to take. It costs no points.",
    no_interface: "This course does not test functions one by one. It costs no points.",
    checks: "Check by check",
    found: "found",
    notes: "Good to know",
    partial: "Grading has not ended: checks are still to come, and the points are those so far.",
    hidden: "checks that count and are not shown:",
    hidden_test: "checks that are not shown",
    said: "what was printed",
    log: "What building and running printed",
    cut: "(and more, left out here)",
    picture: "The discs of that frame; those that are meant have their numbers. Arrows: which way they \
              move, the longer the faster.",
    how: "How it was graded",
    how_rows: ["graded by", "whole frames", "discs", "time that grading took, s"],
    sandbox: "sandbox",
    no_tier: "nothing was run: the frames were handed in",
    rubric: "The numbers it was measured by",
    rubric_rows: [
        "discs",
        "side of the box, m",
        "radius, m",
        "mass, kg",
        "gravity, m/s²",
        "stiffness k_n, N/m",
        "damping η_n, kg/s",
        "expected e of walls",
        "expected e of pairs",
    ],
    any: "any",
    class_head: ["submission", "%", "looks like"],
    class_line: ["submission", "submissions", "median, %"],
    distribution: "How many per cent",
    distribution_caption: "Submissions by per cent of the points that could be judged.",
    mistakes: "What to teach again",
    mistakes_head: ["looks like", "submissions", "check"],
    no_mistakes: "No check failed.",
    unknown_mistake: "a mistake of another kind",
    ungraded: "Could not be graded, through no fault of the students",
    scaled: "what could not be judged is left out, and the score is scaled to the points of all checks",
};

fn face(face: Face) -> &'static str {
    match face {
        Face::Passed => "passed",
        Face::Partly => "partly",
        Face::Failed => "not passed",
        Face::NotSeen => "not seen",
        Face::Skipped => "not asked yet",
        Face::Masked => "masked",
    }
}

fn kindly(face: Face) -> &'static str {
    match face {
        Face::NotSeen => "Nothing in these frames decides it. It costs no points.",
        Face::Skipped => "It can be judged only when this is right:",
        Face::Masked => "It cannot be seen behind what the printed eta_n does. It costs no points.",
        Face::Passed | Face::Partly | Face::Failed => "",
    }
}
