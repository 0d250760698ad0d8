package org.sami.mavlink.link;

import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.time.Duration;

/** An open way to vehicles, as two streams. Closing it makes a read under way fail or end. Safe for one thread that reads and one that writes. */
interface LinkStreams extends Closeable {
    /** What vehicles send. */
    InputStream in();

    /** What is sent to vehicles; each write of an array is one packet. */
    OutputStream out();

    /**
     * Has each later read fail with a {@link java.net.SocketTimeoutException} once nothing has come for a time. Only a connection does so, as its other end may vanish without a
     * word: a port that listens, or a serial one, stays as good as it is.
     *
     * @throws IOException if the way is broken already
     */
    default void failWhenSilent(Duration time) throws IOException {}
}
