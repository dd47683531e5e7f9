//! Values found by numbers that a neighbour list names, without asking each time whether they are there.
//!
//! A step looks up eight discs and twelve forces for every four pairs. The list is made once in tens
//! of steps and keeps its numbers in bounds.
#![allow(unsafe_code)]

/// Values with a promise that only numbers below their length are asked for.
#[derive(Clone, Copy)]
pub(super) struct Lookup<'a, T>(&'a [T]);

impl<'a, T> Lookup<'a, T> {
    /// `values`, of which those up to `end` will be asked for. Panics if there are fewer.
    ///
    /// # Safety
    ///
    /// No number from `end` on may be asked for.
    #[inline(always)]
    pub unsafe fn new(values: &'a [T], end: usize) -> Self {
        assert!(end <= values.len(), "a list names {end} values of {}", values.len());
        Self(values)
    }

    /// The sides of `pairs`, two of each, of which those up to `end` will be asked for. Panics if there are fewer.
    ///
    /// # Safety
    ///
    /// No number from `end` on may be asked for; `B` and `T` are nothing but numbers.
    #[inline(always)]
    pub unsafe fn sides<B>(pairs: &'a [B], end: usize) -> Self {
        const { assert!(size_of::<B>() == 2 * size_of::<T>(), "a pair is two sides and nothing else") }
        // SAFETY: a pair is an array of numbers as long as two values, themselves arrays of numbers, so pairs that follow
        // each other are twice as many values that do.
        let sides = unsafe { std::slice::from_raw_parts(pairs.as_ptr().cast(), 2 * pairs.len()) };
        // SAFETY: promised by the caller.
        unsafe { Self::new(sides, end) }
    }

    /// The value of this number.
    #[inline(always)]
    pub fn at(&self, number: u16) -> &'a T {
        debug_assert!(usize::from(number) < self.0.len());
        // SAFETY: who made this promised that the number is below `end`, and `new` has looked at that.
        unsafe { self.0.get_unchecked(usize::from(number)) }
    }
}
