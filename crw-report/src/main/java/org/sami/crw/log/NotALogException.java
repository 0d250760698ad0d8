package org.sami.crw.log;

import java.io.IOException;

/** The file is no log of a boat at all; the message says what it is instead, without the file's name. */
public final class NotALogException extends IOException {
    NotALogException(String message) {
        super(message);
    }
}
