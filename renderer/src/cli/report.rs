//! `renderer report`

use std::path::PathBuf;

use renderer_files::disk::{check_writable, write_atomically};

use super::out_folder::check_no_result;
use super::output::print;
use crate::Error;
use crate::report::report_page;

#[derive(clap::Args)]
pub(super) struct Arguments {
    /// A folder that `renderer optimize` has filled
    folder: PathBuf,

    /// Where to write the page [default: report.html in the folder]
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Error> {
    let default = || arguments.folder.join("report.html");
    let output = arguments.output.clone().unwrap_or_else(default);
    let page = report_page(&arguments.folder)?;
    check_writable(&output)?;
    check_no_result(&output, &arguments.folder)?;
    write_atomically(&output, page.as_bytes())?;
    print(output.display())
}
