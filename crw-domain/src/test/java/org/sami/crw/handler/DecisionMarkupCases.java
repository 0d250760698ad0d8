package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.decision.BoatDescriptions;
import org.sami.crw.decision.DecisionPresentation.LocationDefault;
import org.sami.crw.decision.DecisionPresentation.OptionsFormat;
import org.sami.crw.decision.OfferedOption;
import org.sami.crw.markup.Attention;
import org.sami.crw.operator.DecisionQueue;
import org.sami.crw.operator.OperatorLogEntry;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.BooleanValue;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.TextValue;

/** What markups do to questions. */
final class DecisionMarkupCases {
    private DecisionMarkupCases() {}

    static void add(MarkupCatalogue catalogue) {
        priority(catalogue);
        autonomy(catalogue);
        attention(catalogue);
        location(catalogue);
        selection(catalogue);
        description(catalogue);
        filter(catalogue);
        sort(catalogue);
        layout(catalogue);
        pictures(catalogue);
    }

    private static void pictures(MarkupCatalogue catalogue) {
        catalogue.shows("RelevantProxy.showPictures", "the question is shown with the pictures of its boats", () -> {
            PlanSketch plan = approval();
            plan.marked("RelevantProxy", "proxy", "ALL_PROXIES", "showPictures", new BooleanValue(true));
            PlanScene scene = new PlanScene(plan, 1);

            assertThat(scene.world
                            .operator
                            .decisions()
                            .pending()
                            .get(0)
                            .presentation()
                            .map()
                            .boats())
                    .hasValueSatisfying(
                            boats -> assertThat(boats.showPictures()).isTrue())
                    .hasValueSatisfying(boats -> assertThat(boats.boats()).hasSize(1));
        });
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
        catalogue.shows(
                "MixedInitiativeTrigger.trigger=TIMER", "autonomy answers when the time is up, unless held", () -> {
                    PlanScene scene = new PlanScene(timed(5000), 0);
                    scene.run(10);
                    assertThat(scene.effects).contains(byAutonomy());

                    PlanScene held = new PlanScene(timed(5000), 0);
                    assertThat(first(held).presentation().autonomy().words()).isEqualTo("yes");
                    held.post(new Input.HoldDecision(held.decision().id()));
                    held.run(10);
                    assertThat(held.effects).doesNotContain(byAutonomy());
                    assertThat(first(held).presentation().autonomy().isHeld()).isTrue();
                    assertThat(held.world.operator.log().snapshot())
                            .extracting(OperatorLogEntry::text)
                            .contains("held [1] Go on?");
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

    private static void attention(MarkupCatalogue catalogue) {
        for (Attention.Type type : Attention.Type.values()) {
            catalogue.shows("Attention.type=" + type, "the question says how attention is drawn to it", () -> {
                PlanSketch plan = approval().marked("Attention", "type", type.name());
                assertThat(asked(plan, 0).attention())
                        .contains(new Attention(type, Attention.End.ON_CLICK, Attention.Target.COMPONENT));
            });
        }
        for (Attention.Target target : Attention.Target.values()) {
            catalogue.shows("Attention.target=" + target, "the question says to what attention is drawn", () -> {
                PlanSketch plan = approval().marked("Attention", "type", "BLINK", "target", target.name());
                assertThat(asked(plan, 0).attention().map(Attention::target)).contains(target);
            });
        }
        catalogue.shows("Attention.end=ON_CLICK", "none is drawn any longer when the operator turns to it", () -> {
            PlanScene scene = new PlanScene(approval().marked("Attention", "type", "BLINK", "end", "ON_CLICK"), 0);
            DecisionQueue queue = scene.world.operator.decisions();
            assertThat(queue.pending().get(0).attention()).isPresent();

            queue.attend(scene.decision().id());

            assertThat(queue.pending().get(0).attention()).isEmpty();
        });
    }

    private static void location(MarkupCatalogue catalogue) {
        for (LocationDefault location : LocationDefault.values()) {
            catalogue.shows(
                    "DefaultLocation.location=" + location, "it is proposed where a location is asked for", () -> {
                        PlanSketch plan = new PlanSketch()
                                .asks("asking", "OperatorCreateLocations")
                                .marked("DefaultLocation", "location", location.name());
                        assertThat(asked(plan, 0).presentation().proposedLocation())
                                .contains(location);
                    });
        }
    }

    private static void selection(MarkupCatalogue catalogue) {
        catalogue.shows("DefaultSelection.selection=ALL", "all boats are selected at first", () -> {
            PlanSketch plan = boats().marked("DefaultSelection", "selection", "ALL");
            assertThat(asked(plan, 3).presentation().selected())
                    .contains(new Answer.Proxies(List.of("boat-1", "boat-2", "boat-3")));
        });
        catalogue.shows("DefaultSelection.selection=NONE", "nobody is selected at first, nor by autonomy", () -> {
            PlanScene scene = new PlanScene(
                    boats().marked("DefaultSelection", "selection", "NONE")
                            .marked("MixedInitiativeTrigger", "trigger", "IMMEDIATELY"),
                    3);
            assertThat(first(scene).presentation().selected()).isEmpty();
            assertThat(first(scene).presentation().autonomy().answer()).isEmpty();
            assertThat(scene.notes()).anyMatch(note -> note.contains("Autonomy has no answer"));
        });
    }

    private static void description(MarkupCatalogue catalogue) {
        catalogue.shows("Description.source", "the question says so", () -> {
            PlanSketch plan = approval().marked("Description", "source", new TextValue("Look around first."));
            assertThat(asked(plan, 0).presentation().description()).containsExactly("Look around first.");
        });
        Map<String, String> names = new LinkedHashMap<>();
        names.put("showPlanName", "Plan: " + PlanSketch.ROOT);
        names.put("showVertexName", "Place: asking");
        names.put("showEventName", "Event: Operator Approve");
        names.forEach((option, line) -> catalogue.shows("Description." + option, "the question names it", () -> {
            PlanSketch plan =
                    approval().marked("Description", "source", new TextValue(""), option, new BooleanValue(true));
            assertThat(asked(plan, 0).presentation().description()).containsExactly(line);
            PlanSketch without =
                    approval().marked("Description", "source", new TextValue(""), option, new BooleanValue(false));
            assertThat(asked(without, 0).presentation().description()).isEmpty();
        }));
    }

    private static void filter(MarkupCatalogue catalogue) {
        catalogue.shows("Filter.source", "boats are offered by what plans have called them", () -> {
            PlanScene scene =
                    new PlanScene(boats().marked("Filter", "source", new TextValue("shore"), "action", "INCLUDE"), 3);
            scene.post(BoatDescriptions.remember("boat-2", "SHORE"));
            scene.post(new Input.StartMission(PlanSketch.ROOT, "again", Map.of()));
            List<PendingDecision> both = scene.world.operator.decisions().pending();
            assertThat(labels(both.get(0)))
                    .as("nobody is on the shore: all are offered")
                    .hasSize(3);
            assertThat(labels(both.get(1))).containsExactly("boat-2");
            assertThat(both.get(1).presentation().options().get(0).detail()).isEqualTo("SHORE");
        });
        catalogue.shows("Filter.action=INCLUDE", "those are offered that contain the text", () -> {
            PlanSketch plan = boats().marked("Filter", "source", new TextValue("OAT-3"), "action", "INCLUDE");
            assertThat(labels(asked(plan, 3))).containsExactly("boat-3");
        });
        catalogue.shows("Filter.action=EXCLUDE", "those are offered that do not contain the text", () -> {
            PlanSketch plan = boats().marked("Filter", "source", new TextValue("3"), "action", "EXCLUDE");
            assertThat(labels(asked(plan, 3))).containsExactly("boat-1", "boat-2");
        });
    }

    private static void sort(MarkupCatalogue catalogue) {
        catalogue.shows("Sort.method=ALPHABETICAL", "boats are offered by name, with numbers by their size", () -> {
            PlanSketch plan = boats().marked("Sort", "method", "ALPHABETICAL");
            assertThat(labels(asked(plan, 10)))
                    .startsWith("boat-1", "boat-2", "boat-3")
                    .endsWith("boat-10");
        });
        catalogue.shows("Sort.method=CHRONOLOGICAL", "the boat that joined last stands on top", () -> {
            PlanSketch plan = boats().marked("Sort", "method", "CHRONOLOGICAL");
            assertThat(labels(asked(plan, 3))).containsExactly("boat-3", "boat-2", "boat-1");
        });
        catalogue.shows("Sort.order=INCREASING", "from A, or from the oldest", () -> {
            assertThat(labels(asked(sorted("ALPHABETICAL", "INCREASING"), 3)))
                    .containsExactly("boat-1", "boat-2", "boat-3");
            assertThat(labels(asked(sorted("CHRONOLOGICAL", "INCREASING"), 3)))
                    .containsExactly("boat-1", "boat-2", "boat-3");
        });
        catalogue.shows("Sort.order=DECREASING", "to A, or from the newest", () -> {
            assertThat(labels(asked(sorted("ALPHABETICAL", "DECREASING"), 3)))
                    .containsExactly("boat-3", "boat-2", "boat-1");
            assertThat(labels(asked(sorted("CHRONOLOGICAL", "DECREASING"), 3)))
                    .containsExactly("boat-3", "boat-2", "boat-1");
        });
    }

    private static PlanSketch sorted(String method, String order) {
        return boats().marked("Sort", "method", method, "order", order);
    }

    private static void layout(MarkupCatalogue catalogue) {
        for (OptionsFormat format : OptionsFormat.values()) {
            catalogue.shows("SelectionOptions.format=" + format, "the question says how options are laid out", () -> {
                PlanSketch plan =
                        boats().marked("SelectionOptions", "number", new IntegerValue(2), "format", format.name());
                assertThat(asked(plan, 1).presentation().format()).isEqualTo(format);
            });
        }
    }

    private static PlanSketch boats() {
        return new PlanSketch().asks("asking", "OperatorSelectBoatList");
    }

    private static PendingDecision asked(PlanSketch plan, int boats) {
        return first(new PlanScene(plan, boats));
    }

    private static PendingDecision first(PlanScene scene) {
        return scene.world.operator.decisions().pending().get(0);
    }

    private static List<String> labels(PendingDecision pending) {
        return pending.presentation().options().stream()
                .map(OfferedOption::label)
                .toList();
    }
}
