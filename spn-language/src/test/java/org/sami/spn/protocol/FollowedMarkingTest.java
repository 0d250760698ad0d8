package org.sami.spn.protocol;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.sami.spn.engine.MissionView;
import org.sami.spn.model.Plan;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.Session;

/** The differential test holds the followed marking against the engine's on thousands of random plans; here it is shown. */
class FollowedMarkingTest {
    private static final Token A = new Token.Proxy("A");
    private static final Token B = new Token.Proxy("B");

    /** Robots do something in a shared sub-mission and come back one by one. */
    private static final Plan CHILD = new NetBuilder("child")
            .start("c")
            .output("c", "Do")
            .end("done")
            .transition("ok", "Done")
            .in("c", "ok", "relevant all")
            .out("ok", "done", "take all relevant")
            .build();

    private static final Plan PARENT = new NetBuilder("parent")
            .start("s")
            .shared("work", "child")
            .transition("send")
            .in("s", "send", "proxy >= 1")
            .out("send", "work", "take all proxy")
            .out("send", "asked", "always")
            .transition("back")
            .in("work", "back", "always")
            .out("back", "home", "take all sub")
            .build();

    private final Session session = new Session(PARENT, CHILD);
    private final FollowedMarking followed = new FollowedMarking();
    private int heard;

    private void hear() {
        List<Effect> all = session.effects();
        all.subList(heard, all.size()).forEach(followed);
        heard = all.size();
        assertThat(markings(followed)).isEqualTo(markings(session));
    }

    private static Map<Long, Map<String, List<Token>>> markings(FollowedMarking followed) {
        Map<Long, Map<String, List<Token>>> all = new LinkedHashMap<>();
        followed.missions().forEach(mission -> all.put(mission, followed.marking(mission)));
        return all;
    }

    private static Map<Long, Map<String, List<Token>>> markings(Session session) {
        Map<Long, Map<String, List<Token>>> all = new LinkedHashMap<>();
        session.view().missions().forEach(mission -> all.put(mission.id(), mission.marking()));
        return all;
    }

    @Test
    void startFiringSharedInstanceReturnAndDropAreTold() {
        session.join("A", "B");
        long mission = session.start("parent");
        hear();
        long child = session.idOf("child");

        assertThat(followed.tokens(mission, "s")).containsExactly(Token.GENERIC);
        assertThat(followed.tokens(mission, "work")).containsExactly(A, B);
        assertThat(followed.tokens(child, "c")).containsExactly(A, B);
        assertThat(followed.visitedByNobody(mission)).containsExactly("asked");

        session.answer("Done", "c", "A");
        hear();
        assertThat(followed.tokens(mission, "home")).containsExactly(A);
        assertThat(followed.marking(child)).isEqualTo(Map.of("c", List.of(B)));

        session.step(new Input.ProxyDropped("B", mission));
        hear();
        assertThat(followed.marking(mission)).isEqualTo(Map.of("s", List.of(Token.GENERIC), "home", List.of(A)));
        assertThat(followed.marking(child)).isEmpty();
    }

    @Test
    void parentsAndTheirPlacesAreKnownUntilMissionsEnd() {
        session.join("A");
        long mission = session.start("parent");
        hear();
        long child = session.idOf("child");

        assertThat(followed.plan(child)).isEqualTo("child");
        assertThat(followed.parent(child)).isEqualTo(OptionalLong.of(mission));
        assertThat(followed.parentPlace(child)).isEqualTo("work");
        assertThat(followed.children(mission)).containsExactly(child);
        assertThat(followed.parent(mission)).isEmpty();

        session.step(new Input.AbortMission(mission));
        hear();
        assertThat(followed.missions()).isEmpty();
        assertThat(followed.marking(mission)).isEmpty();
    }

    @Test
    void whoBeginsInTheMiddleOfASessionIsToldWhatStandsWhere() {
        session.join("A", "B");
        session.start("parent");
        session.answer("Done", "c", "A");
        FollowedMarking late = new FollowedMarking();
        session.view().markingAsEffects().forEach(late);

        assertThat(markings(late)).isEqualTo(markings(session));
        assertThat(late.visitedByNobody(session.idOf("parent"))).containsExactly("asked");

        session.answer("Done", "c", "B").forEach(late);
        assertThat(markings(late)).isEqualTo(markings(session));
    }

    @Test
    void haltedMissionKeepsItsMarkingUntilItIsAborted() {
        Session ring = new Session(new NetBuilder("ring")
                .start("a")
                .places("b")
                .transition("there")
                .in("a", "there", "generic >= 1")
                .out("there", "b", "take 1 generic")
                .transition("back")
                .in("b", "back", "generic >= 1")
                .out("back", "a", "take 1 generic")
                .build());
        long mission = ring.start("ring");
        ring.effects().forEach(followed);

        assertThat(ring.view().mission(mission).map(MissionView::status)).contains(MissionStatus.HALTED);
        assertThat(followed.marking(mission)).isEqualTo(Map.of("a", List.of(Token.GENERIC)));

        ring.step(new Input.AbortMission(mission)).forEach(followed);
        assertThat(followed.isKnown(mission)).isFalse();
    }

    @Test
    void whatWasMissedIsNamed() {
        session.join("A");
        session.start("parent");
        List<Effect> effects = new ArrayList<>(session.effects());
        effects.removeIf(
                e -> e instanceof Effect.Entered entered && entered.place().equals("s"));

        assertThatThrownBy(() -> effects.forEach(followed))
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("visit 1 of 's' in mission 1");
        assertThatThrownBy(() -> new FollowedMarking().accept(new Effect.Entered(7, "s", 1, List.of())))
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("mission 7");
    }
}
