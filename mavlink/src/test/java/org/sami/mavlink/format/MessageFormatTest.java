package org.sami.mavlink.format;

import static org.assertj.core.api.Assertions.assertThat;

import io.dronefleet.mavlink.annotations.MavlinkMessageInfo;
import io.dronefleet.mavlink.ardupilotmega.ArdupilotmegaDialect;
import io.dronefleet.mavlink.serialization.payload.reflection.ReflectionPayloadDeserializer;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class MessageFormatTest {
    private static final int NUMBERS = 70_000; // beyond the highest number of the dialect
    private static final int LONGEST = 255;
    private static final int EACH = 20;

    private static int[] numbers() {
        ArdupilotmegaDialect dialect = new ArdupilotmegaDialect();
        return IntStream.range(0, NUMBERS).filter(dialect::supports).toArray();
    }

    @Test
    void eachKindIsReadAsTheLibraryReadsItWhateverTheBytesAre() {
        SplittableRandom random = new SplittableRandom(1);
        ReflectionPayloadDeserializer library = new ReflectionPayloadDeserializer();
        int[] numbers = numbers();

        for (int number : numbers) {
            MessageFormat format = MessageFormats.of(number).orElseThrow();
            for (int i = 0; i < EACH; i++) {
                byte[] payload = new byte[random.nextInt(LONGEST + 1)]; // cut off, whole, or longer than is known
                random.nextBytes(payload);
                assertThat(format.read(payload))
                        .as(format.kind().getSimpleName())
                        .isEqualTo(library.deserialize(payload, format.kind()));
            }
        }

        assertThat(numbers.length).isGreaterThan(200);
    }

    @Test
    void kindsHaveTheNumbersAndChecksumsOfTheLibrary() {
        for (int number : numbers()) {
            MessageFormat format = MessageFormats.of(number).orElseThrow();
            MavlinkMessageInfo info = format.kind().getAnnotation(MavlinkMessageInfo.class);
            assertThat(info.id()).isEqualTo(number);
            assertThat(format.checksumExtra()).isEqualTo(info.crc());
        }
        assertThat(MessageFormats.of(NUMBERS)).isEmpty();
    }
}
