package org.sami.crw.gui.sound;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import javax.sound.sampled.LineUnavailableException;
import org.junit.jupiter.api.Test;
import org.sami.boat.server.testing.Await;

class AlarmToneTest {
    @Test
    void eachToneHasItsOwnSoundAndBeginsAndEndsInSilence() {
        Set<String> sounds = new HashSet<>();
        for (AlarmTone tone : AlarmTone.values()) {
            byte[] samples = tone.samples();
            sounds.add(Arrays.toString(samples));
            assertThat(samples).hasSize((int) (2 * (tone.lengthMillis() * AlarmTone.RATE_HZ / 1000)));
            assertThat(Math.abs(sample(samples, 0))).as("it does not click").isLessThan(1000);
            assertThat(Math.abs(sample(samples, samples.length / 2 - 1))).isLessThan(1000);
            assertThat(loudest(samples)).as("it is heard, and not distorted").isBetween(14_000, 20_000);
        }
        assertThat(sounds).hasSize(AlarmTone.values().length);
    }

    @Test
    void aMachineWithoutSoundSaysSoOnceAndGoesOn() {
        List<String> said = new CopyOnWriteArrayList<>();
        AtomicInteger tried = new AtomicInteger();
        try (Loudspeaker speaker = new Loudspeaker(
                format -> {
                    tried.incrementAndGet();
                    throw new LineUnavailableException("no card");
                },
                said::add)) {
            speaker.play(AlarmTone.MEDIUM);
            Await.until("it says so", () -> !said.isEmpty());
            speaker.play(AlarmTone.CRITICAL);
        }
        assertThat(said).containsExactly("This machine makes no sound: alarms are seen, and not heard");
        assertThat(tried).as("it does not try again").hasValue(1);
    }

    private static int sample(byte[] samples, int index) {
        return (samples[2 * index] & 0xff) | (samples[2 * index + 1] << 8);
    }

    private static int loudest(byte[] samples) {
        int most = 0;
        for (int i = 0; i < samples.length / 2; i++) {
            most = Math.max(most, Math.abs(sample(samples, i)));
        }
        return most;
    }
}
