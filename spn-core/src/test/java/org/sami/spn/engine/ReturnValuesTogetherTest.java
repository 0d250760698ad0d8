package org.sami.spn.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Activation;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.Session;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/** Which return values one firing may use together (R-RET-3). */
class ReturnValuesTogetherTest {
    private static Map<String, Value> value(String text) {
        return Map.of("value", new TextValue(text));
    }

    /** Who is done returns "good", who failed "bad". */
    private static Plan child(String id) {
        Map<String, FieldSource> good = Map.of("value", new FieldSource.Fixed(new TextValue("good")));
        Map<String, FieldSource> bad = Map.of("value", new FieldSource.Fixed(new TextValue("bad")));
        return new NetBuilder(id)
                .start(id + "s")
                .output(id + "s", "Do")
                .end(id + "good", id + "bad")
                .output(id + "good", "ReturnValue", good, Map.of())
                .output(id + "bad", "ReturnValue", bad, Map.of())
                .transition(id + "done", "Done")
                .in(id + "s", id + "done", "relevant all")
                .out(id + "done", id + "good", "take all relevant")
                .transition(id + "failed", "Failed")
                .in(id + "s", id + "failed", "relevant all")
                .out(id + "failed", id + "bad", "take all relevant")
                .build();
    }

    /** News sends robots one by one to the sub-missions; "both" checks a good and a bad return at once. */
    private static NetBuilder parent() {
        return new NetBuilder("m")
                .start("s")
                .transition("send", "News")
                .in("s", "send", "relevant all")
                .out("send", "w", "take all relevant")
                .input("both", "CheckReturn", value("good"), Map.of())
                .input("both", "CheckReturn", value("bad"), Map.of())
                .in("w", "both", "always")
                .out("both", "d", "take all sub");
    }

    private static Session sent(NetBuilder net) {
        Session s = new Session(net.build(), child("c"), child("k"));
        s.join("A", "B").start("m");
        s.news("News", "A");
        s.news("News", "B");
        return s;
    }

    private static void answer(Session s, String type, String place, int activation, String robot) {
        List<Activation> asked = s.activations(place);
        s.answer(type, asked.get(activation), robot);
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void valuesOfTwoReturnsNeverGoTogether(boolean shared) {
        Session s = sent(parent().sub("w", "c", shared, Map.of(), Map.of()));

        answer(s, "Done", "cs", 0, "A");
        answer(s, "Failed", "cs", 1, "B");

        assertThat(s.allFired()).contains("cdone", "cfailed").doesNotContain("both");
        assertThat(s.marking(s.idOf("m"), "w")).isEqualTo("A B");
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void valuesOfTwoSubMissionsGoTogether(boolean shared) {
        Session s = sent(parent().sub("w", "c", shared, Map.of(), Map.of()).sub("w", "k", shared, Map.of(), Map.of()));

        answer(s, "Done", "cs", 0, "A");
        answer(s, "Failed", "ks", 0, "A");

        assertThat(s.fired()).contains("both");
        assertThat(s.marking(s.idOf("m"), "d")).isEqualTo("A");
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void whoWaitsForAllUsesTheValueOfOneReturn(boolean shared) {
        Session s = sent(new NetBuilder("m")
                .start("s")
                .transition("send", "News")
                .in("s", "send", "relevant all")
                .out("send", "w", "take all relevant")
                .sub("w", "c", shared, Map.of(), Map.of())
                .transition("all", "Other")
                .input("all", "CheckReturn", value("good"), Map.of())
                .waitForAll("all")
                .in("w", "all", "always")
                .out("all", "d", "take all sub"));
        answer(s, "Done", "cs", 0, "A");
        answer(s, "Done", "cs", 1, "B");

        s.news("Other", "A", "B");

        assertThat(s.fired()).containsExactly("all");
        assertThat(s.marking(s.idOf("m"))).isEqualTo(Map.of("s", "generic", "w", "B", "d", "A"));
    }

    @Test
    void theSecondReturnIsCheckedByTheNextFiring() {
        Session s = sent(new NetBuilder("m")
                .start("s")
                .transition("send", "News")
                .in("s", "send", "relevant all")
                .out("send", "w", "take all relevant")
                .shared("w", "c")
                .input("good", "CheckReturn", value("good"), Map.of())
                .in("w", "good", "always")
                .out("good", "d", "take all sub")
                .input("bad", "CheckReturn", value("bad"), Map.of())
                .in("w", "bad", "always")
                .out("bad", "e", "take all sub"));

        answer(s, "Failed", "cs", 1, "B");
        answer(s, "Done", "cs", 0, "A");

        assertThat(s.marking(s.idOf("m"))).isEqualTo(Map.of("s", "generic", "d", "A", "e", "B"));
    }
}
