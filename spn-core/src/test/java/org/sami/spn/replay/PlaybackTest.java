package org.sami.spn.replay;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.sami.spn.replay.TimeLine.Kind;
import org.sami.spn.replay.TimeLine.Mark;

class PlaybackTest {
    private final Playback playback = new Playback(new TimeLine(
            10_000,
            List.of(new Mark(2000, Kind.MISSION_STARTED, 1, "starts"), new Mark(6000, Kind.MESSAGE, 0, "told")),
            new TreeSet<>(List.of(1000L, 2000L, 6000L))));

    @Test
    void playsAtItsSpeedAndStandsAtTheEnd() {
        playback.setSpeed(2);
        playback.passed(500);
        assertThat(playback.atMillis()).as("it stands at first").isZero();

        playback.toggle();
        playback.passed(500);
        assertThat(playback.atMillis()).isEqualTo(1000);
        playback.passed(60_000);
        assertThat(playback.atMillis()).isEqualTo(10_000);
        assertThat(playback.isPlaying()).isFalse();
    }

    @Test
    void playsFromTheStartAgainAtTheEnd() {
        playback.goTo(10_000);
        playback.toggle();
        playback.passed(1000);

        assertThat(playback.atMillis()).isEqualTo(1000);
    }

    @Test
    void slowSpeedsLoseNoTime() {
        playback.setSpeed(0.25);
        playback.toggle();
        for (int i = 0; i < 40; i++) {
            playback.passed(1);
        }
        assertThat(playback.atMillis()).isEqualTo(10);
    }

    @Test
    void stepsGoFromOneStepOfTheEngineToTheNextAndStand() {
        playback.toggle();
        playback.step(true);
        assertThat(playback.isPlaying()).isFalse();
        assertThat(playback.atMillis()).isEqualTo(1000);
        playback.step(true);
        playback.step(true);
        playback.step(true);
        assertThat(playback.atMillis()).as("behind the last step is the end").isEqualTo(10_000);
        playback.step(false);
        assertThat(playback.atMillis()).isEqualTo(6000);
    }

    @Test
    void goesFromMarkToMark() {
        playback.toMark(true);
        assertThat(playback.atMillis()).isEqualTo(2000);
        playback.toMark(true);
        playback.toMark(false);
        playback.toMark(false);
        assertThat(playback.atMillis()).isZero();
    }

    @Test
    void onlySpeedsOfTheListAreTaken() {
        assertThatThrownBy(() -> playback.setSpeed(3)).hasMessageContaining("a speed of 3.0");
        for (int i = 0; i < 20; i++) {
            playback.change(true);
        }
        assertThat(playback.speed()).isEqualTo(100);
    }
}
