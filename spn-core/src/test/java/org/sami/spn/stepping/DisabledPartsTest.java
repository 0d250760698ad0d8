package org.sami.spn.stepping;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.SetDisabled;
import org.sami.spn.engine.Engine;
import org.sami.spn.model.DisabledParts;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TestStep;
import org.sami.spn.protocol.Effect;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.TestVocabulary;

/** What is disabled for trying does nothing while the plan is tried, and what answers it can be put in by hand. */
class DisabledPartsTest {
    private static final Plan VISIT = new NetBuilder("visit")
            .start("start")
            .output("work", "Do")
            .end("end")
            .in("start", "begin", "generic >= 1")
            .out("begin", "work", "take all any")
            .transition("done", "Done")
            .in("work", "done", "relevant all")
            .out("done", "end", "take all relevant")
            .transition("news", "News")
            .in("work", "news", "relevant all")
            .out("news", "end", "take all relevant")
            .build();

    private static Project with(Edit edit) {
        return edit.apply(NetBuilder.project(VISIT), TestVocabulary.TEST)
                .project()
                .orElseThrow();
    }

    private static Stepper tried(Project project) {
        return Stepper.start(
                new Engine(TestVocabulary.TEST, DisabledParts.leftOut(project)), "visit", "tried", List.of("A", "B"));
    }

    private static boolean fired(TakenStep taken, String transition) {
        return taken.effects().stream()
                .anyMatch(effect -> effect instanceof Effect.Fired fired
                        && fired.transition().equals(transition));
    }

    @Test
    void disabledTransitionNeverFires() {
        TestStep news = new TestStep.Occur("News", "", List.of("A"), List.of(), Map.of());
        Project project = with(new SetDisabled("visit", Set.of("news"), true));

        assertThat(fired(tried(NetBuilder.project(VISIT)).take(news), "news")).isTrue();
        assertThat(fired(tried(project).take(news), "news")).isFalse();
        assertThat(tried(project).view().openActivations())
                .extracting(open -> open.place())
                .containsExactly("work");
    }

    @Test
    void disabledPlaceSendsNothingAndTheAnswerIsPutInByHand() {
        Stepper stepper = tried(with(new SetDisabled("visit", Set.of("work"), true)));

        assertThat(stepper.view().openActivations()).isEmpty();
        assertThat(Possible.of(stepper.view(), TestVocabulary.TEST).news())
                .extracting(type -> type.name())
                .contains("Done");

        TakenStep taken = stepper.news("Done", List.of("A", "B"), List.of(), Map.of());

        assertThat(fired(taken, "done")).isTrue();
    }

    @Test
    void whatIsEnabledAgainIsThePlanAsItWas() {
        Project disabled = with(new SetDisabled("visit", Set.of("work", "news"), true));

        assertThat(DisabledParts.of(disabled.plan("visit").orElseThrow())).containsExactly("work", "news");
        assertThat(new SetDisabled("visit", Set.of("work", "news"), false)
                        .apply(disabled, TestVocabulary.TEST)
                        .project())
                .contains(NetBuilder.project(VISIT));
        assertThat(DisabledParts.leftOut(NetBuilder.project(VISIT))).isEqualTo(NetBuilder.project(VISIT));
    }
}
