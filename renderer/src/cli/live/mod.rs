//! `--live`: a page that shows a run while it goes on.
//!
//! An observer leaves the numbers of each iteration under a lock, which costs the run a copy of them;
//! threads of a small server answer the page from there. They make scenes and images themselves, in a pool of
//! threads of their own, and only when the page asks.
//!
//! The page asks again and again for what is new (polling). Turned down: server-sent events, whose
//! connections stay open, so that a few forgotten pages hold all threads of the server, and which images
//! would need another way beside; a state is some kilobytes, and the page has to ask for images anyway.
//!
//! HTTP is our own, [a page of it](http): requests without bodies, one for each connection. Crates for it
//! bring chunked bodies, keep-alive and pools of threads, which nothing here uses, and leave time limits of slow
//! clients to their callers.

mod course;
mod http;
mod orbit;
mod routes;
mod stage;
mod state;

use std::io::ErrorKind;
use std::net::{IpAddr, Ipv4Addr, SocketAddr, TcpListener, TcpStream};
use std::path::Path;
use std::sync::Arc;
use std::thread;
use std::time::Duration;

pub(super) use state::State;

use super::output::{print_note, print_warning};
use crate::Error;
use crate::optimize::Settings;
use crate::recovery::Recovery;
use http::{Request, Response, Token};
use routes::Page;
use stage::Stage;

/// So many connections are served at a time; a browser has up to six.
const MOST_CONNECTIONS: usize = 16;

#[derive(clap::Args)]
pub(super) struct LiveArguments {
    /// Show the run in a browser while it goes on: the address is printed, with a free port unless one is given
    #[arg(long, value_name = "PORT", num_args = 0..=1, default_missing_value = "0")]
    live: Option<u16>,

    /// The address of this machine to serve the page at; nothing is encrypted [default: 127.0.0.1]
    #[arg(long, value_name = "ADDRESS", requires = "live")]
    live_address: Option<IpAddr>,
}

impl LiveArguments {
    /// Takes the port, if there is to be a page on the run of a scene file.
    ///
    /// # Errors
    ///
    /// If it cannot be taken.
    pub fn bind(&self, scene: &Path) -> Result<Option<LiveServer>, Error> {
        let Some(port) = self.live else { return Ok(None) };
        let address =
            SocketAddr::new(self.live_address.unwrap_or(Ipv4Addr::LOCALHOST.into()), port);
        let refuse = |error| Error::new(format_args!("--live: {address}"), error);
        let listener = TcpListener::bind(address).map_err(refuse)?;
        let address = listener.local_addr().map_err(refuse)?;
        Ok(Some(LiveServer { listener, address, title: scene.display().to_string() }))
    }
}

/// A port that is taken.
pub(super) struct LiveServer {
    listener: TcpListener,
    address: SocketAddr,
    title: String,
}

impl LiveServer {
    /// Answers from now on, until the process ends, and prints where. What an observer is to keep up to date.
    pub fn start(self, recovery: &Recovery<'_>, settings: &Settings) -> Arc<State> {
        let Self { listener, address, title } = self;
        let token = Token::new();
        if !address.ip().is_loopback() {
            print_warning("--live-address: whoever reads the network can see and stop the run");
        }
        print_note(format_args!("live: http://{address}/{token}/"));
        let state = Arc::new(State::new(recovery, settings));
        let page = Arc::new(Page {
            title,
            state: state.clone(),
            stage: Stage::new(recovery),
            token,
            is_loopback: address.ip().is_loopback(),
        });
        thread::spawn(move || listen(&listener, &page));
        state
    }
}

fn listen(listener: &TcpListener, page: &Arc<Page>) {
    // Each connection holds on to it.
    let connections = Arc::new(());
    for connection in listener.incoming() {
        let connection = match connection {
            Ok(connection) => connection,
            // Such as too many open files: that may pass.
            Err(error) if error.kind() != ErrorKind::Interrupted => {
                thread::sleep(Duration::from_millis(50));
                continue;
            }
            Err(_) => continue,
        };
        if Arc::strong_count(&connections) > MOST_CONNECTIONS {
            continue;
        }
        let (page, connections) = (page.clone(), connections.clone());
        let serve = move || {
            serve(&connection, &page);
            drop(connections);
        };
        // Without a thread the connection is closed.
        let _ = thread::Builder::new().spawn(serve);
    }
}

/// Answers one request. A client that is slow or gone is none of the run's business.
fn serve(connection: &TcpStream, page: &Page) {
    let response = match Request::read(connection) {
        Ok(request) => page.answer(&request),
        Err(Some(refused)) => refused,
        Err(None) => return,
    };
    let _ = Response::write(&response, connection);
}
