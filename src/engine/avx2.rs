//! Four numbers in one register, on processors of 2013 and later (AVX2).
//!
//! The one place where the compiler cannot see that the processor has what it is asked to do:
//! [`Four`] can only be had from [`Four::on_this_processor`] or from another, so who has one may use it.
#![allow(unsafe_code)]

use std::arch::x86_64::*;
use std::ops::{Add, Div, Mul, Sub};

use super::lanes::Lanes;

/// Four numbers, on a processor with AVX2.
#[derive(Clone, Copy)]
pub struct Four(__m256d);

impl Four {
    /// Four zeros, if this processor has AVX2.
    pub fn on_this_processor() -> Option<Self> {
        // SAFETY: made only if the processor has AVX2, of which AVX is a part.
        std::is_x86_feature_detected!("avx2").then(|| Self(unsafe { _mm256_setzero_pd() }))
    }

    /// Does `work`, which is compiled for AVX2 where it is inlined.
    #[inline(always)]
    pub fn run<R>(self, work: impl FnOnce() -> R) -> R {
        #[target_feature(enable = "avx2")]
        unsafe fn with_avx2<R>(work: impl FnOnce() -> R) -> R {
            work()
        }
        // SAFETY: `self` is there, so the processor has AVX2.
        unsafe { with_avx2(work) }
    }
}

macro_rules! operators {
    ($($trait:ident $name:ident $intrinsic:ident),*) => {$(
        impl $trait for Four {
            type Output = Self;
            #[inline(always)]
            fn $name(self, other: Self) -> Self {
                // SAFETY: `self` is there, so the processor has AVX2.
                Self(unsafe { $intrinsic(self.0, other.0) })
            }
        }
    )*};
}
operators!(Add add _mm256_add_pd, Sub sub _mm256_sub_pd, Mul mul _mm256_mul_pd, Div div _mm256_div_pd);

// SAFETY, of every `unsafe` below: `self` is there, so the processor has AVX2; memory is touched only in
// `of`, `put` and `to_array`, which read and write the four numbers of an array.
impl Lanes for Four {
    #[inline(always)]
    fn apart(self, work: impl FnOnce()) {
        #[inline(never)]
        #[target_feature(enable = "avx2")]
        fn with_avx2(work: impl FnOnce()) {
            work();
        }
        // SAFETY: `self` is there, so the processor has AVX2.
        unsafe { with_avx2(work) }
    }
    #[inline(always)]
    fn of(self, numbers: [f64; 4]) -> Self {
        Self(unsafe { _mm256_loadu_pd(numbers.as_ptr()) })
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
        Self(unsafe { _mm256_sqrt_pd(self.0) })
    }
    #[inline(always)]
    fn or_zero(self) -> Self {
        self.where_all(self.all(0.0).is_less(self))
    }
    #[inline(always)]
    fn lesser(self, other: Self) -> Self {
        Self(unsafe { _mm256_min_pd(self.0, other.0) })
    }
    #[inline(always)]
    fn greater(self, other: Self) -> Self {
        Self(unsafe { _mm256_max_pd(self.0, other.0) })
    }
    #[inline(always)]
    fn negated(self) -> Self {
        Self(unsafe { _mm256_xor_pd(self.0, self.all(-0.0).0) })
    }
    #[inline(always)]
    fn neighbours_exchanged(self) -> Self {
        Self(unsafe { _mm256_permute_pd::<0b0101>(self.0) })
    }
    #[inline(always)]
    fn is_less(self, other: Self) -> Self {
        Self(unsafe { _mm256_cmp_pd::<_CMP_LT_OQ>(self.0, other.0) })
    }
    #[inline(always)]
    fn where_all(self, mask: Self) -> Self {
        Self(unsafe { _mm256_and_pd(self.0, mask.0) })
    }
    #[inline(always)]
    fn or_else(self, mask: Self, other: Self) -> Self {
        Self(unsafe { _mm256_blendv_pd(other.0, self.0, mask.0) })
    }
    #[inline(always)]
    fn or_where(self, other: Self) -> Self {
        Self(unsafe { _mm256_or_pd(self.0, other.0) })
    }
    #[inline(always)]
    fn is_any(self) -> bool {
        (unsafe { _mm256_movemask_pd(self.0) }) != 0
    }
    #[inline(always)]
    fn transposed([a, b, c, d]: [Self; 4]) -> [Self; 4] {
        unsafe {
            let (ab, cd) = (_mm256_unpacklo_pd(a.0, b.0), _mm256_unpacklo_pd(c.0, d.0));
            let (ba, dc) = (_mm256_unpackhi_pd(a.0, b.0), _mm256_unpackhi_pd(c.0, d.0));
            [
                Self(_mm256_permute2f128_pd::<0x20>(ab, cd)),
                Self(_mm256_permute2f128_pd::<0x20>(ba, dc)),
                Self(_mm256_permute2f128_pd::<0x31>(ab, cd)),
                Self(_mm256_permute2f128_pd::<0x31>(ba, dc)),
            ]
        }
    }
    #[inline(always)]
    fn halves_exchanged(a: Self, b: Self) -> [Self; 2] {
        unsafe {
            let low = Self(_mm256_permute2f128_pd::<0x20>(a.0, b.0));
            [low, Self(_mm256_permute2f128_pd::<0x31>(a.0, b.0))]
        }
    }
    #[inline(always)]
    fn both_sides(x: Self, y: Self) -> [Self; 4] {
        unsafe {
            let (low, high) = (_mm256_unpacklo_pd(x.0, y.0), _mm256_unpackhi_pd(x.0, y.0));
            let (minus_low, minus_high) = (Self(low).negated().0, Self(high).negated().0);
            [
                Self(_mm256_permute2f128_pd::<0x20>(minus_low, low)),
                Self(_mm256_permute2f128_pd::<0x20>(minus_high, high)),
                Self(_mm256_permute2f128_pd::<0x31>(minus_low, low)),
                Self(_mm256_permute2f128_pd::<0x31>(minus_high, high)),
            ]
        }
    }
}
