//! Values found by numbers that a neighbour list names, without asking each time whether they are there.
//!
//! A step looks up eight discs and twelve forces for every four pairs. The list is made once in tens
//! of steps and keeps its numbers in bounds.
#![allow(unsafe_code)]

/// Values with a promise that only numbers below their length are asked for.
#[derive(Clone, Copy)]
pub struct Lookup<'a, T>(&'a [T]);

/// A number, as bytes from the first value on: what a processor adds to an address.
#[derive(Clone, Copy, Default)]
pub struct Offset(u32);

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

    /// Where the value of this number begins.
    #[inline(always)]
    pub fn offset(number: u16) -> Offset {
        Offset(u32::from(number) * size_of::<T>() as u32)
    }

    /// The value there; what was said of numbers holds for what offsets were made of.
    #[inline(always)]
    pub fn after(&self, Offset(bytes): Offset) -> &'a T {
        debug_assert!((bytes as usize) < size_of_val(self.0));
        // SAFETY: as in `at`; an offset is made of a number by `offset` alone.
        unsafe { &*self.0.as_ptr().byte_add(bytes as usize) }
    }

    /// The value of this number.
    #[inline(always)]
    pub fn at(&self, number: u16) -> &'a T {
        debug_assert!(usize::from(number) < self.0.len());
        // SAFETY: who made this promised that the number is below `end`, and `new` has looked at that.
        unsafe { self.0.get_unchecked(usize::from(number)) }
    }
}
