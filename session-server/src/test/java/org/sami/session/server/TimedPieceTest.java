package org.sami.session.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.KeptFile;
import org.sami.crw.proxy.file.BoatFileSource;

/** Bytes of a boat's log for one request, over a link whose pieces take their time. */
class TimedPieceTest {
    private static final int PIECE = 6000;
    private static final int MOST = 240_000;

    private long nowNanos;
    private int pieces;

    /** Each piece takes so long. */
    private final class Slow implements BoatFileSource {
        private final long pieceMs;

        Slow(long pieceMs) {
            this.pieceMs = pieceMs;
        }

        @Override
        public void open() {}

        @Override
        public String boatId() {
            return "anna";
        }

        @Override
        public List<KeptFile> list(String kind) {
            return List.of();
        }

        @Override
        public byte[] piece(String name, long offset, int atMost) {
            pieces++;
            nowNanos += TimeUnit.MILLISECONDS.toNanos(pieceMs);
            return new byte[Math.min(PIECE, atMost)];
        }

        @Override
        public void close() {}
    }

    private byte[] read(long pieceMs, int goneAfter) throws IOException {
        return new TimedPiece(() -> nowNanos, () -> pieces >= goneAfter).read(new Slow(pieceMs), "anna.log", 0, MOST);
    }

    @Test
    void fastLinkGivesAllThatIsAskedFor() throws Exception {
        assertThat(read(20, Integer.MAX_VALUE)).hasSize(MOST);
    }

    @Test
    void slowLinkGivesWhatCameInFiveSeconds() throws Exception {
        assertThat(read(1000, Integer.MAX_VALUE)).hasSize(5 * PIECE);
    }

    @Test
    void slowestLinkGivesOnePiece() throws Exception {
        assertThat(read(60_000, Integer.MAX_VALUE)).hasSize(PIECE);
    }

    @Test
    void nothingMoreIsReadWhenNobodyWaitsForIt() {
        assertThatThrownBy(() -> read(20, 3)).hasMessage("the client has gone");

        assertThat(pieces).isEqualTo(3);
    }
}
