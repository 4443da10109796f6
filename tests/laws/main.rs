//! Laws: properties and invariants, module by module.

mod architecture;
