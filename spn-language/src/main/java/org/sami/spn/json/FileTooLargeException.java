package org.sami.spn.json;

import java.io.IOException;

/** A file is larger than what it is to be ever is, or than the memory of the program. The message is one sentence that names it. */
public final class FileTooLargeException extends IOException {
    /** A file that is not read. */
    public FileTooLargeException(String message) {
        super(message);
    }
}
