package org.sami.crw.sim.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.boat.link.LostLinkAction;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.crw.sim.run.settings.SettingsMap;

class RadioTest {
    private static final String ALL = "loss=5,range=90.5,lost-link=return";

    @Test
    void saysWhatItReads() {
        assertThat(Radio.parse(ALL)).isEqualTo(new Radio(5, OptionalDouble.of(90.5), LostLinkAction.RETURN));
        assertThat(Radio.parse(ALL)).hasToString(ALL);
        assertThat(Radio.parse("loss=0")).isEqualTo(Radio.PERFECT);
    }

    @Test
    void reachesToItsRange() {
        assertThat(Radio.parse(ALL).reaches(90.5)).isTrue();
        assertThat(Radio.parse(ALL).reaches(90.6)).isFalse();
        assertThat(Radio.PERFECT.reaches(1e6)).isTrue();
    }

    @Test
    void journalKeepsItUnlessItIsPerfect() {
        RunSettings settings =
                RunSettings.of("clv", "Visit", new FleetSettings(3, 6, 120, 1)).build();
        RunSettings over = settings.withFleet(settings.fleet().over(Radio.parse(ALL)));

        assertThat(SettingsMap.read(SettingsMap.write(over))).isEqualTo(over);
        assertThat(SettingsMap.write(settings)).doesNotContainKey("radio");
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "90", "loss", "loss=x", "loss=91", "loss=NaN", "range=29", "lost-link=sink", "noise=3"})
    void refusesWhatIsNoRadio(String text) {
        assertThatIllegalArgumentException().isThrownBy(() -> Radio.parse(text));
    }
}
