package org.sami.spn.drawing;

/** Measures the width of a text; implemented by the painter, which knows the fonts. */
@FunctionalInterface
public interface TextMeasure {
    /** The width of a line, in drawing units. */
    double width(String text, TextStyle style);
}
