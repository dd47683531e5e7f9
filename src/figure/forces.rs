//! The contact forces of a frame: a line from centre to centre of every two discs that touch, and
//! to the walls, as wide as they push each other hard.

use glam::DVec2;

use super::Figure;
use super::colour::hex;
use super::frame;
use super::gnuplot;
use super::scene::{Scene, Stroke, left_out};
use crate::force::HalfPlane;
use crate::neighbours::Neighbours;
use crate::number::{counted, typographic};
use crate::output::frames::{Frame, FrameRow};
use crate::particle::{Contact, ContactLaw, Particle};

const FILL: [u8; 3] = [0xe5; 3];
const EDGE: [u8; 3] = [0x99; 3];
/// Lines that push and lines that pull: vermilion and blue of Okabe and Ito.
const PUSH: [u8; 3] = [0xd5, 0x5e, 0x00];
const PULL: [u8; 3] = [0x00, 0x72, 0xb2];
/// The widest line is as wide as a typical disc, within these fractions of what is shown.
const WIDEST: std::ops::RangeInclusive<f64> = 0.005..=0.02;

/// A contact and its force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Link {
    /// Centre of the disc (of lower number), m.
    pub from: DVec2,
    /// Centre of the other disc, or the point of the wall, m.
    pub to: DVec2,
    /// How hard they push each other apart, N; negative if they pull.
    pub push: f64,
}

/// The contacts of `discs` with each other and with `walls` under `law`, in order of the discs.
///
/// ```
/// use glam::DVec2;
/// use parsim2d::figure::forces::links;
/// use parsim2d::force::HalfPlane;
/// use parsim2d::particle::{Damping, Particle, SpringDashpot};
/// let law =
///     SpringDashpot { stiffness: 5e4, damping: Damping::Coefficient(0.0), tension: true };
/// let disc = |x| Particle::at_rest(DVec2::new(x, 0.02), 1e-3, 1e-3);
/// let links = links(&[disc(0.010), disc(0.0119)], &law, &HalfPlane::square(0.04));
/// assert_eq!(links.len(), 1);
/// assert!((links[0].push - 5.0).abs() < 1e-9); // 5e4 N/m * 1e-4 m
/// ```
pub fn links(discs: &[Particle], law: &impl ContactLaw, walls: &[HalfPlane]) -> Vec<Link> {
    let mut links = Vec::new();
    for disc in discs {
        for wall in walls {
            let distance = wall.distance(disc.position);
            if let Some(contact) = Contact::with_wall(disc, distance, wall.normal) {
                let to = disc.position + distance * wall.normal;
                links.push(Link { from: disc.position, to, push: law.push(&contact) });
            }
        }
    }
    let mut neighbours = Neighbours::default();
    neighbours.refresh(discs);
    for (i, j) in neighbours.pairs() {
        if let Some(contact) = Contact::between(&discs[i], &discs[j]) {
            let (from, to) = (discs[i].position, discs[j].position);
            links.push(Link { from, to, push: law.push(&contact) });
        }
    }
    links
}

/// The discs of a frame, of `mass` (kg) if the frame has no masses; at rest if it has no velocities.
pub fn discs(frame: &Frame, mass: f64) -> Vec<Particle> {
    let disc = |row: &FrameRow| {
        let mut disc = Particle::at_rest(row.position, row.radius, row.mass.unwrap_or(mass));
        disc.velocity = row.velocity.unwrap_or_default();
        disc
    };
    frame.rows.iter().map(disc).collect()
}

/// The walls of the frame's box; none if the file does not say how large it is.
pub fn walls(frame: &Frame) -> Vec<HalfPlane> {
    frame.side.map_or(Vec::new(), |side| HalfPlane::square(side).to_vec())
}

/// The largest force, N, without its sign.
fn hardest(links: &[Link]) -> f64 {
    links.iter().map(|link| link.push.abs()).filter(|push| push.is_finite()).fold(0.0, f64::max)
}

/// Width of the widest line, m.
fn widest(frame: &Frame) -> f64 {
    let mut radii: Vec<f64> = frame.rows.iter().map(|row| row.radius).collect();
    radii.sort_by(f64::total_cmp);
    let typical = radii.get(radii.len() / 2).copied().unwrap_or(0.0);
    let shown = frame::view(frame).width;
    typical.clamp(WIDEST.start() * shown, WIDEST.end() * shown)
}

fn title(frame: &Frame, links: &[Link]) -> String {
    let most = match hardest(links) {
        0.0 => String::new(),
        push => format!(", the largest force {} N", typographic(push, 3)),
    };
    let contacts = match links.len() {
        0 => "no contacts".to_owned(),
        n => counted(n, "contact"),
    };
    format!("{}{contacts}{most}{}", frame::time(frame), left_out(frame, frame::view(frame)))
}

/// The lines with their widths, m; the weaker ones first, so that they hide nothing.
fn lines(frame: &Frame, links: &[Link]) -> Vec<(Stroke, f64)> {
    let (hardest, widest) = (hardest(links), widest(frame));
    let mut links: Vec<&Link> = links.iter().filter(|link| link.push.is_finite()).collect();
    links.sort_by(|a, b| a.push.abs().total_cmp(&b.push.abs()));
    let line = |link: &Link| {
        let colour = if link.push < 0.0 { PULL } else { PUSH };
        let width = if hardest > 0.0 { widest * link.push.abs() / hardest } else { 0.0 };
        (Stroke { from: link.from, to: link.to, colour }, width)
    };
    links.into_iter().map(line).collect()
}

/// The picture of a frame's contact forces.
pub fn figure(frame: &Frame, links: &[Link]) -> Figure {
    let mut scene = Scene::new(title(frame, links), frame::view(frame), frame.side);
    scene.discs = frame::plain_discs(frame, FILL);
    scene.edge = EDGE;
    scene.lines = lines(frame, links);
    let most = typographic(hardest(links), 3);
    if links.iter().any(|link| link.push >= 0.0) {
        scene.legend.push((hex(PUSH), format!("push, width by force (full: {most} N)")));
    }
    if links.iter().any(|link| link.push < 0.0) {
        scene.legend.push((hex(PULL), "pull (dashpot)".to_owned()));
    }
    Figure::of_scene(scene)
}

/// The script that draws [`figure`], with the numbers in it: discs, and the lines as thin
/// rectangles, so that their widths are to scale.
pub fn script(stem: &str, frame: &Frame, links: &[Link]) -> String {
    let size = figure(frame, links).panel;
    let mut text = gnuplot::head(stem, "Contact forces", size, "png pdf");
    let row =
        |row: &FrameRow| format!("{:e} {:e} {:e}", row.position.x, row.position.y, row.radius);
    text += &gnuplot::block("discs", frame.rows.iter().map(row));
    let lines = lines(frame, links);
    for (name, colour) in [("push", PUSH), ("pull", PULL)] {
        let same = lines.iter().filter(|(line, _)| line.colour == colour);
        text += &gnuplot::block(name, same.map(|(line, width)| rectangle(line, *width)));
    }
    text += &gnuplot::ground(frame::view(frame), frame.side);
    let [fill, edge, push, pull] = [FILL, EDGE, PUSH, PULL].map(hex);
    let legend = "set key above horizontal ; set style fill solid noborder";
    let mut curves = vec![format!(
        "$discs using 1:2:3 with circles fc rgb '{fill}' fs solid border lc rgb '{edge}' notitle"
    )];
    for (name, colour, what) in [("push", push, "push"), ("pull", pull, "pull (dashpot)")] {
        let there = lines.iter().any(|(line, _)| (line.colour == PUSH) == (name == "push"));
        if there {
            curves.push(format!(
                "${name} using 1:2 with filledcurves closed fc rgb '{colour}' title '{what}'"
            ));
        }
    }
    let title = gnuplot::quoted(&title(frame, links));
    text + &format!("{legend}\nset title {title} noenhanced\nplot {}\n", curves.join(", \\\n    "))
}

/// The corners of a line of some width, m, and a blank line.
fn rectangle(line: &Stroke, width: f64) -> String {
    let along = (line.to - line.from).normalize_or_zero();
    let aside = 0.5 * width * along.perp();
    [line.from + aside, line.to + aside, line.to - aside, line.from - aside]
        .map(|corner| format!("{:e} {:e}\n", corner.x, corner.y))
        .concat()
}
