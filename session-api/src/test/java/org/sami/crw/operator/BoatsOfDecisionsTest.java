package org.sami.crw.operator;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.crw.decision.DomainQuestion;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Priority;

/** Whom decisions are about, as windows are told. */
class BoatsOfDecisionsTest {
    private final ModelWorld world = new ModelWorld();

    @Test
    void aPlansQuestionIsAboutTheBoatsOfThePlaceThatAsks() {
        world.step(
                new Input.ProxyJoined("anna"),
                new Input.ProxyJoined("bert"),
                ModelWorld.start("dawn"),
                new Input.Interrupt(1, "Go", List.of()));
        world.settle();

        assertThat(boats()).containsExactly("anna");
    }

    @Test
    void aQuestionOfTheDomainIsAboutItsBoatAndNotAboutOneThatItsTextNames() {
        world.step(
                new Input.ProxyJoined("anna"),
                new Input.ProxyJoined("base"),
                new Input.AskOperator(
                        DomainQuestion.COMMAND_ASKED.kind(),
                        "anna",
                        "Another base wishes to command anna. Is it to have it?",
                        Priority.HIGH));
        world.settle();

        assertThat(boats()).containsExactly("anna");
    }

    private List<String> boats() {
        return world.models.decisions().snapshot().get(0).presentation().boats();
    }
}
