package org.sami.mavlink.link;

import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;

/** Counts the bytes that are read. Read by one thread, asked by any. */
final class CountedStream extends FilterInputStream {
    private volatile long bytes;

    CountedStream(InputStream in) {
        super(in);
    }

    long bytes() {
        return bytes;
    }

    @Override
    public int read() throws IOException {
        int one = super.read();
        count(one < 0 ? 0 : 1);
        return one;
    }

    @Override
    public int read(byte[] to, int from, int length) throws IOException {
        int part = super.read(to, from, length);
        count(Math.max(0, part));
        return part;
    }

    @SuppressWarnings("NonAtomicOperationOnVolatileField") // one thread writes
    private void count(int more) {
        bytes += more;
    }
}
