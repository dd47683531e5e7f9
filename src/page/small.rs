//! Pictures of half the width of a sheet: what must be larger to be seen there, and what is left out.

use maud::Markup;

use super::html::figure;
use super::words::Words;
use crate::figure::frame::LONGEST_ARROW;
use crate::figure::scene::Scene;
use crate::figure::{Figure, Panel};

/// A chart and a picture of discs of half the width of a sheet, pixels: their text is of 8 points there.
const CHART: (f64, f64) = (460.0, 310.0);
const SCENE: (f64, f64) = (460.0, 382.0);
/// So many discs or fewer may be drawn larger than they are, with longer arrows.
const FEW: usize = 200;
/// The least radius of such discs, as a fraction of what is shown.
const LEAST_RADIUS: f64 = 0.005;
/// More arrows than this on half a sheet are a smear.
const MOST_ARROWS: usize = 2000;

/// The panels of a figure, each as number `k` of the page.
pub fn panels(k: usize, figure: &Figure, caption: &str, words: &Words) -> Vec<Markup> {
    figure.panels.iter().map(|panel| self::panel(k, panel, caption, words)).collect()
}

/// A velocity field as number `k` of the page: fewer arrows if there are many, longer ones if there are few.
pub fn field(k: usize, figure: &Figure, words: &Words) -> Vec<Markup> {
    let mut figure = figure.clone();
    let longest = (100.0 * stretched(&mut figure) * LONGEST_ARROW).round().to_string();
    let mut caption = words.velocity_caption.replace("{}", &longest);
    let step = thinned(&mut figure);
    if step > 1 {
        caption += " ";
        caption += &words.fewer_arrows.replace("{}", &step.to_string());
    }
    panels(k, &figure, &caption, words)
}

/// A panel of half the width of a sheet. Its title goes into the caption, which wraps.
pub fn panel(k: usize, panel: &Panel, caption: &str, words: &Words) -> Markup {
    let mut panel = panel.clone();
    let mut caption = caption.to_owned();
    let (size, title) = match &mut panel {
        Panel::Chart(chart) => (CHART, &mut chart.title),
        Panel::Scene(scene) => {
            if enlarged(scene) {
                caption = format!("{caption} {}", words.enlarged);
            }
            (SCENE, &mut scene.title)
        }
    };
    if !title.is_empty() {
        caption = format!("{}. {caption}", std::mem::take(title));
    }
    let small = Figure { panels: vec![panel], columns: 1, panel: size, strip: None };
    figure(k, &small.to_svg(), &caption)
}

/// Makes discs larger that would be lost on paper; says whether there are such.
fn enlarged(scene: &mut Scene) -> bool {
    let least = LEAST_RADIUS * scene.view.width;
    let are_few = scene.discs.len() <= FEW;
    let small = scene.discs.iter_mut().filter(|disc| are_few && disc.radius < least);
    small.map(|disc| disc.radius = least).count() > 0
}

/// Leaves so many arrows as can be told apart, every so-manieth, and says which.
fn thinned(figure: &mut Figure) -> usize {
    let mut step = 1;
    for panel in &mut figure.panels {
        if let Panel::Scene(scene) = panel {
            step = scene.arrows.len().div_ceil(MOST_ARROWS).max(1);
            scene.arrows = scene.arrows.iter().step_by(step).copied().collect();
        }
    }
    step
}

/// Makes the arrows of few discs longer, and says how many times.
fn stretched(figure: &mut Figure) -> f64 {
    const STRETCH: f64 = 2.0;
    for panel in &mut figure.panels {
        if let Panel::Scene(scene) = panel {
            if scene.discs.len() > FEW {
                return 1.0;
            }
            for arrow in &mut scene.arrows {
                arrow.to = arrow.from + STRETCH * (arrow.to - arrow.from);
            }
        }
    }
    STRETCH
}
