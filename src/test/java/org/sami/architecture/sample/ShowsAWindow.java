package org.sami.architecture.sample;

import javax.swing.JLabel;

/** Knows Swing, as no model may, and leaves its threads alone. */
public record ShowsAWindow(JLabel label) {}
