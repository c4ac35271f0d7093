//! Listening, answering, ending.

use std::ffi::OsString;
use std::io;
use std::net::{IpAddr, SocketAddr};
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use hyper::server::conn::http1;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::server::graceful::GracefulShutdown;
use hyper_util::service::TowerToHyperService;
use thiserror::Error;
use tokio::net::TcpListener;
use tokio::sync::Semaphore;

use crate::answered::Answered;
use crate::impatient::Impatient;
use crate::program::Program;
use crate::queue::Queue;
use crate::uploads::Uploads;
use crate::{Page, router};

/// Where to listen.
#[derive(Debug, Clone)]
pub struct Options {
    /// Address; 127.0.0.1 keeps the page on this machine.
    pub address: IpAddr,
    /// Port; 0 takes any that is free.
    pub port: u16,
    /// Show the page in the browser of the user.
    pub open: bool,
    /// The command that runs `riffel`, which reads the files that pages send: a program, and its first arguments.
    pub program: Vec<OsString>,
}

/// Why the page cannot be served.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ServeError {
    /// The address or port is not to be had.
    #[error("cannot listen on {address}: {reason}")]
    Listen {
        /// Address and port.
        address: SocketAddr,
        /// Why not.
        reason: io::Error,
    },

    /// There is no place for files.
    #[error("cannot make a private temporary folder: {0}")]
    Folder(io::Error),

    /// The machine refuses threads, timers or signals.
    #[error("cannot start the server: {0}")]
    Start(io::Error),
}

/// Connections at a time; a browser keeps six.
const MOST_CONNECTIONS: usize = 512;
/// Time for the head of a request: whoever sends it byte by byte is cut off.
const HEAD_TIME: Duration = Duration::from_secs(10);
/// Time for which what is sent may wait for a browser that does not read it.
const SENDING_TIME: Duration = Duration::from_secs(60);
/// Time to end in.
const ENDING_TIME: Duration = Duration::from_secs(5);

/// Serve the page until a signal (Ctrl-C or a request to end) comes; `ready` is told its address.
///
/// # Errors
/// [`ServeError`].
pub fn serve(options: Options, ready: impl FnOnce(&str)) -> Result<(), ServeError> {
    let runtime = tokio::runtime::Builder::new_multi_thread()
        .enable_all()
        .thread_name("riffel-serve")
        .build()
        .map_err(ServeError::Start)?;
    let outcome = runtime.block_on(listen(options, ready));
    // Work that does not look whether it is wanted is left behind.
    runtime.shutdown_timeout(ENDING_TIME);
    // What that holds of its files goes all the same.
    let _ = std::fs::remove_dir_all(outcome?);
    Ok(())
}

/// Answer until a signal comes; the private folder of files.
async fn listen(options: Options, ready: impl FnOnce(&str)) -> Result<PathBuf, ServeError> {
    let address = SocketAddr::new(options.address, options.port);
    let cannot_listen = |reason| ServeError::Listen { address, reason };
    let listener = TcpListener::bind(address).await.map_err(cannot_listen)?;
    let bound = listener.local_addr().map_err(cannot_listen)?;
    let mut signals = Signals::new().map_err(ServeError::Start)?;

    let workers = std::thread::available_parallelism().map_or(2, usize::from);
    let page = Page {
        queue: Queue::new(workers),
        answered: Answered::default(),
        marches: Queue::new(1),
        long: Queue::for_files(),
        chains: Queue::for_files(),
        uploads: Uploads::new().map_err(ServeError::Folder)?,
        program: Program::new(options.program),
    };
    let place = page.uploads.place().to_owned();
    let queues = page.queues().cloned().collect::<Vec<_>>();
    let service = TowerToHyperService::new(router(page));
    let mut http = http1::Builder::new();
    http.timer(TokioTimer::new()).header_read_timeout(HEAD_TIME);
    let connections = Arc::new(Semaphore::new(MOST_CONNECTIONS));
    let graceful = GracefulShutdown::new();

    let shown = if bound.ip().is_unspecified() { SocketAddr::new([127, 0, 0, 1].into(), bound.port()) } else { bound };
    let url = format!("http://{shown}/");
    ready(&url);
    if options.open {
        // Without a browser the address is still on the terminal.
        let _ = open::that_detached(&url);
    }

    loop {
        let stream = tokio::select! {
            () = signals.next() => break,
            stream = accept(&listener, &connections) => stream,
        };
        let Some((stream, place)) = stream else {
            // Out of file descriptors, say: let some go before the next.
            tokio::time::sleep(Duration::from_millis(50)).await;
            continue;
        };
        let stream = TokioIo::new(Impatient::new(stream, SENDING_TIME));
        let connection = http.serve_connection(stream, service.clone());
        let watched = graceful.watch(connection);
        tokio::spawn(async move {
            // A connection that breaks off concerns nobody else.
            let _ = watched.await;
            drop(place);
        });
    }
    for queue in queues {
        queue.close();
    }
    // A connection that does not end is cut.
    let _ = tokio::time::timeout(ENDING_TIME, graceful.shutdown()).await;
    Ok(place)
}

/// The next connection, when there is a place for it.
async fn accept(
    listener: &TcpListener,
    places: &Arc<Semaphore>,
) -> Option<(tokio::net::TcpStream, tokio::sync::OwnedSemaphorePermit)> {
    let place = places.clone().acquire_owned().await.ok()?;
    let (stream, _) = listener.accept().await.ok()?;
    // Answers are small and awaited.
    let _ = stream.set_nodelay(true);
    Some((stream, place))
}

/// The signals that end the program.
struct Signals {
    #[cfg(unix)]
    interrupt: tokio::signal::unix::Signal,
    #[cfg(unix)]
    terminate: tokio::signal::unix::Signal,
}

impl Signals {
    fn new() -> io::Result<Self> {
        #[cfg(unix)]
        use tokio::signal::unix::{SignalKind, signal};
        // Both are caught from here on: a signal that comes before the first wait must not leave files behind.
        Ok(Self {
            #[cfg(unix)]
            interrupt: signal(SignalKind::interrupt())?,
            #[cfg(unix)]
            terminate: signal(SignalKind::terminate())?,
        })
    }

    async fn next(&mut self) {
        #[cfg(unix)]
        tokio::select! {
            _ = self.interrupt.recv() => (),
            _ = self.terminate.recv() => (),
        }
        #[cfg(not(unix))]
        let _ = tokio::signal::ctrl_c().await;
    }
}
