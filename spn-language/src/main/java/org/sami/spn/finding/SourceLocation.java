package org.sami.spn.finding;

import java.util.Objects;

/**
 * A place in a text file.
 *
 * @param file the file's path as it was named; empty text for a text that came from no file
 * @param line counts from 1
 * @param column counts from 1, in UTF-16 units
 */
public record SourceLocation(String file, int line, int column) {
    public SourceLocation {
        Objects.requireNonNull(file, "file");
        if (line < 1 || column < 1) {
            throw new IllegalArgumentException("Lines and columns count from 1, not " + line + ":" + column);
        }
    }

    /** The place as compilers print it: {@code FILE:LINE:COLUMN}. */
    @Override
    public String toString() {
        return (file.isEmpty() ? "" : file + ":") + line + ":" + column;
    }
}
