package org.sami.spn.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.spn.protocol.Input;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.Session;
import org.sami.spn.value.TextValue;

/** "Why is this transition not enabled?" has an answer in words. */
class WhyNotTest {
    private final Session s = new Session(new NetBuilder("net")
            .start("s")
            .input("pull", "Interrupt", Map.of("interruptName", new TextValue("Stop")), Map.of())
            .in("x", "pull", "generic >= 2")
            .in("s", "pull", "proxy = 0")
            .transition("t", "News", "Other")
            .in("s", "t", "relevant all")
            .out("t", "x", "take all relevant")
            .transition("plain")
            .in("s", "plain", "generic >= 1")
            .in("x", "plain", "task < 1")
            .in("x", "plain", "generic == 1")
            .build());

    @Test
    void everyUnmetConditionIsNamedWithWhatIsThere() {
        long m = s.join("A", "B").start("net");

        assertThat(s.view().whyNotEnabled(m, "pull").reasons())
                .containsExactly(
                        "It waits for Interrupt 'Stop', which has not been received.",
                        "'x' must have at least 2 generic tokens; there are 0.",
                        "'s' must have no robots; there are 2.");
        assertThat(s.view().whyNotEnabled(m, "plain").reasons())
                .containsExactly("'x' must have exactly 1 generic tokens; there are 0.");
    }

    @Test
    void eventsThatDoNotFitTogetherAreNamed() {
        long m = s.join("A", "B").start("net");
        s.news("News", "A");
        s.news("Other", "B");

        assertThat(s.view().whyNotEnabled(m, "t").reasons())
                .containsExactly("The events that it has received do not name the same robots or tasks.");
    }

    @Test
    void missionsAndTransitionsThatAreNotThereAreNamed() {
        long m = s.start("net");

        assertThat(s.view().whyNotEnabled(99, "t").reasons()).containsExactly("Mission 99 is not running.");
        assertThat(s.view().whyNotEnabled(m, "no").reasons()).containsExactly("The plan 'net' has no transition 'no'.");
        s.step(new Input.AbortMission(m));
        assertThat(s.view().whyNotEnabled(m, "t").yes()).isFalse();
    }
}
