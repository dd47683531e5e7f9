//! A thread that replaces `out.txt` while the run goes on.
//!
//! The run hands it one copied frame at a time and gets the copy's room back. A frame that comes while
//! the last one is still being written is left out: the next will be newer.

use std::io;
use std::sync::mpsc::{Receiver, RecvError, Sender, TryRecvError, channel};
use std::thread::{Builder, JoinHandle};
use std::time::{Duration, Instant};

use super::OutputError;
use super::live::{LiveFrame, Still};
use crate::simulation::Simulation;

/// Writes live frames on a thread of its own, which is started for the first of them.
pub struct LiveWriter {
    live: LiveFrame,
    thread: Option<Thread>,
    /// Room for the next frame; `None` while the thread has it.
    room: Option<Still>,
}

/// The other side.
struct Thread {
    frames: Option<Sender<Still>>, // `None` says that no more will come
    written: Receiver<Written>,
    handle: Option<JoinHandle<()>>,
}

/// What comes back of a frame: its room, how long writing it took, and whether that worked.
struct Written {
    room: Still,
    took: Duration,
    outcome: Result<(), OutputError>,
}

impl LiveWriter {
    /// A writer of `live`.
    pub fn new(live: LiveFrame) -> Self {
        Self { live, thread: None, room: Some(Still::empty()) }
    }

    /// What is written.
    pub fn frame(&self) -> &LiveFrame {
        &self.live
    }

    /// Writes the present state here and now, after what was handed over.
    pub fn refresh(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
        self.wait()?;
        self.live.refresh(simulation)
    }

    /// Has the present state written, and returns how long the frame before it took the thread; or does
    /// nothing and returns `None`, if that one is still being written.
    ///
    /// An error is that of the frame before: what was handed over last fails at the next call or at
    /// [`wait`](Self::wait).
    pub fn offer(&mut self, simulation: &Simulation) -> Result<Option<Duration>, OutputError> {
        let mut took = Duration::ZERO;
        if self.room.is_none() {
            match self.receive(|thread| thread.written.try_recv())? {
                Some(time) => took = time,
                None => return Ok(None),
            }
        }
        if self.thread.is_none() {
            self.thread = Thread::start(&self.live).ok();
        }
        let frames = self.thread.as_ref().and_then(|thread| thread.frames.as_ref());
        let Some((frames, mut room)) = frames.zip(self.room.take()) else {
            self.live.refresh(simulation)?; // no thread is to be had: then here
            return Ok(Some(took));
        };
        room.take(simulation);
        frames.send(room).map_err(|_| self.stopped())?;
        Ok(Some(took))
    }

    /// Returns once everything handed over has been written.
    pub fn wait(&mut self) -> Result<(), OutputError> {
        if self.room.is_none() {
            self.receive(|thread| {
                thread.written.recv().map_err(|RecvError| TryRecvError::Disconnected)
            })?;
        }
        Ok(())
    }

    /// Takes back what the thread has written, if it has, and returns how long that took.
    fn receive(
        &mut self,
        receive: impl Fn(&Thread) -> Result<Written, TryRecvError>,
    ) -> Result<Option<Duration>, OutputError> {
        match self.thread.as_ref().map_or(Err(TryRecvError::Disconnected), receive) {
            Ok(written) => {
                self.room = Some(written.room);
                written.outcome.map(|()| Some(written.took))
            }
            Err(TryRecvError::Empty) => Ok(None),
            Err(TryRecvError::Disconnected) => Err(self.stopped()),
        }
    }

    /// Only a panic ends the thread early.
    fn stopped(&self) -> OutputError {
        let source = io::Error::other("the thread that writes it has stopped");
        OutputError::Write { path: self.live.path.clone(), source }
    }
}

impl Thread {
    fn start(live: &LiveFrame) -> io::Result<Self> {
        let live = live.clone();
        let (frames, to_write) = channel::<Still>();
        let (back, written) = channel();
        let handle = Builder::new().name("out.txt".to_owned()).spawn(move || {
            for mut room in to_write {
                let begun = Instant::now();
                let outcome = live.refresh_from(&mut room);
                let took = begun.elapsed();
                if back.send(Written { room, took, outcome }).is_err() {
                    return; // the run is over
                }
            }
        })?;
        Ok(Self { frames: Some(frames), written, handle: Some(handle) })
    }
}

impl Drop for Thread {
    /// Waits for the thread, so that it leaves no temporary file behind.
    fn drop(&mut self) {
        self.frames = None;
        if let Some(handle) = self.handle.take() {
            let _ = handle.join(); // a panic has said so itself
        }
    }
}
