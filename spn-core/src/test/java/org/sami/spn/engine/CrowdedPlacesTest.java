package org.sami.spn.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.Session;

/** Places with few and with very many robots keep their tokens in order of entry, whoever leaves first; and so does a copy, and what was written and read. */
class CrowdedPlacesTest {
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 15, 16, 17, 63, 64, 65, 128, 129, 200})
    void tokensStandInOrderOfEntryWhoeverLeaves(int robots) {
        Session session = new Session(new NetBuilder("go")
                .start("from")
                .transition("moved", "News")
                .in("from", "moved", "relevant all")
                .out("moved", "to", "take all relevant")
                .transition("back", "News")
                .in("to", "back", "relevant all")
                .out("back", "from", "take all relevant")
                .build());
        List<String> from = new ArrayList<>();
        List<String> to = new ArrayList<>();
        for (int i = 0; i < robots; i++) {
            from.add("r" + i);
        }
        List<String> all = List.copyOf(from);
        session.join(all.toArray(String[]::new));
        long mission = session.start("go");

        from.add(0, "generic");

        Random random = new Random(robots);
        for (int i = 0; i < 3 * robots; i++) {
            String robot = all.get(random.nextInt(robots));
            session.news("News", robot);
            if (from.remove(robot)) {
                to.add(robot);
            } else if (to.remove(robot)) {
                from.add(robot);
            }
            if (i % 3 == 1) {
                session.replaceState(session.state().copy());
            } else if (i % 3 == 2) {
                session.replaceState(StateCodec.decode(StateCodec.encode(session.state()), session.engine()));
            }
            assertThat(session.marking(mission, "from")).isEqualTo(String.join(" ", from));
            assertThat(session.marking(mission, "to")).isEqualTo(String.join(" ", to));
        }
    }

    @Test
    void robotsAreFoundAmongAThousandGenericTokens() {
        Session session = new Session(new NetBuilder("go")
                .start("start")
                .transition("begin")
                .in("start", "begin", "always")
                .out("begin", "from", "take all any", "add 1000 generic")
                .transition("moved", "News")
                .in("from", "moved", "relevant all")
                .out("moved", "to", "take all relevant")
                .transition("cleared", "News")
                .in("to", "cleared", "relevant all", "proxy >= 2")
                .in("from", "cleared", "always")
                .out("cleared", "rest", "take all generic")
                .build());
        session.join("a", "b", "c");
        long mission = session.start("go");
        assertThat(session.marking(mission, "from")).startsWith("generic a b c generic generic");

        session.news("News", "b");
        assertThat(session.marking(mission, "from")).startsWith("generic a c generic generic");
        assertThat(session.marking(mission, "to")).isEqualTo("b");

        session.news("News", "c"); // the generic tokens leave after it, and with them the table of robots
        assertThat(session.marking(mission, "from")).isEqualTo("a");
        assertThat(session.marking(mission, "to")).isEqualTo("b c");
        session.news("News", "a");
        assertThat(session.marking(mission, "from")).isEmpty();
        assertThat(session.marking(mission, "to")).isEqualTo("b c a");
    }
}
