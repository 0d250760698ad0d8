package org.sami.crw.proxy.file;

import java.io.IOException;

/** A boat does not give a file, or what it gives is not what it listed; its message is for people. Trying again at once does not help. */
public final class FileFetchException extends IOException {
    private static final long serialVersionUID = 1;

    /** A refusal, in words. */
    public FileFetchException(String message) {
        super(message);
    }
}
