package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.spn.engine.Engine;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Question;
import org.sami.spn.testing.Session;

/** Plans that the engine once ran wrongly: each stands or falls with one rule of docs/semantics.md. */
class RulesOnFoundPlansTest {
    private static final DomainLibrary LIBRARY =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

    private static Session started(String file) {
        Session s = new Session(new Engine(LIBRARY.vocabulary(), project(file)));
        s.join("b1", "b2").start("m");
        return s;
    }

    private static Project project(String file) {
        try (InputStream in = RulesOnFoundPlansTest.class.getResourceAsStream("/plans/rules/" + file + ".json")) {
            return new ProjectReader(LIBRARY.vocabulary())
                    .read(new String(in.readAllBytes(), StandardCharsets.UTF_8))
                    .result()
                    .orElseThrow();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static void drop(Session s, String robot) {
        s.step(new Input.ProxyDropped(robot, Ids.NONE));
    }

    @Test
    void anApprovalOfADroppedBoatIsForTheOthers() {
        Session s = started("boat-dropped-before-the-approval");
        drop(s, "b1");

        s.decide(new Answer.YesNo(true));

        assertThat(s.marking(s.idOf("m"))).isEqualTo(Map.of("s", "generic", "d", "b2"));
        assertThat(s.notes()).containsExactly(NoteKind.GONE);
    }

    @Test
    void anApprovalOfAPulledBoatIsForTheOthersWhicheverCameFirst() {
        for (boolean pulledFirst : new boolean[] {true, false}) {
            Session s = started("boat-pulled-before-the-approval");
            if (pulledFirst) {
                s.press("pull", "b1");
                s.decide(new Answer.YesNo(true));
                assertThat(s.marking(s.idOf("m"))).isEqualTo(Map.of("s", "generic", "away", "b1", "d", "b2"));
            } else {
                s.decide(new Answer.YesNo(true));
                assertThat(s.marking(s.idOf("m"))).isEqualTo(Map.of("s", "generic", "d", "b1 b2"));
            }
        }
    }

    @Test
    void allAreOfferedAgainWhenTheLastBoatThatAFilterKeptIsDropped() {
        Session s = started("filter-whose-last-boat-goes");
        assertThat(s.onlyDecision().question())
                .isEqualTo(new Question.ChooseProxies(List.of("b1"), 1, Integer.MAX_VALUE));

        drop(s, "b1");

        assertThat(s.onlyDecision().question())
                .isEqualTo(new Question.ChooseProxies(List.of("b2"), 1, Integer.MAX_VALUE));
        assertThat(s.notes()).containsExactly(NoteKind.GONE);
        s.advance(10_000);
        assertThat(s.marking(s.idOf("m"), "d")).isEqualTo("b2");
    }

    @Test
    void returnsOfTwoStaticSubMissionsInOppositeOrderArePairedByBoats() {
        Session s = started("two-static-returns-in-opposite-order");
        List<Activation> timers = s.activations("cw");
        Activation first = timers.get(0);
        Activation second = timers.get(1);

        s.answer("ProxyTimerExpired", first, "b1");
        s.answer("ProxyTimerExpired", second, "b2");
        assertThat(s.marking(s.idOf("m"))).isEqualTo(Map.of("s", "generic", "w", "b1 b2"));
        s.answer("ProxyTimerExpired", first, "b2");
        assertThat(s.marking(s.idOf("m"))).isEqualTo(Map.of("s", "generic", "w", "b1", "d", "b2"));
        s.answer("ProxyTimerExpired", second, "b1");

        assertThat(s.marking(s.idOf("m"))).isEqualTo(Map.of("s", "generic", "d", "b2 b1"));
    }
}
