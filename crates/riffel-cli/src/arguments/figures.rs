//! Arguments of `figures`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

#[derive(Args)]
#[command(after_help = "Example: riffel figures --model non-steady -o figures")]
pub(crate) struct Figures {
    /// Folder for the figures, made if need be.
    #[arg(short, long, value_name = "DIR", default_value = "figures")]
    pub(crate) output: PathBuf,

    /// How the contact answers to oscillations.
    #[arg(long, value_enum, default_value_t = ModelArgument::QuasiStatic)]
    pub(crate) model: ModelArgument,
}

/// How the contact answers to oscillations.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum ModelArgument {
    /// At once, by the paper's creep law: the figures as printed.
    QuasiStatic,
    /// By a spring and a dashpot in series, with the paper's creep law.
    SpringDashpot,
    /// By the exact theory of non-steady rolling.
    NonSteady,
}
