//! Where the program writes the files of an answer.

/// Where the program writes the files of an answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Files {
    /// Nowhere: a document and words are enough.
    None,
    /// Nowhere: the answer is one text; asked in JSON, it is a document.
    Text,
    /// In the folder of `output`, or else one that is named after the first file and the question.
    Named,
    /// In the folder of `output`, or else the one that the question is on.
    There,
    /// In the folder of `output` alone.
    OutputOnly,
}

impl Files {
    /// What is said of `output` where the question does not say it.
    pub const OUTPUT: &str = "Folder for the results, made if need be [default: named after the case or file and the command, as in case-map]";
}
