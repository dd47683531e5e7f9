//! The system's allocator, and a sentence where it has no more to give.

#![allow(unsafe_code)] // an allocator cannot be written without

use std::alloc::{GlobalAlloc, Layout, System};
use std::io::Write;
use std::process::exit;

/// The exit code where the machine is at fault.
const ENVIRONMENT: i32 = 3;

/// Ends the program with a sentence where memory cannot be had; Rust alone aborts it, which leaves a core and an exit
/// code of a crash. What has been written is there: nothing is flushed or removed, for that may want memory.
struct Allocator;

#[global_allocator]
static ALLOCATOR: Allocator = Allocator;

// SAFETY: every call is the system's with the same arguments, and what it gives is handed on as it is.
unsafe impl GlobalAlloc for Allocator {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        given(unsafe { System.alloc(layout) }, layout.size())
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        given(unsafe { System.alloc_zeroed(layout) }, layout.size())
    }

    unsafe fn realloc(&self, old: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        given(unsafe { System.realloc(old, layout, size) }, size)
    }

    unsafe fn dealloc(&self, old: *mut u8, layout: Layout) {
        unsafe { System.dealloc(old, layout) }
    }
}

/// `memory` of `bytes`, or the end.
#[inline]
fn given(memory: *mut u8, bytes: usize) -> *mut u8 {
    if memory.is_null() {
        give_up(bytes);
    }
    memory
}

#[cold]
fn give_up(bytes: usize) -> ! {
    // Standard error is not buffered, and numbers are written without memory of their own.
    let _ = writeln!(
        std::io::stderr(),
        "error: out of memory: {} MB more were needed, and the system has no more to give\n  \
         way out: fewer discs (`parsim2d check` says what they need), or a machine or a limit (ulimit -v) with more",
        bytes.div_ceil(1_000_000)
    );
    exit(ENVIRONMENT);
}
