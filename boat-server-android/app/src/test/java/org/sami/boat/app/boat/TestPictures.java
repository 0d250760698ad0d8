package org.sami.boat.app.boat;

import java.io.IOException;
import java.util.concurrent.atomic.AtomicInteger;

/** A camera that takes the same picture again and again, or says why it does not. */
final class TestPictures implements PictureSource {
    private final AtomicInteger taken = new AtomicInteger();
    private volatile String trouble = "";
    private volatile String fault = "";
    private volatile int bytes = 1000;

    void setTrouble(String words) {
        trouble = words;
    }

    void setFault(String words) {
        fault = words;
    }

    void setBytes(int each) {
        bytes = each;
    }

    int taken() {
        return taken.get();
    }

    @Override
    public String trouble() {
        return trouble;
    }

    @Override
    public byte[] take(int mostBytes) throws IOException {
        if (!fault.isEmpty()) {
            throw new IOException(fault);
        }
        taken.incrementAndGet();
        return new byte[bytes];
    }
}
