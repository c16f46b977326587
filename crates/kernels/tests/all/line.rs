//! The list of the lines of the balance.

use tremolite_kernels::{Line, Lines};

#[test]
fn every_line_has_a_name_of_its_own_and_a_sign_unless_it_is_the_sum() {
    for (i, line) in Line::ALL.iter().enumerate() {
        assert_eq!(*line as usize, i);
        assert_eq!(Line::ALL.iter().filter(|other| other.name() == line.name()).count(), 1);
        assert_eq!(line.sign().abs(), if *line == Line::Error { 0.0 } else { 1.0 }, "{}", line.name());
    }
    assert_eq!(Line::ALL.last(), Some(&Line::Error), "scripts expect it last");
}

#[test]
fn the_sum_takes_what_was_put_in_off_what_is_found() {
    let mut lines = Lines::default();
    lines[Line::Kinetic] = 3.0;
    lines[Line::Strain] = 2.0;
    lines[Line::Created] = 0.5;
    lines[Line::Input] = 4.0;
    lines[Line::Error] = 77.0;
    assert_eq!(lines.sum(), 0.5);
}
