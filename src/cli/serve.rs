//! `ocean-globe serve`: the built page over HTTP, with range requests, so that tiles come out of their archives piecewise.
//!
//! A small server for one's own machine and for tests: no TLS, no listings, no writes. For the world, copy the folder to any
//! static host.

pub mod http;
pub mod range;
pub mod site;

use crate::error::{Error, Result};
use http::{Answer, Request};
use range::Wanted;
use site::{Found, Site, http_date, not_newer};
use std::io::{self, BufReader, Read, Seek, SeekFrom};
use std::net::{SocketAddr, TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::JoinHandle;
use std::time::Duration;

/// A browser opens a new connection without a word when an idle one has been closed.
const IDLE: Duration = Duration::from_secs(60);

/// Serve the built page, with HTTP range requests.
#[derive(Debug, Clone, clap::Args)]
#[command(after_help = "Examples:
  ocean-globe serve                      the page in dist/ on http://127.0.0.1:8080
  ocean-globe serve dist --port 9000     on another port (0: any free one)
  ocean-globe serve --host 0.0.0.0       for other machines too; browsers allow WebGPU only on https and localhost")]
pub struct ServeArgs {
    /// Folder that holds the page
    #[arg(default_value = "dist")]
    pub dir: PathBuf,
    /// Port; 0 takes any free one
    #[arg(long, default_value_t = 8080)]
    pub port: u16,
    /// Address or name to listen on
    #[arg(long, default_value = "127.0.0.1")]
    pub host: String,
}

/// Serves until the process ends; says the address once it listens.
///
/// # Errors
/// As [`Serving::start`].
pub fn run(args: &ServeArgs) -> Result<()> {
    let serving = Serving::start(&args.dir, &args.host, args.port)?;
    println!("Serving {} on http://{}/ (Ctrl-C ends it)", args.dir.display(), serving.address());
    serving.wait();
    Ok(())
}

/// A server at work in threads of its own; dropping it ends it.
pub struct Serving {
    address: SocketAddr,
    stop: Arc<AtomicBool>,
    accepting: Option<JoinHandle<()>>,
}

impl Serving {
    /// Starts to serve the folder `dir` on `host`:`port` (port 0: any free one).
    ///
    /// # Errors
    /// The folder is missing or holds no page; the host is unknown; the port is taken.
    pub fn start(dir: &Path, host: &str, port: u16) -> Result<Self> {
        let site = Site::open(dir)?;
        let refused = |source| {
            let remedy = "stop the program that listens there, or choose another port with --port (0: any free one)";
            Error::io(format!("{host}:{port}"), source, remedy)
        };
        let listener = TcpListener::bind((host, port)).map_err(refused)?;
        let address = listener.local_addr().map_err(refused)?;
        let stop = Arc::new(AtomicBool::new(false));
        let stopped = Arc::clone(&stop);
        let accepting = std::thread::spawn(move || accept(&listener, &site, &stopped));
        Ok(Self { address, stop, accepting: Some(accepting) })
    }

    /// Where it listens.
    #[must_use]
    pub fn address(&self) -> SocketAddr {
        self.address
    }

    /// Blocks for as long as it serves.
    pub fn wait(mut self) {
        if let Some(accepting) = self.accepting.take() {
            let _ = accepting.join();
        }
    }
}

impl Drop for Serving {
    fn drop(&mut self) {
        self.stop.store(true, Ordering::Relaxed);
        // Wakes the thread that waits for a connection, so that it sees the flag.
        let _ = TcpStream::connect(self.address);
    }
}

fn accept(listener: &TcpListener, site: &Site, stopped: &AtomicBool) {
    for stream in listener.incoming() {
        if stopped.load(Ordering::Relaxed) {
            return;
        }
        let Ok(stream) = stream else {
            // Mostly too many open files: wait until some are closed.
            std::thread::sleep(Duration::from_millis(50));
            continue;
        };
        let site = site.clone();
        let work = move || {
            if let Err(error) = converse(stream, &site) {
                // Mostly a browser that went away in the middle of a tile that it no longer needs.
                log::debug!("connection: {error}");
            }
        };
        if let Err(error) = std::thread::Builder::new().spawn(work) {
            log::warn!("one connection refused: {error}");
        }
    }
}

/// Answers the requests of one connection, one after the other.
fn converse(mut stream: TcpStream, site: &Site) -> io::Result<()> {
    stream.set_read_timeout(Some(IDLE))?;
    stream.set_write_timeout(Some(IDLE))?;
    stream.set_nodelay(true)?;
    let mut reader = BufReader::new(stream.try_clone()?);
    loop {
        let request = match Request::read(&mut reader) {
            Ok(Some(request)) => request,
            Ok(None) => return Ok(()),
            Err(error) if error.kind() == io::ErrorKind::InvalidData => {
                return Answer::new("400 Bad Request").text("Not an HTTP/1.1 request\n").send(
                    &mut stream,
                    false,
                    false,
                );
            }
            Err(error) => return Err(error),
        };
        answer(site, &request)?.send(&mut stream, request.method == "HEAD", request.keep_alive)?;
        if !request.keep_alive {
            return Ok(());
        }
    }
}

fn answer(site: &Site, request: &Request) -> io::Result<Answer> {
    if !matches!(request.method.as_str(), "GET" | "HEAD") {
        return Ok(Answer::new("405 Method Not Allowed").header("Allow", "GET, HEAD").text("Only GET and HEAD\n"));
    }
    let Some(found) = site.find(&request.target) else {
        return Ok(Answer::new("404 Not Found").text("Not found\n"));
    };
    if is_unchanged(request, &found) {
        return Ok(describe(Answer::new("304 Not Modified"), &found));
    }
    let ranged = request.method == "GET" && same_file(request, &found);
    Ok(match range::wanted(request.header("Range").filter(|_| ranged), found.len) {
        Wanted::Whole => describe(Answer::new("200 OK"), &found).body(found.file, found.len),
        Wanted::Unsatisfiable => describe(Answer::new("416 Range Not Satisfiable"), &found)
            .header("Content-Range", format!("bytes */{}", found.len)),
        Wanted::Part(part) => {
            let answer = describe(Answer::new("206 Partial Content"), &found)
                .header("Content-Range", format!("bytes {}-{}/{}", part.start, part.end - 1, found.len));
            let mut file = found.file;
            file.seek(SeekFrom::Start(part.start))?;
            let len = part.end - part.start;
            answer.body(file.take(len), len)
        }
    })
}

fn describe(answer: Answer, found: &Found) -> Answer {
    let answer = answer
        .header("Content-Type", found.mime)
        .header("ETag", found.etag.as_str())
        .header("Cache-Control", found.cache)
        .header("Accept-Ranges", "bytes")
        .header("X-Content-Type-Options", "nosniff");
    let dates = [("Last-Modified", found.modified), ("Date", Some(jiff::Timestamp::now()))];
    dates.into_iter().fold(answer, |answer, (name, time)| match time.as_ref().and_then(http_date) {
        Some(date) => answer.header(name, date),
        None => answer,
    })
}

/// RFC 9110, section 13.2.2: the entity tag decides where there is one, else the date.
fn is_unchanged(request: &Request, found: &Found) -> bool {
    let ours = |tag: &str| matches!(tag, "*") || tag.strip_prefix("W/").unwrap_or(tag) == found.etag;
    match (request.header("If-None-Match"), request.header("If-Modified-Since"), &found.modified) {
        (Some(tags), _, _) => tags.split(',').any(|tag| ours(tag.trim())),
        (None, Some(since), Some(modified)) => not_newer(modified, since),
        _ => false,
    }
}

/// `If-Range`: a part is worth sending only from the file that the other parts came from.
fn same_file(request: &Request, found: &Found) -> bool {
    let date = found.modified.as_ref().and_then(http_date);
    request.header("If-Range").is_none_or(|mark| mark == found.etag || Some(mark) == date.as_deref())
}
