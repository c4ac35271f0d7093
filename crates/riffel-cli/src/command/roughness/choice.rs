//! Which spectra of a table to take, and how to group them.

use std::path::Path;

use riffel_case::CaseError;
use riffel_case::roughness::LabelledSpectrum;

/// The spectra that were chosen, in groups by the value of a column; one group named "all" without one.
pub(crate) fn groups(
    path: &Path,
    mut spectra: Vec<LabelledSpectrum>,
    choose: &[String],
    by: Option<&str>,
) -> Result<Vec<(String, Vec<LabelledSpectrum>)>, CaseError> {
    let columns: Vec<String> = columns(&spectra);
    let known = |column: &str| -> Result<(), CaseError> {
        if columns.iter().any(|known| known == column) {
            return Ok(());
        }
        let message = format!(
            "no column \"{column}\" to choose by; there are {}",
            columns.join(", ")
        );
        Err(refuse(path, message))
    };
    for choice in choose {
        let (column, value) = choice.split_once('=').ok_or_else(|| {
            refuse(
                path,
                format!("--where is {choice}, but must be COLUMN=VALUE"),
            )
        })?;
        known(column)?;
        spectra.retain(|spectrum| spectrum.label(column) == Some(value));
        if spectra.is_empty() {
            Err(refuse(path, format!("no spectrum has {choice}")))?;
        }
    }
    if let Some(column) = by {
        known(column)?;
    }
    let mut groups: Vec<(String, Vec<LabelledSpectrum>)> = Vec::new();
    for labelled in spectra {
        let name = match by {
            Some(column) => labelled.label(column).unwrap_or_default().to_owned(),
            None => "all".to_owned(),
        };
        match groups.iter_mut().find(|group| group.0 == name) {
            Some(group) => group.1.push(labelled),
            None => groups.push((name, vec![labelled])),
        }
    }
    Ok(groups)
}

/// Names of the columns besides wavelength and level.
pub(crate) fn columns(spectra: &[LabelledSpectrum]) -> Vec<String> {
    let labels = spectra.first().map(|spectrum| &spectrum.labels);
    let names = labels.into_iter().flatten().map(|label| label.0.clone());
    names.collect()
}

/// A file that cannot be used.
pub(crate) fn refuse(path: &Path, message: String) -> CaseError {
    CaseError::Data {
        path: path.to_owned(),
        line: None,
        message,
        help: None,
    }
}
