package org.sami.boat.link;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** A damaged frame is never taken for another message than was sent. */
class FlippedBitsTest {
    private final LinkCodec codec = new LinkCodec();

    @Test
    void flippedBitsNeverMakeAnotherMessageOfAFrame() {
        SplittableRandom random = new SplittableRandom(81);
        List<LinkMessage> messages = RoundTripTest.messages().toList();
        List<String> taken = new ArrayList<>();
        for (int i = 0; i < 100_000; i++) {
            byte[] sent = codec.encode(i, messages.get(i % messages.size()));
            byte[] came = sent.clone();
            for (int flips = random.nextInt(1, 9); flips > 0; flips--) {
                came[random.nextInt(came.length)] ^= (byte) (1 << random.nextInt(8));
            }
            if (!Arrays.equals(sent, came)) {
                isTaken(came, taken);
            }
        }

        assertThat(taken).isEmpty();
    }

    @Test
    void everySingleFlippedBitIsNoticed() {
        byte[] sent = codec.encode(7, new StartWaypoints("m1-a1", "l1", 3));
        List<String> taken = new ArrayList<>();
        for (int bit = 0; bit < 8 * sent.length; bit++) {
            byte[] came = sent.clone();
            came[bit / 8] ^= (byte) (1 << (bit % 8));
            isTaken(came, taken);
        }

        assertThat(taken).isEmpty();
    }

    @Test
    void bytesThatChangedPlacesOrWereOverwrittenAreNoticed() {
        SplittableRandom random = new SplittableRandom(82);
        List<String> taken = new ArrayList<>();
        for (int i = 0; i < 20_000; i++) {
            byte[] sent = codec.encode(i, new StartWaypoints("m1-a" + i, "l1", random.nextInt(1000)));
            byte[] came = sent.clone();
            int from = 4 + random.nextInt(came.length - 4);
            int to = 4 + random.nextInt(came.length - 4);
            came[to] = sent[from];
            came[from] = random.nextBoolean() ? sent[to] : sent[from];
            if (!Arrays.equals(sent, came)) {
                isTaken(came, taken);
            }
        }

        assertThat(taken).isEmpty();
    }

    private void isTaken(byte[] frame, List<String> taken) {
        try {
            Frame read = codec.decode(frame);
            taken.add(read.sequence() + " " + read.message().type());
        } catch (LinkException e) {
            assertThat(e.fault()).isNotNull();
        }
    }
}
