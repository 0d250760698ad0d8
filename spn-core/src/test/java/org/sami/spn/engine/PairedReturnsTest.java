package org.sami.spn.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Activation;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.Session;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/** Returns of several static sub-missions on one place go together by whom they name (R-SHR-9). */
class PairedReturnsTest {
    private static Map<String, Value> value(String text) {
        return Map.of("value", new TextValue(text));
    }

    /** Who is done, together or one by one, returns "good". */
    private static Plan child(String id) {
        return new NetBuilder(id)
                .start(id + "s")
                .output(id + "s", "Do")
                .end(id + "e")
                .output(
                        id + "e",
                        "ReturnValue",
                        Map.of("value", new FieldSource.Fixed(new TextValue("good"))),
                        Map.of())
                .transition(id + "ok", "Done")
                .in(id + "s", id + "ok", "relevant all")
                .out(id + "ok", id + "e", "take all relevant")
                .transition(id + "over", "Done2")
                .in(id + "s", id + "over", "always")
                .out(id + "over", id + "e", "always")
                .build();
    }

    /** Robots enter a place with two shared sub-missions; what came back from both goes to "d". */
    private static NetBuilder parent() {
        return new NetBuilder("m")
                .start("s")
                .shared("w", "c")
                .shared("w", "k")
                .transition("in")
                .in("s", "in", "proxy >= 1")
                .out("in", "w", "take all proxy");
    }

    private static Session started(NetBuilder net) {
        Session s = new Session(net.build(), child("c"), child("k"));
        s.join("A", "B").start("m");
        return s;
    }

    private static Session started() {
        return started(parent().transition("out").in("w", "out", "always").out("out", "d", "take all sub"));
    }

    private static void done(Session s, String child, String... robots) {
        Activation asked = s.activations(child + "s").get(0);
        s.answer("Done", asked, robots);
    }

    private static Map<String, String> marking(Session s) {
        return s.marking(s.idOf("m"));
    }

    @Test
    void returnsInOppositeOrderGoTogetherByWhomTheyName() {
        Session s = started();

        done(s, "c", "A");
        done(s, "k", "B");
        assertThat(s.allFired()).doesNotContain("out");
        done(s, "c", "B");
        assertThat(marking(s)).isEqualTo(Map.of("s", "generic", "w", "A", "d", "B"));
        done(s, "k", "A");

        assertThat(marking(s)).isEqualTo(Map.of("s", "generic", "d", "B A"));
    }

    @Test
    void whoCameBackFromOneOnlyStaysAReturnOfIt() {
        Session s = started();

        done(s, "c", "A", "B");
        done(s, "k", "A");
        assertThat(marking(s)).isEqualTo(Map.of("s", "generic", "w", "B", "d", "A"));
        done(s, "k", "B");

        assertThat(marking(s)).isEqualTo(Map.of("s", "generic", "d", "A B"));
        assertThat(s.allFired().stream().filter("out"::equals)).hasSize(2);
    }

    @Test
    void theValueOfWhatStaysAReturnIsCheckedAgain() {
        Session s = started(parent().input("good", "CheckReturn", value("good"), Map.of())
                .in("w", "good", "always")
                .out("good", "d", "take all sub"));

        done(s, "c", "A", "B");
        done(s, "k", "B");
        done(s, "k", "A");

        assertThat(marking(s)).isEqualTo(Map.of("s", "generic", "d", "B A"));
    }

    @Test
    void aReturnOfNobodyGoesWithAnyAndLeavesItUnused() {
        Session s =
                started(parent().transition("out").in("w", "out", "always").out("out", "d", "take all sub", "always"));

        s.answer("Done2", s.activations("cs").get(0), "A");
        done(s, "k", "A");
        assertThat(marking(s)).as("'c' has not brought it back").isEqualTo(Map.of("s", "generic", "w", "A B"));
        done(s, "c", "A");

        assertThat(marking(s)).isEqualTo(Map.of("s", "generic", "w", "B", "d", "A"));
    }

    @Test
    void whatCameBackFromBothIsOneToken() {
        Session s = started(parent().transition("out").in("w", "out", "always").out("out", "d", "take 2 sub"));

        done(s, "c", "A", "B");
        done(s, "k", "A", "B");

        assertThat(marking(s)).isEqualTo(Map.of("s", "generic", "d", "A B"));
    }

    @Test
    void pairsSurviveASnapshot() {
        Session s = started();
        done(s, "c", "A", "B");
        done(s, "k", "B");
        s.replaceState(StateCodec.decode(StateCodec.encode(s.state()), s.engine()));

        done(s, "k", "A");

        assertThat(marking(s)).isEqualTo(Map.of("s", "generic", "d", "B A"));
        assertThat(List.of(s.marking(s.idOf("m"), "w"))).containsExactly("");
    }
}
