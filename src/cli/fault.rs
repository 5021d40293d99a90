//! Our own mistakes: a panic becomes one line and an exit status.
//!
//! In: a function. Out: what it returns, or the complaint that says what broke. Nothing else is printed of a panic.

use super::complaint::{Complaint, Status};
use std::panic::{self, AssertUnwindSafe, PanicHookInfo};
use std::sync::{Mutex, PoisonError};

/// The first panic of the run, in words.
static FIRST: Mutex<Option<String>> = Mutex::new(None);

/// Runs `work`; a panic in it, on any thread it waits for, becomes a complaint.
///
/// # Errors
/// What `work` returns, or the fault.
pub fn guard(work: impl FnOnce() -> Result<(), Complaint>) -> Result<(), Complaint> {
    panic::set_hook(Box::new(remember));
    panic::catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|_| {
        let first = FIRST.lock().unwrap_or_else(PoisonError::into_inner).take();
        let what = first.unwrap_or_else(|| "a thread ended without a word".into());
        Err(Complaint::worded(
            Status::Fault,
            format!("internal fault: {what}; this is a mistake of the program itself\n"),
        ))
    })
}

fn remember(info: &PanicHookInfo) {
    let message = info.payload_as_str().unwrap_or("unknown").lines().next().unwrap_or_default().to_owned();
    let place = info.location().map_or_else(String::new, |at| format!(" at {}:{}", at.file(), at.line()));
    FIRST.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(format!("{message}{place}"));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_is_one_line() {
        let complaint = guard(|| panic!("two\nlines")).unwrap_err();
        let _ = panic::take_hook();
        assert_eq!(complaint.status, Status::Fault);
        assert!(complaint.text.starts_with("internal fault: two at ") && complaint.text.lines().count() == 1);
    }
}
