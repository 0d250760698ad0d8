package org.sami.spn.drawing;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.spn.model.Action;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.Mode;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.model.WaitFor;

class EdgeWordsTest {
    private static final InRequirement ONE_GENERIC = InRequirement.of(TokenKind.GENERIC, Match.AT_LEAST, 1);
    private static final OutRequirement TAKE_GENERIC = OutRequirement.of(Action.TAKE, 1, TokenKind.GENERIC);

    @Test
    void requirementsAreWrittenInTheWordsOfTheThesis() {
        assertThat(RequirementWords.of(ONE_GENERIC)).isEqualTo("≥ 1 Generic");
        assertThat(RequirementWords.of(InRequirement.of(TokenKind.ANY_PROXY, Match.ZERO, 0)))
                .isEqualTo("No Proxy");
        assertThat(RequirementWords.of(new InRequirement(TokenKind.TASK, Match.EXACTLY, 2, "T1")))
                .isEqualTo("= 2 Task T1");
        assertThat(RequirementWords.of(InRequirement.allRelevant())).isEqualTo("All Relevant");
        assertThat(RequirementWords.of(InRequirement.unconditional())).isEqualTo("No Condition");
        assertThat(RequirementWords.of(OutRequirement.of(Action.TAKE, OutRequirement.ALL, TokenKind.RELEVANT)))
                .isEqualTo("Take All Relevant");
        assertThat(RequirementWords.of(OutRequirement.of(Action.ADD, 2, TokenKind.GENERIC)))
                .isEqualTo("Add 2 Generic");
        assertThat(RequirementWords.of(OutRequirement.unconditional())).isEqualTo("Enter With Nobody");
    }

    @Test
    void genericTokenThatPassesThroughIsNotWritten() {
        Map<String, List<String>> words =
                words(in("a", ONE_GENERIC, InRequirement.allRelevant()), out("x", TAKE_GENERIC));

        assertThat(words).containsEntry("a", List.of("All Relevant")).containsEntry("x", List.of());
    }

    @Test
    void genericTokenThatStaysOrIsMovedTwiceIsWritten() {
        Map<String, List<String>> stays = words(in("a", ONE_GENERIC));
        Map<String, List<String>> twice = words(in("a", ONE_GENERIC), out("x", TAKE_GENERIC), out("y", TAKE_GENERIC));

        assertThat(stays).containsEntry("a", List.of("≥ 1 Generic"));
        assertThat(twice)
                .containsEntry("a", List.of("≥ 1 Generic"))
                .containsEntry("x", List.of("Take 1 Generic"))
                .containsEntry("y", List.of("Take 1 Generic"));
    }

    private static Map<String, List<String>> words(InEdge in, OutEdge... out) {
        Transition transition = new Transition("t", "", Mode.NOMINAL, WaitFor.EACH, List.of());
        return EdgeWords.of(new Plan(
                "p",
                "",
                "",
                List.of(),
                List.of(transition),
                List.of(in),
                Arrays.asList(out),
                List.of(),
                List.of(),
                List.of(),
                Map.of(),
                List.of(),
                List.of()));
    }

    private static InEdge in(String id, InRequirement... requirements) {
        return new InEdge(id, "from-" + id, "t", Mode.NOMINAL, List.of(requirements));
    }

    private static OutEdge out(String id, OutRequirement... requirements) {
        return new OutEdge(id, "t", "to-" + id, Mode.NOMINAL, List.of(requirements));
    }
}
