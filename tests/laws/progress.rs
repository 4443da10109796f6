//! Times as a person tells them.

use lightbench_kit::progress::in_words;
use std::time::Duration;

#[test]
fn times_have_their_two_largest_units() {
    for (milliseconds, words) in [
        (0, "0 s"),
        (1, "1 s"), // never too little
        (46_001, "47 s"),
        (59_999, "1 min 0 s"),
        (200_000, "3 min 20 s"),
        (3_600_000, "1 h 0 min"),
        (18_120_000, "5 h 2 min"),
        (172_799_000, "47 h 59 min"),
        (273_600_000, "3 days 4 h"),
    ] {
        assert_eq!(in_words(Duration::from_millis(milliseconds)), words);
    }
    assert!(in_words(Duration::MAX).ends_with(" h"), "no time is too long");
}
