package org.sami.crw.operator;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.crw.operator.mission.BlockedPlaces;
import org.sami.crw.operator.mission.InterruptChoice;
import org.sami.crw.operator.mission.MissionSnapshot;
import org.sami.crw.operator.mission.Wait;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.MissionView;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.protocol.Priority;
import org.sami.spn.protocol.Question;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;

class OperatorModelsTest {
    private static final List<Priority> PRIORITIES = List.of(Priority.values());
    private static final int BOATS = 4;

    private final ModelWorld world = new ModelWorld();
    private final OperatorModels models = world.models;

    /** What models follow from effects is compared with what the engine itself answers, after bursts of random inputs. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void modelsFollowTheEngineThroughRandomInputs(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        for (int boat = 0; boat < BOATS; boat++) {
            world.step(new Input.ProxyJoined("boat" + boat));
        }
        for (int burst = 0; burst < 60; burst++) {
            for (int i = random.nextInt(6); i >= 0; i--) {
                world.nowMillis.addAndGet(random.nextInt(1000));
                world.step(randomInput(random));
            }
            world.settle();
            world.refresh();
            world.host.ask(view -> {
                assertModelsAre(view);
                return null;
            });
        }
        assertThat(models.missions().snapshot().firings()).as("firings").isPositive();
    }

    @Test
    void missionsOfOnePlanAreToldApartByTheirNumbersWhileBothRun() {
        world.step(ModelWorld.start("first"));
        world.settle();
        assertThat(models.missions().words(1)).isEqualTo("There and back");

        world.step(ModelWorld.start("second"));
        world.settle();
        assertThat(models.missions().words(1)).isEqualTo("There and back (1)");
        assertThat(models.missions().words(2)).isEqualTo("There and back (2)");

        world.step(new Input.AbortMission(1));
        world.settle();
        assertThat(models.missions().words(2)).isEqualTo("There and back");
        assertThat(models.missions().words(9)).isEqualTo("mission 9");
    }

    private Input randomInput(SplittableRandom random) {
        long mission = 1L + random.nextInt(6);
        List<String> boat = List.of("boat" + random.nextInt(BOATS));
        List<Decision> open = world.host.ask(EngineView::decisions);
        return switch (random.nextInt(14)) {
            case 0 -> ModelWorld.start("m" + world.nowMillis);
            case 1 -> new Input.AbortMission(mission);
            case 2 -> new Input.SetVariable(mission, "@note", new TextValue("note " + random.nextInt(100)));
            case 3 ->
                new Input.AllocateTasks(Map.of(
                        new TaskId(mission, random.nextBoolean() ? "a" : "b"),
                        random.nextInt(3) == 0 ? Optional.empty() : Optional.of(boat.get(0))));
            case 4 -> new Input.ProxyDropped(boat.get(0), mission);
            case 5, 6, 7 -> new Input.Interrupt(mission, "Back", List.of());
            case 8, 9, 10 ->
                open.isEmpty()
                        ? new Input.TimeReached()
                        : new Input.AnswerDecision(
                                open.get(random.nextInt(open.size())).id(),
                                new Answer.Proxies(boat),
                                Answerer.OPERATOR);
            default -> new Input.Interrupt(mission, "Go", List.of());
        };
    }

    private void assertModelsAre(EngineView view) {
        Map<Long, Map<String, List<Token>>> markings = new LinkedHashMap<>();
        view.missions().forEach(mission -> markings.put(mission.id(), mission.marking()));
        Map<Long, Map<String, List<Token>>> followed = new LinkedHashMap<>();
        models.missions().snapshot().running().forEach(mission -> followed.put(mission.id(), mission.marking()));
        assertThat(followed).isEqualTo(markings);
        for (MissionView mission : view.missions()) {
            MissionSnapshot seen =
                    models.missions().snapshot().mission(mission.id()).orElseThrow();
            assertThat(seen.variables())
                    .containsEntry("@note", view.variable(mission.id(), "@note").orElseThrow());
            assertThat(seen.details().pending()).isEqualTo(view.pendingAnswers(mission.id()));
            assertThat(seen.details().blocked()).isEqualTo(BlockedPlaces.of(ModelWorld.VOCABULARY, view, mission));
            assertThat(seen.name()).isEqualTo(mission.name());
        }
        assertThat(models.decisions().pending())
                .extracting(pending -> pending.decision().id())
                .containsExactlyElementsOf(
                        view.decisions().stream().map(Decision::id).toList());
        List<TaskId> free = new ArrayList<>();
        view.missions()
                .forEach(mission -> List.of("a", "b").forEach(name -> {
                    TaskId task = new TaskId(mission.id(), name);
                    if (!view.allocation().containsKey(task)) {
                        free.add(task);
                    }
                }));
        assertThat(models.allocation().snapshot().unallocated()).containsExactlyInAnyOrderElementsOf(free);
    }

    @Test
    void aMissionTellsWhenItStartedAndHowItEnded() {
        world.nowMillis.set(5000);
        world.step(ModelWorld.start("dawn"));
        world.nowMillis.set(9000);
        world.step(new Input.AbortMission(1));
        world.settle();

        assertThat(models.missions().snapshot().mission(1)).hasValueSatisfying(mission -> {
            assertThat(mission.title()).isEqualTo("There and back");
            assertThat(mission.startedAtMillis()).isEqualTo(5000);
            assertThat(mission.outcome()).contains(Outcome.ABORTED);
            assertThat(mission.endedAtMillis()).isEqualTo(OptionalLong.of(9000));
            assertThat(mission.marking()).isEmpty();
        });
    }

    @Test
    void aDecisionTellsWhoAsksAndAnAnswerIsCheckedBeforeItIsPosted() {
        askWhomToSend();

        PendingDecision asked = models.decisions().pending().get(0);
        assertThat(asked.plan()).isEqualTo("p");
        assertThat(asked.mission()).isEqualTo("dawn");
        assertThat(asked.place()).isEqualTo("work");
        assertThat(asked.ageMillis(2500)).isEqualTo(1500);
        assertThat(asked.autonomyInMillis(2500)).isEmpty();
        long id = asked.decision().id();
        assertThat(check(id, new Answer.Proxies(List.of("anna")))).isEmpty();
        assertThat(check(id, new Answer.Proxies(List.of()))).contains("nobody is chosen");
        assertThat(check(id, new Answer.Proxies(List.of("carla"))))
                .contains("'carla' is not among those to choose from");
        assertThat(check(id, new Answer.YesNo(true))).contains("a choice of robots is expected, not yes");
        assertThat(check(id + 1, new Answer.YesNo(true))).contains("Decision " + (id + 1) + " waits no longer");
    }

    private Optional<String> check(long decision, Answer answer) {
        return models.decisions().check(decision, answer, ModelWorld.VOCABULARY);
    }

    private void askWhomToSend() {
        world.nowMillis.set(1000);
        world.step(new Input.ProxyJoined("anna"), ModelWorld.start("dawn"), new Input.Interrupt(1, "Go", List.of()));
        world.settle();
    }

    @Test
    void buttonsThatCannotBePressedSayWhy() {
        world.step(new Input.ProxyJoined("anna"), ModelWorld.start("dawn"));
        world.refresh();

        assertThat(models.interrupts().snapshot())
                .extracting(InterruptChoice::name)
                .containsExactly("Go", "Back", "Over");
        assertThat(button("Go").isEnabled()).isTrue();
        assertThat(button("Back").whyNot()).contains("'Work' must have at least 1 robots; there are 0.");

        world.step(new Input.Interrupt(1, "Go", List.of()));
        world.refresh();

        assertThat(button("Go").isEnabled()).isFalse();
        assertThat(button("Back").isEnabled()).isTrue();
    }

    private InterruptChoice button(String name) {
        return models.interrupts().snapshot().stream()
                .filter(button -> button.name().equals(name))
                .findFirst()
                .orElseThrow();
    }

    @Test
    void anAnswerThatIsKeptIsShownWithWhatBlocksIt() {
        askWhomToSend();
        long id = models.decisions().pending().get(0).decision().id();
        world.step(new Input.AnswerDecision(id, new Answer.Proxies(List.of("anna")), Answerer.OPERATOR));
        world.refresh();

        MissionSnapshot.Details details =
                models.missions().snapshot().mission(1).orElseThrow().details();
        assertThat(details.pending()).singleElement().satisfies(kept -> {
            assertThat(kept.transition()).isEqualTo("picked");
            assertThat(kept.occurrence().proxies()).containsExactly("anna");
        });
        assertThat(details.blocked())
                .flatExtracting(Wait::transitions)
                .flatExtracting(Wait.BlockedTransition::reasons)
                .contains("'Work' must have at least 2 robots; there is 1.");
    }

    @Test
    void aStateThatIsRestoredIsShownAsItStands() {
        askWhomToSend();
        OperatorModels later = new OperatorModels(Runnable::run, () -> 0);

        world.host.ask(view -> {
            later.restore(view, 7000);
            return null;
        });

        assertThat(later.missions().snapshot().running())
                .extracting(MissionSnapshot::marking)
                .isEqualTo(models.missions().snapshot().running().stream()
                        .map(MissionSnapshot::marking)
                        .toList());
        assertThat(later.decisions().pending())
                .singleElement()
                .satisfies(pending -> assertThat(pending.place()).isEqualTo("work"));
        assertThat(later.allocation().snapshot().unallocated()).containsExactly(new TaskId(1, "a"), new TaskId(1, "b"));
    }

    /** Opened and closed at random; the order is recomputed by sorting what is left. */
    @Test
    void aThousandDecisionsStandInTheirOrder() {
        SplittableRandom random = new SplittableRandom(7);
        Map<Long, PendingDecision> left = new LinkedHashMap<>();
        List<List<PendingDecision>> told = new ArrayList<>();
        models.decisions().addListener((List<PendingDecision> all) -> told.add(all));
        EngineView view = world.host.ask(here -> here);
        for (long id = 1; id <= 1000; id++) {
            Priority priority = PRIORITIES.get(random.nextInt(4));
            Decision decision = decision(id, priority);
            long at = random.nextInt(100);
            left.put(id, new PendingDecision(decision, at));
            List<Effect> effects = new ArrayList<>(List.of(new Effect.DecisionOpened(decision)));
            long other = 1 + random.nextLong(id);
            if (random.nextInt(3) == 0 && left.remove(other) != null) {
                effects.add(new Effect.DecisionClosed(other, Optional.empty(), Optional.empty()));
            }
            models.onStep(id, at, new Input.TimeReached(), effects, view);
            if (random.nextInt(20) == 0) {
                world.settle();
            }
        }
        world.settle();

        List<PendingDecision> expected = new ArrayList<>(left.values());
        expected.sort(Comparator.comparing(
                        (PendingDecision pending) -> pending.decision().priority())
                .reversed()
                .thenComparing(PendingDecision::openedAtMillis)
                .thenComparing(pending -> pending.decision().id()));
        assertThat(models.decisions().pending()).isEqualTo(expected).hasSizeGreaterThan(500);
        assertThat(told).as("told together").hasSizeLessThan(150);
        assertThat(told.get(told.size() - 1)).isEqualTo(expected);
    }

    private static Decision decision(long id, Priority priority) {
        return new Decision(
                id,
                Ids.NONE,
                Ids.NONE,
                "BoatRestarted",
                "May it move?",
                new Question.Approve(),
                Optional.empty(),
                OptionalLong.empty(),
                priority,
                List.of());
    }
}
