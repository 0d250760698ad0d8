package org.sami.spn.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.Plan;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.Session;
import org.sami.spn.value.TextValue;

/** A state that version 2 wrote: A and B have returned from the static instance and C from a dynamic one, all unused. */
class EarlierStateTest {
    private static final Plan CHILD = new NetBuilder("child")
            .start("c")
            .output("c", "Do")
            .end("good")
            .output("good", "ReturnValue", Map.of("value", new FieldSource.Fixed(new TextValue("good"))), Map.of())
            .transition("ok", "Done")
            .in("c", "ok", "relevant all")
            .out("ok", "good", "take all relevant")
            .build();

    private static NetBuilder checked(NetBuilder net, String transition, String from, String to) {
        return net.input(transition, "CheckReturn", Map.of("value", new TextValue("good")), Map.of())
                .in(from, transition, "always")
                .in("gate", transition, "generic >= 1")
                .out(transition, to, "take all sub", "consume 1 generic");
    }

    private static Plan parent() {
        NetBuilder net = new NetBuilder("parent")
                .start("s")
                .shared("together", "child")
                .sub("each", "child")
                .transition("join", "News")
                .in("s", "join", "relevant all")
                .out("join", "together", "take all relevant")
                .transition("send", "Other")
                .in("s", "send", "relevant all")
                .out("send", "each", "take all relevant")
                .input("open", "Interrupt", Map.of("interruptName", new TextValue("Open")), Map.of())
                .out("open", "gate", "add 1 generic");
        return checked(checked(net, "all", "together", "x"), "one", "each", "y").build();
    }

    static Session session() {
        return new Session(parent(), CHILD);
    }

    /** What was done before the state was written. */
    static void before(Session s) {
        s.join("A", "B", "C").start("parent");
        s.news("News", "A");
        s.news("News", "B");
        s.news("Other", "C");
        for (int i = 0; i < 3; i++) {
            s.answer("Done", s.activations("c").get(i), new String[] {"A", "B", "C"}[i]);
        }
    }

    @Test
    void returnsOfAStateOfTheSecondVersionAreUsedInOrder() throws IOException {
        Session s = session();
        try (InputStream bytes = EarlierStateTest.class.getResourceAsStream("state-2.bin")) {
            s.replaceState(StateCodec.decode(bytes.readAllBytes(), s.engine()));
        }
        long m = s.idOf("parent");
        assertThat(s.marking(m)).isEqualTo(Map.of("s", "generic", "together", "A B", "each", "C"));

        for (int i = 0; i < 3; i++) {
            s.press("Open");
        }

        assertThat(s.marking(m)).isEqualTo(Map.of("s", "generic", "x", "A B", "y", "C"));
    }
}
