//! `riffel calibrate`

use std::fs;

use crate::*;
