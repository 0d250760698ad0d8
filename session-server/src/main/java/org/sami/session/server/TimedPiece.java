package org.sami.session.server;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.function.LongSupplier;
import org.sami.crw.proxy.file.BoatFileSource;

/** Reads bytes of a boat's file for one request. A slow link gives fewer of them, so that the client, which gives up after a while, gets some each time; it asks for what follows. */
final class TimedPiece {
    /** A boat's piece that was asked for before is still waited for. */
    private static final long LONGEST_NANOS = TimeUnit.SECONDS.toNanos(5);

    private final LongSupplier nanos;
    private final BooleanSupplier gone;

    /**
     * Reads for a request.
     *
     * @param nanos a clock that only goes on
     * @param gone whether nobody waits for the bytes any longer
     */
    TimedPiece(LongSupplier nanos, BooleanSupplier gone) {
        this.nanos = nanos;
        this.gone = gone;
    }

    /**
     * The bytes from one on: none at the end of the file, else one piece of the boat at least. Fewer also where the link breaks after the first.
     *
     * @throws IOException if the boat gives none, or nobody waits for them any longer
     */
    byte[] read(BoatFileSource boat, String name, long from, int most) throws IOException {
        long begun = nanos.getAsLong();
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        do {
            if (gone.getAsBoolean()) {
                throw new IOException("the client has gone");
            }
            byte[] next;
            try {
                next = boat.piece(name, from + all.size(), most - all.size());
            } catch (IOException broken) {
                if (all.size() == 0) {
                    throw broken;
                }
                break;
            }
            if (next.length == 0) {
                break;
            }
            all.writeBytes(next);
        } while (all.size() < most && nanos.getAsLong() - begun < LONGEST_NANOS);
        return all.toByteArray();
    }
}
