package org.sami.boat.link;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(900)
class FramePumpTest {
    private final FramePump pump = new FramePump(8, 1000);
    private final ByteArrayOutputStream written = new ByteArrayOutputStream();

    @Test
    void finishedPumpWritesWhatWaitsAndNothingMore() throws Exception {
        pump.send(new byte[] {1, 2});
        pump.send(new byte[] {3});
        pump.finish();
        boolean taken = pump.send(new byte[] {4});

        pump.write(written);

        assertThat(taken).as("nobody is to be dropped for it").isTrue();
        assertThat(written.toByteArray()).containsExactly(1, 2, 3);
    }

    @Test
    void closedPumpForgetsWhatWaits() throws Exception {
        pump.send(new byte[] {1, 2});
        pump.close();

        pump.write(written);

        assertThat(written.toByteArray()).isEmpty();
    }
}
