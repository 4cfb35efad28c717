//! Where bytes come from: a file natively, HTTP ranges in the browser. The only place where the two differ.

use super::pmtiles::ByteSource;
use crate::error::{Error, Result};

/// Joins a folder or base URL and a file name, keeping a query string at the end.
pub fn join(base: &str, name: &str) -> String {
    let (path, query) = base.split_once('?').map_or((base, ""), |(path, query)| (path, query));
    let slash = if path.is_empty() || path.ends_with('/') { "" } else { "/" };
    let question = if query.is_empty() { "" } else { "?" };
    format!("{path}{slash}{name}{question}{query}")
}

#[cfg(not(target_arch = "wasm32"))]
pub use native::{Source, Spawner, now_s};
#[cfg(target_arch = "wasm32")]
pub use web::{Source, Spawner, now_s};

#[cfg(not(target_arch = "wasm32"))]
mod native {
    use super::{ByteSource, Error, Result};
    use std::fs::File;
    use std::future::Future;
    use std::io::{Read as _, Seek as _, SeekFrom};
    use std::pin::Pin;
    use std::sync::{Arc, Mutex, OnceLock, PoisonError, mpsc};
    use std::time::Instant;

    /// A file, opened at its first read.
    #[derive(Debug)]
    pub struct Source {
        path: String,
        file: Mutex<Option<File>>,
    }

    impl Source {
        /// The file at a path; nothing is touched yet.
        pub fn new(path: impl Into<String>) -> Self {
            Self { path: path.into(), file: Mutex::default() }
        }
    }

    impl ByteSource for Source {
        async fn read(&self, offset: u64, length: u64) -> Result<Vec<u8>> {
            let failed = |e| Error::io(&self.path, e, "check the path, or make the data with scripts/make-world.sh");
            let mut slot = self.file.lock().unwrap_or_else(PoisonError::into_inner);
            let file = match &mut *slot {
                Some(file) => file,
                None => slot.insert(File::open(&self.path).map_err(failed)?),
            };
            file.seek(SeekFrom::Start(offset)).map_err(failed)?;
            // `take` bounds the read; the buffer grows with what is really there.
            let mut bytes = Vec::new();
            file.take(length).read_to_end(&mut bytes).map_err(failed)?;
            Ok(bytes)
        }

        fn name(&self) -> &str {
            &self.path
        }
    }

    /// A clock that never goes backwards, seconds from an arbitrary start.
    pub fn now_s() -> f64 {
        static START: OnceLock<Instant> = OnceLock::new();
        START.get_or_init(Instant::now).elapsed().as_secs_f64()
    }

    type Job = Pin<Box<dyn Future<Output = ()> + Send>>;

    /// Runs jobs on a few threads of its own, which end with it.
    #[derive(Debug)]
    pub struct Spawner(mpsc::Sender<Job>);

    impl Default for Spawner {
        fn default() -> Self {
            let (sender, receiver) = mpsc::channel::<Job>();
            let receiver = Arc::new(Mutex::new(receiver));
            for _ in 0..2 {
                let receiver = receiver.clone();
                std::thread::spawn(move || {
                    let next = || receiver.lock().unwrap_or_else(PoisonError::into_inner).recv();
                    while let Ok(job) = next() {
                        pollster::block_on(job);
                    }
                });
            }
            Self(sender)
        }
    }

    impl Spawner {
        /// Starts a job.
        pub fn spawn(&self, job: impl Future<Output = ()> + Send + 'static) {
            // The threads live as long as this sender does.
            let _ = self.0.send(Box::pin(job));
        }
    }
}

#[cfg(target_arch = "wasm32")]
mod web {
    use super::{ByteSource, Error, Result};
    use std::future::Future;
    use std::sync::{Arc, Mutex, PoisonError};
    use wasm_bindgen::{JsCast as _, JsValue};
    use wasm_bindgen_futures::JsFuture;
    use web_sys::{Headers, RequestInit, Response};

    /// The largest archive accepted from a server that knows no ranges, bytes.
    const MAX_WHOLE: usize = 1 << 30;

    /// A URL, read by HTTP ranges. Where the server sends the whole file instead, it is kept and sliced.
    #[derive(Debug)]
    pub struct Source {
        url: String,
        whole: Mutex<Option<Arc<Vec<u8>>>>,
    }

    impl Source {
        /// The file at a URL; nothing is fetched yet.
        pub fn new(url: impl Into<String>) -> Self {
            Self { url: url.into(), whole: Mutex::default() }
        }

        fn failed(&self, why: impl ToString) -> Error {
            Error::Fetch { url: self.url.clone(), why: why.to_string() }
        }

        fn kept(&self) -> Option<Arc<Vec<u8>>> {
            self.whole.lock().unwrap_or_else(PoisonError::into_inner).clone()
        }

        async fn respond(&self, offset: u64, last: u64) -> std::result::Result<Response, JsValue> {
            let headers = Headers::new()?;
            headers.set("Range", &format!("bytes={offset}-{last}"))?;
            let init = RequestInit::new();
            init.set_method("GET");
            init.set_headers(&headers);
            let window = web_sys::window().ok_or("there is no window to fetch with")?;
            JsFuture::from(window.fetch_with_str_and_init(&self.url, &init)).await?.dyn_into()
        }

        async fn body(&self, response: &Response) -> std::result::Result<Vec<u8>, JsValue> {
            let buffer = JsFuture::from(response.array_buffer()?).await?;
            Ok(js_sys::Uint8Array::new(&buffer).to_vec())
        }
    }

    impl ByteSource for Source {
        async fn read(&self, offset: u64, length: u64) -> Result<Vec<u8>> {
            if let Some(whole) = self.kept() {
                return Ok(slice(&whole, offset, length));
            }
            let last = offset.saturating_add(length.max(1) - 1);
            let response = self.respond(offset, last).await.map_err(|e| self.failed(reason(&e)))?;
            let status = response.status();
            if status == 404 || status == 410 {
                let status = format!("{status} {}", response.status_text());
                return Err(Error::NotThere { url: self.url.clone(), status });
            }
            if status != 200 && status != 206 {
                return Err(self.failed(format!("the server answers {status} {}", response.status_text())));
            }
            let bytes = self.body(&response).await.map_err(|e| self.failed(reason(&e)))?;
            if status == 200 {
                if bytes.len() > MAX_WHOLE {
                    return Err(self.failed("the server knows no ranges and the archive is too large to load whole"));
                }
                let mut slot = self.whole.lock().unwrap_or_else(PoisonError::into_inner);
                let whole = slot.get_or_insert_with(|| Arc::new(bytes)).clone();
                return Ok(slice(&whole, offset, length));
            }
            if let Ok(Some(range)) = response.headers().get("Content-Range")
                && !range.trim_start().starts_with(&format!("bytes {offset}-"))
            {
                return Err(self.failed(format!("the server answers with `{range}` for bytes {offset}-{last}")));
            }
            if bytes.len() as u64 > length {
                return Err(self.failed(format!("the server sends {} bytes for {length}", bytes.len())));
            }
            Ok(bytes)
        }

        fn name(&self) -> &str {
            &self.url
        }
    }

    fn slice(whole: &[u8], offset: u64, length: u64) -> Vec<u8> {
        let size = whole.len() as u64;
        let (start, end) = (offset.min(size), offset.saturating_add(length).min(size));
        whole[start as usize..end as usize].to_vec()
    }

    fn reason(error: &JsValue) -> String {
        match error.dyn_ref::<js_sys::Error>() {
            Some(error) => error.message().into(),
            None => error.as_string().unwrap_or_else(|| format!("{error:?}")),
        }
    }

    /// The browser's clock, seconds.
    pub fn now_s() -> f64 {
        js_sys::Date::now() / 1000.0
    }

    /// Runs jobs on the browser's event loop.
    #[derive(Debug, Default)]
    pub struct Spawner {}

    impl Spawner {
        /// Starts a job.
        pub fn spawn(&self, job: impl Future<Output = ()> + 'static) {
            wasm_bindgen_futures::spawn_local(job);
        }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn names_join_to_folders_and_urls() {
        for (base, joined) in [
            ("data", "data/a"),
            ("data/", "data/a"),
            ("", "a"),
            ("https://x.org/d?v=1", "https://x.org/d/a?v=1"),
            ("./data/?v=1", "./data/a?v=1"),
        ] {
            assert_eq!(super::join(base, "a"), joined);
        }
    }
}
