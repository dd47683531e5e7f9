//! Two contacts at a time: [`Contact::between`] in two lanes.
//!
//! The arithmetic is that of `Contact::between`, operation by operation, so the bits are the same
//! (IEEE 754 says what each must give, one at a time or two); a test holds one against the other. What
//! differs is that nothing branches on which of two pairs touch: in a bed most of them do, but not all, and a
//! processor that guesses wrong loses more time than the contact costs.

use glam::DVec2;
use wide::{CmpGt, CmpLt, f64x2};

use super::lane_law::{ContactLanes, LaneLaw};
use super::push::{Kept, Largest};
use crate::particle::Particle;

/// The forces on discs `b` of their contacts with discs `a`, lane by lane, N: the whole and, where that
/// is kept, the springs' share. Nothing for discs that do not touch.
#[inline(always)]
pub(super) fn forces<L: LaneLaw, K: Kept>(
    law: &L,
    a: [&Particle; 2],
    b: [&Particle; 2],
    largest: &mut Largest,
) -> ([f64x2; 2], [f64x2; 2]) {
    let separation = |k: usize| vector(b[k].position) - vector(a[k].position);
    let (x, y) = transposed(separation(0), separation(1));
    let [radius, other_radius] = [a, b].map(|[one, two]| f64x2::new([one.radius, two.radius]));
    let reach = radius + other_radius;

    let distance_squared = x * x + y * y;
    let touch = distance_squared.cmp_lt(reach * reach);
    if touch.move_mask() == 0 {
        return ([f64x2::ZERO; 2], [f64x2::ZERO; 2]); // most pairs of a gas; few of a bed
    }
    let velocity = |k: usize| vector(a[k].velocity) - vector(b[k].velocity);
    let (vx, vy) = transposed(velocity(0), velocity(1));
    let distance = distance_squared.sqrt();
    let has_direction = distance.cmp_gt(f64x2::ZERO);
    let normal_x = has_direction.blend(x / distance, f64x2::ONE);
    let normal_y = has_direction & (y / distance);
    let overlap = reach - distance;
    let approach_speed = vx * normal_x + vy * normal_y;
    let contacts = ContactLanes { overlap, approach_speed, discs: [a, b] };

    let notable = f64x2::splat(largest.notable) * radius.fast_min(other_radius);
    if (touch & overlap).cmp_gt(notable).move_mask() != 0 {
        let overlaps = (touch & overlap).to_array();
        (0..2).for_each(|k| largest.note(overlaps[k], a[k].radius, b[k].radius));
    }
    let along_normal = |size: f64x2| {
        let (first, second) = transposed(touch & (size * normal_x), touch & (size * normal_y));
        [first, second]
    };
    let springs =
        if K::HAS_SPRING { along_normal(law.springs(&contacts)) } else { [f64x2::ZERO; 2] };
    (along_normal(law.pushes(&contacts)), springs)
}

#[inline(always)]
fn vector(v: DVec2) -> f64x2 {
    f64x2::new(v.to_array())
}

/// (a0, a1), (b0, b1) as (a0, b0), (a1, b1).
#[inline(always)]
fn transposed(a: f64x2, b: f64x2) -> (f64x2, f64x2) {
    let ([a0, a1], [b0, b1]) = (a.to_array(), b.to_array());
    (f64x2::new([a0, b0]), f64x2::new([a1, b1]))
}
