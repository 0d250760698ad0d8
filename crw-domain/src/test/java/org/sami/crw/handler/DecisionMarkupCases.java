package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.sami.crw.operator.OperatorMessage;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.TextValue;

/** What markups do to questions and messages. */
final class DecisionMarkupCases {
    private DecisionMarkupCases() {}

    static void add(MarkupCatalogue catalogue) {
        priority(catalogue);
        autonomy(catalogue);
        keyword(catalogue);
    }

    private static void priority(MarkupCatalogue catalogue) {
        for (Priority rank : Priority.values()) {
            catalogue.shows("Priority.rank=" + rank, "the question stands where its rank says", () -> {
                PlanSketch plan = new PlanSketch();
                for (Priority other : Priority.values()) {
                    plan.asks("asking", "OperatorApprove", "question", new TextValue(other.name()));
                    plan.marked("Priority", "rank", other.name());
                }
                PlanScene scene = new PlanScene(plan, 0);

                int place = Priority.CRITICAL.compareTo(rank);

                assertThat(scene.world.operator.decisions().pending().get(place).decision())
                        .satisfies(decision -> assertThat(decision.prompt()).isEqualTo(rank.name()))
                        .satisfies(decision -> assertThat(decision.priority()).isEqualTo(rank));
            });
        }
    }

    private static void autonomy(MarkupCatalogue catalogue) {
        catalogue.shows("MixedInitiativeTrigger.trigger=NEVER", "the operator alone answers", () -> {
            PlanScene scene = new PlanScene(approval().marked("MixedInitiativeTrigger", "trigger", "NEVER"), 0);

            scene.run(300);

            assertThat(scene.decision().deadlineMillis()).isEmpty();
        });
        catalogue.shows("MixedInitiativeTrigger.trigger=IMMEDIATELY", "autonomy answers at once", () -> {
            PlanScene scene = new PlanScene(approval().marked("MixedInitiativeTrigger", "trigger", "IMMEDIATELY"), 0);

            assertThat(scene.effects).contains(byAutonomy());
        });
        catalogue.shows("MixedInitiativeTrigger.trigger=TIMER", "autonomy answers when the time is up", () -> {
            PlanScene scene = new PlanScene(timed(5000), 0);
            scene.run(10);

            assertThat(scene.effects).contains(byAutonomy());
        });
        catalogue.shows("MixedInitiativeTrigger.timeout", "so long the operator can answer", () -> {
            PlanScene scene = new PlanScene(timed(5000), 0);
            long askedAt = scene.world.operator.decisions().pending().get(0).openedAtMillis();

            assertThat(scene.decision().deadlineMillis()).hasValue(askedAt + 5000);
            scene.run(4.5);
            assertThat(scene.effects).doesNotContain(byAutonomy());
        });
    }

    private static PlanSketch approval() {
        return new PlanSketch().asks("asking", "OperatorApprove", "question", new TextValue("Go on?"));
    }

    private static PlanSketch timed(long millis) {
        return approval()
                .marked("MixedInitiativeTrigger", "trigger", "TIMER", "timeout", new DurationValue(millis))
                .on("asking", "YesOption", "done");
    }

    private static Effect byAutonomy() {
        return new Effect.DecisionClosed(1, Optional.of(new Answer.YesNo(true)), Optional.of(Answerer.AUTONOMY));
    }

    private static void keyword(MarkupCatalogue catalogue) {
        catalogue.shows("Keyword.source", "the message replaces the one with its keyword", () -> {
            PlanScene scene = new PlanScene(
                    new PlanSketch()
                            .asks("telling", "DisplayMessage", "message", new TextValue("first"))
                            .marked("Keyword", "source", new TextValue("link"))
                            .asks("telling", "DisplayMessage", "message", new TextValue("second"))
                            .marked("Keyword", "source", new TextValue("link")),
                    0);

            assertThat(scene.world.operator.messages().messages())
                    .extracting(OperatorMessage::text)
                    .isEqualTo(List.of("second"));
        });
    }
}
