//! Eight numbers in one register, on processors with AVX-512.
//!
//! As in [`avx2`](super::avx2): [`Eight`] can only be had where the processor was found to have it.
#![allow(unsafe_code)]
// Built only where the compiler has them: see `build.rs`.
#![allow(clippy::incompatible_msrv)]

use std::arch::x86_64::*;
use std::ops::{Add, Div, Mul, Sub};

use super::avx2::{Four, Processor};
use super::both::Both;
use super::group::Group;
use super::lookup::{Lookup, Offset};
use super::phase::Phase;

/// A processor with AVX-512: registers of eight numbers, masks, and the same for shorter registers.
#[derive(Clone, Copy)]
pub struct Avx512;

impl Processor for Avx512 {
    type Group = Eight;
    fn is_here() -> bool {
        std::is_x86_feature_detected!("avx2")
            && std::is_x86_feature_detected!("avx512f")
            && std::is_x86_feature_detected!("avx512vl")
            && std::is_x86_feature_detected!("avx512dq")
            && std::is_x86_feature_detected!("avx512bw")
    }
    #[inline(always)]
    unsafe fn run<R>(work: impl FnOnce() -> R) -> R {
        #[target_feature(enable = "avx2,avx512f,avx512vl,avx512dq,avx512bw")]
        unsafe fn with_avx512<R>(work: impl FnOnce() -> R) -> R {
            work()
        }
        // SAFETY: promised by the caller.
        unsafe { with_avx512(work) }
    }
    #[inline(always)]
    unsafe fn apart(work: impl FnOnce()) {
        #[inline(never)]
        #[target_feature(enable = "avx2,avx512f,avx512vl,avx512dq,avx512bw")]
        unsafe fn apart_with_avx512(work: impl FnOnce()) {
            work();
        }
        // SAFETY: promised by the caller.
        unsafe { apart_with_avx512(work) }
    }
    #[inline(always)]
    fn group(_zero: Four<Self>) -> Eight {
        // SAFETY: who has a `Four` of this processor has the processor.
        Eight(unsafe { _mm512_setzero_pd() })
    }
}

/// Eight numbers, on such a processor.
#[derive(Clone, Copy)]
pub struct Eight(__m512d);

macro_rules! operators {
    ($($trait:ident $name:ident $intrinsic:ident),*) => {$(
        impl $trait for Eight {
            type Output = Self;
            #[inline(always)]
            fn $name(self, other: Self) -> Self {
                // SAFETY: `self` is there, so the processor has AVX-512.
                Self(unsafe { $intrinsic(self.0, other.0) })
            }
        }
    )*};
}
operators!(Add add _mm512_add_pd, Sub sub _mm512_sub_pd, Mul mul _mm512_mul_pd, Div div _mm512_div_pd);

// SAFETY, of every `unsafe` below: `self` is there, so the processor has AVX-512; memory is touched only through
// slices that were asked for their length.
impl Group for Eight {
    const PAIRS: usize = 8;
    type Mask = __mmask8;

    #[inline(always)]
    fn load(self, numbers: &[f64]) -> Self {
        Self(unsafe { _mm512_loadu_pd(numbers[..8].as_ptr()) })
    }
    #[inline(always)]
    fn store(self, there: &mut [f64]) {
        unsafe { _mm512_storeu_pd(there[..8].as_mut_ptr(), self.0) };
    }
    #[inline(always)]
    fn all(self, number: f64) -> Self {
        Self(unsafe { _mm512_set1_pd(number) })
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(unsafe { _mm512_sqrt_pd(self.0) })
    }
    #[inline(always)]
    fn negated(self) -> Self {
        Self(unsafe { _mm512_xor_pd(self.0, _mm512_set1_pd(-0.0)) })
    }
    #[inline(always)]
    fn none(self) -> __mmask8 {
        0
    }
    #[inline(always)]
    fn is_less(self, other: Self) -> __mmask8 {
        unsafe { _mm512_cmp_pd_mask::<_CMP_LT_OQ>(self.0, other.0) }
    }
    #[inline(always)]
    fn either(self, one: __mmask8, other: __mmask8) -> __mmask8 {
        one | other
    }
    #[inline(always)]
    fn is_any(self, mask: __mmask8) -> bool {
        mask != 0
    }
    #[inline(always)]
    fn where_all(self, mask: __mmask8) -> Self {
        Self(unsafe { _mm512_maskz_mov_pd(mask, self.0) })
    }
    #[inline(always)]
    fn store_mask(self, mask: __mmask8, there: &mut [f64]) {
        there[0] = f64::from_bits(u64::from(mask));
    }
    #[inline(always)]
    fn load_mask(self, from: &[f64]) -> __mmask8 {
        from[0].to_bits() as __mmask8
    }
    #[inline(always)]
    fn differences(self, discs: Lookup<Phase>, pairs: &[[Offset; 2]]) -> [Self; 4] {
        let of = |offset: Offset| discs.after(offset).0.as_ptr();
        let pairs: &[[Offset; 2]; 8] = pairs.first_chunk().expect("eight pairs");
        unsafe {
            let two = |a: Offset, b: Offset| {
                let a = _mm512_castpd256_pd512(_mm256_load_pd(of(a)));
                _mm512_insertf64x4::<1>(a, _mm256_load_pd(of(b)))
            };
            let seen = |a: usize, b: usize| {
                _mm512_sub_pd(two(pairs[a][1], pairs[b][1]), two(pairs[a][0], pairs[b][0]))
            };
            let [a, b, c, d] = [seen(0, 2), seen(1, 3), seen(4, 6), seen(5, 7)];
            // x and vx of pairs 0 to 3, and of 4 to 7; then y and vy.
            let (low, high) = (_mm512_unpacklo_pd(a, b), _mm512_unpacklo_pd(c, d));
            let (low_y, high_y) = (_mm512_unpackhi_pd(a, b), _mm512_unpackhi_pd(c, d));
            [
                Self(_mm512_shuffle_f64x2::<0b10_00_10_00>(low, high)),
                Self(_mm512_shuffle_f64x2::<0b10_00_10_00>(low_y, high_y)),
                Self(_mm512_shuffle_f64x2::<0b11_01_11_01>(low, high)),
                Self(_mm512_shuffle_f64x2::<0b11_01_11_01>(low_y, high_y)),
            ]
        }
    }
    #[inline(always)]
    fn put_sides([x, y]: [Self; 2], there: &mut [Both<[f64; 4]>]) {
        let there = &mut there[..8];
        unsafe {
            let minus = _mm512_setr_pd(-0.0, -0.0, 0.0, 0.0, -0.0, -0.0, 0.0, 0.0);
            for k in 0..4 {
                let (a, b) = (2 * k, 2 * k + 1);
                let which = _mm512_setr_epi64(a, 8 + a, a, 8 + a, b, 8 + b, b, 8 + b);
                let two = _mm512_xor_pd(_mm512_permutex2var_pd(x.0, which, y.0), minus);
                _mm512_storeu_pd(there[2 * k as usize..].as_mut_ptr().cast(), two);
            }
        }
    }
    #[inline(always)]
    fn put_sides_of_two([x, y]: [Self; 2], [sx, sy]: [Self; 2], there: &mut [Both<[[f64; 4]; 2]>]) {
        let there = &mut there[..8];
        unsafe {
            let minus = _mm512_setr_pd(-0.0, -0.0, -0.0, -0.0, 0.0, 0.0, 0.0, 0.0);
            let whole = [_mm512_unpacklo_pd(x.0, y.0), _mm512_unpackhi_pd(x.0, y.0)];
            let spring = [_mm512_unpacklo_pd(sx.0, sy.0), _mm512_unpackhi_pd(sx.0, sy.0)];
            for (k, there) in there.iter_mut().enumerate() {
                let a = (k / 2 * 2) as i64;
                let b = a + 8;
                let which = _mm512_setr_epi64(a, a + 1, b, b + 1, a, a + 1, b, b + 1);
                let both = _mm512_permutex2var_pd(whole[k % 2], which, spring[k % 2]);
                _mm512_storeu_pd(there.0.as_mut_ptr().cast(), _mm512_xor_pd(both, minus));
            }
        }
    }
}
