//! Four numbers in one register, on processors of 2013 and later (AVX2).
//!
//! The one place where the compiler cannot see that the processor has what it is asked to do:
//! [`Four`] can only be had from [`Four::on_this_processor`] or from another, so who has one may use it.
#![allow(unsafe_code)]

use std::arch::x86_64::*;
use std::marker::PhantomData;
use std::ops::{Add, Div, Mul, Sub};

use super::group;
use super::lanes::Lanes;

/// What a processor has, at least AVX2.
pub trait Processor: Copy {
    /// The numbers that contacts are worked out in.
    type Group: group::Group;
    /// Whether this processor has it.
    fn is_here() -> bool;
    /// Does `work`, which is compiled for it where it is inlined.
    ///
    /// # Safety
    ///
    /// It is here.
    unsafe fn run<R>(work: impl FnOnce() -> R) -> R;
    /// The same in a function of its own.
    ///
    /// # Safety
    ///
    /// It is here.
    unsafe fn apart(work: impl FnOnce());
    /// Zeros.
    fn group(zero: Four<Self>) -> Self::Group;
}

/// A processor with AVX2.
#[derive(Clone, Copy)]
pub struct Avx2;

impl Processor for Avx2 {
    type Group = Four<Self>;
    fn is_here() -> bool {
        std::is_x86_feature_detected!("avx2")
    }
    #[inline(always)]
    unsafe fn run<R>(work: impl FnOnce() -> R) -> R {
        #[target_feature(enable = "avx2")]
        unsafe fn with_avx2<R>(work: impl FnOnce() -> R) -> R {
            work()
        }
        // SAFETY: promised by the caller.
        unsafe { with_avx2(work) }
    }
    #[inline(always)]
    unsafe fn apart(work: impl FnOnce()) {
        #[inline(never)]
        #[target_feature(enable = "avx2")]
        unsafe fn apart_with_avx2(work: impl FnOnce()) {
            work();
        }
        // SAFETY: promised by the caller.
        unsafe { apart_with_avx2(work) }
    }
    #[inline(always)]
    fn group(zero: Four<Self>) -> Four<Self> {
        zero
    }
}

/// Four numbers, on such a processor.
#[derive(Clone, Copy)]
pub struct Four<P>(__m256d, PhantomData<P>);

impl<P: Processor> Four<P> {
    /// Four zeros, if this processor is one.
    pub fn on_this_processor() -> Option<Self> {
        // SAFETY: made only if the processor has AVX2, of which AVX is a part.
        P::is_here().then(|| Self::with(unsafe { _mm256_setzero_pd() }))
    }

    /// Does `work`, which is compiled for the processor where it is inlined.
    #[inline(always)]
    pub fn run<R>(self, work: impl FnOnce() -> R) -> R {
        // SAFETY: `self` is there, so the processor is here.
        unsafe { P::run(work) }
    }

    #[inline(always)]
    fn with(numbers: __m256d) -> Self {
        Self(numbers, PhantomData)
    }
}

macro_rules! operators {
    ($($trait:ident $name:ident $intrinsic:ident),*) => {$(
        impl<P: Processor> $trait for Four<P> {
            type Output = Self;
            #[inline(always)]
            fn $name(self, other: Self) -> Self {
                // SAFETY: `self` is there, so the processor has AVX2.
                Self::with(unsafe { $intrinsic(self.0, other.0) })
            }
        }
    )*};
}
operators!(Add add _mm256_add_pd, Sub sub _mm256_sub_pd, Mul mul _mm256_mul_pd, Div div _mm256_div_pd);

// SAFETY, of every `unsafe` below: `self` is there, so the processor has AVX2; memory is touched only in
// `of`, `put` and `to_array`, which read and write the four numbers of an array.
impl<P: Processor> Lanes for Four<P> {
    type Group = P::Group;
    #[inline(always)]
    fn group(self) -> P::Group {
        P::group(self)
    }
    #[inline(always)]
    fn apart(self, work: impl FnOnce()) {
        // SAFETY: `self` is there, so the processor is here.
        unsafe { P::apart(work) }
    }
    #[inline(always)]
    fn of(self, numbers: [f64; 4]) -> Self {
        Self::with(unsafe { _mm256_loadu_pd(numbers.as_ptr()) })
    }
    #[inline(always)]
    fn put(self, there: &mut [f64; 4]) {
        unsafe { _mm256_storeu_pd(there.as_mut_ptr(), self.0) };
    }
    #[inline(always)]
    fn to_array(self) -> [f64; 4] {
        let mut numbers = [0.0; 4];
        unsafe { _mm256_storeu_pd(numbers.as_mut_ptr(), self.0) };
        numbers
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self::with(unsafe { _mm256_sqrt_pd(self.0) })
    }
    #[inline(always)]
    fn greater(self, other: Self) -> Self {
        Self::with(unsafe { _mm256_max_pd(self.0, other.0) })
    }
    #[inline(always)]
    fn negated(self) -> Self {
        Self::with(unsafe { _mm256_xor_pd(self.0, self.all(-0.0).0) })
    }
    #[inline(always)]
    fn neighbours_exchanged(self) -> Self {
        Self::with(unsafe { _mm256_permute_pd::<0b0101>(self.0) })
    }
    #[inline(always)]
    fn is_less(self, other: Self) -> Self {
        Self::with(unsafe { _mm256_cmp_pd::<_CMP_LT_OQ>(self.0, other.0) })
    }
    #[inline(always)]
    fn where_all(self, mask: Self) -> Self {
        Self::with(unsafe { _mm256_and_pd(self.0, mask.0) })
    }
    #[inline(always)]
    fn or_where(self, other: Self) -> Self {
        Self::with(unsafe { _mm256_or_pd(self.0, other.0) })
    }
    #[inline(always)]
    fn has_any(self) -> bool {
        (unsafe { _mm256_movemask_pd(self.0) }) != 0
    }
    #[inline(always)]
    fn transposed([a, b, c, d]: [Self; 4]) -> [Self; 4] {
        unsafe {
            let (ab, cd) = (_mm256_unpacklo_pd(a.0, b.0), _mm256_unpacklo_pd(c.0, d.0));
            let (ba, dc) = (_mm256_unpackhi_pd(a.0, b.0), _mm256_unpackhi_pd(c.0, d.0));
            [
                Self::with(_mm256_permute2f128_pd::<0x20>(ab, cd)),
                Self::with(_mm256_permute2f128_pd::<0x20>(ba, dc)),
                Self::with(_mm256_permute2f128_pd::<0x31>(ab, cd)),
                Self::with(_mm256_permute2f128_pd::<0x31>(ba, dc)),
            ]
        }
    }
    #[inline(always)]
    fn halves_exchanged(a: Self, b: Self) -> [Self; 2] {
        unsafe {
            let low = Self::with(_mm256_permute2f128_pd::<0x20>(a.0, b.0));
            [low, Self::with(_mm256_permute2f128_pd::<0x31>(a.0, b.0))]
        }
    }
    #[inline(always)]
    fn both_sides(x: Self, y: Self) -> [Self; 4] {
        unsafe {
            let (low, high) = (_mm256_unpacklo_pd(x.0, y.0), _mm256_unpackhi_pd(x.0, y.0));
            let (minus_low, minus_high) =
                (Self::with(low).negated().0, Self::with(high).negated().0);
            [
                Self::with(_mm256_permute2f128_pd::<0x20>(minus_low, low)),
                Self::with(_mm256_permute2f128_pd::<0x20>(minus_high, high)),
                Self::with(_mm256_permute2f128_pd::<0x31>(minus_low, low)),
                Self::with(_mm256_permute2f128_pd::<0x31>(minus_high, high)),
            ]
        }
    }
}
