package org.sami.boat.link;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import org.junit.jupiter.api.Test;

/** What is sent below all else waits for all else, and one at a time. */
class FramesBelowTest {
    private final FramePump pump = new FramePump(512, 1 << 20);

    @Test
    void pieceWaitsForWhateverIsSentAfterIt() throws Exception {
        assertThat(pump.sendBelow(new byte[] {9})).isTrue();
        pump.send(new byte[] {1});
        pump.send(new byte[] {2});
        pump.finish();

        assertThat(written()).containsExactly(1, 2, 9);
    }

    @Test
    void secondPieceIsNotTakenWhileOneWaits() throws Exception {
        assertThat(pump.sendBelow(new byte[] {9})).isTrue();
        assertThat(pump.sendBelow(new byte[] {8})).isFalse();
        pump.finish();

        assertThat(written()).containsExactly(9);
    }

    @Test
    void whatWaitsBelowCountsForNoLimit() throws Exception {
        FramePump small = new FramePump(1, 10);
        assertThat(small.sendBelow(new byte[6000])).isTrue();

        assertThat(small.send(new byte[10])).isTrue();
    }

    @Test
    void closedPumpForgetsIt() throws Exception {
        pump.sendBelow(new byte[] {9});
        pump.close();

        assertThat(written()).isEmpty();
    }

    private byte[] written() throws Exception {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        pump.write(out);
        return out.toByteArray();
    }
}
