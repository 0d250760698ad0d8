package org.sami.boat.hull.stream;

import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;

/** An open port. Closing it from any thread ends reads and writes that wait. */
public interface StreamConnection extends Closeable {
    /** What the device sends; its end or an {@link IOException} means that the device is gone. */
    InputStream in();

    /** What is sent to the device. */
    OutputStream out();
}
