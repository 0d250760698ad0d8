package org.sami.spn.drawing;

/** Tells how wide a text will be; whoever paints knows the fonts. */
@FunctionalInterface
public interface TextMeasure {
    /** The width of a line, in drawing units. */
    double width(String text, TextStyle style);
}
