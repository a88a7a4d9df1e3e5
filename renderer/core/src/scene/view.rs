//! What a scene is seen through.

use super::{Camera, Object, Scene};
use crate::Error;

/// A camera with a name, and the size of its image.
#[derive(Clone, Debug, PartialEq)]
pub struct View {
    /// The name, unique among views.
    pub name: String,
    /// The width of the image in pixels.
    pub width: u32,
    /// The height of the image in pixels.
    pub height: u32,
    /// The camera.
    pub camera: Camera<f64>,
}

impl Scene {
    /// Adds a view; returns its index. From the first on the scene is seen through one of its views.
    ///
    /// # Errors
    ///
    /// If a number is out of its range, or another view has the name.
    pub fn add_view(&mut self, view: View) -> Result<u32, Error> {
        self.views.push(view);
        self.added(|scene| &mut scene.views, Object::View)
    }

    /// The views, in the order in which they were added.
    pub fn views(&self) -> &[View] {
        &self.views
    }

    /// Sees the scene through a view, by index.
    ///
    /// # Panics
    ///
    /// If there is no such view.
    pub fn look_through(&mut self, view: usize) {
        assert!(view < self.views.len(), "view {view} of {}", self.views.len());
        self.shown = view;
    }

    /// The camera that the scene is seen through.
    pub fn seen_from(&self) -> &Camera<f64> {
        self.camera_at(self.shown)
    }

    /// Width and height of the image in pixels.
    pub fn size(&self) -> [u32; 2] {
        self.size_at(self.shown)
    }

    /// The width divided by the height of the image.
    pub fn aspect(&self) -> f64 {
        let [width, height] = self.size();
        f64::from(width) / f64::from(height)
    }

    /// What the scene is seen through, among its objects.
    pub(crate) fn eye(&self) -> Object {
        if self.views.is_empty() { Object::Camera } else { Object::View(self.shown) }
    }

    /// All that the scene may be seen through.
    pub(super) fn eyes(&self) -> impl Iterator<Item = Object> + use<> {
        let nameless = self.views.is_empty().then_some(Object::Camera);
        nameless.into_iter().chain((0..self.views.len()).map(Object::View))
    }

    /// The camera of a view; the one without a name, if the scene has no views.
    pub(super) fn camera_at(&self, view: usize) -> &Camera<f64> {
        self.views.get(view).map_or(&self.camera, |view| &view.camera)
    }

    /// The size of the image of a view, or of the camera without a name.
    pub(super) fn size_at(&self, view: usize) -> [u32; 2] {
        self.views.get(view).map_or([self.width, self.height], |view| [view.width, view.height])
    }
}
