package org.sami.mavlink.link;

import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.concurrent.atomic.AtomicLong;

/** Counts the bytes that are read. Read by one thread, asked by any. */
final class CountedStream extends FilterInputStream {
    private final AtomicLong bytes = new AtomicLong();

    CountedStream(InputStream in) {
        super(in);
    }

    long bytes() {
        return bytes.get();
    }

    @Override
    public int read() throws IOException {
        int one = super.read();
        bytes.addAndGet(one < 0 ? 0 : 1);
        return one;
    }

    @Override
    public int read(byte[] to, int from, int length) throws IOException {
        int part = super.read(to, from, length);
        bytes.addAndGet(Math.max(0, part));
        return part;
    }
}
