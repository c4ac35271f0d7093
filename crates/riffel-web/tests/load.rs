//! The page under load and under attack, over real sockets.
//!
//! `RIFFEL_LOAD_SECONDS=60 cargo test --release --package riffel-web --test load -- --nocapture` is the full
//! run whose figures stand in the book, and `RIFFEL_LOAD_PAUSE_MS=0` lets the clients ask without a pause; left
//! alone it takes a few seconds. It asserts the same, but no times.

use std::io::{Read, Write};
use std::net::TcpStream;
use std::process::Command;
use std::sync::mpsc::channel;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use riffel_web::{Options, ServeError, serve};

const CLIENTS: usize = 64;

/// The page, while there are tests that use it.
struct Running {
    users: usize,
    host: String,
    thread: JoinHandle<Result<(), ServeError>>,
}

static RUNNING: Mutex<Option<Running>> = Mutex::new(None);

fn running() -> MutexGuard<'static, Option<Running>> {
    RUNNING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A page that tests at the same time share. The last one that lets go of it ends it, which removes its
/// temporary folder.
struct Served {
    /// Its address.
    host: String,
}

impl Served {
    fn new() -> Self {
        let mut running = running();
        let running = running.get_or_insert_with(|| {
            let (ready, address) = channel();
            let thread = std::thread::spawn(move || {
                let options =
                    Options { address: [127, 0, 0, 1].into(), port: 0, open: false, program: vec!["riffel".into()] };
                serve(options, |url| ready.send(url.to_owned()).unwrap())
            });
            let url = address.recv().unwrap();
            let host = url.trim_start_matches("http://").trim_end_matches('/');
            Running { users: 0, host: host.to_owned(), thread }
        });
        running.users += 1;
        Self { host: running.host.clone() }
    }

    fn connect(&self) -> TcpStream {
        TcpStream::connect(&self.host).unwrap()
    }

    /// A request of a page with its body.
    fn request(&self, path: &str, page: usize, body: &str) -> Vec<u8> {
        let host = &self.host;
        format!(
            "POST {path} HTTP/1.1\r\nHost: {host}\r\nOrigin: http://{host}\r\nContent-Type: application/json\r\n\
             X-Riffel-Page: {page}\r\nContent-Length: {}\r\n\r\n{body}",
            body.len()
        )
        .into_bytes()
    }
}

impl Drop for Served {
    fn drop(&mut self) {
        let mut running = running();
        let Some(last) = running.take_if(|running| {
            running.users -= 1;
            running.users == 0
        }) else {
            return;
        };
        // As a terminal or a manager of services ends it. Elsewhere it ends with the tests.
        if cfg!(unix) {
            let this = std::process::id().to_string();
            let told = Command::new("kill").args(["-TERM", &this]).status();
            assert!(told.is_ok_and(|status| status.success()));
            last.thread.join().unwrap().unwrap();
        }
    }
}

/// Status and body of the next answer on a connection.
fn answer(stream: &mut TcpStream) -> std::io::Result<(u16, Vec<u8>)> {
    let mut head = Vec::new();
    let mut byte = [0];
    while !head.ends_with(b"\r\n\r\n") {
        stream.read_exact(&mut byte)?;
        head.push(byte[0]);
    }
    let head = String::from_utf8_lossy(&head).to_ascii_lowercase();
    let status = head.split(' ').nth(1).and_then(|word| word.parse().ok());
    let length =
        head.lines().find_map(|line| line.strip_prefix("content-length: ")).and_then(|length| length.parse().ok());
    let mut body = vec![0; length.unwrap_or(0)];
    stream.read_exact(&mut body)?;
    Ok((status.unwrap_or(0), body))
}

fn case(columns: usize, rows: usize) -> String {
    let text = riffel_case::NOMINAL_CASE
        .replace("points = 241", &format!("points = {columns}"))
        .replace("points = 221", &format!("points = {rows}"));
    format!("{{\"toml\":{}}}", serde_json::Value::from(text))
}

/// Resident memory of this process \[MB\], page and clients together, where the system tells.
fn resident_megabytes() -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmRSS:"))?;
    let kilobytes: f64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(kilobytes / 1e3)
}

// Long: asks the server without a rest for four seconds.
#[test]
fn many_pages_at_once_get_answers_or_are_told_to_wait() {
    let served = Served::new();
    let seconds = std::env::var("RIFFEL_LOAD_SECONDS").ok().and_then(|seconds| seconds.parse().ok());
    let time = Duration::from_secs(seconds.unwrap_or(4));
    // A hand on a slider is no faster.
    let pause = std::env::var("RIFFEL_LOAD_PAUSE_MS").ok().and_then(|pause| pause.parse().ok());
    let pause = Duration::from_millis(pause.unwrap_or(100));
    let begun = Instant::now();
    // What a page asks: mostly small maps and points, now and then a whole map or a picture.
    let small = format!("{{\"case\":{}}}", case(61, 56));
    let whole = format!("{{\"case\":{}}}", case(241, 221));
    let point = format!("{{\"case\":{},\"wavelength_m\":0.05,\"speed_m_per_s\":30.0}}", case(241, 221));
    let questions = [
        ("/api/map", &small),
        ("/api/point", &point),
        ("/api/map", &small),
        ("/api/case", &small),
        ("/api/map", &small),
        ("/api/map", &whole),
    ];
    let (small, served) = (&small, &served);
    let warm_up = time / 4;
    let (times, first, last, busy) = std::thread::scope(|scope| {
        let clients: Vec<_> = (0..CLIENTS)
            .map(|client| {
                scope.spawn(move || {
                    let mut stream = served.connect();
                    stream.set_nodelay(true).unwrap();
                    let (mut times, mut busy) = (Vec::new(), 0usize);
                    for turn in client.. {
                        if begun.elapsed() > time {
                            break;
                        }
                        let (path, body) = questions[turn % questions.len()];
                        let asked = Instant::now();
                        stream.write_all(&served.request(path, client, body)).unwrap();
                        let (status, bytes) = answer(&mut stream).unwrap();
                        match status {
                            200 if std::ptr::eq(body, small) && path == "/api/map" => {
                                times.push(asked.elapsed());
                            }
                            200 => {}
                            503 => busy += 1,
                            other => panic!("{path}: {other} {}", String::from_utf8_lossy(&bytes)),
                        }
                        std::thread::sleep(pause);
                    }
                    (times, busy)
                })
            })
            .collect();
        std::thread::sleep(warm_up);
        let first = resident_megabytes();
        let results: Vec<_> = clients.into_iter().map(|client| client.join().unwrap()).collect();
        let busy: usize = results.iter().map(|result| result.1).sum();
        let times: Vec<Duration> = results.into_iter().flat_map(|result| result.0).collect();
        (times, first, resident_megabytes(), busy)
    });
    let mut times = times;
    times.sort();
    assert!(times.len() > CLIENTS, "every client got a small map: {}", times.len());
    let share = |share: f64| 1e3 * times[((times.len() - 1) as f64 * share) as usize].as_secs_f64();
    println!(
        "{CLIENTS} clients, {:.0} s: {} small maps, no error, median {:.1} ms, 95 % within {:.1} ms, 99 % within {:.1} ms, {busy} told to wait; memory {first:?} → {last:?} MB",
        time.as_secs_f64(),
        times.len(),
        share(0.5),
        share(0.95),
        share(0.99)
    );
    if let (Some(first), Some(last)) = (first, last) {
        // Allocators keep some of what was given back; a leak of one map a request would be gigabytes.
        assert!(last < 1.5 * first + 60.0, "memory grew from {first} to {last} MB");
    }
}

/// A page that closes, or that has asked anew, leaves no work behind that somebody else waits for.
// Long: takes the whole time of five long answers, with which what is broken off is compared.
#[test]
fn whoever_hangs_up_frees_a_worker() {
    let served = Served::new();
    // Two pages never ask the same: long answers are kept for whoever does.
    let long = |path: &str, page: usize| {
        let text = match path {
            "/api/line" => include_str!("../../../cases/wheelset-tram.toml"),
            _ => include_str!("../../../cases/curve.toml"),
        };
        let case = serde_json::Value::from(format!("# {page}\n{text}"));
        format!("{{\"case\":{{\"toml\":{case}}},\"wavelength_m\":0.05,\"speed_m_per_s\":10}}")
    };
    let small = format!("{{\"case\":{}}}", case(61, 56));
    let workers = std::thread::available_parallelism().map_or(2, usize::from);
    let ask = |path: &str, page: usize, body: &str| {
        let mut stream = served.connect();
        stream.write_all(&served.request(path, page, body)).unwrap();
        stream
    };
    for path in ["/api/stability", "/api/map", "/api/line", "/api/damage", "/api/remedies"] {
        let begun = Instant::now();
        assert_eq!(answer(&mut ask(path, 2000, &long(path, 2000))).unwrap().0, 200);
        let whole = begun.elapsed();
        let asked: Vec<TcpStream> = (3000..3000 + workers).map(|page| ask(path, page, &long(path, page))).collect();
        // Work is under way once as long a part of it has gone by as it has taken to begin.
        std::thread::sleep(whole / 10);
        drop(asked);
        let hung_up = Instant::now();
        assert_eq!(answer(&mut ask("/api/map", 4000, &small)).unwrap().0, 200);
        let freed = hung_up.elapsed();
        println!(
            "{path}: {:.2} s alone; broken off it frees its worker within {:.3} s",
            whole.as_secs_f64(),
            freed.as_secs_f64()
        );
        // All workers would have gone on for nine tenths of it, each no faster than one alone.
        assert!(freed < whole / 2, "{path}: {freed:?} of {whole:?}");
    }
}

// Long: waits the ten seconds that a server gives a head to come.
#[test]
fn whoever_sends_a_head_byte_by_byte_is_cut_off_and_holds_up_nobody() {
    let served = Served::new();
    let slow: Vec<TcpStream> = (0..100)
        .map(|_| {
            let mut stream = served.connect();
            stream.write_all(b"POST /api/map HTTP/1.1\r\nHost: 127").unwrap();
            stream
        })
        .collect();
    let mut quick = served.connect();
    let body = format!("{{\"case\":{}}}", case(61, 56));
    quick.write_all(&served.request("/api/map", 1000, &body)).unwrap();
    assert_eq!(answer(&mut quick).unwrap().0, 200);
    for mut stream in slow {
        stream.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
        let mut rest = Vec::new();
        // An answer that says so, or just the end; but an end.
        let end = stream.read_to_end(&mut rest);
        assert!(end.is_ok() || end.is_err_and(|error| error.kind() != std::io::ErrorKind::WouldBlock));
    }
}

// Long: waits the ten seconds that a server gives a body to come.
#[test]
fn a_body_that_is_too_large_or_never_comes_is_refused() {
    let served = Served::new();
    let mut large = served.connect();
    let host = &served.host;
    let head = format!(
        "POST /api/map HTTP/1.1\r\nHost: {host}\r\nOrigin: http://{host}\r\nContent-Type: application/json\r\n\
         Content-Length: 1000000000\r\n\r\n"
    );
    large.write_all(head.as_bytes()).unwrap();
    let piece = vec![b' '; 1 << 16];
    // It may be cut off while we still write.
    for _ in 0..16 {
        if large.write_all(&piece).is_err() {
            break;
        }
    }
    if let Ok((status, _)) = answer(&mut large) {
        assert_eq!(status, 413);
    }

    let mut waiting = served.connect();
    waiting.write_all(head.as_bytes()).unwrap();
    waiting.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
    assert_eq!(answer(&mut waiting).unwrap().0, 408);
}
