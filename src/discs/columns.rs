//! What is remembered of the discs from step to step beside the particles: named columns, listed once.
//!
//! Snapshots, restore points, the arrays of a checkpoint and their reading, and the order in which discs are stored all
//! follow from the one list below: a new column is one entry in it (and, if it has a type of its own, how that is
//! written as numbers).

mod array;
mod row;
mod table;
mod view;

use glam::DVec2;

pub use self::array::{Array, rows, take};
pub use self::row::Row;
pub(crate) use self::row::row_of_numbers;
use self::table::columns;
pub use self::view::ArrayView;
use super::overlaps::Overlaps;
use crate::particle::Particle;
use crate::work::{Account, Channel, Share, Sum, Works};

columns! {
    /// The columns beside the particles.
    Columns,
    /// The same, looked at where they lie.
    ColumnsView;
    one {
        /// Largest overlaps so far.
        overlaps: Overlaps,
        /// Energies booked since the ledger was opened, J.
        works: Works,
        /// Energy stored at walls, in pairs, and by added forces, J, where it is added up with the forces.
        stored: [f64; 3],
        /// The skin of the present list of near pairs, m, and the square of how far a disc may move before there is a new
        /// one, m2.
        list: [f64; 2],
        /// When the present forces were added up, and when the present list was made, s; for what moves by itself.
        times: [f64; 2],
    }
    each {
        /// The discs' ids; empty if they are stored in id order.
        ids: u32,
        /// Which kind each disc is of; empty where kinds are not told apart.
        kinds: u32,
        /// The springs' part of the force on each disc, N; empty without ledger, and where `shares` are kept.
        springs: DVec2,
        /// What springs and dashpots do to each disc; empty without ledger, and where `springs` are kept.
        shares: Share,
        /// Where each disc was when the present list of near pairs was made, m.
        reference_positions: DVec2,
    }
    own {
        /// Pairs that remember something: their ids, the lower first; ascending.
        pair_ids: [u32; 2],
        /// What each of them remembers.
        pair_memory: f64,
    }
}

impl Columns {
    /// Whether the columns of `n` discs fit each other.
    ///
    /// # Errors
    ///
    /// Names the array that does not fit.
    pub fn check(&self, n: usize) -> Result<(), String> {
        if !self.ids.is_empty() && !is_permutation(&self.ids) {
            return Err(format!("array ids: the numbers from 0 to {} are wanted", n - 1));
        }
        if self.reference_positions.len() != self.ids.len() {
            return Err(
                "array reference_positions: it is wanted where there are ids, and only there"
                    .into(),
            );
        }
        Ok(())
    }
}

/// Whether `ids` has every number below its length once.
fn is_permutation(ids: &[u32]) -> bool {
    let mut is_there = vec![false; ids.len()];
    ids.iter().all(|id| match is_there.get_mut(*id as usize) {
        Some(there) => !std::mem::replace(there, true),
        None => false,
    })
}

/// Whether there is an array of this name.
fn has(arrays: &[(String, Array)], name: &str) -> bool {
    arrays.iter().any(|(of, _)| of == name)
}

fn copy<T: Copy>(to: &mut Vec<T>, from: &[T]) {
    to.clear();
    to.extend_from_slice(from);
}

row_of_numbers!(
    Particle,
    8,
    |p| {
        let (x, v, f) = (p.position, p.velocity, p.force);
        [x.x, x.y, v.x, v.y, f.x, f.y, p.radius, p.mass]
    },
    |[x, y, vx, vy, fx, fy, radius, mass]| Particle {
        position: DVec2::new(x, y),
        velocity: DVec2::new(vx, vy),
        force: DVec2::new(fx, fy),
        radius,
        mass,
    }
);
row_of_numbers!(
    Share,
    4,
    |share| [share.spring.x, share.spring.y, share.dashpot.x, share.dashpot.y],
    |[sx, sy, dx, dy]| Share { spring: DVec2::new(sx, sy), dashpot: DVec2::new(dx, dy) }
);
row_of_numbers!(
    Overlaps,
    3,
    |all| [all.largest_pair_overlap, all.largest_sinking, all.largest_wall_overlap],
    |[largest_pair_overlap, largest_sinking, largest_wall_overlap]| Overlaps {
        largest_pair_overlap,
        largest_sinking,
        largest_wall_overlap,
    }
);
row_of_numbers!(
    Works,
    4 * Channel::ALL.len(),
    |works| {
        let sums = |account: Account| [account.work, account.beside].map(|s| [s.value, s.carry]);
        let words = Channel::ALL.map(|channel| sums(works[channel]));
        std::array::from_fn(|k| words[k / 4][k / 2 % 2][k % 2])
    },
    |numbers| {
        let mut works = Works::default();
        for (channel, n) in Channel::ALL.into_iter().zip(numbers.chunks_exact(4)) {
            let [work, beside] =
                [[n[0], n[1]], [n[2], n[3]]].map(|[value, carry]| Sum { value, carry });
            works[channel] = Account { work, beside };
        }
        works
    }
);

#[cfg(test)]
mod tests {
    use super::*;

    columns! {
        /// Columns of every kind.
        Some_, SomeView;
        one {
            /// A number.
            charge: f64,
        }
        each {
            /// Kinds.
            kinds: u32,
            /// Spins.
            spins: [f64; 3],
        }
        own {
            /// Pairs that remember.
            pairs: [u32; 2],
            /// What.
            stretches: f64,
        }
    }

    fn some() -> Some_ {
        Some_ {
            charge: 0.1,
            kinds: vec![3, 1, 2],
            spins: Vec::new(),
            pairs: vec![[0, 2], [1, 2]],
            stretches: vec![1e-9, -2e-9],
        }
    }

    fn named(some: &Some_) -> Vec<(String, Array)> {
        let arrays = some.view().arrays().into_iter();
        arrays.map(|(name, array)| (name.to_owned(), array.to_array())).collect()
    }

    #[test]
    fn a_column_named_once_is_written_read_and_copied_with_every_bit() {
        let there = named(&some());
        let names: Vec<&str> = there.iter().map(|(name, _)| name.as_str()).collect();
        assert_eq!(names, ["charge", "kinds", "pairs", "stretches"]); // none is empty
        let back = Some_::from_arrays(3, &mut there.clone()).unwrap();
        assert_eq!(named(&back), there);
        let mut copy = Some_ { spins: vec![[0.0; 3]; 3], ..Some_::default() };
        copy.copy_from(some().view(), &["kinds", "spins"]);
        assert!(copy.kinds.is_empty() && copy.spins.len() == 3);
        copy.copy_from(some().view(), &[]);
        assert_eq!(named(&copy), there);
    }

    #[test]
    fn what_lies_beside_a_disc_goes_where_it_goes() {
        let mut some = some();
        some.swap(0, 2);
        assert_eq!(some.kinds, [2, 1, 3]);
        assert_eq!(some.pairs, [[0, 2], [1, 2]]); // named by ids, not by places
    }

    #[test]
    fn columns_that_do_not_fit_are_refused_by_name() {
        let mut spoilt = named(&some());
        let refused = |arrays: &[(String, Array)]| {
            Some_::from_arrays(3, &mut arrays.to_vec()).map(|_| ()).unwrap_err()
        };
        spoilt[1].1 = Array::Counts(vec![1, 2]);
        assert_eq!(refused(&spoilt), "array kinds: it has 2, 3 counts are wanted");
        spoilt[1].1 = Array::Counts(vec![1, 2, 1 << 32]);
        assert_eq!(refused(&spoilt), "array kinds: row 2 is out of range");
        spoilt[1].1 = Array::Numbers(vec![1.0; 3]);
        assert_eq!(refused(&spoilt), "array kinds: 3 counts are wanted, there are none");
        spoilt.remove(1);
        spoilt[1].1 = Array::Counts(vec![1, 2, 3]);
        assert_eq!(refused(&spoilt), "array pairs: it has 3, 2 counts a row are wanted");
        spoilt.remove(0);
        assert_eq!(refused(&spoilt), "array charge: 1 numbers are wanted, there are none");
    }
}
