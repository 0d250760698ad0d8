package org.sami.spn.geotext;

import java.util.Objects;
import org.sami.spn.finding.Severity;

/**
 * What was found in a text file.
 *
 * @param line from 1
 */
public record LineFinding(int line, Severity severity, String message) {
    public LineFinding {
        Objects.requireNonNull(severity, "severity");
        Objects.requireNonNull(message, "message");
    }

    static LineFinding error(int line, String message) {
        return new LineFinding(line, Severity.ERROR, message);
    }

    static LineFinding warning(int line, String message) {
        return new LineFinding(line, Severity.WARNING, message);
    }

    /** Whether the file is not used because of it. */
    public boolean isError() {
        return severity == Severity.ERROR;
    }
}
