package org.sami.work.postgres;

import java.io.IOException;
import org.jspecify.annotations.Nullable;

/** The database does not do what the work needs; its message names the address, without a password. */
public class WorkException extends IOException {
    private static final long serialVersionUID = 1;

    WorkException(String message, @Nullable Throwable cause) {
        super(message, cause);
    }
}
