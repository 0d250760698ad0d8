package org.sami.mavlink.link;

import java.io.Closeable;
import java.io.InputStream;
import java.io.OutputStream;

/** An open way to vehicles, as two streams. Closing it makes a read under way fail or end. Safe for one thread that reads and one that writes. */
interface LinkStreams extends Closeable {
    /** What vehicles send. */
    InputStream in();

    /** What is sent to vehicles; each write of an array is one packet. */
    OutputStream out();
}
