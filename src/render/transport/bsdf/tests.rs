//! Scattering against integrals and closed forms.
