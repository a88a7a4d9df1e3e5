//! What the server answers.

use std::sync::Arc;

use serde_json::json;

use super::http::{Request, Response, Token};
use super::orbit::Orbit;
use super::stage::Stage;
use super::state::State;
use crate::Error;
use crate::Image;
use crate::files::png_bytes;

/// The page, whose addresses are relative to its own.
const PAGE: &str = include_str!("page.html");
/// The sides of images that go around the scene, in pixels, at least and at most.
const SIDES: (f64, f64) = (16.0, 1024.0);

/// The page on a run.
pub(super) struct Page {
    pub title: String,
    pub state: Arc<State>,
    pub stage: Stage,
    pub token: Token,
    /// Whether only this machine can reach it.
    pub is_loopback: bool,
}

impl Page {
    pub fn answer(&self, request: &Request) -> Response {
        if self.is_loopback && !request.is_for_loopback() {
            return Response::refusal(403, "only this machine is served");
        }
        match request.path.split_once('/') {
            Some((token, path)) if self.token.is(token) => {
                self.route(request, path).unwrap_or_else(|refused| refused)
            }
            _ => Response::refusal(403, "the address is another one: renderer has printed it"),
        }
    }

    fn route(&self, request: &Request, path: &str) -> Result<Response, Response> {
        let method = match path {
            "pause" | "go_on" | "stop" | "learning_rate" => "POST",
            _ => "GET",
        };
        if request.method != method {
            return Err(Response::refusal(405, &format!("this is asked for by {method}")));
        }
        match path {
            "" => Ok(Response::new("text/html", PAGE)),
            "state.json" => Ok(self.state()),
            "target.png" => png(&self.stage.target(self.target(request)?)),
            "current.png" => {
                let target = self.target(request)?;
                png(&self.stage.current(target, &self.state.position()))
            }
            "difference.png" => {
                let target = self.target(request)?;
                let (image, white) = self.stage.difference(target, &self.state.position());
                Ok(png(&image)?.with_white(white))
            }
            "orbit.png" => self.orbit(request),
            "pause" => Ok(self.steered(State::pause)),
            "go_on" => Ok(self.steered(State::go_on)),
            "stop" => Ok(self.steered(State::stop)),
            "learning_rate" => {
                let set = self.state.set_factor(request.number("factor", None)?);
                set.map_err(|problem| Response::refusal(400, &problem))?;
                Ok(self.state())
            }
            _ => Err(Response::refusal(404, "there is nothing here")),
        }
    }

    fn state(&self) -> Response {
        let mut state = self.state.json();
        state["title"] = json!(self.title);
        state["views"] = json!(self.stage.names);
        Response::new("application/json", state.to_string())
    }

    fn steered(&self, steer: fn(&State)) -> Response {
        steer(&self.state);
        self.state()
    }

    /// The target that a request is about.
    fn target(&self, request: &Request) -> Result<usize, Response> {
        let number = request.number("view", Some(0.0))?;
        let targets = 0..self.stage.names.len();
        let target = targets.into_iter().find(|&target| target as f64 == number);
        target.ok_or_else(|| Response::refusal(400, "there is no such view"))
    }

    fn orbit(&self, request: &Request) -> Result<Response, Response> {
        let orbit = Orbit {
            turn: request.number("turn", Some(0.0))?,
            rise: request.number("rise", Some(0.0))?,
            distance: request.number("distance", Some(1.0))?,
        };
        let side = |name: &str| {
            let pixels = request.number(name, Some(256.0))?;
            Ok::<_, Response>(pixels.clamp(SIDES.0, SIDES.1) as u32)
        };
        let size = [side("width")?, side("height")?];
        let image = self.stage.orbit(orbit, size, &self.state.position());
        png(&image.map_err(|error| Response::refusal(400, &error.to_string()))?)
    }
}

fn png(image: &Image) -> Result<Response, Response> {
    let bytes = png_bytes(image, "an image");
    let refuse = |error: Error| Response::refusal(500, &error.to_string());
    Ok(Response::new("image/png", bytes.map_err(refuse)?))
}
