package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.spn.analysis.PlanChecks;
import org.sami.spn.drawing.RequirementWords;
import org.sami.spn.edit.EdgeEdit;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditHistory;
import org.sami.spn.edit.EditResult;
import org.sami.spn.edit.PlanBuilder;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.AuthoringReader;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Action;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Mode;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.sequence.AuthoringLibrary;
import org.sami.spn.sequence.EventCategory;
import org.sami.spn.sequence.Sequence;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.wizard.AddEvent;
import org.sami.spn.wizard.AddVertex;
import org.sami.spn.wizard.ComputeRequirements;
import org.sami.spn.wizard.EventTarget;
import org.sami.spn.wizard.NextEvents;
import org.sami.spn.wizard.PlanChange;
import org.sami.spn.wizard.RemoveWithRequirements;

/**
 * The event wizard and the computation of requirements (thesis 5.1.1), with the sequences of the boats. The thesis calls some of their events
 * by other names: SystemStartTimer is StartSystemTimer here, SystemTimerExpired TimerExpired, OperatorSelectRobot OperatorSelectBoat.
 */
class EventWizardTest {
    private static final DomainLibrary BOATS =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final AuthoringLibrary LIBRARY = BOATS.authoring();
    private static final EventTarget SOMEWHERE = new EventTarget.Free(Optional.of(new LayoutPoint(60, 200)));

    private final EditHistory history = history(new PlanBuilder("p").build());

    private static EditHistory history(Plan plan) {
        return new EditHistory(
                new Project("project", "", "crw", List.of(), List.of(), List.of(plan)), BOATS.vocabulary(), 100);
    }

    private Plan plan() {
        return history.project().plans().get(0);
    }

    private static Plan done(EditHistory history, Edit edit) {
        EditResult result = history.apply(edit);
        assertThat(result).as("%s", result).isInstanceOf(EditResult.Done.class);
        return history.project().plans().get(0);
    }

    private Plan add(String event, EventTarget target) {
        return done(history, AddEvent.usual("p", event, target, Mode.NOMINAL, LIBRARY));
    }

    private static List<String> in(Plan plan, String transition) {
        return plan.inEdgesOf(transition).stream()
                .flatMap(e -> e.requirements().stream())
                .map(RequirementWords::of)
                .toList();
    }

    private static List<String> out(Plan plan, String transition) {
        return plan.outEdgesOf(transition).stream()
                .flatMap(e -> e.requirements().stream())
                .map(RequirementWords::of)
                .toList();
    }

    /** The transition with an input event of a type. */
    private static String on(Plan plan, String input) {
        return plan.transitions().stream()
                .filter(t -> t.inputs().stream().anyMatch(i -> i.type().equals(input)))
                .map(Transition::id)
                .findFirst()
                .orElseThrow();
    }

    /** The place behind the transition with an input event of a type. */
    private static String behind(Plan plan, String input) {
        return plan.outEdgesOf(on(plan, input)).get(0).place();
    }

    /**
     * "A developer starts a new SPN by dropping a SystemStartTimer output event. […] the computation results in using a generic token to
     * activate SystemStartTimer and SystemTimerExpired is given the in and out edge requirements '≥ 1 Generic' and 'Take 1 Generic'".
     */
    @Test
    void firstExampleOfTheThesisComesOut() {
        Plan plan = add("StartSystemTimer", SOMEWHERE);

        assertThat(plan.places()).hasSize(2);
        assertThat(plan.startPlace().orElseThrow().outputs())
                .extracting(o -> o.type())
                .containsExactly("StartSystemTimer");
        assertThat(plan.transitions())
                .singleElement()
                .satisfies(t -> assertThat(t.inputs()).extracting(i -> i.type()).containsExactly("TimerExpired"));
        assertThat(in(plan, on(plan, "TimerExpired"))).containsExactly("≥ 1 Generic");
        assertThat(out(plan, on(plan, "TimerExpired"))).containsExactly("Take 1 Generic");
    }

    /**
     * "Next, the developer drops a OperatorSelectRobot output event onto the outgoing place created for the SystemTimerExpired transition. […]
     * 'All Relevant Tokens' as a in edge requirement and 'Take All Relevant Tokens' as an out edge requirement. These edge requirements are
     * added, as well as a '≥ 1 Generic' and 'Take 1 Generic,' so that the generic token is moved forward through the plan. Additionally, to
     * ensure the proxy token requirement for OperatorSelectRobot is fulfilled, 'Take All Proxy' is added as an out edge requirement for
     * SystemTimerExpired."
     */
    @Test
    void secondExampleOfTheThesisComesOut() {
        String blank = behind(add("StartSystemTimer", SOMEWHERE), "TimerExpired");

        Plan plan = add("OperatorSelectBoat", new EventTarget.OnVertex(blank));

        assertThat(plan.places()).hasSize(3);
        assertThat(plan.transitions()).hasSize(2);
        assertThat(plan.inEdgesOf(on(plan, "OperatorSelectsBoat")))
                .extracting(InEdge::place)
                .containsExactly(blank);
        assertThat(in(plan, on(plan, "OperatorSelectsBoat"))).containsExactlyInAnyOrder("All Relevant", "≥ 1 Generic");
        assertThat(out(plan, on(plan, "OperatorSelectsBoat")))
                .containsExactlyInAnyOrder("Take All Relevant", "Take 1 Generic");
        assertThat(in(plan, on(plan, "TimerExpired"))).containsExactly("≥ 1 Generic");
        assertThat(out(plan, on(plan, "TimerExpired"))).containsExactly("Take 1 Generic", "Take All Proxy");
    }

    /** "ProxyTimerExpired […] require[s] an 'All Relevant Tokens' in edge requirement and a 'Take All Relevant Tokens' out edge requirement." */
    @Test
    void timerOfARobotLeavesTheGenericToken() {
        Plan plan = add("StartProxyTimer", SOMEWHERE);

        assertThat(in(plan, on(plan, "ProxyTimerExpired"))).containsExactly("All Relevant");
        assertThat(out(plan, on(plan, "ProxyTimerExpired"))).containsExactly("Take All Relevant");
    }

    @Test
    void deletedEventTakesAlongTheRequirementsThatItNeeded() {
        String blank = behind(add("StartSystemTimer", SOMEWHERE), "TimerExpired");
        Plan before = plan();
        Plan with = add("OperatorSelectBoat", new EventTarget.OnVertex(blank));
        Set<String> added = Set.of(
                with.place(blank).orElseThrow().outputs().get(0).id(),
                on(with, "OperatorSelectsBoat"),
                behind(with, "OperatorSelectsBoat"));

        Plan after = done(history, new RemoveWithRequirements("p", added, LIBRARY));

        assertThat(after).isEqualTo(before);
    }

    @Test
    void needIsCarriedThroughThePlacesBefore() {
        String first = behind(add("StartSystemTimer", SOMEWHERE), "TimerExpired");
        add("OperatorCreateArea", new EventTarget.OnVertex(first));
        String second = behind(plan(), "OperatorCreatedArea");

        Plan plan = add("ProxyExploreArea", new EventTarget.OnVertex(second));

        assertThat(out(plan, on(plan, "TimerExpired"))).contains("Take All Proxy");
        assertThat(out(plan, on(plan, "OperatorCreatedArea"))).contains("Take All Proxy");
    }

    @Test
    void additionAndAllThatCameWithItIsUndoneAsOne() {
        Plan empty = plan();
        add("OperatorAllocationOptions", SOMEWHERE);

        history.undo();

        assertThat(plan()).isEqualTo(empty);
        assertThat(history.undoLabel()).isEmpty();
    }

    @Test
    void eventWithoutASequenceNeedsNoTokens() {
        String blank = behind(add("StartSystemTimer", SOMEWHERE), "TimerExpired");

        AuthoringLibrary withoutBoats = new AuthoringLibrary(
                List.of(),
                LIBRARY.sequences().stream()
                        .filter(s -> !s.event().startsWith("OperatorSelect"))
                        .toList());
        Plan plan = done(
                history,
                AddEvent.usual("p", "OperatorSelectBoat", new EventTarget.OnVertex(blank), Mode.NOMINAL, withoutBoats));

        assertThat(plan.transitions()).hasSize(1);
        assertThat(out(plan, on(plan, "TimerExpired"))).containsExactly("Take 1 Generic");
    }

    @Test
    void lockedEdgeIsNeverTouched() {
        Plan timer = add("StartSystemTimer", SOMEWHERE);
        String blank = behind(timer, "TimerExpired");
        String edge = timer.outEdges().get(0).id();
        done(history, new EdgeEdit.SetLocked("p", Set.of(edge), true));

        add("OperatorSelectBoat", new EventTarget.OnVertex(blank));
        Plan computed = done(history, new ComputeRequirements("p", Set.of(edge), LIBRARY));

        assertThat(out(computed, on(computed, "TimerExpired"))).containsExactly("Take 1 Generic");
    }

    @Test
    void requirementWrittenByHandStays() {
        Plan timer = add("StartSystemTimer", SOMEWHERE);
        OutEdge edge = timer.outEdges().get(0);
        done(
                history,
                new EdgeEdit.SetOutRequirements(
                        "p",
                        edge.id(),
                        List.of(OutRequirement.of(Action.TAKE, OutRequirement.ALL, TokenKind.ANY_TOKEN))));

        Plan plan = add("OperatorSelectBoat", new EventTarget.OnVertex(edge.place()));

        assertThat(out(plan, on(plan, "TimerExpired"))).containsExactly("Take All Token");
    }

    @Test
    void manualSequenceIsDrawnWithLockedEdgesThatStayAsTheyAre() {
        String blank = behind(add("StartSystemTimer", SOMEWHERE), "TimerExpired");
        Plan plan = done(
                history,
                AddEvent.usual("p", "ProxyExecutePath", new EventTarget.OnVertex(blank), Mode.NOMINAL, LIBRARY)
                        .withSequence("go-on-when-the-last-is-there"));
        List<InEdge> drawn = plan.inEdges().stream().filter(InEdge::locked).toList();

        assertThat(plan.place(blank).orElseThrow().outputs()).hasSize(1);
        assertThat(drawn).hasSize(4);
        assertThat(out(plan, on(plan, "TimerExpired"))).containsExactly("Take 1 Generic", "Take All Proxy");

        String last = plan.places().stream()
                .filter(p -> p.name().equals("All there"))
                .map(p -> p.id())
                .findFirst()
                .orElseThrow();
        Plan more = add("OperatorSelectBoatList", new EventTarget.OnVertex(last));
        assertThat(more.inEdges()).containsAll(drawn);
        assertThat(more.outEdges())
                .containsAll(plan.outEdges().stream().filter(OutEdge::locked).toList());
    }

    @Test
    void eventStandsOnlyWhereItsDirectionAllows() {
        String place =
                add("StartSystemTimer", SOMEWHERE).startPlace().orElseThrow().id();

        EditResult result = history.apply(
                AddEvent.usual("p", "TimerExpired", new EventTarget.OnVertex(place), Mode.NOMINAL, LIBRARY));

        assertThat(result)
                .isInstanceOfSatisfying(
                        EditResult.Refused.class,
                        r -> assertThat(r.message())
                                .isEqualTo("Timer Expired is an input event: it stands on transitions, and " + place
                                        + " is a place"));
    }

    @Test
    void otherLoadedPlansAreLeftAlone() {
        for (Project project : BOATS.projects().values()) {
            for (Plan plan : project.plans()) {
                EditHistory opened = new EditHistory(project, BOATS.vocabulary(), 10);
                opened.apply(AddEvent.usual(
                        plan.id(), "DisplayMessage", new EventTarget.Free(Optional.empty()), Mode.NOMINAL, LIBRARY));
                Plan after = opened.project().plan(plan.id()).orElseThrow();

                assertThat(after.inEdges()).as(plan.id()).isEqualTo(plan.inEdges());
                assertThat(after.outEdges()).as(plan.id()).isEqualTo(plan.outEdges());
            }
        }
    }

    /** What is left to do after an addition is to say values and where the plan ends; nothing that was drawn is wrong. */
    @Test
    void noSequenceOfAnyEventDrawsWhatChecksRefuse() {
        for (EventType event : BOATS.vocabulary().events().values()) {
            for (Sequence sequence : LIBRARY.of(event.name())) {
                EditHistory drawing = history(new PlanBuilder("p").build());
                Plan timer = done(drawing, AddEvent.usual("p", "StartSystemTimer", SOMEWHERE, Mode.NOMINAL, LIBRARY));
                done(
                        drawing,
                        AddEvent.usual(
                                        "p",
                                        event.name(),
                                        new EventTarget.Behind(behind(timer, "TimerExpired")),
                                        Mode.NOMINAL,
                                        LIBRARY)
                                .withSequence(sequence.id()));

                assertThat(PlanChecks.check(drawing.project(), BOATS.vocabulary()).stream()
                                .filter(Finding::isError)
                                .map(Finding::code))
                        .as("%s %s", event.name(), sequence.id())
                        .isSubsetOf(
                                event.direction() == Direction.OUTPUT
                                        ? List.of("E-FIELD-MISSING", "E-APPLIES-NOTHING")
                                        : List.of("E-FIELD-MISSING", "E-NO-CAUSE", "E-NO-SUB-MISSION"));
            }
        }
    }

    /** Random additions and deletions, as a wild author makes them: all can be saved and undone, and no locked edge is changed. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void whateverIsAddedAndDeletedIsSavedReadEqualAndUndone(long seed) {
        Random random = new Random(seed);
        Project start = BOATS.projectOf("station-keep").orElseThrow();
        String id = start.plans().get(0).id();
        EditHistory wild = new EditHistory(start, BOATS.vocabulary(), 1000);
        List<EventType> events = List.copyOf(BOATS.vocabulary().events().values());
        int undo = 0;
        for (int i = 0; i < 60; i++) {
            Plan before = wild.project().plan(id).orElseThrow();
            List<String> vertices = new ArrayList<>();
            before.places().forEach(p -> vertices.add(p.id()));
            before.transitions().forEach(t -> vertices.add(t.id()));
            String vertex = vertices.isEmpty() ? "none" : vertices.get(random.nextInt(vertices.size()));
            EventType event = events.get(random.nextInt(events.size()));
            List<EventTarget> targets = List.of(
                    new EventTarget.OnVertex(vertex),
                    new EventTarget.Behind(vertex),
                    new EventTarget.Free(Optional.of(new LayoutPoint(random.nextInt(900), random.nextInt(900)))));
            AddEvent addition = AddEvent.usual(id, event.name(), targets.get(random.nextInt(3)), Mode.NOMINAL, LIBRARY);
            List<Sequence> sequences = LIBRARY.of(event.name());
            Edit edit = random.nextInt(3) == 0
                    ? new RemoveWithRequirements(id, Set.of(vertex), LIBRARY)
                    : random.nextInt(3) == 0 || sequences.isEmpty()
                            ? addition.withSequence(Sequence.ALONE)
                            : addition.withSequence(sequences
                                    .get(random.nextInt(sequences.size()))
                                    .id());
            Project was = wild.project();
            wild.apply(edit);
            undo += wild.project().equals(was) ? 0 : 1;
            Plan after = wild.project().plan(id).orElseThrow();
            assertThat(after.inEdges())
                    .as("%s", edit)
                    .containsAll(before.inEdges().stream()
                            .filter(e -> e.locked() && after.place(e.place()).isPresent())
                            .filter(e -> after.transition(e.transition()).isPresent())
                            .toList());
        }
        ProjectWriter writer = new ProjectWriter(BOATS.vocabulary());
        assertThat(undo).isGreaterThan(20);
        assertThat(new ProjectReader(BOATS.vocabulary())
                        .read(writer.text(wild.project()))
                        .orThrow())
                .isEqualTo(wild.project());
        for (int i = 0; i < undo; i++) {
            wild.undo();
        }
        assertThat(wild.project()).isEqualTo(start);
    }

    @Test
    void changeIsShownInWordsBeforeItIsMade() {
        Plan before = add("StartSystemTimer", SOMEWHERE);
        Plan after = add("OperatorSelectBoat", new EventTarget.OnVertex(behind(before, "TimerExpired")));

        PlanChange change = PlanChange.between(before, after, BOATS.vocabulary());

        assertThat(change.vertices()).hasSize(2);
        assertThat(change.edges()).hasSize(2);
        assertThat(change.changed()).hasSize(1);
        assertThat(change.lines())
                .contains(
                        "Transition \"Operator Selects Boat\"",
                        "Changed \"Timer Expired\" → \"Operator Select Boat\": Take 1 Generic, Take All Proxy");
    }

    @Test
    void whatCanComeNextIsWhatTheEventsCanCause() {
        Plan plan = add("ProxyExecutePath", SOMEWHERE);
        String place = plan.startPlace().orElseThrow().id();
        NextEvents next = new NextEvents(BOATS.vocabulary(), LIBRARY);

        assertThat(next.at(plan, place))
                .extracting(n -> n.event().name(), NextEvents.Next::drawn)
                .containsExactly(tuple("ProxyPathCompleted", true), tuple("ProxyPathFailed", true));

        Plan fewer = done(history, new RemoveWithRequirements("p", Set.of(on(plan, "ProxyPathFailed")), LIBRARY));
        assertThat(next.at(fewer, place))
                .extracting(n -> n.event().name(), NextEvents.Next::drawn)
                .startsWith(tuple("ProxyPathFailed", false));
    }

    @Test
    void subMissionBehindAPlaceComesWithTheTransitionBetween() {
        String place =
                add("StartSystemTimer", SOMEWHERE).startPlace().orElseThrow().id();

        Plan plan = done(
                history,
                new AddVertex(
                        "p",
                        new AddVertex.Content.SubMission("p", "Again"),
                        new EventTarget.Behind(place),
                        Mode.RECOVERY,
                        LIBRARY));

        assertThat(plan.places().get(2).subMissions()).extracting(s -> s.plan()).containsExactly("p");
        assertThat(plan.places().get(2).mode()).isEqualTo(Mode.RECOVERY);
        assertThat(plan.transitions()).hasSize(2);
        assertThat(in(plan, plan.transitions().get(1).id())).containsExactly("≥ 1 Generic");
    }

    @Test
    void aBlankVertexInFreeSpaceLeavesEdgesAsTheyAre() {
        EditHistory drawn = history(
                new PlanBuilder("p").start("a").transition("t").in("a", "t").build());

        Plan plan =
                done(drawn, new AddVertex("p", new AddVertex.Content.BlankPlace(), SOMEWHERE, Mode.NOMINAL, LIBRARY));

        assertThat(plan.places()).hasSize(2);
        assertThat(plan.inEdges().get(0).requirements()).isEmpty();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "{'formatVersion': 2} | E-VERSION | /formatVersion",
                "{'formatVersion': 1, 'sequences': [{'event': 'StartSystemTimr', 'inputs': []}]} | E-UNKNOWN-EVENT | /sequences/0/event",
                "{'formatVersion': 1, 'sequences': [{'event': 'StartSystemTimer', 'inputs': ['DisplayMessage']}]} | E-UNKNOWN-EVENT | /sequences/0/inputs",
                "{'formatVersion': 1, 'sequences': [{'event': 'TimerExpired', 'inputs': []}]} | E-UNKNOWN-MEMBER | /sequences/0/inputs",
                "{'formatVersion': 1, 'sequences': [{'event': 'TimerExpired', 'in': [{'match': 'all', 'kind': 'generic'}]}]} | E-REQUIREMENT | /sequences/0/in/0",
                "{'formatVersion': 1, 'sequences': [{'event': 'TimerExpired', 'manual': {'id': 'x', 'places': [{'id': 'a'}]}}]} | E-MISSING-MEMBER | /sequences/0/manual",
                "{'formatVersion': 1, 'categories': [{'id': 'a', 'name': 'A', 'events': ['TimerExpired', 'TimerExpired']}]} | E-DUPLICATE | /categories/0/events/1"
            })
    void wrongFileIsRefusedWithTheReasonAndItsPlace(String text, String code, String pointer) {
        Reading<AuthoringLibrary> reading = AuthoringReader.read(text.replace('\'', '"'), BOATS.vocabulary());

        assertThat(reading.result()).isEmpty();
        assertThat(reading.findings())
                .extracting(Finding::code, Finding::pointer)
                .contains(tuple(code, pointer));
    }

    @Test
    void everyEventIsInOneGroupOfThePalette() {
        List<String> grouped = LIBRARY.categories().stream()
                .map(EventCategory::events)
                .flatMap(List::stream)
                .toList();

        assertThat(grouped).doesNotHaveDuplicates();
        assertThat(grouped)
                .containsExactlyInAnyOrderElementsOf(BOATS.vocabulary().events().keySet());
    }
}
